#include "render/scene/scene_look.h"

#include "render/scene/scene_buffers.h"

namespace render {

SceneLook::SceneLook(BoardScene& scene) : m_layers(scene.impl().layers) {
    for (const SceneStep& step : scene.impl().steps) {
        m_states.push_back(step.states);
    }
}

void SceneLook::applyTo(BoardScene& scene) const {
    scene.impl().layers = m_layers;
    for (std::uint32_t step = 0; step < m_states.size(); ++step) {
        scene.setStates(m_states[step], step);
    }
}

}  // namespace render
