#include "render/frame/frame_copies.h"

#include <algorithm>

namespace render {
namespace {

/// Workgroups along x that every device dispatches (Vulkan's required limit).
constexpr std::uint32_t kMaxDispatch = 65535;

bool isBoxInView(const shader::FrameData& data, const glm::vec3& middle, const glm::vec3& extent) {
    // As in_view.glsl does: what cannot be compared is in view.
    return std::ranges::none_of(data.planes, [&](const glm::vec4& plane) {
        const glm::vec3 normal(plane);
        return glm::dot(normal, middle) + glm::dot(glm::abs(normal), extent) + plane.w < 0.0F;
    });
}

/// `data` is the copy's own.
bool isInView(const shader::FrameData& data, const SceneStep& step, const LayerPlan& layers) {
    float low = 1e30F;
    float high = -1e30F;
    for (const LayerBatch& batch : layers.batches) {
        for (const std::uint32_t layer : batch) {
            low = std::min(low, layers.states[layer].z0 - data.boreProtrusionMm);
            high = std::max(high, layers.states[layer].z1 + data.boreProtrusionMm);
        }
    }
    if (step.standard) {
        return true;  // the paper's standard pipeline leaves nothing out
    }
    const glm::vec3 from(step.reachMin, low);
    const glm::vec3 to(step.reachMax, high);
    return low <= high && isBoxInView(data, 0.5F * (from + to) - data.centre, 0.5F * (to - from));
}

VkDeviceAddress putStates(gpu::Frame& frame, const LayerPlan& layers) {
    return frame.put(std::span<const shader::LayerState>(layers.states)).address;
}

}  // namespace

shader::FrameData frameOfCopy(const shader::FrameData& board, const ModelCopy& copy) {
    // The turn is its own transpose's inverse.
    const glm::dmat2 back = glm::transpose(copy.rotation);
    const auto rotateBack = [&](glm::dvec2 v) { return glm::vec2(back * v); };
    shader::FrameData data = board;
    data.clipFromBoard = glm::mat4(glm::dmat4(board.clipFromBoard) * glm::dmat4(glm::dmat3(copy.rotation)));
    for (glm::vec4& plane : data.planes) {
        plane = {rotateBack(glm::vec2(plane)), plane.z, plane.w};
    }
    data.eye = {rotateBack(glm::vec2(board.eye)), board.eye.z, board.eye.w};
    data.centre = {rotateBack(glm::dvec2(board.centre) - copy.origin), board.centre.z};
    for (glm::vec3 shader::FrameData::*vector :
         {&shader::FrameData::screen, &shader::FrameData::screenRight, &shader::FrameData::screenDown}) {
        data.*vector = {rotateBack(glm::vec2(board.*vector)), (board.*vector).z};
    }
    data.light = rotateBack(board.light);
    data.sectionPlane = {rotateBack(glm::vec2(board.sectionPlane)), board.sectionPlane.z};
    return data;
}

FrameCopies::FrameCopies(gpu::Frame& frame, const FramePlan& plan, const BoardScene::Impl& scene)
    : m_frame(frame),
      m_plan(plan),
      m_scene(scene),
      m_upright(putStates(frame, plan.upright)),
      m_flipped(scene.layers.hasFlipped ? putStates(frame, plan.flipped) : m_upright),
      m_palette(frame.put(std::span<const glm::vec3>(scene.layers.palette)).address) {
    for (std::uint32_t row = 0; row < scene.copies.size(); ++row) {
        add(scene.copies[row], row);
    }
}

void FrameCopies::add(const ModelCopy& copy, std::uint32_t row) {
    const SceneStep& step = m_scene.steps[copy.step];
    const LayerPlan& layers = copy.isFlipped ? m_plan.flipped : m_plan.upright;
    // The board itself keeps its numbers to the last bit.
    shader::FrameData data = row == 0 ? m_plan.data : frameOfCopy(m_plan.data, copy);
    if (step.isEmpty() || ((data.flags & shader::kFrameCull) != 0 && !isInView(data, step, layers))) {
        return;
    }
    const std::uint64_t bytes = step.listBytes();
    if (m_groups.empty() || m_used + bytes > m_scene.lists.size()) {
        m_groups.emplace_back();
        m_used = 0;
    }
    const DrawLists lists = step.listsAt(m_scene.lists, m_used);
    m_used += bytes;
    step.setAddresses(data, lists);
    data.layers = copy.isFlipped ? m_flipped : m_upright;
    data.palette = m_palette;
    data.letDrawCount = static_cast<std::uint32_t>(layers.batches.size()) * shader::kBucketCount;
    data.maxDispatch = kMaxDispatch;
    data.copy = row;
    const VkDeviceAddress address = m_frame.put(std::span<const shader::FrameData>(&data, 1)).address;
    m_groups.back().push_back({m_frame, m_plan, m_scene, layers, step, lists, copy.isMirrored, address});
}

}  // namespace render
