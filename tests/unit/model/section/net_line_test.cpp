// The line that follows a net: chains, loops, arcs, vias, copies, and nets with nothing to follow.
#include "model/section/net_line.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/board/document_builder.h"
#include "tests/unit/model/hand_made.h"

using namespace model;
using namespace hand_made;

namespace {

/// Two copper layers and a drill through both.
struct Board {
    DocumentBuilder builder;
    LayerId top = addLayer(builder, "top");
    LayerId bottom = addLayer(builder, "bottom");
    LayerId drill = addDrill(builder, top, bottom);
    NetId net = builder.addNet("N");
    NetId other = builder.addNet("other");

    void line(Point a, Point b, int flags = 0) { builder.addLine({a, b, kMm / 10, 0}, of(net, flags)); }
};

double lengthOf(const std::vector<PointD>& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    }
    return length;
}

/// Corners in either order.
bool isLine(std::vector<PointD> line, const std::vector<Point>& corners) {
    if (line.size() != corners.size()) {
        return false;
    }
    const auto fits = [&] {
        return std::ranges::equal(line, corners, [](PointD a, Point b) {
            return std::hypot(a.x - static_cast<double>(b.x), a.y - static_cast<double>(b.y)) < 1.0;
        });
    };
    const bool isForth = fits();
    std::ranges::reverse(line);
    return isForth || fits();
}

}  // namespace

class NetLineTest : public QObject {
    Q_OBJECT

private slots:
    void theLongestChainIsTakenAndBranchesAreLeftOut() {
        Board board;
        board.builder.beginLayer(board.top);
        board.line({0, 0}, {10 * kMm, 0});
        board.line({10 * kMm, 0}, {10 * kMm, 5 * kMm});
        board.line({10 * kMm, 0}, {12 * kMm, 0});         // a branch
        board.line({0, 20 * kMm}, {14 * kMm, 20 * kMm});  // longer than any stroke, but no longer than the chain
        board.builder.addLine({{0, 0}, {-90 * kMm, 0}, kMm / 10, 0}, of(board.other));
        const auto line = lineAlong(*indexed(board.builder.finish()), {0, board.net});
        QVERIFY2(line, line ? "" : line.error().text.c_str());
        QVERIFY(isLine(line->line, {{0, 0}, {10 * kMm, 0}, {10 * kMm, 5 * kMm}}));
    }

