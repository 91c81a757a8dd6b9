#include "render/gpu/pipeline.h"

#include <vector>

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

Unique<VkShaderModule> createModule(Device& device, Spirv code, std::string_view label) {
    auto info = vkInfo<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = code.size_bytes();
    info.pCode = code.data();
    VkShaderModule handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreateShaderModule(device.handle(), &info, nullptr, &handle));
    return {device, handle, label};
}

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, VkShaderModule module) {
    auto info = vkInfo<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    return info;
}

VkPipelineDepthStencilStateCreateInfo depthState(Pass pass) {
    auto info =
        vkInfo<VkPipelineDepthStencilStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    info.depthTestEnable = pass == Pass::Overlay ? VK_FALSE : VK_TRUE;
    info.depthWriteEnable = pass == Pass::Blend || pass == Pass::Overlay ? VK_FALSE : VK_TRUE;
    info.depthCompareOp = pass == Pass::Blend     ? VK_COMPARE_OP_EQUAL
                          : pass == Pass::InFront ? VK_COMPARE_OP_ALWAYS
                                                  : VK_COMPARE_OP_GREATER_OR_EQUAL;
    // Overlapping shapes of one layer lie at the same depth: the first to come marks the sample with the layer's
    // reference.
    info.stencilTestEnable = pass == Pass::Blend ? VK_TRUE : VK_FALSE;
    info.front.compareOp = VK_COMPARE_OP_NOT_EQUAL;
    info.front.passOp = VK_STENCIL_OP_REPLACE;
    info.front.compareMask = 0xff;
    info.front.writeMask = 0xff;
    info.back = info.front;
    return info;
}

VkPipelineColorBlendAttachmentState blendState(Pass pass) {
    VkPipelineColorBlendAttachmentState state{};
    state.blendEnable = pass == Pass::Blend || pass == Pass::Overlay ? VK_TRUE : VK_FALSE;
    // Layers come multiplied by their opacity; what they let through of each colour is set with setFilter.
    const bool isLayer = pass == Pass::Blend;
    state.srcColorBlendFactor = isLayer ? VK_BLEND_FACTOR_ONE : VK_BLEND_FACTOR_SRC_ALPHA;
    state.dstColorBlendFactor = isLayer ? VK_BLEND_FACTOR_CONSTANT_COLOR : VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO;
    state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    // Alpha stays what the background is: pictures are opaque.
    state.colorWriteMask =
        pass == Pass::DepthOnly ? 0 : VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT;
    return state;
}

Unique<VkPipelineLayout> createLayout(Device& device, VkShaderStageFlags stages, std::uint32_t pushBytes,
                                      std::string_view label) {
    const VkPushConstantRange range{stages, 0, pushBytes};
    auto info = vkInfo<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    VkPipelineLayout handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreatePipelineLayout(device.handle(), &info, nullptr, &handle));
    return {device, handle, label};
}

MadePipeline make(Device& device, const ComputePipelineOptions& options) {
    MadePipeline made;
    made.bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE;
    made.stages = VK_SHADER_STAGE_COMPUTE_BIT;
    made.layout = createLayout(device, made.stages, options.pushBytes, options.label);
    const Unique<VkShaderModule> module = createModule(device, options.shader, options.label);
    auto info = vkInfo<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, module.get());
    info.layout = made.layout.get();
    VkPipeline handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreateComputePipelines(device.handle(), device.pipelineCache(), 1, &info, nullptr, &handle));
    made.handle = {device, handle, options.label};
    return made;
}

/// The shaders of a graphics pipeline. Points into itself, so it stays where it was made.
struct GraphicsStages {
    VkBool32 hasSection = VK_FALSE;
    VkSpecializationMapEntry sectionConstant{0, 0, sizeof hasSection};
    VkSpecializationInfo constants{1, &sectionConstant, sizeof hasSection, &hasSection};
    std::vector<Unique<VkShaderModule>> modules;
    std::vector<VkPipelineShaderStageCreateInfo> infos;
    VkShaderStageFlags flags = 0;

    GraphicsStages(Device& device, const GraphicsPipelineOptions& options)
        : hasSection(options.hasSection ? VK_TRUE : VK_FALSE) {
        const bool needsNoColour =
            options.pass == Pass::DepthOnly && options.cover == Cover::Triangles && !options.hasSection;
        for (const ShaderStage& stage : options.stages) {
            if (stage.stage != VK_SHADER_STAGE_FRAGMENT_BIT || !needsNoColour) {
                add(device, stage, options.label);
            }
        }
    }
    GraphicsStages(const GraphicsStages&) = delete;
    GraphicsStages& operator=(const GraphicsStages&) = delete;

    void add(Device& device, const ShaderStage& stage, std::string_view label) {
        modules.push_back(createModule(device, stage.shader, label));
        infos.push_back(stageInfo(stage.stage, modules.back().get()));
        infos.back().pSpecializationInfo = stage.stage == VK_SHADER_STAGE_FRAGMENT_BIT ? &constants : nullptr;
        flags |= static_cast<VkShaderStageFlags>(stage.stage);
    }
};

