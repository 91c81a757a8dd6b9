// Random polygons of every kind into all triangulators: the outcomes agree, the triangle sets are equal, and the
// verifier accepts them. Crossing input has to be refused by all.
#include <QtTest>
#include <optional>

#include "model/base/parallel.h"
#include "tests/unit/tri/cases.h"
#include "tri/triangulate.h"
#include "tri/verify.h"

using base::Point;
using cases::Case;
using tri::Fault;
using tri::Outcome;
using tri::Triangulator;

namespace {

using Triangles = std::vector<std::uint32_t>;

class Generator {
public:
    explicit Generator(unsigned seed) : m_random(seed) {}

    int below(int limit) { return static_cast<int>(m_random() % static_cast<unsigned>(limit)); }
    Point point(int extent) { return {below(extent), below(extent)}; }

    /// Loops along the cells of a small grid, traced so that they touch but never cross: the border of a random set of
    /// cells, cut into random closed walks.
    Case cells(int size) {
        std::vector<std::uint8_t> isInside(static_cast<std::size_t>((size + 2) * (size + 2)), 0);
        const auto cell = [&](int x, int y) -> std::uint8_t& {
            return isInside[static_cast<std::size_t>((y + 1) * (size + 2) + x + 1)];
        };
        for (int i = 0; i < size * size; ++i) {
            cell(i % size, i / size) = below(3) != 0;
        }
        std::vector<std::pair<Point, Point>> edges;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                if (cell(x, y) == 0) {
                    continue;
                }
                const Point a{x, y}, b{x + 1, y}, c{x + 1, y + 1}, d{x, y + 1};
                addUnless(edges, cell(x, y - 1), a, b);
                addUnless(edges, cell(x + 1, y), b, c);
                addUnless(edges, cell(x, y + 1), c, d);
                addUnless(edges, cell(x - 1, y), d, a);
            }
        }
        return walk(std::move(edges));
    }

    /// Random walks on a tiny grid: everything crosses, overlaps, repeats or cancels.
    Case scribble(int extent, int corners) {
        Case input{"scribble"};
        for (int loops = 1 + below(3); loops > 0; --loops) {
            std::vector<Point> loop;
            for (int i = 1 + below(corners); i > 0; --i) {
                loop.push_back(point(extent));
            }
            input.loop(loop);
        }
        return input;
    }

    /// A star around the origin on a coarse grid, with spikes and repeats, and its mirror image as a hole.
    Case star(int extent, int corners) {
        std::vector<Point> loop;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * M_PI * i / corners;
            const double radius = extent * (0.3 + 0.7 * below(1000) / 1000.0);
            const Point p{static_cast<int>(radius * std::cos(angle)), static_cast<int>(radius * std::sin(angle))};
            loop.insert(loop.end(), static_cast<std::size_t>(1 + (below(8) == 0)), p);
        }
        std::vector<Point> hole;
        for (const Point& p : loop) {
            hole.push_back({p.x / 8, p.y / 8});
        }
        return Case{"star"}.loop(loop).loop(cases::reversed(hole));
    }

private:
    static void addUnless(std::vector<std::pair<Point, Point>>& edges, bool isShared, Point from, Point to) {
        if (!isShared) {
            edges.emplace_back(from, to);
        }
    }

    /// Closed walks over all the edges, turning at random where several meet; sometimes a bridge there and back.
    Case walk(std::vector<std::pair<Point, Point>> edges) {
        Case input{"cells"};
        std::ranges::shuffle(edges, m_random);
        while (!edges.empty()) {
            const Point start = edges.back().first;
            std::vector<Point> loop;
            std::optional<Point> at = start;
            do {
                const auto next = std::ranges::find(edges, *at, &std::pair<Point, Point>::first);
                loop.push_back({17 * at->x, 13 * at->y});
                if (below(10) == 0) {
                    loop.push_back({17 * below(8), 13 * below(8)});  // a spike: the way back follows
                    loop.push_back({17 * at->x, 13 * at->y});
                }
                at = next->second;
                edges.erase(next);
            } while (*at != start);
            input.loop(loop);
        }
        return input;
    }

    std::mt19937 m_random;
};

