#include "model/geometry/loops/split_loops.h"

#include <QtTest>
#include <algorithm>
#include <numbers>

#include "model/geometry/loops/edge_faults.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"

using model::EdgeLoops;
using model::PointD;
using model::RegionLimits;

namespace {

/// A wavy outline of so many corners around a grid of round holes.
EdgeLoops plane(int corners, int holesAcross) {
    EdgeLoops loops;
    const auto corner = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const double radius = 50e6 + 1e6 * std::sin(17 * angle);
        return PointD{std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))};
    };
    for (int i = 0; i < corners; ++i) {
        loops.addLine(corner(i), corner((i + 1) % corners));
    }
    loops.endLoop();
    const double pitch = 60e6 / std::max(1, holesAcross);
    for (int x = 0; x < holesAcross; ++x) {
        for (int y = 0; y < holesAcross; ++y) {
            loops.addCircle({-30e6 + pitch * x, -30e6 + pitch * y}, std::min(400'000.0, 0.3 * pitch));
        }
    }
    return loops;
}

double areaOf(const std::vector<EdgeLoops>& pieces) {
    double area = 0.0;
    for (const EdgeLoops& piece : pieces) {
        area += model::areaOf(piece);
    }
    return area;
}

}  // namespace

class SplitLoopsTest : public QObject {
    Q_OBJECT

private slots:
    void piecesKeepTheLimitsAndCoverTheRegion_data() {
        QTest::addColumn<int>("corners");
        QTest::addColumn<int>("holes");
        QTest::newRow("a long outline") << 5000 << 0;
        QTest::newRow("many holes") << 100 << 30;
        QTest::newRow("both") << 3000 << 25;
        QTest::newRow("holes in long rows") << 100 << 161;
    }
    void piecesKeepTheLimitsAndCoverTheRegion() {
        QFETCH(int, corners);
        QFETCH(int, holes);
        const EdgeLoops region = plane(corners, holes);
        const RegionLimits limits{400, 200};
        const std::vector<EdgeLoops> pieces = model::splitLarge(region, limits);
        QVERIFY(pieces.size() > 1);
        for (const EdgeLoops& piece : pieces) {
            for (std::size_t i = 0; i < piece.loopCount(); ++i) {
                QVERIFY(piece.loop(i).size() <= limits.edgesOfLoop);
            }
            QVERIFY(piece.loopCount() - 1 <= limits.holes);
            QVERIFY(edge_loop_checks::areSound(piece));
            const auto fault = model::findFault(piece);
            QVERIFY2(!fault, fault ? fault->what.c_str() : "");
        }
        const double area = model::areaOf(region);
        // A sum near 7e15 nm² is rounded by up to 0.5 nm² with each of up to 80,000 edges.
        QVERIFY(std::abs(areaOf(pieces) / area - 1.0) < 6e-12);
    }

    void aRegionThatKeepsTheLimitsStaysAsItIs() {
        const EdgeLoops region = plane(100, 3);
        const auto pieces = model::splitLarge(region, {400, 200});
        QCOMPARE(pieces.size(), std::size_t{1});
        QCOMPARE(pieces.front().edges.size(), region.edges.size());
    }

    void circlesAreCutInTwoArcs() {
        EdgeLoops disc;
        disc.addCircle({0.0, 0.0}, 1e6);
        disc.addCircle({200'000.0, 0.0}, 1e5);
        disc.addCircle({-200'000.0, 0.0}, 1e5);
        const auto pieces = model::splitLarge(disc, {400, 1});
        QCOMPARE(pieces.size(), std::size_t{2});
        QVERIFY(std::abs(areaOf(pieces) / model::areaOf(disc) - 1.0) < 1e-12);
    }

    void aRegionThatCannotBeCutIsGivenBack() {
        EdgeLoops tiny;  // no place between its corners
        for (int i = 0; i < 5; ++i) {
            const auto at = [](int k) { return PointD{std::cos(k * 1.2566), std::sin(k * 1.2566)}; };
            tiny.addLine(at(i), at((i + 1) % 5));
        }
        tiny.endLoop();
        QCOMPARE(model::splitLarge(tiny, {3, 0}).size(), std::size_t{1});
    }
};

QTEST_APPLESS_MAIN(SplitLoopsTest)
#include "split_loops_test.moc"
