#include "model/solids/region_distance.h"

#include <QtTest>

using model::Box;
using model::EdgeStrips;
using model::Point;

namespace {

/// A triangle with a long slanted side.
EdgeStrips triangle() {
    model::PolygonSet set;
    set.beginPolygon();
    const Point loop[] = {{0, 0}, {1000, 0}, {0, 1000}};
    set.addLoop(loop);
    return EdgeStrips(set);
}

}  // namespace

class RegionDistanceTest : public QObject {
    Q_OBJECT

private slots:
    void boxesMeetEdges_data() {
        QTest::addColumn<Point>("low");
        QTest::addColumn<Point>("high");
        QTest::addColumn<bool>("meets");
        QTest::newRow("inside") << Point{100, 100} << Point{300, 300} << false;
        QTest::newRow("outside, in the box of the slant") << Point{700, 700} << Point{900, 900} << false;
        QTest::newRow("across the slant") << Point{400, 400} << Point{600, 600} << true;
        QTest::newRow("corner on the slant") << Point{500, 500} << Point{600, 600} << true;
        QTest::newRow("corner just off it") << Point{501, 500} << Point{600, 600} << false;
        QTest::newRow("around all of it") << Point{-10, -10} << Point{2000, 2000} << true;
        QTest::newRow("on a side") << Point{100, -50} << Point{200, 0} << true;
        QTest::newRow("below") << Point{100, -50} << Point{200, -1} << false;
    }
    void boxesMeetEdges() {
        QFETCH(Point, low);
        QFETCH(Point, high);
        QFETCH(bool, meets);
        QCOMPARE(triangle().meets(Box{low, high}), meets);
    }
};

QTEST_APPLESS_MAIN(RegionDistanceTest)
#include "region_distance_test.moc"
