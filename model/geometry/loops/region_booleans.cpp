#include "model/geometry/loops/region_booleans.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/geometry/boolean.h"
#include "model/geometry/loops/edge_union.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model {

namespace {

PathNode nodeOf(const Edge& edge) {
    const EdgeKind kind = !edge.isArc()      ? EdgeKind::Line
                          : edge.isClockwise ? EdgeKind::ArcClockwise
                                             : EdgeKind::ArcCounterClockwise;
    return {rounded(edge.a), edge.isArc() ? rounded(edge.centre) : Point{}, kind};
}

/// False where the contour has no area: then it is left out.
bool addLoop(EdgeLoops& region, const PathNodes& contour) {
    const std::size_t before = region.loopCount();
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const PathNode& node = contour[i];
        const PointD from = base::toDouble(node.point);
        const PointD to = base::toDouble(contour.endOf(i));
        const PointD centre = base::toDouble(node.centre);
        if (!isArc(node.edge)) {
            region.addLine(from, to);
        } else if (node.point == contour.endOf(i)) {
            region.addCircle(centre, std::hypot(from.x - centre.x, from.y - centre.y));
        } else {
            region.addArc(from, to, centre, node.edge == EdgeKind::ArcClockwise);
        }
    }
    const bool isOpen = region.edges.size() > region.loopStart.back();
    return (!isOpen || region.endLoop()) && region.loopCount() > before;
}

}  // namespace

void RegionBoolean::append(RegionBoolean other) {
    isExact = isExact && other.isExact;
    std::ranges::move(other.regions, std::back_inserter(regions));
}

RegionBoolean unionOf(std::span<const EdgeLoops> regions) {
    std::optional<std::vector<EdgeLoops>> exact = unite(regions);
    return exact ? RegionBoolean{std::move(*exact), true} : RegionBoolean{regionsOf(unite(polygonsOf(regions))), false};
}

RegionBoolean differenceOf(std::span<const EdgeLoops> from, std::span<const EdgeLoops> what) {
    std::optional<std::vector<EdgeLoops>> exact = subtract(from, what);
    return exact ? RegionBoolean{std::move(*exact), true}
                 : RegionBoolean{regionsOf(subtract(polygonsOf(from), polygonsOf(what))), false};
}

ShapeSketch sketchOf(std::span<const EdgeLoops> regions) {
    ShapeSketch sketch;
    std::vector<PathNode> nodes;
    for (const EdgeLoops& region : regions) {
        for (std::size_t loop = 0; loop < region.loopCount(); ++loop) {
            nodes.clear();
            for (const Edge& edge : region.loop(loop)) {
                nodes.push_back(nodeOf(edge));
            }
            addPath(sketch, nodes, loop > 0);
        }
    }
    return sketch;
}

PolygonSet polygonsOf(std::span<const EdgeLoops> regions) {
    PolygonSet polygons;
    std::vector<Point> points;
    for (const EdgeLoops& region : regions) {
        polygons.beginPolygon();
        for (std::size_t loop = 0; loop < region.loopCount(); ++loop) {
            points.clear();
            for (const Edge& edge : region.loop(loop)) {
                discretiseEdge(nodeOf(edge), rounded(edge.b), kBooleanChords, points);
            }
            static_cast<void>(polygons.addLoop(points));
        }
    }
    return polygons;
}

std::vector<EdgeLoops> regionsOf(const ShapeSketch& sketch) {
    std::vector<EdgeLoops> regions;
    bool hasArea = false;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        if (!sketch.isHole(i)) {
            regions.emplace_back();
            hasArea = addLoop(regions.back(), sketch.contour(i));
            if (!hasArea) {
                regions.pop_back();
            }
        } else if (hasArea) {
            addLoop(regions.back(), sketch.contour(i));
        }
    }
    return regions;
}

std::vector<EdgeLoops> regionsOf(const PolygonSet& polygons) {
    std::vector<EdgeLoops> regions;
    for (const PolygonSet::Polygon& polygon : polygons.polygons) {
        EdgeLoops loops;
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            const std::span<const Point> points = polygons.loop(polygon.firstLoop + i);
            for (std::size_t k = 0; k < points.size(); ++k) {
                loops.addLine(base::toDouble(points[k]), base::toDouble(points[(k + 1) % points.size()]));
            }
            if (!loops.endLoop() && i == 0) {
                break;
            }
        }
        if (loops.loopCount() > 0) {
            regions.push_back(std::move(loops));
        }
    }
    return regions;
}

}  // namespace model
