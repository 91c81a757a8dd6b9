#pragma once

#include <span>

#include "render/scene/scene_layers.h"
#include "shaders/shared/board.h"

namespace render {

/// On which layers the shadows of bodies fall in a frame: those with a face on the outside of the board, on the side
/// that is seen, while the bodies of that side are drawn and opaque, in shaded views with the layers together.
class ShadowedLayers {
public:
    ShadowedLayers(const SceneLayers& scene, const ViewSettings& settings, bool isFromAbove);

    /// By how much they darken where they are darkest; 0: none are drawn.
    [[nodiscard]] float strength() const { return m_strength; }
    /// Gives the states of these layers kMaterialShadowed.
    void mark(std::span<shader::LayerState> states) const;
    /// The same for a layer that lies at its mirror image.
    void markMirrored(std::uint32_t layer, shader::LayerState& state) const;

private:
    [[nodiscard]] bool reachesOut(const ZRange& z) const;
    void set(bool isShadowed, shader::LayerState& state) const;

    const SceneLayers& m_scene;
    bool m_isFromAbove;
    float m_strength;
    float m_outside;  ///< z from which on faces are outside
};

}  // namespace render
