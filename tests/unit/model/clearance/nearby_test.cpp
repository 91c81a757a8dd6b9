// What lies near something, against every pair looked at.
#include "model/clearance/nearby.h"

#include <QtTest>
#include <random>

#include "model/base/parallel.h"
#include "model/board/document_builder.h"
#include "model/clearance/copper_owners.h"
#include "model/figures/distance.h"
#include "tests/unit/model/figures/element_spacing.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::DocumentBuilder;
using model::ElementId;
using model::LayerId;
using model::Nearby;
using model::NetId;
using model::Nm;
using model::Point;

namespace {

std::shared_ptr<const model::Document> randomBoard(std::uint32_t seed) {
    DocumentBuilder builder;
    std::vector<NetId> nets(1);  // none
    for (int i = 0; i < 6; ++i) {
        nets.push_back(builder.addNet("n" + std::to_string(i)));
    }
    std::mt19937 random(seed);
    const auto at = [&] { return static_cast<Nm>(random() % 8'000'000); };
    for (const char* name : {"top", "bottom"}) {
        builder.beginLayer(addLayer(builder, name));
        for (int i = 0; i < 80; ++i) {
            const NetId net = nets[random() % nets.size()];
            const Point a{at(), at()};
            i % 2 == 0 ? builder.addCircle({a, 200 * kUm, 0}, of(net))
                       : builder.addLine({a, {at(), at()}, 60 * kUm, 0}, of(net));
        }
    }
    return builder.finish();
}

std::vector<Nearby> near(const model::Document& board, const std::vector<ElementId>& targets, double reach) {
    base::Progress progress;
    return *model::copperNear(board, targets, reach, progress);
}

/// By element, copper without a net with that of what it touches; infinite where nothing of the targets is on its layer
/// or it is left out.
std::vector<double> bruteForce(const model::Document& board, const std::vector<ElementId>& targets) {
    std::vector<double> nearest(board.elements.size(), std::numeric_limits<double>::infinity());
    base::Progress progress;
    const model::CopperNets nets = *model::CopperNets::of(board, progress);
    for (std::uint32_t i = 0; i < board.elements.size(); ++i) {
        const NetId net = nets.netOf(ElementId{i});
        const bool isLeftOut = std::ranges::any_of(targets, [&](ElementId target) {
            return target == ElementId{i} || (net.isValid() && nets.netOf(target) == net);
        });
        for (const ElementId target : targets) {
            if (!isLeftOut && board.elements.layer[target.row()] == board.elements.layer[i]) {
                nearest[i] =
                    std::min(nearest[i], figure_testing::spacingBetween(board, ElementId{i}, target)->distance);
            }
        }
    }
    return nearest;
}

}  // namespace

class NearbyTest : public QObject {
    Q_OBJECT

private slots:
    void everythingNearIsFoundOnceNearestFirst() {
        for (std::uint32_t seed = 0; seed < 5; ++seed) {
            const auto board = randomBoard(seed);
            const std::span<const ElementId> net = board->elementsOf(NetId{std::size_t{seed}});
            const std::vector<ElementId> targets(net.begin(), net.end());
            const std::vector<double> expected = bruteForce(*board, targets);
            for (const double reach : {0.0, 100.0 * kUm, 1'000.0 * kUm}) {
                const std::vector<Nearby> found = near(*board, targets, reach);
                QVERIFY(std::ranges::is_sorted(found, {}, [](const Nearby& n) { return n.spacing.distance; }));
                std::vector<bool> isFound(board->elements.size());
                for (const Nearby& n : found) {
                    QVERIFY(!isFound[n.element.row()]);
                    isFound[n.element.row()] = true;
                    QCOMPARE(n.spacing.distance + 1.0, expected[n.element.row()] + 1.0);
                }
                for (std::size_t i = 0; i < expected.size(); ++i) {
                    QCOMPARE(isFound[i], expected[i] <= reach);
                }
            }
        }
    }

    void oneThreadFindsTheSame() {
        const auto board = randomBoard(9);
        const std::vector<Nearby> all = near(*board, {ElementId{3}, ElementId{90}}, 2'000.0 * kUm);
        const base::ThreadLimit oneThread(1);
        const std::vector<Nearby> alone = near(*board, {ElementId{3}, ElementId{90}}, 2'000.0 * kUm);
        QCOMPARE(alone.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            QCOMPARE(alone[i].element, all[i].element);
        }
    }

    void nothingIsNearNothing() { QVERIFY(near(*randomBoard(1), {}, 1e9).empty()); }

    void aCancelIsSaid() {
        base::Progress progress;
        progress.cancel();
        QVERIFY(!model::copperNear(*randomBoard(1), std::vector{ElementId{1}}, 1e6, progress));
    }
};

QTEST_GUILESS_MAIN(NearbyTest)
#include "nearby_test.moc"
