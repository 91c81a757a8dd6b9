#include "model/formats/common/board_outline.h"

#include <numeric>

#include "model/geometry/outlines.h"

namespace model::formats {

namespace {

Box boxOf(const ShapeSketch& sketch) {
    Box box;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        box.include(boxOfPath(sketch.contour(i), true));
    }
    return box;
}

bool isBoardCopper(const Layer& layer) {
    return layer.isCopper() && layer.context == LayerContext::Board;
}

std::uint64_t copperElements(const Document& step) {
    std::uint64_t count = 0;
    for (const Layer& layer : step.layers) {
        if (isBoardCopper(layer)) {
            count = std::accumulate(layer.countsWithCopies.begin(), layer.countsWithCopies.end(), count);
        }
    }
    return count;
}

/// Calls `visit(box, count)` for every element on a copper layer, and for every copy of a step with all its copper.
template <class Visit>
void forEachCopper(const Document& document, Visit visit) {
    for (const Layer& layer : document.layers) {
        for (std::uint32_t i = 0; i < layer.elements.count && isBoardCopper(layer); ++i) {
            visit(document.boxOf(ElementId{layer.elements.first + i}), 1);
        }
    }
    for (const StepInstance& instance : document.instances) {
        const Document& step = *document.steps[instance.step];
        visit(instance.placement.boxOf(step.board), copperElements(step));
    }
}

}  // namespace

bool fitsCopper(const ShapeSketch& outline, const Document& soFar) {
    const Box box = boxOf(outline).grownBy(1'000'000);
    std::uint64_t inside = 0;
    std::uint64_t all = 0;
    forEachCopper(soFar, [&](const Box& element, std::uint64_t count) {
        all += count;
        inside += box.holds(element.middle()) ? count : 0;
    });
    return 2 * inside >= all;
}

std::optional<ShapeSketch> outlineOfCopper(const Document& soFar) {
    Box box;
    forEachCopper(soFar, [&](const Box& element, std::uint64_t) { box.include(element); });
    if (box.isEmpty() || box.width() == 0 || box.height() == 0) {
        return std::nullopt;
    }
    ShapeSketch sketch;
    addBox(sketch, box);
    return sketch;
}

}  // namespace model::formats
