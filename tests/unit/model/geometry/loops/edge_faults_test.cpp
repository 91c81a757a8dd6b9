#include "model/geometry/loops/edge_faults.h"

#include <QtTest>
#include <vector>

using model::EdgeLoops;
using model::PointD;

namespace {

void addPolygon(EdgeLoops& loops, const std::vector<PointD>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        loops.addLine(points[i], points[(i + 1) % points.size()]);
    }
    loops.endLoop();
}

std::vector<PointD> corners(double x, double y, double size) {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

EdgeLoops loopsOf(const std::vector<std::vector<PointD>>& polygons) {
    EdgeLoops loops;
    for (const auto& points : polygons) {
        addPolygon(loops, points);
    }
    return loops;
}

/// A plate of 100 by 100 holes of 6 nm every 10 nm.
EdgeLoops sieve() {
    EdgeLoops loops = loopsOf({corners(0, 0, 1000)});
    for (int i = 0; i < 10'000; ++i) {
        addPolygon(loops, corners(2 + i % 100 * 10, 2 + i / 100 * 10, 6));
    }
    return loops;
}

QString faultOf(const EdgeLoops& loops) {
    const auto fault = model::findFault(loops);
    return fault ? QString::fromStdString(fault->what) : QString();
}

}  // namespace

class EdgeFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void faults_data() {
        QTest::addColumn<EdgeLoops>("loops");
        QTest::addColumn<QString>("fault");
        using Polygons = std::vector<std::vector<PointD>>;
        const auto row = [](const char* name, const Polygons& polygons, const char* fault) {
            QTest::newRow(name) << loopsOf(polygons) << QString(fault);
        };
        const std::vector<PointD> plate = corners(0, 0, 100);
        row("a square", {plate}, "");
        row("a square with holes", {plate, corners(10, 10, 20), corners(40, 10, 20)}, "");
        row("holes 2 nm apart", {plate, corners(10, 10, 20), corners(32, 10, 20)}, "");
        row("holes that share a side", {plate, corners(10, 10, 20), corners(30, 10, 20)},
            "two holes touch or cross each other");
        row("holes that share a corner", {plate, corners(10, 10, 20), corners(30, 30, 20)},
            "two holes touch or cross each other");
        row("a hole on the outline", {plate, corners(0, 10, 20)}, "a hole touches or crosses the outline");
        row("a hole over the outline", {plate, corners(-10, 10, 20)}, "a hole touches or crosses the outline");
        row("a hole outside", {plate, corners(200, 10, 20)}, "a hole lies outside the outline or in another hole");
        row("a hole in a hole", {plate, corners(10, 10, 80), corners(20, 20, 20)},
            "a hole lies outside the outline or in another hole");
        row("a bow tie", {{{0, 0}, {90, 90}, {90, 0}, {0, 60}}}, "the outline touches or crosses itself");
        row("a pinch", {{{0, 0}, {90, 0}, {45, 45}, {90, 90}, {0, 90}, {45, 45}}},
            "the outline touches or crosses itself");
        row("a spike", {{{0, 0}, {90, 0}, {90, 90}, {50, 90}, {50, 200}, {50, 90}, {0, 90}}},
            "the outline touches or crosses itself");
        row("a side that folds back", {{{0, 0}, {90, 0}, {60, 0}, {45, 90}}}, "neighbouring edges fold back");
        row("a hole that pinches itself", {plate, {{10, 10}, {90, 10}, {50, 50}, {90, 90}, {10, 90}, {50, 50}}},
            "a hole touches or crosses itself");
    }
    void faults() {
        QFETCH(EdgeLoops, loops);
        QTEST(faultOf(loops), "fault");
    }

    void roundOnes() {
        EdgeLoops loops;
        loops.addCapsule({0, 0}, {3e5, 4e5}, 5e4);
        QCOMPARE(faultOf(loops), QString());
        loops.addCapsule({0, 0}, {3e5, 4e5}, 4e4);
        QCOMPARE(faultOf(loops), QString());
        loops.addCircle({3e5, 4e5}, 4e4);
        QCOMPARE(faultOf(loops), QString("two holes touch or cross each other"));
        EdgeLoops ring;
        ring.addCircle({0, 0}, 1e5);
        ring.addCircle({4e4, 0}, 6e4);
        QCOMPARE(faultOf(ring), QString("a hole touches or crosses the outline"));
    }

    void neighboursThatMeetAgain() {
        EdgeLoops loops;  // the arc runs round below the line it came from
        loops.addLine({0, 0}, {1e5, 0});
        loops.addArc({1e5, 0}, {0, 1e5}, {0, 0}, false);
        loops.addLine({0, 1e5}, {0, 0});
        loops.endLoop();
        QCOMPARE(faultOf(loops), QString());
        EdgeLoops crossing;
        crossing.addLine({-2e5, 0}, {1e5, 0});
        crossing.addArc({1e5, 0}, {0, -1e5}, {0, 0}, false);
        crossing.addLine({0, -1e5}, {-2e5, 0});
        crossing.endLoop();
        const auto fault = model::findFault(crossing);
        QVERIFY(fault.has_value());
        QCOMPARE(fault->what, std::string("neighbouring edges cross each other"));
        QCOMPARE(fault->at, (PointD{-1e5, 0}));
    }

    void openLoops() {
        EdgeLoops loops = loopsOf({corners(0, 0, 100)});
        loops.edges[2].b.x += 1e-9;
        QCOMPARE(faultOf(loops), QString("a loop is not closed"));
    }

    void cuspsAreNone() {
        EdgeLoops loops;  // a line that is tangent to the arc it comes back to
        loops.addLine({0, 0}, {3e5, 0});
        loops.addLine({3e5, 0}, {1e5, 1e5});
        loops.addArc({1e5, 1e5}, {0, 0}, {0, 1e5}, true);
        loops.endLoop();
        QCOMPARE(faultOf(loops), QString());
    }

    void manyHoles() {
        EdgeLoops loops = sieve();
        QCOMPARE(loops.loopCount(), 10'001U);
        QCOMPARE(faultOf(loops), QString());
        addPolygon(loops, corners(55, 55, 1));
        QCOMPARE(faultOf(loops), QString("a hole lies outside the outline or in another hole"));
    }

    void simpleOnesCostLittle() {
        EdgeLoops loops;
        loops.addCapsule({0, 0}, {3e5, 4e5}, 5e4);
        int found = 0;
        QBENCHMARK {
            found += model::findFault(loops) ? 1 : 0;
        }
        QCOMPARE(found, 0);
    }
};

QTEST_APPLESS_MAIN(EdgeFaultsTest)
#include "edge_faults_test.moc"
