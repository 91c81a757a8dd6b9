// Distances between nets in space: beside each other, through dielectric, at plated holes, across copies; and all of
// them against every pair of elements tried one by one.
#include "model/clearance/stackup_clearance.h"

#include <QtTest>
#include <cmath>
#include <map>
#include <random>

#include "model/board/document_builder.h"
#include "model/figures/distance.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::BoardElement;
using model::DocumentBuilder;
using model::LayerId;
using model::Nm;
using model::StackupClearance;

namespace {

constexpr hand_made::StackLayer kStack[] = {{"top", model::LayerType::Signal, 1000 * kUm, 35 * kUm, 2},
                                            {"inner", model::LayerType::Signal, 800 * kUm, 18 * kUm, 1},
                                            {"bottom", model::LayerType::Signal, 0, 35 * kUm, 0},
                                            {"drill", model::LayerType::Drill, 0, 1035 * kUm, 3}};

std::vector<StackupClearance> measure(const model::Document& board, model::StackupClearanceRequest request = {}) {
    base::Progress progress;
    return *model::smallestThroughStackup(board, request, progress);
}

bool isNear(double a, double b) {
    return std::abs(a - b) < 1.0;
}

/// Discs of ten nets at random places of three layers, and plated holes.
std::shared_ptr<const model::Document> randomBoard(unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](Nm most) { return static_cast<Nm>(random() % static_cast<unsigned>(most)); };
    DocumentBuilder builder;
    addLayers(builder, kStack);
    std::vector<model::NetId> nets;
    for (int i = 0; i < 10; ++i) {
        nets.push_back(builder.addNet("N" + std::to_string(i)));
    }
    for (std::size_t layer = 0; layer < 4; ++layer) {
        builder.beginLayer(LayerId{layer});
        for (int i = 0; i < 20; ++i) {
            const int flags = layer == 3 ? model::kHole | model::kPlated : 0;
            const Nm open = layer == 3 ? 100 * kUm : 0;
            builder.addCircle({{below(20 * kMm), below(20 * kMm)}, 200 * kUm + below(kMm), open},
                              of(nets[random() % nets.size()], flags));
        }
    }
    return builder.finish();
}

/// Between the faces of two elements.
double heightOf(const model::Document& board, std::uint32_t a, std::uint32_t b) {
    const model::ZRange za = board.heightsOf(model::ElementId{a});
    const model::ZRange zb = board.heightsOf(model::ElementId{b});
    return std::max({0.0, double(za.bottom - zb.top), double(zb.bottom - za.top)});
}

using Smallest = std::map<std::pair<model::NetId, model::NetId>, double>;

Smallest bruteForce(const model::Document& board) {
    Smallest smallest;
    for (std::uint32_t a = 0; a < board.elements.size(); ++a) {
        for (std::uint32_t b = 0; b < a; ++b) {
            const auto nets = std::minmax(board.elements.net[a], board.elements.net[b]);
            model::FigureTable first;
            model::FigureTable second;
            first.add(board, model::ElementId{a});
            second.add(board, model::ElementId{b});
            const double d = std::hypot(model::spacingBetween(first, second)->distance, heightOf(board, a, b));
            if (nets.first != nets.second) {
                const auto known = smallest.try_emplace({nets.first, nets.second}, d).first;
                known->second = std::min(known->second, d);
            }
        }
    }
    return smallest;
}

}  // namespace

