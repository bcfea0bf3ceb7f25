#include "frame/HandWrittenFrame.h"

#include "device/Check.h"
#include "device/Translate.h"
#include <algorithm>
#include <array>
#include <limn/core/Mesh.h>

namespace limn::benchmarks
{

namespace
{

std::vector<VkDescriptorSetLayoutBinding> BindingsOf(const PropertyLayout& layout)
{
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    const auto add = [&](const auto& resource, VkDescriptorType type)
    {
        bindings.push_back(
            {resource.binding, type, 1, vulkan::ToVkStages(resource.stages), nullptr});
    };
    for (const UniformBuffer& buffer : layout.buffers)
    {
        add(buffer, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    }
    for (const TextureBinding& texture : layout.textures)
    {
        add(texture, DescriptorTypeOf(texture));
    }
    for (const SamplerBinding& sampler : layout.samplers)
    {
        add(sampler, VK_DESCRIPTOR_TYPE_SAMPLER);
    }
    for (const StorageBufferBinding& buffer : layout.storageBuffers)
    {
        add(buffer, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    }
    return bindings;
}

vulkan::UniqueShaderModule CreateModule(VkDevice device, const std::vector<std::uint32_t>& spirv)
{
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = spirv.size() * sizeof(std::uint32_t);
    info.pCode = spirv.data();
    VkShaderModule handle = VK_NULL_HANDLE;
    vulkan::Check(vkCreateShaderModule(device, &info, nullptr, &handle), "vkCreateShaderModule");
    return {device, handle};
}

/// A pipeline's description without dynamic state; its parts point at each other.
struct FixedPipeline
{
    std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
    std::vector<VkVertexInputBindingDescription> bindings;
    std::vector<VkVertexInputAttributeDescription> attributes;
    VkViewport viewport{};
    VkRect2D scissor{};
    VkPipelineColorBlendAttachmentState target{};
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkPipelineVertexInputStateCreateInfo vertexInput{};
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    VkPipelineViewportStateCreateInfo viewportState{};
    VkPipelineRasterizationStateCreateInfo rasterization{};
    VkPipelineMultisampleStateCreateInfo multisample{};
    VkPipelineDepthStencilStateCreateInfo depth{};
    VkPipelineColorBlendStateCreateInfo blend{};
    VkPipelineRenderingCreateInfo rendering{};
    VkGraphicsPipelineCreateInfo info{};
};

void DescribeVertices(FixedPipeline& parts, const PropertyLayout& layout)
{
    for (const VertexInput& input : layout.vertexInputs)
    {
        const auto& attribute =
            *std::ranges::find(VertexAttributes(), input.semantic, &VertexAttribute::semantic);
        constexpr std::array formats = {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
                                        VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};
        const auto binding = static_cast<std::uint32_t>(parts.bindings.size());
        const auto stride = static_cast<std::uint32_t>(attribute.components * sizeof(float));
        parts.bindings.push_back({binding, stride, VK_VERTEX_INPUT_RATE_VERTEX});
        parts.attributes.push_back(
            {input.location, binding, formats.at(attribute.components - 1), 0});
    }
    parts.vertexInput.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    parts.vertexInput.vertexBindingDescriptionCount =
        static_cast<std::uint32_t>(parts.bindings.size());
    parts.vertexInput.pVertexBindingDescriptions = parts.bindings.data();
    parts.vertexInput.vertexAttributeDescriptionCount =
        static_cast<std::uint32_t>(parts.attributes.size());
    parts.vertexInput.pVertexAttributeDescriptions = parts.attributes.data();
    parts.assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    parts.assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

/// y = 1 is the first row, as in limn.
void DescribeArea(FixedPipeline& parts, VkExtent2D extent)
{
    const auto height = static_cast<float>(extent.height);
    parts.viewport = {0.0f, height, static_cast<float>(extent.width), -height, 0.0f, 1.0f};
    parts.scissor = {{0, 0}, extent};
    parts.viewportState.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    parts.viewportState.viewportCount = 1;
    parts.viewportState.pViewports = &parts.viewport;
    parts.viewportState.scissorCount = 1;
    parts.viewportState.pScissors = &parts.scissor;
}

/// Meshes show their clockwise faces, which the camera's flipped projection turns over; a
/// full-screen triangle has but one.
void DescribeRasterization(FixedPipeline& parts, bool hasMesh, bool testsDepth)
{
    parts.rasterization.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    parts.rasterization.cullMode = hasMesh ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE;
    parts.rasterization.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    parts.rasterization.lineWidth = 1.0f;
    parts.multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    parts.multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    parts.depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    parts.depth.depthTestEnable = testsDepth ? VK_TRUE : VK_FALSE;
    parts.depth.depthWriteEnable = parts.depth.depthTestEnable;
    parts.depth.depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL; // near is 1
}

/// Blending: the composite's, One SrcAlpha, Zero One.
void DescribeTarget(FixedPipeline& parts, VkFormat format, VkFormat depth, bool blends)
{
    parts.format = format;
    parts.target.blendEnable = blends ? VK_TRUE : VK_FALSE;
    parts.target.srcColorBlendFactor = VK_BLEND_FACTOR_ONE;
    parts.target.dstColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
    parts.target.srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO;
    parts.target.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    parts.target.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                  VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    parts.blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    parts.blend.attachmentCount = 1;
    parts.blend.pAttachments = &parts.target;
    parts.rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    parts.rendering.colorAttachmentCount = 1;
    parts.rendering.pColorAttachmentFormats = &parts.format;
    parts.rendering.depthAttachmentFormat = depth;
}

VkPipelineShaderStageCreateInfo StageOf(VkShaderStageFlagBits stage, VkShaderModule module)
{
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    return info;
}

vulkan::UniquePipeline CreatePipeline(VkDevice device, FixedPipeline& parts,
                                      VkPipelineLayout layout)
{
    parts.info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    parts.info.pNext = &parts.rendering;
    parts.info.stageCount = static_cast<std::uint32_t>(parts.stages.size());
    parts.info.pStages = parts.stages.data();
    parts.info.pVertexInputState = &parts.vertexInput;
    parts.info.pInputAssemblyState = &parts.assembly;
    parts.info.pViewportState = &parts.viewportState;
    parts.info.pRasterizationState = &parts.rasterization;
    parts.info.pMultisampleState = &parts.multisample;
    parts.info.pDepthStencilState = &parts.depth;
    parts.info.pColorBlendState = &parts.blend;
    parts.info.layout = layout;
    VkPipeline handle = VK_NULL_HANDLE;
    vulkan::Check(
        vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &parts.info, nullptr, &handle),
        "vkCreateGraphicsPipelines");
    return {device, handle};
}

} // namespace

VkDescriptorType DescriptorTypeOf(const TextureBinding& texture)
{
    return texture.combinedSampler ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                   : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
}

void HandWrittenFrame::CreateStages()
{
    m_LitStage = CreateStage(m_Numbers.lit, m_Color, m_Depth.format, false);
    m_MaskStage = CreateStage(m_Numbers.mask, m_Mask, VK_FORMAT_UNDEFINED, false);
    m_EdgeStage = CreateStage(m_Numbers.edge.program, m_Edge, VK_FORMAT_UNDEFINED, false);
    m_CompositeStage = CreateStage(m_Numbers.composite.program, m_Color, m_Depth.format, true);
    m_FinalStage = CreateStage(m_Numbers.final.program, m_Output, VK_FORMAT_UNDEFINED, false);
}

HandWrittenFrame::Stage
HandWrittenFrame::CreateStage(const std::shared_ptr<const ShaderProgram>& program,
                              const Target& target, VkFormat depth, bool blends)
{
    VkDevice device = m_Context.device();
    Stage stage;
    stage.program = program;
    const auto bindings = BindingsOf(program->layout);
    VkDescriptorSetLayoutCreateInfo setInfo{};
    setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    setInfo.bindingCount = static_cast<std::uint32_t>(bindings.size());
    setInfo.pBindings = bindings.data();
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    vulkan::Check(vkCreateDescriptorSetLayout(device, &setInfo, nullptr, &set),
                  "vkCreateDescriptorSetLayout");
    stage.setLayout = vulkan::UniqueSetLayout{device, set};
    VkPipelineLayoutCreateInfo layoutInfo{};
    layoutInfo.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layoutInfo.setLayoutCount = 1;
    layoutInfo.pSetLayouts = &set;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    vulkan::Check(vkCreatePipelineLayout(device, &layoutInfo, nullptr, &layout),
                  "vkCreatePipelineLayout");
    stage.layout = vulkan::UniquePipelineLayout{device, layout};

    const bool hasMesh = !program->layout.vertexInputs.empty();
    const auto vertex = CreateModule(device, program->vertexSpirv);
    const auto fragment = CreateModule(device, program->fragmentSpirv);
    FixedPipeline parts;
    parts.stages = {StageOf(VK_SHADER_STAGE_VERTEX_BIT, vertex.get()),
                    StageOf(VK_SHADER_STAGE_FRAGMENT_BIT, fragment.get())};
    DescribeVertices(parts, program->layout);
    DescribeArea(parts, target.extent);
    DescribeRasterization(parts, hasMesh, hasMesh && depth != VK_FORMAT_UNDEFINED);
    DescribeTarget(parts, target.format, depth, blends);
    stage.pipeline = CreatePipeline(device, parts, layout);
    return stage;
}

} // namespace limn::benchmarks
