#include "model/formats/odb/symbols/standard_symbols.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "model/geometry/region.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Box;
using model::Nm;
using model::Point;
using model::ShapeSketch;
using model::formats::PadShape;
using model::odb::standardSymbol;
using model::odb::SymbolRef;
using model::odb::Unit;
using odb_testing::covers;
using Kind = model::formats::PadShape::Kind;

namespace {

constexpr double kPi = std::numbers::pi;

PadShape shapeOf(const std::string& name, Unit unit = Unit::Millimetre, int resize = 0) {
    const auto shape = standardSymbol({name, unit, resize});
    if (!shape) {
        qFatal("%s is no standard symbol", name.c_str());
    }
    return *shape;
}

Box boxOf(const ShapeSketch& sketch) {
    Box box;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        box.include(model::boxOfPath(sketch.contour(i), true));
    }
    return box;
}

/// In mm².
double areaOf(const ShapeSketch& sketch) {
    return static_cast<double>(model::twiceArea(model::polygonsOf(sketch))) / 2e12;
}

/// Of a point in nm from what a moire with these values (µm, rings and degrees as in its name) covers, in mm; negative
/// inside.
double distanceToMoire(Point p, const std::array<double, 6>& v) {
    const double x = p.x / 1e6, y = p.y / 1e6;
    const double d = std::hypot(x, y);
    const double width = v[0] / 1e3, gap = v[1] / 1e3;
    double distance = width > 0 ? d - width / 2 : 1.0;
    for (int ring = 1; ring <= v[2] && width > 0; ++ring) {
        const double outer = width / 2 + ring * (width + gap);
        distance = std::min(distance, std::max(d - outer, outer - width - d));
    }
    for (const double degrees : {v[5], v[5] + 90}) {
        const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
        const double past = std::max(std::abs(x * c + y * s) - v[4] / 2e3, 0.0);
        distance = v[3] > 0 ? std::min(distance, std::hypot(past, y * c - x * s) - v[3] / 2e3) : distance;
    }
    return distance;
}

}  // namespace

