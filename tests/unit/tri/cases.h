#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tri/triangulate.h"

/// Polygons that the tests of tri/ share.
namespace cases {

using base::Point;

struct Case {
    std::string name;
    std::vector<Point> points{};
    std::vector<std::uint32_t> loopStart{0};
    tri::Outcome outcome = tri::Outcome::Ok;

    Case& loop(const std::vector<Point>& loop) {
        points.insert(points.end(), loop.begin(), loop.end());
        loopStart.push_back(static_cast<std::uint32_t>(points.size()));
        return *this;
    }
    Case& expect(tri::Outcome expected) {
        outcome = expected;
        return *this;
    }
    [[nodiscard]] tri::Polygon polygon() const { return {points, loopStart}; }
};

inline std::vector<Point> reversed(std::vector<Point> loop) {
    std::ranges::reverse(loop);
    return loop;
}

inline std::vector<Point> square(int x, int y, int size) {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

inline std::vector<Point> squareHole(int x, int y, int size) {
    return reversed(square(x, y, size));
}

inline std::vector<Point> circle(double x, double y, double radius, int corners) {
    std::vector<Point> loop;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        loop.push_back({static_cast<int>(std::lround(x + radius * std::cos(angle))),
                        static_cast<int>(std::lround(y + radius * std::sin(angle)))});
    }
    return loop;
}

inline Case lattice(int count) {
    Case grid{"lattice of square holes"};
    grid.loop(square(0, 0, 20 * count + 10));
    for (int i = 0; i < count * count; ++i) {
        grid.loop(squareHole(10 + 20 * (i % count), 10 + 20 * (i / count), 10));
    }
    return grid;
}

/// A plane with side * side antipads, half of them on a lattice.
inline Case plane(int side) {
    Case input = Case{"plane"}.loop(square(0, 0, 1'000'000 * (side + 1)));
    for (int i = 0; i < side * side; ++i) {
        const double shift = i % 2 == 0 ? 0.0 : 1e5 * ((i * 37) % 11) / 11;
        input.loop(reversed(circle(1e6 * (i % side + 1) + shift, 1e6 * (i / side + 1) - shift, 3e5, 24)));
    }
    return input;
}

/// Long parallel channels: their edges are no Delaunay edges.
inline Case channels(int count) {
    Case input = Case{"channels"}.loop(
        {{0, 0}, {20'000'000, 0}, {20'000'000, 300'000 * count + 300'000}, {0, 300'000 * count + 300'000}});
    for (int i = 0; i < count; ++i) {
        const int y = 300'000 * i + 200'000;
        const int x = 1'000'000 + 70'001 * ((i * 7) % 13);
        input.loop({{x, y},
                    {x, y + 200'000},
                    {x + 17'000'000, y + 200'000},
                    {x + 17'500'000, y + 100'000},
                    {x + 17'000'000, y}});
    }
    return input;
}

/// What boards and bad exporters come up with.
inline std::vector<Case> touching() {
    const std::vector<Point> big = square(0, 0, 100);
    return {
        Case{"triangle"}.loop({{0, 0}, {7, 1}, {3, 5}}),
        Case{"hole vertex on outline vertex"}.loop(big).loop({{0, 0}, {30, 60}, {60, 30}}),
        Case{"holes share a vertex"}.loop(big).loop(squareHole(20, 20, 20)).loop(squareHole(40, 40, 20)),
        Case{"holes share an edge"}.loop(big).loop(squareHole(20, 20, 20)).loop(squareHole(40, 20, 20)),
        Case{"holes share part of an edge"}.loop(big).loop(squareHole(20, 20, 30)).loop(squareHole(50, 30, 10)),
        Case{"hole shares part of the outline"}.loop(big).loop(squareHole(30, 0, 20)),
        Case{"hole shares a corner of the outline"}.loop(big).loop(squareHole(0, 0, 20)),
        Case{"hole vertex inside an outline edge"}.loop(big).loop({{50, 0}, {40, 50}, {60, 50}}),
        Case{"hole vertex inside a hole edge"}
            .loop(big)
            .loop(squareHole(20, 20, 20))
            .loop({{40, 30}, {60, 40}, {60, 20}}),
        Case{"keyhole"}.loop({{0, 0},
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
        Case{"keyhole that starts inside an edge"}
            .loop({{0, 0}, {100, 0}, {100, 100}, {0, 100}})
            .loop({{0, 50}, {40, 50}, {40, 60}, {60, 60}, {60, 40}, {40, 40}, {40, 50}}),
        Case{"two keyholes in a row"}.loop({{0, 0},    {200, 0}, {200, 100}, {0, 100},  {0, 50},   {40, 50},  {40, 60},
                                            {60, 60},  {60, 50}, {120, 50},  {120, 60}, {140, 60}, {140, 40}, {120, 40},
                                            {120, 50}, {60, 50}, {60, 40},   {40, 40},  {40, 50},  {0, 50}}),
        Case{"repeated vertices"}.loop({{0, 0}, {100, 0}, {100, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 100}, {0, 0}}),
        Case{"spike outwards"}.loop({{0, 0}, {100, 0}, {100, 100}, {150, 100}, {100, 100}, {0, 100}}),
        Case{"spike inwards"}.loop({{0, 0}, {100, 0}, {100, 50}, {50, 50}, {100, 50}, {100, 100}, {0, 100}}),
        Case{"spike along an edge"}.loop({{0, 0}, {70, 0}, {30, 0}, {100, 0}, {100, 100}, {0, 100}}),
        Case{"branching slit"}.loop({{0, 0},
                                     {100, 0},
                                     {100, 50},
                                     {60, 50},
                                     {40, 70},
                                     {60, 50},
                                     {40, 30},
                                     {60, 50},
                                     {100, 50},
                                     {100, 100},
                                     {0, 100}}),
        Case{"slit of its own"}.loop(big).loop({{20, 20}, {80, 70}}).loop({{20, 80}, {30, 90}, {40, 80}, {30, 90}}),
        Case{"lone points inside"}.loop(big).loop({{20, 20}}).loop({{70, 71}}).loop({{70, 20}}).loop({{120, 20}}),
        Case{"hole touches a reflex vertex"}
            .loop({{0, 0}, {100, 0}, {100, 100}, {50, 40}, {0, 100}})
            .loop({{50, 40}, {60, 10}, {40, 10}}),
        Case{"figure eight that touches itself"}.loop({{0, 0}, {50, 50}, {100, 0}, {100, 100}, {50, 50}, {0, 100}}),
        Case{"island in a hole"}.loop(big).loop(squareHole(20, 20, 60)).loop(square(40, 40, 20)),
        Case{"island that touches its hole"}.loop(big).loop(squareHole(20, 20, 60)).loop(square(20, 20, 20)),
        Case{"collinear runs"}.loop({{0, 0},
                                     {10, 0},
                                     {20, 0},
                                     {90, 0},
                                     {100, 0},
                                     {100, 50},
                                     {100, 100},
                                     {50, 100},
                                     {0, 100},
                                     {0, 99},
                                     {0, 98}}),
    };
}

/// As large, thin or round as input may be.
inline std::vector<Case> extreme() {
    constexpr int kMax = 1 << 30;
    return {
        Case{"sliver"}.loop({{0, 0}, {1'000'000'000, 0}, {1'000'000'000, 1}, {0, 1}}),
        Case{"needle"}.loop({{-kMax, -kMax}, {kMax, kMax - 1}, {kMax, kMax}}),
        Case{"full extent"}
            .loop({{-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax}, {-kMax, kMax}})
            .loop(squareHole(-5, -5, 10)),
        Case{"cocircular"}.loop({{25, 0},   {24, 7},   {20, 15}, {15, 20},  {7, 24},   {0, 25},    {-7, 24},
                                 {-15, 20}, {-20, 15}, {-24, 7}, {-25, 0},  {-24, -7}, {-20, -15}, {-15, -20},
                                 {-7, -24}, {0, -25},  {7, -24}, {15, -20}, {20, -15}, {24, -7}}),
        Case{"circle of 4096"}.loop(circle(0, 0, 5e8, 4096)),
        lattice(8),
    };
}

/// Degenerate enough to break a triangulator.
inline std::vector<Case> refused() {
    using tri::Outcome;
    const std::vector<Point> big = square(0, 0, 100);
    return {
        Case{"flat"}.loop({{0, 0}, {10, 0}, {20, 0}}).expect(Outcome::Degenerate),
        Case{"flat and slanted"}.loop({{0, 0}, {30, 10}, {60, 20}, {90, 30}}).expect(Outcome::Degenerate),
        Case{"there and back"}.loop({{0, 0}, {10, 5}}).expect(Outcome::Degenerate),
        Case{"one place"}.loop({{3, 3}, {3, 3}, {3, 3}, {3, 3}}).expect(Outcome::Degenerate),
        Case{"hole fills the outline"}.loop(big).loop(squareHole(0, 0, 100)).expect(Outcome::Degenerate),
        Case{"nothing"}.expect(Outcome::Degenerate),
        Case{"empty loops"}.loop({}).loop({}).expect(Outcome::Degenerate),
        Case{"bow tie"}.loop({{0, 0}, {100, 100}, {100, 0}, {0, 70}}).expect(Outcome::Crossing),
        Case{"hole across the outline"}.loop(big).loop(squareHole(90, 40, 20)).expect(Outcome::Crossing),
        Case{"hole outside"}.loop(big).loop(squareHole(190, 40, 20)).expect(Outcome::Crossing),
        Case{"holes overlap"}
            .loop(big)
            .loop(squareHole(20, 20, 30))
            .loop(squareHole(40, 40, 30))
            .expect(Outcome::Crossing),
        Case{"hole twice"}
            .loop(big)
            .loop(squareHole(20, 20, 30))
            .loop(squareHole(20, 20, 30))
            .expect(Outcome::Crossing),
        Case{"outline twice"}.loop(big).loop(big).expect(Outcome::Crossing),
        Case{"region within a region"}.loop(big).loop(square(20, 20, 30)).expect(Outcome::Crossing),
        Case{"outline clockwise"}.loop(reversed(big)).expect(Outcome::Crossing),
        Case{"holes overlap along an edge"}
            .loop(big)
            .loop(squareHole(20, 20, 30))
            .loop(squareHole(20, 30, 10))
            .expect(Outcome::Crossing),
    };
}

/// All of these.
inline std::vector<Case> nasty() {
    std::vector<Case> all;
    for (const std::vector<Case>& some : {touching(), extreme(), refused()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace cases
