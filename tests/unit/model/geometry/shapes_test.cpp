#include "model/geometry/shapes.h"

#include <QtTest>
#include <cmath>
#include <numbers>
#include <random>

using model::Box;
using model::EdgeKind;
using model::PathNode;
using model::Placement;
using model::Point;

class ShapesTest : public QObject {
    Q_OBJECT

private slots:
    void quarterTurnsAreExactAndClockwise() {
        const Point p{1000, 300};
        QVERIFY((Placement{{}, 90.0, false}.apply(p) == Point{300, -1000}));
        QVERIFY((Placement{{}, 180.0, false}.apply(p) == Point{-1000, -300}));
        QVERIFY((Placement{{}, 270.0, false}.apply(p) == Point{-300, 1000}));
        QVERIFY((Placement{{}, -90.0, false}.apply(p) == Point{-300, 1000}));
        QVERIFY((Placement{{}, 450.0, false}.apply(p) == Point{300, -1000}));
    }

    /// Files may say any number of degrees.
    void manyTurnsAreAsGoodAsNone() {
        for (const double turns : {1e3, -1e3, 1e12}) {
            QCOMPARE((Placement{{5, 5}, 360.0 * turns + 90.0, false}.apply(Point{10, 0})), (Point{5, -5}));
        }
        const Point far = Placement{{5, 5}, 9e108, false}.apply(Point{10, 0});
        QVERIFY(std::abs(far.x) <= 15 && std::abs(far.y) <= 15);
    }

    void mirrorComesAfterRotation() {
        // Clockwise by 90° takes (1000, 300) to (300, -1000); the mirror then turns x around.
        QVERIFY((Placement{{5, 7}, 90.0, true}.apply(Point{1000, 300}) == Point{5 - 300, 7 - 1000}));
    }

    void chainedPlacementsEqualOneAfterTheOther() {
        std::mt19937 random(7);
        const auto any = [&] { return static_cast<int>(random() % 2'000'001U) - 1'000'000; };
        for (int round = 0; round < 200; ++round) {
            const Placement outer{{any(), any()}, any() / 1000.0, (random() & 1U) != 0};
            const Placement inner{{any(), any()}, any() / 1000.0, (random() & 1U) != 0};
            const model::PointD p{any() * 1.0, any() * 1.0};
            const model::PointD twice = outer.apply(inner.apply(p));
            const model::PointD once = outer.after(inner).apply(p);
            // The inner origin is rounded to the grid when it is moved: at most half a nanometre per axis.
            QVERIFY(std::hypot(twice.x - once.x, twice.y - once.y) < 1.0);
        }
    }

    void boxOfAnArcHoldsItAndTouchesIt() {
        std::mt19937 random(3);
        for (int round = 0; round < 500; ++round) {
            const double radius = 1000.0 + static_cast<double>(random() % 1'000'000U);
            const double from = static_cast<double>(random() % 6283U) / 1000.0;
            const double to = static_cast<double>(random() % 6283U) / 1000.0;
            const Point centre{static_cast<int>(random() % 1000U), -static_cast<int>(random() % 1000U)};
            const auto at = [&](double angle) {
                return Point{static_cast<int>(std::lround(centre.x + radius * std::cos(angle))),
                             static_cast<int>(std::lround(centre.y + radius * std::sin(angle)))};
            };
            const bool isClockwise = (random() & 1U) != 0;
            const PathNode node{at(from), centre, isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise};
            const Box box = model::boxOfEdge(node, at(to));
            double sweep = isClockwise ? from - to : to - from;
            while (sweep <= 0) {
                sweep += 2 * std::numbers::pi;
            }
            Box sampled;
            for (int i = 0; i <= 20000; ++i) {
                const double t = sweep * i / 20000.0;
                sampled.include(at(isClockwise ? from - t : from + t));
            }
            const auto isNear = [&](model::Nm exact, model::Nm seen) {
                return std::abs(exact - seen) <= 1 + radius * 2e-7;
            };
            QVERIFY(isNear(box.min.x, sampled.min.x) && isNear(box.min.y, sampled.min.y));
            QVERIFY(isNear(box.max.x, sampled.max.x) && isNear(box.max.y, sampled.max.y));
        }
    }

    void equalEndsAreAFullCircle() {
        const PathNode node{{100, 0}, {0, 0}, EdgeKind::ArcClockwise};
        QVERIFY((model::boxOfEdge(node, node.point) == Box{{-100, -100}, {100, 100}}));
    }
};

QTEST_APPLESS_MAIN(ShapesTest)
#include "shapes_test.moc"
