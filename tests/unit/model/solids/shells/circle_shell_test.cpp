#include "model/solids/shells/circle_shell.h"

#include <QtTest>

#include "model/geometry/loops/edge_faults.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"

using namespace edge_loop_checks;
using model::EdgeLoops;

class CircleShellTest : public QObject {
    Q_OBJECT

private slots:
    void discs() {
        const EdgeLoops disc = model::circleOutline({{7, -3}, 200'001, 0});
        QVERIFY(areSound(disc) && !model::findFault(disc));
        QCOMPARE(disc.edges.size(), 1U);
        QVERIFY(disc.edges.front().isFullCircle());
        QVERIFY(relative(model::areaOf(disc), kPi / 4 * 200'001.0 * 200'001.0) < 1e-14);
    }

    void rings() {
        const EdgeLoops ring = model::circleOutline({{7, -3}, 200'000, 150'000});
        QVERIFY(areSound(ring) && !model::findFault(ring));
        QCOMPARE(ring.loopCount(), 2U);
        QVERIFY(relative(model::areaOf(ring), kPi * (1e10 - 75e2 * 75e4)) < 1e-14);
    }

    void nothingIsLeft() {
        QCOMPARE(model::circleOutline({{0, 0}, 0, 0}).loopCount(), 0U);
        QCOMPARE(model::circleOutline({{0, 0}, -2, 0}).loopCount(), 0U);
        QCOMPARE(model::circleOutline({{0, 0}, 300, 300}).loopCount(), 0U);  // NPTH
        QCOMPARE(model::circleOutline({{0, 0}, 300, 400}).loopCount(), 0U);
    }
};

QTEST_APPLESS_MAIN(CircleShellTest)
#include "circle_shell_test.moc"
