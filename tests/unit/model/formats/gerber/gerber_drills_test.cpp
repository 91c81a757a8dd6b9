#include <QtTest>
#include <algorithm>

#include "model/base/units.h"
#include "model/formats/gerber/drills/drill_file.h"

using model::Plating;
using model::Point;
using model::formats::DrawnKind;
using model::gerber::Image;

namespace {

Image parse(const std::string& text) {
    const auto formats = model::gerber::likelyFormats(model::gerber::readDrillHead(text));
    return model::gerber::parseDrills(text, "test.drl", formats.front());
}

model::Nm sizeOf(const Image& image, std::size_t feature) {
    return image.symbols[static_cast<std::size_t>(image.features[feature].symbol)].shape.width;
}

bool isReported(const Image& image, const std::string& words) {
    return std::ranges::any_of(image.diagnostics.entries(),
                               [&](const auto& entry) { return entry.text.find(words) != std::string::npos; });
}

/// The records with a head before them and an end behind.
Image parseBody(const std::string& body) {
    return parse("M48\nMETRIC\nT1C1.0\nT2C2.0\n%\nT1\n" + body + "\nM30\n");
}

}  // namespace

class GerberDrillsTest : public QObject {
    Q_OBJECT

private slots:
    void unitsAndZerosAreBelievedLongerThanDigits() {
        for (const char* text : {"INCH,TZ\n%\nX0012345Y12\n", "INCH\n%\nX0012345Y0000012\n"}) {
            const auto formats =
                model::gerber::likelyFormats(model::gerber::readDrillHead("M48\n" + std::string(text)));
            const auto other = std::ranges::find(formats, true, &model::gerber::CoordinateFormat::isTrailingOmitted);
            QVERIFY(!formats.front().isTrailingOmitted && other != formats.end());
            const auto isInch = [](const auto& format) { return format.nmPerUnit == base::kNmPerInch; };
            const auto millimetres = std::ranges::find_if_not(formats, isInch);
            QVERIFY(std::all_of(other, millimetres, [](const auto& format) { return format.isTrailingOmitted; }));
            QVERIFY(std::none_of(millimetres, formats.end(), isInch));
        }
    }

