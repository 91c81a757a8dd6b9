// What is straight or round under a cursor, and angles of lines.
#include "model/measure/edge_at.h"

#include <QtTest>
#include <cmath>

#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

namespace {

constexpr double kReach = 100'000.0;

bool isAt(PointD a, double x, double y) {
    return std::hypot(a.x - x, a.y - y) < 1e-3;
}

Edge straight(PointD a, PointD b) {
    Edge edge;
    edge.a = a;
    edge.b = b;
    return edge;
}

}  // namespace

class EdgeAtTest : public QObject {
    Q_OBJECT

private slots:
    void discsHolesAndRingsAreRoundWhereverTheyAreClicked() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId disc = builder.addCircle({{0, 0}, 2 * kMm, 0}, of({}, kPad));
        const ElementId ring = builder.addCircle({{9 * kMm, 0}, 4 * kMm, 2 * kMm}, {});
        builder.beginLayer(LayerId{Drill});
        const ElementId hole = builder.addCircle({{20 * kMm, 0}, kMm, 800'000}, of({}, kHole | kPlated));
        const auto index = indexed(builder.finish());
        const auto at = [&](ElementId id, PointD location) { return roundAt(*index, {0, id}, location, kReach); };
        QCOMPARE(at(disc, {0, 0})->radius, 1e6);
        QVERIFY(isAt(at(disc, {0, 0})->centre, 0, 0));
        QVERIFY(isAt(at(disc, {3e5, 4e5})->on, 6e5, 8e5));
        QCOMPARE(at(ring, {9e6 + 1.1e6, 0})->radius, 1e6);  // the inner edge is nearer
        QCOMPARE(at(ring, {9e6 + 1.9e6, 0})->radius, 2e6);
        QCOMPARE(at(hole, {20e6, 1e5})->radius, 5e5);
        QVERIFY(!straightAt(*index, {0, disc}, {0, 0}, kReach));
    }

    void arcsAreRoundAndLinesStraightNearby() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId arc =
            builder.addArc({PathNode{{kMm, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, {0, kMm}, 100'000}, {});
        const ElementId line = builder.addLine({{0, 0}, {3 * kMm, 4 * kMm}, 200'000, 0}, {});
        const ElementId area = builder.addArea({builder.addShape(rectangle({0, 0}, {5 * kMm, kMm})), {}}, {});
        const ElementId dot = builder.addLine({{0, 0}, {0, 0}, 200'000, 0}, {});
        const ElementId hairline = builder.addLine({{0, 0}, {kMm, 0}, 0, 0}, {});
        const auto index = indexed(builder.finish());
        const double half = std::sqrt(0.5) * 1e6;
        const auto round = roundAt(*index, {0, arc}, {half * 1.04, half * 1.04}, kReach);
        QVERIFY(round && isAt(round->centre, 0, 0) && isAt(round->on, half, half));
        QCOMPARE(round->radius, 1e6);
        QVERIFY(!straightAt(*index, {0, arc}, {half, half}, kReach));
        QVERIFY(!roundAt(*index, {0, line}, {1.5e6, 2e6}, kReach));
        const auto middle = straightAt(*index, {0, line}, {1.5e6, 2e6}, kReach);
        QVERIFY(middle && isAt(middle->a, 0, 0) && isAt(middle->b, 3e6, 4e6));
        const auto side = straightAt(*index, {0, area}, {2e6, 9.5e5}, kReach);
        QVERIFY(side && side->a.y == 1e6 && side->b.y == 1e6);
        QVERIFY(!straightAt(*index, {0, area}, {2e6, 5e5}, kReach));  // in the middle of it
        QVERIFY(!straightAt(*index, {0, dot}, {0, 0}, kReach));
        QVERIFY(!straightAt(*index, {0, hairline}, {0, 0}, kReach));  // it covers nothing
    }

    void endsOfTracksAndOvalPadsAreRound() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId track = builder.addLine({{0, 0}, {4 * kMm, 0}, kMm, 0}, {});
        const ElementId oval = builder.addLine({{0, 9 * kMm}, {2 * kMm, 9 * kMm}, kMm, 0}, of({}, kPad));
        const auto index = indexed(builder.finish());
        const auto at = [&](ElementId id, PointD location) { return roundAt(*index, {0, id}, location, kReach); };
        const auto end = at(track, {4.3e6, 0});
        QVERIFY(end && isAt(end->centre, 4e6, 0) && isAt(end->on, 4.5e6, 0));
        QCOMPARE(end->radius, 5e5);
        QVERIFY(!at(track, {3.7e6, 0}));
        QVERIFY(isAt(at(oval, {1.4e6, 9e6})->centre, 2e6, 9e6));
        QVERIFY(isAt(at(oval, {-0.1e6, 9e6})->centre, 0, 9e6));
    }

    void linesCrossWhereTheyWouldMeet() {
        const Edge flat = straight({0, 0}, {1e6, 0});
        QVERIFY(isAt(*linesCross(flat, straight({5e6, 1e6}, {5e6, 2e6})), 5e6, 0));
        QVERIFY(isAt(*linesCross(straight({-1e6, -1e6}, {-2e6, -2e6}), straight({1e6, -1e6}, {0, 0})), 0, 0));
        QVERIFY(!linesCross(flat, straight({0, 1e6}, {3e6, 1e6})));
        QVERIFY(!linesCross(flat, flat));
        QVERIFY(!linesCross(flat, straight({0, 1e9}, {1e6, 1e9 + 1})));  // a thousand kilometres away
    }

    void anglesAreBetweenDirections() {
        QCOMPARE(angleDeg({1, 0}, {0, 5}), 90.0);
        QCOMPARE(angleDeg({0, 5}, {1, 0}), 90.0);
        QCOMPARE(angleDeg({1, 0}, {-1, 0}), 180.0);
        QCOMPARE(angleDeg({2, 2}, {1, 1}), 0.0);
        QVERIFY(std::abs(angleDeg({1, 0}, {-1, 1}) - 135.0) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(EdgeAtTest)
#include "edge_at_test.moc"
