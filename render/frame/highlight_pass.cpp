#include "render/frame/highlight_pass.h"

#include <algorithm>
#include <memory>
#include <span>

#include "render/frame/frame_copies.h"

namespace render {
namespace {

// Drawn several times, moved to all sides, things get wider whatever they are: by this much on each side their dark
// outline, and by this much they themselves, so that tracks thinner than a pixel are seen.
constexpr float kOutlinePx[] = {1.4F, 1.8F};
constexpr float kWidenPx[] = {0.4F, 0.8F};  // no gap between copies of what is thinner than a pixel
/// Of more elements there are no outlines: they would cost more than the board, and what is so much is seen.
constexpr std::size_t kMostOutlined = 2'000;
constexpr glm::vec2 kSides[] = {{-1.0F, -1.0F}, {0.0F, -1.0F}, {1.0F, -1.0F}, {-1.0F, 0.0F},
                                {1.0F, 0.0F},   {-1.0F, 1.0F}, {0.0F, 1.0F},  {1.0F, 1.0F}};

/// A plan and what is drawn of it; recordings point at their plan.
struct MovedCopy {
    std::unique_ptr<FramePlan> plan;
    std::vector<CopyGroup> groups;
};

MovedCopy moved(gpu::Frame& frame, const FramePlan& wanted, const BoardScene::Impl& scene, glm::vec2 pixels,
                std::uint32_t flags) {
    auto plan = std::make_unique<FramePlan>(shifted(wanted, pixels));
    plan->data.flags |= flags;
    std::vector<CopyGroup> groups = copiesInView(frame, *plan, scene);
    return {std::move(plan), std::move(groups)};
}

std::vector<MovedCopy> movedToAllSides(gpu::Frame& frame, const FramePlan& wanted, const BoardScene::Impl& scene,
                                       std::span<const float> distances, std::uint32_t flags) {
    std::vector<MovedCopy> copies;
    for (const float pixels : distances) {
        for (const glm::vec2& side : kSides) {
            copies.push_back(moved(frame, wanted, scene, pixels * side, flags));
        }
    }
    return copies;
}

/// Draws all of `copies` into the same depth. They share their draw lists, which hold one group at a time: where there
/// is but one, `areListsMade` says that its lists are there already.
void draw(SceneDrawer& drawer, const RenderTarget& target, VkCommandBuffer commands,
          const std::vector<MovedCopy>& copies, bool areListsMade) {
    clear(commands, VK_IMAGE_ASPECT_DEPTH_BIT, target.extent());
    const std::size_t groups = copies.front().groups.size();
    for (std::size_t group = 0; group < groups; ++group) {
        if (!areListsMade || groups > 1) {
            target.pause(commands);
            drawer.cull(copies.front().groups[group]);
            target.resume(commands);
        }
        for (const MovedCopy& copy : copies) {
            for (const Recording& recording : copy.groups[group]) {
                gpu::Pipeline::setFrontFace(commands, recording.isMirrored);
                drawer.draw(recording, 0, gpu::Pass::Opaque);
            }
        }
    }
}

}  // namespace

void drawStandingOut(gpu::Frame& frame, const RenderTarget& target, SceneDrawer& drawer, const FramePlan& wanted,
                     const BoardScene::Impl& scene, LevelOfDetail levels) {
    std::vector<MovedCopy> copies;
    const bool isOutlined = levels != LevelOfDetail::Coarse && countStandingOut(scene) <= kMostOutlined;
    if (isOutlined) {
        draw(drawer, target, frame.commands(),
             movedToAllSides(frame, wanted, scene, kOutlinePx, shader::kFrameSilhouettes), false);
        copies = movedToAllSides(frame, wanted, scene, kWidenPx, 0);
    }
    copies.push_back(moved(frame, wanted, scene, {}, 0));
    draw(drawer, target, frame.commands(), copies, isOutlined);
}

std::size_t countStandingOut(const BoardScene::Impl& scene) {
    std::size_t count = 0;
    for (const ModelCopy& copy : scene.copies) {
        count += scene.steps[copy.step].standingOut;
    }
    return count;
}

void clear(VkCommandBuffer commands, VkImageAspectFlags aspects, VkExtent2D extent) {
    VkClearAttachment what{};  // reversed depth: 0 is farthest
    what.aspectMask = aspects;
    const VkClearRect where{{{0, 0}, extent}, 0, 1};
    vkCmdClearAttachments(commands, 1, &what, 1, &where);
}

}  // namespace render
