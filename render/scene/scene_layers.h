#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/modelling/substrate_margins.h"
#include "render/scene/explosion.h"
#include "render/scene/layer_style.h"
#include "render/scene/view_settings.h"
#include "shaders/shared/frame.h"

namespace render {

/// What planning a frame must know of a scene; no device needed.
struct SceneLayers {
    SceneLayers() = default;
    explicit SceneLayers(const BoardFrame& frame);

    std::vector<FrameLayer> layers;             ///< with areas in any step
    std::vector<LayerInSubstrate> inSubstrate;  ///< one per layer; the standard pipeline's says nothing
    std::vector<LayerStyle> styles;             ///< likewise
    std::array<glm::vec3, shader::kElementColourCount> palette{};  ///< linear; colours of single elements
    float widthMm = 0.0F;                                          ///< longer side of the board
    float facesMm = 0.0F;                                          ///< BoardFrame::facesMm
    bool hasFlipped = false;                                       ///< some copies are flipped
};

/// Where layers are drawn: their heights after explosion.
[[nodiscard]] std::vector<ZRange> drawnHeights(const SceneLayers& scene, const ViewSettings& settings);

/// An sRGB colour, 0 to 1, as light.
[[nodiscard]] glm::vec3 toLinear(const glm::vec3& srgb);

}  // namespace render
