#include "model/formats/kicad/shapes/largest_outline.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "model/geometry/edges.h"
#include "model/geometry/loops/edge_union.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

auto keyOf(const ChainEdge& edge) {
    return std::tuple(edge.from.point.x, edge.from.point.y, edge.to.x, edge.to.y, edge.from.edge, edge.from.centre.x,
                      edge.from.centre.y);
}

ChainEdge reversed(const ChainEdge& edge) {
    ChainEdge back{edge.from, edge.from.point};
    back.from.point = edge.to;
    back.from.edge = model::reversed(edge.from.edge);
    return back;
}

/// In an order and directions that do not depend on how they come, for ends that are near each other are joined one
/// after the other.
std::vector<ChainEdge> inOrder(std::span<const ChainEdge> edges) {
    std::vector<ChainEdge> sorted;
    sorted.reserve(edges.size());
    for (const ChainEdge& edge : edges) {
        const ChainEdge back = reversed(edge);
        sorted.push_back(keyOf(back) < keyOf(edge) ? back : edge);
    }
    std::ranges::sort(sorted, {}, [](const ChainEdge& edge) { return keyOf(edge); });
    return sorted;
}

/// Edges cross only where they share a range of x: are there too many such pairs?
bool isTangle(std::span<const Edge> edges) {
    std::vector<Box> boxes;
    for (const Edge& edge : edges) {
        boxes.push_back(boxOf(edge));
    }
    std::ranges::sort(boxes, {}, [](const Box& box) { return box.min.x; });
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].min.x <= boxes[i].max.x; ++j) {
            if (++pairs > kMostSideBySide) {
                return true;
            }
        }
    }
    return false;
}

/// The regions of a drawing; its loops where they cannot be told.
std::vector<ShapeSketch> outlinesOf(std::span<const ChainEdge> drawing, double tolerance) {
    std::vector<Edge> edges;
    for (const ChainEdge& edge : drawing) {
        edges.push_back(edgeOf(edge.from, edge.to));
    }
    std::vector<ShapeSketch> outlines;
    if (const auto regions = isTangle(edges) ? std::nullopt : enclosedBy(edges)) {
        for (const EdgeLoops& region : *regions) {
            outlines.push_back(sketchOf({&region, 1}));
        }
        return outlines;
    }
    for (const std::vector<PathNode>& loop : chained(drawing, tolerance).loops) {
        addPath(outlines.emplace_back(), loop, false);
    }
    return outlines;
}

}  // namespace

ShapeSketch largestOutline(std::span<const ChainEdge> edges, double tolerance) {
    ShapeSketch largest;
    // Of those that are as large, the one that lies furthest left and down.
    std::tuple<std::int64_t, std::int64_t, std::int64_t> best;
    for (const std::vector<ChainEdge>& drawing : drawings(inOrder(edges), tolerance)) {
        for (ShapeSketch& outline : outlinesOf(drawing, tolerance)) {
            const Box box = boxOf(outline);
            const std::tuple size(box.width() * box.height(), -std::int64_t{box.min.x}, -std::int64_t{box.min.y});
            if (box.width() > 0 && box.height() > 0 && (largest.isEmpty() || size > best)) {
                best = size;
                largest = std::move(outline);
            }
        }
    }
    return largest;
}

}  // namespace model::kicad
