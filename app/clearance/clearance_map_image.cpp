#include "app/clearance/clearance_map_image.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/clearance/bitmap_text.h"
#include "model/base/units.h"
#include "model/text/formatting.h"
#include "render/scene/colour_ramp.h"

namespace app {

namespace {

constexpr glm::u8vec3 kCopper{122, 124, 130};
constexpr glm::u8vec3 kFar{24, 26, 31};
constexpr glm::u8vec3 kGround{40, 43, 50};
constexpr int kMargin = 12;
constexpr int kBarWidth = 24;
constexpr int kBarHeight = 256;
constexpr int kSwatch = 16;
constexpr int kNumbers = 5;
constexpr int kLine = 24;

glm::u8vec3 bytes(const glm::vec3& colour) {
    return glm::u8vec3(glm::round(colour * 255.0F));
}

glm::u8vec3 colourOf(float nm, double reach) {
    if (nm <= 0.0F) {
        return kCopper;
    }
    return nm > reach ? kFar : bytes(render::rampColour(static_cast<float>(nm / reach)));
}

void set(render::Image& image, int x, int y, glm::u8vec3 colour) {
    std::uint8_t* pixel = &image.rgba[(static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x)) * 4];
    std::ranges::copy(std::array<std::uint8_t, 4>{colour.r, colour.g, colour.b, 255}, pixel);
}

void fill(render::Image& image, int x, int y, int width, int height, glm::u8vec3 colour) {
    for (int row = y; row < y + height; ++row) {
        for (int column = x; column < x + width; ++column) {
            set(image, column, row, colour);
        }
    }
}

std::string millimetres(double nm) {
    std::string text = model::fixedText(nm / base::kNmPerMm, 4);
    text.erase(text.find_last_not_of('0') + 1);
    return (text.back() == '.' ? text.substr(0, text.size() - 1) : text) + " mm";
}

/// Draws from (x, y) downwards.
void drawLegend(render::Image& image, int x, int y, double reach, const std::string& title) {
    const BitmapText text;
    text.draw(image, x, y, title);
    y += 2 * kLine;
    for (int row = 0; row < kBarHeight; ++row) {
        fill(image, x, y + row, kBarWidth, 1, bytes(render::rampColour(static_cast<float>(row) / kBarHeight)));
    }
    for (int i = 0; i <= kNumbers; ++i) {
        const int at = y + i * (kBarHeight - 1) / kNumbers;
        fill(image, x + kBarWidth, at, 6, 1, text.colour);
        text.draw(image, x + kBarWidth + 10, at - text.height() / 2, millimetres(reach * i / kNumbers));
    }
    y += kBarHeight + kLine;
    for (const auto& [colour, words] :
         {std::pair(kCopper, std::string("copper")), std::pair(kFar, "> " + millimetres(reach))}) {
        fill(image, x, y, kSwatch, kSwatch, colour);
        text.draw(image, x + kBarWidth + 10, y + (kSwatch - text.height()) / 2, words);
        y += kLine;
    }
}

}  // namespace

render::Image imageOf(const model::ClearanceMap& map, double reach, const std::string& title) {
    const BitmapText text;
    const int legend = std::max(text.width(title), kBarWidth + 10 + text.width("> " + millimetres(reach) + "00"));
    const auto width = static_cast<int>(map.frame.width);
    const auto height = static_cast<int>(map.frame.height);
    const int least = 2 * kMargin + kBarHeight + 6 * kLine;
    render::Image image{static_cast<std::uint32_t>(width + legend + 2 * kMargin),
                        static_cast<std::uint32_t>(std::max(height, least)),
                        {}};
    image.rgba.resize(std::size_t{image.width} * image.height * 4);
    fill(image, 0, 0, static_cast<int>(image.width), static_cast<int>(image.height), kGround);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const std::size_t cell =
                static_cast<std::size_t>(height - 1 - row) * map.frame.width + static_cast<std::size_t>(column);
            set(image, column, row, colourOf(map.nm[cell], reach));
        }
    }
    drawLegend(image, width + kMargin, kMargin, reach, title);
    return image;
}

}  // namespace app