    /// Each chain is looked at for itself; were all locations looked at for each of them, this took many minutes.
    void oneOfVeryManyChainsIsFound() {
        Board board;
        board.builder.beginLayer(board.top);
        const auto addShort = [&board](int first, int end) {
            for (int i = first; i < end; ++i) {
                const Point start{i % 1000 * 100 * kUm, i / 1000 * kMm};
                board.line(start, {start.x + 50 * kUm, start.y});
            }
        };
        addShort(0, 100'000);
        board.line({0, -5 * kMm}, {50 * kUm, -5 * kMm});
        board.line({50 * kUm, -5 * kMm}, {50 * kUm, -4 * kMm});
        addShort(100'000, 200'000);
        const auto line = lineAlong(*indexed(board.builder.finish()), {0, board.net});
        QVERIFY(line && isLine(line->line, {{0, -5 * kMm}, {50 * kUm, -5 * kMm}, {50 * kUm, -4 * kMm}}));
    }

    /// Two ways around: no corner twice, and the shorter one of both.
    void aLoopIsCutShort() {
        Board board;
        board.builder.beginLayer(board.top);
        board.line({-5 * kMm, 0}, {0, 0});
        board.line({0, 0}, {0, 2 * kMm});
        board.line({0, 2 * kMm}, {8 * kMm, 2 * kMm});
        board.line({8 * kMm, 2 * kMm}, {8 * kMm, 0});
        board.line({0, 0}, {8 * kMm, 0});
        board.line({8 * kMm, 0}, {15 * kMm, 0});
        const auto line = lineAlong(*indexed(board.builder.finish()), {0, board.net});
        QVERIFY(line && isLine(line->line, {{-5 * kMm, 0}, {0, 0}, {8 * kMm, 0}, {15 * kMm, 0}}));
    }

    void aRingHasEndsToo() {
        Board board;
        board.builder.beginLayer(board.top);
        board.line({0, 0}, {4 * kMm, 0});
        board.line({4 * kMm, 0}, {4 * kMm, 4 * kMm});
        board.line({4 * kMm, 4 * kMm}, {0, 4 * kMm});
        board.line({0, 4 * kMm}, {0, 0});
        const auto line = lineAlong(*indexed(board.builder.finish()), {0, board.net});
        QVERIFY(line);
        QCOMPARE(lengthOf(line->line), 8.0 * kMm);  // half of it
    }

    void arcsBecomeShortChordsOnTheCircle() {
        Board board;
        board.builder.beginLayer(board.top);
        board.line({-9 * kMm, 0}, {-3 * kMm, 0});
        const PathNode start{{-3 * kMm, 0}, {0, 0}, EdgeKind::ArcClockwise};
        board.builder.addArc({start, {3 * kMm, 0}, kMm / 10, 0}, of(board.net));
        board.line({3 * kMm, 0}, {9 * kMm, 0});
        const auto line = lineAlong(*indexed(board.builder.finish()), {0, board.net});
        QVERIFY(line && line->line.size() > 36);
        for (std::size_t i = 1; i + 1 < line->line.size(); ++i) {
            QVERIFY(std::abs(std::hypot(line->line[i].x, line->line[i].y) - 3.0 * kMm) < 1.0);
            QVERIFY(line->line[i].y > -1.0);  // over the top: clockwise from the left
        }
        const double exact = (12.0 + 3.0 * std::numbers::pi) * kMm;
        QVERIFY(lengthOf(line->line) <= exact && lengthOf(line->line) > exact * 0.999);
    }

    /// Strokes hang together at the via, whatever layer they are on; pads and holes are no way.
    void viasLeadToTheOtherSide() {
        Board board;
        board.builder.beginLayer(board.top);
        board.line({0, 0}, {6 * kMm, 0});
        board.builder.addCircle({{6 * kMm, 0}, kMm, 0}, of(board.net, kPad));
        board.builder.beginLayer(board.bottom);
        board.line({6 * kMm, 0}, {6 * kMm, 7 * kMm});
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{6 * kMm, 0}, kMm / 2, kMm / 2}, of(board.net, kHole | kPlated));
        const auto line = lineAlong(*indexed(board.builder.finish()), {0, board.net});
        QVERIFY(line && isLine(line->line, {{0, 0}, {6 * kMm, 0}, {6 * kMm, 7 * kMm}}));
        const std::vector<LayerRun> runs = runsOf(*line);
        QCOMPARE(runs.size(), std::size_t{2});
        QCOMPARE(runs[0], (LayerRun{0.0, 6e6, line->layers[0]}));
        QCOMPARE(runs[1], (LayerRun{6e6, 13e6, line->layers[1]}));
        QVERIFY(runs[0].layer != runs[1].layer);
    }

    void aNetOfACopyIsFollowedWhereTheCopyLies() {
        Board step;
        step.builder.beginLayer(step.top);
        step.line({0, 0}, {3 * kMm, 0});
        Board panel;
        const std::uint32_t row = panel.builder.addStep(step.builder.finish());
        panel.builder.addInstance({row, {{100 * kMm, 50 * kMm}, 0.0, false}, false});
        panel.builder.addInstance({row, {{200 * kMm, 50 * kMm}, 0.0, true}, true});
        const auto index = indexed(panel.builder.finish());
        QCOMPARE(index->tree.copies.size(), std::size_t{3});
        const auto first = lineAlong(*index, {1, step.net});
        QVERIFY(first && isLine(first->line, {{100 * kMm, 50 * kMm}, {103 * kMm, 50 * kMm}}));
        const auto second = lineAlong(*index, {2, step.net});
        QVERIFY(second && isLine(second->line, {{200 * kMm, 50 * kMm}, {197 * kMm, 50 * kMm}}));
    }

    void aNetWithoutStrokesIsTold() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, kMm, 0}, of(board.net, kPad));
        board.line({kMm, 0}, {kMm * 2, 0}, kPad);  // an oval pad is no track
        const auto line = lineAlong(*indexed(board.builder.finish()), {0, board.net});
        QVERIFY(!line);
        QVERIFY2(line.error().text.find("no tracks") != std::string::npos, line.error().text.c_str());
        QVERIFY(line.error().code == base::ErrorCode::BadUsage);
    }
};

QTEST_GUILESS_MAIN(NetLineTest)
#include "net_line_test.moc"
