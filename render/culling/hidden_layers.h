#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "render/modelling/substrate_margins.h"
#include "shaders/shared/board.h"

namespace render {

/// How a frame looks at the board, whatever the pixel.
struct Sight {
    bool isOutside = false;   ///< the eye is above or below everything that is visible
    bool isFromAbove = true;  ///< which of the two
    /// Millimetres the flattest line of sight moves sideways while it passes one millimetre of height.
    float flatness = std::numeric_limits<float>::infinity();
    /// Where the board is nearest. What is thinner than a part of a pixel there is so everywhere.
    float pixelsPerMm = std::numeric_limits<float>::infinity();
};

struct EyePoint {
    glm::dmat4 clipFromCentred{1.0};  ///< of positions relative to `centre`
    glm::dvec3 centre{0.0};
    float pixelsPerMm = 0.0F;  ///< at w = 1
};

/// What is seen of the heights from `low` to `high` mm.
[[nodiscard]] Sight sightOf(const EyePoint& eye, float low, float high);

/// Walls of fewer pixels are not drawn: tilted as boards are looked at, less than a third of a pixel would show.
inline constexpr float kThinPx = 0.6F;

/// Leaves out what opaque substrate hides. Layers in it or behind it lose kLayerVisible, or, where some of it is milled
/// at the board's edge, get kLayerMilledOnly; barrels that go through it end a little below its surface. Holes let
/// nobody see into it while the layers that fill them are visible and opaque. `layers` are in the rows of `states`.
void hideBuried(std::span<const LayerInSubstrate> layers, const Sight& sight, std::vector<shader::LayerState>& states);

}  // namespace render
