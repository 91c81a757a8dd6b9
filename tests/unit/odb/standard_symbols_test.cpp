#include "model/odb/standard_symbols.h"

#include <cmath>
#include <numbers>

#include "model/odb/region.h"
#include "odb_testing.h"

using model::Box;
using model::Point;
using model::ShapeSketch;
using model::odb::standardSymbol;
using model::odb::SymbolRef;
using model::odb::SymbolShape;
using model::odb::Unit;
using Kind = model::odb::SymbolShape::Kind;

namespace {

constexpr double kPi = std::numbers::pi;

SymbolShape shapeOf(const std::string& name, Unit unit = Unit::Millimetre, int resize = 0) {
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
    return static_cast<double>(model::twiceArea(model::odb::polygonsOf(sketch))) / 2e12;
}

}  // namespace

class StandardSymbolsTest : public QObject {
    Q_OBJECT

private slots:
    void simpleShapesNeedNoRegion() {
        const SymbolShape round = shapeOf("r100");
        QCOMPARE(round.kind, Kind::Round);
        QCOMPARE(round.width, 100'000);
        QCOMPARE(shapeOf("r100", Unit::Inch).width, 2'540'000);
        QCOMPARE(shapeOf("r1300.0").width, 1'300'000);
        QCOMPARE(shapeOf("r0").kind, Kind::Round);
        const SymbolShape ring = shapeOf("donut_r2000x1000.5");
        QCOMPARE(ring.kind, Kind::Ring);
        QCOMPARE(ring.width, 2'000'000);
        QCOMPARE(ring.height, 1'000'500);
        const SymbolShape oval = shapeOf("oval1200x400");
        QCOMPARE(oval.kind, Kind::Oval);
        QCOMPARE(oval.width, 1'200'000);
        QCOMPARE(oval.height, 400'000);
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
            const SymbolShape shape = shapeOf(name);
            QCOMPARE(shape.kind, Kind::Nothing);
            QVERIFY2(shape.problem.find("draws nothing") != std::string::npos, name);
        }
        for (const char* name : {"donut_r100x100", "donut_s100x200", "donut_sr10x11", "ths10x20x0x4x1"}) {
            QCOMPARE(shapeOf(name).kind, Kind::Nothing);
            QVERIFY2(shapeOf(name).problem.find("no area") != std::string::npos, name);
        }
        QVERIFY(shapeOf("s_thr4000x3000x45x4x500").problem.find("cannot be drawn yet") != std::string::npos);
        QCOMPARE(shapeOf("rect0x100").kind, Kind::Nothing);
        QVERIFY(shapeOf("rect0x100").problem.find("no area") != std::string::npos);
    }

    void aRingWithoutRoomForItsHoleIsADisc() {
        const SymbolShape shape = shapeOf("donut_r200.0x-25.0");
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
    }
    void regionsHaveTheirSizeAndArea() {
        QFETCH(QString, name);
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, area);
        const SymbolShape shape = shapeOf(name.toStdString());
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
        const auto polygons = model::odb::polygonsOf(shapeOf("ths4000x2000x90x1x500").region);
        int top = 0;
        int bottom = 0;
        for (const Point& point : polygons.points) {
            top += std::abs(point.x) < 200'000 && point.y > 0 ? 1 : 0;
            bottom += std::abs(point.x) < 200'000 && point.y < 0 ? 1 : 0;
        }
        QCOMPARE(top, 0);
        QVERIFY(bottom > 0);
    }

    void strokesCanUseStraightSidedConvexSymbols() {
        QVERIFY(shapeOf("s100").isSquarePen);
        QVERIFY(shapeOf("rect100x100").isSquarePen);
        QVERIFY(!shapeOf("rect100x200").isSquarePen);
        QCOMPARE(shapeOf("rect100x200").penCorners.size(), std::size_t{4});
        QCOMPARE(shapeOf("oct100x200x10").penCorners.size(), std::size_t{8});
        QVERIFY(shapeOf("rect100x200xr10").penCorners.empty());
        QVERIFY(shapeOf("donut_s100x50").penCorners.empty());
    }

    void resizingAddsToTheWholeSize() {
        QCOMPARE(shapeOf("r100", Unit::Millimetre, -40'000).width, 60'000);
        QCOMPARE(shapeOf("r100", Unit::Inch, 10'000).width, 2'550'000);
        QCOMPARE(boxOf(shapeOf("rect100x200", Unit::Millimetre, 50'000).region).height(), 250'000);
        QCOMPARE(shapeOf("r10", Unit::Millimetre, -40'000).kind, Kind::Nothing);
        QVERIFY(shapeOf("donut_r100x50", Unit::Millimetre, 10'000).problem.find("cannot be resized") !=
                std::string::npos);
    }

    void moireHasRingsAndACross() {
        const SymbolShape shape = shapeOf("moire100x200x3x50x2000x0");
        QCOMPARE(boxOf(shape.region).width(), 2'000'000);
        QCOMPARE(boxOf(shape.region).height(), 2'000'000);
        QVERIFY(areaOf(shape.region) > 0.0);
    }
};

QTEST_APPLESS_MAIN(StandardSymbolsTest)
#include "standard_symbols_test.moc"
