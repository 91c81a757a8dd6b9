#include "model/geometry/loops/region_search.h"

#include <QtTest>

#include "tests/unit/model/geometry/loop_shapes.h"

using model::CutLie;
using model::EdgeLoops;
using model::RegionSearch;

namespace {

constexpr double kMm = 1e6;

RegionSearch disc(double x, double y, double radius) {
    return RegionSearch(loop_shapes::disc(x, y, radius));
}

/// A square of 100 mm with a square hole of 2 mm every 10 mm: enough edges for a tree.
RegionSearch plane() {
    EdgeLoops loops = loop_shapes::rectangle(0, 0, 100, 100);
    for (int i = 0; i < 100; ++i) {
        const double x = 4.0 + 10.0 * (i % 10);
        const double y = 4.0 + 10.0 * (i / 10);
        loop_shapes::addRectangle(loops, x, y, x + 2, y + 2);
    }
    return RegionSearch(loops);
}

}  // namespace

class RegionSearchTest : public QObject {
    Q_OBJECT

private slots:
    void holdsWhatIsNoHole() {
        const RegionSearch region = plane();
        QVERIFY(region.holds({1 * kMm, 1 * kMm}));
        QVERIFY(!region.holds({5 * kMm, 5 * kMm}));
        QVERIFY(region.holds({51 * kMm, 55 * kMm}));
        QVERIFY(!region.holds({95 * kMm, 95 * kMm}));
        QVERIFY(!region.holds({-1 * kMm, 50 * kMm}));
        QVERIFY(!region.holds({101 * kMm, 50 * kMm}));
        QVERIFY(disc(0, 0, 1).holds({0.9 * kMm, 0}));
        QVERIFY(!disc(0, 0, 1).holds({0.9 * kMm, 0.9 * kMm}));
    }

    void cutsLieApartInsideOrAcross() {
        const RegionSearch region = plane();
        QCOMPARE(lieOf(disc(50, 50, 2), region), CutLie::Inside);
        QCOMPARE(lieOf(disc(55, 55, 0.5), region), CutLie::Apart);  // within a hole
        QCOMPARE(lieOf(disc(55, 55, 1), region), CutLie::Across);   // touches it
        QCOMPARE(lieOf(disc(55, 55, 2), region), CutLie::Across);   // around it
        QCOMPARE(lieOf(disc(100, 50, 1), region), CutLie::Across);  // at the edge
        QCOMPARE(lieOf(disc(102, 50, 1), region), CutLie::Apart);
        QCOMPARE(lieOf(disc(50, 50, 200), region), CutLie::Across);  // takes all of it
    }

    void cutsWithAnIslandAreNoLoop() {
        EdgeLoops ring;
        ring.addCircle({50 * kMm, 50 * kMm}, 3 * kMm);
        ring.addCircle({50 * kMm, 50 * kMm}, 2 * kMm);
        const RegionSearch cut(ring);
        QCOMPARE(lieOf(cut, plane()), CutLie::Across);
        QCOMPARE(lieOf(cut, disc(50, 50, 1)), CutLie::Apart);
    }
};

QTEST_APPLESS_MAIN(RegionSearchTest)
#include "region_search_test.moc"
