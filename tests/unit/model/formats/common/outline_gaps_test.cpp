#include "model/formats/common/outline_gaps.h"

#include <QtTest>

#include "model/geometry/outlines.h"

using model::Nm;
using model::Point;
using model::formats::BridgedLoop;
using model::formats::OutlineTrack;

namespace {

constexpr Nm kMm = 1'000'000;
constexpr double kJoint = 10'000.0;

OutlineTrack line(double x0, double y0, double x1, double y1) {
    const auto at = [](double x, double y) { return Point{static_cast<Nm>(x * kMm), static_cast<Nm>(y * kMm)}; };
    OutlineTrack track;
    track.from.point = at(x0, y0);
    track.to = at(x1, y1);
    return track;
}

std::vector<BridgedLoop> loopsOf(const std::vector<OutlineTrack>& tracks) {
    return model::formats::bridgedLoops(tracks, kJoint);
}

}  // namespace

class OutlineGapsTest : public QObject {
    Q_OBJECT

private slots:
    void aGapIsClosedAndSaid() {
        const auto loops = loopsOf({line(0, 0, 30, 0), line(30, 20, 30, 0.5), line(30, 20, 0, 20), line(0, 20, 0, 0)});
        QCOMPARE(loops.size(), 1U);
        QCOMPARE(loops[0].nodes.size(), 5U);
        QCOMPARE(loops[0].trackCount, 4U);
        QCOMPARE(model::boxOfPath(loops[0].nodes, true).max, (Point{30 * kMm, 20 * kMm}));
        QCOMPARE(model::formats::gapsText(loops[0]),
                 std::string("the board's outline is open by 0.50 mm at (30.00, 0.25) mm; a straight line closes it"));
    }

    /// Sides that stop short of all corners, in any order and direction.
    void cornersMayBeMissing() {
        const auto loops = loopsOf({line(1, 0, 29, 0), line(29, 20, 1, 20), line(30, 19, 30, 1), line(0, 19, 0, 2)});
        QCOMPARE(loops.size(), 1U);
        QCOMPARE(loops[0].gaps.size(), 4U);
        QCOMPARE(model::formats::gapsText(loops[0]),
                 std::string("the board's outline is open at 4 locations, by up to 2.24 mm, most at (0.50, 1.00) mm; "
                             "straight lines close it"));
    }

    void aSideMayBeMissing() {
        const auto loops = loopsOf({line(30, 0, 0, 0), line(0, 0, 0, 20), line(0, 20, 30, 20)});
        QCOMPARE(loops.size(), 1U);
        QCOMPARE(loops[0].gaps.size(), 1U);
    }

    void arcsKeepTheirSense() {
        OutlineTrack arc = line(30, 10, 20, 0);  // clockwise around (20, 10)
        arc.from.centre = {20 * kMm, 10 * kMm};
        arc.from.edge = model::EdgeKind::ArcClockwise;
        const auto loops =
            loopsOf({line(0, 0, 19, 0), arc, line(30, 10, 30, 20), line(30, 20, 0, 20), line(0, 20, 0, 0)});
        QCOMPARE(loops.size(), 1U);
        QCOMPARE(model::boxOfPath(loops[0].nodes, true).max, (Point{30 * kMm, 20 * kMm}));
        const auto bent =
            std::ranges::count_if(loops[0].nodes, [](const auto& node) { return model::isArc(node.edge); });
        QCOMPARE(bent, 1);
    }

    /// Three ends at one corner: which of them belong together nobody can tell.
    void whatDoesNotFaceClearlyStaysOpen() {
        QVERIFY(loopsOf({line(0.5, 0, 30, 0), line(30, 0, 30, 20), line(30, 20, 0, 20), line(0, 20, 0, 0.5),
                         line(0.4, 0.4, 10, 10)})
                    .empty());
    }

    void whatIsMoreGapThanLineStaysOpen() {
        QVERIFY(loopsOf({line(0, 0, 30, 0), line(0, 20, 30, 20)}).empty());
        QVERIFY(loopsOf({line(0, 0, 30, 0)}).empty());
        QVERIFY(loopsOf({}).empty());
    }
};

QTEST_APPLESS_MAIN(OutlineGapsTest)
#include "outline_gaps_test.moc"
