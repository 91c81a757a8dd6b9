#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "tests/unit/tri/cases.h"

namespace cases {

/// Random polygons: those that touch in every way but never cross, and those that do.
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

}  // namespace cases
