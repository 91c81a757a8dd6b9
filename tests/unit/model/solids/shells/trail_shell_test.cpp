#include "model/solids/shells/trail_shell.h"

#include <QtTest>
#include <algorithm>
#include <random>

#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/loops/edge_union.h"
#include "model/solids/shells/trail_offset.h"
#include "tests/locations.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"
#include "tests/unit/model/hand_made.h"

using namespace edge_loop_checks;
using namespace hand_made;
using model::Edge;
using model::EdgeKind;
using model::EdgeLoops;
using model::Nm;
using model::PathNode;
using model::Point;
using Regions = std::vector<EdgeLoops>;

namespace {

/// A document with one trail.
class Board {
public:
    Board(const std::vector<PathNode>& nodes, const std::vector<Nm>& widths) {
        m_builder.beginLayer(addLayer(m_builder, "top"));
        m_builder.addTrail(nodes, widths, {});
    }
    Board(const std::vector<PathNode>& nodes, Nm width, Nm innerWidth) {
        m_builder.beginLayer(addLayer(m_builder, "top"));
        m_builder.addTrail(nodes, width, {}, innerWidth);
    }
    [[nodiscard]] Regions outlines() const {
        return model::trailOutlines(m_builder.soFar(), m_builder.soFar().trails[0]).value_or(Regions{});
    }
    [[nodiscard]] Regions united() const {
        return model::unite(model::trackOutlines(m_builder.soFar(), m_builder.soFar().trails[0])).value_or(Regions{});
    }

private:
    model::DocumentBuilder m_builder;
};

PathNode to(Nm x, Nm y) {
    return {{x, y}, {}, EdgeKind::Line};
}

double areaOf(const Regions& regions) {
    double sum = 0.0;
    for (const EdgeLoops& region : regions) {
        sum += model::areaOf(region);
    }
    return sum;
}

bool areAllSound(const Regions& regions) {
    return !regions.empty() && std::ranges::all_of(regions, [](const EdgeLoops& region) {
        return areSound(region) && !model::findFault(region);
    });
}

Edge track(double ax, double ay, double bx, double by, double pen) {
    Edge edge;
    edge.a = {ax, ay};
    edge.b = {bx, by};
    edge.pen = pen;
    return edge;
}

}  // namespace

