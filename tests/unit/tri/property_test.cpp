// Random polygons of every kind into all triangulators: the outcomes agree, the triangle sets are equal, and the
// verifier accepts them. Crossing input has to be refused by all.
#include <QtTest>

#include "model/base/parallel.h"
#include "tests/unit/tri/cases.h"
#include "tests/unit/tri/generator.h"
#include "tri/triangulate.h"
#include "tri/verify.h"

using base::Point;
using cases::Case;
using cases::Generator;
using tri::Fault;
using tri::Outcome;
using tri::Triangulator;

namespace {

using Triangles = std::vector<std::uint32_t>;

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
        const tri::Status status = tri::triangulate(input.polygon(), Triangulator::Auto, triangles);
        okCount += status.outcome == Outcome::Ok ? 1 : 0;
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
#include "property_test.moc"
