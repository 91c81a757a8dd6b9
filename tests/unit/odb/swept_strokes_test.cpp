#include "model/odb/swept_strokes.h"

#include <cmath>
#include <numbers>

#include "odb_testing.h"

using model::EdgeKind;
using model::PathNode;
using model::Point;
using model::PolygonSet;
using model::odb::penOf;
using model::odb::standardSymbol;
using model::odb::sweep;
using model::odb::Unit;

namespace {

constexpr double kPi = std::numbers::pi;

PolygonSet pen(const std::string& name) {
    return penOf(standardSymbol({name, Unit::Millimetre, 0}).value());
}

/// In mm².
double areaOf(const PolygonSet& set) {
    return static_cast<double>(model::twiceArea(set)) / 2e12;
}

PathNode lineFrom(Point p) {
    return {p, {}, EdgeKind::Line};
}

/// Is the point in the region? By the winding number of all loops.
bool covers(const PolygonSet& set, Point p) {
    int winding = 0;
    for (std::size_t l = 0; l < set.loopCount(); ++l) {
        const auto loop = set.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point a = loop[i];
            const Point b = loop[(i + 1) % loop.size()];
            const __int128 side = static_cast<__int128>(b.x - std::int64_t{a.x}) * (p.y - std::int64_t{a.y}) -
                                  static_cast<__int128>(b.y - std::int64_t{a.y}) * (p.x - std::int64_t{a.x});
            winding += a.y <= p.y && b.y > p.y && side > 0 ? 1 : 0;
            winding -= a.y > p.y && b.y <= p.y && side < 0 ? 1 : 0;
        }
    }
    return winding > 0;
}

}  // namespace

class SweptStrokesTest : public QObject {
    Q_OBJECT

private slots:
    /// A ring of radius 1 mm carried around a circle of 3 mm covers everything between 2 and 4 mm: its own hole is
    /// covered by where it was before. Hundreds of places lie on each other, so this is about time as well.
    void aRingAroundALongArcLeavesNoHole() {
        const PathNode start{{3'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        const PolygonSet cover = sweep(pen("donut_r2000x1000"), start, {3'000'000, 0});
        const double exact = kPi * (16.0 - 4.0);
        QVERIFY2(std::abs(areaOf(cover) - exact) < 1e-3 * exact, qPrintable(QString::number(areaOf(cover))));
        QVERIFY(!covers(cover, {0, 0}) && covers(cover, {0, 3'000'000}) && covers(cover, {-2'500'000, 0}));
        QVERIFY(!covers(cover, {0, 4'002'000}));
    }

    /// Pen P along a vector v covers |P| + |v| × width of P across v, when P is convex.
    void convexPensCoverTheirAreaAndTheirWidthTimesTheWay_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("penArea");
        QTest::addColumn<double>("across");
        QTest::newRow("s") << "s1000" << 1.0 << 1.0;
        QTest::newRow("oval") << "oval1000x400" << 0.24 + kPi * 0.04 << 0.4;
        QTest::newRow("el") << "el1000x600" << kPi * 0.15 << 0.6;
        QTest::newRow("rounded") << "rect1000x600xr200" << 0.6 - (4 - kPi) * 0.04 << 0.6;
        QTest::newRow("half oval") << "oval_h1000x400" << 0.32 + kPi * 0.02 << 0.4;
        QTest::newRow("tri") << "tri1000x600" << 0.3 << 0.6;
    }
    void convexPensCoverTheirAreaAndTheirWidthTimesTheWay() {
        QFETCH(QString, name);
        QFETCH(double, penArea);
        QFETCH(double, across);
        const PolygonSet swept = sweep(pen(name.toStdString()), lineFrom({0, 0}), {5'000'000, 0});
        QCOMPARE(swept.polygons.size(), std::size_t{1});
        QVERIFY2(std::abs(areaOf(swept) - penArea - 5.0 * across) < 0.003, qPrintable(QString::number(areaOf(swept))));
    }

    void pensWithHolesFillTheirWay() {
        // A ring of 1 mm with a hole of 0.6 along 0.2 mm: what both ends leave open stays open.
        const PolygonSet near = sweep(pen("donut_r1000x600"), lineFrom({0, 0}), {200'000, 0});
        QVERIFY(!covers(near, {100'000, 0}));
        QVERIFY(covers(near, {-250'000, 0}));  // open at the start, passed by the ring behind it
        const double lens = 2 * (0.09 * std::acos(0.1 / 0.3) - 0.1 * std::sqrt(0.09 - 0.01));
        QVERIFY2(std::abs(areaOf(near) - (kPi / 4 + 0.2 - lens)) < 0.003, qPrintable(QString::number(areaOf(near))));
        // Along 2 mm nothing in the middle stays open.
        const PolygonSet far = sweep(pen("donut_r1000x600"), lineFrom({0, 0}), {2'000'000, 0});
        QVERIFY(covers(far, {1'000'000, 0}));
    }

    void concavePensAreNotTakenForTheirHull() {
        // A home plate turned in: its notch is on the right and stays open at the end of the way.
        const PolygonSet swept = sweep(pen("rhplate1000x800x500"), lineFrom({0, 0}), {3'000'000, 0});
        QVERIFY(!covers(swept, {3'400'000, 0}));
        QVERIFY(covers(swept, {400'000, 0}));
        QVERIFY(std::abs(areaOf(swept) - (0.8 - 0.2 + 3 * 0.8)) < 1e-5);
    }

    void arcsAreSweptAlongTheArcWithoutTurning() {
        // A square pen around a full circle of radius 3: every extreme lies half a pen beyond the circle.
        const PathNode start{{3'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        const PolygonSet swept = sweep(pen("s1000"), start, start.point);
        model::Box box;
        for (const Point& point : swept.points) {
            box.include(point);
        }
        QVERIFY(std::abs(box.max.x - 3'500'000) <= 1'000 && std::abs(box.min.y + 3'500'000) <= 1'000);
        QVERIFY(!covers(swept, {0, 0}));
        QVERIFY(covers(swept, {2'550'000, 0}));
        QVERIFY(!covers(swept, {2'450'000, 0}));
        // On the diagonal the pen reaches half its diagonal far.
        const double reach = 3.0 + std::sqrt(0.5);
        const auto diagonal = [](double r) {
            return Point{static_cast<model::Nm>(r * 1e6 / std::numbers::sqrt2),
                         static_cast<model::Nm>(r * 1e6 / std::numbers::sqrt2)};
        };
        QVERIFY(covers(swept, diagonal(reach - 0.003)));
        QVERIFY(!covers(swept, diagonal(reach + 0.003)));
    }

    void aRoundPenGivesTheSameAsALine() {
        const PolygonSet swept = sweep(pen("r500"), lineFrom({0, 0}), {3'000'000, 4'000'000});
        QVERIFY(std::abs(areaOf(swept) - (2.5 + kPi / 16)) < 0.002);
    }
};

QTEST_APPLESS_MAIN(SweptStrokesTest)
#include "swept_strokes_test.moc"
