// How close different nets come: against every pair looked at, on one thread and on all.
#include "model/clearance/clearance.h"

#include <QtTest>
#include <map>
#include <random>

#include "model/base/parallel.h"
#include "model/board/document_builder.h"
#include "model/clearance/copper_owners.h"
#include "model/figures/distance.h"
#include "tests/unit/model/figures/element_spacing.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::Clearance;
using model::ClearanceRequest;
using model::DocumentBuilder;
using model::ElementId;
using model::LayerId;
using model::NetId;
using model::Nm;
using model::Point;

namespace {

/// Two layers of random tracks and pads of eight nets and of none.
std::shared_ptr<const model::Document> randomBoard() {
    DocumentBuilder builder;
    const LayerId layers[] = {addLayer(builder, "top"), addLayer(builder, "bottom")};
    std::vector<NetId> nets(1);  // none
    for (int i = 0; i < 8; ++i) {
        nets.push_back(builder.addNet("n" + std::to_string(i)));
    }
    std::mt19937 random(7);
    const auto at = [&] { return static_cast<Nm>(random() % 20'000'000); };
    for (const LayerId layer : layers) {
        builder.beginLayer(layer);
        for (int i = 0; i < 60; ++i) {
            const NetId net = nets[random() % nets.size()];
            const Point a{at(), at()};
            const auto step = [&] { return static_cast<Nm>(random() % 2'000'000) - 1'000'000; };
            if (i % 2 == 0) {
                builder.addCircle({a, 200 * kUm, 0}, of(net));
            } else {
                builder.addLine({a, {a.x + step(), a.y + step()}, 100 * kUm, 0}, of(net));
            }
        }
    }
    return builder.finish();
}

std::vector<Clearance> clearancesOf(const model::Document& document, const ClearanceRequest& question = {}) {
    base::Progress progress;
    return *model::smallestClearances(document, question, progress);
}

/// Spacing by layer and nets, every pair of elements looked at. Copper without a net has that of what it touches.
std::vector<double> bruteForce(const model::Document& document) {
    base::Progress progress;
    const model::CopperNets nets = *model::CopperNets::of(document, progress);
    std::map<std::tuple<LayerId, NetId, NetId>, double> narrowest;
    for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
        for (std::uint32_t j = i + 1; j < document.elements.size(); ++j) {
            const NetId netI = nets.netOf(ElementId{i}), netJ = nets.netOf(ElementId{j});
            if (netI == netJ || document.elements.layer[i] != document.elements.layer[j]) {
                continue;
            }
            const double gap = figure_testing::spacingBetween(document, ElementId{i}, ElementId{j})->distance;
            const auto [low, high] = std::minmax(netI, netJ);
            const auto [location, isFirst] = narrowest.try_emplace({document.elements.layer[i], low, high}, gap);
            location->second = std::min(location->second, gap);
        }
    }
    std::vector<double> gaps;
    std::ranges::transform(narrowest, std::back_inserter(gaps), [](const auto& entry) { return entry.second; });
    std::ranges::sort(gaps);
    return gaps;
}

}  // namespace

class ClearanceTest : public QObject {
    Q_OBJECT

private slots:
    void stepsWithCopperButNoNetsAreTold() {
        DocumentBuilder bare;
        const LayerId top = addLayer(bare, "top");
        bare.beginLayer(top);
        bare.addCircle({{0, 0}, 200 * kUm, 0}, of({}));
        const auto board = bare.finish();
        QVERIFY(model::isCopperWithoutNets(*board));
        QCOMPARE(model::unmeasuredSteps(*board).size(), std::size_t{1});
        QVERIFY(model::unmeasuredSteps(*board)[0].find("no nets") != std::string::npos);
        DocumentBuilder empty;
        addLayer(empty, "top");
        QVERIFY(model::unmeasuredSteps(*empty.finish()).empty());
        QVERIFY(model::unmeasuredSteps(*randomBoard()).empty());
    }

    void everyPairOfNetsIsFoundAtItsNarrowest() {
        const auto board = randomBoard();
        ClearanceRequest all;
        all.count = 1'000;
        const std::vector<Clearance> found = clearancesOf(*board, all);
        const std::vector<double> expected = bruteForce(*board);
        QCOMPARE(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            QCOMPARE(found[i].spacing.distance, expected[i]);
            QCOMPARE(std::hypot(found[i].spacing.to.x - found[i].spacing.from.x,
                                found[i].spacing.to.y - found[i].spacing.from.y) +
                         1.0,
                     found[i].spacing.distance + 1.0);
        }
    }

    void fewOfThemAreTheSameAsTheFirstOfAll() {
        const auto board = randomBoard();
        ClearanceRequest all;
        all.count = 1'000;
        const std::vector<Clearance> everything = clearancesOf(*board, all);
        ClearanceRequest few;
        few.count = 5;
        const base::ThreadLimit oneThread(1);
        const std::vector<Clearance> found = clearancesOf(*board, few);
        QCOMPARE(found.size(), std::size_t{5});
        for (std::size_t i = 0; i < found.size(); ++i) {
            QCOMPARE(found[i].a, everything[i].a);
            QCOMPARE(found[i].b, everything[i].b);
            QCOMPARE(found[i].layer, everything[i].layer);
        }
    }

