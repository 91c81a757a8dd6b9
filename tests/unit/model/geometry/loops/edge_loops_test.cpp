#include "model/geometry/loops/edge_loops.h"

#include <QtTest>

#include "tests/unit/model/geometry/edge_loop_checks.h"

using namespace edge_loop_checks;
using model::Edge;
using model::EdgeLoops;
using model::Placement;
using model::PointD;

namespace {

/// An L with one round corner and a round hole.
EdgeLoops bracket() {
    EdgeLoops loops;
    loops.addLine({0, 0}, {9e5, 0});
    loops.addLine({9e5, 0}, {9e5, 3e5});
    loops.addLine({9e5, 3e5}, {3e5, 3e5});
    loops.addLine({3e5, 3e5}, {3e5, 8e5});
    loops.addArc({3e5, 8e5}, {2e5, 9e5}, {2e5, 8e5}, false);
    loops.addLine({2e5, 9e5}, {0, 9e5});
    loops.addLine({0, 9e5}, {0, 0});
    loops.endLoop();
    loops.addCircle({15e4, 15e4}, 1e5);
    return loops;
}

constexpr double kBracket = 81e10 - 36e10 - (1 - kPi / 4) * 1e10 - kPi * 1e10;

}  // namespace

class EdgeLoopsTest : public QObject {
    Q_OBJECT

private slots:
    void areas() {
        QVERIFY(areSound(bracket()));
        QCOMPARE(bracket().loopCount(), 2U);
        QVERIFY(relative(model::areaOf(bracket()), kBracket) < 1e-14);
        const double polygons = edge_loop_checks::areaOf(polygonsOf(bracket(), 10.0));
        QVERIFY(std::abs(polygons - kBracket) < 10.0 * lengthOf(bracket()));
    }

    void loopsWindAsTheirPlaceDemands() {
        EdgeLoops loops;
        for (const double size : {9e5, 1e5}) {
            for (const bool isClockwise : {false, true}) {
                const PointD a{size, 0};
                const PointD b{-size, 0};
                loops.addArc(a, b, {0, 0}, isClockwise);
                loops.addArc(b, a, {0, 0}, isClockwise);
                QVERIFY(loops.endLoop());
                QVERIFY(windAsTheyMust(loops));
            }
        }
        QCOMPARE(loops.loopCount(), 4U);
        QVERIFY(areSound(loops));
    }

