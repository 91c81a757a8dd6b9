#include "model/formats/odb/painting/holes.h"

#include <QtTest>
#include <algorithm>

#include "model/board/holes.h"
#include "model/formats/odb/features/tools.h"
#include "odb_testing.h"
#include "tests/places.h"

using model::DrillRow;
using model::DrillTool;
using model::HoleKind;
using model::HoleSpan;
using model::LayerType;
using model::Nm;
using model::odb::Feature;
using model::odb::FeatureKind;
using model::odb::Hole;
using model::odb::HoleRules;
using model::odb::MatrixLayer;
using model::odb::PinLocations;
using odb_testing::findDiagnostic;

namespace {

DrillTool tool(const char* type, Nm finished, Nm drilled, const char* process = "") {
    DrillTool made;
    made.type = type;
    made.process = process;
    made.finishedSize = finished;
    made.drillSize = drilled;
    return made;
}

Feature padAt(model::Point location, int drill = -1) {
    Feature feature;
    feature.kind = FeatureKind::Pad;
    feature.a = location;
    feature.drill = static_cast<std::int8_t>(drill);
    return feature;
}

/// One hole of `size` at the origin.
Hole holeOf(const std::vector<DrillTool>& tools, Nm size, int drill = -1, bool hasNet = false, bool hasPin = false,
            const char* addType = "", LayerType type = LayerType::Drill) {
    MatrixLayer layer;
    layer.type = type;
    layer.addType = addType;
    const PinLocations pins(hasPin ? std::vector<model::Point>{{0, 0}} : std::vector<model::Point>{});
    return HoleRules(layer, tools, pins).hole(padAt({0, 0}, drill), size, hasNet);
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
        QCOMPARE(kindOf(holeOf({}, 500'000, 2)), HoleKind::Via);
        QCOMPARE(kindOf(holeOf({}, 500'000, 1, true, true)), HoleKind::NonPlated);
        QCOMPARE(kindOf(holeOf({}, 500'000, 0, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf({}, 500'000, 0, true, false)), HoleKind::Mounting);
        QCOMPARE(kindOf(holeOf({}, 500'000, 2, true, true)), HoleKind::Via);  // a via in a pad
    }

    void elseTheToolsOfThatSizeSay() {
        const std::vector<DrillTool> tools = {tool("VIA", 300'000, 300'000), tool("PLATED", 900'000, 900'000),
                                              tool("NON_PLATED", 3'000'000, 3'000'000)};
        QCOMPARE(kindOf(holeOf(tools, 300'900)), HoleKind::Via);
        QCOMPARE(kindOf(holeOf(tools, 900'000, -1, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf(tools, 900'000)), HoleKind::Mounting);
        QCOMPARE(kindOf(holeOf(tools, 3'000'000, -1, true)), HoleKind::NonPlated);
    }

    void whereNothingIsSaidNetsAndPinsTell() {
        QCOMPARE(kindOf(holeOf({}, 300'000, -1, true, false)), HoleKind::Via);
        QCOMPARE(kindOf(holeOf({}, 300'000, -1, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf({}, 300'000, -1, false, false)), HoleKind::Mounting);
        QVERIFY(holeOf({}, 300'000).isPlatingAssumed);
        QCOMPARE(kindOf(holeOf({}, 300'000, -1, true, true, "", LayerType::Rout)), HoleKind::NonPlated);
        // Two tools of one size: the pin decides.
        const std::vector<DrillTool> both = {tool("VIA", 300'000, 0), tool("PLATED", 300'000, 0)};
        QCOMPARE(kindOf(holeOf(both, 300'000, -1, true, true)), HoleKind::Component);
        QCOMPARE(kindOf(holeOf(both, 300'000, -1, false, false)), HoleKind::Via);
    }

    void attributeAndToolMayContradict() {
        const Hole hole = holeOf({tool("NON_PLATED", 500'000, 0)}, 500'000, 0);
        QVERIFY(hole.isContradicted);
        QVERIFY((hole.flags & model::kPlated) != 0);
        QVERIFY(!holeOf({tool("PLATED", 500'000, 0)}, 500'000, 0).isContradicted);
    }

    void theWallLiesBetweenDrilledAndFinishedSize() {
        const std::vector<DrillTool> tools = {tool("PLATED", 900'000, 1'000'000)};
        for (const Nm symbol : {900'000, 1'000'000}) {
            const Hole hole = holeOf(tools, symbol);
            QCOMPARE(hole.drilled, 1'000'000);
            QCOMPARE(hole.open, 900'000);
            QVERIFY(!hole.isWallAssumed);
        }
    }

    void aWallThatIsNotStatedIsAssumed() {
        for (const DrillTool& odd : {tool("PLATED", 0, 900'000), tool("PLATED", 900'000, 900'000),
                                     tool("PLATED", 950'000, 900'000), tool("PLATED", 900'000, 0)}) {
            const Hole hole = holeOf({odd}, 900'000);
            QCOMPARE(hole.drilled, 900'000);
            QCOMPARE(hole.open, 850'000);
            QVERIFY(hole.isWallAssumed);
        }
        QCOMPARE(holeOf({}, 60'000).open, 30'000);  // two walls of 25 µm would all but fill it
        const Hole bare = holeOf({}, 900'000, 1);
        QCOMPARE(bare.open, 900'000);
        QVERIFY(!bare.isWallAssumed);
    }

    void backDrillsAreBare() {
        const Hole hole = holeOf({tool("PLATED", 500'000, 600'000)}, 500'000, 0, true, false, "BACKDRILL");
        QCOMPARE(kindOf(hole), HoleKind::NonPlated);
        QCOMPARE(hole.open, 500'000);
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

    void aToolOfTheRightPlatingIsPreferred() {
        const std::vector<DrillTool> tools = {tool("NON_PLATED", 500'000, 0), tool("PLATED", 400'000, 500'000),
                                              tool("PLATED", 500'000, 600'000)};
        QCOMPARE(model::findTool(tools, 500'000, true), &tools[2]);
        QCOMPARE(model::findTool(tools, 500'000, false), &tools[0]);
        QCOMPARE(model::findTool(tools, 400'500, true), &tools[1]);
        QVERIFY(model::findTool(tools, 700'000, true) == nullptr);
        QVERIFY(!model::fits(tool("PLATED", 0, 0), 0));
    }

    // ---- whole boards ----

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
