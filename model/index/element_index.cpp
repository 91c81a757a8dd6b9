#include "model/index/element_index.h"

#include "model/base/parallel.h"

namespace model {

ElementIndex::ElementIndex(const Document& step, std::span<const Box> boxes)
    : m_layers(step.layers.size(), OfLayer{0, BoxIndex({})}) {
    const auto largestFirst =
        base::largestFirst(m_layers.size(), [&](std::size_t row) { return step.layers[row].elements.count; });
    base::parallelFor(m_layers.size(), [&](std::size_t i) {
        const Range& elements = step.layers[largestFirst[i]].elements;
        m_layers[largestFirst[i]] = {elements.first, BoxIndex(boxes.subspan(elements.first, elements.count))};
    });
}

void ElementIndex::visit(const Box& box, const std::function<void(std::uint32_t)>& visit) const {
    for (const OfLayer& layer : m_layers) {
        visitIn(layer, box, visit);
    }
}

void ElementIndex::visit(LayerId layer, const Box& box, const std::function<void(std::uint32_t)>& visit) const {
    visitIn(m_layers[layer.row()], box, visit);
}

void ElementIndex::visitIn(const OfLayer& layer, const Box& box, const std::function<void(std::uint32_t)>& visit) {
    layer.boxes.visit(box, [&](std::uint32_t row) { visit(layer.first + row); });
}

}  // namespace model
