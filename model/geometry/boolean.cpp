#include "model/geometry/boolean.h"

#include <algorithm>
#include <new>
#include <polyclipping/clipper.hpp>

#include "model/geometry/clear_loops.h"

namespace model {

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

Paths toPaths(const PolygonSet& set) {
    Paths paths(set.loopCount());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (const Point& point : set.loop(i)) {
            paths[i].emplace_back(point.x, point.y);
        }
    }
    return paths;
}

std::vector<Point> toLoop(const Path& path) {
    std::vector<Point> loop;
    loop.reserve(path.size());
    for (const ClipperLib::IntPoint& point : path) {
        loop.push_back({static_cast<Nm>(point.X), static_cast<Nm>(point.Y)});
    }
    return loop;
}

/// Outlines and the holes directly below them; islands inside holes start polygons of their own.
void collect(const ClipperLib::PolyNode& parent, PolygonSet& out) {
    for (const ClipperLib::PolyNode* outline : parent.Childs) {
        out.beginPolygon();
        if (!out.addLoop(toLoop(outline->Contour))) {
            out.polygons.pop_back();
            continue;
        }
        for (const ClipperLib::PolyNode* hole : outline->Childs) {
            out.addLoop(toLoop(hole->Contour));
        }
        for (const ClipperLib::PolyNode* hole : outline->Childs) {
            collect(*hole, out);
        }
    }
}

/// polyclipping keeps to itself what is thrown inside, above all where memory runs out, and leaves an empty result:
/// that must not pass for one. It says the same of operands without an area, whose result is empty indeed.
class Clip {
public:
    explicit Clip(int options = 0) : m_clipper(options) {}

    void add(const Paths& paths, ClipperLib::PolyType operand) {
        m_hasEdges = m_clipper.AddPaths(paths, operand, true) || m_hasEdges;
    }
    /// Keeps corners on straight lines that come up, not those of what was added before.
    void keepCornersOnLines() { m_clipper.PreserveCollinear(true); }
    /// `Result` is Paths or a PolyTree.
    template <class Result>
    void execute(ClipperLib::ClipType type, Result& result) {
        const bool isDone = m_clipper.Execute(type, result, ClipperLib::pftPositive, ClipperLib::pftPositive);
        if (m_hasEdges && !isDone) {
            throw std::bad_alloc();
        }
    }

private:
    ClipperLib::Clipper m_clipper;
    bool m_hasEdges = false;
};

LoopSet toLoops(const Paths& paths) {
    LoopSet loops;
    for (const Path& path : paths) {
        const std::vector<Point> loop = toLoop(path);
        loops.points.insert(loops.points.end(), loop.begin(), loop.end());
        loops.loopStart.push_back(static_cast<std::uint32_t>(loops.points.size()));
    }
    return loops;
}

/// To split loops where they touch themselves, polyclipping compares every two corners of each: is that more than to
/// look whether they do at all?
bool areSplitSlowly(const Paths& paths) {
    constexpr double kComparedPerCorner = 2000.0;
    double corners = 0.0;
    double compared = 0.0;
    for (const Path& path : paths) {
        const auto count = static_cast<double>(path.size());
        corners += count;
        compared += count * count;
    }
    return compared > kComparedPerCorner * corners;
}

bool passesPointTwice(const ClipperLib::PolyTree& tree) {
    for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
        std::vector<Point> loop = toLoop(node->Contour);
        std::ranges::sort(loop);
        if (std::ranges::adjacent_find(loop) != loop.end()) {
            return true;
        }
    }
    return false;
}

/// What sortSplit() makes of them, to the last point and in the same order, but in time n log n; false, and the tree is
/// of no use, if that cannot be told beforehand. To be strictly simple, polyclipping does four things more: it puts
/// corners where sides lie within a nanometre of each other on a level line, and where a top touches a level side
/// (neither happens to clear loops), it keeps corners on straight lines (so do we), and it splits loops that pass a
/// point twice (we look for any).
bool sortClear(const Paths& paths, ClipperLib::PolyTree& tree) {
    if (!areSplitSlowly(paths) || !areClear(toLoops(paths))) {
        return false;
    }
    Clip clip;
    clip.add(paths, ClipperLib::ptSubject);
    clip.keepCornersOnLines();
    clip.execute(ClipperLib::ctUnion, tree);
    return !passesPointTwice(tree);
}

/// Splits loops where they touch themselves.
void sortSplit(const Paths& paths, ClipperLib::PolyTree& tree) {
    Clip clip(ClipperLib::ioStrictlySimple);
    clip.add(paths, ClipperLib::ptSubject);
    clip.execute(ClipperLib::ctUnion, tree);
}

/// Loops that do not overlap, sorted into polygons.
PolygonSet sorted(const Paths& paths) {
    ClipperLib::PolyTree tree;
    if (!sortClear(paths, tree)) {
        sortSplit(paths, tree);
    }
    PolygonSet result;
    collect(tree, result);
    return result;
}

/// Outlines wind +1 and holes -1 in a PolygonSet, so "any polygon covers it" is winding > 0. Which hole is whose is
/// found out in a pass of its own: polyclipping looks through all loops each time it joins two while it keeps a tree of
/// them, and the strokes of a hatch make it join thousands, which are gone in the second pass.
PolygonSet execute(ClipperLib::ClipType type, const PolygonSet& subject, const PolygonSet& other) {
    Clip clip;
    clip.add(toPaths(subject), ClipperLib::ptSubject);
    clip.add(toPaths(other), ClipperLib::ptClip);
    Paths paths;
    clip.execute(type, paths);
    return sorted(paths);
}

}  // namespace

PolygonSet unite(const PolygonSet& set) {
    return execute(ClipperLib::ctUnion, set, {});
}

LoopSet unitedLoops(const LoopSet& set) {
    Paths paths(set.loopStart.size() - 1);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (std::uint32_t k = set.loopStart[i]; k < set.loopStart[i + 1]; ++k) {
            paths[i].emplace_back(set.points[k].x, set.points[k].y);
        }
    }
    Clip clip;
    clip.add(paths, ClipperLib::ptSubject);
    Paths united;
    clip.execute(ClipperLib::ctUnion, united);
    return toLoops(united);
}

PolygonSet subtract(const PolygonSet& from, const PolygonSet& what) {
    return execute(ClipperLib::ctDifference, from, what);
}

PolygonSet intersect(const PolygonSet& a, const PolygonSet& b) {
    return execute(ClipperLib::ctIntersection, a, b);
}

PolygonSet grow(const PolygonSet& set, double distance) {
    PolygonSet all;
    const Paths paths = toPaths(set);
    for (const PolygonSet::Polygon& polygon : set.polygons) {
        ClipperLib::ClipperOffset offset(3.0);  // sharper corners than 39 degrees are cut off
        offset.AddPath(paths[polygon.firstLoop], ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
        Paths grown;
        offset.Execute(grown, distance);
        Clip clip(ClipperLib::ioStrictlySimple);
        clip.add(grown, ClipperLib::ptSubject);
        Paths holes(paths.begin() + polygon.firstLoop + 1, paths.begin() + polygon.firstLoop + polygon.loopCount);
        ClipperLib::ReversePaths(holes);
        clip.add(holes, ClipperLib::ptClip);
        ClipperLib::PolyTree tree;
        clip.execute(ClipperLib::ctDifference, tree);
        collect(tree, all);
    }
    return unite(all);
}

}  // namespace model
