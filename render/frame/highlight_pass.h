#pragma once

#include "render/backends/scene_drawer.h"
#include "render/frame/render_target.h"

namespace render {

/// Draws what is highlighted or has a colour of its own over the picture of a board that `target` has begun, through
/// all that covers it and, unless it is very much or the view moves, with a dark outline. `wanted` is planned for
/// Subject::StandingOut.
void drawStandingOut(gpu::Frame& frame, const RenderTarget& target, SceneDrawer& drawer, const FramePlan& wanted,
                     const BoardScene::Impl& scene, LevelOfDetail levels);

/// Elements that stand out, in all copies of steps.
[[nodiscard]] std::size_t countStandingOut(const BoardScene::Impl& scene);

/// Clears depth or stencil of a target that is being drawn to.
void clear(VkCommandBuffer commands, VkImageAspectFlags aspects, VkExtent2D extent);

}  // namespace render
