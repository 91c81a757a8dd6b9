#include "model/geometry/boolean.h"

#include <QtTest>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <polyclipping/clipper.hpp>
#include <random>

using model::Point;
using model::PolygonSet;

namespace {

PolygonSet square(int x, int y, int size) {
    PolygonSet set;
    set.beginPolygon();
    const Point corners[] = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    set.addLoop(corners);
    return set;
}

PolygonSet bar(int x, int y, int width, int height) {
    PolygonSet set;
    set.beginPolygon();
    const Point corners[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    set.addLoop(corners);
    return set;
}

long long area(const PolygonSet& set) {
    return static_cast<long long>(model::twiceArea(set) / 2);
}

ClipperLib::Paths pathsOf(const PolygonSet& set) {
    ClipperLib::Paths paths(set.loopCount());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (const Point& p : set.loop(i)) {
            paths[i].emplace_back(p.x, p.y);
        }
    }
    return paths;
}

/// The loops of polyclipping's strictly simple result: each outline, its holes, and what lies in these.
ClipperLib::Paths strictlyIntersected(const PolygonSet& a, const PolygonSet& b) {
    ClipperLib::Clipper first;
    first.AddPaths(pathsOf(a), ClipperLib::ptSubject, true);
    first.AddPaths(pathsOf(b), ClipperLib::ptClip, true);
    ClipperLib::Paths loops;
    first.Execute(ClipperLib::ctIntersection, loops, ClipperLib::pftPositive, ClipperLib::pftPositive);
    ClipperLib::Clipper second(ClipperLib::ioStrictlySimple);
    second.AddPaths(loops, ClipperLib::ptSubject, true);
    ClipperLib::PolyTree tree;
    second.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
    ClipperLib::Paths result;
    const std::function<void(const ClipperLib::PolyNode&)> collect = [&](const ClipperLib::PolyNode& parent) {
        for (const ClipperLib::PolyNode* outline : parent.Childs) {
            result.push_back(outline->Contour);
            for (const ClipperLib::PolyNode* hole : outline->Childs) {
                result.push_back(hole->Contour);
            }
            for (const ClipperLib::PolyNode* hole : outline->Childs) {
                collect(*hole);
            }
        }
    };
    collect(tree);
    return result;
}

/// A pour as many programs write it: one contour, with teeth on its right side, that runs in to round openings along
/// slanted slits. Where `touches`, an opening reaches the left side of the pour.
PolygonSet pourWithSlits(std::mt19937& random, bool touches) {
    const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
    std::vector<Point> contour{{0, 0}, {50'000'000, 0}};
    constexpr int kTeeth = 2500;
    for (int i = 0; i < kTeeth; ++i) {
        contour.push_back({50'000'000 + below(400'000), 5'000 + i * 24'000});
        contour.push_back({49'000'000 - below(400'000), 16'000 + i * 24'000});
    }
    contour.push_back({50'000'000, kTeeth * 24'000});
    contour.push_back({0, kTeeth * 24'000});
    constexpr int kOpenings = 40;
    for (int i = kOpenings; i > 0; --i) {
        const int radius = 300'000 + below(300'000);
        const Point middle{touches && i == 7 ? radius : 2'000'000 + below(30'000'000), i * 1'400'000};
        const Point mouth{0, middle.y - below(50'000)};
        contour.push_back(mouth);
        for (int k = 0; k <= 48; ++k) {  // clockwise from the left
            const double angle = M_PI - k * M_PI / 24;
            contour.push_back({middle.x + static_cast<int>(std::lround(radius * std::cos(angle))),
                               middle.y + static_cast<int>(std::lround(radius * std::sin(angle)))});
        }
        contour.push_back(mouth);
    }
    PolygonSet pour;
    pour.beginPolygon();
    pour.addLoop(contour);
    return pour;
}

}  // namespace

class BooleanTest : public QObject {
    Q_OBJECT

private slots:
    void overlapCountsOnce() {
        PolygonSet both = square(0, 0, 10);
        both.append(square(5, 5, 10));
        QCOMPARE(area(both), 200);
        const PolygonSet united = model::unite(both);
        QCOMPARE(area(united), 175);
        QCOMPARE(united.polygons.size(), 1U);
    }

    /// Unsorted, they wind as what they surround says.
    void loopsAreUnitedWithoutTheirOrder() {
        model::LoopSet loops;
        for (const Point p : {Point{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 5}, {15, 5}, {15, 15}, {5, 15}}) {
            loops.points.push_back(p);
        }
        for (const Point p : {Point{1, 1}, {1, 2}, {2, 2}, {2, 1}}) {  // a hole, clockwise
            loops.points.push_back(p);
        }
        loops.loopStart = {0, 4, 8, 12};
        const model::LoopSet united = model::unitedLoops(loops);
        QCOMPARE(united.loopStart.size(), std::size_t{3});
        __int128 twice = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::uint32_t first = united.loopStart[i];
            twice += model::twiceArea(std::span(united.points).subspan(first, united.loopStart[i + 1] - first));
        }
        QCOMPARE(static_cast<long long>(twice / 2), 174);
    }

    void differenceKeepsHolesWithTheirOutline() {
        PolygonSet holes = square(10, 10, 5);
        holes.append(square(30, 30, 5));
        holes.append(square(95, 95, 20));  // bites a corner off
        const PolygonSet result = model::subtract(square(0, 0, 100), holes);
        QCOMPARE(result.polygons.size(), 1U);
        QCOMPARE(result.polygons[0].loopCount, 3U);
        QCOMPARE(area(result), 10000 - 25 - 25 - 25);
    }

    void islandInsideAHoleIsItsOwnPolygon() {
        PolygonSet ring = model::subtract(square(0, 0, 100), square(20, 20, 60));
        ring.append(square(40, 40, 20));
        const PolygonSet result = model::unite(ring);
        QCOMPARE(result.polygons.size(), 2U);
        QCOMPARE(area(result), 10000 - 3600 + 400);
    }

    /// Together or a hundred at a time: what they cover is the same. Sides along the axes cross on the grid.
    void manyAreUnitedAsFewAre() {
        std::mt19937 random(5);
        PolygonSet many;
        PolygonSet atOnce;
        for (int i = 0; i < 700; ++i) {
            const int x = static_cast<int>(random() % 3000);
            const int y = static_cast<int>(random() % 3000);
            const PolygonSet one =
                bar(x, y, 10 + static_cast<int>(random() % 300), 10 + static_cast<int>(random() % 30));
            many.append(one);
            atOnce.append(one);
            if (i % 100 == 99) {  // few, with what was united before
                atOnce = model::unite(atOnce);
            }
        }
        const PolygonSet united = model::unite(many);
        QCOMPARE(area(united), area(atOnce));
        QCOMPARE(area(model::subtract(united, atOnce)), 0);
        QCOMPARE(area(model::subtract(atOnce, united)), 0);
        QCOMPARE(united.polygons.size(), atOnce.polygons.size());
        PolygonSet whole = square(0, 0, 4000);
        QCOMPARE(area(model::subtract(whole, many)), 16'000'000 - area(united));
    }

    /// The strokes of a hatch, slanted: their union covers each of them, and no more than all of them.
    void hatchesBecomeWhatTheyFill() {
        PolygonSet strokes;
        for (int i = 0; i < 600; ++i) {
            strokes.beginPolygon();
            const int x = 100'000 * i;
            const Point corners[] = {
                {x, 0}, {x + 150'000, 0}, {x + 1'150'007, 10'000'003}, {x + 1'000'007, 10'000'003}};
            strokes.addLoop(corners);
        }
        const PolygonSet united = model::unite(strokes);
        QCOMPARE(united.polygons.size(), std::size_t{1});
        QCOMPARE(united.polygons[0].loopCount, 1U);
        const long long expected = (599LL * 100'000 + 150'000) * 10'000'003;
        QVERIFY(std::abs(area(united) - expected) < 10'000'003LL * 20);  // corners are on the grid
    }

    void areaOfUnionAndCommonPartAddUp() {
        // |A ∪ B| = |A \ B| + |B|, on the grid exactly when all crossings are grid points.
        const PolygonSet a = square(0, 0, 64);
        const PolygonSet b = square(32, 16, 64);
        PolygonSet both = a;
        both.append(b);
        QCOMPARE(area(model::unite(both)), area(model::subtract(a, b)) + area(b));
    }

    /// Long loops that keep clear of each other go another way, which is faster (areClear()).
    void longLoopsAreThoseOfAStrictResult() {
        std::mt19937 random(3);
        for (int i = 0; i < 8; ++i) {
            const PolygonSet pour = pourWithSlits(random, i % 4 == 3);
            PolygonSet board;
            board.beginPolygon();
            const Point corners[] = {
                {-1, 300'007}, {49'500'000, 200'000 + i}, {49'700'003, 59'000'000}, {-1, 58'999'000}};
            board.addLoop(corners);
            const PolygonSet cut = model::intersect(pour, board);
            QVERIFY(cut.loopCount() >= 40);
            QVERIFY(cut.loop(0).size() > 4900 || cut.polygons.size() > 1);
            QVERIFY(pathsOf(cut) == strictlyIntersected(pour, board));
        }
    }

    void nothingMinusSomethingIsNothing() {
        QCOMPARE(model::subtract({}, square(0, 0, 10)).polygons.size(), 0U);
        QCOMPARE(model::subtract(square(0, 0, 10), square(-1, -1, 20)).polygons.size(), 0U);
    }
};

QTEST_APPLESS_MAIN(BooleanTest)
#include "boolean_test.moc"
