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

    void regionsComeNearEdges_data() {
        QTest::addColumn<Point>("low");
        QTest::addColumn<Point>("high");
        QTest::addColumn<double>("margin");
        QTest::addColumn<bool>("comesNear");
        QTest::newRow("crosses the slant") << Point{400, 400} << Point{600, 600} << 1.0 << true;
        QTest::newRow("touches the slant") << Point{500, 500} << Point{600, 600} << 1.0 << true;
        QTest::newRow("2.8 off the slant, within 3") << Point{502, 502} << Point{600, 600} << 3.0 << true;
        QTest::newRow("2.8 off the slant, beyond 2") << Point{502, 502} << Point{600, 600} << 2.0 << false;
        QTest::newRow("below a side, within 5") << Point{100, -50} << Point{200, -4} << 5.0 << true;
        QTest::newRow("below a side, beyond 4") << Point{100, -50} << Point{200, -4} << 4.0 << false;
        QTest::newRow("inside, away from all sides") << Point{100, 100} << Point{300, 300} << 50.0 << false;
        QTest::newRow("around all of it") << Point{-10, -10} << Point{2000, 2000} << 5.0 << false;
    }
    void regionsComeNearEdges() {
        QFETCH(Point, low);
        QFETCH(Point, high);
        QFETCH(double, margin);
        model::PolygonSet set;
        set.beginPolygon();
        const Point loop[] = {low, {high.x, low.y}, high, {low.x, high.y}};
        set.addLoop(loop);
        QTEST(triangle().comesNear(set, set.polygons, Box{low, high}, margin), "comesNear");
    }
};

QTEST_APPLESS_MAIN(RegionDistanceTest)
#include "region_distance_test.moc"
