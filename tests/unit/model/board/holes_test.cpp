// Drill tables of panels. What readers make of holes stands in formats/odb/holes_test.cpp.

#include "model/board/holes.h"

#include <QtTest>
#include <array>
#include <set>

#include "model/board/document_builder.h"
#include "model/geometry/outlines.h"

using model::BoardElement;
using model::Document;
using model::DocumentBuilder;
using model::DrillRow;
using model::HoleKind;
using model::LayerId;
using model::Nm;

namespace {

constexpr std::uint8_t kViaFlags = model::kHole | model::kPlated | model::kVia;

/// Copper on both sides, a drill layer through the board and two of laser drills, each the other's opposite.
struct Step {
    DocumentBuilder builder;
    LayerId through;
    LayerId above;
    LayerId below;

    Step() {
        const LayerId top = copper("top", model::LayerSide::Top);
        const LayerId inner1 = copper("inner1", model::LayerSide::Inner);
        const LayerId inner2 = copper("inner2", model::LayerSide::Inner);
        const LayerId bottom = copper("bottom", model::LayerSide::Bottom);
        through = drill("through", top, bottom, {});
        above = drill("above", top, inner1, LayerId{std::size_t{6}});
        below = drill("below", inner2, bottom, above);
    }

    LayerId copper(const char* name, model::LayerSide side) {
        model::Layer layer;
        layer.name = name;
        layer.type = model::LayerType::Signal;
        layer.side = side;
        return builder.addLayer(layer);
    }
    LayerId drill(const char* name, LayerId top, LayerId bottom, LayerId opposite) {
        model::Layer layer;
        layer.name = name;
        layer.type = model::LayerType::Drill;
        layer.spanTop = top;
        layer.spanBottom = bottom;
        layer.opposite = opposite;
        return builder.addLayer(layer);
    }
    Step& tool(int number, Nm size) {
        model::DrillTool tool;
        tool.layer = through;
        tool.number = number;
        tool.plating = model::Plating::Via;
        tool.drillSize = tool.finishedSize = size;
        builder.addTool(tool);
        return *this;
    }
    Step& holes(LayerId layer, Nm size, int count, std::uint8_t flags = kViaFlags) {
        builder.beginLayer(layer);
        DocumentBuilder::Origin origin;
        origin.flags = flags;
        for (int i = 0; i < count; ++i) {
            builder.addCircle({{i * 1'000'000, 0}, size, size}, origin);
        }
        return *this;
    }
    Step& place(const std::shared_ptr<const Document>& step, int upright, int flipped = 0) {
        const std::uint32_t row = builder.addStep(step);
        for (int i = 0; i < upright + flipped; ++i) {
            builder.addInstance({row, {{0, (i + 1) * 10'000'000}, 0.0, i >= upright}, i >= upright});
        }
        return *this;
    }
};

/// "through via 300 #1 x 12" of each row, sizes in µm.
std::vector<std::string> textOf(const Document& board, const std::vector<DrillRow>& rows) {
    std::vector<std::string> texts;
    for (const DrillRow& row : rows) {
        const std::string tool = row.tool != nullptr ? " #" + std::to_string(row.tool->number) : "";
        texts.push_back(board.layer(row.layer).name + " " + toString(row.kind) + " " +
                        std::to_string(row.diameter / 1000) + tool + " x " + std::to_string(row.count));
    }
    return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

class HolesTest : public QObject {
    Q_OBJECT

private slots:
    void ofABoardWithoutCopiesBothTablesAreTheSame() {
        Step step;
        step.tool(1, 300'000).holes(step.through, 300'000, 3);
        const auto board = step.builder.finish();
        QCOMPARE(textOf(*board, model::drillTable(*board)), Texts{"through via 300 #1 x 3"});
        QCOMPARE(textOf(*board, model::drillTableWithCopies(*board)), Texts{"through via 300 #1 x 3"});
    }

    void toolsThatFitAlikeAreAllNamed() {
        Step step;
        step.tool(1, 300'000).tool(2, 300'000).tool(3, 800'000).holes(step.through, 300'000, 3);
        const auto board = step.builder.finish();
        const std::vector<DrillRow> rows = model::drillTableWithCopies(*board);
        QCOMPARE(textOf(*board, rows), Texts{"through via 300 #1 x 3"});
        QCOMPARE(rows[0].otherTools, std::vector{2});
        QCOMPARE(model::toolsText(rows[0]), std::string("1, 2"));
    }

    /// Sizes of a DipTrace job: 39.3701 and 39.4003 mil, both within what is forgiven.
    void theNearestToolIsTheOne() {
        Step step;
        step.tool(1, 1'000'001).tool(2, 1'000'768).tool(3, 1'000'768);
        step.builder.beginLayer(step.through);
        DocumentBuilder::Origin origin;
        origin.flags = kViaFlags;
        for (const Nm size : {1'000'001, 1'000'400, 1'000'768}) {
            step.builder.addCircle({{0, 0}, size, size}, origin);
        }
        const auto board = step.builder.finish();
        std::vector<std::pair<Nm, std::string>> tools;
        for (const DrillRow& row : model::drillTable(*board)) {
            tools.emplace_back(row.diameter, model::toolsText(row));
        }
        QCOMPARE(tools,
                 (std::vector<std::pair<Nm, std::string>>{{1'000'001, "1"}, {1'000'400, "2, 3"}, {1'000'768, "2, 3"}}));
    }

    void aNearerToolOfTheOtherPlatingIsNotPreferred() {
        Step step;
        model::DrillTool bare;
        bare.layer = step.through;
        bare.number = 9;
        bare.plating = model::Plating::NonPlated;
        bare.drillSize = bare.finishedSize = 300'000;
        step.builder.addTool(bare);
        step.tool(1, 300'500).holes(step.through, 300'000, 1);
        const auto board = step.builder.finish();
        QCOMPARE(textOf(*board, model::drillTable(*board)), Texts{"through via 300 #1 x 1"});
    }

    void runsOfToolsAreShort() {
        model::DrillTool tool;
        tool.number = 4;
        model::DrillRow row;
        QCOMPARE(model::toolsText(row), std::string());
        row.tool = &tool;
        row.otherTools = {5, 6, 7, 9, 12, 13};
        QCOMPARE(model::toolsText(row), std::string("4-7, 9, 12, 13"));
        row.otherTools.insert(row.otherTools.end(), {20, 21, 22, 30});
        QCOMPARE(model::toolsText(row), std::string("4-7, 9, 12, 13, …"));
    }

    void whatNoToolSaysOfThePlatingIsAssumed() {
        for (const bool isSaid : {false, true}) {
            Step step;
            model::DrillTool tool;
            tool.layer = step.through;
            tool.drillSize = 300'000;
            tool.finishedSize = isSaid ? 250'000 : 300'000;
            step.builder.addTool(tool);
            step.holes(step.through, 300'000, 1, model::kHole);  // an NPTH is as wide inside as it is drilled
            DocumentBuilder::Origin origin;
            origin.flags = kViaFlags;
            const model::ElementId plated = step.builder.addCircle({{0, 0}, 300'000, 250'000}, origin);
            const auto board = step.builder.finish();
            for (const DrillRow& row : model::drillTable(*board)) {
                QCOMPARE(row.isOpenAssumed, !isSaid && row.kind != HoleKind::NonPlated);
            }
            const DrillRow row = model::drillRowOf(*board, plated);
            QCOMPARE(row.isOpenAssumed, !isSaid);
            QCOMPARE(row.open, 250'000);
            QCOMPARE(row.tool->finishedSize, isSaid ? 250'000 : 300'000);
            QCOMPARE(row.count, 1U);
        }
    }

    void slotsOfOneWidthAreToldApartByLength() {
        Step step;
        step.builder.beginLayer(step.through);
        DocumentBuilder::Origin origin;
        origin.flags = kViaFlags;
        const auto slot = [&](model::Point from, model::Point to) {
            step.builder.addLine({from, to, 1'000'000, 900'000}, origin);
        };
        slot({0, 0}, {3'000'000, 0});
        slot({0, 0}, {0, 3'000'002});  // ends are whole nanometres
        slot({0, 0}, {2'400'000, 3'200'000});
        step.builder.addArc(
            {{{1'000'000, 0}, {0, 0}, model::EdgeKind::ArcCounterClockwise}, {-1'000'000, 0}, 600'000, 0}, origin);
        const std::vector<DrillRow> rows = model::drillTable(*step.builder.finish());
        std::vector<std::pair<Nm, std::uint32_t>> lengths;
        for (const DrillRow& row : rows) {
            QCOMPARE(row.shape, "slot");
            QVERIFY(hasDrilledSize(row));
            lengths.emplace_back(row.length, row.count);
        }
        QCOMPARE(lengths, (std::vector<std::pair<Nm, std::uint32_t>>{{3'741'600, 1}, {4'000'000, 2}, {5'000'000, 1}}));
    }

    void areasAreToldApartByTheSidesOfTheirBox() {
        Step step;
        step.tool(1, 1'100'000).builder.beginLayer(step.through);
        DocumentBuilder::Origin origin;
        origin.flags = kViaFlags;
        const auto add = [&](Nm width, Nm height, double turn) {
            model::ShapeSketch sketch;
            model::addBox(sketch, width, height, false);
            return step.builder.addArea({step.builder.addShape(sketch), {{0, 0}, turn, false}}, origin);
        };
        add(1'100'000, 1'800'000, 0.0);
        add(1'100'002, 1'800'000, 90.0);
        add(1'000'000, 1'800'000, 0.0);
        const auto board = step.builder.finish();
        std::vector<std::array<Nm, 3>> sizes;
        for (const DrillRow& row : model::drillTable(*board)) {
            QCOMPARE(row.shape, "area");
            QVERIFY(row.tool == nullptr && !row.isOpenAssumed && row.open == 0 && !hasDrilledSize(row));
            sizes.push_back({row.diameter, row.length, static_cast<Nm>(row.count)});
            QCOMPARE(model::holesOf(*board, std::span(&row, 1)).size(), std::size_t{row.count});
        }
        QCOMPARE(sizes, (std::vector<std::array<Nm, 3>>{{1'000'000, 1'800'000, 1}, {1'100'000, 1'800'000, 2}}));
    }

    void holesOfCopiesOfCopiesAreCounted() {
        Step card;
        card.tool(1, 300'000).holes(card.through, 300'000, 3);
        Step row;
        row.place(card.builder.finish(), 2);
        Step panel;
        panel.holes(panel.through, 3'000'000, 4, model::kHole).place(row.builder.finish(), 5);
        const auto board = panel.builder.finish();
        QCOMPARE(textOf(*board, model::drillTable(*board)), Texts{"through non_plated 3000 x 4"});
        QCOMPARE(textOf(*board, model::drillTableWithCopies(*board)),
                 (Texts{"through via 300 #1 x 30", "through non_plated 3000 x 4"}));
    }

    void whatTheJobCallsAMicroviaIsOneBetweenNeighbours() {
        Step card;
        for (const LayerId layer : {card.above, card.through}) {
            card.builder.beginLayer(layer);
            DocumentBuilder::Origin origin;
            origin.flags = kViaFlags;
            card.builder.addCircle({{0, 0}, 200'000, 200'000}, origin);
            origin.attributes = card.builder.attributes({{model::kViaType, model::kMicroviaType}});
            card.builder.addCircle({{model::kMostMicrovia * 4, 0}, 200'000, 200'000}, origin);
        }
        const std::vector<DrillRow> rows = model::drillTable(*card.builder.finish());
        const auto count = [&](model::HoleSpan span) { return std::ranges::count(rows, span, &DrillRow::span); };
        QCOMPARE(rows.size(), std::size_t{4});
        QCOMPARE(count(model::HoleSpan::Micro), 1);
        QCOMPARE(count(model::HoleSpan::Blind), 1);
        QCOMPARE(count(model::HoleSpan::Through), 2);
    }

    void flippedCopiesAreDrilledFromTheOtherSide() {
        Step card;
        card.holes(card.above, 100'000, 2).holes(card.below, 100'000, 1);
        Step panel;
        panel.place(card.builder.finish(), 10, 1);
        const auto board = panel.builder.finish();
        const std::vector<DrillRow> rows = model::drillTableWithCopies(*board);
        QCOMPARE(textOf(*board, rows), (Texts{"above via 100 x 21", "below via 100 x 12"}));
        QVERIFY(rows[0].span == model::HoleSpan::Micro);
    }

    void stepsThatNumberToolsDifferentlyAreToldApart() {
        Step one;
        one.tool(1, 300'000).holes(one.through, 300'000, 1);
        Step other;
        other.tool(2, 300'000).holes(other.through, 300'000, 1);
        Step panel;
        panel.place(one.builder.finish(), 2).place(other.builder.finish(), 3);
        const auto board = panel.builder.finish();
        QCOMPARE(textOf(*board, model::drillTableWithCopies(*board)),
                 (Texts{"through via 300 #1 x 2", "through via 300 #2 x 3"}));
    }

    void everyRowNamesAsManyHolesAsItCounts() {
        Step card;
        card.tool(1, 300'000).holes(card.through, 300'000, 3).holes(card.above, 100'000, 2);
        Step other;
        other.tool(2, 300'000).holes(other.through, 300'000, 4).holes(other.below, 100'000, 1);
        Step panel;
        panel.holes(panel.through, 300'000, 1).place(card.builder.finish(), 2, 2).place(other.builder.finish(), 1, 3);
        const auto board = panel.builder.finish();
        std::set<BoardElement> all;
        std::size_t counted = 0;
        for (const DrillRow& row : model::drillTableWithCopies(*board)) {
            const std::vector<BoardElement> holes = model::holesOf(*board, std::span(&row, 1));
            QCOMPARE(holes.size(), std::size_t{row.count});
            QVERIFY(std::ranges::is_sorted(holes));
            all.insert(holes.begin(), holes.end());
            counted += row.count;
        }
        QCOMPARE(all.size(), counted);  // none twice
        QCOMPARE(counted, std::size_t{1 + 4 * 5 + 4 * 5});
    }
};

QTEST_APPLESS_MAIN(HolesTest)
#include "holes_test.moc"