class StandardSymbolsTest : public QObject {
    Q_OBJECT

private slots:
    void simpleShapesNeedNoRegion() {
        const PadShape round = shapeOf("r100");
        QCOMPARE(round.kind, Kind::Round);
        QCOMPARE(round.width, 100'000);
        QCOMPARE(shapeOf("r100", Unit::Inch).width, 2'540'000);
        QCOMPARE(shapeOf("r1300.0").width, 1'300'000);
        QCOMPARE(shapeOf("r0").kind, Kind::Round);
        const PadShape ring = shapeOf("donut_r2000x1000.5");
        QCOMPARE(ring.kind, Kind::Ring);
        QCOMPARE(ring.width, 2'000'000);
        QCOMPARE(ring.height, 1'000'500);
        const PadShape oval = shapeOf("oval1200x400");
        QCOMPARE(oval.kind, Kind::Oval);
        QCOMPARE(oval.width, 1'200'000);
        QCOMPARE(oval.height, 400'000);
        for (const char* hole : {"hole1000xpx10x10", "hole1000xnx0x0", "hole1000xvx1.5x2"}) {
            QCOMPARE(shapeOf(hole).kind, Kind::Round);
            QCOMPARE(shapeOf(hole).width, 1'000'000);
        }
        QCOMPARE(shapeOf("null10").kind, Kind::Nothing);
        QVERIFY(shapeOf("null10").problem.empty());
    }

    void namesMustMatchCompletely() {
        for (const char* name :
             {"rect20x60_45", "s47.2441_135", "oval55x155_225", "smp", "u76r5", "u76r5+1", "r", "rect20", "rect20x",
              "r1.2.3", "rect20x30xr", "rect20x30xr2x", "rect20x30xr2x5", "R100", "donut_r100", "r100 ", ""}) {
            QVERIFY2(!standardSymbol({name, Unit::Inch, 0}).has_value(), name);
        }
    }

    void sizesThatCannotBeDrawnDrawNothing() {
        for (const char* name : {"r-13.1234", "rect-1x5", "oval5x-1", "r18446744073709552.0", "r726249766681478.38"}) {
            const PadShape shape = shapeOf(name);
            QCOMPARE(shape.kind, Kind::Nothing);
            QVERIFY2(shape.problem.find("draws nothing") != std::string::npos, name);
        }
        for (const char* name : {"donut_r100x100", "donut_s100x200", "donut_sr10x11", "ths10x20x0x4x1"}) {
            QCOMPARE(shapeOf(name).kind, Kind::Nothing);
            QVERIFY2(shapeOf(name).problem.find("no area") != std::string::npos, name);
        }
        // A line thermal has four gaps at 45 degrees, else the name is not of the standard.
        QVERIFY(!standardSymbol({"s_thr4000x3000x0x4x500", Unit::Millimetre, 0}).has_value());
        QCOMPARE(shapeOf("rect0x100").kind, Kind::Nothing);
        QVERIFY(shapeOf("rect0x100").problem.find("no area") != std::string::npos);
    }

    void aRingWithoutRoomForItsHoleIsADisc() {
        const PadShape shape = shapeOf("donut_r200.0x-25.0");
        QCOMPARE(shape.kind, Kind::Round);
        QCOMPARE(shape.width, 200'000);
        QVERIFY(!shape.problem.empty());
    }

    /// Sizes and areas in mm, worked out by hand from the definitions of the format.
    void regionsHaveTheirSizeAndArea_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("area");
        const auto row = [](const char* name, double width, double height, double area) {
            QTest::newRow(name) << name << width << height << area;
        };
        row("s4000", 4, 4, 16);
        row("rect4000x2000", 4, 2, 8);
        row("rect4000x2000xr500", 4, 2, 8 - (4 - kPi) * 0.25);
        row("rect4000x2000xr500x1", 4, 2, 8 - (4 - kPi) * 0.25 / 4);
        row("rect4000x2000xr500x124", 4, 2, 8 - 3 * (4 - kPi) * 0.25 / 4);
        row("rect4000x2000xr5000", 4, 2, 4 + kPi);  // limited to half the height: a stadium
        row("rect4000x2000xc500", 4, 2, 8 - 4 * 0.125);
        row("rect4000x2000xc500x34", 4, 2, 8 - 2 * 0.125);
        row("oct4000x2000x500", 4, 2, 8 - 4 * 0.125);
        row("di4000x2000", 4, 2, 4);
        row("hex_l4000x2000x1000", 4, 2, 8 - 2);
        row("hex_s4000x2000x500", 4, 2, 8 - 2);
        row("tri4000x3000", 4, 3, 6);
        row("el4000x2000", 4, 2, 2 * kPi);
        row("oval_h4000x2000", 4, 2, 6 + kPi / 2);
        row("bfr4000", 4, 4, 2 * kPi);
        row("bfs4000", 4, 4, 8);
        row("donut_s4000x2000", 4, 4, 12);
        row("donut_sr4000x2000", 4, 4, 16 - kPi);
        row("donut_rc4000x3000x500", 4, 3, 12 - 6);
        row("donut_rc4000x3000x500xr700", 4, 3, 12 - (4 - kPi) * 0.49 - (6 - (4 - kPi) * 0.04));
        row("donut_o4000x2000x500", 4, 2, (4 + kPi) - (2 + kPi / 4));
        row("donut_s4000x3000xr1000", 4, 4, 16 - (4 - kPi) - (9 - (4 - kPi) * 0.25));
        row("s_ths4000x2000x0x4x500", 4, 4, 12 - 4 * 0.5);
        // Each gap takes 2 × 0.5 of the strip, less what lies inside of the round hole.
        const double stripInHole = 0.25 * std::sqrt(1 - 0.0625) + std::asin(0.25);
        row("sr_ths4000x2000x0x2x500", 4, 4, 16 - kPi - 2 * (1 - stripInHole));
        row("rc_ths6000x4000x0x2x500x1000", 6, 4, 24 - 8 - 2 * 0.5);
        row("o_ths6000x2000x90x2x500x500", 6, 2, (8 + kPi) - (4 + kPi / 4) - 2 * 0.25);
        row("s_tho4000x2000x45x1x500", 4, 4, 12 - (1 + 2 * 0.25 * std::sqrt(2.0)));
        row("rc_tho6000x4000x0x2x500x1000", 6, 4, 24 - 8 - 2 * 0.5);
        row("rc_tho6000x4000x0x4x500x1000xr500x1", 6, 4, 16 - 4 * 0.5 - (4 - kPi) * 0.25 / 4);
        row("oblong_ths6000x2000x90x2x500x500xr", 6, 2, (8 + kPi) - (4 + kPi / 4) - 2 * 0.25);
        row("oblong_ths6000x2000x90x2x500x500xs", 6, 2, 12 - 5 - 2 * 0.25);
        row("hplate4000x2000x1500", 4, 2, 8 - 1.5);
        row("rhplate4000x2000x1000", 4, 2, 8 - 1);
        row("rhplate4000x2000x500x0x100", 4, 2, 8 - 0.5 - 0.01 * (std::tan(std::atan(0.5)) - std::atan(0.5)));
        row("fhplate4000x2000x500x1000", 4, 2, 8 - 0.5);
        row("fhplate4000x2000x500x1000x200x0", 4, 2, 8 - 0.5 - 2 * (1 - kPi / 4) * 0.04);
        row("radhplate4000x2000x1000", 4, 2, 8 - kPi / 8);
        row("radhplate4000x2000x1000x300", 4, 2, 8 - kPi / 8 - (4 - kPi) * 0.09);
        row("dshape4000x2000x1000", 4, 2, 6 + kPi / 2);
        row("dshape4000x2000x1000x400", 4, 2, 6 + kPi / 2 - (4 - kPi) * 0.16 / 2);
        // Relief 0.5 over a chord of 2: radius 1.25, half angle asin(0.8).
        row("dshape4000x2000x500", 4, 2, 7 + 1.25 * 1.25 * std::asin(0.8) - 0.75);
        row("cross4000x3000x500x400x50x50xs", 4, 3, 2 + 1.2 - 0.2);
        row("cross4000x3000x500x400x25x75xr", 4, 3, 3 - (1 - kPi / 4) * (0.25 + 0.16));
        row("cross4000x3000x500x400x50x50xs200", 4, 3, 3 + (4 - kPi) * 0.04);
        row("dogbone4000x3000x500x400x50xs", 4, 3, 4 + 2 * 0.4);
        row("dogbone4000x3000x500x400x50xr", 4, 3, 4.8 - 2 * (1 - kPi / 4) * 0.25);
        row("dogbone4000x3000x500x400x0xsx200", 4, 3, 4.8 + 2 * (1 - kPi / 4) * 0.04);
        row("dpack4000x2000x200x200x4x2", 4, 2, (4 - 0.6) * (2 - 0.2));
        row("dpack4000x2000x200x200x4x2x100", 4, 2, 3.4 * 1.8 - 8 * (4 - kPi) * 0.01);
    }
    void regionsHaveTheirSizeAndArea() {
        QFETCH(QString, name);
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, area);
        const PadShape shape = shapeOf(name.toStdString());
        QCOMPARE(shape.kind, Kind::Region);
        const Box box = boxOf(shape.region);
        QVERIFY(std::abs(static_cast<double>(box.width()) / 1e6 - width) < 2e-6);
        QVERIFY(std::abs(static_cast<double>(box.height()) / 1e6 - height) < 2e-6);
        QVERIFY(std::abs(box.min.x + box.max.x) <= 2 && std::abs(box.min.y + box.max.y) <= 2);
        // Chords lie up to 1 µm inside of arcs; a thousandth of the area is far above that.
        QVERIFY2(std::abs(areaOf(shape.region) - area) < 0.002 * area,
                 qPrintable(QString::number(areaOf(shape.region))));
    }

    void cornersAreCountedCounterClockwiseFromTheTopRight_data() {
        QTest::addColumn<QString>("corner");
        QTest::addColumn<int>("sx");
        QTest::addColumn<int>("sy");
        QTest::newRow("1") << "1" << 1 << 1;
        QTest::newRow("2") << "2" << -1 << 1;
        QTest::newRow("3") << "3" << -1 << -1;
        QTest::newRow("4") << "4" << 1 << -1;
    }
    void cornersAreCountedCounterClockwiseFromTheTopRight() {
        QFETCH(QString, corner);
        QFETCH(int, sx);
        QFETCH(int, sy);
        const ShapeSketch cut = shapeOf("rect4000x2000xc500x" + corner.toStdString()).region;
        const Point sharp{sx * 2'000'000, sy * 1'000'000};
        QCOMPARE(cut.contour(0).size(), std::size_t{5});
        for (const model::PathNode& node : cut.contour(0)) {
            QVERIFY(node.point != sharp);
        }
    }

    void roundThermalsAreExactPieces_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("pieces");
        QTest::newRow("ths") << "ths4000x2000x45x4x500" << 4;
        QTest::newRow("ths one gap") << "ths4000x2000x0x1x500" << 1;
        QTest::newRow("thr") << "thr4000x2000x45x3x500" << 3;
    }
    void roundThermalsAreExactPieces() {
        QFETCH(QString, name);
        QFETCH(int, pieces);
        const ShapeSketch region = shapeOf(name.toStdString()).region;
        QCOMPARE(region.contourCount(), static_cast<std::size_t>(pieces));
        for (std::size_t i = 0; i < region.contourCount(); ++i) {
            QCOMPARE(region.contour(i).size(), std::size_t{4});
            for (const model::PathNode& node : region.contour(i)) {
                const double radius = std::hypot(node.point.x, node.point.y);
                QVERIFY(std::abs(radius - 2e6) < 2 || std::abs(radius - 1e6) < 2);
            }
        }
    }

