#include "model/geometry/boolean.h"

#include <QtTest>
#include <cstdlib>
#include <random>

using model::Point;
using model::PolygonSet;

namespace {

PolygonSet square(int x, int y, int size) {
    PolygonSet set;
    set.beginPolygon();
    const Point corners[] = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    set.addLoop(corners);
    return set;
}

PolygonSet bar(int x, int y, int width, int height) {
    PolygonSet set;
    set.beginPolygon();
    const Point corners[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    set.addLoop(corners);
    return set;
}

long long area(const PolygonSet& set) {
    return static_cast<long long>(model::twiceArea(set) / 2);
}

}  // namespace

class BooleanTest : public QObject {
    Q_OBJECT

private slots:
    void overlapCountsOnce() {
        PolygonSet both = square(0, 0, 10);
        both.append(square(5, 5, 10));
        QCOMPARE(area(both), 200);
        const PolygonSet united = model::unite(both);
        QCOMPARE(area(united), 175);
        QCOMPARE(united.polygons.size(), 1U);
    }

    /// Unsorted, they wind as what they surround says.
    void loopsAreUnitedWithoutTheirOrder() {
        model::LoopSet loops;
        for (const Point p : {Point{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 5}, {15, 5}, {15, 15}, {5, 15}}) {
            loops.points.push_back(p);
        }
        for (const Point p : {Point{1, 1}, {1, 2}, {2, 2}, {2, 1}}) {  // a hole, clockwise
            loops.points.push_back(p);
        }
        loops.loopStart = {0, 4, 8, 12};
        const model::LoopSet united = model::unitedLoops(loops);
        QCOMPARE(united.loopStart.size(), std::size_t{3});
        __int128 twice = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::uint32_t first = united.loopStart[i];
            twice += model::twiceArea(std::span(united.points).subspan(first, united.loopStart[i + 1] - first));
        }
        QCOMPARE(static_cast<long long>(twice / 2), 174);
    }

    void differenceKeepsHolesWithTheirOutline() {
        PolygonSet holes = square(10, 10, 5);
        holes.append(square(30, 30, 5));
        holes.append(square(95, 95, 20));  // bites a corner off
        const PolygonSet result = model::subtract(square(0, 0, 100), holes);
        QCOMPARE(result.polygons.size(), 1U);
        QCOMPARE(result.polygons[0].loopCount, 3U);
        QCOMPARE(area(result), 10000 - 25 - 25 - 25);
    }

    void islandInsideAHoleIsItsOwnPolygon() {
        PolygonSet ring = model::subtract(square(0, 0, 100), square(20, 20, 60));
        ring.append(square(40, 40, 20));
        const PolygonSet result = model::unite(ring);
        QCOMPARE(result.polygons.size(), 2U);
        QCOMPARE(area(result), 10000 - 3600 + 400);
    }

    /// Together or a hundred at a time: what they cover is the same. Sides along the axes cross on the grid.
    void manyAreUnitedAsFewAre() {
        std::mt19937 random(5);
        PolygonSet many;
        PolygonSet atOnce;
        for (int i = 0; i < 700; ++i) {
            const int x = static_cast<int>(random() % 3000);
            const int y = static_cast<int>(random() % 3000);
            const PolygonSet one =
                bar(x, y, 10 + static_cast<int>(random() % 300), 10 + static_cast<int>(random() % 30));
            many.append(one);
            atOnce.append(one);
            if (i % 100 == 99) {  // few, with what was united before
                atOnce = model::unite(atOnce);
            }
        }
        const PolygonSet united = model::unite(many);
        QCOMPARE(area(united), area(atOnce));
        QCOMPARE(area(model::subtract(united, atOnce)), 0);
        QCOMPARE(area(model::subtract(atOnce, united)), 0);
        QCOMPARE(united.polygons.size(), atOnce.polygons.size());
        PolygonSet whole = square(0, 0, 4000);
        QCOMPARE(area(model::subtract(whole, many)), 16'000'000 - area(united));
    }

    /// The strokes of a hatch, slanted: their union covers each of them, and no more than all of them.
    void hatchesBecomeWhatTheyFill() {
        PolygonSet strokes;
        for (int i = 0; i < 600; ++i) {
            strokes.beginPolygon();
            const int x = 100'000 * i;
            const Point corners[] = {
                {x, 0}, {x + 150'000, 0}, {x + 1'150'007, 10'000'003}, {x + 1'000'007, 10'000'003}};
            strokes.addLoop(corners);
        }
        const PolygonSet united = model::unite(strokes);
        QCOMPARE(united.polygons.size(), std::size_t{1});
        QCOMPARE(united.polygons[0].loopCount, 1U);
        const long long expected = (599LL * 100'000 + 150'000) * 10'000'003;
        QVERIFY(std::abs(area(united) - expected) < 10'000'003LL * 20);  // corners are on the grid
    }

    void areaOfUnionAndCommonPartAddUp() {
        // |A ∪ B| = |A \ B| + |B|, on the grid exactly when all crossings are grid points.
        const PolygonSet a = square(0, 0, 64);
        const PolygonSet b = square(32, 16, 64);
        PolygonSet both = a;
        both.append(b);
        QCOMPARE(area(model::unite(both)), area(model::subtract(a, b)) + area(b));
    }

    void nothingMinusSomethingIsNothing() {
        QCOMPARE(model::subtract({}, square(0, 0, 10)).polygons.size(), 0U);
        QCOMPARE(model::subtract(square(0, 0, 10), square(-1, -1, 20)).polygons.size(), 0U);
    }
};

QTEST_APPLESS_MAIN(BooleanTest)
#include "boolean_test.moc"
