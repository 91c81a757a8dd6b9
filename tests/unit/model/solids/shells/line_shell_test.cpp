#include "model/solids/shells/line_shell.h"

#include <QtTest>

#include "model/geometry/loops/edge_faults.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"

using namespace edge_loop_checks;
using model::EdgeLoops;
using model::LineGeometry;
using model::Point;

class LineShellTest : public QObject {
    Q_OBJECT

private slots:
    void roundPens_data() {
        QTest::addColumn<Point>("end");
        QTest::newRow("along x") << Point{1'000'000, 0};
        QTest::newRow("slanted") << Point{300'001, -400'003};
        QTest::newRow("1 nm") << Point{0, 1};
        QTest::newRow("a dot") << Point{0, 0};
    }
    void roundPens() {
        QFETCH(Point, end);
        for (const model::Nm width : {100'001, 3}) {
            const EdgeLoops loops = model::lineOutline({{0, 0}, end, width, 0}, false);
            QVERIFY(areSound(loops));
            const double exact = std::hypot(end.x, end.y) * width + kPi * width * width / 4.0;
            QVERIFY(relative(model::areaOf(loops), exact) < 1e-9);
        }
        const double polygons =
            edge_loop_checks::areaOf(polygonsOf(model::lineOutline({{0, 0}, end, 100'000, 0}, false), 10.0));
        QVERIFY(std::abs(polygons - std::hypot(end.x, end.y) * 1e5 - kPi * 25e8) < 20.0 * (2e6 + kPi * 1e5));
    }

    void platedSlots() {
        const EdgeLoops slot = model::lineOutline({{0, 0}, {400'000, 300'000}, 200'000, 150'000}, false);
        QVERIFY(areSound(slot) && !model::findFault(slot));
        QCOMPARE(slot.loopCount(), 2U);
        QVERIFY(relative(model::areaOf(slot), 5e5 * 5e4 + kPi * (1e10 - 75e2 * 75e4)) < 1e-9);
    }

    void squarePens() {
        const EdgeLoops along = model::lineOutline({{0, 0}, {1'000, 0}, 101, 0}, true);
        QVERIFY(areSound(along) && !model::findFault(along));
        QCOMPARE(along.edges.size(), 4U);
        QCOMPARE(model::areaOf(along), 1'101.0 * 101.0);
        const EdgeLoops slanted = model::lineOutline({{0, 0}, {1'000, 500}, 101, 0}, true);
        QVERIFY(areSound(slanted) && !model::findFault(slanted));
        QCOMPARE(slanted.edges.size(), 6U);
        QCOMPARE(model::areaOf(slanted), 101.0 * 101.0 + 101.0 * 1'500.0);
        QCOMPARE(model::areaOf(model::lineOutline({{5, 5}, {5, 5}, 8, 0}, true)), 64.0);
    }

    void nothingIsLeft() {
        QCOMPARE(model::lineOutline({{0, 0}, {9, 9}, 0, 0}, false).loopCount(), 0U);
        QCOMPARE(model::lineOutline({{0, 0}, {9, 9}, 0, 0}, true).loopCount(), 0U);
        QCOMPARE(model::lineOutline({{0, 0}, {9, 9}, -4, 0}, false).loopCount(), 0U);
        QCOMPARE(model::lineOutline({{0, 0}, {9, 9}, 50, 50}, false).loopCount(), 0U);
    }
};

QTEST_APPLESS_MAIN(LineShellTest)
#include "line_shell_test.moc"
