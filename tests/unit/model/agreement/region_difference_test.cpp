#include "model/agreement/region_difference.h"

#include <QtTest>
#include <array>

#include "model/base/parallel.h"

using model::Nm;
using model::Point;
using model::PolygonSet;
using model::RegionDifference;

namespace {

constexpr Nm kUm = 1'000;
constexpr Nm kPixel = 10 * kUm;

void addBox(PolygonSet& set, Point min, Point max) {
    set.beginPolygon();
    set.addLoop(std::array<Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}});
}

PolygonSet box(Point min, Point max) {
    PolygonSet set;
    addBox(set, min, max);
    return set;
}

}  // namespace

class RegionDifferenceTest : public QObject {
    Q_OBJECT

private slots:
    void areasAreThoseOfTheRegions() {
        PolygonSet ring = box({0, 0}, {1000 * kUm, 500 * kUm});
        ring.addLoop(std::array<Point, 4>{
            {{100 * kUm, 100 * kUm}, {300 * kUm, 100 * kUm}, {300 * kUm, 300 * kUm}, {100 * kUm, 300 * kUm}}});
        PolygonSet overlapping = box({0, 0}, {600 * kUm, 500 * kUm});
        addBox(overlapping, {400 * kUm, 0}, {1000 * kUm, 500 * kUm});
        const RegionDifference d = model::differenceOf(ring, overlapping, kPixel);
        QCOMPARE(d.areas[0], 1e6 * (1000.0 * 500.0 - 200.0 * 200.0));
        QCOMPARE(d.areas[1], 1e6 * 1000.0 * 500.0);
        QCOMPARE(d.only[0], 0.0);
        QCOMPARE(d.only[1], 1e6 * 180.0 * 180.0);  // a pixel less on all sides
        QCOMPARE(d.box, (model::Box{{110 * kUm, 110 * kUm}, {290 * kUm, 290 * kUm}}));
        QCOMPARE(d.places.size(), std::size_t{1});
        QCOMPARE(d.places[0].at, (Point{110 * kUm, 110 * kUm}));
        QCOMPARE(d.places[0].box, d.box);
        QCOMPARE(d.share(), 180.0 * 180.0 / (1000.0 * 500.0));
    }

    void edgesMayBeOffByAPixel() {
        const PolygonSet a = box({0, 0}, {5000 * kUm, 3000 * kUm});
        const PolygonSet b = box({-9 * kUm, 8 * kUm}, {5009 * kUm, 2991 * kUm});
        const RegionDifference d = model::differenceOf(a, b, kPixel);
        QCOMPARE(d.only[0] + d.only[1], 0.0);
        QVERIFY(d.box.isEmpty() && d.places.empty());
        const RegionDifference farther = model::differenceOf(a, box({-40 * kUm, 0}, {5000 * kUm, 3000 * kUm}), kPixel);
        QVERIFY(farther.only[1] > 0.0 && farther.only[0] == 0.0);
    }

    void aTrackOfFiftyMicrometresIsNotLost_data() {
        QTest::addColumn<int>("x");
        for (const int x : {0, 3, 63, 64, 630, 637, 641, 1277}) {
            QTest::addRow("%d um", x) << x;
        }
    }
    void aTrackOfFiftyMicrometresIsNotLost() {
        QFETCH(int, x);
        PolygonSet a = box({-2000 * kUm, 0}, {-1000 * kUm, 2000 * kUm});
        const PolygonSet b = a;
        addBox(a, {x * kUm, 300 * kUm}, {(x + 50) * kUm, 1900 * kUm});
        const RegionDifference d = model::differenceOf(a, b, kPixel);
        QVERIFY(d.only[0] >= 1e6 * 20.0 * 1570.0 && d.only[0] <= 1e6 * 40.0 * 1600.0);
        QVERIFY(d.box.min.x >= x * kUm && d.box.max.x <= (x + 50) * kUm);
    }

    void slantedEdgesAndHolesInsideAreCountedAcrossBands() {
        // A rhombus over many bands of rows; its area is half of its box.
        PolygonSet rhombus;
        rhombus.beginPolygon();
        rhombus.addLoop(
            std::array<Point, 4>{{{0, -20'000 * kUm}, {10'000 * kUm, 0}, {0, 20'000 * kUm}, {-10'000 * kUm, 0}}});
        const RegionDifference d = model::differenceOf(rhombus, {}, kPixel);
        const double exact = 1e6 * 10'000.0 * 40'000.0;
        QVERIFY(std::abs(d.areas[0] - exact) < 1e-4 * exact);
        QVERIFY(d.only[0] < d.areas[0] && d.only[0] > 0.996 * exact);
        QCOMPARE(d.areas[1], 0.0);
    }

