#include "model/geometry/loops/needless_corners.h"

#include <QtTest>

#include "tests/unit/model/geometry/edge_loop_checks.h"

using model::EdgeLoops;
using model::PointD;

namespace {

EdgeLoops closed(std::initializer_list<PointD> corners) {
    EdgeLoops loops;
    for (auto corner = corners.begin(); corner != corners.end(); ++corner) {
        loops.addLine(*corner, corner + 1 == corners.end() ? *corners.begin() : *(corner + 1));
    }
    loops.endLoop();
    return loops;
}

}  // namespace

class NeedlessCornersTest : public QObject {
    Q_OBJECT

private slots:
    void pairsOfCornersBecomeOne() {
        const EdgeLoops clipped =
            closed({{0, 0}, {1e6, 0}, {1e6 + 3, 2}, {1e6 + 4, 6}, {1e6, 1e6}, {5e5, 1e6 + 1}, {0, 1e6}});
        const EdgeLoops kept = model::withoutNeedlessCorners(clipped, 5.0);
        QCOMPARE(kept.edges.size(), std::size_t{4});  // one of the three stands for the others
        QVERIFY(edge_loop_checks::areSound(kept));
        QVERIFY(std::abs(model::areaOf(kept) - model::areaOf(clipped)) < 5.0 * 4e6);
        for (const model::Edge& edge : clipped.edges) {
            double nearest = 1e9;
            for (const model::Edge& other : kept.edges) {
                const PointD on = model::nearestOn(other, edge.a);
                nearest = std::min(nearest, std::hypot(on.x - edge.a.x, on.y - edge.a.y));
            }
            QVERIFY(nearest <= 5.0);
        }
    }

    void cornersFurtherAwayStay() {
        const EdgeLoops bent = closed({{0, 0}, {5e5, -6}, {1e6, 0}, {1e6, 1e6}, {0, 1e6}});
        QCOMPARE(model::withoutNeedlessCorners(bent, 5.0).edges.size(), std::size_t{5});
        QCOMPARE(model::withoutNeedlessCorners(bent, 7.0).edges.size(), std::size_t{4});
    }

    void endsOfArcsStay() {
        EdgeLoops half;
        half.addArc({1e6, 0}, {-1e6, 0}, {0, 0}, false);
        half.addLine({-1e6, 0}, {0, 1});
        half.addLine({0, 1}, {1e6, 0});
        half.endLoop();
        const EdgeLoops kept = model::withoutNeedlessCorners(half, 5.0);
        QCOMPARE(kept.edges.size(), std::size_t{2});
        QVERIFY(edge_loop_checks::areSound(kept));
    }

    void whatWouldTouchItselfStays() {
        // A slit 4 nm wide between two teeth: without its corners at the mouth the outline would lie on itself.
        const EdgeLoops slit =
            closed({{0, 0}, {1e6, 0}, {1e6, 1e6}, {5e5 + 2, 1e6}, {5e5, 2e5}, {5e5 - 2, 1e6}, {0, 1e6}});
        const EdgeLoops kept = model::withoutNeedlessCorners(slit, 5.0);
        QVERIFY(edge_loop_checks::areSound(kept));
        QCOMPARE(kept.edges.size(), slit.edges.size());
    }
};

QTEST_APPLESS_MAIN(NeedlessCornersTest)
#include "needless_corners_test.moc"
