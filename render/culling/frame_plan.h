#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/culling/hidden_layers.h"
#include "render/modelling/let_tables.h"
#include "render/scene/camera.h"
#include "render/scene/scene_layers.h"
#include "shaders/shared/frame.h"

namespace render {

/// Layers that are drawn together.
using LayerBatch = std::vector<std::uint32_t>;

/// The layers of a step as a copy shows them: upright, or flipped on the layers of the other side. Rows are the step's.
struct LayerPlan {
    std::vector<shader::LayerState> states;
    std::vector<LayerBatch> batches;  ///< [0] all opaque layers from the front, then one per translucent layer
                                      ///< from the back
    std::vector<SeenFaces> faces;     ///< per layer
    std::vector<glm::vec3> passed;    ///< per layer: how much of each colour beneath a translucent one shows through it
};

/// What a pass over the board draws.
enum class Subject : std::uint8_t {
    Board,       ///< everything
    StandingOut  ///< what is highlighted or has a colour of its own, through all that covers it
};

/// Everything decided on the CPU before a frame is recorded.
struct FramePlan {
    LayerPlan upright;
    LayerPlan flipped;         ///< empty if nothing is flipped; its batches are those of the layers its own lie on
    SeenFaces faces;           ///< of any layer
    bool isFromAbove = true;   ///< which side of the board is seen: its bodies' shadows are those that are drawn
    bool hasSection = false;   ///< the board is cut by a section plane (ViewSettings::section)
    shader::FrameData data{};  ///< for the board itself, all but the addresses and counts of the scene
};

/// `width` and `height` of the picture in pixels.
[[nodiscard]] FramePlan planFrame(const SceneLayers& scene, const Camera& camera, const ViewSettings& settings,
                                  std::uint32_t width, std::uint32_t height, Subject subject = Subject::Board);

/// What no layer covers: linear.
[[nodiscard]] glm::vec3 backgroundOf(const ViewSettings& settings);

/// The same picture moved by so many pixels to the right and down; what is in view is not asked anew.
[[nodiscard]] FramePlan shifted(FramePlan plan, glm::vec2 pixels);

/// The depth of a level plane at height `z` (mm, as drawn) over the pixels of a picture: x * column + y * row + z, a
/// little nearer than faces in that plane are drawn, and with sample 0 of its pixels where they are smoothed. None if
/// the plane is seen edge-on.
[[nodiscard]] std::optional<glm::vec3> depthOfPlane(const Camera& camera, float z, std::uint32_t width,
                                                    std::uint32_t height, bool isSmoothed);

/// Does the frame look straight at one face, in parallel projection?
[[nodiscard]] bool isFlatView(const FramePlan& plan);

}  // namespace render
