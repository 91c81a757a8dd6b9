#include "model/solids/shells/arc_shell.h"

#include <QtTest>
#include <algorithm>

#include "model/geometry/boolean.h"
#include "model/geometry/loops/edge_faults.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"

using namespace edge_loop_checks;
using model::ArcGeometry;
using model::EdgeKind;
using model::EdgeLoops;
using model::Nm;
using model::Point;

namespace {

Point at(double radius, double degrees) {
    return {model::toNm(radius * std::cos(degrees * kPi / 180)), model::toNm(radius * std::sin(degrees * kPi / 180))};
}

/// Around the origin, from 0°.
ArcGeometry arc(double radius, double degrees, Nm width, Nm innerWidth = 0) {
    return {{at(radius, 0), {0, 0}, degrees < 0 ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise},
            at(radius, degrees),
            width,
            innerWidth};
}

/// The union of the pen in many places.
double sweptArea(double radius, double degrees, Nm width) {
    model::PolygonSet pens;
    const int count = static_cast<int>(std::ceil(std::abs(degrees) * kPi / 180 * radius / (width * 0.02)));
    for (int i = 0; i <= count; ++i) {
        EdgeLoops pen;
        const double angle = degrees * i / count * kPi / 180;
        pen.addCircle({radius * std::cos(angle), radius * std::sin(angle)}, width / 2.0);
        pens.append(polygonsOf(pen, width * 1e-4));
    }
    return edge_loop_checks::areaOf(model::unite(pens));
}

bool isSound(const EdgeLoops& loops) {
    return areSound(loops) && !model::findFault(loops);
}

}  // namespace

class ArcShellTest : public QObject {
    Q_OBJECT

private slots:
    void tracks_data() {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {1.0, 30.0, 90.0, -90.0, 180.0, -180.0, 270.0, -300.0}) {
            QTest::addRow("%g", degrees) << degrees;
        }
    }
    void tracks() {
        QFETCH(double, degrees);
        const auto outline = model::arcOutline(arc(1e6, degrees, 200'000));
        QVERIFY(outline && isSound(*outline));
        QCOMPARE(outline->edges.size(), 4U);
        const double exact = 1e6 * std::abs(degrees) * kPi / 180 * 2e5 + kPi * 1e10;
        QVERIFY(relative(model::areaOf(*outline), exact) < 1e-5);  // ends are on the grid
        QCOMPARE(model::arcOutlines(arc(1e6, degrees, 200'000))->size(), 1U);
    }

    /// The pen covers the centre: no inner arc.
    void widePens_data() {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {20.0, 90.0, 179.0, 180.0, 200.0, -250.0, 350.0}) {
            QTest::addRow("%g", degrees) << degrees;
        }
    }
    void widePens() {
        QFETCH(double, degrees);
        const auto regions = model::arcOutlines(arc(100'000, degrees, 300'000));
        QVERIFY(regions && regions->size() == 1 && isSound(regions->front()));
        QVERIFY(relative(model::areaOf(regions->front()), sweptArea(1e5, degrees, 300'000)) < 2e-3);
        QCOMPARE(model::arcOutline(arc(100'000, degrees, 300'000)).has_value(), std::abs(degrees) <= 180);
    }

    void endsThatMeet() {
        QVERIFY(!model::arcOutline(arc(1e6, 350, 200'000)));
        const auto regions = model::arcOutlines(arc(1e6, 350, 200'000));
        QVERIFY(regions && regions->size() == 1 && isSound(regions->front()));
        QCOMPARE(regions->front().loopCount(), 2U);
        const double outside = model::areaOf(regions->front());
        QVERIFY(outside < 2 * kPi * 1e6 * 2e5 && outside > 0.995 * 2 * kPi * 1e6 * 2e5);
        QVERIFY(relative(outside, sweptArea(1e6, 350, 200'000)) < 1e-3);
    }

    void fullCircles() {
        ArcGeometry ring = arc(1e6, 360, 200'000);
        ring.end = ring.node.point;
        const auto outline = model::arcOutline(ring);
        QVERIFY(outline && isSound(*outline));
        QCOMPARE(outline->edges.size(), 2U);
        QVERIFY(relative(model::areaOf(*outline), 2 * kPi * 1e6 * 2e5) < 1e-12);
        ring.width = 2'000'000;
        QCOMPARE(model::arcOutline(ring)->loopCount(), 1U);
        QVERIFY(relative(model::areaOf(*model::arcOutline(ring)), kPi * 4e12) < 1e-12);
        ring.width = 200'000;
        ring.innerWidth = 100'000;
        QVERIFY(!model::arcOutline(ring));
        const auto barrel = model::arcOutlines(ring);
        QVERIFY(barrel && barrel->size() == 2 && std::ranges::all_of(*barrel, isSound));
        QVERIFY(relative(model::areaOf((*barrel)[0]) + model::areaOf((*barrel)[1]), 2 * kPi * 1e6 * 1e5) < 1e-9);
    }

    void platedSlots() {
        const auto slot = model::arcOutline(arc(1e6, 90, 200'000, 100'000));
        QVERIFY(slot && isSound(*slot));
        QCOMPARE(slot->loopCount(), 2U);
        QVERIFY(relative(model::areaOf(*slot), kPi / 2 * 1e6 * 1e5 + kPi * 75e8) < 1e-5);
        const auto overlapping = model::arcOutlines(arc(1e6, 355, 200'000, 100'000));
        QVERIFY(overlapping && std::ranges::all_of(*overlapping, isSound));
        QCOMPARE(overlapping->size(), 2U);
    }

    /// The job's radii differ by rounding, or by far.
    void endsWithRadiiThatDiffer() {
        for (const Point end : {Point{3, 1'000'004}, Point{0, 999'000}, Point{-1'020'000, 10}}) {
            const auto outline =
                model::arcOutline({{{1'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, end, 200'000, 0});
            QVERIFY(outline && isSound(*outline));
            QVERIFY(relative(model::areaOf(*outline), 1e6 * std::atan2(end.y, end.x) * 2e5 + kPi * 1e10) < 0.02);
        }
    }

    void nothingIsLeft() {
        QCOMPARE(model::arcOutline(arc(1e6, 90, 0))->loopCount(), 0U);
        QCOMPARE(model::arcOutline(arc(1e6, 90, 100, 100))->loopCount(), 0U);
        QVERIFY(model::arcOutlines(arc(1e6, 90, 0))->empty());
    }
};

QTEST_APPLESS_MAIN(ArcShellTest)
#include "arc_shell_test.moc"
