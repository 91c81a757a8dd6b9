#include "model/export/solids/solid_plan.h"

#include <QtTest>

#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::ElementId;
using model::LayerId;
using model::LayerType;
using model::SolidChoice;
using model::SolidPlan;

namespace {

constexpr std::array<StackLayer, 4> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2},
                                              {"inner", LayerType::Signal, 800 * kUm, 35 * kUm, 1},
                                              {"bottom", LayerType::Signal, 0, 50 * kUm, 0},
                                              {"drill", LayerType::Drill, 0, 1'635 * kUm, 3}}};

struct Board {
    std::shared_ptr<const model::Document> document;
    ElementId track, pad, inner, narrow, wide, npth;
};

Board makeBoard() {
    model::DocumentBuilder builder;
    Board board;
    std::array<StackLayer, 4> rows = kStackup;
    addLayers(builder, rows);
    const model::NetId a = builder.addNet("A");
    const model::NetId b = builder.addNet("B");
    builder.beginLayer(LayerId{std::size_t{0}});
    board.track = builder.addLine({{0, 0}, {kMm, 0}, 200 * kUm, 0}, of(a));
    board.pad = builder.addCircle({{9 * kMm, 9 * kMm}, kMm, 0}, of(b, model::kPad));
    builder.beginLayer(LayerId{std::size_t{1}});
    board.inner = builder.addLine({{0, 0}, {kMm, 0}, 200 * kUm, 0}, of(b));
    builder.beginLayer(LayerId{std::size_t{3}});
    board.narrow = builder.addCircle({{kMm, kMm}, 300 * kUm, 250 * kUm}, of(a, model::kHole | model::kPlated));
    board.wide = builder.addCircle({{2 * kMm, kMm}, kMm, 950 * kUm}, of(a, model::kHole | model::kPlated));
    board.npth = builder.addCircle({{3 * kMm, kMm}, kMm, kMm}, flagged(model::kHole));
    board.document = std::move(builder).finish();
    return board;
}

std::vector<ElementId> chosen(const Board& board, const SolidChoice& choice) {
    base::Progress progress;
    const auto plan = model::planSolids(*board.document, choice, progress);
    return plan ? plan->steps.front().elements : std::vector<ElementId>();
}

}  // namespace

class SolidPlanTest : public QObject {
    Q_OBJECT

private slots:
    void groupsAreLayersAndNets() {
        const Board board = makeBoard();
        base::Progress progress;
        const SolidPlan plan = *model::planSolids(*board.document, {}, progress);
        const auto& groups = plan.steps.front().groups;
        QStringList names;
        for (const model::SolidGroup& group : groups) {
            names << QString::fromStdString(board.document->layer(group.layer).name + "/" +
                                            plan.nameOf(plan.steps.front(), group));
        }
        QCOMPARE(names, QStringList({"top/A", "top/B", "inner/B", "drill/A"}));
        QCOMPARE(plan.elements, std::uint64_t{5});  // an NPTH is no solid
    }

    void filtersLeaveOut() {
        const Board board = makeBoard();
        const std::vector<ElementId> all{board.track, board.pad, board.inner, board.narrow, board.wide};
        QCOMPARE(chosen(board, {}), all);
        SolidChoice layers;
        layers.layers = {LayerId{std::size_t{1}}};
        QCOMPARE(chosen(board, layers), std::vector{board.inner});
        SolidChoice nets;
        nets.nets = {"B"};
        QCOMPARE(chosen(board, nets), (std::vector{board.pad, board.inner}));
        SolidChoice window;
        window.window = model::Box{{8 * kMm, 8 * kMm}, {10 * kMm, 10 * kMm}};
        QCOMPARE(chosen(board, window), std::vector{board.pad});
        SolidChoice holes;
        holes.minHole = 500 * kUm;
        QCOMPARE(chosen(board, holes), (std::vector{board.track, board.pad, board.inner, board.wide}));
    }

    void refusesWhatIsNotThere() {
        const Board board = makeBoard();
        base::Progress progress;
        SolidChoice choice;
        choice.nets = {"A", "nowhere"};
        const auto unknown = model::planSolids(*board.document, choice, progress);
        QVERIFY(!unknown && unknown.error().code == base::ErrorCode::BadUsage);
        QVERIFY(unknown.error().text.find("nowhere") != std::string::npos);
        SolidChoice nothing;
        nothing.window = model::Box{{50 * kMm, 50 * kMm}, {60 * kMm, 60 * kMm}};
        QVERIFY(!model::planSolids(*board.document, nothing, progress));
    }

    void closedHolesAreGoneFromTheSubstrate() {
        model::DocumentBuilder builder;
        const LayerId body = addLayer(builder, "board", LayerType::Body);
        builder.beginLayer(body);
        model::ShapeSketch sketch = rectangle({0, 0}, {10 * kMm, 10 * kMm});
        sketch.addCircle({2 * kMm, 2 * kMm}, 150 * kUm, true);
        sketch.addCircle({5 * kMm, 5 * kMm}, kMm, true);
        const ElementId element = builder.addArea({builder.addShape(sketch), {}}, {});
        model::Document made = *std::move(builder).finish();
        made.layers[0].thickness = kMm;
        base::Progress progress;
        SolidChoice choice;
        choice.minHole = 500 * kUm;
        const SolidPlan plan = *model::planSolids(made, choice, progress);
        const auto shells = plan.shellsOf(plan.steps.front(), element).shells;
        QCOMPARE(shells.size(), std::size_t{1});
        QCOMPARE(shells.front().outline.loopCount(), std::size_t{2});
    }

    void flippedCopiesLieMirroredOnTheOppositeLayer() {
        const Board board = makeBoard();
        model::Document panel = *board.document;
        panel.steps = {board.document};
        panel.instances = {model::StepInstance{0, {{20 * kMm, 0}, 90.0, true}, true}};
        base::Progress progress;
        const SolidPlan plan = *model::planSolids(panel, {}, progress);
        QCOMPARE(plan.steps.size(), std::size_t{2});
        QCOMPARE(plan.copies.size(), std::size_t{2});
        const model::StepSolids& step = plan.steps[1];
        QVERIFY(step.isFlipped && !plan.copies[1].placement.isMirrored);
        const model::ZRange z = plan.heightsOf(step, board.track);
        QCOMPARE(z.bottom, 0);
        QCOMPARE(z.top, 50 * kUm);  // the bottom layer's
        // The same location by the panel's own placement and by that of the flipped step.
        const model::PointD corner{kMm, 300 * kUm};
        const model::PointD direct = panel.instances[0].placement.apply(corner);
        const model::PointD turned = plan.copies[1].placement.apply(model::PointD{-corner.x, corner.y});
        QVERIFY(std::hypot(direct.x - turned.x, direct.y - turned.y) < 1e-6);
        const auto shells = plan.shellsOf(step, board.track).shells;
        QVERIFY(shells.front().outline.edges.front().a.x <= 200'000.0);  // mirrored: it runs to x = -1 mm
        QVERIFY(model::areaOf(shells.front().outline) > 0.0);
    }
};

QTEST_APPLESS_MAIN(SolidPlanTest)
#include "solid_plan_test.moc"
