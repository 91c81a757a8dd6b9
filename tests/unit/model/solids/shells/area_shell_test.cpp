#include "model/solids/shells/area_shell.h"

#include <QtTest>

#include "model/geometry/outlines.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"

using namespace edge_loop_checks;
using model::EdgeLoops;
using model::Point;
using model::ShapeSketch;

namespace {

std::vector<EdgeLoops> outlinesOf(const ShapeSketch& sketch) {
    model::ShapeTable shapes;
    return model::areaOutlines(shapes, shapes.add(sketch));
}

}  // namespace

class AreaShellTest : public QObject {
    Q_OBJECT

private slots:
    void arcsStayArcs() {
        ShapeSketch sketch;
        model::addCornerBox(sketch, 1'000'000, 600'000, 100'000, model::kAllCorners, model::CornerStyle::Rounded,
                            false);
        const std::vector<EdgeLoops> regions = outlinesOf(sketch);
        QCOMPARE(regions.size(), 1U);
        QVERIFY(areSound(regions.front()));
        QCOMPARE(regions.front().edges.size(), 8U);
        QVERIFY(relative(model::areaOf(regions.front()), 6e11 - (4 - kPi) * 1e10) < 1e-9);
    }

    /// Contours wind as they like in a job.
    void holesBelongToTheIslandBeforeThem() {
        ShapeSketch sketch;
        sketch.addPolygon(std::vector<Point>{{0, 0}, {0, 90}, {90, 90}, {90, 0}}, false);
        sketch.addPolygon(std::vector<Point>{{10, 10}, {20, 10}, {20, 20}, {10, 20}}, true);
        sketch.addCircle({60, 60}, 10, true);
        sketch.addCircle({200, 60}, 10, false);
        const std::vector<EdgeLoops> regions = outlinesOf(sketch);
        QCOMPARE(regions.size(), 2U);
        QVERIFY(areSound(regions[0]) && areSound(regions[1]));
        QCOMPARE(regions[0].loopCount(), 3U);
        QVERIFY(relative(model::areaOf(regions[0]), 8100 - 100 - kPi * 100) < 1e-12);
        QVERIFY(relative(model::areaOf(regions[1]), kPi * 100) < 1e-12);
    }

    void whatHasNoAreaIsLeftOut() {
        ShapeSketch sketch;
        sketch.addPolygon(std::vector<Point>{{0, 0}, {50, 0}}, false);
        sketch.addPolygon(std::vector<Point>{{10, 0}, {20, 0}, {20, 5}}, true);  // of nothing
        QVERIFY(outlinesOf(sketch).empty());
        sketch.addPolygon(std::vector<Point>{{0, 0}, {50, 0}, {0, 50}}, false);
        QCOMPARE(outlinesOf(sketch).size(), 1U);
        QCOMPARE(outlinesOf(sketch).front().loopCount(), 1U);
    }
};

QTEST_APPLESS_MAIN(AreaShellTest)
#include "area_shell_test.moc"
