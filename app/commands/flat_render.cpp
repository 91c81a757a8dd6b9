#include "app/commands/flat_render.h"

#include <algorithm>

namespace app {

namespace {

/// What a device takes for the samples of a picture, about.
constexpr std::uint64_t kBytesPerPixel = 64;

render::SceneLayers layersOf(const render::BoardModel& board, std::span<const render::LayerStyle> styles) {
    render::SceneLayers layers(board);
    layers.styles.assign(styles.begin(), styles.end());
    return layers;
}

}  // namespace

FlatRender::FlatRender(std::shared_ptr<const render::BoardModel> board, std::span<const render::LayerStyle> styles,
                       std::span<const render::ElementStates> states, std::uint32_t width, std::uint32_t height)
    : m_width(width),
      m_height(height),
      m_layers(layersOf(*board, styles)),
      m_picture(std::move(board),
                std::max(render::FlatPicture::kMaxBytes, std::uint64_t{width} * height * kBytesPerPixel)) {
    for (const render::ElementStates& step : states) {
        m_states.emplace_back(step.bytes().begin(), step.bytes().end());
    }
}

base::Result<render::Image> FlatRender::draw(const render::Camera& camera, const render::ViewSettings& settings) {
    constexpr double kAsLongAsItTakes = 0.0;
    const render::FlatPicture::Quality quality =
        m_picture.draw({&m_layers, m_states, camera, settings, static_cast<int>(m_width), static_cast<int>(m_height)},
                       kAsLongAsItTakes);
    if (quality != render::FlatPicture::Quality::Exact) {
        return base::Error{base::ErrorCode::DeviceFailed, "this picture takes a Vulkan device"};
    }
    render::Image image{m_width, m_height, {}};
    const std::shared_ptr<const render::FlatPicture::Pixels> pixels = m_picture.pixels();
    image.rgba.reserve(pixels->size() * 4);
    for (const std::uint32_t pixel : *pixels) {
        for (const std::uint32_t shift : {16U, 8U, 0U, 24U}) {
            image.rgba.push_back(static_cast<std::uint8_t>(pixel >> shift));
        }
    }
    return image;
}

}  // namespace app