    void thermalGapsAreWhereTheAngleSays() {
        // One gap at 90°: nothing is at the top, the ring is whole at the bottom.
        const auto polygons = model::polygonsOf(shapeOf("ths4000x2000x90x1x500").region);
        int top = 0;
        int bottom = 0;
        for (const Point& point : polygons.points) {
            top += std::abs(point.x) < 200'000 && point.y > 0 ? 1 : 0;
            bottom += std::abs(point.x) < 200'000 && point.y < 0 ? 1 : 0;
        }
        QCOMPARE(top, 0);
        QVERIFY(bottom > 0);
    }

    void onlySquaresAreSquarePens() {
        QVERIFY(shapeOf("s100").isSquarePen);
        QVERIFY(shapeOf("rect100x100").isSquarePen);
        QVERIFY(!shapeOf("rect100x200").isSquarePen);
    }

    void resizingAddsToTheWholeSize() {
        QCOMPARE(shapeOf("r100", Unit::Millimetre, -40'000).width, 60'000);
        QCOMPARE(shapeOf("r100", Unit::Inch, 10'000).width, 2'550'000);
        QCOMPARE(boxOf(shapeOf("rect100x200", Unit::Millimetre, 50'000).region).height(), 250'000);
        QCOMPARE(shapeOf("r10", Unit::Millimetre, -40'000).kind, Kind::Nothing);
    }

    /// Outer sizes grow, everything else stays as the name says: a resized symbol is the symbol of another name.
    void aResizedSymbolIsTheOneWithGrownOuterSizes_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("grown");
        const auto row = [](const char* name, const char* grown) { QTest::newRow(name) << name << grown; };
        row("s4000", "s4100");
        row("rect4000x2000xr500x12", "rect4100x2100xr500x12");
        row("oct4000x2000x500", "oct4100x2100x500");
        row("hex_s4000x2000x500", "hex_s4100x2100x500");
        row("el4000x2000", "el4100x2100");
        row("bfr4000", "bfr4100");
        row("donut_s4000x2000", "donut_s4100x2000");
        row("donut_sr4000x2000", "donut_sr4100x2000");
        row("donut_rc4000x3000x500xr700", "donut_rc4100x3100x500xr700");
        row("donut_o4000x2000x500", "donut_o4100x2100x500");
        row("ths4000x2000x45x4x500", "ths4100x2000x45x4x500");
        row("s_tho4000x2000x45x4x500", "s_tho4100x2000x45x4x500");
        row("rc_ths6000x4000x0x2x500x1000", "rc_ths6100x4100x0x2x500x1000");
        row("oblong_ths6000x2000x90x2x500x500xs", "oblong_ths6100x2100x90x2x500x500xs");
        row("hplate4000x2000x1000", "hplate4100x2100x1000");
        row("cross4000x3000x500x400x50x50xr", "cross4100x3100x500x400x50x50xr");
        row("dpack4000x2000x200x200x4x2", "dpack4100x2100x200x200x4x2");
    }
    void aResizedSymbolIsTheOneWithGrownOuterSizes() {
        QFETCH(QString, name);
        QFETCH(QString, grown);
        const ShapeSketch a = shapeOf(name.toStdString(), Unit::Millimetre, 100'000).region;
        const ShapeSketch b = shapeOf(grown.toStdString()).region;
        QCOMPARE(a.contourCount(), b.contourCount());
        for (std::size_t i = 0; i < a.contourCount(); ++i) {
            QVERIFY(std::ranges::equal(a.contour(i), b.contour(i)));
        }
    }

    void aSymbolWithoutOuterSizesGrowsByItsOutline() {
        // The arms grow by 50 µm to every side, so does the outermost ring.
        const PadShape shape = shapeOf("moire100x200x3x50x2000x0", Unit::Millimetre, 100'000);
        QVERIFY(std::abs(boxOf(shape.region).width() - 2'150'000) <= 4'000);
        QVERIFY(areaOf(shape.region) > areaOf(shapeOf("moire100x200x3x50x2000x0").region));
        // A ring's hole stays.
        model::ShapeSketch ring;
        ring.addPolygon(std::vector<Point>{{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}}, false);
        ring.addPolygon(std::vector<Point>{{1000, 1000}, {1000, 3000}, {3000, 3000}, {3000, 1000}}, true);
        PadShape user;
        user.kind = Kind::Region;
        user.region = ring;
        const ShapeSketch grown = model::odb::resized(user, 200).region;
        QCOMPARE(boxOf(grown), (Box{{-100, -100}, {4100, 4100}}));
        QCOMPARE(static_cast<long long>(model::twiceArea(model::polygonsOf(grown))), 2LL * (4200 * 4200 - 2000 * 2000));
        QCOMPARE(model::odb::resized(user, -3000).kind, Kind::Nothing);
    }

    void moireIsADotRingsAndACrossWithRoundEnds() {
        const PadShape shape = shapeOf("moire100x200x2x50x2000x0");
        QCOMPARE(boxOf(shape.region).width(), 2'050'000);
        QCOMPARE(boxOf(shape.region).height(), 2'050'000);
        // Dot Ø 0.1; rings 0.5 to 0.7 and 1.1 to 1.3 in diameter; the cross adds its arms where nothing else is.
        const double rings = kPi / 4 * (0.01 + 0.49 - 0.25 + 1.69 - 1.21);
        const double arms = 4 * (1.0 - 0.05 - 0.2) * 0.05 + kPi * 0.05 * 0.05 / 4 * 2;
        QVERIFY2(std::abs(areaOf(shape.region) - rings - arms) < 0.005,
                 qPrintable(QString::number(areaOf(shape.region))));
    }

    /// Wherever the cross ends, every point is where the definition says: in the dot, a ring or the cross.
    void moiresCoverDotRingsAndCross_data() {
        QTest::addColumn<std::array<double, 6>>("v");
        QTest::newRow("cross beyond the rings") << std::array<double, 6>{100, 200, 3, 50, 3000, 0};
        QTest::newRow("turned") << std::array<double, 6>{100, 200, 3, 50, 3000, 33};
        QTest::newRow("cross ends in a gap") << std::array<double, 6>{100, 400, 3, 60, 1500, 10};
        QTest::newRow("cross ends in a ring") << std::array<double, 6>{200, 200, 3, 60, 900, 10};
        QTest::newRow("round end on a circle") << std::array<double, 6>{100, 200, 3, 300, 560, 45};
        QTest::newRow("cross within the dot") << std::array<double, 6>{400, 200, 2, 50, 100, 0};
        QTest::newRow("lines as wide as gaps") << std::array<double, 6>{100, 200, 3, 500, 2500, 0};
        QTest::newRow("lines wider than long") << std::array<double, 6>{100, 200, 3, 700, 300, 20};
        QTest::newRow("a disc for a cross") << std::array<double, 6>{100, 200, 3, 700, 0, 0};
        QTest::newRow("no cross") << std::array<double, 6>{100, 200, 3, 0, 2000, 0};
        QTest::newRow("no rings") << std::array<double, 6>{100, 200, 0, 50, 2000, 0};
        QTest::newRow("rings without width") << std::array<double, 6>{0, 200, 40, 50, 2000, 0};
        QTest::newRow("rings without gaps") << std::array<double, 6>{100, 0, 4, 50, 2000, 0};
        QTest::newRow("wide cross, no dot to see") << std::array<double, 6>{20, 30, 30, 900, 2600, 15};
    }
    void moiresCoverDotRingsAndCross() {
        using Values = std::array<double, 6>;
        QFETCH(Values, v);
        QString name = "moire%1x%2x%3x%4x%5x%6";
        for (const double value : v) {
            name = name.arg(value);
        }
        const model::PolygonSet region = model::polygonsOf(shapeOf(name.toStdString()).region, {500.0, false});
        std::mt19937 random(5);
        int unsure = 0;
        for (int i = 0; i < 4000; ++i) {
            const Point p{static_cast<Nm>(random() % 3'400'000) - 1'700'000,
                          static_cast<Nm>(random() % 3'400'000) - 1'700'000};
            const double distance = distanceToMoire(p, v);
            unsure += std::abs(distance) < 0.002 ? 1 : 0;
            if (std::abs(distance) >= 0.002) {
                QVERIFY2(covers(region, p) == (distance < 0),
                         qPrintable(QString("%1 at %2, %3").arg(name).arg(p.x).arg(p.y)));
            }
        }
        QVERIFY(unsure < 800);
    }

    void symbolsOfMoreThanAHundredPiecesDrawNothing() {
        QVERIFY(shapeOf("moire10x10x100x5x1000x0").problem.empty());
        for (const char* name : {"moire10x10x101x5x1000x0", "thr2000x1000x45x200x100", "s_ths2000x1000x45x-4x100",
                                 "dpack9000x9000x10x10x101x2"}) {
            const PadShape shape = shapeOf(name);
            QCOMPARE(shape.kind, Kind::Nothing);
            QVERIFY2(shape.problem.find("draws nothing") != std::string::npos, name);
        }
    }

    void butterfliesFillTheTopLeftAndTheBottomRight() {
        for (const char* name : {"bfr4000", "bfs4000"}) {
            const ShapeSketch region = shapeOf(name).region;
            QCOMPARE(region.contourCount(), std::size_t{2});
            QCOMPARE(model::boxOfPath(region.contour(0), true), (Box{{-2'000'000, 0}, {0, 2'000'000}}));
            QCOMPARE(model::boxOfPath(region.contour(1), true), (Box{{0, -2'000'000}, {2'000'000, 0}}));
        }
    }

    void diagonalGapsOfRectanglesLeaveThroughTheCorners() {
        for (const char* name : {"rc_ths6000x4000x45x4x500x1000", "rc_tho6000x4000x45x4x500x1000",
                                 "oblong_ths6000x4000x45x4x500x1000xs"}) {
            const ShapeSketch region = shapeOf(name).region;
            QCOMPARE(region.contourCount(), std::size_t{4});
            for (std::size_t i = 0; i < 4; ++i) {  // no piece goes round a corner
                const Box box = model::boxOfPath(region.contour(i), true);
                QVERIFY2(std::min(box.width(), box.height()) <= 1'000'001, name);
            }
        }
    }

    void openCornersLeaveStraightBars() {
        // Four bars, each from gap edge to gap edge: 2 mm inside less 2 × 0.5 / √2.
        const ShapeSketch open = shapeOf("s_tho4000x2000x45x4x500").region;
        QCOMPARE(open.contourCount(), std::size_t{4});
        const double bar = 2.0 - std::sqrt(2.0) * 0.5;
        QVERIFY(std::abs(areaOf(open) - 4 * bar * 1.0) < 1e-5);
        // With straight gaps the corners stay: four L's.
        QCOMPARE(shapeOf("s_tho4000x2000x0x4x500").region.contourCount(), std::size_t{4});
        QVERIFY(std::abs(areaOf(shapeOf("s_tho4000x2000x0x4x500").region) - (12 - 4 * 0.5)) < 1e-5);
        // s_thr: the same bars with round ends of diameter (OS - IS) / 2.
        const ShapeSketch lines = shapeOf("s_thr4000x2000x45x4x500").region;
        QVERIFY(std::abs(areaOf(lines) - 4 * (bar - 1.0 + kPi / 4)) < 0.01);
    }
};

QTEST_APPLESS_MAIN(StandardSymbolsTest)
#include "standard_symbols_test.moc"
