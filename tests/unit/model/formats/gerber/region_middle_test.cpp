#include "model/formats/gerber/region_middle.h"

#include <QtTest>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/geometry/outlines.h"

using model::PointD;

namespace {

/// A pad drawn around 3 mm, 4 mm, rotated.
model::ShapeSketch pad(std::vector<PointD> corners, double degrees) {
    const double turn = degrees * std::numbers::pi / 180.0;
    for (PointD& p : corners) {
        p = {3e6 + p.x * std::cos(turn) - p.y * std::sin(turn), 4e6 + p.x * std::sin(turn) + p.y * std::cos(turn)};
    }
    model::ShapeSketch sketch;
    addLoop(sketch, corners, false);
    return sketch;
}

}  // namespace

class RegionMiddleTest : public QObject {
    Q_OBJECT

private slots:
    /// Where the box around the pad has its middle elsewhere unless the pad lies along the axes.
    void padsHaveTheirOwnMiddle_data() {
        QTest::addColumn<std::vector<PointD>>("corners");
        QTest::newRow("trapezoid") << std::vector<PointD>{
            {-0.95e6, -0.8e6}, {0.95e6, -0.8e6}, {0.65e6, 0.8e6}, {-0.65e6, 0.8e6}};
        QTest::newRow("rectangle with a chamfer")
            << std::vector<PointD>{{-1e6, -0.5e6}, {1e6, -0.5e6}, {1e6, 0.1e6}, {0.6e6, 0.5e6}, {-1e6, 0.5e6}};
    }
    void padsHaveTheirOwnMiddle() {
        QFETCH(std::vector<PointD>, corners);
        for (const double degrees : {0.0, 30.0, 45.0, 90.0, 137.0}) {
            const model::Point middle = model::gerber::middleOfPad(pad(corners, degrees));
            QVERIFY(std::abs(middle.x - 3'000'000) <= 2 && std::abs(middle.y - 4'000'000) <= 2);
        }
    }

    void aShapeWithoutAnAxisLiesInItsBox() {
        const model::ShapeSketch triangle = pad({{-1e6, -1e6}, {1e6, -1e6}, {-1e6, 1e6}}, 0.0);
        QCOMPARE(model::gerber::middleOfPad(triangle), (model::Point{3'000'000, 4'000'000}));
        QCOMPARE(model::gerber::middleOfPad({}), model::Point());
    }

    void arcsCountAsTheyAre() {
        model::ShapeSketch oval;
        addCapsule(oval, {1e6, 1e6}, {2e6, 3e6}, 0.5e6);
        const model::Point middle = model::gerber::middleOfPad(oval);
        QVERIFY(std::abs(middle.x - 1'500'000) <= 1'000 && std::abs(middle.y - 2'000'000) <= 1'000);
    }
};

QTEST_APPLESS_MAIN(RegionMiddleTest)
#include "region_middle_test.moc"
