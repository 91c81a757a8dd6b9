#include "tri/triangulate.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

using base::Point;
using tri::Outcome;

namespace {

struct Case {
    std::vector<Point> points;
    std::vector<std::uint32_t> loopStart{0};

    Case& loop(const std::vector<Point>& loop) {
        points.insert(points.end(), loop.begin(), loop.end());
        loopStart.push_back(static_cast<std::uint32_t>(points.size()));
        return *this;
    }
    [[nodiscard]] tri::Polygon polygon() const { return {points, loopStart}; }
};

std::vector<Point> square(int x, int y, int size, bool isHole = false) {
    std::vector<Point> loop{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    if (isHole) {
        std::ranges::reverse(loop);
    }
    return loop;
}

std::int64_t cross(Point a, Point b, Point c) {
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
           (std::int64_t{c.x} - a.x) * (std::int64_t{b.y} - a.y);
}

/// Sum of twice the triangles' areas; fails if one of them is not counter-clockwise.
std::int64_t twiceAreaOf(const Case& input, const std::vector<std::uint32_t>& triangles) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const std::int64_t area =
            cross(input.points[triangles[i]], input.points[triangles[i + 1]], input.points[triangles[i + 2]]);
        [&] { QVERIFY(area > 0); }();
        sum += area;
    }
    return sum;
}

}  // namespace

class TriangulateTest : public QObject {
    Q_OBJECT

private slots:
    void squareBecomesTwoTriangles() {
        const Case input = Case{}.loop(square(0, 0, 10));
        std::vector<std::uint32_t> triangles;
        QCOMPARE(tri::triangulate(input.polygon(), triangles), Outcome::Ok);
        QCOMPARE(triangles.size(), 6U);
        QCOMPARE(twiceAreaOf(input, triangles), 200);
    }

    void polygonWithHolesHasEulersNumberOfTriangles() {
        // n vertices and h holes: n + 2h - 2 triangles.
        Case input = Case{}.loop(square(0, 0, 1000));
        for (int i = 0; i < 9; ++i) {
            input.loop(square(100 + 300 * (i % 3), 100 + 300 * (i / 3), 150, true));
        }
        std::vector<std::uint32_t> triangles;
        QCOMPARE(tri::triangulate(input.polygon(), triangles), Outcome::Ok);
        QCOMPARE(triangles.size() / 3, 40U + 2 * 9 - 2);
        QCOMPARE(twiceAreaOf(input, triangles), 2 * (1000 * 1000 - 9 * 150 * 150));
    }

    void touchingContoursKeepTheirArea_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < 6; ++i) {
            QTest::addRow("case %d", i) << i;
        }
    }
    void touchingContoursKeepTheirArea() {
        QFETCH(int, index);
        const Case cases[] = {
            // Hole corner on the outline's corner.
            Case{}.loop(square(0, 0, 100)).loop({{0, 0}, {30, 60}, {60, 30}}),
            // Two holes that share a corner.
            Case{}.loop(square(0, 0, 100)).loop(square(20, 20, 20, true)).loop(square(40, 40, 20, true)),
            // Two holes that share an edge.
            Case{}.loop(square(0, 0, 100)).loop(square(20, 20, 20, true)).loop(square(40, 20, 20, true)),
            // Hole corner inside an edge of the outline (T-junction).
            Case{}.loop(square(0, 0, 100)).loop({{50, 0}, {40, 50}, {60, 50}}),
            // Keyhole: the outline walks into the hole and back over a bridge of no width.
            Case{}.loop({{0, 0},
                         {100, 0},
                         {100, 100},
                         {0, 100},
                         {0, 50},
                         {40, 50},
                         {40, 60},
                         {60, 60},
                         {60, 40},
                         {40, 40},
                         {40, 50},
                         {0, 50}}),
            // Consecutive repeated vertex and a spike.
            Case{}.loop({{0, 0}, {100, 0}, {100, 0}, {100, 100}, {150, 100}, {100, 100}, {0, 100}}),
        };
        const std::int64_t expected[] = {20000 - 2700, 20000 - 1600, 20000 - 1600, 20000 - 1000, 20000 - 800, 20000};
        std::vector<std::uint32_t> triangles;
        QCOMPARE(tri::triangulate(cases[index].polygon(), triangles), Outcome::Ok);
        QCOMPARE(twiceAreaOf(cases[index], triangles), expected[index]);
    }

    void crossingInputIsRefusedAndAppendsNothing() {
        const Case bowTie = Case{}.loop({{0, 0}, {100, 100}, {100, 0}, {0, 70}});
        const Case holeAcross = Case{}.loop(square(0, 0, 100)).loop(square(90, 40, 20, true));
        const Case holesOverlap =
            Case{}.loop(square(0, 0, 100)).loop(square(20, 20, 30, true)).loop(square(40, 40, 30, true));
        const Case holeTwice =
            Case{}.loop(square(0, 0, 100)).loop(square(20, 20, 30, true)).loop(square(20, 20, 30, true));
        for (const Case& input : {bowTie, holeAcross, holesOverlap, holeTwice}) {
            std::vector<std::uint32_t> triangles{7, 8, 9};
            QCOMPARE(tri::triangulate(input.polygon(), triangles), Outcome::Crossing);
            QCOMPARE(triangles, (std::vector<std::uint32_t>{7, 8, 9}));
        }
    }

    void flatInputIsDegenerate() {
        std::vector<std::uint32_t> triangles;
        QCOMPARE(tri::triangulate(Case{}.loop({{0, 0}, {10, 0}, {20, 0}}).polygon(), triangles), Outcome::Degenerate);
        QCOMPARE(tri::triangulate(Case{}.polygon(), triangles), Outcome::Degenerate);
        QVERIFY(triangles.empty());
    }

    void randomStarsKeepTheirAreaAtFullExtent() {
        std::mt19937 random(1);
        for (int round = 0; round < 50; ++round) {
            Case input;
            std::vector<Point> star;
            const int corners = 3 + round * 7;
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * M_PI * i / corners;
                const double radius = 1e8 + static_cast<double>(random() % 900'000'000U);
                star.push_back(
                    {static_cast<int>(radius * std::cos(angle)), static_cast<int>(radius * std::sin(angle))});
            }
            input.loop(star);
            std::int64_t expected = 0;
            for (std::size_t i = 0; i < star.size(); ++i) {
                const Point& a = star[i];
                const Point& b = star[(i + 1) % star.size()];
                expected += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
            }
            std::vector<std::uint32_t> triangles;
            QCOMPARE(tri::triangulate(input.polygon(), triangles), Outcome::Ok);
            QCOMPARE(twiceAreaOf(input, triangles), expected);
            QCOMPARE(triangles.size() / 3, star.size() - 2);
        }
    }
};

QTEST_APPLESS_MAIN(TriangulateTest)
#include "triangulate_test.moc"