/// Why the triangulators disagree about the input, or nothing.
std::string disagreement(const Case& input) {
    Triangles cpu;
    const tri::Status status = tri::triangulate(input.polygon(), Triangulator::Cpu, cpu);
    if (status.outcome == Outcome::Ok && tri::verify(input.polygon(), cpu) != Fault::None) {
        return "cpu: " + std::string(tri::nameOf(tri::verify(input.polygon(), cpu)));
    }
    for (const Triangulator triangulator : tri::kTriangulators) {
        Triangles other;
        const tri::Status otherStatus = tri::triangulate(input.polygon(), triangulator, other);
        // A contour across the cancelled part of an edge is in CGAL's way (cdt_cgal.h): then the verifier has the say.
        const bool isKnown = triangulator == Triangulator::Cgal && otherStatus.outcome == Outcome::Crossing;
        if (otherStatus.outcome != status.outcome && !isKnown) {
            return std::string(tri::nameOf(triangulator)) + ": outcome " +
                   std::to_string(static_cast<int>(otherStatus.outcome)) + " instead of " +
                   std::to_string(static_cast<int>(status.outcome));
        }
        if (!isKnown && tri::triangleSetHash(other) != tri::triangleSetHash(cpu)) {
            return std::string(tri::nameOf(triangulator)) + ": other triangles";
        }
    }
    return {};
}

std::string print(const Case& input) {
    std::string text;
    for (std::size_t i = 0; i < input.points.size(); ++i) {
        text += std::ranges::find(input.loopStart, i) != input.loopStart.end() ? "\n" : " ";
        text += '{';
        text += std::to_string(input.points[i].x);
        text += ',';
        text += std::to_string(input.points[i].y);
        text += "},";
    }
    return text;
}

/// Runs `make(generator)` for many seeds; fails with the first polygon that the triangulators disagree about.
template <class Make>
void compareMany(int rounds, const Make& make) {
    int okCount = 0;
    for (int seed = 0; seed < rounds; ++seed) {
        Generator generator(static_cast<unsigned>(seed));
        const Case input = make(generator);
        const std::string problem = disagreement(input);
        QVERIFY2(problem.empty(), (problem + ", seed " + std::to_string(seed) + print(input)).c_str());
        Triangles triangles;
        okCount += tri::triangulate(input.polygon(), triangles) == Outcome::Ok ? 1 : 0;
    }
    QVERIFY2(okCount > rounds / 100, "the generator makes nothing that can be triangulated");
}

}  // namespace

class TriPropertyTest : public QObject {
    Q_OBJECT

private slots:
    void touchingContoursOnAGrid() {
        compareMany(600, [](Generator& g) { return g.cells(2 + g.below(7)); });
    }
    void scribblesOnATinyGrid() {
        compareMany(6000, [](Generator& g) { return g.scribble(2 + g.below(4), 8); });
    }
    void largerScribbles() {
        compareMany(2000, [](Generator& g) { return g.scribble(3 + g.below(60), 5); });
    }
    void largePolygonsAreTheSameOnAnyNumberOfCores() {
        // Large enough for the parallel triangulator to cut: circles, half of them on a lattice and cocircular.
        std::mt19937 random(3);
        Case input = Case{}.loop(cases::square(0, 0, 61'000'000));
        for (int i = 0; i < 60 * 60; ++i) {
            const double shift = i % 2 == 0 ? 0.0 : static_cast<double>(random() % 100'000U);
            input.loop(
                cases::reversed(cases::circle(1e6 * (i % 60) + 1e6 + shift, 1e6 * (i / 60) + 1e6 - shift, 3e5, 24)));
        }
        Triangles expected;
        QCOMPARE(tri::triangulate(input.polygon(), Triangulator::Cpu, expected).outcome, Outcome::Ok);
        QCOMPARE(tri::verify(input.polygon(), expected), Fault::None);
        for (const int threads : {1, 2, 3}) {
            const base::ThreadLimit limit(threads);
            Triangles triangles;
            QCOMPARE(tri::triangulate(input.polygon(), Triangulator::Parallel, triangles).outcome, Outcome::Ok);
            QCOMPARE(tri::triangleSetHash(triangles), tri::triangleSetHash(expected));
        }
        // Several at a time, as tasks: a thread that waits for one may be given the next.
        std::vector<Triangles> several(6);
        base::parallelFor(several.size(), [&](std::size_t i) {
            static_cast<void>(tri::triangulate(input.polygon(), Triangulator::Parallel, several[i]));
        });
        for (const Triangles& triangles : several) {
            QCOMPARE(tri::triangleSetHash(triangles), tri::triangleSetHash(expected));
        }
        input.loop(cases::squareHole(30'000'000, 30'000'000, 900'000));
        Triangles none;
        QCOMPARE(tri::triangulate(input.polygon(), Triangulator::Parallel, none).outcome, Outcome::Crossing);
    }
    void starsOnCoarseGrids() {
        compareMany(500, [](Generator& g) { return g.star(10 << g.below(20), 3 + g.below(60)); });
    }
};

QTEST_APPLESS_MAIN(TriPropertyTest)
#include "tri_property_test.moc"
