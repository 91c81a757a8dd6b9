#include "model/solids/shells/drawn_outlines.h"

#include <QtTest>
#include <numbers>

#include "tests/unit/model/hand_made.h"

using hand_made::kMm;
using model::EdgeKind;
using model::ElementId;
using model::ElementOutlines;

namespace {

constexpr double kMm2 = 1e12;
constexpr double kPi = std::numbers::pi;

/// The regions of what `add` adds first.
template <class Add>
ElementOutlines drawn(const Add& add) {
    model::DocumentBuilder builder;
    builder.beginLayer(hand_made::addLayer(builder, "layer"));
    add(builder);
    return model::drawnOutlinesOf(*builder.finish(), ElementId{0});
}

double area(const ElementOutlines& outlines) {
    double sum = 0.0;
    for (const model::EdgeLoops& region : outlines.regions) {
        sum += model::areaOf(region);
    }
    return sum / kMm2;
}

bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

}  // namespace

class DrawnOutlinesTest : public QObject {
    Q_OBJECT

private slots:
    /// Plating makes holes narrower only once they are drilled.
    void holesAreWhatIsDrilled() {
        const auto plated = hand_made::flagged(model::kHole | model::kPlated);
        QVERIFY(isNear(area(drawn([&](auto& b) { b.addCircle({{}, 2 * kMm, kMm}, plated); })), kPi));
        const auto open = hand_made::flagged(model::kHole);
        QVERIFY(isNear(area(drawn([&](auto& b) { b.addCircle({{}, 2 * kMm, 2 * kMm}, open); })), kPi));
        const double slot = 10.0 + kPi / 4;
        QVERIFY(isNear(area(drawn([&](auto& b) { b.addLine({{}, {10 * kMm, 0}, kMm, kMm / 2}, plated); })), slot));
        const model::PathNode nodes[] = {{{}, {}, EdgeKind::Line}, {{10 * kMm, 0}, {}, EdgeKind::Line}};
        QVERIFY(isNear(area(drawn([&](auto& b) { b.addTrail(nodes, kMm, plated, kMm / 2); })), slot));
    }

    void ringsThatAreNoHolesKeepTheirHole() {
        QVERIFY(isNear(area(drawn([](auto& b) { b.addCircle({{}, 4 * kMm, 2 * kMm}, {}); })), 3 * kPi));
    }

    /// Its ends meet, and its tracks join: all the same it is one region.
    void aTrackThatOverlapsItselfIsOneRegion() {
        const model::PathNode start{{5 * kMm, 0}, {}, EdgeKind::ArcCounterClockwise};
        const model::PathNode end{{4'975'000, -499'375}, {}, EdgeKind::Line};
        const ElementOutlines arc = drawn([&](auto& b) { b.addArc({start, end.point, kMm}, {}); });
        QCOMPARE(arc.regions.size(), std::size_t{1});
        QVERIFY(arc.problem.empty());
        const double ring = kPi * (5.5 * 5.5 - 4.5 * 4.5);
        QVERIFY(area(arc) < ring && area(arc) > ring - 0.1);
        const model::PathNode nodes[] = {start, end, {{0, 0}, {}, EdgeKind::Line}};
        const ElementOutlines trail = drawn([&](auto& b) { b.addTrail(nodes, kMm, {}); });
        QCOMPARE(trail.regions.size(), std::size_t{1});
        QVERIFY(area(trail) > area(arc) + 4.0);
    }

    void whatHasNoWidthIsSaid() {
        const ElementOutlines line = drawn([](auto& b) { b.addLine({{}, {kMm, 0}, 0}, {}); });
        QVERIFY(line.regions.empty());
        QCOMPARE(line.problem, std::string_view("it has no width"));
        QVERIFY(!drawn([](auto& b) { b.addCircle({{}, 0, 0}, {}); }).problem.empty());
    }
};

QTEST_GUILESS_MAIN(DrawnOutlinesTest)
#include "drawn_outlines_test.moc"
