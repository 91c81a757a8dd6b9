#include "model/geometry/nesting.h"

#include <algorithm>

#include "model/geometry/discretise.h"

namespace model {

namespace {

bool contains(const Box& outer, const Box& inner) {
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.max.x >= inner.max.x &&
           outer.max.y >= inner.max.y;
}

std::vector<Point> discretised(const PathNodes& path) {
    std::vector<Point> loop;
    for (std::size_t i = 0; i < path.size(); ++i) {
        discretiseEdge(path, i, {}, loop);
    }
    return loop;
}

/// Even-odd test with a ray to the right. Points on the loop count as either: a touching hole is decided by its other
/// points.
bool isInside(std::span<const Point> loop, Point p) {
    bool isIn = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Point& a = loop[i];
        const Point& b = loop[j];
        if ((a.y > p.y) != (b.y > p.y)) {
            const double x = a.x + (double(p.y) - a.y) / (double(b.y) - a.y) * (double(b.x) - a.x);
            isIn = isIn != (p.x < x);
        }
    }
    return isIn;
}

/// Do most of the hole's points lie inside? Holes may touch their island.
bool isMostlyInside(std::span<const Point> island, std::span<const Point> hole) {
    const auto inside = std::ranges::count_if(hole, [&](Point p) { return isInside(island, p); });
    return 2 * static_cast<std::size_t>(inside) > hole.size();
}

struct Island {
    std::size_t contour;
    Box box;
    std::vector<Point> loop;  ///< made on first need
    std::vector<std::size_t> holes;
};

/// Finds the island of a hole among the sketch's islands.
class Nester {
public:
    explicit Nester(const ShapeSketch& sketch) : m_sketch(sketch) {}

    std::vector<Island> run() {
        for (std::size_t i = 0; i < m_sketch.contourCount(); ++i) {
            if (!m_sketch.isHole(i)) {
                m_islands.push_back({i, boxOfPath(m_sketch.contour(i), true), {}, {}});
            }
        }
        std::size_t before = 0;  // islands that come before the hole
        for (std::size_t i = 0; i < m_sketch.contourCount(); ++i) {
            if (!m_sketch.isHole(i)) {
                ++before;
            } else if (before > 0) {
                m_islands[islandOf(i, before - 1)].holes.push_back(i);
            }
        }
        return std::move(m_islands);
    }

private:
    std::size_t islandOf(std::size_t hole, std::size_t preceding) {
        const Box box = boxOfPath(m_sketch.contour(hole), true);
        std::vector<std::size_t> candidates;
        for (std::size_t i = 0; i < m_islands.size(); ++i) {
            if (contains(m_islands[i].box, box)) {
                candidates.push_back(i);
            }
        }
        if (candidates.size() == 1) {
            return candidates.front();
        }
        std::ranges::sort(candidates, {}, [&](std::size_t i) {
            return std::pair(
                static_cast<double>(m_islands[i].box.width()) * static_cast<double>(m_islands[i].box.height()), i);
        });
        const std::vector<Point> loop = discretised(m_sketch.contour(hole));
        const auto found =
            std::ranges::find_if(candidates, [&](std::size_t i) { return isMostlyInside(loopOf(i), loop); });
        return found == candidates.end() ? preceding : *found;
    }

    const std::vector<Point>& loopOf(std::size_t island) {
        if (m_islands[island].loop.empty()) {
            m_islands[island].loop = discretised(m_sketch.contour(m_islands[island].contour));
        }
        return m_islands[island].loop;
    }

    const ShapeSketch& m_sketch;
    std::vector<Island> m_islands;
};

void copyContour(const ShapeSketch& from, std::size_t contour, ShapeSketch& to) {
    to.beginContour(from.isHole(contour));
    to.addNodes(from.contour(contour));
}

bool hasSeveralIslandsAndHoles(const ShapeSketch& sketch) {
    std::size_t islands = 0;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        islands += sketch.isHole(i) ? 0 : 1;
    }
    return islands > 1 && islands < sketch.contourCount();
}

}  // namespace

ShapeSketch nestHoles(ShapeSketch sketch) {
    if (!hasSeveralIslandsAndHoles(sketch)) {
        return sketch;
    }
    ShapeSketch nested;
    for (const Island& island : Nester(sketch).run()) {
        copyContour(sketch, island.contour, nested);
        for (const std::size_t hole : island.holes) {
            copyContour(sketch, hole, nested);
        }
    }
    return nested;
}

}  // namespace model
