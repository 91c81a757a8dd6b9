#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/let_tables.h"
#include "render/view.h"
#include "shaders/shared/frame.h"

namespace render {

/// What planning a frame must know of a scene; no device needed.
struct SceneLayers {
    struct Layer {
        float z0 = 0.0F;  ///< before explosion, mm
        float z1 = 0.0F;
        bool hasAreas = false;
        std::uint32_t openLets = 0;  ///< lets by topology (ladder.h)
        std::uint32_t tubes = 0;
        LayerRun clusters;
        LayerRun areaBatches;
    };
    std::vector<Layer> layers;
    std::vector<LayerStyle> styles;  ///< one per layer
    float widthMm = 0.0F;            ///< longer side of the board
};

/// Layers that are drawn together.
struct LayerBatch {
    std::vector<std::uint32_t> layers;
    std::uint32_t openLets = 0;
    std::uint32_t tubes = 0;
};

/// Everything decided on the CPU before a frame is recorded.
struct FramePlan {
    std::vector<shader::LayerState> layers;
    std::vector<LayerBatch> batches;  ///< [0] all opaque layers from the front, then one per translucent layer
                                      ///< from the back
    std::vector<SeenFaces> facesOfLayers;
    SeenFaces faces;           ///< of any layer
    shader::FrameData data{};  ///< all but the addresses and counts of the scene
};

/// `width` and `height` of the picture in pixels.
[[nodiscard]] FramePlan planFrame(const SceneLayers& scene, const Camera& camera, const ViewSettings& settings,
                                  std::uint32_t width, std::uint32_t height);

/// One sRGB colour component, 0 to 1, as light.
[[nodiscard]] float toLinear(float srgb);

}  // namespace render