    void questionsNarrowTheAnswer() {
        const auto board = randomBoard();
        ClearanceRequest question;
        question.count = 1'000;
        const std::vector<Clearance> everything = clearancesOf(*board, question);
        question.below = everything[3].spacing.distance + 0.001;
        QCOMPARE(clearancesOf(*board, question).size(), std::size_t{4});
        question.below = everything.back().spacing.distance + 1.0;
        question.layer = LayerId{std::size_t{1}};
        for (const Clearance& c : clearancesOf(*board, question)) {
            QCOMPARE(c.layer, question.layer);
        }
        question.layer = {};
        question.between = {NetId{std::size_t{4}}, NetId{std::size_t{2}}};
        const std::vector<Clearance> two = clearancesOf(*board, question);
        QCOMPARE(two.size(), std::size_t{2});  // one per layer
        QVERIFY(two[0].netA == NetId{std::size_t{2}} && two[0].netB == NetId{std::size_t{4}});
    }

    void aPlatedHoleIsCopperOfEveryLayerItJoins_data() {
        QTest::addColumn<bool>("isBackDrilled");
        QTest::newRow("as drilled") << false;
        QTest::newRow("back-drilled") << true;
    }
    void aPlatedHoleIsCopperOfEveryLayerItJoins() {
        QFETCH(bool, isBackDrilled);
        DocumentBuilder builder;
        const LayerId top = addLayer(builder, "top");
        const LayerId inner = addLayer(builder, "inner");
        const LayerId bottom = addLayer(builder, "bottom");
        model::Layer drill;
        drill.type = model::LayerType::Drill;
        drill.spanTop = top;
        drill.spanBottom = inner;
        const LayerId blind = builder.addLayer(drill);
        const NetId a = builder.addNet("a"), b = builder.addNet("b");
        for (const LayerId layer : {top, inner, bottom}) {
            builder.beginLayer(layer);
            if (layer != top) {
                builder.addCircle({{500 * kUm, 0}, 200 * kUm, 0}, of(b));
            }
        }
        builder.beginLayer(blind);
        const model::ElementId hole =
            builder.addCircle({{0, 0}, 300 * kUm, 300 * kUm}, of(a, model::kHole | model::kPlated));
        if (isBackDrilled) {
            builder.addPlatedSpan({hole, top, top});
        }
        const std::vector<Clearance> found = clearancesOf(*builder.finish());
        QCOMPARE(found.size(), isBackDrilled ? std::size_t{0} : std::size_t{1});
        if (!isBackDrilled) {
            QCOMPARE(found[0].layer, inner);
            QCOMPARE(found[0].spacing.distance, 250.0 * kUm);
        }
    }

    void copperOfNobodyThatTouchesANetIsPartOfIt() {
        DocumentBuilder builder;
        builder.beginLayer(addLayer(builder, "top"));
        const NetId a = builder.addNet("a");
        builder.addCircle({{0, 0}, 200 * kUm, 0}, of(a));
        builder.addCircle({{100 * kUm, 0}, 200 * kUm, 0}, of({}));
        const auto touching = builder.finish();
        QVERIFY(clearancesOf(*touching).empty());
    }

    void copperOfNobodyKeepsTheClearancesOfTheNetItTouches() {
        DocumentBuilder builder;
        builder.beginLayer(addLayer(builder, "top"));
        const NetId a = builder.addNet("a"), b = builder.addNet("b");
        builder.addCircle({{0, 0}, 200 * kUm, 0}, of(a));
        builder.addLine({{0, 0}, {300 * kUm, 0}, 100 * kUm, 0}, of({}));  // of a
        builder.addCircle({{0, 400 * kUm}, 200 * kUm, 0}, of(a));         // closer to it than b is
        builder.addCircle({{600 * kUm, 0}, 200 * kUm, 0}, of(b));
        builder.addCircle({{600 * kUm, 1000 * kUm}, 200 * kUm, 0}, of({}));  // of nobody
        const std::vector<Clearance> found = clearancesOf(*builder.finish());
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(found[0].netA == a && found[0].netB == b);
        QCOMPARE(found[0].a, ElementId{1});
        QCOMPARE(found[0].spacing.distance, 150.0 * kUm);
        QVERIFY(!found[1].netB.isValid() && !found[2].netB.isValid());
    }

    void aCancelIsSaid() {
        base::Progress progress;
        progress.cancel();
        QVERIFY(!model::smallestClearances(*randomBoard(), {}, progress));
    }
};

QTEST_GUILESS_MAIN(ClearanceTest)

#include "clearance_test.moc"
