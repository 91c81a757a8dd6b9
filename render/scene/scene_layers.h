#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/modelling/substrate_margins.h"
#include "render/scene/explosion.h"
#include "render/scene/layer_style.h"
#include "render/scene/view_settings.h"
#include "shaders/shared/frame.h"

namespace render {

using ElementColours = std::array<glm::vec3, shader::kElementColourCount + shader::kMaterialCount>;

/// An sRGB colour, 0 to 1, as light.
[[nodiscard]] glm::vec3 toLinear(const glm::vec3& srgb);

/// Colours of single elements, linear: these, those of what is highlighted from shader::kHighlightRow on, and behind
/// them those of materials (body_colours.h).
[[nodiscard]] ElementColours paletteOf(std::span<const glm::vec3> colours);

/// What planning a frame must know of a scene; no device needed.
struct SceneLayers {
    SceneLayers() = default;
    explicit SceneLayers(const BoardFrame& frame);

    std::vector<FrameLayer> layers;             ///< with areas in any step
    std::vector<LayerInSubstrate> inSubstrate;  ///< one per layer; the standard pipeline's says nothing
    std::vector<LayerStyle> styles;             ///< likewise
    ElementColours palette = paletteOf({});
    float widthMm = 0.0F;     ///< longer side of the board
    glm::vec2 facesMm{0.0F};  ///< BoardFrame::facesMm
    bool hasFlipped = false;  ///< some copies are flipped
    bool hasShadows = false;  ///< bodies of some step darken the board around them; not in the standard pipeline
};

/// Where layers are drawn: their heights after explosion; in 2D with LayerStyle::raised.
[[nodiscard]] std::vector<ZRange> drawnHeights(const SceneLayers& scene, const ViewSettings& settings);

/// `box` as high as the bodies of components reach that are drawn: they are as high as they are, on layers that are
/// scaled and apart.
[[nodiscard]] Box3 withBodies(Box3 box, const SceneLayers& scene, const ViewSettings& settings);

/// The board's lower plus its upper face as they are drawn: flipped, what is drawn at z is drawn at this minus z.
[[nodiscard]] float drawnFaces(const SceneLayers& scene, const ViewSettings& settings);

}  // namespace render
