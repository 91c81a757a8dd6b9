#include "model/clearance/annular_ring.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/base/parallel.h"
#include "model/clearance/layer_geometry.h"
#include "model/figures/distance.h"

namespace model {

namespace {

/// The line from a point inside of a figure to its nearest edge; nothing if the point lies outside.
std::optional<Spacing> shortestOut(const FigureTable& table, std::size_t row, PointD p) {
    if (table[row].isFilled) {
        return isInside(table, row, p) ? std::optional(spacingToEdges(table, row, p)) : std::nullopt;
    }
    Edge dot;
    dot.a = dot.b = p;
    // Of a track: across it, where its middle line is nearest.
    std::optional<Spacing> farthest;
    for (Edge edge : table.edges(row)) {
        const double pen = std::exchange(edge.pen, 0.0);
        Spacing spacing = spacingBetween(dot, edge);
        const double deep = pen - spacing.distance;
        if (deep > 0 && (!farthest || deep > farthest->distance)) {
            const double scale = spacing.distance > 0 ? pen / spacing.distance : 0.0;
            const PointD out{spacing.to.x + scale * (p.x - spacing.to.x), spacing.to.y + scale * (p.y - spacing.to.y)};
            farthest = Spacing{deep, p, scale > 0 ? out : PointD{p.x + pen, p.y}};
        }
    }
    return farthest;
}

bool hasRings(const Document& document, ElementId hole) {
    return isPlatedHole(document.elements.flags[hole.row()]) &&
           document.elements.kind[hole.row()] == ElementKind::Circle && document.elements.net[hole.row()].isValid();
}

std::optional<AnnularRing> ringOf(const Document& document, const LayerGeometry& copper, ElementId hole) {
    const CircleGeometry& circle = document.circles[document.elements.geometry[hole.row()]];
    const PointD centre = base::toDouble(circle.centre);
    std::optional<AnnularRing> widest;
    copper.visitNear(document.boxOf(hole), 0.0, [&](std::uint32_t row) {
        const ElementId element = copper.elementOf(row);
        if (document.elements.net[element.row()] != document.elements.net[hole.row()]) {
            return;
        }
        const std::optional<Spacing> out = shortestOut(copper.figures(), row, centre);
        const double width = out ? std::max(0.0, out->distance - circle.diameter / 2.0) : 0.0;
        if (out && (!widest || width > widest->width.distance)) {
            const double part = out->distance > 0 ? (circle.diameter / 2.0) / out->distance : 0.0;
            const PointD edge{centre.x + part * (out->to.x - centre.x), centre.y + part * (out->to.y - centre.y)};
            widest = AnnularRing{hole, element, {width, width > 0 ? edge : out->to, out->to}};
        }
    });
    return widest;
}

}  // namespace

std::vector<AnnularRing> annularRings(const Document& document, LayerId layer, double below) {
    const LayerGeometry copper = layerGeometry(document, layer);
    std::vector<ElementId> holes;
    for (const Layer& drill : document.layers) {
        for (std::uint32_t i = drill.elements.first;
             drill.spans(layer) && i < drill.elements.first + drill.elements.count; ++i) {
            const ElementId hole{i};
            if (hasRings(document, hole) && document.platedSpanOf(hole).joins(layer)) {
                holes.push_back(hole);
            }
        }
    }
    std::vector<std::optional<AnnularRing>> rings(holes.size());
    base::parallelFor(holes.size(), [&](std::size_t i) { rings[i] = ringOf(document, copper, holes[i]); });
    std::vector<AnnularRing> small;
    for (const std::optional<AnnularRing>& ring : rings) {
        if (ring && ring->width.distance < below) {
            small.push_back(*ring);
        }
    }
    return small;
}

HolesWithoutRings holesWithoutRings(const Document& document) {
    HolesWithoutRings count;
    for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
        const bool isLeftOut = isPlatedHole(document.elements.flags[i]) && !hasRings(document, ElementId{i});
        const bool isRound = document.elements.kind[i] == ElementKind::Circle;
        count.notRound += isLeftOut && !isRound ? 1 : 0;
        count.withoutNet += isLeftOut && isRound ? 1 : 0;
    }
    return count;
}

}  // namespace model
