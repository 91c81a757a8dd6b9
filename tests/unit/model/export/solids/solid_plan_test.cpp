#include "model/export/solids/solid_plan.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/board/flip.h"
#include "model/solids/solids.h"
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

SolidPlan planOf(const model::Document& document, const SolidChoice& choice = {}) {
    base::Progress progress;
    auto plan = model::planSolids(document, choice, progress);
    if (!plan) {
        qFatal("%s", plan.error().text.c_str());
    }
    return std::move(*plan);
}

/// mm², of all regions of an element.
double areaOf(const SolidPlan& plan, ElementId element) {
    double area = 0.0;
    for (const model::Shell& shell : plan.shellsOf(plan.steps.front(), element).shells) {
        area += model::areaOf(shell.outline) / 1e12;
    }
    return area;
}

bool isNear(double value, double expected) {
    const bool is = std::abs(value - expected) < 1e-6;
    if (!is) {
        qWarning("%.9g is not %.9g", value, expected);
    }
    return is;
}

/// mm²
double disc(double diameter) {
    return std::numbers::pi / 4 * diameter * diameter;
}

/// What a track of 0.2 mm that begins in the middle of a circle has within it, but for its round end.
double underTrack(double radius) {
    const double half = std::asin(0.1 / radius);
    return 0.1 * radius * std::cos(half) + radius * radius * half;
}

/// Pads, a track and a plane on each of three copper layers, drilled through and from the top down to
/// the inner layer.
struct DrilledBoard {
    std::shared_ptr<const model::Document> document;
    std::array<ElementId, 3> pads, blind, eaten, planes, slotted, tracks;  ///< by layer of copper
    ElementId barrel, npth;
};

DrilledBoard makeDrilledBoard() {
    model::DocumentBuilder builder;
    DrilledBoard board;
    std::array<StackLayer, 4> rows = kStackup;
    addLayers(builder, rows);
    model::Layer blind;
    blind.name = "blind";
    blind.type = LayerType::Drill;
    blind.spanTop = LayerId{std::size_t{0}};
    blind.spanBottom = LayerId{std::size_t{1}};
    builder.addLayer(blind);
    const model::NetId a = builder.addNet("A");
    const model::NetId b = builder.addNet("B");
    const model::ShapeId plane = builder.addShape(rectangle({0, 10 * kMm}, {10 * kMm, 20 * kMm}));
    for (const std::size_t layer : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        builder.beginLayer(LayerId{layer});
        board.pads[layer] = builder.addCircle({{0, 0}, kMm, 0}, of(a, model::kPad));
        board.blind[layer] = builder.addCircle({{5 * kMm, 0}, kMm, 0}, of(a, model::kPad));
        board.eaten[layer] = builder.addCircle({{10 * kMm, 0}, kMm, 0}, of(a, model::kPad));
        board.slotted[layer] = builder.addCircle({{20 * kMm, 0}, 3 * kMm, 0}, of(a, model::kPad));
        board.tracks[layer] = builder.addLine({{0, 0}, {0, -5 * kMm}, 200 * kUm}, of(a));
        board.planes[layer] = builder.addArea({plane, {}}, of(b));
    }
    builder.beginLayer(LayerId{std::size_t{3}});
    board.barrel = builder.addCircle({{0, 0}, 500 * kUm, 400 * kUm}, of(a, model::kHole | model::kPlated));
    board.npth = builder.addCircle({{10 * kMm, 0}, kMm, kMm}, flagged(model::kHole));
    builder.addLine({{19 * kMm, 0}, {21 * kMm, 0}, 500 * kUm, 400 * kUm}, of(a, model::kHole | model::kPlated));
    builder.addCircle({{5 * kMm, 15 * kMm}, 500 * kUm, 400 * kUm}, of(b, model::kHole | model::kPlated));
    builder.addCircle({{0, 15 * kMm}, kMm, 900 * kUm}, of(b, model::kHole | model::kPlated));
    builder.beginLayer(LayerId{std::size_t{4}});
    builder.addCircle({{5 * kMm, 0}, 500 * kUm, 400 * kUm}, of(a, model::kHole | model::kPlated));
    board.document = std::move(builder).finish();
    return board;
}

model::Box boxOf(const std::vector<model::Shell>& shells, const model::Placement& placement) {
    model::Box box;
    for (const model::Shell& shell : shells) {
        box.include(model::boxOf(model::placed(shell.outline, placement)));
    }
    return box;
}

