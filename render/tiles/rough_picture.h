#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "render/tiles/flat_board.h"

namespace render {

/// A picture that is there already: where it lies, 0xffRRGGBB, rows from the top; no pixels: none.
struct RoughSource {
    const std::uint32_t* pixels = nullptr;
    glm::ivec2 size{0};
    PlaneMap map;
};

/// Draws what lies at `map` from `best` where it reaches, else from `rest`, else `ground`; between pixels of a source
/// the mean of its neighbours by distance (of sRGB bytes). Both must be turned like `map`.
void paintScaled(const RoughSource& best, const RoughSource& rest, std::uint32_t ground, const PlaneMap& map,
                 glm::ivec2 size, std::uint32_t* pixels);

}  // namespace render
