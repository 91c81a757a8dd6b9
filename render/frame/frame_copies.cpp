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
    const glm::vec3 from(step.reach.min, low);
    const glm::vec3 to(step.reach.max, high);
    return low <= high && isBoxInView(data, 0.5F * (from + to) - data.centre, 0.5F * (to - from));
}

/// The frame as a copy sees it: camera, frustum and light in the coordinates of its step.
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
    data.keyLight = {rotateBack(glm::vec2(board.keyLight)), board.keyLight.z};
    data.sectionPlane = {rotateBack(glm::vec2(board.sectionPlane)), board.sectionPlane.z};
    return data;
}

}  // namespace

std::vector<CopyGroup> copiesInView(gpu::Frame& frame, const FramePlan& plan, const BoardScene::Impl& scene) {
    const VkDeviceAddress upright = frame.put(plan.upright.states).address;
    const VkDeviceAddress flipped = scene.layers.hasFlipped ? frame.put(plan.flipped.states).address : upright;
    const VkDeviceAddress palette = frame.put(scene.layers.palette).address;
    std::vector<CopyGroup> groups;
    std::uint64_t used = 0;  // of the scene's lists by the last group
    for (std::uint32_t row = 0; row < scene.copies.size(); ++row) {
        const ModelCopy& copy = scene.copies[row];
        const SceneStep& step = scene.steps[copy.step];
        const LayerPlan& layers = copy.isFlipped ? plan.flipped : plan.upright;
        // The board itself keeps its numbers to the last bit.
        shader::FrameData data = row == 0 ? plan.data : frameOfCopy(plan.data, copy);
        if (step.isEmpty() || ((data.flags & shader::kFrameCull) != 0 && !isInView(data, step, layers))) {
            continue;
        }
        const std::uint64_t bytes = step.listBytes();
        if (groups.empty() || used + bytes > scene.lists.size()) {
            groups.emplace_back();
            used = 0;
        }
        const DrawLists lists = step.listsAt(scene.lists, used);
        used += bytes;
        step.setAddresses(data, lists);
        step.setShadows(data, plan.isFromAbove != copy.isFlipped);
        data.layers = copy.isFlipped ? flipped : upright;
        data.palette = palette;
        data.letDrawCount = static_cast<std::uint32_t>(layers.batches.size()) * shader::kDrawCount;
        data.maxDispatch = kMaxDispatch;
        const VkDeviceAddress address = frame.put(std::span(&data, 1)).address;
        groups.back().push_back({frame, plan, scene, layers, step, lists, copy.isMirrored, address, data.shadows});
    }
    return groups;
}

}  // namespace render
