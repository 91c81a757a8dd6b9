#pragma once

#include <memory>
#include <span>

#include "model/base/result.h"
#include "render/scene/element_state.h"
#include "render/tiles/flat_picture.h"

namespace app {

/// Flat pictures without a graphics device: processors draw what the device would (render/tiles), in a fraction of the
/// time that a software device takes to start, and where there is none (decision 225).
class FlatRender {
public:
    /// `states` by step, as BoardScene::setStates takes them.
    FlatRender(std::shared_ptr<const render::BoardModel> board, std::span<const render::LayerStyle> styles,
               std::span<const render::ElementStates> states, std::uint32_t width, std::uint32_t height);

    /// Errors: DeviceFailed where it takes the device; render::FlatPicture says what it does not draw.
    [[nodiscard]] base::Result<render::Image> draw(const render::Camera& camera, const render::ViewSettings& settings);

private:
    std::uint32_t m_width;
    std::uint32_t m_height;
    render::SceneLayers m_layers;
    std::vector<std::vector<render::ElementState>> m_states;
    render::FlatPicture m_picture;
};

}  // namespace app