/// All that Vulkan wants to know of a graphics pipeline beside its shaders. Points into itself, as they do.
struct FixedFunctions {
    VkPipelineVertexInputStateCreateInfo noVertices =
        vkInfo<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    VkPipelineInputAssemblyStateCreateInfo assembly =
        vkInfo<VkPipelineInputAssemblyStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    VkPipelineViewportStateCreateInfo viewport =
        vkInfo<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    VkPipelineRasterizationStateCreateInfo raster =
        vkInfo<VkPipelineRasterizationStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    VkPipelineMultisampleStateCreateInfo samples =
        vkInfo<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    VkPipelineDepthStencilStateCreateInfo depth;
    VkPipelineColorBlendAttachmentState blend;
    VkPipelineColorBlendStateCreateInfo colour =
        vkInfo<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
    VkPipelineDynamicStateCreateInfo dynamic =
        vkInfo<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
    VkPipelineRenderingCreateInfo rendering =
        vkInfo<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);

    explicit FixedFunctions(const GraphicsPipelineOptions& options)
        : depth(depthState(options.pass)), blend(blendState(options.pass)) {
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;
        raster.cullMode = options.cullsBackFaces ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE;
        raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
        raster.lineWidth = 1.0F;
        samples.rasterizationSamples = options.samples;
        samples.sampleShadingEnable = options.cover == Cover::Samples ? VK_TRUE : VK_FALSE;
        samples.minSampleShading = 1.0F;
        colour.attachmentCount = 1;
        colour.pAttachments = &blend;
        // Binding a pipeline where a state is fixed undoes what was set: so the front face is dynamic in all of them.
        static constexpr VkDynamicState kDynamic[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                                      VK_DYNAMIC_STATE_FRONT_FACE, VK_DYNAMIC_STATE_STENCIL_REFERENCE,
                                                      VK_DYNAMIC_STATE_BLEND_CONSTANTS};
        dynamic.dynamicStateCount = options.pass == Pass::Blend ? 5 : 3;
        dynamic.pDynamicStates = kDynamic;
        rendering.colorAttachmentCount = 1;
        rendering.pColorAttachmentFormats = &options.colourFormat;
        rendering.depthAttachmentFormat = options.depthFormat;
        rendering.stencilAttachmentFormat = options.depthFormat;
    }
    FixedFunctions(const FixedFunctions&) = delete;
    FixedFunctions& operator=(const FixedFunctions&) = delete;

    void putInto(VkGraphicsPipelineCreateInfo& info) const {
        info.pNext = &rendering;
        info.pVertexInputState = &noVertices;
        info.pInputAssemblyState = &assembly;
        info.pViewportState = &viewport;
        info.pRasterizationState = &raster;
        info.pMultisampleState = &samples;
        info.pDepthStencilState = &depth;
        info.pColorBlendState = &colour;
        info.pDynamicState = &dynamic;
    }
};

MadePipeline make(Device& device, const GraphicsPipelineOptions& options) {
    MadePipeline made;
    const GraphicsStages stages(device, options);
    const FixedFunctions fixed(options);
    made.stages = stages.flags;
    made.layout = createLayout(device, made.stages, options.pushBytes, options.label);
    auto info = vkInfo<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.stageCount = static_cast<std::uint32_t>(stages.infos.size());
    info.pStages = stages.infos.data();
    fixed.putInto(info);
    info.layout = made.layout.get();
    VkPipeline handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreateGraphicsPipelines(device.handle(), device.pipelineCache(), 1, &info, nullptr, &handle));
    made.handle = {device, handle, options.label};
    return made;
}

std::uint64_t numberOf(Spirv code) {
    return reinterpret_cast<std::uintptr_t>(code.data());
}

PipelineStore::Key keyOf(const ComputePipelineOptions& options) {
    return {numberOf(options.shader), options.pushBytes};
}

PipelineStore::Key keyOf(const GraphicsPipelineOptions& options) {
    PipelineStore::Key key{options.pushBytes,
                           static_cast<std::uint64_t>(options.pass),
                           options.cullsBackFaces ? 1U : 0U,
                           static_cast<std::uint64_t>(options.cover),
                           static_cast<std::uint64_t>(options.colourFormat),
                           static_cast<std::uint64_t>(options.depthFormat),
                           static_cast<std::uint64_t>(options.samples),
                           options.hasSection ? 1U : 0U};
    for (const ShaderStage& stage : options.stages) {
        key.push_back(static_cast<std::uint64_t>(stage.stage));
        key.push_back(numberOf(stage.shader));
    }
    return key;
}

}  // namespace

Pipeline::Pipeline(Device& device, const ComputePipelineOptions& options)
    : m_made(&device.pipelines().get(keyOf(options), [&] { return make(device, options); })) {}

Pipeline::Pipeline(Device& device, const GraphicsPipelineOptions& options)
    : m_made(&device.pipelines().get(keyOf(options), [&] { return make(device, options); })) {}

void Pipeline::bind(VkCommandBuffer commands) const {
    vkCmdBindPipeline(commands, m_made->bindPoint, m_made->handle.get());
}

void Pipeline::pushBytes(VkCommandBuffer commands, const void* data, std::uint32_t size) const {
    vkCmdPushConstants(commands, m_made->layout.get(), m_made->stages, 0, size, data);
}

}  // namespace render::gpu