    void oneThreadCountsAsManyDo() {
        PolygonSet a;
        PolygonSet b;
        for (Nm i = 0; i < 200; ++i) {
            addBox(a, {i * 97 * kUm, i * 53 * kUm}, {(i * 97 + 200) * kUm, (i * 53 + 120) * kUm});
            addBox(b, {i * 97 * kUm, i * 53 * kUm}, {(i * 97 + 200) * kUm, (i * 53 + 120 + i % 50) * kUm});
        }
        const RegionDifference all = model::differenceOf(a, b, kPixel);
        const base::ThreadLimit one(1);
        const RegionDifference single = model::differenceOf(a, b, kPixel);
        QVERIFY(all.only[1] > 0.0);
        QCOMPARE(single.only[1], all.only[1]);
        QCOMPARE(single.areas[0], all.areas[0]);
        QCOMPARE(single.places.size(), all.places.size());
        for (std::size_t i = 0; i < all.places.size(); ++i) {
            QCOMPARE(single.places[i].at, all.places[i].at);
            QCOMPARE(single.places[i].box, all.places[i].box);
        }
    }

    void whatLiesApartIsAPlaceOfItsOwn() {
        const PolygonSet common = box({0, 0}, {1000 * kUm, 1000 * kUm});
        PolygonSet a = common;
        PolygonSet b = common;
        addBox(a, {5000 * kUm, 20'000 * kUm}, {5100 * kUm, 20'100 * kUm});
        addBox(b, {30'000 * kUm, 100 * kUm}, {30'400 * kUm, 500 * kUm});
        addBox(b, {5060 * kUm, 20'200 * kUm}, {5120 * kUm, 20'300 * kUm});  // beside that of A
        const RegionDifference d = model::differenceOf(a, b, kPixel);
        QCOMPARE(d.places.size(), std::size_t{2});
        QCOMPARE(d.places[0].box, (model::Box{{30'010 * kUm, 110 * kUm}, {30'390 * kUm, 490 * kUm}}));
        QCOMPARE(d.places[0].only[0], 0.0);
        QCOMPARE(d.places[0].only[1], 1e6 * 380.0 * 380.0);
        QCOMPARE(d.places[1].box, (model::Box{{5010 * kUm, 20'010 * kUm}, {5110 * kUm, 20'290 * kUm}}));
        QCOMPARE(d.places[1].at, (Point{5010 * kUm, 20'010 * kUm}));
        QCOMPARE(d.places[1].only[0], 1e6 * 80.0 * 80.0);
        QCOMPARE(d.places[1].only[1], 1e6 * 40.0 * 80.0);
        QCOMPARE(d.only[1], d.places[0].only[1] + d.places[1].only[1]);
    }

    void whatLiesAcrossCellsAndBandsIsOnePlace() {
        PolygonSet a = box({0, 0}, {100 * kUm, 100 * kUm});
        const PolygonSet b = a;
        // A ring whose sides pass many cells, from the lower edge up, and back down to a place that lies lower.
        addBox(a, {10'000 * kUm, 3000 * kUm}, {10'200 * kUm, 30'000 * kUm});
        addBox(a, {10'000 * kUm, 29'800 * kUm}, {20'000 * kUm, 30'000 * kUm});
        addBox(a, {19'800 * kUm, 2000 * kUm}, {20'000 * kUm, 30'000 * kUm});
        const RegionDifference d = model::differenceOf(a, b, kPixel);
        QCOMPARE(d.places.size(), std::size_t{1});
        QCOMPARE(d.places[0].at, (Point{19'810 * kUm, 2010 * kUm}));
        QCOMPARE(d.places[0].box, (model::Box{{10'010 * kUm, 2010 * kUm}, {19'990 * kUm, 29'990 * kUm}}));
    }

    void nothingAndNothingAgree() {
        const RegionDifference d = model::differenceOf({}, {}, kPixel);
        QCOMPARE(d.share(), 0.0);
        QCOMPARE(model::differenceOf({}, box({0, 0}, {100 * kUm, 100 * kUm}), kPixel).only[1], 1e6 * 80.0 * 80.0);
    }
};

QTEST_APPLESS_MAIN(RegionDifferenceTest)
#include "region_difference_test.moc"