class TrailShellTest : public QObject {
    Q_OBJECT

private slots:
    void plainTrailsAreOffset() {
        const Board board({to(0, 0), to(1'000'000, 0), to(2'000'000, 1'000'000), to(2'000'000, 3'000'000)}, 200'000, 0);
        const Regions regions = board.outlines();
        QVERIFY(areAllSound(regions));
        QCOMPARE(regions.size(), 1U);
        QCOMPARE(regions.front().edges.size(), 10U);  // 6 sides, 2 ends, 2 rounds
        // An inner corner of 45° covers twice: a kite less the sector beyond it.
        const double corner = std::tan(kPi / 8) * 1e10 - kPi / 8 * 1e10;
        const double exact = (3e6 + std::sqrt(2e12)) * 2e5 + kPi * 1e10 - 2 * corner;
        QVERIFY2(relative(areaOf(regions), exact) < 1e-9, qPrintable(QString::number(areaOf(regions) - exact)));
        QVERIFY(relative(areaOf(board.united()), exact) < 1e-9);
    }

    void arcsBetweenLines() {
        const Board board({to(0, 0),
                           {{1'000'000, 0}, {1'000'000, 500'000}, EdgeKind::ArcCounterClockwise},
                           to(1'500'000, 500'000),
                           to(1'500'000, 2'000'000)},
                          200'000, 0);
        const Regions regions = board.outlines();
        QVERIFY(areAllSound(regions));
        QCOMPARE(regions.front().edges.size(), 8U);
        QVERIFY(relative(areaOf(regions), (2.5e6 + kPi / 2 * 5e5) * 2e5 + kPi * 1e10) < 1e-9);
    }

    void widthsThatChange() {
        const Board narrower({to(0, 0), to(1'000'000, 0), to(2'000'000, 0)}, {200'000, 100'000});
        QVERIFY(areAllSound(narrower.outlines()));
        QCOMPARE(narrower.outlines().front().edges.size(), 8U);
        QVERIFY(relative(areaOf(narrower.outlines()), areaOf(narrower.united())) < 1e-9);
        const Board wider({to(0, 0), to(1'000'000, 0), to(1'500'000, 1'000'000)}, {100'000, 240'000});
        QVERIFY(areAllSound(wider.outlines()));
        QVERIFY(relative(areaOf(wider.outlines()), areaOf(wider.united())) < 1e-9);
    }

    void trailsThatCrossThemselves() {
        const Board board(
            {to(0, 0), to(2'000'000, 0), to(2'000'000, 1'000'000), to(1'000'000, 1'000'000), to(1'000'000, -1'000'000)},
            200'000, 0);
        const Regions regions = board.outlines();
        QVERIFY(areAllSound(regions));
        QCOMPARE(regions.size(), 1U);
        QCOMPARE(regions.front().loopCount(), 2U);
        QVERIFY(relative(areaOf(regions), areaOf(board.united())) < 1e-12);
    }

    void closedTrails() {
        const Board board({to(0, 0), to(2'000'000, 0), to(2'000'000, 1'000'000), to(0, 1'000'000), to(0, 0)}, 200'000,
                          0);
        const Regions regions = board.outlines();
        QVERIFY(areAllSound(regions));
        QCOMPARE(regions.size(), 1U);
        QCOMPARE(regions.front().loopCount(), 2U);
        QCOMPARE(regions.front().edges.size(), 12U);
        QVERIFY(relative(areaOf(regions), 2.2e6 * 1.2e6 - (4 - kPi) * 1e10 - 1.8e6 * 0.8e6) < 1e-9);
    }

    void shortTracks() {
        const Board board({to(0, 0), to(1'000'000, 0), to(1'010'000, 10'000), to(1'010'000, 30'000), to(0, 300'000)},
                          200'000, 0);
        QVERIFY(areAllSound(board.outlines()));
        QCOMPARE(board.outlines().size(), 1U);
        QVERIFY(relative(areaOf(board.outlines()), areaOf(board.united())) < 1e-9);
    }

    void thereAndBack() {
        const Board board({to(0, 0), to(1'000'000, 0), to(400'000, 0)}, 200'000, 0);
        QVERIFY(areAllSound(board.outlines()));
        QVERIFY(relative(areaOf(board.outlines()), 1e6 * 2e5 + kPi * 1e10) < 1e-9);
    }

    void routedSlots() {
        const Board board({to(0, 0), to(1'000'000, 0), to(1'000'000, 1'000'000)}, 300'000, 200'000);
        const Regions regions = board.outlines();
        QVERIFY(areAllSound(regions));
        QCOMPARE(regions.size(), 1U);
        QCOMPARE(regions.front().loopCount(), 2U);
        const Board outer({to(0, 0), to(1'000'000, 0), to(1'000'000, 1'000'000)}, 300'000, 0);
        const Board inner({to(0, 0), to(1'000'000, 0), to(1'000'000, 1'000'000)}, 200'000, 0);
        QVERIFY(relative(areaOf(regions), areaOf(outer.outlines()) - areaOf(inner.outlines())) < 1e-12);
        const Board frame({to(0, 0), to(1'000'000, 0), to(1'000'000, 1'000'000), to(0, 0)}, 300'000, 200'000);
        QVERIFY(areAllSound(frame.outlines()));
        QCOMPARE(frame.outlines().size(), 2U);  // a wall outside the slot and one inside
    }

    /// The local construction gives up where it does not hold.
    void offsetsOfWhatIsNotPlain() {
        QVERIFY(!model::offsetOutline({}).outline);
        const Edge along = track(0, 0, 1e6, 0, 1e5);
        QVERIFY(model::offsetOutline(std::vector{along, track(1e6, 0, 2e6, 1e5, 1e5)}).outline.has_value());
        QVERIFY(!model::offsetOutline(std::vector{along, track(1e6, 0, 0, 1e4, 1e5)}).outline);  // back along itself
        QVERIFY(!model::offsetOutline(std::vector{along, track(1e6, 0, 1.02e6, 3e4, 1e5)})
                     .outline);                       // shorter than the pen
        Edge bend = track(1e6, 0, 1.05e6, 5e4, 1e5);  // of a radius below the pen
        bend.centre = {1e6, 5e4};
        bend.radius = 5e4;
        QVERIFY(!model::offsetOutline(std::vector{along, bend}).outline);
    }

    void offsetsOfRings() {
        const std::vector<Edge> square{track(0, 0, 1e6, 0, 1e5), track(1e6, 0, 1e6, 1e6, 1e5),
                                       track(1e6, 1e6, 0, 1e6, 1e5), track(0, 1e6, 0, 0, 1e5)};
        const double exact = 1.2e6 * 1.2e6 - (4 - kPi) * 1e10 - 0.8e6 * 0.8e6;
        std::vector<Edge> back(square.rbegin(), square.rend());
        std::ranges::transform(back, back.begin(), [](const model::Edge& edge) { return model::reversed(edge); });
        for (const std::vector<Edge>& tracks : {square, back}) {
            const auto ring = model::offsetRing(tracks);
            QVERIFY(ring && areAllSound({*ring}));
            QCOMPARE(ring->edges.size(), 12U);
            QVERIFY(relative(model::areaOf(*ring), exact) < 1e-9);
        }
        std::vector<Edge> filled = square;  // no hole is left
        std::ranges::for_each(filled, [](Edge& edge) { edge.pen = 6e5; });
        QVERIFY(!model::offsetRing(filled));
        QVERIFY(!model::offsetRing(std::vector{square[0], model::reversed(square[0])}));
    }

    void randomRings() {
        std::mt19937 random(5);
        const auto pick = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
        for (int i = 0; i < (locations::isThorough() ? 20'000 : 1'000); ++i) {
            std::vector<PathNode> nodes;
            std::vector<Nm> widths;
            for (int k = pick(2, 8); k > 0; --k) {
                nodes.push_back(to(pick(0, 20) * 60'000 + k, pick(0, 20) * 60'001));
                widths.push_back(widths.empty() || pick(0, 6) == 0 ? 40'000 * pick(1, 4) : widths.back());
            }
            nodes.push_back(nodes.front());
            const Board board(nodes, widths);
            const Regions regions = board.outlines();
            QVERIFY2(areAllSound(regions), qPrintable(QString::number(i)));
            QCOMPARE(regions.size(), 1U);
            QVERIFY2(
                relative(areaOf(regions), areaOf(board.united())) < 1e-5,
                qPrintable(QString("%1: %2 instead of %3").arg(i).arg(areaOf(regions)).arg(areaOf(board.united()))));
        }
    }

    void randomTrails() {
        std::mt19937 random(3);
        const auto pick = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
        const int cases = locations::isThorough() ? 20'000 : 1'000;
        for (int i = 0; i < cases; ++i) {
            std::vector<PathNode> nodes{to(0, 0)};
            std::vector<Nm> widths;
            for (int k = pick(1, 8); k > 0; --k) {
                const Point last = nodes.back().point;
                nodes.push_back(to(last.x + 1 + pick(-20, 20) * 30'000, last.y + pick(-20, 20) * 30'001));
                widths.push_back(widths.empty() || pick(0, 4) == 0 ? 40'000 * pick(1, 6) : widths.back());
            }
            const Board board(nodes, widths);
            const Regions regions = board.outlines();
            QVERIFY2(areAllSound(regions), qPrintable(QString::number(i)));
            QCOMPARE(regions.size(), 1U);
            QVERIFY2(
                relative(areaOf(regions), areaOf(board.united())) < 1e-5,
                qPrintable(QString("%1: %2 instead of %3").arg(i).arg(areaOf(regions)).arg(areaOf(board.united()))));
        }
    }
};

QTEST_APPLESS_MAIN(TrailShellTest)
#include "trail_shell_test.moc"
