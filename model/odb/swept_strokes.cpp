#include "model/odb/swept_strokes.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/geometry/boolean.h"
#include "model/odb/outlines.h"
#include "model/odb/region.h"

namespace model::odb {

namespace {

constexpr Discretisation kPenChords{500.0, false};

Point shifted(Point p, Point by) {
    return {p.x + by.x, p.y + by.y};
}

std::vector<Point> shifted(std::span<const Point> loop, Point by) {
    std::vector<Point> moved;
    for (const Point point : loop) {
        moved.push_back(shifted(point, by));
    }
    return moved;
}

/// One loop that is its own hull; collinear points do not matter.
bool isConvex(const PolygonSet& pen) {
    if (pen.loopCount() != 1) {
        return false;
    }
    const std::span<const Point> loop = pen.loop(0);
    const std::vector<Point> hull = convexHull({loop.begin(), loop.end()});
    return hull.size() >= 3 && twiceArea(hull) == twiceArea(loop);
}

/// A convex pen covers the hull of its two ends.
void addHull(PolygonSet& cover, std::span<const Point> pen, Point a, Point b) {
    std::vector<Point> corners = shifted(pen, a);
    const std::vector<Point> other = shifted(pen, b);
    corners.insert(corners.end(), other.begin(), other.end());
    cover.beginPolygon();
    cover.addLoop(convexHull(std::move(corners)));
}

void addPen(PolygonSet& cover, const PolygonSet& pen, Point at) {
    for (const PolygonSet::Polygon& polygon : pen.polygons) {
        cover.beginPolygon();
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            cover.addLoop(shifted(pen.loop(polygon.firstLoop + i), at));
        }
    }
}

/// Any other pen covers both ends and whatever its boundary passes: a parallelogram per side.
void addSides(PolygonSet& cover, const PolygonSet& pen, Point a, Point b) {
    addPen(cover, pen, a);
    addPen(cover, pen, b);
    for (std::size_t l = 0; l < pen.loopCount(); ++l) {
        const std::span<const Point> loop = pen.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point from = loop[i];
            const Point to = loop[(i + 1) % loop.size()];
            const std::vector<Point> side =
                convexHull({shifted(from, a), shifted(to, a), shifted(to, b), shifted(from, b)});
            if (side.size() >= 3) {
                cover.beginPolygon();
                cover.addLoop(side);
            }
        }
    }
}

void append(PolygonSet& to, const PolygonSet& from) {
    for (const PolygonSet::Polygon& polygon : from.polygons) {
        to.beginPolygon();
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            to.addLoop(from.loop(polygon.firstLoop + i));
        }
    }
}

/// Two by two, then those two by two: a large pen on a long arc covers places hundreds of times, and uniting all at
/// once would look at every pair of edges there.
PolygonSet uniteNeighbours(std::vector<PolygonSet> covers) {
    if (covers.empty()) {
        return {};
    }
    for (PolygonSet& cover : covers) {
        cover = unite(cover);
    }
    while (covers.size() > 1) {
        for (std::size_t i = 0; i + 1 < covers.size(); i += 2) {
            append(covers[i], covers[i + 1]);
            covers[i / 2] = unite(covers[i]);
        }
        if (covers.size() % 2 == 1) {
            covers[covers.size() / 2] = std::move(covers.back());
        }
        covers.resize((covers.size() + 1) / 2);
    }
    return std::move(covers.front());
}

}  // namespace

PolygonSet penOf(const SymbolShape& shape) {
    ShapeSketch sketch = shape.region;
    switch (shape.kind) {
        case SymbolShape::Kind::Nothing: return {};
        case SymbolShape::Kind::Round: addDisc(sketch, shape.width, false); break;
        case SymbolShape::Kind::Ring:
            addDisc(sketch, shape.width, false);
            addDisc(sketch, shape.height, true);
            break;
        case SymbolShape::Kind::Oval: addOval(sketch, shape.width, shape.height, false); break;
        case SymbolShape::Kind::Region: break;
    }
    return polygonsOf(sketch, kPenChords);
}

PolygonSet sweep(const PolygonSet& pen, const PathNode& from, Point end) {
    std::vector<Point> path;
    discretiseEdge(from, end, kPenChords, path);
    path.push_back(end);
    const bool convex = isConvex(pen);
    std::vector<PolygonSet> covers;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        PolygonSet& cover = covers.emplace_back();
        if (convex) {
            addHull(cover, pen.loop(0), path[i], path[i + 1]);
        } else {
            addSides(cover, pen, path[i], path[i + 1]);
        }
    }
    return uniteNeighbours(std::move(covers));
}

}  // namespace model::odb
