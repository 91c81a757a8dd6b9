#include "model/geometry/swept_tracks.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/geometry/boolean.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model {

namespace {

/// Sides of a pen times chords of a path: about a second of work at most.
constexpr std::size_t kMostSides = 50'000;

std::vector<Point> pathOf(const PathNode& from, Point end, const Discretisation& chords) {
    std::vector<Point> path;
    discretiseEdge(from, end, chords, path);
    path.push_back(end);
    return path;
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

/// 1 if the path from `a` to `b` leads to the left of a direction, -1 to its right, 0 along it.
int sideOf(Point direction, Point a, Point b) {
    const std::int64_t cross = direction.x * (std::int64_t{b.y} - a.y) - direction.y * (std::int64_t{b.x} - a.x);
    return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

/// How many chords, from the first on, lead to one side of a direction.
std::size_t chordsToOneSide(Point direction, std::span<const Point> path) {
    int side = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const int next = sideOf(direction, path[i], path[i + 1]);
        if (next * side < 0) {
            return i;
        }
        side = next != 0 ? next : side;
    }
    return path.size() - 1;
}

/// What one side of a pen passes. As long as the path leads to one side of it that is a polygon without crossings.
PolygonSet passedBy(Point from, Point to, std::span<const Point> path) {
    PolygonSet passed;
    const Point direction{to.x - from.x, to.y - from.y};
    while (path.size() > 1) {
        const std::size_t chords = chordsToOneSide(direction, path);
        std::vector<Point> loop = shifted(path.first(chords + 1), from);
        const std::vector<Point> back = shifted(path.first(chords + 1), to);
        loop.insert(loop.end(), back.rbegin(), back.rend());
        passed.beginPolygon();
        passed.addLoop(loop);
        path = path.subspan(chords);
    }
    return passed;
}

/// Any pen covers its start and whatever its boundary passes.
std::vector<PolygonSet> coversOfSides(const PolygonSet& pen, std::span<const Point> path) {
    std::vector<PolygonSet> covers(1);
    addPen(covers.front(), pen, path.front());
    for (std::size_t l = 0; l < pen.loopCount(); ++l) {
        const std::span<const Point> loop = pen.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            covers.push_back(passedBy(loop[i], loop[(i + 1) % loop.size()], path));
        }
    }
    return covers;
}

/// A convex pen covers the hull of both ends of each chord.
std::vector<PolygonSet> coversOfChords(const PolygonSet& pen, std::span<const Point> path) {
    std::vector<PolygonSet> covers(path.size() - 1);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        addHull(covers[i], pen.loop(0), path[i], path[i + 1]);
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

PolygonSet sweptAlong(const PolygonSet& pen, std::span<const Point> path) {
    return uniteNeighbours(isConvex(pen) ? coversOfChords(pen, path) : coversOfSides(pen, path));
}

}  // namespace

PolygonSet sweep(const PolygonSet& pen, const PathNode& from, Point end) {
    return sweptAlong(pen, pathOf(from, end, kFinestSweep));
}

SweptTrack sweep(const ShapeSketch& pen, const PolygonSet& finest, const PathNode& from, Point end) {
    PolygonSet coarse;
    const PolygonSet* sides = &finest;
    for (Discretisation chords = kFinestSweep; chords.chordToleranceNm <= Discretisation::kMaxChordNm;) {
        const std::vector<Point> path = pathOf(from, end, chords);
        if (sides->points.size() * path.size() <= kMostSides) {
            return {sweptAlong(*sides, path), chords.chordToleranceNm};
        }
        chords.chordToleranceNm *= 10;
        coarse = polygonsOf(pen, chords);
        sides = &coarse;
    }
    return {};
}

}  // namespace model