    void capsules() {
        for (const PointD to :
             {PointD{1e6, 0}, PointD{0, -7e5}, PointD{3e5, 4e5}, PointD{-1, 1}, PointD{123'457, -7}}) {
            EdgeLoops loops;
            loops.addCapsule({0, 0}, to, 5e4);
            QVERIFY(areSound(loops));
            QCOMPARE(loops.edges.size(), 4U);
            QVERIFY(relative(model::areaOf(loops), std::hypot(to.x, to.y) * 1e5 + kPi * 25e8) < 1e-12);
        }
        EdgeLoops dot;
        dot.addCapsule({5, 5}, {5, 5}, 100);
        QCOMPARE(dot.edges.size(), 1U);
        QVERIFY(dot.edges.front().isFullCircle());
    }

    void whatHasNoAreaIsLeftOut() {
        EdgeLoops loops;
        loops.addLine({1, 1}, {1, 1});
        QVERIFY(!loops.endLoop());
        loops.addLine({0, 0}, {9, 0});
        loops.addLine({9, 0}, {0, 0});
        QVERIFY(!loops.endLoop());
        loops.addArc({5, 0}, {5, 0}, {0, 0}, false);
        QVERIFY(!loops.endLoop());
        QCOMPARE(loops.loopCount(), 0U);
        QVERIFY(loops.edges.empty());
        QCOMPARE(model::areaOf(loops), 0.0);
    }

    /// Jobs write ends on the grid: the two radii differ.
    void arcsWithTwoRadiiAreTrueCircles() {
        for (const PointD end : {PointD{0, 100'003}, PointD{-99'998, 0}, PointD{70'712, -70'709}}) {
            for (const bool isClockwise : {false, true}) {
                EdgeLoops loops;
                loops.addArc({100'000, 0}, end, {0, 0}, isClockwise);
                QCOMPARE(loops.edges.size(), 1U);
                QVERIFY(areTrueCircles(loops));
                QCOMPARE(loops.edges.front().a, (PointD{100'000, 0}));
                QCOMPARE(loops.edges.front().b, end);
                QVERIFY(model::length(loops.edges.front().centre) < 10.0);
            }
        }
    }

    /// Where moving the centre would take it far, a short line ends the arc.
    void nearlyFullCirclesEndByALine() {
        EdgeLoops loops;
        loops.addArc({100'000, 0}, {100'003, -30}, {0, 0}, false);
        QCOMPARE(loops.edges.size(), 2U);
        QVERIFY(!loops.edges[1].isArc());
        QVERIFY(areTrueCircles(loops));
        QCOMPARE(loops.edges[0].b, loops.edges[1].a);
        QCOMPARE(loops.edges[1].b, (PointD{100'003, -30}));
    }

    void placed_data() {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<bool>("isMirrored");
        for (const double degrees : {0.0, 90.0, 180.0, 270.0, 33.3}) {
            for (const bool isMirrored : {false, true}) {
                QTest::addRow("%g %s", degrees, isMirrored ? "mirrored" : "") << degrees << isMirrored;
            }
        }
    }
    void placed() {
        QFETCH(double, degrees);
        QFETCH(bool, isMirrored);
        const Placement placement{{123'456, -7}, degrees, isMirrored};
        const EdgeLoops loops = model::placed(bracket(), placement);
        QVERIFY(areSound(loops));
        QVERIFY(relative(model::areaOf(loops), kBracket) < 1e-12);
        const PointD corner = placement.apply(PointD{9e5, 3e5});
        QVERIFY(std::ranges::any_of(loops.edges, [&](const Edge& edge) { return edge.a == corner; }));
    }

    void boxes() {
        EdgeLoops loops;
        QVERIFY(model::boxOf(loops).isEmpty());
        loops.addCapsule({0, 0}, {3e5, 4e5}, 5e4);
        const model::Box box = model::boxOf(loops);
        QCOMPARE(box.min, (model::Point{-50'000, -50'000}));
        QCOMPARE(box.max, (model::Point{350'000, 450'000}));
    }

    void reversedTwiceIsTheSame() {
        const Edge arc = bracket().edges[4];
        QCOMPARE(model::reversed(arc).a, arc.b);
        QVERIFY(model::reversed(arc).isClockwise);
        QCOMPARE(model::reversed(model::reversed(arc)).b, arc.b);
        QCOMPARE(model::lengthOf(model::reversed(arc)), model::lengthOf(arc));
    }

    void curvesStayWhatTheyAreHoweverARegionIsTurned() {
        EdgeLoops loops;
        const model::Nurbs bow{2, {0, 0, 0, 1, 1, 1}, {{{0, 0}, 1}, {{5e5, 2e6}, 0.7}, {{1e6, 0}, 1}}};
        loops.addCurve(bow.view());  // clockwise, so that the loop is turned round
        loops.addLine({1e6, 0}, {0, 0});
        QVERIFY(loops.endLoop());
        QCOMPARE(loops.curves.size(), std::size_t{1});
        const auto check = [](const EdgeLoops& region) {
            const EdgeLoops::CurveRun& run = region.curves.front();
            QVERIFY(model::curveAt(region, run.firstEdge) == &run);
            const model::NurbsView curve = run.curve.view();
            QVERIFY(model::faultIn(curve).empty());
            const auto isAt = [](model::PointD p, model::PointD q) { return std::hypot(p.x - q.x, p.y - q.y) < 1e-6; };
            QVERIFY(isAt(model::pointOn(curve, curve.from()), region.edges[run.firstEdge].a));
            QVERIFY(isAt(model::pointOn(curve, curve.to()), region.edges[run.firstEdge + run.edgeCount - 1].b));
            const model::PointD middle = model::pointOn(curve, (curve.from() + curve.to()) / 2);
            double nearest = 1e9;
            for (std::uint32_t i = run.firstEdge; i < run.firstEdge + run.edgeCount; ++i) {
                const model::PointD on = model::nearestOn(region.edges[i], middle);
                nearest = std::min(nearest, std::hypot(on.x - middle.x, on.y - middle.y));
            }
            QVERIFY(nearest < 0.3);
        };
        check(loops);
        check(model::placed(loops, {{1'000, 2'000}, 30.0, true}));
        loops.addCurve(bow.view());
        QVERIFY(!loops.endLoop() || loops.loopCount() == 2);
    }
};

QTEST_APPLESS_MAIN(EdgeLoopsTest)
#include "edge_loops_test.moc"
