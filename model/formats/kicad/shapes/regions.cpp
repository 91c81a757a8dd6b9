#include "model/formats/kicad/shapes/regions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/geometry/discretise.h"
#include "model/geometry/loops/edge_union.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"
#include "model/geometry/slits.h"
#include "model/geometry/vectors.h"

namespace model::kicad {

namespace {

using base::toDouble;

EdgeLoops circle(PointD centre, double radius) {
    EdgeLoops loops;
    loops.addCircle(centre, radius);
    return loops;
}

/// Along chords, for arcs that are tighter than the pen.
std::vector<EdgeLoops> penAlongChords(const PathNode& from, Point to, double width) {
    std::vector<Point> points;
    discretiseEdge(from, to, kBooleanChords, points);
    points.push_back(to);
    std::vector<EdgeLoops> capsules;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        capsules.emplace_back().addCapsule(toDouble(points[i]), toDouble(points[i + 1]), width / 2.0);
    }
    return capsules;
}

std::vector<EdgeLoops> penAlongCircle(PointD centre, double radius, double half) {
    EdgeLoops ring;
    ring.addCircle(centre, radius + half);
    if (radius > half) {
        ring.addCircle(centre, radius - half);
    }
    return {ring};
}

std::vector<EdgeLoops> penAlongArc(const PathNode& from, Point to, double half) {
    const PointD a = toDouble(from.point);
    const PointD b = toDouble(to);
    const PointD centre = toDouble(from.centre);
    const double ra = distance(centre, a);
    const double rb = distance(centre, b);
    const auto at = [&](PointD p, double r, double offset) {
        return PointD{centre.x + (p.x - centre.x) * (r + offset) / r, centre.y + (p.y - centre.y) * (r + offset) / r};
    };
    const bool isClockwise = from.edge == EdgeKind::ArcClockwise;
    EdgeLoops band;
    band.addArc(at(a, ra, half), at(b, rb, half), centre, isClockwise);
    band.addArc(at(b, rb, half), at(b, rb, -half), b, isClockwise);
    band.addArc(at(b, rb, -half), at(a, ra, -half), centre, !isClockwise);
    band.addArc(at(a, ra, -half), at(a, ra, half), a, isClockwise);
    if (!band.endLoop()) {
        return {};
    }
    return {band};
}

std::vector<EdgeLoops> boundaryPen(const ShapeSketch& sketch, double width) {
    std::vector<EdgeLoops> pens;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        const PathNodes nodes = sketch.contour(i);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            for (EdgeLoops& pen : penAlong(nodes[n], nodes.endOf(n), width)) {
                pens.push_back(std::move(pen));
            }
        }
    }
    return pens;
}

/// A loop of lines moved to its right: arcs around the corners where it turns left, and there and back through the
/// corner where it turns right. What then has a winding number above 0 is what lies within the distance.
void addOffsetLoop(EdgeLoops& offset, std::span<const Edge> loop, double distanceNm) {
    const auto beside = [&](const Edge& edge, PointD p) {
        const double length = distance(edge.a, edge.b);
        return PointD{p.x + distanceNm * (edge.b.y - edge.a.y) / length,
                      p.y - distanceNm * (edge.b.x - edge.a.x) / length};
    };
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Edge& edge = loop[i];
        const Edge& next = loop[i + 1 < loop.size() ? i + 1 : 0];
        const PointD end = beside(edge, edge.b);
        const PointD start = beside(next, edge.b);
        offset.addLine(beside(edge, edge.a), end);
        const PointD u = {edge.b.x - edge.a.x, edge.b.y - edge.a.y};
        const PointD v = {next.b.x - next.a.x, next.b.y - next.a.y};
        const double cross = u.x * v.y - u.y * v.x;
        if (cross < 0.0) {
            offset.addLine(end, edge.b);
            offset.addLine(edge.b, start);
        } else if (distance(end, start) < 1.0) {
            offset.addLine(end, start);
        } else {
            offset.addArc(end, start, edge.b, false);
        }
    }
    offset.loopStart.push_back(static_cast<std::uint32_t>(offset.edges.size()));
}

/// Regions with straight edges, grown; no value for others, and where that cannot be relied on.
std::optional<std::vector<EdgeLoops>> offsetStraight(std::span<const EdgeLoops> regions, double distanceNm) {
    std::vector<EdgeLoops> grown;
    for (const EdgeLoops& region : regions) {
        const bool isStraight = std::ranges::none_of(region.edges, [](const Edge& edge) { return edge.isArc(); });
        EdgeLoops offset;
        for (std::size_t loop = 0; loop < region.loopCount() && isStraight; ++loop) {
            addOffsetLoop(offset, region.loop(loop), distanceNm);
        }
        std::optional<std::vector<EdgeLoops>> clean = isStraight ? cleaned(offset) : std::nullopt;
        if (!clean) {
            return {};
        }
        grown.insert(grown.end(), clean->begin(), clean->end());
    }
    return grown;
}

}  // namespace

std::vector<EdgeLoops> regionsOf(const PathNodes& contour) {
    ShapeSketch sketch;
    addPath(sketch, contour, false);
    return model::regionsOf(sketch);
}

std::vector<EdgeLoops> penAlong(const PathNode& from, Point to, double width) {
    const double half = width / 2.0;
    if (half <= 0.0) {
        return {};
    }
    const double radius = distance(toDouble(from.centre), toDouble(from.point));
    if (!isArc(from.edge)) {
        std::vector<EdgeLoops> capsule(1);
        capsule[0].addCapsule(toDouble(from.point), toDouble(to), half);
        return capsule;
    }
    if (from.point == to) {
        return radius > 0.0 ? penAlongCircle(toDouble(from.centre), radius, half)
                            : std::vector<EdgeLoops>{circle(toDouble(to), half)};
    }
    return radius > half + 1.0 ? penAlongArc(from, to, half) : penAlongChords(from, to, width);
}

ShapeSketch united(std::span<const EdgeLoops> regions) {
    return sketchOf(unionOf(regions).regions);
}

ShapeSketch without(std::span<const EdgeLoops> from, std::span<const EdgeLoops> what) {
    return sketchOf(differenceOf(from, what).regions);
}

ShapeSketch grown(const ShapeSketch& sketch, double margin) {
    const std::optional<ShapeSketch> healed = healSlits(sketch);
    const ShapeSketch& clean = healed ? *healed : sketch;
    if (margin == 0.0) {
        return clean;
    }
    std::vector<EdgeLoops> inside = model::regionsOf(clean);
    if (margin > 0.0) {
        if (const std::optional<std::vector<EdgeLoops>> offset = offsetStraight(inside, margin)) {
            return offset->size() == 1 ? sketchOf(*offset) : united(*offset);
        }
    }
    const std::vector<EdgeLoops> pens = boundaryPen(clean, 2.0 * std::abs(margin));
    if (margin < 0.0) {
        return without(inside, pens);
    }
    inside.insert(inside.end(), pens.begin(), pens.end());
    return united(inside);
}

}  // namespace model::kicad
