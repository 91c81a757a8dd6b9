#include "model/formats/odb/painting/swept_tracks.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/formats/common/outlines.h"
#include "model/formats/common/region.h"
#include "model/geometry/boolean.h"

namespace model::odb {

namespace {

/// Sides of a pen times chords of a way: about a second of work at most.
constexpr std::size_t kMostSides = 50'000;

std::vector<Point> wayOf(const PathNode& from, Point end, const Discretisation& chords) {
    std::vector<Point> way;
    discretiseEdge(from, end, chords, way);
    way.push_back(end);
    return way;
}

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

/// 1 if the way from `a` to `b` leads to the left of a direction, -1 to its right, 0 along it.
int sideOf(Point direction, Point a, Point b) {
    const std::int64_t cross = direction.x * (std::int64_t{b.y} - a.y) - direction.y * (std::int64_t{b.x} - a.x);
    return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

/// How many chords, from the first on, lead to one side of a direction.
std::size_t chordsToOneSide(Point direction, std::span<const Point> way) {
    int side = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const int next = sideOf(direction, way[i], way[i + 1]);
        if (next * side < 0) {
            return i;
        }
        side = next != 0 ? next : side;
    }
    return way.size() - 1;
}

/// What one side of a pen passes. As long as the way leads to one side of it that is a polygon without crossings.
PolygonSet passedBy(Point from, Point to, std::span<const Point> way) {
    PolygonSet passed;
    const Point direction{to.x - from.x, to.y - from.y};
    while (way.size() > 1) {
        const std::size_t chords = chordsToOneSide(direction, way);
        std::vector<Point> loop = shifted(way.first(chords + 1), from);
        const std::vector<Point> back = shifted(way.first(chords + 1), to);
        loop.insert(loop.end(), back.rbegin(), back.rend());
        passed.beginPolygon();
        passed.addLoop(loop);
        way = way.subspan(chords);
    }
    return passed;
}

/// Any pen covers its start and whatever its boundary passes.
std::vector<PolygonSet> coversOfSides(const PolygonSet& pen, std::span<const Point> way) {
    std::vector<PolygonSet> covers(1);
    addPen(covers.front(), pen, way.front());
    for (std::size_t l = 0; l < pen.loopCount(); ++l) {
        const std::span<const Point> loop = pen.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            covers.push_back(passedBy(loop[i], loop[(i + 1) % loop.size()], way));
        }
    }
    return covers;
}

/// A convex pen covers the hull of both ends of each chord.
std::vector<PolygonSet> coversOfChords(const PolygonSet& pen, std::span<const Point> way) {
    std::vector<PolygonSet> covers(way.size() - 1);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        addHull(covers[i], pen.loop(0), way[i], way[i + 1]);
    }
    return covers;
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
            covers[i].append(covers[i + 1]);
            covers[i / 2] = unite(covers[i]);
        }
        if (covers.size() % 2 == 1) {
            covers[covers.size() / 2] = std::move(covers.back());
        }
        covers.resize((covers.size() + 1) / 2);
    }
    return std::move(covers.front());
}

PolygonSet sweptAlong(const PolygonSet& pen, std::span<const Point> way) {
    return uniteNeighbours(isConvex(pen) ? coversOfChords(pen, way) : coversOfSides(pen, way));
}

}  // namespace

PolygonSet penOf(const SymbolShape& shape, const Discretisation& chords) {
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
    return polygonsOf(sketch, chords);
}

PolygonSet sweep(const PolygonSet& pen, const PathNode& from, Point end) {
    return sweptAlong(pen, wayOf(from, end, kFinestSweep));
}

SweptTrack sweep(const SymbolShape& shape, const PolygonSet& finestPen, const PathNode& from, Point end) {
    PolygonSet coarsePen;
    const PolygonSet* pen = &finestPen;
    for (Discretisation chords = kFinestSweep; chords.chordToleranceNm <= Discretisation::kMaxChordNm;) {
        const std::vector<Point> way = wayOf(from, end, chords);
        if (pen->points.size() * way.size() <= kMostSides) {
            return {sweptAlong(*pen, way), chords.chordToleranceNm};
        }
        chords.chordToleranceNm *= 10;
        coarsePen = penOf(shape, chords);
        pen = &coarsePen;
    }
    return {};
}

}  // namespace model::odb