class StackupClearanceTest : public QObject {
    Q_OBJECT

private slots:
    void throughDielectricAndAslant() {
        DocumentBuilder builder;
        addLayers(builder, kStack);
        const auto a = builder.addNet("A");
        const auto b = builder.addNet("B");
        const auto c = builder.addNet("C");
        builder.beginLayer(LayerId{0});
        builder.addCircle({{0, 0}, 200 * kUm, 0}, of(a));
        builder.beginLayer(LayerId{1});
        builder.addCircle({{50 * kUm, 0}, 200 * kUm, 0}, of(b));   // beneath
        builder.addCircle({{500 * kUm, 0}, 200 * kUm, 0}, of(c));  // 300 um beside, 182 below
        builder.addCircle({{100 * kUm, 0}, 200 * kUm, 0}, of({}));
        const auto found = measure(*builder.finish());
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(isNear(found[0].spacing.distance, 182'000) && found[0].planar == 0.0);
        QVERIFY(found[0].layerA == LayerId{std::size_t{0}} && found[0].layerB == LayerId{std::size_t{1}});
        QVERIFY(isNear(found[1].spacing.distance, 250'000) && found[1].height == 0.0);  // B and C, on one layer
        QVERIFY(isNear(found[2].spacing.distance, std::hypot(300'000, 182'000)));
        QVERIFY(isNear(found[2].planar, 300'000) && isNear(found[2].height, 182'000));
    }

    void everyPairIsTheSmallest() {
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const auto board = randomBoard(seed);
            const Smallest smallest = bruteForce(*board);
            const auto found = measure(*board, {1000, 1e9, {}});
            QCOMPARE(found.size(), smallest.size());
            for (const StackupClearance& c : found) {
                const auto nets =
                    std::minmax(board->elements.net[c.a.element.row()], board->elements.net[c.b.element.row()]);
                QVERIFY(isNear(c.spacing.distance, smallest.at({nets.first, nets.second})));
            }
            const auto few = measure(*board, {5, 1e9, {}});
            QCOMPARE(few.size(), std::size_t{5});
            QVERIFY(isNear(few.back().spacing.distance, found[4].spacing.distance));
            const auto two = measure(*board, {10, 1e9, {"N1", "N7"}});
            QCOMPARE(two.size(), std::size_t{1});
            const auto below = measure(*board, {1000, found[3].spacing.distance, {}});
            QVERIFY(below.size() <= 3);
        }
    }

    void acrossCopiesOfAPanel() {
        DocumentBuilder card;
        addLayers(card, kStack);
        const auto a = card.addNet("A");
        card.beginLayer(LayerId{0});
        card.addCircle({{0, 0}, 200 * kUm, 0}, of(a));
        const auto step = card.finish();
        DocumentBuilder panel;
        addLayers(panel, kStack);
        const std::uint32_t row = panel.addStep(step);
        panel.addInstance({row, {{0, 0}}, false});
        panel.addInstance({row, {{500 * kUm, 0}}, false});
        model::StepInstance flipped{row, {{300 * kUm, 0}}, true};
        flipped.placement.isMirrored = true;
        panel.addInstance(flipped);
        const auto found = measure(*panel.finish(), {10, 1e9, {}});
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(isNear(found[0].spacing.distance, 300'000));
        QVERIFY(found[0].a.copy != found[0].b.copy && found[0].layerA == found[0].layerB);
        QVERIFY(isNear(found[1].height, 965'000));  // the flipped one lies on the other face
        QVERIFY(found[1].layerA != found[1].layerB);
    }

    /// Copper on the top of 1 mm of substrate: that of a flipped copy is on the bottom.
    void acrossCopiesOfOneCopperLayer() {
        const auto addLayers = [](DocumentBuilder& builder) {
            model::Layer layer;
            layer.type = model::LayerType::Signal;
            layer.side = model::LayerSide::Top;
            layer.z = kMm;
            layer.thickness = 35 * kUm;
            builder.setBoardThickness(kMm);
            return builder.addLayer(layer);
        };
        DocumentBuilder card;
        card.beginLayer(addLayers(card));
        card.addCircle({{0, 0}, 200 * kUm, 0}, of(card.addNet("A")));
        DocumentBuilder panel;
        addLayers(panel);
        const std::uint32_t row = panel.addStep(card.finish());
        panel.addInstance({row, {{0, 0}}, false});
        panel.addInstance({row, {{500 * kUm, 0}}, false});
        panel.addInstance({row, {{100 * kUm, 0}, 0.0, true}, true});
        const auto found = measure(*panel.finish(), {10, 1e9, {}});
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(isNear(found[0].spacing.distance, 300'000) && found[0].height == 0.0);
        QVERIFY(isNear(found[1].spacing.distance, kMm - 35 * kUm) && found[1].planar == 0.0);
        QVERIFY(isNear(found[2].height, kMm - 35 * kUm) && isNear(found[2].planar, 200'000));
    }

    void withoutHeightsThereIsNothingToMeasure() {
        DocumentBuilder builder;
        builder.beginLayer(addLayer(builder, "top"));
        builder.addCircle({{0, 0}, 200 * kUm, 0}, of(builder.addNet("A")));
        base::Progress progress;
        QVERIFY(!model::smallestThroughStackup(*builder.finish(), {}, progress));
    }
};

QTEST_APPLESS_MAIN(StackupClearanceTest)
#include "stackup_clearance_test.moc"
