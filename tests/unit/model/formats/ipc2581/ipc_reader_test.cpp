#include "model/formats/ipc2581/ipc_reader.h"

#include <QtTest>
#include <filesystem>
#include <string_view>

#include "model/formats/registry.h"
#include "model/geometry/outlines.h"
#include "tests/locations.h"
#include "tests/unit/model/formats/ipc2581/ipc_files.h"

using namespace ipc_files;
using namespace model;
using formats::DrawnFeature;
using formats::DrawnJob;
using formats::DrawnKind;
using formats::DrawnStep;

class IpcReaderTest : public QObject {
    Q_OBJECT

private slots:
    void aBoardIsReadWhole() {
        const auto job = parse(corpusFile("board_c.xml"));
        QVERIFY2(job.ok(), job ? "" : job.error().text.c_str());
        QCOMPARE(job->info.version, std::string("IPC-2581C"));
        QCOMPARE(job->info.units, std::string("MM"));
        const DrawnStep& step = job->steps.at(0);
        QCOMPARE(step.profile.contourCount(), std::size_t{2});
        QCOMPARE(step.profile.contour(1).size(), std::size_t{1});  // a full circle
        QCOMPARE(step.nets.size(), std::size_t{1});
        QCOMPARE(job->layers[layerNamed(*job, "T")].facts.thicknessNm.value_or(0), 35e3);
        QCOMPARE(job->layers[layerNamed(*job, "T")].facts.material.name, std::string("COPPER"));
        QVERIFY(job->layers[layerNamed(*job, "N")].isNegative);
        QCOMPARE(layerNamed(*job, "S"), std::size_t{0});  // print lies outside
        const auto& copper = featuresOn(*job, "T");
        QCOMPARE(copper.size(), std::size_t{5});
        QCOMPARE(copper[0].subnet, SubnetKind::Via);
        QCOMPARE(copper[1].kind, DrawnKind::Region);
        QVERIFY(copper[2].isNegative);
        QCOMPARE(shapeOf(*job, copper[3]).width, 254'000);  // its dictionary is in inches
        QCOMPARE(copper[4].kind, DrawnKind::Arc);
        const formats::DrawnLayer& drill = job->layers[layerNamed(*job, "D")];
        QCOMPARE(drill.spanTop, static_cast<std::int32_t>(layerNamed(*job, "T")));
        QCOMPARE(drill.spanBottom, static_cast<std::int32_t>(layerNamed(*job, "B")));
        QCOMPARE(drill.tools.at(0).maxTolerance, 50'000);
        QCOMPARE(featuresOn(*job, "D").size(), std::size_t{2});
        QCOMPARE(featuresOn(*job, "D")[0].plating, Plating::Via);
        QCOMPARE(featuresOn(*job, "D")[1].kind, DrawnKind::Region);
        QVERIFY(reports(*job, "shapes contain each other"));  // the user shape that holds itself
        QCOMPARE(step.groups.at(0).properties.at(0).second, std::string("Hi"));
        QCOMPARE(step.netlists.at(0).netlist.points.at(0).position, (Point{10 * kMm, 4 * kMm}));
    }

    void partsLieAsTheirPadsSay_data() {
        QTest::addColumn<QByteArray>("pad");
        QTest::addColumn<double>("clockwiseDeg");
        // The package's pin 1 is at (-1, 0); the part at (10, 5) is rotated by 90 degrees and mirrored.
        QTest::newRow("x to -x") << QByteArray("<Location x='10' y='4'/>") << 270.0;
        QTest::newRow("y to -y, as KiCad does") << QByteArray("<Location x='10' y='6'/>") << 90.0;
    }
    void partsLieAsTheirPadsSay() {
        QFETCH(QByteArray, pad);
        QFETCH(double, clockwiseDeg);
        std::string text = corpusFile("board_c.xml");
        const std::string before = "<Location x=\"10\" y=\"4\"/>";
        text.replace(text.find(before), before.size(), pad.toStdString());
        const auto job = parse(text);
        QVERIFY(job.ok());
        const formats::DrawnComponent& part = job->steps[0].components.at(0);
        QCOMPARE(part.clockwiseDeg, clockwiseDeg);
        QVERIFY(part.isMirrored.value_or(false));
        QVERIFY(!part.isPopulated);
        QCOMPARE(part.side, LayerSide::Bottom);
        QCOMPARE(part.properties.back(), (std::pair<std::string, std::string>("Value", "10k")));
        const DrawnFeature& feature = featuresOn(*job, "B").at(0);
        QCOMPARE(part.pins.at(0).position, feature.a);
        QCOMPARE(part.pins[0].net, 0);
        QCOMPARE(feature.component, 0);
        QCOMPARE(feature.pin, 0);
        const Placement placement{part.position, part.clockwiseDeg, true};
        QCOMPARE(placement.apply(Point{-kMm, 0}), feature.a);
    }

    void pinsLieWhereTheirOffsetMovesThem() {
        // As Allegro writes pads that lie beside the location of their pin: on the board they are where they are drawn.
        const auto pad = [](const char* pin, const char* x) {
            return "<Set><Pad><Location x='" + std::string(x) + "' y='5'/><RectCenter width='2' height='1'/>" +
                   "<PinRef componentRef='R1' pin='" + pin + "'/></Pad></Set>";
        };
        const std::string package =
            "<Package name='p'><Pin number='1'><Xform xOffset='0.05'/><Location x='0' y='0'/><Circle diameter='1'/>"
            "</Pin><Pin number='2'><Xform xOffset='-0.05' rotation='180'/><Location x='3' y='0'/><Circle "
            "diameter='1'/></Pin></Package>"
            "<Component refDes='R1' packageRef='p' layerRef='T'><Location x='10' y='5'/></Component>";
        const auto job = parse(fileWith(package + onTop(pad("1", "10.05") + pad("2", "12.95"))));
        QVERIFY(job.ok());
        const auto& pins = job->steps[0].packages.at(0).pins;
        QCOMPARE(pins.at(0).position, (Point{50'000, 0}));
        QCOMPARE(pins.at(1).position, (Point{2'950'000, 0}));
        QCOMPARE(job->steps[0].components.at(0).pins.at(1).position, (Point{12'950'000, 5 * kMm}));
    }

    void packagesLearnPadsThatTheyListOnce() {
        // As KiCad writes a connector with two pads of one name: its package has only one of them.
        const auto pad = [](const char* part, const char* pin, const char* at) {
            return "<Pad><Location " + std::string(at) + "/><RectCenter width='2' height='1'/><PinRef componentRef='" +
                   part + "' pin='" + pin + "'/></Pad>";
        };
        const auto pads = [&](const char* part, const char* one, const char* missing, const char* listed) {
            return pad(part, "1", one) + pad(part, "M", missing) + pad(part, "M", listed);
        };
        const std::string package =
            "<Package name='p'><Pin number='1' type='SURFACE'><Location x='0' y='-2'/><RectCenter width='1' "
            "height='2'/></Pin><Pin number='M' type='SURFACE'><Location x='3' y='2'/><RectCenter width='1' "
            "height='2'/></Pin></Package>";
        const auto part = [](const char* name, const char* x) {
            return "<Component refDes='" + std::string(name) + "' packageRef='p' layerRef='T'><Xform rotation='90'/>" +
                   "<Location x='" + x + "' y='5'/></Component>";
        };
        const auto job = parse(fileWith(package + part("J1", "10") + part("J2", "30") +
                                        onTop("<Set>" + pads("J1", "x='12' y='5'", "x='8' y='2'", "x='8' y='8'") +
                                              pads("J2", "x='32' y='5'", "x='28' y='2'", "x='28' y='8'") + "</Set>")));
        QVERIFY(job.ok());
        const auto& step = job->steps[0];
        QCOMPARE(step.packages.at(0).pins.size(), std::size_t{3});
        QCOMPARE(step.packages[0].pins[2].position, (Point{-3 * kMm, 2 * kMm}));
        const Box pads3 = boxOf(step.packages[0].pins[2].outline);
        QCOMPARE(pads3, (Box{{-7 * kMm / 2, kMm}, {-5 * kMm / 2, 3 * kMm}}));
        for (const formats::DrawnComponent& component : step.components) {
            const Placement placement{component.position, component.clockwiseDeg, false};
            QCOMPARE(component.pins.size(), std::size_t{3});
            for (const formats::DrawnPin& pin : component.pins) {
                QCOMPARE(placement.apply(step.packages[0].pins.at(static_cast<std::size_t>(pin.packagePin)).position),
                         pin.position);
            }
        }
    }

    void padstacksOfRevisionBHoldPadsAndHoles() {
        const auto job = parse(corpusFile("panel_b.xml"), "board");
        QVERIFY(job.ok());
        QCOMPARE(job->steps[0].nets.at(0).name, std::string("A&B"));
        const auto& holes = featuresOn(*job, "Drill T - F");
        QCOMPARE(holes.at(0).a, (Point{12'700'000, 12'700'000}));
        QCOMPARE(shapeOf(*job, holes[0]).width, 304'800);
        const DrawnFeature& pad = featuresOn(*job, "T").at(0);
        QCOMPARE(pad.a, (Point{12'954'000, 12'700'000}));
        QCOMPARE(pad.clockwiseDeg, 330.0);
        QCOMPARE(job->steps[0].symbols[static_cast<std::size_t>(pad.symbol)].name.substr(0, 9),
                 std::string("Thermal 1"));
        QVERIFY(reports(*job, "a LayerPad names a layer that is not listed"));
        QVERIFY(reports(*job, "a pad names a component"));
    }

    void panelsPlaceTheirSteps() {
        const auto job = parse(corpusFile("panel_b.xml"), "panel");
        QVERIFY(job.ok());
        QCOMPARE(job->steps.size(), std::size_t{2});
        QCOMPARE(job->steps[0].copies.size(), std::size_t{4});
        const formats::DrawnCopy& copy = job->steps[0].copies[3];
        QVERIFY(copy.isFlipped);
        QCOMPARE(job->steps[static_cast<std::size_t>(copy.step)].name, std::string("board"));
        const Point datum = copy.placement.apply(Point{2'540'000, 2'540'000});
        QCOMPARE(datum, (Point{76'200'000, 63'500'000}));  // 1 + 2 by 1 + 1.5 inch
        QVERIFY(reports(*job, "the step contains itself"));
        const auto first = parse(corpusFile("panel_b.xml"));
        QCOMPARE(first->steps[0].name, std::string("board"));  // the first one that draws anything
        const auto none = parse(corpusFile("panel_b.xml"), "other");
        QVERIFY(!none);
        QCOMPARE(none.error().code, base::ErrorCode::BadUsage);
        QVERIFY(none.error().text.find("panel, board") != std::string::npos);
    }

    void stackupsMakeOneOrder() {
        const auto job = parse(corpusFile("panel_b.xml"), "board");
        QCOMPARE(layerNamed(*job, "T"), std::size_t{0});  // written from the bottom
        QCOMPARE(layerNamed(*job, "C"), std::size_t{1});  // next to the copper it covers
        QCOMPARE(layerNamed(*job, "F"), std::size_t{2});
        QCOMPARE(job->layers[1].use, LayerUse::Coverlay);
        QCOMPARE(job->steps[0].zones.at(0).layers, (std::vector<std::int32_t>{1, 2}));
    }

    void fillsDrawWhatTheySay_data() {
        QTest::addColumn<QByteArray>("shape");
        QTest::addColumn<QByteArray>("drawn");
        const auto row = [](const char* name, const char* children, const char* drawn) {
            QTest::newRow(name) << QByteArray("<RectCenter width='4' height='2'>") + children + "</RectCenter>"
                                << QByteArray(drawn);
        };
        row("nothing said", "", "P");
        row("filled", "<FillDesc fillProperty='FILL'/>", "P");
        row("filled with an edge", "<LineDesc lineEnd='ROUND' lineWidth='0.1'/>", "PLLLL");
        row("hollow", "<FillDesc fillProperty='HOLLOW'/><LineDesc lineEnd='ROUND' lineWidth='0.1'/>", "LLLL");
        row("hollow without width", "<FillDesc fillProperty='HOLLOW'/>", "");
        row("hatched", "<FillDesc fillProperty='HATCH' lineWidth='0.1' pitch1='0.5' angle1='0'/>", "R");
        row("void", "<FillDesc fillProperty='VOID'/>", "-P");
        row("filled with an erased edge", "<LineDesc lineProperty='ERASE' lineWidth='0.1'/>", "P-L-L-L-L");
    }
    void fillsDrawWhatTheySay() {
        QFETCH(QByteArray, shape);
        QFETCH(QByteArray, drawn);
        const auto job = parse(fileWith(features(shape.toStdString())));
        QVERIFY(job.ok());
        std::string found;
        for (const DrawnFeature& feature : featuresOn(*job, "T")) {
            found += feature.isNegative ? "-" : "";
            found += "LAPR"[static_cast<std::size_t>(feature.kind)];
        }
        QCOMPARE(found, drawn.toStdString());
    }

    void lineEndsAreDrawn_data() {
        QTest::addColumn<QByteArray>("end");
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<int>("kind");
        QTest::newRow("round") << QByteArray("ROUND") << QByteArray("endX='3' endY='1'")
                               << static_cast<int>(DrawnKind::Line);
        QTest::newRow("square") << QByteArray("SQUARE") << QByteArray("endX='3' endY='0'")
                                << static_cast<int>(DrawnKind::Line);
        QTest::newRow("square, aslant") << QByteArray("SQUARE") << QByteArray("endX='3' endY='4'")
                                        << static_cast<int>(DrawnKind::Region);
        QTest::newRow("none") << QByteArray("NONE") << QByteArray("endX='3' endY='0'")
                              << static_cast<int>(DrawnKind::Region);
    }
    void lineEndsAreDrawn() {
        QFETCH(QByteArray, end);
        QFETCH(QByteArray, line);
        QFETCH(int, kind);
        const auto job =
            parse(fileWith(features("<Line startX='0' startY='0' " + line.toStdString() + "><LineDesc lineEnd='" +
                                    end.toStdString() + "' lineWidth='1'/></Line>")));
        const auto& found = featuresOn(*job, "T");
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(static_cast<int>(found[0].kind), kind);
    }

    void linesMayEraseOrBeBroken() {
        const auto line = [](const char* property) {
            return "\n<Line startX='0' startY='0' endX='3' endY='4'><LineDesc lineEnd='SQUARE' lineWidth='1' "
                   "lineProperty='" +
                   std::string(property) + "'/></Line>";
        };
        const auto job = parse(fileWith(features("<UserSpecial>" + line("SOLID") + line("ERASE") + line("DASHED") +
                                                 line("PHANTOM") + "</UserSpecial>")));
        const auto& found = featuresOn(*job, "T");
        QCOMPARE(found.size(), std::size_t{4});
        QVERIFY(!found[0].isNegative && found[1].isNegative && !found[2].isNegative && !found[3].isNegative);
        QVERIFY(reports(*job, "dashed and dotted lines are drawn as solid ones", 1));
        const auto negative = parse(fileWith(
            onTop("<Set polarity='NEGATIVE'><Features>" + line("ERASE") + line("SOLID") + "</Features></Set>")));
        QVERIFY(!featuresOn(*negative, "T").at(0).isNegative);
        QVERIFY(featuresOn(*negative, "T").at(1).isNegative);
    }

    void placesAddUp() {
        const std::string xform = "<Xform rotation='90' mirror='true' scale='2' xOffset='1' yOffset='2'/>";
        const auto job =
            parse(fileWith(onTop("<Set><Features>" + xform +
                                 "<Location x='10' y='20'/><Location x='30' y='20'/>"
                                 "<Line startX='0' startY='0' endX='3' endY='0'><LineDesc lineWidth='0.2'/></Line>"
                                 "</Features></Set>")));
        const auto& found = featuresOn(*job, "T");
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(found[0].a, (Point{11 * kMm, 22 * kMm}));
        QCOMPARE(found[0].b, (Point{11 * kMm, 28 * kMm}));
        QCOMPARE(found[1].a, (Point{31 * kMm, 22 * kMm}));
        QCOMPARE(shapeOf(*job, found[0]).width, 400'000);
    }

    void whatFollowsAHoleIsOnTheLayerOfItsSet_data() {
        QTest::addColumn<QByteArray>("cut");
        QTest::newRow("hole") << QByteArray("<Hole diameter='1' x='5' y='5' platingStatus='VIA'/>");
        QTest::newRow("slot") << QByteArray("<SlotCavity platingStatus='VIA'><Circle diameter='1'/></SlotCavity>");
    }
    void whatFollowsAHoleIsOnTheLayerOfItsSet() {
        QFETCH(QByteArray, cut);
        const std::string line =
            "<Features><Line startX='0' startY='0' endX='9' endY='0'><LineDesc lineWidth='0.2'/>"
            "</Line></Features>";
        const auto job = parse(fileWith(onTop("<Set net='A' geometryUsage='TEXT'>" + line + cut.toStdString() + line +
                                              "<Pad><Location x='5' y='5'/><Circle diameter='2'/></Pad>"
                                              "<NonstandardAttribute name='TEXT' value='Hi'/></Set>" +
                                              "<Set net='B'>" + line + "</Set>")));
        QVERIFY(job.ok());
        const auto& copper = featuresOn(*job, "T");
        QCOMPARE(copper.size(), std::size_t{4});
        QCOMPARE(copper[2].kind, DrawnKind::Pad);
        QCOMPARE(copper[2].plating, Plating::NotSaid);
        const auto& holes = featuresOn(*job, "Drill");
        QCOMPARE(holes.size(), std::size_t{1});
        QCOMPARE(holes[0].plating, Plating::Via);
        QCOMPARE(holes[0].net, copper[0].net);
        QVERIFY(copper[0].attributes >= 0);
        for (const DrawnFeature* feature : {&copper[1], &copper[2], &holes[0]}) {
            QCOMPARE(feature->attributes, copper[0].attributes);
        }
        QVERIFY(copper[3].attributes != copper[0].attributes);
        QCOMPARE(job->steps[0].groups.size(), std::size_t{1});
        const auto top = static_cast<std::int32_t>(layerNamed(*job, "T"));
        const auto drill = static_cast<std::int32_t>(layerNamed(*job, "Drill"));
        const std::vector<std::pair<std::int32_t, std::uint32_t>> text = {{top, 0}, {top, 1}, {top, 2}, {drill, 0}};
        QCOMPARE(job->steps[0].groups[0].features, text);
    }

    void padsMayLeaveTheirShapeToTheirPadstack() {
        const std::string padstack =
            "<PadStackDef name='P'><PadstackHoleDef diameter='0.5' x='0' y='0'/>"
            "<PadstackPadDef layerRef='T' padUse='ANTIPAD'><Location x='0' y='0'/><Circle diameter='3'/>"
            "</PadstackPadDef><PadstackPadDef layerRef='T' padUse='REGULAR'><Xform xOffset='0.5' rotation='30'/>"
            "<Location x='1' y='0'/><RectCenter width='2' height='1'/></PadstackPadDef></PadStackDef>";
        const std::string pad =
            "<Set><Pad padstackDefRef='P'><Xform rotation='90'/><Location x='20' y='10'/></Pad>"
            "<Pad padstackDefRef='P'><Location x='4' y='5'/><Circle diameter='1'/></Pad></Set>";
        const auto job = parse(fileWith(padstack + onTop(pad)));
        const auto& copper = featuresOn(*job, "T");
        QCOMPARE(copper.size(), std::size_t{2});
        QCOMPARE(copper[0].a, (Point{20 * kMm, 11'500'000}));
        QCOMPARE(copper[0].clockwiseDeg, 240.0);
        QCOMPARE(shapeOf(*job, copper[0]).width, 2 * kMm);
        QCOMPARE(copper[1].a, (Point{4 * kMm, 5 * kMm}));
    }

    void holesOfPadstacksThatNoLayerDrawsAreReported() {
        const auto padAt = [](const char* place) {
            return "\n<Set><Pad padstackDefRef='P'><Xform rotation='90'/><Location " + std::string(place) +
                   "/><Circle diameter='1'/></Pad></Set>";
        };
        const std::string step = "<PadStackDef name='P'><PadstackHoleDef diameter='0.5' x='1' y='0'/></PadStackDef>" +
                                 onTop(padAt("x='0' y='0'") + padAt("x='0.004' y='9'"));
        const char* const message = "a padstack has a hole where no layer of holes draws one";
        QVERIFY(reports(*parse(fileWith(step)), message, 2));
        const std::string hole = "<Set><Hole diameter='0.5' x='0' y='1' platingStatus='VIA'/></Set>";
        const std::string slot =
            "<Set><SlotCavity><Location x='0' y='10'/><RectCenter width='1' height='2'/></SlotCavity></Set>";
        QVERIFY(reports(*parse(fileWith(step + onTop(hole))), message, 3));
        QVERIFY(!reports(*parse(fileWith(step + onTop(hole + slot))), message));
        const std::string asKicadDoes = "<Set><Hole diameter='0.5' x='-1' y='0' platingStatus='VIA'/></Set>";
        QVERIFY(!reports(*parse(fileWith(step + onTop(asKicadDoes + slot))), message));
    }

    void arcsTurnRoundInMirrors() {
        const std::string arc =
            "<Arc startX='1' startY='0' endX='0' endY='1' centerX='0' centerY='0' clockwise='false'><LineDesc "
            "lineWidth='0.1'/></Arc>";
        const auto plain = parse(fileWith(features(arc)));
        QVERIFY(!featuresOn(*plain, "T").at(0).isClockwise);
        const auto job = parse(fileWith(onTop("<Set><Features><Xform mirror='true'/>" + arc + "</Features></Set>")));
        QVERIFY(featuresOn(*job, "T").at(0).isClockwise);
        QCOMPARE(featuresOn(*job, "T")[0].a, (Point{-kMm, 0}));
    }

    void orderDoesNotMatter() {
        const std::string text =
            "<IPC-2581 revision='A'><Ecad><CadData><Step name='s'>" + features("<StandardPrimitiveRef id='c'/>") +
            "</Step><Layer name='T' layerFunction='SIGNAL' side='TOP'/></CadData><CadHeader units='INCH'/></Ecad>"
            "<Content><DictionaryStandard units='MICRON'><EntryStandard id='c'><Circle diameter='100'/></EntryStandard>"
            "</DictionaryStandard></Content></IPC-2581>";
        const auto job = parse(text);
        QVERIFY(job.ok());
        QCOMPARE(shapeOf(*job, featuresOn(*job, "T").at(0)).width, 100'000);
        QCOMPARE(job->info.units, std::string("INCH"));
    }

    void whatIsBrokenIsReportedWithItsLine_data() {
        QTest::addColumn<QByteArray>("step");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const std::string& step, const char* message) {
            QTest::newRow(name) << QByteArray::fromStdString(step) << QByteArray(message);
        };
        row("shape", features("\n<StandardPrimitiveRef id='no'/>"), "a shape refers to an entry");
        row("user shape", features("\n<UserPrimitiveRef id='no'/>"), "a shape refers to an entry");
        row("layer", "\n<LayerFeature layerRef='X'><Set/></LayerFeature>", "names a layer that is not listed");
        row("element", features("\n<Spline/>"), "element Spline is of no kind");
        row("number", features("\n<Line startX='a' startY='0' endX='1' endY='1'><LineDesc lineWidth='1'/></Line>"),
            "attribute startX is missing");
        row("line",
            features(
                "<Polyline><PolyBegin x='0' y='0'/><PolyStepSegment x='1' y='1'/>\n<LineDescRef id='no'/></Polyline>"),
            "a LineDescRef refers to");
        row("package", "\n<Component refDes='R' packageRef='no' layerRef='T'/>", "names a package");
        row("repeat", "\n<StepRepeat stepRef='no' x='0' y='0' nx='1' ny='1'/>", "names a step");
        row("zone", "\n<StackupZone name='z' stackupRef='no'/>", "names a stackup");
        row("hole", onTop("<Set>\n<Hole diameter='0' x='0' y='0'/></Set>"), "a hole without a diameter");
        row("far away", onTop("<Set>\n<Hole diameter='1' x='2000' y='0' platingStatus='VIA'/></Set>"),
            "a coordinate lies more than");
    }
    void whatIsBrokenIsReportedWithItsLine() {
        QFETCH(QByteArray, step);
        QFETCH(QByteArray, message);
        const auto job = parse(fileWith(step.toStdString()));
        QVERIFY(job.ok());
        QVERIFY2(reports(*job, message.toStdString(), 2), message.constData());
    }

    void whatIsNotReadIsReported_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(message);
        };
        const auto step = [&](const char* name, const std::string& text, const char* message) {
            row(name, fileWith(text), message);
        };
        const auto cadData = [&](const char* name, const std::string& text, const char* message) {
            row(name, fileWith({}, {}, text), message);
        };
        const auto spec = [&](const char* name, const std::string& inside, const std::string& inStep,
                              const char* message) {
            std::string text = fileWith(inStep);
            const std::string header = "<CadHeader units='MILLIMETER'/>";
            text.replace(text.find(header), header.size(),
                         "<CadHeader units='MILLIMETER'><Spec name='p'>" + inside + "</Spec></CadHeader>");
            row(name, text, message);
        };
        const std::string hole = "<Hole diameter='1' x='0' y='0'";
        step("square hole", onTop("<Set>\n" + hole + " type='SQUARE'/></Set>"), "is taken for its side");
        spec("back-drilled set", "<Backdrill/>", onTop("<Set>\n<SpecRef id='p'/>" + hole + "/></Set>"),
             "single holes are back-drilled");
        spec("back-drilled hole", "<Backdrill/>", onTop("<Set>" + hole + ">\n<SpecRef id='p'/></Hole></Set>"),
             "single holes are back-drilled");
        spec("specified set", "<General/>", onTop("<Set>\n<SpecRef id='p'/></Set>"), "say of single features");
        spec("kind of spec", "\n<Impedance/>", {}, "element Impedance");
        spec("property of a spec", "<General type='OTHER'>\n<Property text='x'/></General>", {},
             "of properties of Specs");
        step("nets joined on purpose", onTop("<Set>\n<NetShort/></Set>"), "what joins nets on purpose");
        cadData("unknown function", "\n<Layer name='X' layerFunction='CONDUKTOR'/>", "no function that is known");
        cadData("resistive layer", "\n<Layer name='X' layerFunction='RESISTIVE'/>", "layers of function RESISTIVE");
        cadData("beside the steps", "\n<Panel/>", "element Panel");
        cadData("spec of a stackup", "<Stackup name='s'>\n<SpecRef id='p'/></Stackup>", "element SpecRef");
        step("attribute of a pad", onTop("<Set><Pad>\n<NonstandardAttribute name='a'/></Pad></Set>"),
             "element NonstandardAttribute");
        step("pad of two pins",
             onTop("<Set>\n<Pad><Circle diameter='1'/><PinRef pin='1' componentRef='U1'/><PinRef pin='2' "
                   "componentRef='U1'/></Pad></Set>"),
             "a pad is of several pins");
        step("part that lies face up", onTop("<Set><Features>\n<Xform faceUp='true'/></Features></Set>"), "faceUp");
        step("drawing of a package", "<Package name='p'>\n<SilkScreen/></Package>", "not their other drawings");
        step("point of a net", "<PhyNetGroup><PhyNet name='A'>\n<Point/></PhyNet></PhyNetGroup>", "element Point");
        const std::string triangle =
            "<PolyBegin x='0' y='0'/><PolyStepSegment x='1' y='0'/><PolyStepSegment x='1' y='1'/>";
        const std::string polygon = "<Polygon>" + triangle + "</Polygon>";
        step("cutout that is moved",
             features("<Contour>" + polygon + "\n<Cutout>" + triangle + "<Xform xOffset='1'/></Cutout></Contour>"),
             "the Xform and LineDesc of a cutout");
        step("two polygons", features("<Contour>" + polygon + "\n" + polygon + "</Contour>"), "several polygons");
        step("fill", features("<Circle diameter='1'>\n<FillDesc fillProperty='DOTS'/></Circle>"),
             "fillProperty that is not known");
        step("attribute of the step", "\n<NonstandardAttribute name='a'/>", "element NonstandardAttribute");
        row("measured value",
            "<IPC-2581><Bom><BomItem><Characteristics>\n<Measured/></Characteristics></BomItem></Bom><Ecad><CadData>"
            "<Step name='s'/></CadData></Ecad></IPC-2581>",
            "element Measured");
    }
    void whatIsNotReadIsReported() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        const auto job = parse(text.toStdString());
        QVERIFY(job.ok());
        QVERIFY2(reports(*job, message.toStdString(), 2), message.constData());
    }

    void drawingsAndKnownPartsAreNotReported() {
        const auto job = parse(fileWith({}, {}, "<Layer name='X' layerFunction='ASSEMBLY' side='TOP'/>"));
        QVERIFY(job.ok());
        QVERIFY(!reports(*job, "no function that is known"));
        QVERIFY(!reports(*job, "of no kind that is read"));
    }

    void squareHolesAreSquare() {
        const auto job =
            parse(fileWith(onTop("<Set><Hole diameter='2' x='3' y='4' type='SQUARE' "
                                 "platingStatus='PLATED'><Xform rotation='90'/></Hole></Set>")));
        const DrawnFeature& hole = featuresOn(*job, "Drill").at(0);
        QVERIFY(hole.kind == DrawnKind::Region && hole.plating == model::Plating::Plated);
        const ShapeSketch& square = job->steps[0].regions[static_cast<std::size_t>(hole.region)];
        QCOMPARE(boxOf(square), (Box{{2 * kMm, 3 * kMm}, {4 * kMm, 5 * kMm}}));
        QCOMPARE(square.contour(0).size(), std::size_t{4});
    }

    void holesLieWhereTheirXformMovesThem() {
        const auto job =
            parse(fileWith(onTop("<Set><Hole diameter='1' x='2' y='3' plusTol='0.1' platingStatus='VIA'><Xform "
                                 "xOffset='1' scale='2'/></Hole></Set>")));
        const DrawnFeature& hole = featuresOn(*job, "Drill").at(0);
        QCOMPARE(hole.a, (Point{3 * kMm, 3 * kMm}));
        QCOMPARE(shapeOf(*job, hole).width, 2 * kMm);
        QCOMPARE(job->layers[layerNamed(*job, "Drill")].tools.at(0).finishedSize, 2 * kMm);
    }

    void aFaultKeepsWhatComesBeforeIt() {
        std::string text =
            fileWith(features("<Circle diameter='1'/>") + "\n<LayerFeature layerRef='B'><Set></LayerFeature>");
        const auto job = parse(text);
        QVERIFY(job.ok());
        QCOMPARE(featuresOn(*job, "T").size(), std::size_t{1});
        QVERIFY(reports(*job, "no sound XML from here on", 2));
    }

    void whatIsNoBoardIsRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("document type") << QByteArray("<!DOCTYPE x [<!ENTITY a 'b'>]><IPC-2581/>")
                                       << QByteArray("line 1: the file has a document type");
        QTest::newRow("cut off") << QByteArray("<IPC-2581 revision='C'>\n<Content>\n<FunctionMode")
                                 << QByteArray("no sound XML from line 3 on");
        QTest::newRow("other XML") << QByteArray("<svg/>") << QByteArray("no IPC-2581");
        QTest::newRow("empty") << QByteArray("") << QByteArray("no IPC-2581");
        QTest::newRow("no step") << QByteArray("<IPC-2581><Ecad/></IPC-2581>") << QByteArray("no Step");
        QTest::newRow("wide") << QByteArray("\xFF\xFE<\0", 4) << QByteArray("UTF-16");
    }
    void whatIsNoBoardIsRefused() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        const auto job = parse(text.toStdString());
        QVERIFY(!job);
        QCOMPARE(job.error().code, base::ErrorCode::BadInput);
        QVERIFY2(job.error().text.find(message.toStdString()) != std::string::npos, job.error().text.c_str());
    }

    void referencesToReferencesEnd() {
        std::string dictionary = "<DictionaryUser units='MILLIMETER'>";
        for (int i = 0; i < 30; ++i) {
            const std::string next = "<UserPrimitiveRef id='u" + std::to_string(i + 1) + "'/>";
            dictionary += "<EntryUser id='u" + std::to_string(i) + "'><UserSpecial>" + next + next + next + next +
                          "</UserSpecial></EntryUser>";
        }
        const auto job = parse(fileWith(features("<UserPrimitiveRef id='u0'/>"), dictionary + "</DictionaryUser>"));
        QVERIFY(job.ok());
        QVERIFY(reports(*job, "more than 8 levels, the limit"));
    }

    void filesOpenWhateverTheyComeIn() {
        base::Progress progress;
        QTemporaryDir folder;
        const std::string text = corpusFile("board_c.xml");
        const auto opens = [&](const char* name, const QByteArray& bytes) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
            file.close();
            const auto board = readBoard(folder.filePath(name).toStdString(), {}, progress);
            QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
            QCOMPARE((*board)->job.version, std::string("IPC-2581C"));
            QCOMPARE((*board)->components.size(), std::size_t{1});
        };
        opens("board.xml", QByteArray::fromStdString(text));
        opens("board.cvg", QByteArray("\xEF\xBB\xBF\n") + QByteArray::fromStdString(text));
        // gzip without compression: header, one stored block, checksum and size.
        const QByteArray body = QByteArray::fromStdString(text);
        QByteArray packed = QByteArray::fromHex("1f8b0800000000000003");
        const auto little = [](std::uint32_t value, int bytes) {
            QByteArray out;
            for (int i = 0; i < bytes; ++i) {
                out.append(static_cast<char>(value >> (8 * i)));
            }
            return out;
        };
        const auto size = static_cast<std::uint32_t>(body.size());
        packed += '\x01' + little(size, 2) + little(~size & 0xFFFFU, 2) + body;
        std::uint32_t crc = 0xFFFFFFFFU;
        for (const char c : body) {
            crc ^= static_cast<unsigned char>(c);
            for (int bit = 0; bit < 8; ++bit) {
                crc = (crc >> 1U) ^ (0xEDB88320U & (0U - (crc & 1U)));
            }
        }
        packed += little(~crc, 4) + little(size, 4);
        opens("board.xml.gz", packed);
    }
};

QTEST_APPLESS_MAIN(IpcReaderTest)
#include "ipc_reader_test.moc"
