#include "model/board/holes.h"

#include <QtTest>
#include <algorithm>

#include "model/board/document_builder.h"
#include "model/formats/common/hole_rules.h"
#include "model/formats/odb/features/tools.h"
#include "tests/locations.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::DrillRow;
using model::DrillTool;
using model::HoleKind;
using model::HoleSpan;
using model::LayerType;
using model::Nm;
using model::Plating;
using model::formats::Hole;
using model::formats::HoleRules;
using model::formats::PinLocations;
using odb_testing::findDiagnostic;

namespace {

constexpr Plating kNotSaid = Plating::NotSaid;
constexpr Plating kPlated = Plating::Plated;
constexpr Plating kNonPlated = Plating::NonPlated;
constexpr Plating kVia = Plating::Via;

DrillTool tool(Plating plating, Nm finished, Nm drilled, const char* process = "") {
    DrillTool made;
    made.plating = plating;
    made.process = process;
    made.finishedSize = finished;
    made.drillSize = drilled;
    return made;
}

/// One hole of `size` at the origin.
Hole holeOf(const std::vector<DrillTool>& tools, Nm size, Plating plating = kNotSaid, bool hasNet = false,
            bool hasPin = false, model::LayerUse use = model::LayerUse::Plain, LayerType type = LayerType::Drill) {
    model::Layer layer;
    layer.type = type;
    layer.use = use;
    const PinLocations pins(hasPin ? std::vector<model::Point>{{0, 0}} : std::vector<model::Point>{});
    return HoleRules(layer, tools, pins).hole({plating, model::Point{0, 0}, hasNet}, size);
}

HoleKind kindOf(const Hole& hole) {
    return model::holeKind(hole.flags);
}

std::shared_ptr<const model::Document> drilledBoard(odb_testing::Folder& folder) {
    folder.copyJob("drills");
    return odb_testing::read(folder.path());
}

std::vector<DrillRow> rowsOf(const model::Document& document, const char* layer) {
    std::vector<DrillRow> rows = model::drillTable(document);
    std::erase_if(rows, [&](const DrillRow& row) { return row.layer != document.findLayer(layer); });
    return rows;
}

}  // namespace

class HolesTest : public QObject {
    Q_OBJECT

private slots:
    // ---- rules ----

