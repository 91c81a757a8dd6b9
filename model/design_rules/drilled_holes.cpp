#include "model/design_rules/drilled_holes.h"

#include <cmath>
#include <cstdlib>

namespace model {

namespace {

constexpr Nm kConcentric = 1000;  ///< holes this near to each other's middle have one middle

}  // namespace

LayerGeometry allHoles(const Document& document) {
    FigureTable figures;
    for (const Layer& layer : document.layers) {
        for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
            if ((document.elements.flags[i] & kHole) != 0) {
                figures.add(document, ElementId{i});
            }
        }
    }
    return LayerGeometry(std::move(figures));
}

DrilledHole drilledHole(const Document& document, const LayerGeometry& holes, std::uint32_t row) {
    const ElementId element = holes.elementOf(row);
    return {element, holes.figures().box(row), document.layer(document.elements.layer[element.row()]),
            isPlatedHole(document.elements.flags[element.row()])};
}

bool areConcentric(const Box& a, const Box& b) {
    const auto twice = [](const Box& box) {
        return base::PointD{double{1} * box.min.x + box.max.x, double{1} * box.min.y + box.max.y};
    };
    return std::hypot(twice(a).x - twice(b).x, twice(a).y - twice(b).y) <= 2 * kConcentric;
}

bool areOfOneSize(const Box& a, const Box& b) {
    return std::abs(a.width() - b.width()) <= kConcentric && std::abs(a.height() - b.height()) <= kConcentric;
}

bool areOfStack(const DrilledHole& a, const DrilledHole& b) {
    return a.hasSpan() && b.hasSpan() &&
           (a.layer.spanBottom <= b.layer.spanTop || b.layer.spanBottom <= a.layer.spanTop);
}

bool areOneHole(const RuleContext& context, const DrilledHole& a, const DrilledHole& b) {
    const bool isSameNet = context.owners().of(a.element) == context.owners().of(b.element);
    return areConcentric(a.box, b.box) && areOfOneSize(a.box, b.box) && a.isPlated == b.isPlated &&
           (!a.isPlated || (isSameNet && !areOfStack(a, b)));
}

}  // namespace model
