#include "model/solids/far_holes.h"

#include <QtTest>
#include <random>

#include "model/geometry/boolean.h"

using model::Box;
using model::FarHoles;
using model::Point;
using model::PolygonSet;

namespace {

std::vector<Point> rectangle(const Box& box) {
    return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

PolygonSet regionOf(const Box& box) {
    PolygonSet set;
    set.beginPolygon();
    set.addLoop(rectangle(box));
    return set;
}

/// A plane of 100 by 100 with a hole of some size in each of 20 by 20 fields.
PolygonSet perforated(std::mt19937& random) {
    constexpr int kField = 5000;
    PolygonSet set = regionOf({{0, 0}, {20 * kField, 20 * kField}});
    for (int row = 0; row < 20; ++row) {
        for (int column = 0; column < 20; ++column) {
            const int half = 200 + static_cast<int>(random() % 2000);
            const Point middle{column * kField + kField / 2, row * kField + kField / 2};
            set.addLoop(std::vector<Point>{{middle.x - half, middle.y},
                                           {middle.x, middle.y - half},
                                           {middle.x + half, middle.y},
                                           {middle.x, middle.y + half}});
        }
    }
    return set;
}

}  // namespace

class FarHolesTest : public QObject {
    Q_OBJECT

private slots:
    /// A slanted bar cuts the plane into pieces: the result covers what it does without the detour.
    void theRestIsTheSame() {
        std::mt19937 random(7);
        for (int run = 0; run < 20; ++run) {
            const PolygonSet plane = perforated(random);
            const int from = static_cast<int>(random() % 100'000);
            const int to = static_cast<int>(random() % 100'000);
            PolygonSet bar;
            bar.beginPolygon();
            bar.addLoop(std::vector<Point>{{from, -1000}, {from + 900, -1000}, {to + 900, 101'000}, {to, 101'000}});
            Box cut;
            for (const Point point : bar.points) {
                cut.include(point);
            }
            const PolygonSet direct = model::subtract(plane, bar);

            PolygonSet near = plane;
            const FarHoles far(near, [&](const Box& hole) { return !hole.grownBy(5).meets(cut); });
            QVERIFY(near.loopCount() <= plane.loopCount());
            const PolygonSet rest = far.putBack(model::subtract(near, bar));
            QCOMPARE(rest.polygons.size(), direct.polygons.size());
            QCOMPARE(rest.loopCount(), direct.loopCount());
            QVERIFY(model::twiceArea(rest) == model::twiceArea(direct));
            QVERIFY(model::subtract(rest, direct).polygons.empty());
        }
    }

    void eachGoesToItsPiece() {
        PolygonSet plane = regionOf({{0, 0}, {300, 100}});
        plane.addLoop(rectangle({{20, 20}, {30, 30}}));
        plane.addLoop(rectangle({{145, 40}, {155, 50}}));
        plane.addLoop(rectangle({{220, 20}, {230, 30}}));
        const FarHoles far(plane, [](const Box& hole) { return hole.max.x < 140 || hole.min.x > 160; });
        QCOMPARE(plane.loopCount(), 2U);
        const PolygonSet rest = far.putBack(model::subtract(plane, regionOf({{140, -10}, {160, 110}})));
        QCOMPARE(rest.polygons.size(), 2U);
        QCOMPARE(rest.polygons[0].loopCount, 2U);
        QCOMPARE(rest.polygons[1].loopCount, 2U);
    }

    /// A hole that no piece surrounds is open all the same.
    void aHoleAcrossAnEdgeStaysOpen() {
        PolygonSet plane = regionOf({{0, 0}, {100, 100}});
        plane.addLoop(rectangle({{10, 10}, {20, 20}}));
        const FarHoles far(plane, [](const Box&) { return true; });
        const PolygonSet rest = far.putBack(regionOf({{15, 0}, {100, 100}}));
        QVERIFY(model::twiceArea(rest) == 2 * (85 * 100 - 5 * 10));
    }

    void nothingIsLeftOfNothing() {
        PolygonSet plane = regionOf({{0, 0}, {100, 100}});
        plane.addLoop(rectangle({{10, 10}, {20, 20}}));
        const FarHoles far(plane, [](const Box&) { return true; });
        QVERIFY(far.putBack({}).polygons.empty());
    }
};

QTEST_APPLESS_MAIN(FarHolesTest)
#include "far_holes_test.moc"
