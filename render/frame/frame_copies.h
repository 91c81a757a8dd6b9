#pragma once

#include <vector>

#include "render/backends/let_backend.h"

namespace render {

/// The copies of steps that a frame draws. What is not in view is left out here, whole copies at a time; the device
/// looks into the rest. Their draw lists lie one behind the other in the scene's buffer; when that is full, a group
/// ends and the next one takes the buffer over.
class FrameCopies {
public:
    FrameCopies(gpu::Frame& frame, const FramePlan& plan, const BoardScene::Impl& scene);

    /// None where nothing is in view.
    [[nodiscard]] const std::vector<std::vector<Recording>>& groups() const { return m_groups; }

private:
    void add(const ModelCopy& copy, std::uint32_t row);

    gpu::Frame& m_frame;
    const FramePlan& m_plan;
    const BoardScene::Impl& m_scene;
    VkDeviceAddress m_upright;
    VkDeviceAddress m_flipped;
    VkDeviceAddress m_palette;
    std::uint64_t m_used = 0;  ///< of the scene's lists by the last group
    std::vector<std::vector<Recording>> m_groups;
};

/// The frame as a copy sees it: camera, frustum and light in the coordinates of its step.
[[nodiscard]] shader::FrameData frameOfCopy(const shader::FrameData& board, const ModelCopy& copy);

}  // namespace render
