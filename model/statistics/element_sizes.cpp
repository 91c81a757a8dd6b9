#include "model/statistics/element_sizes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/parallel.h"
#include "model/figures/tracks.h"
#include "model/geometry/curve_queries.h"
#include "model/geometry/discretise.h"
#include "model/geometry/edges.h"
#include "model/geometry/path_length.h"

namespace model {

namespace {

constexpr double kPi = std::numbers::pi;

double square(double v) {
    return v * v;
}

/// Its tracks, and a round end.
double trailArea(const Document& document, ElementId trail) {
    double area = kPi / 4.0 * square(document.trails[document.elements.geometry[trail.row()]].width);
    forEachTrack(document, trail,
                 [&](const PathNode& node, Point end, Nm width, Nm) { area += pathLength(node, end) * width; });
    return area;
}

double lineArea(const LineGeometry& line, bool isSquare) {
    const double length = pathLength({line.a, {}, EdgeKind::Line}, line.b);
    if (isSquare) {
        // An axis-parallel square swept along: itself, and what its two leading sides pass.
        return square(line.width) +
               line.width * (std::abs(double{1} * line.b.x - line.a.x) + std::abs(double{1} * line.b.y - line.a.y));
    }
    return length * line.width + kPi / 4.0 * square(line.width) - length * line.innerWidth -
           kPi / 4.0 * square(line.innerWidth);
}

double arcArea(const ArcGeometry& arc) {
    const bool isRing = arc.node.point == arc.end;
    return pathLength(arc.node, arc.end) * arc.width + (isRing ? 0.0 : kPi / 4.0 * square(arc.width));
}

double shapeArea(const ShapeTable& shapes, ShapeId shape) {
    double area = 0.0;
    for (const Contour& contour : shapes.contoursOf(shape)) {
        const auto nodes = shapes.nodesOf(contour);
        double own = 0.0;
        const PointD base = base::toDouble(nodes[0].point);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            own += nodes[i].edge == EdgeKind::Curve ? areaUnder(bezierPieces(nodes.curveAt(i)), base)
                                                    : areaUnder(edgeOf(nodes[i], nodes.endOf(i)), base);
        }
        area += contour.isHole ? -std::abs(own) : std::abs(own);
    }
    return area;
}

}  // namespace

double lengthOf(const Document& document, ElementId element) {
    double length = 0.0;
    forEachTrack(document, element, [&](const PathNode& node, Point end, Nm, Nm) { length += pathLength(node, end); });
    return length;
}

double areaOf(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    const std::uint8_t flags = document.elements.flags[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Line: return lineArea(document.lines[row], (flags & kSquarePen) != 0);
        case ElementKind::Arc: return arcArea(document.arcs[row]);
        case ElementKind::Circle: {
            const CircleGeometry& circle = document.circles[row];
            const double inner = (flags & kHole) != 0 ? 0.0 : square(circle.innerDiameter);
            return kPi / 4.0 * (square(circle.diameter) - inner);
        }
        case ElementKind::Trail: return trailArea(document, element);
        case ElementKind::Area: return shapeArea(document.shapes, document.areas[row].shape);
    }
    return 0.0;
}

std::vector<double> copperAreas(const Document& document) {
    std::vector<double> areas(document.layers.size());
    base::parallelFor(areas.size(), [&](std::size_t row) {
        const Layer& layer = document.layers[row];
        if (!layer.isCopper()) {
            return;
        }
        double sum = 0.0;
        for (std::uint32_t i = 0; i < layer.elements.count; ++i) {
            sum += areaOf(document, ElementId{layer.elements.first + i});
        }
        areas[row] = sum;
    });
    std::vector<std::vector<double>> ofSteps;
    for (const auto& step : document.steps) {
        ofSteps.push_back(copperAreas(*step));
    }
    for (const StepInstance& instance : document.instances) {
        const std::vector<double>& copied = ofSteps[instance.step];
        for (std::size_t row = 0; row < std::min(copied.size(), areas.size()); ++row) {
            areas[document.layerOfCopy(LayerId{row}, instance.isFlipped).row()] += copied[row];
        }
    }
    return areas;
}

}  // namespace model
