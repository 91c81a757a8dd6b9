#include "render/scene/element_state.h"

#include <algorithm>

namespace render {

std::vector<ElementState> plainStates(std::size_t elements) {
    constexpr std::size_t kWord = shader::kElementsPerWord;
    return std::vector<ElementState>((elements + kWord - 1) / kWord * kWord);
}

void ElementStates::add(std::span<const model::ElementId> elements, ElementState bits) {
    for (const model::ElementId element : elements) {
        m_bytes.resize(std::max(m_bytes.size(), element.row() + 1));
        m_bytes[element.row()] |= bits;
    }
}

}  // namespace render
