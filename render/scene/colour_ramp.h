#pragma once

#include <glm/glm.hpp>

namespace render {

/// The colour of a number from 0 to 1 (others count as the nearest of these), sRGB: yellow, green, teal, blue, violet.
/// It gets darker all the way, so that the order is seen whatever colours the eye distinguishes, and in grey prints.
[[nodiscard]] glm::vec3 rampColour(float value);

}  // namespace render
