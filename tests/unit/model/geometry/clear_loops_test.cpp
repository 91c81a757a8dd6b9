#include "model/geometry/clear_loops.h"

#include <QtTest>
#include <initializer_list>
#include <polyclipping/clipper.hpp>
#include <random>

using ClipperLib::Path;
using ClipperLib::Paths;
using model::LoopSet;
using model::Nm;
using model::Point;

namespace {

LoopSet loopsOf(std::initializer_list<std::vector<Point>> loops) {
    LoopSet set;
    for (const std::vector<Point>& loop : loops) {
        set.points.insert(set.points.end(), loop.begin(), loop.end());
        set.loopStart.push_back(static_cast<std::uint32_t>(set.points.size()));
    }
    return set;
}

LoopSet loopsOf(const Paths& paths) {
    LoopSet set;
    for (const Path& path : paths) {
        for (const ClipperLib::IntPoint& p : path) {
            set.points.push_back({static_cast<Nm>(p.X), static_cast<Nm>(p.Y)});
        }
        set.loopStart.push_back(static_cast<std::uint32_t>(set.points.size()));
    }
    return set;
}

/// Loops that do not overlap but may touch, as a union leaves them.
Paths someLoops(std::mt19937& random, int extent, int count) {
    const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
    ClipperLib::Clipper clipper;
    for (int i = 0; i < count; ++i) {
        Path path;
        if (below(2) == 0) {
            const int x = below(extent);
            const int y = below(extent);
            const int width = 1 + below(extent / 2);
            const int height = 1 + below(extent / 2);
            path << ClipperLib::IntPoint(x, y) << ClipperLib::IntPoint(x + width, y)
                 << ClipperLib::IntPoint(x + width, y + height) << ClipperLib::IntPoint(x, y + height);
        } else {
            for (int corner = 3 + below(4); corner > 0; --corner) {
                path << ClipperLib::IntPoint(below(extent), below(extent));
            }
        }
        clipper.AddPath(path, below(4) == 0 ? ClipperLib::ptClip : ClipperLib::ptSubject, true);
    }
    Paths loops;
    clipper.Execute(ClipperLib::ctDifference, loops, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return loops;
}

/// Loops in the order of the tree, each behind how deep it lies.
std::vector<Path> sortedBy(ClipperLib::Clipper& clipper, const Paths& loops, bool keepsCornersOnLines) {
    clipper.AddPaths(loops, ClipperLib::ptSubject, true);
    clipper.PreserveCollinear(keepsCornersOnLines);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
    std::vector<Path> result;
    for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
        int depth = 0;
        for (const ClipperLib::PolyNode* parent = node->Parent; parent != nullptr; parent = parent->Parent) {
            ++depth;
        }
        result.push_back({ClipperLib::IntPoint(depth, 0)});
        result.push_back(node->Contour);
    }
    return result;
}

}  // namespace

class ClearLoopsTest : public QObject {
    Q_OBJECT

private slots:
    void loopsApartAreClear() {
        QVERIFY(areClear(loopsOf({{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                  {{20, 20}, {20, 80}, {80, 80}, {80, 20}},
                                  {{110, 7}, {150, 60}, {140, 90}}})));
    }

    void whatTouchesIsNotClear_data() {
        QTest::addColumn<LoopSet>("loops");
        QTest::newRow("corner at corner") << loopsOf({{{0, 0}, {50, 0}, {50, 50}}, {{50, 50}, {90, 50}, {90, 90}}});
        QTest::newRow("corner on a slanted side")
            << loopsOf({{{0, 0}, {60, 0}, {0, 60}}, {{30, 30}, {90, 30}, {90, 90}}});
        QTest::newRow("top on a level side") << loopsOf({{{0, 50}, {60, 50}, {30, 90}}, {{30, 50}, {20, 0}, {40, 0}}});
        QTest::newRow("run past each other")
            << loopsOf({{{0, 0}, {50, 0}, {50, 50}, {0, 50}}, {{50, 10}, {90, 10}, {90, 40}, {50, 40}}});
        QTest::newRow("nearer than rounding, at a corner of another loop")
            << loopsOf({{{0, 0}, {0, 999}, {-90, 999}}, {{1, 0}, {90, 999}, {1, 998}}, {{300, 5}, {400, 5}, {350, 7}}});
        QTest::newRow("sharp, and with a level where that is narrow")
            << loopsOf({{{0, 0}, {10, 100}, {0, 100}}, {{200, 1}, {300, 50}, {200, 50}}});
        QTest::newRow("spike") << loopsOf({{{0, 0}, {50, 0}, {50, 90}, {50, 50}, {0, 50}}});
        QTest::newRow("level spike") << loopsOf({{{0, 0}, {90, 0}, {50, 0}, {50, 50}}});
    }

    void whatTouchesIsNotClear() {
        QFETCH(LoopSet, loops);
        QVERIFY(!areClear(loops));
    }

    /// Steps of rounding lie in sides of many results, and are no reason to say "no".
    void shortSidesMayBeClear() {
        QVERIFY(areClear(loopsOf({{{0, 0}, {900, 0}, {905, 500}, {906, 501}, {911, 999}, {0, 1000}}})));
        QVERIFY(areClear(loopsOf({{{0, 0}, {900, 0}, {905, 500}, {906, 500}, {911, 999}, {0, 1000}}})));
    }

    /// What the first lines of the header are for: polyclipping's strictly simple result is then the plain one, to the
    /// last corner and in the same order, where that passes no corner twice.
    void strictlySimpleIsPlain() {
        std::mt19937 random(11);
        int clear = 0;
        int differing = 0;
        for (int i = 0; i < 40'000; ++i) {
            const int extent = 8 << (i % 9);
            const Paths loops = someLoops(random, extent, 1 + i % 7);
            ClipperLib::Clipper plain;
            ClipperLib::Clipper strict(ClipperLib::ioStrictlySimple);
            const bool areSame = sortedBy(plain, loops, true) == sortedBy(strict, loops, false);
            const bool isClear = areClear(loopsOf(loops));
            QVERIFY2(areSame || !isClear, qPrintable(QString::number(i)));
            clear += isClear ? 1 : 0;
            differing += areSame ? 0 : 1;
        }
        qInfo("%d of 40000 are clear, %d differ", clear, differing);
        QVERIFY(clear > 10'000);
        QVERIFY(differing > 1'000);
    }
};

QTEST_APPLESS_MAIN(ClearLoopsTest)
#include "clear_loops_test.moc"