    void theAttributeSaysWhatAHoleIs() {
        QCOMPARE(kindOf(holeOf({}, 500'000, kVia)), HoleKind::Via);
        QCOMPARE(kindOf(holeOf({}, 500'000, kNonPlated, true, true)), HoleKind::NonPlated);
        QCOMPARE(kindOf(holeOf({}, 500'000, kPlated, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf({}, 500'000, kPlated, true, false)), HoleKind::Plated);
        QCOMPARE(kindOf(holeOf({}, 500'000, kVia, true, true)), HoleKind::Via);  // a via in a pad
    }

    void elseTheToolsOfThatSizeSay() {
        const std::vector<DrillTool> tools = {tool(kVia, 300'000, 300'000), tool(kPlated, 900'000, 900'000),
                                              tool(kNonPlated, 3'000'000, 3'000'000)};
        QCOMPARE(kindOf(holeOf(tools, 300'900)), HoleKind::Via);
        QCOMPARE(kindOf(holeOf(tools, 900'000, kNotSaid, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf(tools, 900'000)), HoleKind::Plated);
        QCOMPARE(kindOf(holeOf(tools, 3'000'000, kNotSaid, true)), HoleKind::NonPlated);
    }

    void aHitThatIsAViaIsOneIfItIsPlated() {
        const PinLocations pins;
        const std::vector<DrillTool> tools;
        const model::Layer drills = [] {
            model::Layer layer;
            layer.type = LayerType::Drill;
            return layer;
        }();
        const HoleRules rules(drills, tools, pins);
        const auto kindAs = [&](Plating plating) {
            return kindOf(rules.hole({plating, model::Point{0, 0}, false, true}, 300'000));
        };
        QCOMPARE(kindAs(kNotSaid), HoleKind::Via);
        QCOMPARE(kindAs(kPlated), HoleKind::Via);
        QCOMPARE(kindAs(kNonPlated), HoleKind::NonPlated);
    }

    void whereNothingIsSaidNetsAndPinsTell() {
        QCOMPARE(kindOf(holeOf({}, 300'000, kNotSaid, true, false)), HoleKind::Via);
        QCOMPARE(kindOf(holeOf({}, 300'000, kNotSaid, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf({}, 300'000, kNotSaid, false, false)), HoleKind::Plated);
        QVERIFY(holeOf({}, 300'000).isPlatingAssumed);
        QCOMPARE(kindOf(holeOf({}, 300'000, kNotSaid, true, true, model::LayerUse::Plain, LayerType::Rout)),
                 HoleKind::NonPlated);
        // Two tools of one size: the pin decides.
        const std::vector<DrillTool> both = {tool(kVia, 300'000, 0), tool(kPlated, 300'000, 0)};
        QCOMPARE(kindOf(holeOf(both, 300'000, kNotSaid, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf(both, 300'000, kNotSaid, false, false)), HoleKind::Via);
    }

    void attributeAndToolMayContradict() {
        const Hole hole = holeOf({tool(kNonPlated, 500'000, 0)}, 500'000, kPlated);
        QVERIFY(hole.isContradicted);
        QVERIFY((hole.flags & model::ElementFlag::kPlated) != 0);
        QVERIFY(!holeOf({tool(kPlated, 500'000, 0)}, 500'000, kPlated).isContradicted);
    }

    void theBarrelLiesBetweenDrilledAndFinishedSize() {
        const std::vector<DrillTool> tools = {tool(kPlated, 900'000, 1'000'000)};
        for (const Nm symbol : {900'000, 1'000'000}) {
            const Hole hole = holeOf(tools, symbol);
            QCOMPARE(hole.drilled, 1'000'000);
            QCOMPARE(hole.finished, 900'000);
            QVERIFY(!hole.isBarrelAssumed);
        }
    }

    void aBarrelThatIsNotStatedIsAssumed() {
        for (const DrillTool& odd : {tool(kPlated, 0, 900'000), tool(kPlated, 900'000, 900'000),
                                     tool(kPlated, 950'000, 900'000), tool(kPlated, 900'000, 0)}) {
            const Hole hole = holeOf({odd}, 900'000);
            QCOMPARE(hole.drilled, 900'000);
            QCOMPARE(hole.finished, 850'000);
            QVERIFY(hole.isBarrelAssumed);
        }
        QCOMPARE(holeOf({}, 60'000).finished, 30'000);  // two platings of 25 µm would all but fill it
        const Hole unplated = holeOf({}, 900'000, kNonPlated);
        QCOMPARE(unplated.finished, 900'000);
        QVERIFY(!unplated.isBarrelAssumed);
    }

    void backDrillsAreNotPlated() {
        const Hole hole =
            holeOf({tool(kPlated, 500'000, 600'000)}, 500'000, kPlated, true, false, model::LayerUse::Backdrill);
        QCOMPARE(kindOf(hole), HoleKind::NonPlated);
        QCOMPARE(hole.finished, 500'000);
    }

    void pinsAreFoundWithinReach() {
        const PinLocations pins({{5, 100}, {1'000, 0}, {-7'000, 50}, {1'000, 9'000}});
        QVERIFY(pins.isAnyWithin({1'100, 90}, 100));
        QVERIFY(!pins.isAnyWithin({1'101, 0}, 100));
        QVERIFY(!pins.isAnyWithin({1'000, 5'000}, 100));
        QVERIFY(pins.isAnyWithin({-7'000, 50}, 0));
        QVERIFY(!PinLocations().isAnyWithin({0, 0}, 1'000'000));
    }

    // ---- tools ----

    void toolsTellProcessBitAndTolerances() {
        model::Diagnostics diagnostics;
        const auto tools = model::odb::parseTools(
            "UNITS=MM\nTOOLS {\n NUM=7\n TYPE=VIA\n TYPE2=LASER\n MIN_TOL=50\n MAX_TOL=75\n BIT=L4\n FINISH_SIZE=80\n "
            "DRILL_SIZE=100\n}\n",
            "tools", diagnostics);
        QCOMPARE(tools.size(), std::size_t{1});
        QCOMPARE(tools[0].number, 7);
        QCOMPARE(tools[0].process, "LASER");
        QCOMPARE(tools[0].bit, "L4");
        QCOMPARE(tools[0].minTolerance, 50'000);
        QCOMPARE(tools[0].maxTolerance, 75'000);
        QCOMPARE(tools[0].finishedSize, 80'000);
        QCOMPARE(tools[0].drillSize, 100'000);
        QVERIFY(diagnostics.entries().empty());
    }

    void oddToolsAreReported() {
        model::Diagnostics diagnostics;
        const auto tools = model::odb::parseTools(
            "TOOLS {\n NUM=1\n TYPE=PLATED\n FINISH_SIZE=-1\n DRILL_SIZE=0\n}\nTOOLS {\n TYPE=PLATED\n FINISH_SIZE=9\n "
            "DRILL_SIZE=8\n}\nTOOLS {\n TYPE=CHISEL\n DRILL_SIZE=8\n}\n",
            "tools", diagnostics);
        QCOMPARE(tools.size(), std::size_t{3});
        QCOMPARE(findDiagnostic(diagnostics, "without a size")->line, 1U);
        QCOMPARE(findDiagnostic(diagnostics, "larger than its drilled size")->line, 7U);
        QCOMPARE(findDiagnostic(diagnostics, "unknown TYPE")->line, 12U);
    }

    /// Both tools have both sizes of the NPTH; the plated one comes first.
    void holesOfOneSizeHaveTheToolOfTheirPlating() {
        model::DocumentBuilder builder;
        model::Layer layer;
        layer.type = LayerType::Drill;
        const model::LayerId drills = builder.addLayer(layer);
        DrillTool plated = tool(kPlated, 889'000, 889'000);
        plated.number = 4;
        DrillTool unplated = tool(kNonPlated, 889'000, 889'000);
        unplated.number = 9;
        for (DrillTool* made : {&plated, &unplated}) {
            made->layer = drills;
            builder.addTool(*made);
        }
        builder.beginLayer(drills);
        model::DocumentBuilder::Origin origin;
        origin.flags = model::kHole;
        builder.addCircle({{0, 0}, 889'000, 889'000}, origin);
        origin.flags = model::kHole | model::kPlated;
        builder.addCircle({{5'000'000, 0}, 889'000, 839'000}, origin);
        const auto document = builder.finish();
        const std::vector<DrillRow> rows = model::drillTable(*document);
        QCOMPARE(rows.size(), std::size_t{2});
        for (const DrillRow& row : rows) {
            QCOMPARE(row.tool->number, row.kind == HoleKind::NonPlated ? 9 : 4);
        }
    }

    void aToolOfTheRightPlatingIsPreferred() {
        const std::vector<DrillTool> tools = {tool(kNonPlated, 500'000, 0), tool(kPlated, 400'000, 500'000),
                                              tool(kPlated, 500'000, 600'000)};
        QCOMPARE(model::findTool(tools, 500'000, true), &tools[2]);
        QCOMPARE(model::findTool(tools, 500'000, false), &tools[0]);
        QCOMPARE(model::findTool(tools, 400'500, true), &tools[1]);
        QVERIFY(model::findTool(tools, 700'000, true) == nullptr);
        const std::vector<DrillTool> near = {tool(kPlated, 500'000, 0), tool(kPlated, 500'700, 0),
                                             tool(kNonPlated, 500'400, 0)};
        QCOMPARE(model::findTool(near, 500'700, true), &near[1]);
        QCOMPARE(model::findTool(near, 500'400, true), &near[1]);
        QCOMPARE(model::findTool(near, 500'100, true), &near[0]);
        QCOMPARE(model::findTool(near, 500'400, false), &near[2]);
        QVERIFY(!model::fits(tool(kPlated, 0, 0), 0));
        QVERIFY(!model::fits(tool(kPlated, 600, 0), 10));  // sizes that somebody wrote in another unit
        QVERIFY(model::fits(tool(kPlated, 20'900, 0), 20'000));
    }

    // ---- whole boards ----

    void toolsThatFitInAnotherUnitAloneAreTakenSo_data() {
        QTest::addColumn<QString>("tools");
        QTest::addColumn<QString>("symbols");
        QTest::addColumn<Nm>("size");
        QTest::addColumn<QString>("unit");
        const auto sizes = [](const char* units, const char* a, const char* b) {
            return QString(
                       "THICKNESS=0\n%1TOOLS {\n NUM=1\n TYPE=VIA\n DRILL_SIZE=%2\n}\n"
                       "TOOLS {\n NUM=2\n TYPE=PLATED\n DRILL_SIZE=%3\n}\n")
                .arg(units, a, b);
        };
        const QString plain = "$0 r200\n$1 oval1000x1700\n";
        QTest::newRow("as stated") << sizes("UNITS=MM\n", "200", "1000") << plain << 200'000 << "";
        QTest::newRow("mm, as KiCad 10") << sizes("UNITS=MM\n", "0.20", "1.0") << plain << 200'000 << "mm";
        QTest::newRow("inches") << sizes("UNITS=INCH\n", "0.010", "0.040") << "$0 r254\n$1 r1016\n"
                                << 254'000 << "inches";
        QTest::newRow("µm without UNITS") << sizes("", "200", "1000") << plain << 200'000 << "µm";
        QTest::newRow("mil in a file of mm") << sizes("UNITS=MM\n", "10", "40") << "$0 r254\n$1 r1016\n"
                                             << 254'000 << "mil";
        QTest::newRow("one hole fits in none") << sizes("UNITS=MM\n", "0.20", "1.0") << "$0 r200\n$1 r700\n"
                                               << 200 << "";
    }
    void toolsThatFitInAnotherUnitAloneAreTakenSo() {
        QFETCH(QString, tools);
        QFETCH(QString, symbols);
        QFETCH(Nm, size);
        QFETCH(QString, unit);
        odb_testing::Folder folder;
        folder.copyJob("drills");
        folder.write("steps/board/layers/through/features",
                     "UNITS=MM\n" + symbols.toStdString() + "P 4 4 0 P 0 0\nP 8 8 1 P 0 0\n");
        folder.write("steps/board/layers/through/tools", tools.toStdString());
        const auto document = odb_testing::read(folder.path());
        const auto through = document->findLayer("THROUGH");
        const auto first = std::ranges::find(document->tools, through, &DrillTool::layer);
        QVERIFY(first != document->tools.end());
        QCOMPARE(first->drillSize, size);
        const model::Diagnostic* found = findDiagnostic(document->diagnostics, "sizes of tools are taken as");
        QCOMPARE(found != nullptr, !unit.isEmpty());
        if (found != nullptr) {
            QVERIFY(found->text.ends_with("taken as " + unit.toStdString()));
            QCOMPARE(found->file, std::string("steps/board/layers/through/tools"));
            QCOMPARE(found->line, 2U);  // where UNITS is, or else the first tool
        }
    }

    /// KiCad 10 writes vias as `r0.010`.
    void holesThatNothingDrillsAreReported() {
        odb_testing::Folder folder;
        folder.copyJob("drills");
        const auto through = [&](const char* symbol) {
            folder.write("steps/board/layers/through/features",
                         std::string("UNITS=MM\n$0 ") + symbol + "\nP 4 4 0 P 0 0\n");
            return odb_testing::read(folder.path());
        };
        const auto board = through("r0.010");
        const model::Diagnostic* found = findDiagnostic(board->diagnostics, "which nothing drills");
        QVERIFY(found != nullptr && found->line == 3U && found->severity == model::Severity::Warning);
        QVERIFY(findDiagnostic(through("r25")->diagnostics, "which nothing drills") == nullptr);
    }

    void spansInEitherDirection() {
        odb_testing::Folder folder;
        const auto document = drilledBoard(folder);
        QCOMPARE(rowsOf(*document, "THROUGH").front().span, HoleSpan::Through);
        QCOMPARE(rowsOf(*document, "NOSPAN").front().span, HoleSpan::Through);
        QCOMPARE(rowsOf(*document, "BLIND").front().span, HoleSpan::Blind);
        QCOMPARE(rowsOf(*document, "BURIED").front().span, HoleSpan::Buried);
        QCOMPARE(rowsOf(*document, "MICRO").front().span, HoleSpan::Micro);
        QCOMPARE(rowsOf(*document, "BACK").front().span, HoleSpan::Backdrill);
        QCOMPARE(rowsOf(*document, "BACK").front().kind, HoleKind::NonPlated);
        const auto span = [&](const char* name) {
            const model::Layer& layer = document->layer(document->findLayer(name));
            return document->layer(layer.spanTop).name + ">" + document->layer(layer.spanBottom).name;
        };
        QCOMPARE(span("BLIND"), "L1>L3");
        QCOMPARE(span("BURIED"), "L2>L3");  // written bottom to top
        QCOMPARE(span("NOSPAN"), "L1>L4");
        QCOMPARE(span("LOST"), "L2>L4");
        QVERIFY(findDiagnostic(document->diagnostics, "its span ends at NOWHERE") != nullptr);
    }

    void aBackDrillShortensThePlatingOfTheHole() {
        odb_testing::Folder folder;
        const auto document = drilledBoard(folder);
        QCOMPARE(document->platedSpans.size(), std::size_t{1});
        const model::PlatedSpan& left = document->platedSpans.front();
        QCOMPARE(document->layer(document->elements.layer[left.hole.row()]).name, std::string("THROUGH"));
        QCOMPARE(document->layer(left.top).name + ">" + document->layer(left.bottom).name, std::string("L1>L2"));
    }

    void everyHoleCutsTheLaminateItPasses() {
        odb_testing::Folder folder;
        const auto document = drilledBoard(folder);
        std::vector<std::uint32_t> cuts;
        for (const model::Layer& part : document->layers) {
            if (part.type != LayerType::Body) {
                continue;
            }
            std::uint32_t passing = 0;
            for (const model::Layer& layer : document->layers) {
                const bool isHoles = layer.type == LayerType::Drill || layer.type == LayerType::Rout;
                const bool passes = layer.z <= part.z && layer.z + layer.thickness >= part.z + part.thickness;
                // The backdrill lies around the through hole.
                passing += isHoles && passes && layer.name != "BACK" ? layer.elements.count : 0;
            }
            const model::AreaGeometry& area = document->areas[document->elements.geometry[part.elements.first]];
            cuts.push_back(document->shapes.shapes[area.shape.row()].contourCount - 1);
            QCOMPARE(cuts.back(), passing);
        }
        QVERIFY(cuts.size() >= 3);
        QVERIFY(*std::ranges::max_element(cuts) > *std::ranges::min_element(cuts));
    }

    void routedSlotsHaveAnInside() {
        odb_testing::Folder folder;
        const auto document = drilledBoard(folder);
        const std::vector<DrillRow> rows = rowsOf(*document, "SLOTS");
        QCOMPARE(rows.size(), std::size_t{1});
        QCOMPARE(rows[0].shape, "path");
        QCOMPARE(rows[0].diameter, 1'100'000);
        QCOMPARE(rows[0].open, 1'000'000);
        QCOMPARE(rows[0].tool->number, 3);
        QCOMPARE(document->trails.back().innerWidth, 1'000'000);
    }

    void theSampleBoardsHolesAreToldApart() {
        const auto document = odb_testing::read(locations::kSample);
        std::uint32_t vias = 0;
        std::uint32_t all = 0;
        for (const DrillRow& row : model::drillTable(*document)) {
            all += row.count;
            vias += row.kind == HoleKind::Via ? row.count : 0;
            QVERIFY(row.tool != nullptr);
        }
        QCOMPARE(vias, 84U);
        QCOMPARE(all, 118U);
    }
};

QTEST_APPLESS_MAIN(HolesTest)
#include "holes_test.moc"
