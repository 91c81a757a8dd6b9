#include "model/geometry/edges.h"

#include <QtTest>
#include <numbers>

using model::Edge;
using model::PointD;

namespace {

/// A quarter circle of 1 mm about the origin, from the right to the top or back.
Edge quarter(bool isClockwise) {
    Edge edge;
    edge.a = isClockwise ? PointD{0, 1e6} : PointD{1e6, 0};
    edge.b = isClockwise ? PointD{1e6, 0} : PointD{0, 1e6};
    edge.centre = {0, 0};
    edge.radius = 1e6;
    edge.isClockwise = isClockwise;
    return edge;
}

PointD atDegrees(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {1e6 * std::cos(angle), 1e6 * std::sin(angle)};
}

}  // namespace

class EdgesTest : public QObject {
    Q_OBJECT

private slots:
    void lengthsRunInTheSenseOfTheArc() {
        const double full = std::numbers::pi / 2.0 * 1e6;
        for (const bool isClockwise : {false, true}) {
            const Edge edge = quarter(isClockwise);
            QVERIFY(std::abs(model::lengthOf(edge) - full) < 1e-3);
            const double third = model::lengthTo(edge, atDegrees(30));
            QVERIFY(std::abs(third - (isClockwise ? full * 2.0 / 3.0 : full / 3.0)) < 1e-3);
        }
    }

    /// Points on arcs are rounded, to either side of the ends.
    void pointsBesideAnEndAreAtThatEnd() {
        constexpr double kLittle = 1e-9;  // degrees
        for (const bool isClockwise : {false, true}) {
            const Edge edge = quarter(isClockwise);
            const double full = model::lengthOf(edge);
            const double atRight = isClockwise ? full : 0.0;
            for (const double beside : {-kLittle, 0.0, kLittle}) {
                QVERIFY(std::abs(model::lengthTo(edge, atDegrees(beside)) - atRight) < 1e-3);
                QVERIFY(std::abs(model::lengthTo(edge, atDegrees(90 + beside)) - (full - atRight)) < 1e-3);
            }
        }
    }

    void fullCirclesGoAllTheWay() {
        Edge edge = quarter(false);
        edge.b = edge.a;
        QVERIFY(edge.isFullCircle());
        QVERIFY(std::abs(model::lengthOf(edge) - 2.0 * std::numbers::pi * 1e6) < 1e-3);
        QVERIFY(std::abs(model::lengthTo(edge, atDegrees(270)) - 1.5 * std::numbers::pi * 1e6) < 1e-3);
    }
};

QTEST_APPLESS_MAIN(EdgesTest)
#include "edges_test.moc"
