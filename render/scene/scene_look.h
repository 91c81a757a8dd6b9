#pragma once

#include <vector>

#include "render/scene/board_scene.h"
#include "render/scene/scene_layers.h"

namespace render {

/// How a scene looks at a moment, with all that its users set: heights, styles, colours, states of elements. A picture
/// that is drawn later shows the board so.
class SceneLook {
public:
    /// As it looks now.
    explicit SceneLook(BoardScene& scene);
    /// The same scene looks so again, from the next frame on.
    void applyTo(BoardScene& scene) const;

private:
    SceneLayers m_layers;
    std::vector<std::vector<ElementState>> m_states;  ///< by step
};

}  // namespace render
