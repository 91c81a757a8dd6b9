#include "model/index/element_index.h"

namespace model {

ElementIndex::ElementIndex(const Document& step, std::span<const Box> boxes) {
    for (const Layer& layer : step.layers) {
        m_layers.push_back({layer.elements.first, BoxIndex(boxes.subspan(layer.elements.first, layer.elements.count))});
    }
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
