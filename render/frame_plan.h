#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/hiding.h"
#include "render/let_tables.h"
#include "render/view.h"
#include "shaders/shared/frame.h"

namespace render {

/// What planning a frame must know of a scene; no device needed.
struct SceneLayers {
    struct Layer {
        float z0 = 0.0F;  ///< before explosion, mm
        float z1 = 0.0F;
        bool hasAreas = false;  ///< in any step
        bool isCopper = false;
        std::uint32_t growth = 0;  ///< BoardFrame::layerGrowth
        model::LayerId opposite;   ///< where the layer of a flipped copy lies; none: at its own mirror image
    };
    std::vector<Layer> layers;
    std::vector<LayerInLaminate> inLaminate;  ///< one per layer; the standard pipeline's says nothing
    std::vector<LayerStyle> styles;           ///< likewise
    std::array<glm::vec3, shader::kElementColourCount> palette{};  ///< linear; colours of single elements
    float widthMm = 0.0F;                                          ///< longer side of the board
    float facesMm = 0.0F;                                          ///< BoardFrame::facesMm
    bool hasFlipped = false;                                       ///< some copies are flipped
};

/// Layers that are drawn together.
using LayerBatch = std::vector<std::uint32_t>;

/// The layers of a step as a copy shows them: upright, or flipped on the layers of the other side. Rows are the step's.
struct LayerPlan {
    std::vector<shader::LayerState> states;
    std::vector<LayerBatch> batches;  ///< [0] all opaque layers from the front, then one per translucent layer
                                      ///< from the back
    std::vector<SeenFaces> faces;     ///< per layer
};

/// Everything decided on the CPU before a frame is recorded.
struct FramePlan {
    LayerPlan upright;
    LayerPlan flipped;         ///< empty if nothing is flipped; its batches are those of the layers its own lie on
    SeenFaces faces;           ///< of any layer
    bool isCut = false;        ///< the board is cut open (ViewSettings::cut)
    shader::FrameData data{};  ///< for the board itself, all but the addresses and counts of the scene
};

/// Where layers are drawn: their heights after explosion.
[[nodiscard]] std::vector<ZRange> drawnHeights(const SceneLayers& scene, const ViewSettings& settings);

/// `width` and `height` of the picture in pixels.
[[nodiscard]] FramePlan planFrame(const SceneLayers& scene, const Camera& camera, const ViewSettings& settings,
                                  std::uint32_t width, std::uint32_t height);

/// Does the frame look straight at one face, in parallel projection?
[[nodiscard]] bool isFlatView(const FramePlan& plan);

/// An sRGB colour, 0 to 1, as light.
[[nodiscard]] glm::vec3 toLinear(const glm::vec3& srgb);

}  // namespace render
