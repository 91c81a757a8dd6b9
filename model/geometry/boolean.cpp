#include "model/geometry/boolean.h"

#include <polyclipping/clipper.hpp>

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

/// Loops that do not overlap, sorted into polygons.
PolygonSet sorted(const Paths& paths) {
    ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
    PolygonSet result;
    collect(tree, result);
    return result;
}

/// Outlines wind +1 and holes -1 in a PolygonSet, so "any polygon covers it" is winding > 0. Which hole is whose is
/// found out in a pass of its own: polyclipping looks through all loops each time it joins two while it keeps a tree of
/// them, and the strokes of a hatch make it join thousands, which are gone in the second pass.
PolygonSet execute(ClipperLib::ClipType type, const PolygonSet& subject, const PolygonSet& clip) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(toPaths(subject), ClipperLib::ptSubject, true);
    clipper.AddPaths(toPaths(clip), ClipperLib::ptClip, true);
    Paths paths;
    clipper.Execute(type, paths, ClipperLib::pftPositive, ClipperLib::pftPositive);
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
    ClipperLib::Clipper clipper;
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    Paths united;
    clipper.Execute(ClipperLib::ctUnion, united, ClipperLib::pftPositive, ClipperLib::pftPositive);
    LoopSet result;
    for (const Path& path : united) {
        const std::vector<Point> loop = toLoop(path);
        result.points.insert(result.points.end(), loop.begin(), loop.end());
        result.loopStart.push_back(static_cast<std::uint32_t>(result.points.size()));
    }
    return result;
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
        ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
        clipper.AddPaths(grown, ClipperLib::ptSubject, true);
        for (std::uint32_t i = 1; i < polygon.loopCount; ++i) {
            Path hole = paths[polygon.firstLoop + i];
            ClipperLib::ReversePath(hole);
            clipper.AddPath(hole, ClipperLib::ptClip, true);
        }
        ClipperLib::PolyTree tree;
        clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
        collect(tree, all);
    }
    return unite(all);
}

}  // namespace model
