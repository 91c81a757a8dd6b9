#pragma once

#include <glm/glm.hpp>
#include <string>

#include "render/scene/view_settings.h"

namespace app {

/// Letters of 5 × 7 dots for pictures that are made where there is no window and no font: capitals, digits, and signs
/// as in names of layers and nets; small letters are drawn as capitals, but for units, all others as a box.
struct BitmapText {
    int scale = 2;  ///< pixels of a dot
    glm::u8vec3 colour{225, 228, 233};

    [[nodiscard]] int width(const std::string& text) const { return static_cast<int>(text.size()) * 6 * scale; }
    [[nodiscard]] int height() const { return 7 * scale; }
    /// With its upper left corner there; what lies outside is left out.
    void draw(render::Image& image, int x, int y, const std::string& text) const;
};

}  // namespace app
