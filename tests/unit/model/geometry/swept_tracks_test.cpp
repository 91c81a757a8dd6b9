#include "model/geometry/swept_tracks.h"

#include <cmath>
#include <numbers>
#include <random>

#include "model/formats/common/pad_shape.h"
#include "model/formats/odb/symbols/standard_symbols.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::EdgeKind;
using model::PathNode;
using model::Point;
using model::PolygonSet;
using model::sweep;
using model::formats::PadShape;
using model::odb::standardSymbol;
using model::odb::Unit;
using odb_testing::covers;

namespace {

constexpr double kPi = std::numbers::pi;

PolygonSet penOf(const PadShape& shape) {
    return model::polygonsOf(outlineOf(shape), model::kFinestSweep);
}

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

}  // namespace

class SweptTracksTest : public QObject {
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

    /// A concave pen along an arc against the pen laid down at many places of it.
    void aConcavePenAlongAnArcCoversWhatItsPlacesCover() {
        const PolygonSet notched = pen("rhplate1000x800x500");
        const PathNode start{{2'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        const Point end{-1'414'214, 1'414'214};
        const PolygonSet swept = sweep(notched, start, end);
        std::mt19937 random(3);
        for (int i = 0; i < 500; ++i) {
            const Point p{static_cast<int>(random() % 6'000'000) - 3'000'000,
                          static_cast<int>(random() % 4'000'000) - 1'000'000};
            int seen = 0;  // places that cover p; a hair's breadth is neither inside nor outside
            for (int location = 0; location <= 3000; ++location) {
                const double angle = 0.75 * kPi * location / 3000;
                seen += covers(notched, {p.x - static_cast<int>(std::lround(2e6 * std::cos(angle))),
                                         p.y - static_cast<int>(std::lround(2e6 * std::sin(angle)))})
                            ? 1
                            : 0;
            }
            QVERIFY2(seen == 0 || seen > 2 ? covers(swept, p) == (seen > 0) : true,
                     qPrintable(QString("%1, %2: %3 places").arg(p.x).arg(p.y).arg(seen)));
        }
    }

    /// 3,000 sides around a circle of 40 mm: finer chords than needed would take minutes.
    void manySidesAreSweptByCoarserChords() {
        PadShape comb;
        comb.kind = PadShape::Kind::Region;
        std::vector<model::PointD> points;
        for (int tooth = 0; tooth < 1500; ++tooth) {
            points.push_back({tooth * 1'000.0, 0.0});
            points.push_back({tooth * 1'000.0 + 500.0, 1'000'000.0});
        }
        points.push_back({1'500'000.0, -100'000.0});
        points.push_back({0.0, -100'000.0});
        model::addLoop(comb.region, points, false);
        const PathNode start{{40'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        const auto swept = sweep(comb.region, penOf(comb), start, start.point);
        QVERIFY(swept.chordNm == 0.0);  // 50 µm chords are still too many
        const auto across =
            sweep(comb.region, penOf(comb), {{0, 0}, {500'000, 0}, EdgeKind::ArcCounterClockwise}, {0, 0});
        QVERIFY2(across.chordNm > 500.0, qPrintable(QString::number(across.chordNm)));
        QVERIFY(covers(across.cover, {500'000, 900'000}));
        QVERIFY(covers(across.cover, {500'000, -550'000}));
        QVERIFY(!covers(across.cover, {500'000, -650'000}));
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

QTEST_APPLESS_MAIN(SweptTracksTest)
#include "swept_tracks_test.moc"
