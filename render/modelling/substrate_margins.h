#pragma once

#include <vector>

#include "model/board/document.h"

namespace render {

struct BoardModel;

/// What a layer has to do with the substrate, which hides what lies in it (render/culling/hidden_layers.h).
struct LayerInSubstrate {
    enum class Role : std::uint8_t {
        Content,
        Substrate,  ///< a part of it
        Plug        ///< its holes go through the substrate and fill them as long as they are drawn
    };
    Role role = Role::Content;
    /// How far everything on the layer that is not milled keeps inside the substrate's edge, mm; kLargestMargin if it
    /// is farther. Negative: something sticks out, or there is no substrate. Holes with a plug are no edge.
    float marginMm = -1.0F;
    bool isMilled = false;  ///< in part: what is, and what is left of it, reaches the edge at least
};

inline constexpr float kLargestMargin = 2.0F;

/// By layer. `model` has its lets, instances, vertices and walls.
[[nodiscard]] std::vector<LayerInSubstrate> findSubstrateMargins(const model::Document& document,
                                                                 const BoardModel& model);

}  // namespace render
