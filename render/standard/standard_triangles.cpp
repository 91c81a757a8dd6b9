#include "render/standard/standard_triangles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/base/parallel.h"
#include "model/board/copies.h"
#include "model/figures/element_polygons.h"
#include "render/modelling/area_meshes.h"

namespace render {

using model::Document;
using model::ElementKind;

namespace {

/// Triangles of a prism over n vertices and h holes: n + 2h - 2 on top and bottom, 2n on the sides.
std::uint64_t prismTriangles(std::uint64_t vertices, std::uint64_t holes) {
    return 4 * vertices + 4 * holes - 4;
}

std::uint64_t capsuleTriangles(model::Nm width, const model::Discretisation& how) {
    const int chords = model::chordCount(width / 2.0, std::numbers::pi, false, how);
    return prismTriangles(2 * (static_cast<std::uint64_t>(chords) + 1), 0);
}

std::uint64_t trackTriangles(const model::PathNode& node, model::Point end, model::Nm width,
                             const model::Discretisation& how) {
    if (node.edge == model::EdgeKind::Line) {
        return capsuleTriangles(width, how);
    }
    const double radius = std::hypot(double(node.point.x) - node.centre.x, double(node.point.y) - node.centre.y);
    const double sweep = model::sweepOf(node, end);
    const bool isFull = node.point == end;
    const auto sides =
        static_cast<std::uint64_t>(model::chordCount(radius + width / 2.0, sweep, isFull, how)) +
        static_cast<std::uint64_t>(model::chordCount(std::max(1.0, radius - width / 2.0), sweep, isFull, how));
    const auto cap = static_cast<std::uint64_t>(model::chordCount(width / 2.0, std::numbers::pi, false, how));
    return isFull ? prismTriangles(sides, 1) : prismTriangles(sides + 2 * cap, 0);
}

std::uint64_t trianglesOf(const Document& document, std::size_t row, const model::Discretisation& how) {
    const std::uint32_t geometry = document.elements.geometry[row];
    switch (document.elements.kind[row]) {
        case ElementKind::Line: return capsuleTriangles(document.lines[geometry].width, how);
        case ElementKind::Arc:
            return trackTriangles(document.arcs[geometry].node, document.arcs[geometry].end,
                                  document.arcs[geometry].width, how);
        case ElementKind::Circle: {
            const model::CircleGeometry& circle = document.circles[geometry];
            const auto outer =
                static_cast<std::uint64_t>(model::chordCount(circle.diameter / 2.0, 2 * std::numbers::pi, true, how));
            const bool isRing = circle.innerDiameter > 0;
            return prismTriangles(isRing ? 2 * outer : outer, isRing ? 1 : 0);
        }
        case ElementKind::Trail: {
            std::uint64_t sum = 0;
            const model::TrailGeometry& trail = document.trails[geometry];
            const std::span<const model::PathNode> nodes = document.nodesOf(trail);
            const std::span<const model::Nm> widths = document.widthsOf(trail);
            for (std::size_t i = 0; i < widths.size(); ++i) {
                sum += trackTriangles(nodes[i], nodes[i + 1].point, widths[i], how);
            }
            return sum;
        }
        case ElementKind::Area: return 0;  // by its shape, below
    }
    return 0;
}

/// By shape; 0 for shapes that are not in use.
std::vector<std::uint64_t> trianglesOfShapes(const Document& document, const model::Discretisation& how) {
    std::vector<std::uint64_t> triangles(document.shapes.size(), 0);
    const std::vector<model::ShapeId> used = shapesInUse(document);
    base::parallelFor(used.size(), [&](std::size_t i) {
        const model::PolygonSet set = model::discretise(document.shapes, used[i], how);
        triangles[used[i].row()] = 4 * set.points.size() + 4 * set.loopCount() - 8 * set.polygons.size();
    });
    return triangles;
}

std::uint64_t trianglesOfStep(const Document& document, const model::Discretisation& how) {
    const std::vector<std::uint64_t> ofShape = trianglesOfShapes(document, how);
    std::uint64_t sum = 0;
    for (std::size_t row = 0; row < document.elements.size(); ++row) {
        if (document.layer(document.elements.layer[row]).isSynthetic) {
            continue;
        }
        const bool isArea = document.elements.kind[row] == ElementKind::Area;
        sum += isArea ? ofShape[document.areas[document.elements.geometry[row]].shape.row()]
                      : trianglesOf(document, row, how);
    }
    return sum;
}

}  // namespace

std::uint64_t countStandardTriangles(const Document& document, const model::Discretisation& how) {
    const model::StepTree tree = model::unfoldCopies(document);
    std::vector<std::uint64_t> ofStep(tree.steps.size());
    std::ranges::transform(tree.steps, ofStep.begin(),
                           [&](const Document* step) { return trianglesOfStep(*step, how); });
    std::uint64_t sum = 0;
    for (const model::StepCopy& copy : tree.copies) {
        sum += ofStep[copy.step];
    }
    return sum;
}

}  // namespace render
