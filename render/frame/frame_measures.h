#pragma once

#include <cstdint>
#include <optional>

#include "render/scene/board_scene.h"
#include "render/scene/camera.h"
#include "render/standard/standard_model.h"

namespace render {

/// Numbers that only a benchmark requests.

/// Memory of a model's columns.
[[nodiscard]] std::uint64_t cpuBytes(const BoardModel& model);
[[nodiscard]] std::uint64_t cpuBytes(const StandardModel& model);

/// Mean squared difference of grey levels (0 to 1, sRGB luma) over all pixels, as the paper compares its pipelines
/// (there below 0.03). Pictures of different size differ by 1.
[[nodiscard]] double greyMse(const Image& a, const Image& b);

/// Triangles of the frame of this size that was drawn last from `scene`, from the draw lists that the culling pass
/// left on the device; faces that a layer turns away are not among them, translucent layers count once. In the hybrid
/// pipeline the frame must have been drawn by the pull back end; the others make the same choices. None if the device
/// is lost, or if the copies of a panel were drawn in several groups.
[[nodiscard]] std::optional<std::uint64_t> drawnTriangles(BoardScene& scene, const Camera& camera,
                                                          const ViewSettings& settings, std::uint32_t width,
                                                          std::uint32_t height);

}  // namespace render
