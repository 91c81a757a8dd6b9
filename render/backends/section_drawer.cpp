#include "render/backends/section_drawer.h"

#include <algorithm>
#include <cmath>

#include "render/gpu/device_select.h"
#include "render/scene/scene_layers.h"
#include "shaders/shared/section.h"
#include "shaders/spirv.h"

namespace render {
namespace {

gpu::Pipeline makePipeline(gpu::Device& device, const TargetFormat& target, gpu::Pass pass) {
    const auto stages = gpu::drawStages(shader::spirv::kSectionFaceVert, shader::spirv::kSectionFaceFrag);
    return gpu::Pipeline(
        device, gpu::GraphicsPipelineOptions{"section faces", stages, sizeof(shader::SectionPush), pass, false,
                                             gpu::Cover::Triangles, target.colour, gpu::kDepthFormat, target.samples});
}

/// Is the eye on the side that is cut away?
bool isSeenFromFront(const shader::FrameData& data) {
    return glm::dot(glm::vec2(data.sectionPlane), glm::vec2(data.eye)) > data.sectionPlane.z * data.eye.w;
}

/// Where a face is drawn. Bodies of components keep their heights, on whichever face of their layer they stand;
/// everything else grows with its layer.
ZRange drawn(const SectionFace& face, const FrameLayer& real, const shader::LayerState& state) {
    const float thickness = real.z1 - real.z0;
    if ((state.flags & shader::kLayerGrowsUp) != 0) {
        return {state.z0 + face.bottom * thickness, state.z0 + face.top * thickness};
    }
    if ((state.flags & shader::kLayerGrowsDown) != 0) {
        return {state.z1 - (1.0F - face.bottom) * thickness, state.z1 - (1.0F - face.top) * thickness};
    }
    return {glm::mix(state.z0, state.z1, face.bottom), glm::mix(state.z0, state.z1, face.top)};
}

glm::vec3 colourOf(const SectionFace& face, const shader::LayerState& state) {
    if (!face.colour) {
        return glm::vec3(state.colour);
    }
    const auto part = [&](unsigned shift) { return static_cast<float>(*face.colour >> shift & 0xffU) / 255.0F; };
    return toLinear({part(16), part(8), part(0)});
}

/// Is a mask drawn right on its copper? Spread layers are apart.
bool isOn(const FramePlan& plan, model::LayerId mask, model::LayerId copper) {
    constexpr float kApart = 1e-4F;  // mm
    const shader::LayerState& a = plan.upright.states[mask.row()];
    const shader::LayerState& b = plan.upright.states[copper.row()];
    return std::min(std::abs(a.z0 - b.z1), std::abs(b.z0 - a.z1)) < kApart;
}

std::vector<shader::SectionTrapezoid> trapezoids(const FramePlan& plan, const SceneLayers& scene,
                                                 const SectionCut& cut) {
    std::vector<shader::SectionTrapezoid> list;
    for (const SectionFace& face : cut.faces) {
        const std::size_t layer = face.layer.row();
        const std::vector<shader::LayerState>& states = face.isMirrored ? plan.flipped.states : plan.upright.states;
        if (!scene.styles[layer].isVisible || (face.beside.isValid() && !isOn(plan, face.layer, face.beside))) {
            continue;
        }
        const std::size_t at = face.beside.isValid() ? face.beside.row() : layer;
        const ZRange z = drawn(face, scene.layers[at], states[at]);
        const auto end = [&](double along) { return glm::vec2(cut.plane.start + along * cut.plane.direction); };
        list.push_back({colourOf(face, states[layer]), face.isInside ? 1U : 0U, end(face.from), end(face.to),
                        end(face.from + face.leanFrom), end(face.to + face.leanTo), z.z0, z.z1});
    }
    std::ranges::stable_sort(list, {}, &shader::SectionTrapezoid::rank);  // what is drawn last is seen
    return list;
}

}  // namespace

SectionDrawer::SectionDrawer(gpu::Device& device, const TargetFormat& target)
    : m_inFront(makePipeline(device, target, gpu::Pass::InFront)),
      m_behind(makePipeline(device, target, gpu::Pass::Opaque)) {}

void SectionDrawer::draw(gpu::Frame& frame, const FramePlan& plan, const SceneLayers& scene,
                         const SectionCut& cut) const {
    const std::vector<shader::SectionTrapezoid> list = trapezoids(plan, scene, cut);
    if (list.empty()) {
        return;
    }
    const gpu::Frame::Slice data = frame.put(std::span(&plan.data, 1));
    const gpu::Frame::Slice faces = frame.put(list);
    gpu::Pipeline::setFrontFace(frame.commands(), false);
    const gpu::Pipeline& pipeline = isSeenFromFront(plan.data) ? m_inFront : m_behind;
    pipeline.bind(frame.commands());
    pipeline.push(frame.commands(), shader::SectionPush{data.address, faces.address});
    vkCmdDraw(frame.commands(), static_cast<std::uint32_t>(6 * list.size()), 1, 0, 0);
}

}  // namespace render
