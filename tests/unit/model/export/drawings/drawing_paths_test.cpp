#include "model/export/drawings/drawing_paths.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/geometry/loops/edge_loops.h"
#include "model/geometry/vectors.h"

using model::Edge;
using model::PointD;

namespace {

Edge arc(double radius, double from, double sweep) {
    Edge edge;
    edge.radius = radius;
    edge.centre = {7.0, -3.0};
    edge.a = {7.0 + radius * std::cos(from), -3.0 + radius * std::sin(from)};
    edge.b = {7.0 + radius * std::cos(from + sweep), -3.0 + radius * std::sin(from + sweep)};
    edge.isClockwise = sweep < 0;
    return edge;
}

PointD on(const model::Curve& curve, double t) {
    const double u = 1 - t;
    const double k[4] = {u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t};
    return {k[0] * curve.a.x + k[1] * curve.control1.x + k[2] * curve.control2.x + k[3] * curve.b.x,
            k[0] * curve.a.y + k[1] * curve.control1.y + k[2] * curve.control2.y + k[3] * curve.b.y};
}

}  // namespace

class DrawingPathsTest : public QObject {
    Q_OBJECT

private slots:
    void lengthsAreMillimetres() {
        std::string mm = "x";
        model::appendMm(mm, 1'234'567.5);
        QCOMPARE(mm, std::string("x1.2345675"));
    }

    void sweepsHaveASign() {
        for (const double sweep : {0.1, 1.0, 3.0, 3.3, 6.2, -0.1, -3.3, -6.2}) {
            QVERIFY(std::abs(model::sweepOf(arc(1e6, 0.3, sweep)) - sweep) < 1e-9);
        }
        model::EdgeLoops circle;
        circle.addCircle({0, 0}, 5.0);
        QCOMPARE(model::sweepOf(circle.edges[0]), 2 * std::numbers::pi);
    }

    void piecesFollowEachOtherOnTheCircle() {
        const Edge whole = arc(2e6, 1.0, -5.0);
        const std::vector<Edge> pieces = model::shortPiecesOf(whole, std::numbers::pi);
        QCOMPARE(pieces.size(), std::size_t{2});
        QVERIFY(pieces[0].a == whole.a && pieces[0].b == pieces[1].a && pieces[1].b == whole.b);
        QVERIFY(std::abs(model::distance(pieces[0].b, whole.centre) - 2e6) < 1e-6);
        QVERIFY(std::abs(model::sweepOf(pieces[1]) + 2.5) < 1e-9);
        QCOMPARE(model::shortPiecesOf(arc(2e6, 1.0, std::numbers::pi), std::numbers::pi).size(), std::size_t{1});
        Edge line = whole;
        line.radius = 0.0;
        QCOMPARE(model::shortPiecesOf(line, 1.0).size(), std::size_t{1});
    }

    /// Also where radii are large.
    void curvesStayWithinTenNanometres() {
        for (const double radius : {5e4, 1e6, 5e7, 5e8}) {
            for (const double sweep : {0.01, 1.5, 3.2, -6.1}) {
                const Edge edge = arc(radius, 0.7, sweep);
                const std::vector<model::Curve> curves = model::curvesOf(edge);
                QVERIFY(curves.front().a == edge.a && curves.back().b == edge.b);
                for (const model::Curve& curve : curves) {
                    for (double t = 0.0; t <= 1.0; t += 0.0625) {
                        QVERIFY(std::abs(model::distance(on(curve, t), edge.centre) - radius) <= 10.0);
                    }
                }
            }
        }
        QCOMPARE(model::curvesOf(arc(5e4, 0.0, std::numbers::pi / 2)).size(), std::size_t{2});
    }
};

QTEST_GUILESS_MAIN(DrawingPathsTest)
#include "drawing_paths_test.moc"
