#include "model/solids/shells/drilled_copper.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/geometry/loops/edge_faults.h"
#include "tests/unit/model/geometry/loop_shapes.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::EdgeLoops;
using model::HoleRegions;
using model::LayerId;
using model::RegionBoolean;
using model::RegionSearch;

namespace {

constexpr double kPi = std::numbers::pi;

void addRound(model::DocumentBuilder& builder, double x, double y, double diameter) {
    const auto nm = [](double mm) { return static_cast<model::Nm>(std::lround(mm * kMm)); };
    builder.addCircle({{nm(x), nm(y)}, nm(diameter), nm(diameter * 0.8)}, flagged(model::kHole | model::kPlated));
}

/// Holes through one layer of copper.
template <class AddHoles>
std::shared_ptr<const model::Document> drilledBoard(const AddHoles& addHoles) {
    model::DocumentBuilder builder;
    const LayerId copper = addLayer(builder, "top");
    builder.beginLayer(addDrill(builder, copper, copper));
    addHoles(builder);
    return builder.finish();
}

template <class AddHoles>
RegionBoolean cut(const EdgeLoops& copper, const AddHoles& addHoles) {
    const auto document = drilledBoard(addHoles);
    const HoleRegions holes(*document, model::holesThrough(*document, LayerId{std::size_t{0}}));
    return model::drilled(copper, holes.near(boxOf(copper)));
}

/// mm²
double areaOf(const RegionBoolean& result) {
    double area = 0.0;
    for (const EdgeLoops& region : result.regions) {
        area += model::areaOf(region) / 1e12;
    }
    return area;
}

bool isSound(const RegionBoolean& result, double expected) {
    const bool hasFault = std::ranges::any_of(
        result.regions, [](const EdgeLoops& region) { return model::findFault(region).has_value(); });
    if (std::abs(areaOf(result) - expected) > 1e-6) {
        qWarning("%.9g is not %.9g", areaOf(result), expected);
        return false;
    }
    return result.isExact && !hasFault;
}

}  // namespace

class DrilledCopperTest : public QObject {
    Q_OBJECT

private slots:
    void aHoleWithinIsOneMoreLoop() {
        const RegionBoolean result = cut(loop_shapes::rectangle(0, 0, 10, 10), [](auto& builder) {
            addRound(builder, 3, 3, 1);
            addRound(builder, 7, 7, 2);
            addRound(builder, 20, 3, 1);
        });
        QVERIFY(isSound(result, 100 - kPi / 4 - kPi));
        QCOMPARE(result.regions.size(), std::size_t{1});
        QCOMPARE(result.regions.front().loopCount(), std::size_t{3});
        QVERIFY(result.regions.front().loop(1).front().isFullCircle());
    }

    void aHoleAcrossTheEdgeIsCutOutOfIt() {
        const RegionBoolean result = cut(loop_shapes::rectangle(0, 0, 10, 10), [](auto& builder) {
            addRound(builder, 0, 5, 2);
            addRound(builder, 5, 5, 1);
        });
        QVERIFY(isSound(result, 100 - kPi / 2 - kPi / 4));
        QCOMPARE(result.regions.front().loopCount(), std::size_t{2});
    }

    /// Two parts are left; what lies within one of them stays in it.
    void aHoleMayCutCopperInTwo() {
        EdgeLoops copper = loop_shapes::rectangle(0, 0, 20, 4);
        copper.addCircle({18.0 * kMm, 2.0 * kMm}, 1.0 * kMm);
        const RegionBoolean result = cut(copper, [](auto& builder) {
            addRound(builder, 10, 2, 6);
            addRound(builder, 2, 2, 1);
        });
        const double half = std::asin(2.0 / 3.0);
        const double taken = 2 * (2 * 3 * std::cos(half) + 9 * half);
        QVERIFY(isSound(result, 80 - kPi - taken - kPi / 4));
        QCOMPARE(result.regions.size(), std::size_t{2});
        QCOMPARE(result.regions[0].loopCount(), std::size_t{2});
        QCOMPARE(result.regions[1].loopCount(), std::size_t{2});
    }

    void aHoleMayTakeAllOfAPad() {
        EdgeLoops pad;
        pad.addCircle({0.0, 0.0}, 0.5 * kMm);
        QVERIFY(cut(pad, [](auto& builder) { addRound(builder, 0, 0, 1); }).regions.empty());
        QVERIFY(cut(pad, [](auto& builder) { addRound(builder, 0, 0, 2); }).regions.empty());
    }

