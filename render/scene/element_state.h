#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "model/base/ids.h"
#include "shaders/shared/board.h"

namespace render {

/// How an element differs from the style of its layer: shader::kElementHighlighted, kElementHidden, and the colour it
/// has of its own. 0: not at all.
using ElementState = std::uint8_t;

inline constexpr ElementState kPlain = 0;
inline constexpr ElementState kHighlighted = shader::kElementHighlighted;
inline constexpr ElementState kHidden = shader::kElementHidden;

/// ViewSettings::dim while something is shown among the rest: faint, but still of its hue.
inline constexpr float kDimRest = 0.75F;

[[nodiscard]] constexpr bool standsOut(ElementState state) {
    return (state & (shader::kElementHighlighted | shader::kElementColourMask)) != 0;
}

/// Colours of highlighted nets beside each other, sRGB; of one alone the first. No layer, solder mask or background of
/// either palette is within 70 of 255 levels of one in every channel (tests/unit/render/scene/layer_style_test.cpp).
inline constexpr std::array<glm::vec3, 6> kHighlightColours{{{1.0F, 0.0F, 0.94F},
                                                             {0.12F, 1.0F, 0.0F},
                                                             {0.0F, 1.0F, 1.0F},
                                                             {1.0F, 0.0F, 0.06F},
                                                             {0.53F, 0.0F, 1.0F},
                                                             {0.0F, 0.0F, 1.0F}}};
static_assert(shader::kHighlightRow + kHighlightColours.size() == shader::kElementColourCount);

/// In the colour of this row of BoardScene::setPalette.
[[nodiscard]] constexpr ElementState inColour(std::uint32_t row) {
    return static_cast<ElementState>((row + 1) & shader::kElementColourMask);
}

/// As the `net`-th of several that are highlighted.
[[nodiscard]] constexpr ElementState highlightedAs(std::size_t net) {
    return inColour(shader::kHighlightRow + static_cast<std::uint32_t>(net % kHighlightColours.size()));
}

/// Nothing but plain elements, for so many.
[[nodiscard]] inline std::vector<ElementState> plainStates(std::size_t elements) {
    constexpr std::size_t kWord = shader::kElementsPerWord;
    return std::vector<ElementState>((elements + kWord - 1) / kWord * kWord);
}

/// States as BoardScene::setStates takes them, with bits set for some elements.
class ElementStates {
public:
    void add(std::span<const model::ElementId> elements, ElementState bits) {
        for (const model::ElementId element : elements) {
            m_bytes.resize(std::max(m_bytes.size(), element.row() + 1));
            m_bytes[element.row()] |= bits;
        }
    }
    /// Gives elements a colour of their own in place of any that they have.
    void recolour(std::span<const model::ElementId> elements, ElementState colour) {
        add(elements, kPlain);
        for (const model::ElementId element : elements) {
            ElementState& state = m_bytes[element.row()];
            state = static_cast<ElementState>((state & ~shader::kElementColourMask) | colour);
        }
    }
    [[nodiscard]] std::span<const ElementState> bytes() const { return m_bytes; }

private:
    std::vector<ElementState> m_bytes;  ///< up to the last element that is not plain
};

}  // namespace render