bool areNear(const model::Box& a, const model::Box& b) {
    constexpr model::Nm kRounding = 2;
    return a.grownBy(kRounding).holds(b.min) && a.grownBy(kRounding).holds(b.max) &&
           b.grownBy(kRounding).holds(a.min) && b.grownBy(kRounding).holds(a.max);
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
    void openingsThatAreTakenForTheMaskAreFound() {
        model::Document board;
        const auto add = [&](const char* name, LayerType type, model::LayerSide side, bool isSynthetic) {
            model::Layer layer;
            layer.name = name;
            layer.type = type;
            layer.side = side;
            layer.isSynthetic = isSynthetic;
            board.layers.push_back(layer);
            return LayerId{board.layers.size() - 1};
        };
        const LayerId top = add("F.Mask", LayerType::SolderMask, model::LayerSide::Top, false);
        const LayerId copper = add("F.Cu", LayerType::Signal, model::LayerSide::Top, false);
        const LayerId bottom = add("B.Mask", LayerType::SolderMask, model::LayerSide::Bottom, false);
        const LayerId mask = add("F.Mask solder mask", LayerType::SolderMask, model::LayerSide::Top, true);
        const auto found = [&](std::vector<LayerId> layers) {
            SolidChoice choice;
            choice.layers = std::move(layers);
            return model::chosenOpenings(board, choice);
        };
        QVERIFY(found({}).empty());
        QVERIFY(found({copper, mask}).empty());
        QVERIFY(found({top, mask}).empty());
        QVERIFY(found({bottom}).empty());  // there is no mask to name
        QCOMPARE(found({copper, top}).size(), std::size_t{1});
        QCOMPARE(found({top}).front().mask, mask);
    }

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

    void stepsWithoutAChosenNetHaveNoCopper() {
        const Board board = makeBoard();
        model::DocumentBuilder builder;
        std::array<StackLayer, 4> rows = kStackup;
        addLayers(builder, rows);
        builder.beginLayer(LayerId{std::size_t{0}});
        builder.addCircle({{0, 0}, kMm, 0}, {});
        builder.beginLayer(LayerId{std::size_t{3}});
        builder.addCircle({{0, 0}, 500 * kUm, 400 * kUm}, flagged(model::kHole | model::kPlated));
        builder.addInstance({builder.addStep(board.document), {{20 * kMm, 0}, 0.0, false}, false});
        const auto panel = std::move(builder).finish();
        SolidChoice choice;
        choice.nets = {"A"};
        const SolidPlan plan = planOf(*panel, choice);
        QVERIFY(plan.steps.front().elements.empty());
        QCOMPARE(plan.steps[1].elements, (std::vector{board.track, board.narrow, board.wide}));
    }

    void drawingsThatTheJobCallsSilkscreenAreNoPrint() {
        model::Layer layer;
        layer.type = LayerType::SilkScreen;
        layer.name = "silkscreen top";
        QVERIFY(model::isSolidLayer(layer));
        layer.name = "assembly top";
        QVERIFY(!model::isSolidLayer(layer));
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

    void holesAreCutOutOfCopper() {
        const DrilledBoard board = makeDrilledBoard();
        const SolidPlan plan = planOf(*board.document);
        for (const std::size_t layer : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
            QVERIFY(isNear(areaOf(plan, board.pads[layer]), disc(1) - disc(0.5)));
            QVERIFY(isNear(areaOf(plan, board.slotted[layer]), disc(3) - disc(0.5) - 2 * 0.5));
            // One hole in the plane and half of one at its edge.
            QVERIFY(isNear(areaOf(plan, board.planes[layer]), 100 - disc(0.5) - disc(1) / 2));
            const auto eaten = plan.shellsOf(plan.steps.front(), board.eaten[layer]);
            QVERIFY(eaten.shells.empty() && eaten.problem.empty());
        }
        QVERIFY(isNear(areaOf(plan, board.tracks[0]), 5 * 0.2 + disc(0.2) / 2 - underTrack(0.25)));
        // The barrel fits into the hole.
        const auto barrel = plan.shellsOf(plan.steps.front(), board.barrel).shells;
        QCOMPARE(barrel.size(), std::size_t{1});
        const auto pad = plan.shellsOf(plan.steps.front(), board.pads[0]).shells;
        QCOMPARE(pad.size(), std::size_t{1});
        QCOMPARE(pad.front().outline.loopCount(), std::size_t{2});
        QCOMPARE(pad.front().outline.loop(1).front().radius, barrel.front().outline.loop(0).front().radius);
    }

    void holesEndWhereTheirDrillEnds() {
        const DrilledBoard board = makeDrilledBoard();
        const SolidPlan plan = planOf(*board.document);
        QVERIFY(isNear(areaOf(plan, board.blind[0]), disc(1) - disc(0.5)));
        QVERIFY(isNear(areaOf(plan, board.blind[1]), disc(1) - disc(0.5)));
        QVERIFY(isNear(areaOf(plan, board.blind[2]), disc(1)));
    }

    void laserViasLandOnTheirTarget() {
        model::Document document = *makeDrilledBoard().document;
        const DrilledBoard board = makeDrilledBoard();
        const model::Range blind = document.layers[4].elements;
        model::CircleGeometry& via = document.circles.edit()[document.elements.geometry[blind.first]];
        via.diameter = 100 * kUm;
        via.innerDiameter = 60 * kUm;
        const SolidPlan plan = planOf(document);
        QVERIFY(isNear(areaOf(plan, board.blind[0]), disc(1) - disc(0.1)));
        QVERIFY(isNear(areaOf(plan, board.blind[1]), disc(1)));
        const model::ZRange z = plan.heightsOf(plan.steps.front(), ElementId{blind.first});
        QCOMPARE(z.bottom, 835 * kUm);  // the upper face of the inner layer
        QCOMPARE(z.top, 1'635 * kUm);
    }

    void holesAreCutOutWhateverIsChosen() {
        const DrilledBoard board = makeDrilledBoard();
        SolidChoice choice;
        choice.layers = {LayerId{std::size_t{0}}};
        choice.nets = {"A"};
        QVERIFY(isNear(areaOf(planOf(*board.document, choice), board.pads[0]), disc(1) - disc(0.5)));
        choice.minHole = 600 * kUm;  // its barrel is left out, and the substrate closed
        QVERIFY(isNear(areaOf(planOf(*board.document, choice), board.pads[0]), disc(1)));
    }

    void padsThatAreDrilledAlikeAreOneShape() {
        const DrilledBoard board = makeDrilledBoard();
        const SolidPlan plan = planOf(*board.document);
        const model::StepSolids& step = plan.steps.front();
        const auto pad = plan.sharedShapeOf(step, board.pads[0]);
        const auto blind = plan.sharedShapeOf(step, board.blind[0]);
        QVERIFY(pad && blind && pad->key == blind->key);
        QVERIFY(
            isNear(model::areaOf(plan.shellsOf(step, pad->key).shells.front().outline) / 1e12, disc(1) - disc(0.5)));
        const auto below = plan.sharedShapeOf(step, board.blind[2]);
        QVERIFY(!below || below->key.drilled != plan.sharedShapeOf(step, board.pads[0])->key.drilled);
    }

    void comparingHolesStopsWhenCancelled() {
        const DrilledBoard board = makeDrilledBoard();
        const auto drilledOf = [&](bool isCancelled) {
            model::CopperHoles holes(*board.document, [](ElementId) { return true; });
            base::Progress progress;
            if (isCancelled) {
                progress.cancel();
            }
            holes.compare(std::array{board.pads[0], board.blind[0], board.eaten[0]}, progress);
            return holes.sharedShapeOf(board.pads[0])->key.drilled;
        };
        QVERIFY(drilledOf(false) != drilledOf(true));
    }

    void mergedCopperIsDrilledToo() {
        const DrilledBoard board = makeDrilledBoard();
        SolidChoice choice;
        choice.isMerged = true;
        const SolidPlan plan = planOf(*board.document, choice);
        double merged = 0.0;
        double single = 0.0;
        for (const model::SolidGroup& group : plan.steps.front().groups) {
            if (const auto shells = plan.mergedShellsOf(plan.steps.front(), group)) {
                QCOMPARE(shells->problems, std::size_t{0});
                for (const model::Shell& shell : shells->shells) {
                    merged += model::areaOf(shell.outline) / 1e12;
                }
            }
        }
        for (const std::size_t layer : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
            for (const ElementId element : {board.pads[layer], board.blind[layer], board.eaten[layer],
                                            board.slotted[layer], board.planes[layer], board.tracks[layer]}) {
                single += areaOf(plan, element);
            }
        }
        // The track overlaps the ring of its pad: from the hole's edge to that of the pad.
        QVERIFY(isNear(merged, single - 3 * (underTrack(0.5) - underTrack(0.25))));
    }

    void whatIsMilledIsDrilledToo() {
        model::DocumentBuilder builder;
        std::array<StackLayer, 4> rows = kStackup;
        addLayers(builder, rows);
        builder.setProfile(builder.addShape(rectangle({0, 0}, {10 * kMm, 10 * kMm})));
        builder.beginLayer(LayerId{std::size_t{0}});
        const model::ShapeId bar = builder.addShape(rectangle({-5 * kMm, 4 * kMm}, {6 * kMm, 6 * kMm}));
        const ElementId copper = builder.addArea({bar, {}}, {});
        builder.beginLayer(LayerId{std::size_t{3}});
        builder.addCircle({{3 * kMm, 5 * kMm}, kMm, 900 * kUm}, flagged(model::kHole | model::kPlated));
        builder.addCircle({{0, 5 * kMm}, kMm, 900 * kUm}, flagged(model::kHole | model::kPlated));  // a castellation
        const auto document = std::move(builder).finish();
        const double expected = 12 - disc(1) - disc(1) / 2;
        const double found = areaOf(planOf(*document), copper);
        QVERIFY2(std::abs(found - expected) < 5e-3, qPrintable(QString::number(found)));  // chords of 5 µm
        SolidChoice choice;
        choice.isAsDesigned = true;
        QVERIFY(isNear(areaOf(planOf(*document, choice), copper), 22 - 2 * disc(1)));
    }

    /// The layer that a job for a panel names is the panel's: the drawings have the same there.
    void layersAreChosenByWhereCopiesHaveThem() {
        const Board board = makeBoard();
        model::Document panel = *board.document;
        panel.steps = {board.document};
        panel.instances = {model::StepInstance{0, {{20 * kMm, 0}, 0.0, true}, true}};
        SolidChoice choice;
        choice.layers = {board.document->findLayer("bottom")};
        const SolidPlan below = planOf(panel, choice);
        QVERIFY(below.steps[0].elements.empty());
        QCOMPARE(below.steps[1].elements, (std::vector{board.track, board.pad}));
        choice.layers = {board.document->findLayer("top")};
        const SolidPlan above = planOf(panel, choice);
        QCOMPARE(above.steps[0].elements, (std::vector{board.track, board.pad}));
        QVERIFY(above.steps.size() == 1 || above.steps[1].elements.empty());
    }

    /// A job may mirror copies without turning them over, and turn them over without mirroring.
    void allCopiesLieWhereTheirPlacementsSay() {
        const DrilledBoard board = makeDrilledBoard();
        model::Document panel = *board.document;
        panel.steps = {board.document};
        panel.instances = {model::StepInstance{0, {{40 * kMm, 0}, 90.0, false}, false},
                           model::StepInstance{0, {{80 * kMm, 0}, 90.0, true}, false},
                           model::StepInstance{0, {{0, 40 * kMm}, 30.0, true}, true},
                           model::StepInstance{0, {{40 * kMm, 40 * kMm}, 0.0, false}, true}};
        const SolidPlan plan = planOf(panel);
        const model::StepTree tree = model::unfoldCopies(panel);
        QCOMPARE(plan.copies.size(), std::size_t{5});
        std::size_t shared = 0;
        for (std::size_t copy = 0; copy < plan.copies.size(); ++copy) {
            const model::Placement& placement = plan.copies[copy].placement;
            const model::StepSolids& step = plan.steps[plan.copies[copy].step];
            QVERIFY(!placement.isMirrored);
            QCOMPARE(step.isFlipped, tree.copies[copy].isFlipped);
            for (const ElementId element : step.elements) {
                std::vector<model::Shell> expected;
                for (model::EdgeLoops& region : model::outlinesOf(*step.document, element).regions) {
                    expected.push_back({std::move(region), {}});
                }
                QVERIFY(areNear(boxOf(plan.undrilledShellsOf(step, element).shells, placement),
                                boxOf(expected, tree.copies[copy].placement)));
                const auto shape = plan.sharedShapeOf(step, element);
                const std::vector<model::Shell> drilled = plan.shellsOf(step, element).shells;
                if (shape && !drilled.empty()) {
                    QVERIFY(areNear(boxOf(plan.shellsOf(step, shape->key).shells, placement.after(shape->placement)),
                                    boxOf(drilled, placement)));
                    ++shared;
                }
            }
        }
        QVERIFY(shared > 0);
        const model::ZRange mirrored = plan.heightsOf(plan.steps[plan.copies[2].step], board.pads[0]);
        QCOMPARE(mirrored.bottom, 1'600 * kUm);
        const model::ZRange flipped = plan.heightsOf(plan.steps[plan.copies[4].step], board.pads[0]);
        QCOMPARE(flipped.bottom, 0);
    }

    void flippedCopiesAreDrilled() {
        const DrilledBoard board = makeDrilledBoard();
        model::Document panel = *board.document;
        panel.steps = {board.document};
        panel.instances = {model::StepInstance{0, {{40 * kMm, 0}, 90.0, true}, true}};
        const SolidPlan plan = planOf(panel);
        const model::StepSolids& step = plan.steps[1];
        const auto shells = plan.shellsOf(step, board.planes[0]).shells;
        QCOMPARE(shells.size(), std::size_t{1});
        QVERIFY(isNear(model::areaOf(shells.front().outline) / 1e12, 100 - disc(0.5) - disc(1) / 2));
        const auto blind = plan.sharedShapeOf(step, board.blind[0]);
        QVERIFY(blind);
        QVERIFY(
            isNear(model::areaOf(plan.shellsOf(step, blind->key).shells.front().outline) / 1e12, disc(1) - disc(0.5)));
        const auto holes = plan.holesNear(step, LayerId{std::size_t{0}}, {{-6 * kMm, -kMm}, {-4 * kMm, kMm}});
        QCOMPARE(holes.size(), std::size_t{1});  // mirrored: the via of the blind drill
        QVERIFY(std::abs(holes.front().edges.front().centre.x + 5 * kMm) < 1);
    }

    /// A mask on the top alone, a body of 2 mm there and one of 1 mm below.
    void whatNoLayerOfTheJobDrawsIsFlippedToo() {
        model::DocumentBuilder builder;
        std::array<StackLayer, 4> rows = kStackup;
        addLayers(builder, rows);
        builder.setProfile(builder.addShape(rectangle({0, 0}, {10 * kMm, 10 * kMm})));
        model::Layer mask;
        mask.name = "mask";
        mask.type = LayerType::SolderMask;
        mask.side = model::LayerSide::Top;
        mask.z = 1'635 * kUm;
        mask.thickness = 20 * kUm;
        builder.beginLayer(builder.addLayer(mask));
        builder.addCircle({{kMm, kMm}, kMm, 0}, {});
        const base::Progress progress;
        QVERIFY(model::addSolids(builder, progress));
        const model::ShapeId shape = builder.addShape(rectangle({2 * kMm, 2 * kMm}, {4 * kMm, 4 * kMm}));
        std::vector<ElementId> bodies;
        for (const auto& [side, height] :
             {std::pair(model::LayerSide::Top, 2 * kMm), std::pair(model::LayerSide::Bottom, kMm)}) {
            model::Layer layer;
            layer.type = LayerType::ComponentBody;
            layer.side = side;
            layer.isSynthetic = true;
            layer.z = side == model::LayerSide::Top ? 1'655 * kUm : -height;
            layer.thickness = height;
            builder.beginLayer(builder.addLayer(layer));
            bodies.push_back(builder.addArea({shape, {}}, {}));
            builder.addBody({bodies.back(), {}, height});
        }
        model::setSyntheticOpposites(builder.layers());
        const auto board = std::move(builder).finish();
        model::Document panel = *board;
        panel.steps = {board};
        panel.instances = {model::StepInstance{0, {{20 * kMm, 0}, 0.0, true}, true}};
        const SolidPlan plan = planOf(panel);
        const auto heights = [&](ElementId element) {
            const model::ZRange z = plan.heightsOf(plan.steps[1], element);
            return std::pair(z.bottom, z.top);
        };
        const auto onLayer = [&](const char* name) {
            return ElementId{board->layer(board->findLayer(name)).elements.first};
        };
        QCOMPARE(heights(bodies[0]), std::pair(-2 * kMm, 0));
        QCOMPARE(heights(bodies[1]), std::pair(1'655 * kUm, 2'655 * kUm));
        QCOMPARE(heights(onLayer("mask solder mask")), std::pair(-20 * kUm, 0));
        QCOMPARE(heights(onLayer("board")), std::pair(50 * kUm, 1'600 * kUm));
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