    /// Allegro's files without tool records: comments list the sizes, M00 stops for the next tool.
    void stopsChangeTheToolWhereNoRecordDoes() {
        const std::string sizes =
            ";   Holesize 1. = 0.350000 Tolerance = +0.000000/-0.000000 PLATED MM Quantity = 2\n"
            ";   Holesize 2. = 40.000000 Tolerance = +0.000000/-0.000000 NON_PLATED MILS Quantity = 1\n%\nG90\n";
        const Image image = parse(sizes + "X0000100000Y0000200000\nX0000100000\nM00\nX0000300000\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{3});
        QCOMPARE(sizeOf(image, 1), 350'000);
        QCOMPARE(sizeOf(image, 2), 1'016'000);
        QVERIFY(image.hasEnd && image.diagnostics.entries().empty());
        const Image ended = parse(sizes + "X1Y2\nM00\nX2\nM00\n");
        QVERIFY(ended.hasEnd);
        QCOMPARE(ended.features.size(), std::size_t{2});
        const Image chosen = parse(sizes + "T1\nX1Y2\nM00\nX2\n");
        QCOMPARE(chosen.features.size(), std::size_t{1});  // M00 ends a file that selects its tools
    }

    void zerosAreKeptAsTheHeadSays_data() {
        QTest::addColumn<QString>("head");
        QTest::addColumn<QString>("hit");
        QTest::addColumn<int>("x");
        QTest::newRow("inch, leading zeros kept") << "INCH,LZ"
                                                  << "X0125" << 31'750'000;
        QTest::newRow("inch, trailing zeros kept") << "INCH,TZ"
                                                   << "X12500" << 31'750'000;
        QTest::newRow("metric") << "METRIC,TZ"
                                << "X12500" << 12'500'000;
        QTest::newRow("metric with digits") << "METRIC,TZ,0000.00"
                                            << "X1250" << 12'500'000;
        QTest::newRow("digits in a comment") << ";FILE_FORMAT=4:4\nMETRIC,LZ"
                                             << "X00125" << 12'500'000;
        QTest::newRow("Mentor") << "; Format  : 3.3 / Absolute / MM / Leading\nMETRIC,TZ"
                                << "X-12500" << -12'500'000;
        QTest::newRow("more digits than are usual, leading zeros kept") << "INCH,LZ"
                                                                        << "X0125005" << 31'751'270;
        QTest::newRow("a point") << "METRIC,LZ"
                                 << "X12.5" << 12'500'000;
        QTest::newRow("M71") << "M71,TZ"
                             << "X12.5" << 12'500'000;
    }
    void zerosAreKeptAsTheHeadSays() {
        QFETCH(QString, head);
        QFETCH(QString, hit);
        QFETCH(int, x);
        const Image image = parse("M48\n" + head.toStdString() + "\nT1C0.5\n%\nT1\n" + hit.toStdString() + "Y0\nM30\n");
        QCOMPARE(image.features.at(0).a.x, x);
    }

    void unstatedZerosShowInTheDigits() {
        // PADS: no header; shorter numbers begin with zeros, so those are kept.
        const Image image = parse("%\nT1C.015F095S3\nX01095Y01056\nX01095Y0127\nM30\n");
        QCOMPARE(image.features.at(1).a, (Point{27'813'000, 32'258'000}));
        QCOMPARE(sizeOf(image, 0), 381'000);
    }

    void slotsAndRoutesAreTracks() {
        const Image image = parse(
            "M48\nMETRIC\nT1C1.0\n%\nT1\nX1.0Y1.0G85X2.0Y1.0\nG00X5.0Y5.0\nM15\nG01X6.0\n"
            "G03X6.0Y7.0A1.0\nM16\nG00X9.0\nG05\nX3.0Y3.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{4});
        QCOMPARE(image.features[0].kind, DrawnKind::Line);
        QCOMPARE(image.features[0].b, (Point{2'000'000, 1'000'000}));
        QCOMPARE(image.features[1].b, (Point{6'000'000, 5'000'000}));
        QCOMPARE(image.features[2].kind, DrawnKind::Arc);
        QCOMPARE(image.features[2].centre, (Point{6'000'000, 6'000'000}));
        QCOMPARE(image.features[3].kind, DrawnKind::Pad);
    }

    void arcsThatCannotBeDrawnAreReported() {
        const Image without = parseBody("G00X2.0Y2.0\nM15\nG02X6.0Y2.0\nM16");
        QCOMPARE(without.features.at(0).kind, DrawnKind::Line);
        QVERIFY(isReported(without, "arc without a radius"));
        QCOMPARE(without.diagnostics.entries()[0].line, 9U);
        const Image small = parseBody("G00X6.0Y2.0\nM15\nG03X6.0Y6.0A1.0\nM16");
        QCOMPARE(small.features.at(0).centre, (Point{6'000'000, 4'000'000}));
        QVERIFY(isReported(small, "too small for its ends"));
        QVERIFY(!isReported(parseBody("G00X6.0Y2.0\nM15\nG03X6.0Y6.005A2.0\nM16"), "too small"));  // rounding
        const Image spiral = parseBody("G00X6.0Y2.0\nM15\nG03X9.0Y2.0I1.0J0\nM16");
        QVERIFY(isReported(spiral, "spiral"));
    }

    void circlesNeedACentre() {
        for (const char* place : {"X9.0Y5.0I2.0J0", "I2.0"}) {
            const Image circle = parseBody(std::string("G00X9.0Y5.0\nM15\nG02") + place + "\nM16");
            QCOMPARE(circle.features.size(), std::size_t{1});
            QCOMPARE(circle.features[0].kind, DrawnKind::Arc);
            QCOMPARE(circle.features[0].centre, (Point{11'000'000, 5'000'000}));
            QCOMPARE(circle.features[0].a, circle.features[0].b);
            QVERIFY(circle.diagnostics.entries().empty());
        }
        const Image lost = parseBody("G00X9.0Y5.0\nM15\nG02X9.0Y5.0A2.0\nM16");
        QCOMPARE(lost.features.at(0).b, (Point{9'000'000, 5'000'000}));
        QVERIFY(isReported(lost, "a radius (A) but no centre"));
    }

    void pathsBeforeRoutingBeginsAreReported() {
        const Image image = parseBody("G01X1.0Y1.0");
        QCOMPARE(image.features.at(0).kind, DrawnKind::Pad);
        QVERIFY(isReported(image, "without G00"));
    }

    void aToolCountsForTheHoleOfItsRecord() {
        const Image image = parseBody("T2X20.0Y5.0\nX8.0Y8.0T1\nX9.0Y9.0\nT2G00X1.0Y1.0");
        QCOMPARE(image.features.size(), std::size_t{3});
        QCOMPARE(image.features[0].a, (Point{20'000'000, 5'000'000}));
        QCOMPARE(sizeOf(image, 0), 2'000'000);
        QCOMPARE(image.features[1].a, (Point{8'000'000, 8'000'000}));
        QCOMPARE(sizeOf(image, 1), 1'000'000);
        QCOMPARE(sizeOf(image, 2), 1'000'000);
        QVERIFY(image.diagnostics.entries().empty());
    }

    void aToolThatIsDefinedAgainDrillsTheNewSize() {
        const Image image = parseBody("X1.0Y1.0\nT1C3.0\nX2.0Y2.0");
        QCOMPARE(sizeOf(image, 0), 1'000'000);
        QCOMPARE(sizeOf(image, 1), 3'000'000);
        QCOMPARE(image.tools.size(), std::size_t{2});
        QVERIFY(isReported(image, "defined again"));
    }

    void whatIsNotReadIsReported_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<int>("holes");
        QTest::addColumn<QString>("words");
        QTest::newRow("cycle") << "X1.0Y1.0G84X2.0" << 0 << "canned cycle";
        QTest::newRow("cycle with its place behind it") << "G32X1.0Y1.0A2.0" << 0 << "canned cycle";
        QTest::newRow("text") << "M97,TXT1X5" << 0 << "text to drill";
        QTest::newRow("letter") << "X1.0Y1.0Q4" << 1 << "word that is not of Excellon's";
        QTest::newRow("second unit") << "INCH\nX1.0Y1.0" << 1 << "two units";
        QTest::newRow("second unit by a code") << "M72\nX1.0Y1.0" << 1 << "two units";
        QTest::newRow("tool without end") << "X1.0Y1.0T2147483647\nM00" << 1 << "tool whose number cannot be read";
        QTest::newRow("format 1") << "FMAT,1" << 0 << "FMAT,1";
        QTest::newRow("behind the end") << "X1.0Y1.0\nM30\n%\nX2.0Y1.0" << 1 << "behind the end";
        QTest::newRow("pattern") << "M25\nX900.0Y0\nM01\nM02X500.0" << 1 << "pattern of holes goes beyond any board";
        QTest::newRow("repeated path") << "G00X1.0Y1.0\nM15\nG01X2.0\nM16\nR2X1.0" << 1 << "behind a routed path";
    }
    void whatIsNotReadIsReported() {
        QFETCH(QString, body);
        QFETCH(int, holes);
        QFETCH(QString, words);
        const Image image = parseBody(body.toStdString());
        QVERIFY(isReported(image, words.toStdString()));
        QCOMPARE(image.features.size(), static_cast<std::size_t>(holes));
    }

    void whatIsHarmlessIsNotReported() {
        const Image image = parse(
            "M48\nFMAT,2\nICI,OFF\nMETRIC,TZ,000.000\nM71,TZ\nT1F00S00C1.0\nT2C2.0B100H500Z-1.6\n%\nM71\n"
            "N1G90\nM47,TOOL 1 X5\nT01M06\nN2X1.0Y1.0\nS65F200\nM30\n;done\n%\n\x1a");
        QCOMPARE(image.features.size(), std::size_t{1});
        QVERIFY(image.diagnostics.entries().empty());
    }

    void bothEndsOfASlotMayStandBehindItsCode() {
        const Image image = parse(
            "M48\nMETRIC,TZ\nT1C0.8\n%\nT1\nX9000Y9000\nG85X2000Y5000X6000Y4000\nG85X2000Y5000Y7000\n"
            "X1000Y1000G85X3000\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{4});
        QCOMPARE(image.features[1].kind, DrawnKind::Line);
        QCOMPARE(image.features[1].a, (Point{2'000'000, 5'000'000}));
        QCOMPARE(image.features[1].b, (Point{6'000'000, 4'000'000}));
        QCOMPARE(image.features[2].b, (Point{2'000'000, 7'000'000}));
        QCOMPARE(image.features[3].a, (Point{1'000'000, 1'000'000}));
        QCOMPARE(image.features[3].b, (Point{3'000'000, 1'000'000}));
    }

    void platingFollowsAttributesSectionsAndComments() {
        const Image kicad = parse(
            "M48\nMETRIC\n; #@! TA.AperFunction,Plated,PTH,ViaDrill\nT1C0.3\n"
            "; #@! TA.AperFunction,NonPlated,NPTH,ComponentDrill\nT2C1.0\n%\nT1\nX1.Y1.\nT2\nX2.Y2.\nM30\n");
        QCOMPARE(kicad.features[0].plating, Plating::Via);
        QCOMPARE(kicad.features[1].plating, Plating::NonPlated);
        const Image altium =
            parse("M48\nMETRIC\n;TYPE=PLATED\nT1C0.3\n;TYPE=NON_PLATED\nT2C1.0\n%\nT1\nX1.Y1.\nT2\nX2.Y2.\nM30\n");
        QCOMPARE(altium.features[0].plating, Plating::Plated);
        QCOMPARE(altium.features[1].plating, Plating::NonPlated);
        const Image allegro = parse(
            ";T01 Holesize 1. = 12.000000 Tolerance = +0.000000/-0.000000 PLATED MILS Quantity = 1\n"
            ";T02 Holesize 2. = 40.000000 Tolerance = +0.000000/-0.000000 NON_PLATED MILS Quantity = 1\n"
            "%\nG90\nT01\nX004450Y000200\nT02\nX009874Y002026\nM30\n");
        QCOMPARE(sizeOf(allegro, 0), 304'800);
        QCOMPARE(allegro.features[0].a, (Point{11'303'000, 508'000}));
        QCOMPARE(allegro.features[1].plating, Plating::NonPlated);
    }

    void aBackDrillHasNoPlating() {
        const Image image = parse(
            "M48\nMETRIC\n; #@! TA.AperFunction,NonPlated,Blind,BackDrill\nT1C0.3\n"
            "; #@! TA.AperFunction,BackDrill\nT2C1.0\n%\nT1\nX1.Y1.\nT2\nX2.Y2.\nM30\n");
        QCOMPARE(image.features[0].plating, Plating::NonPlated);
        QCOMPARE(image.features[1].plating, Plating::NonPlated);
    }

    void aToolThatGoesDownInOnePlaceDrillsIt() {
        const auto centres = [](const char* body) {
            std::vector<Point> found;
            for (const auto& feature : parseBody(body).features) {
                found.push_back(feature.kind == DrawnKind::Pad ? feature.a : Point{-1, -1});
            }
            return found;
        };
        const Point at{10'000'000, 5'000'000};
        const Point cut{-1, -1};
        QCOMPARE(centres("G00X10.0Y5.0\nM15\nM16\nG05"), (std::vector<Point>{at}));
        QCOMPARE(centres("G00X10.0Y5.0\nM15\nG05"), (std::vector<Point>{at}));
        QCOMPARE(centres("G00X10.0Y5.0\nM15\nG00X1.0\nM15\nG01X2.0\nM16"), (std::vector<Point>{at, cut}));
        QCOMPARE(centres("G00X10.0Y5.0\nM15\nG01X8.0\nM16\nG05"), (std::vector<Point>{cut}));
        QCOMPARE(centres("G00X10.0Y5.0\nM15\nG01X8.0M16\nG00X1.0"), (std::vector<Point>{cut}));
        QCOMPARE(centres("G00X10.0Y5.0\nM15"), (std::vector<Point>{at}));
        QVERIFY(centres("G00X10.0Y5.0\nM16\nG05").empty());
        QCOMPARE(centres("M15\nX10.0Y5.0\nM16"), (std::vector<Point>{at}));  // drilled, not routed
        QCOMPARE(sizeOf(parseBody("G00X10.0Y5.0\nM15\nM16"), 0), 1'000'000);
    }

    void toolsOfTheHeadAreInItsUnit() {
        const Image image = parse("M48\nINCH,TZ\nT1C.0394\n%\nM71\nT1\nX10.0Y10.0\nT2C2.0\nX11.0Y10.0\nM30\n");
        QCOMPARE(sizeOf(image, 0), 1'000'760);
        QCOMPARE(sizeOf(image, 1), 2'000'000);
        QCOMPARE(image.features[0].a, (Point{10'000'000, 10'000'000}));
        QVERIFY(isReported(image, "tools are read in the first one"));
        QVERIFY(isReported(parse("M48\nINCH\nT1C.04\n%\nT1\nX1.0Y1.0\nM71\nX1.0Y1.0\nM30\n"),
                           "one is taken for all of it"));
    }

    void holesAreRepeated() {
        const Image image =
            parse("M48\nMETRIC\nT1C0.3\n%\nT1\nX1.0Y1.0\nR2X0.5\nM25\nX10.0Y0.0\nM01\nM02X0Y5.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{5});
        QCOMPARE(image.features[2].a, (Point{2'000'000, 1'000'000}));
        QCOMPARE(image.features[4].a, (Point{10'000'000, 5'000'000}));
    }

    void slotsAreRepeatedAsSlots() {
        const Image image = parseBody("X2.0Y2.0G85X4.0Y3.0\nR2Y5.0\nX1.0Y1.0\nR1X1.0");
        QCOMPARE(image.features.size(), std::size_t{5});
        QCOMPARE(image.features[2].kind, DrawnKind::Line);
        QCOMPARE(image.features[2].a, (Point{2'000'000, 12'000'000}));
        QCOMPARE(image.features[2].b, (Point{4'000'000, 13'000'000}));
        QCOMPARE(image.features[4].kind, DrawnKind::Pad);
        QCOMPARE(image.features[4].a, (Point{2'000'000, 1'000'000}));
    }

    void repetitionsEndWhereBoardsEnd() {
        const Image image = parse("M48\nMETRIC\nT1C0.3\n%\nT1\nX1.0Y1.0\nR30000X100.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{11});
        QCOMPARE(image.diagnostics.entries().size(), std::size_t{1});
        QCOMPARE(image.diagnostics.entries()[0].count, 1U);
    }

    void incrementalPlacesAndOriginsCount() {
        const Image image = parse("M48\nMETRIC\nT1C0.3\n%\nG93X1.0Y2.0\nT1\nX1.0Y1.0\nICI,ON\nX0.5\nM30\n");
        QCOMPARE(image.features[0].a, (Point{2'000'000, 3'000'000}));
        QCOMPARE(image.features[1].a, (Point{2'500'000, 3'000'000}));
    }

    void toolsWithoutASizeStayHoles() {
        const Image image = parse("M48\nMETRIC\nT1C0.000\n%\nT1\nX1.0Y1.0\nT7\nX2.0Y2.0\nM30\n");
        QCOMPARE(image.features.size(), std::size_t{2});
        QCOMPARE(sizeOf(image, 1), 10);
        QVERIFY(image.diagnostics.entries().empty());  // a netlist may tell it
    }
};

QTEST_APPLESS_MAIN(GerberDrillsTest)
#include "gerber_drills_test.moc"
