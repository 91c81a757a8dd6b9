#include "model/statistics/board_summary.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "tests/unit/model/hand_made.h"

using hand_made::flagged;
using hand_made::kMm;
using model::BoardSummary;
using model::DocumentBuilder;

namespace {

/// Two layers of copper, one that only a drawing has, a plated and a non-plated hole, a net and a component.
void addBoard(DocumentBuilder& builder) {
    const model::LayerId top = hand_made::addLayer(builder, "top");
    const model::LayerId bottom = hand_made::addLayer(builder, "bottom", model::LayerType::PowerGround);
    builder.layer(hand_made::addLayer(builder, "drawing")).context = model::LayerContext::Misc;
    const model::LayerId drill = hand_made::addDrill(builder, top, bottom);
    builder.beginLayer(drill);
    builder.addCircle({{0, 0}, 300'000, 250'000}, flagged(model::kHole | model::kPlated));
    builder.addCircle({{kMm, 0}, 3 * kMm, 3 * kMm}, flagged(model::kHole));
    builder.addNet("GND");
    builder.addComponent({}, {});
}

void outline(DocumentBuilder& builder, model::Point max) {
    builder.setProfile(builder.addShape(hand_made::rectangle({-kMm, 0}, max)));
}

BoardSummary summaryOf(const model::Document& board) {
    return model::summaryOf(board, model::drillTableWithCopies(board));
}

}  // namespace

class BoardSummaryTest : public QObject {
    Q_OBJECT

private slots:
    void aBoardIsAsLargeAsItsOutline() {
        DocumentBuilder builder;
        addBoard(builder);
        outline(builder, {99 * kMm, 80 * kMm});
        builder.setBoardThickness(1'600'000);
        const BoardSummary board = summaryOf(*builder.finish());
        QCOMPARE(board.width, std::int64_t{100 * kMm});
        QCOMPARE(board.height, std::int64_t{80 * kMm});
        QVERIFY(!board.isSizeAssumed && !board.hasCopies);
        QCOMPARE(board.thickness, 1'600'000);
        QCOMPARE(board.copperLayers, std::size_t{2});
        QCOMPARE(board.nets, std::uint64_t{1});
        QCOMPARE(board.components, std::uint64_t{1});
        QCOMPARE(board.holes, std::uint64_t{2});
    }

    void aPanelCountsItsCopies() {
        DocumentBuilder card;
        addBoard(card);
        outline(card, {9 * kMm, 10 * kMm});
        DocumentBuilder builder;
        addBoard(builder);
        outline(builder, {49 * kMm, 20 * kMm});
        const std::uint32_t step = builder.addStep(card.finish());
        builder.addInstance({step, {{10 * kMm, 0}, 0.0, false}, false});
        builder.addInstance({step, {{20 * kMm, 0}, 0.0, false}, false});
        const BoardSummary panel = summaryOf(*builder.finish());
        QVERIFY(panel.hasCopies);
        QCOMPARE(panel.width, std::int64_t{50 * kMm});
        QCOMPARE(panel.copperLayers, std::size_t{2});
        QCOMPARE(panel.nets, std::uint64_t{3});
        QCOMPARE(panel.components, std::uint64_t{3});
        QCOMPARE(panel.holes, std::uint64_t{6});
    }

    void anAssumedOutlineIsSaid() {
        DocumentBuilder builder;
        addBoard(builder);
        const model::ShapeId box = builder.addShape(hand_made::rectangle({0, 0}, {kMm, kMm}));
        builder.setProfile(box, model::Source::Assumed);
        QVERIFY(summaryOf(*builder.finish()).isSizeAssumed);
    }

    void anEmptyBoardHasNothing() {
        const BoardSummary board = summaryOf(model::Document());
        QCOMPARE(board.width, std::int64_t{0});
        QCOMPARE(board.holes + board.nets + board.components + board.copperLayers, std::uint64_t{0});
    }
};

QTEST_APPLESS_MAIN(BoardSummaryTest)
#include "board_summary_test.moc"