    /// A ring that is narrower inside than its hole.
    void aHoleTakesTheHoleOfARing() {
        EdgeLoops ring;
        ring.addCircle({0.0, 0.0}, 2.0 * kMm);
        ring.addCircle({0.0, 0.0}, 0.3 * kMm);
        const RegionBoolean result = cut(ring, [](auto& builder) { addRound(builder, 0, 0, 1); });
        QVERIFY(isSound(result, 4 * kPi - kPi / 4));
        QCOMPARE(result.regions.front().loopCount(), std::size_t{2});
    }

    void slotsAndRoutsAreCutOut() {
        const RegionBoolean result = cut(loop_shapes::rectangle(0, 0, 20, 10), [](auto& builder) {
            builder.addLine({{4 * kMm, 5 * kMm}, {8 * kMm, 5 * kMm}, kMm, 800 * kUm},
                            flagged(model::kHole | model::kPlated));
            const model::ShapeId square = builder.addShape(rectangle({14 * kMm, 4 * kMm}, {16 * kMm, 6 * kMm}));
            builder.addArea({square, {}}, flagged(model::kHole));
        });
        QVERIFY(isSound(result, 200 - 4 - kPi / 4 - 4));
        QCOMPARE(result.regions.front().loopCount(), std::size_t{3});
    }

    void holesThatOverlapAreOne() {
        const RegionBoolean result = cut(loop_shapes::rectangle(0, 0, 20, 10), [](auto& builder) {
            addRound(builder, 3, 3, 1);  // a counterbore
            addRound(builder, 3, 3, 2);
            addRound(builder, 3, 3, 2);
            addRound(builder, 10, 5, 2);  // a slot of two holes
            addRound(builder, 11, 5, 2);
        });
        const double lens = 2 * std::acos(0.5) - 0.5 * std::sqrt(3.0);
        QVERIFY(isSound(result, 200 - kPi - (2 * kPi - lens)));
        QCOMPARE(result.regions.front().loopCount(), std::size_t{3});
        QVERIFY(result.regions.front().loop(1).front().isFullCircle());
    }

    /// Routed around, an island stays.
    void ringsLeaveWhatIsWithin() {
        const RegionBoolean result = cut(loop_shapes::rectangle(0, 0, 20, 10), [](auto& builder) {
            model::ShapeSketch ring;
            ring.addCircle({10 * kMm, 5 * kMm}, 3 * kMm, false);
            ring.addCircle({10 * kMm, 5 * kMm}, 2 * kMm, true);
            builder.addArea({builder.addShape(ring), {}}, flagged(model::kHole));
            addRound(builder, 10, 5, 1);
        });
        QVERIFY(isSound(result, 200 - 9 * kPi + 4 * kPi - kPi / 4));
        QCOMPARE(result.regions.size(), std::size_t{2});
    }

    /// A tool of unknown size is drawn as a point.
    void pointsTakeNothing() {
        const RegionBoolean result =
            cut(loop_shapes::rectangle(0, 0, 10, 10), [](auto& builder) { addRound(builder, 5, 5, 1e-5); });
        QCOMPARE(result.regions.front().loopCount(), std::size_t{1});
    }

    void onlyHolesOfTheSpanPass() {
        model::DocumentBuilder builder;
        const LayerId top = addLayer(builder, "top");
        const LayerId inner = addLayer(builder, "inner");
        const LayerId bottom = addLayer(builder, "bottom");
        builder.beginLayer(addDrill(builder, top, bottom));
        addRound(builder, 0, 0, 1);
        builder.beginLayer(addDrill(builder, top, inner));
        addRound(builder, 5, 0, 1);
        addRound(builder, 9, 0, 0.1);  // by laser, onto the inner layer
        builder.beginLayer(addDrill(builder, inner, bottom));
        addRound(builder, 9, 0, 0.1);  // onto it from below
        const auto document = builder.finish();
        QCOMPARE(model::holesThrough(*document, top).size(), std::size_t{3});
        QCOMPARE(model::holesThrough(*document, inner).size(), std::size_t{2});
        QCOMPARE(model::holesThrough(*document, bottom).size(), std::size_t{2});
    }
};

QTEST_APPLESS_MAIN(DrilledCopperTest)
#include "drilled_copper_test.moc"
