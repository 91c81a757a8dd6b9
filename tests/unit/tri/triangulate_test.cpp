#include "tri/triangulate.h"

#include <QtTest>

#include "tests/unit/tri/cases.h"
#include "tri/predicates.h"
#include "tri/verify.h"

using base::Point;
using cases::Case;
using tri::Fault;
using tri::Outcome;
using tri::Status;
using tri::Triangulator;

namespace {

using Triangles = std::vector<std::uint32_t>;

const std::vector<Case>& nasty() {
    static const std::vector<Case> all = cases::nasty();
    return all;
}

/// A star with `corners` random radii, so that neighbouring edges may be very long and thin.
Case randomStar(std::mt19937& random, int corners) {
    std::vector<Point> star;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        const double radius = 1e8 + static_cast<double>(random() % 900'000'000U);
        star.push_back({static_cast<int>(radius * std::cos(angle)), static_cast<int>(radius * std::sin(angle))});
    }
    return Case{"star"}.loop(star);
}

}  // namespace

class TriangulateTest : public QObject {
    Q_OBJECT

private slots:
    void squareBecomesTwoTriangles() {
        const Case input = Case{}.loop(cases::square(0, 0, 10));
        Triangles triangles;
        QCOMPARE(tri::triangulate(input.polygon(), Triangulator::Auto, triangles).outcome, Outcome::Ok);
        QCOMPARE(triangles.size(), 6U);
    }

    void polygonWithHolesHasEulersNumberOfTriangles() {
        // n vertices and h holes: n + 2h - 2 triangles.
        Case input = Case{}.loop(cases::square(0, 0, 1000));
        for (int i = 0; i < 9; ++i) {
            input.loop(cases::squareHole(100 + 300 * (i % 3), 100 + 300 * (i / 3), 150));
        }
        Triangles triangles;
        QCOMPARE(tri::triangulate(input.polygon(), Triangulator::Auto, triangles).outcome, Outcome::Ok);
        QCOMPARE(triangles.size() / 3, 40U + 2 * 9 - 2);
    }

    void everyTriangulatorIsRightOnNastyInput_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<int>("triangulator");
        for (int i = 0; i < static_cast<int>(nasty().size()); ++i) {
            for (const Triangulator triangulator : tri::kTriangulators) {
                const std::string row =
                    nasty()[static_cast<std::size_t>(i)].name + ", " + std::string(tri::nameOf(triangulator));
                QTest::newRow(row.c_str()) << i << static_cast<int>(triangulator);
            }
        }
    }
    void everyTriangulatorIsRightOnNastyInput() {
        QFETCH(int, index);
        QFETCH(int, triangulator);
        const Case& input = nasty()[static_cast<std::size_t>(index)];
        Triangles triangles{7, 8, 9};
        const Status status = tri::triangulate(input.polygon(), static_cast<Triangulator>(triangulator), triangles);
        QCOMPARE(status.outcome, input.outcome);
        QCOMPARE(Triangles(triangles.begin(), triangles.begin() + 3), (Triangles{7, 8, 9}));
        triangles.erase(triangles.begin(), triangles.begin() + 3);
        QCOMPARE(triangles.empty(), input.outcome != Outcome::Ok);
        if (input.outcome == Outcome::Ok) {
            QCOMPARE(tri::verify(input.polygon(), triangles), Fault::None);
        }
    }

    void aTangleIsToldFromItsFirstCrossings() {
        // Each of 200,000 edges crosses thousands of others: looking at all of them would take a minute.
        std::mt19937 random(3);
        std::vector<Point> points(200'000);
        for (Point& p : points) {
            p = {static_cast<int>(random() >> 2), static_cast<int>(random() >> 2)};
        }
        const Case tangle = Case{"tangle"}.loop(points);
        for (const Triangulator which : {Triangulator::Cpu, Triangulator::Parallel}) {
            Triangles triangles;
            const Status status = tri::triangulate(tangle.polygon(), which, triangles);
            QCOMPARE(status.outcome, Outcome::Crossing);
            QVERIFY(triangles.empty());
            const auto from = [&](std::uint32_t edge) { return points[edge]; };
            const auto to = [&](std::uint32_t edge) { return points[(edge + 1) % points.size()]; };
            const auto isApart = [&](std::uint32_t e, std::uint32_t f) {
                return (tri::orient(from(e), to(e), from(f)) > 0) != (tri::orient(from(e), to(e), to(f)) > 0);
            };
            QVERIFY(isApart(status.firstEdge, status.secondEdge) && isApart(status.secondEdge, status.firstEdge));
        }
    }

    void crossingsNameTheirEdges() {
        // Edges 0 (from (0,0) up) and 2 (from (100,0) to (0,70)) cross.
        const Case bowTie = Case{}.loop({{0, 0}, {100, 100}, {100, 0}, {0, 70}});
        Triangles triangles;
        const Status crossing = tri::triangulate(bowTie.polygon(), Triangulator::Cpu, triangles);
        QCOMPARE(std::min(crossing.firstEdge, crossing.secondEdge), 0U);
        QCOMPARE(std::max(crossing.firstEdge, crossing.secondEdge), 2U);
        const Case twice =
            Case{}.loop(cases::square(0, 0, 9)).loop(cases::squareHole(2, 2, 3)).loop(cases::squareHole(2, 2, 3));
        const Status overlap = tri::triangulate(twice.polygon(), Triangulator::Cpu, triangles);
        QCOMPARE(overlap.secondEdge - overlap.firstEdge, 4U);
        for (const Case& input : nasty()) {
            if (input.outcome == Outcome::Crossing) {
                const Status status = tri::triangulate(input.polygon(), Triangulator::Cpu, triangles);
                QVERIFY2(status.firstEdge < input.points.size(), input.name.c_str());
                QVERIFY2(status.secondEdge < input.points.size(), input.name.c_str());
            }
        }
    }

    void randomStarsAreRightAtFullExtent() {
        std::mt19937 random(1);
        for (int round = 0; round < 50; ++round) {
            const Case input = randomStar(random, 3 + round * 7);
            Triangles triangles;
            QCOMPARE(tri::triangulate(input.polygon(), Triangulator::Auto, triangles).outcome, Outcome::Ok);
            QCOMPARE(tri::verify(input.polygon(), triangles), Fault::None);
            QCOMPARE(triangles.size() / 3, input.points.size() - 2);
        }
    }

    void hashForgetsOrderOnly() {
        const Triangles triangles{1, 2, 3, 4, 5, 6};
        const std::uint64_t hash = tri::triangleSetHash(triangles);
        QCOMPARE(tri::triangleSetHash(Triangles{5, 6, 4, 3, 1, 2}), hash);
        QVERIFY(tri::triangleSetHash(Triangles{1, 3, 2, 4, 5, 6}) != hash);
        QVERIFY(tri::triangleSetHash(Triangles{1, 2, 3}) != hash);
        QVERIFY(tri::triangleSetHash(Triangles{1, 2, 3, 1, 2, 3}) != tri::triangleSetHash(Triangles{4, 5, 6, 4, 5, 6}));
    }
};

QTEST_APPLESS_MAIN(TriangulateTest)
#include "triangulate_test.moc"
