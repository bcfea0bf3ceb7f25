#include "programs/ProgramPool.h"

#include "device/Check.h"
#include "device/Translate.h"

namespace limn::vulkan
{

namespace
{

std::vector<VkDynamicState> DynamicStates(bool dynamicBlend, bool hasVertices)
{
    std::vector<VkDynamicState> states = {VK_DYNAMIC_STATE_VIEWPORT,
                                          VK_DYNAMIC_STATE_SCISSOR,
                                          VK_DYNAMIC_STATE_CULL_MODE,
                                          VK_DYNAMIC_STATE_FRONT_FACE,
                                          VK_DYNAMIC_STATE_PRIMITIVE_TOPOLOGY,
                                          VK_DYNAMIC_STATE_DEPTH_TEST_ENABLE,
                                          VK_DYNAMIC_STATE_DEPTH_WRITE_ENABLE,
                                          VK_DYNAMIC_STATE_DEPTH_COMPARE_OP,
                                          VK_DYNAMIC_STATE_DEPTH_BIAS_ENABLE,
                                          VK_DYNAMIC_STATE_DEPTH_BIAS,
                                          VK_DYNAMIC_STATE_STENCIL_TEST_ENABLE,
                                          VK_DYNAMIC_STATE_STENCIL_OP,
                                          VK_DYNAMIC_STATE_STENCIL_COMPARE_MASK,
                                          VK_DYNAMIC_STATE_STENCIL_WRITE_MASK,
                                          VK_DYNAMIC_STATE_STENCIL_REFERENCE};
    if (hasVertices)
    {
        states.push_back(VK_DYNAMIC_STATE_VERTEX_INPUT_BINDING_STRIDE);
    }
    if (dynamicBlend)
    {
        states.push_back(VK_DYNAMIC_STATE_COLOR_BLEND_ENABLE_EXT);
        states.push_back(VK_DYNAMIC_STATE_COLOR_BLEND_EQUATION_EXT);
        states.push_back(VK_DYNAMIC_STATE_COLOR_WRITE_MASK_EXT);
    }
    return states;
}

VkPipelineShaderStageCreateInfo Stage(VkShaderStageFlagBits stage, VkShaderModule module)
{
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    return info;
}

/// The parts of a pipeline's description that point at each other.
struct PipelineParts
{
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    std::vector<VkVertexInputBindingDescription> bindings;
    std::vector<VkVertexInputAttributeDescription> attributes;
    std::vector<VkPipelineColorBlendAttachmentState> blends;
    std::vector<VkDynamicState> dynamicStates;
    VkPipelineVertexInputStateCreateInfo vertexInput{};
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    VkPipelineViewportStateCreateInfo viewport{};
    VkPipelineRasterizationStateCreateInfo rasterization{};
    VkPipelineRasterizationConservativeStateCreateInfoEXT conservative{};
    VkPipelineMultisampleStateCreateInfo multisample{};
    VkPipelineDepthStencilStateCreateInfo depthStencil{};
    VkPipelineColorBlendStateCreateInfo blend{};
    VkPipelineDynamicStateCreateInfo dynamic{};
    VkPipelineRenderingCreateInfo rendering{};
};

void DescribeVertices(PipelineParts& parts, const ProgramObjects& pass,
                      VkPrimitiveTopology topology)
{
    for (std::uint32_t i = 0; i < pass.fetches.size(); ++i)
    {
        const VertexFetch& fetch = pass.fetches[i];
        parts.bindings.push_back({i, 0, VK_VERTEX_INPUT_RATE_VERTEX});
        parts.attributes.push_back({fetch.location, i, fetch.format, 0});
    }
    parts.vertexInput.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    parts.vertexInput.vertexBindingDescriptionCount =
        static_cast<std::uint32_t>(parts.bindings.size());
    parts.vertexInput.pVertexBindingDescriptions = parts.bindings.data();
    parts.vertexInput.vertexAttributeDescriptionCount =
        static_cast<std::uint32_t>(parts.attributes.size());
    parts.vertexInput.pVertexAttributeDescriptions = parts.attributes.data();
    parts.assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    parts.assembly.topology = topology;
}

void DescribeRasterization(PipelineParts& parts, const PipelineKey& key)
{
    parts.viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    parts.viewport.viewportCount = 1;
    parts.viewport.scissorCount = 1;
    parts.rasterization.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    parts.rasterization.depthClampEnable = key.depthClamp ? VK_TRUE : VK_FALSE;
    parts.rasterization.polygonMode = VK_POLYGON_MODE_FILL;
    parts.rasterization.lineWidth = 1.0f;
    if (key.conservative)
    {
        parts.conservative.sType =
            VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_CONSERVATIVE_STATE_CREATE_INFO_EXT;
        parts.conservative.conservativeRasterizationMode =
            VK_CONSERVATIVE_RASTERIZATION_MODE_OVERESTIMATE_EXT;
        parts.rasterization.pNext = &parts.conservative;
    }
    parts.multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    parts.multisample.rasterizationSamples = key.formats.samples;
    parts.multisample.alphaToCoverageEnable = key.alphaToMask ? VK_TRUE : VK_FALSE;
    parts.depthStencil.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
}

void DescribeTargets(PipelineParts& parts, const PipelineKey& key, int colorOutputs)
{
    const auto count = static_cast<std::uint32_t>(key.formats.colors.size());
    for (std::size_t i = 0; i < count; ++i)
    {
        parts.blends.push_back(ToBlendAttachment(key.blend.at(i), i, colorOutputs));
    }
    parts.blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    parts.blend.attachmentCount = count;
    parts.blend.pAttachments = parts.blends.data();
    parts.blend.logicOpEnable = key.logicOp ? VK_TRUE : VK_FALSE;
    parts.blend.logicOp = key.logicOp.value_or(VK_LOGIC_OP_COPY);
    parts.rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    parts.rendering.colorAttachmentCount = count;
    parts.rendering.pColorAttachmentFormats = key.formats.colors.begin();
    parts.rendering.depthAttachmentFormat = key.formats.depth;
    parts.rendering.stencilAttachmentFormat = key.formats.stencil;
}

} // namespace

VkPipelineColorBlendAttachmentState ToBlendAttachment(const RenderTargetBlendState& blend,
                                                      std::size_t index, int colorOutputs)
{
    RenderTargetBlendState off;
    off.writeMask = blend.writeMask;
    VkPipelineColorBlendAttachmentState state{};
    state.blendEnable = blend != off && !isLogical(blend.colorBlendOperation) ? VK_TRUE : VK_FALSE;
    state.srcColorBlendFactor = ToVkBlendFactor(blend.sourceColorBlendMode);
    state.dstColorBlendFactor = ToVkBlendFactor(blend.destinationColorBlendMode);
    state.colorBlendOp = ToVkBlendOp(blend.colorBlendOperation);
    state.srcAlphaBlendFactor = ToVkBlendFactor(blend.sourceAlphaBlendMode);
    state.dstAlphaBlendFactor = ToVkBlendFactor(blend.destinationAlphaBlendMode);
    state.alphaBlendOp = ToVkBlendOp(blend.alphaBlendOperation);
    const bool written = static_cast<int>(index) < colorOutputs;
    state.colorWriteMask = written ? ToVkColorMask(blend.writeMask) : 0;
    return state;
}

UniquePipeline BuildPipeline(const VulkanContext& context, VkPipelineCache cache,
                             const ProgramObjects& pass, int colorOutputs, const PipelineKey& key)
{
    PipelineParts parts;
    const UniqueShaderModule& vertex = pass.points && isOfPoints(key) ? pass.points : pass.vertex;
    parts.stages = {Stage(VK_SHADER_STAGE_VERTEX_BIT, vertex.get()),
                    Stage(VK_SHADER_STAGE_FRAGMENT_BIT, pass.fragment.get())};
    if (pass.geometry)
    {
        parts.stages.push_back(Stage(VK_SHADER_STAGE_GEOMETRY_BIT, pass.geometry.get()));
    }
    parts.dynamicStates = DynamicStates(key.dynamicBlend, !pass.fetches.empty());
    DescribeVertices(parts, pass, key.topology);
    DescribeRasterization(parts, key);
    DescribeTargets(parts, key, colorOutputs);
    parts.dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    parts.dynamic.dynamicStateCount = static_cast<std::uint32_t>(parts.dynamicStates.size());
    parts.dynamic.pDynamicStates = parts.dynamicStates.data();

    auto info = Make<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.pNext = &parts.rendering;
    info.stageCount = static_cast<std::uint32_t>(parts.stages.size());
    info.pStages = parts.stages.data();
    info.pVertexInputState = &parts.vertexInput;
    info.pInputAssemblyState = &parts.assembly;
    info.pViewportState = &parts.viewport;
    info.pRasterizationState = &parts.rasterization;
    info.pMultisampleState = &parts.multisample;
    info.pDepthStencilState = &parts.depthStencil;
    info.pColorBlendState = &parts.blend;
    info.pDynamicState = &parts.dynamic;
    info.layout = pass.layout.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    Check(vkCreateGraphicsPipelines(context.device(), cache, 1, &info, nullptr, &pipeline),
          "vkCreateGraphicsPipelines");
    return {context.device(), pipeline};
}

UniquePipeline BuildComputePipeline(const VulkanContext& context, VkPipelineCache cache,
                                    VkShaderModule kernel, VkPipelineLayout layout)
{
    auto info = Make<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = Stage(VK_SHADER_STAGE_COMPUTE_BIT, kernel);
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    Check(vkCreateComputePipelines(context.device(), cache, 1, &info, nullptr, &pipeline),
          "vkCreateComputePipelines");
    return {context.device(), pipeline};
}

} // namespace limn::vulkan
