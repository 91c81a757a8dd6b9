#include "model/geometry/loops/region_booleans.h"

#include <QtTest>
#include <numbers>

#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/region.h"
#include "tests/unit/model/geometry/loop_shapes.h"

using loop_shapes::disc;
using loop_shapes::rectangle;
using model::EdgeLoops;
using model::PolygonSet;
using model::RegionBoolean;
using model::ShapeSketch;

namespace {

constexpr double kMm = 1e6;

double areaOf(std::span<const EdgeLoops> regions) {
    double area = 0.0;
    for (const EdgeLoops& region : regions) {
        area += model::areaOf(region) / kMm / kMm;
    }
    return area;
}

}  // namespace

class RegionBooleansTest : public QObject {
    Q_OBJECT

private slots:
    void arcsStayArcs() {
        const EdgeLoops whole = rectangle(0, 0, 10, 10);
        const EdgeLoops holes[] = {disc(3, 3, 1), disc(10, 5, 2)};
        const RegionBoolean left = model::differenceOf({&whole, 1}, holes);
        QVERIFY(left.isExact);
        QCOMPARE(left.regions.size(), std::size_t{1});
        QVERIFY(std::abs(areaOf(left.regions) - (100 - std::numbers::pi - 2 * std::numbers::pi)) < 1e-6);
        const ShapeSketch sketch = model::sketchOf(left.regions);
        QCOMPARE(sketch.contourCount(), std::size_t{2});
        QVERIFY(sketch.isHole(1) && !sketch.isHole(0));
        QCOMPARE(sketch.contour(1).size(), std::size_t{1});
        QCOMPARE(sketch.contour(1)[0].centre, (model::Point{3'000'000, 3'000'000}));
        QCOMPARE(std::abs(sketch.contour(1)[0].point.x - 3'000'000), 1'000'000);
    }

    void whatOverlapsIsOne() {
        const EdgeLoops discs[] = {disc(0, 0, 1), disc(1, 0, 1), disc(5, 0, 1)};
        const RegionBoolean united = model::unionOf(discs);
        QVERIFY(united.isExact);
        QCOMPARE(united.regions.size(), std::size_t{2});
        const double lens = 2 * std::numbers::pi / 3 - std::sqrt(3.0) / 2;
        QVERIFY(std::abs(areaOf(united.regions) - (3 * std::numbers::pi - lens)) < 1e-6);
    }

    void polygonsAreWithinAMicrometre() {
        const EdgeLoops ring[] = {disc(0, 0, 5)};
        const PolygonSet polygons = model::polygonsOf(ring);
        QCOMPARE(polygons.polygons.size(), std::size_t{1});
        const std::span<const model::Point> loop = polygons.loop(0);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const model::Point a = loop[i];
            const model::Point b = loop[(i + 1) % loop.size()];
            QVERIFY(std::abs(std::hypot(a.x, a.y) - 5e6) < 1.0);
            QVERIFY(std::hypot((double(a.x) + b.x) / 2, (double(a.y) + b.y) / 2) > 5e6 - 1001.0);
        }
        const std::vector<EdgeLoops> back = model::regionsOf(polygons);
        QCOMPARE(back.size(), std::size_t{1});
        QCOMPARE(back[0].edges.size(), loop.size());
    }

    void polygonsAreRegions() {
        PolygonSet set;
        set.beginPolygon();
        set.addLoop(std::vector<model::Point>{{0, 0}, {90, 0}, {90, 90}, {0, 90}});
        set.addLoop(std::vector<model::Point>{{10, 10}, {20, 10}, {20, 20}, {10, 20}});
        set.beginPolygon();
        set.addLoop(std::vector<model::Point>{{200, 0}, {290, 0}, {290, 90}});
        const std::vector<EdgeLoops> regions = model::regionsOf(set);
        QCOMPARE(regions.size(), std::size_t{2});
        QVERIFY(!model::findFault(regions[0]) && !model::findFault(regions[1]));
        QCOMPARE(model::areaOf(regions[0]), 8000.0);
        QCOMPARE(model::areaOf(regions[1]), 4050.0);
    }

    void nothingIsNothing() {
        QVERIFY(model::unionOf({}).regions.empty());
        QVERIFY(model::sketchOf(std::span<const EdgeLoops>()).isEmpty());
        QVERIFY(model::polygonsOf(std::span<const EdgeLoops>()).polygons.empty());
        QVERIFY(model::regionsOf(PolygonSet()).empty());
        const EdgeLoops whole = rectangle(0, 0, 1, 1);
        const RegionBoolean same = model::differenceOf({&whole, 1}, {});
        QCOMPARE(areaOf(same.regions), 1.0);
        const EdgeLoops larger = rectangle(-1, -1, 2, 2);
        QVERIFY(model::differenceOf({&whole, 1}, {&larger, 1}).regions.empty());
    }
};

QTEST_APPLESS_MAIN(RegionBooleansTest)
#include "region_booleans_test.moc"
