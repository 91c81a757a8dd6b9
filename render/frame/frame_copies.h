#pragma once

#include <vector>

#include "render/backends/let_backend.h"

namespace render {

/// Copies of steps whose draw lists lie side by side.
using CopyGroup = std::vector<Recording>;

/// The copies of steps that a frame draws; none where nothing is in view. What is not in view is left out here, whole
/// copies at a time; the device looks into the rest. Their draw lists lie one behind the other in the scene's buffer;
/// when that is full, a group ends and the next one takes the buffer over.
[[nodiscard]] std::vector<CopyGroup> copiesInView(gpu::Frame& frame, const FramePlan& plan,
                                                  const BoardScene::Impl& scene);

}  // namespace render
