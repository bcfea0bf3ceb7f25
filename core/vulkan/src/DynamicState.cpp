#include "DynamicState.h"

#include "PipelineBuilder.h"
#include "Translate.h"

namespace limn::vulkan
{

namespace
{

VkBool32 ToVkBool(bool value)
{
    return value ? VK_TRUE : VK_FALSE;
}

VkStencilOpState ToStencilFace(const PipelineState& state, const StencilFace& face)
{
    const auto byte = [](int value)
    {
        return static_cast<std::uint32_t>(value) & 0xFFU;
    };
    return {ToVkStencilOp(face.fail),    ToVkStencilOp(face.pass),
            ToVkStencilOp(face.zFail),   ToStencilCompare(face.compare),
            byte(state.stencilReadMask), byte(state.stencilWriteMask),
            byte(state.stencilReference)};
}

void RecordDepth(VkCommandBuffer commands, const FixedState& state)
{
    vkCmdSetDepthTestEnable(commands, ToVkBool(state.depthTest));
    vkCmdSetDepthWriteEnable(commands, ToVkBool(state.depthWrite));
    vkCmdSetDepthCompareOp(commands, state.depthCompare);
    vkCmdSetDepthBiasEnable(commands, ToVkBool(state.depthBias));
    vkCmdSetDepthBias(commands, state.depthBiasConstant, 0.0f, state.depthBiasSlope);
}

void RecordStencilFace(VkCommandBuffer commands, VkStencilFaceFlags which,
                       const VkStencilOpState& face)
{
    vkCmdSetStencilOp(commands, which, face.failOp, face.passOp, face.depthFailOp, face.compareOp);
    vkCmdSetStencilCompareMask(commands, which, face.compareMask);
    vkCmdSetStencilWriteMask(commands, which, face.writeMask);
    vkCmdSetStencilReference(commands, which, face.reference);
}

void RecordBlend(VkCommandBuffer commands, const PipelineState& state, std::size_t targets,
                 int colorOutputs, const ExtensionFunctions& functions)
{
    std::array<VkBool32, 8> enables{};
    std::array<VkColorBlendEquationEXT, 8> equations{};
    std::array<VkColorComponentFlags, 8> masks{};
    for (std::size_t i = 0; i < targets; ++i)
    {
        const VkPipelineColorBlendAttachmentState blend =
            ToBlendAttachment(state.targets.at(i), i, colorOutputs);
        enables.at(i) = blend.blendEnable;
        equations.at(i) = {blend.srcColorBlendFactor, blend.dstColorBlendFactor,
                           blend.colorBlendOp,        blend.srcAlphaBlendFactor,
                           blend.dstAlphaBlendFactor, blend.alphaBlendOp};
        masks.at(i) = blend.colorWriteMask;
    }
    const auto count = static_cast<std::uint32_t>(targets);
    functions.setColorBlendEnable(commands, 0, count, enables.data());
    functions.setColorBlendEquation(commands, 0, count, equations.data());
    functions.setColorWriteMask(commands, 0, count, masks.data());
}

void RequireSupport(const PipelineState& state, const DeviceCapabilities& capabilities)
{
    if (!state.zClip && !capabilities.depthClamp)
    {
        throw ContractError("a draw has ZClip False, and the device lacks depthClamp; it draws "
                            "ZClip True only");
    }
    if (state.conservative)
    {
        throw ContractError("a draw has Conservative True; limn draws the texels whose centre is "
                            "covered only");
    }
}

} // namespace

PipelineKey MakePipelineKey(const PipelineState& state, const TargetFormats& formats,
                            const DeviceCapabilities& capabilities)
{
    RequireSupport(state, capabilities);
    PipelineKey key;
    key.formats = formats;
    key.alphaToMask = state.alphaToMask;
    key.depthClamp = !state.zClip;
    if (!capabilities.dynamicBlend)
    {
        for (std::size_t i = 0; i < formats.colors.size(); ++i)
        {
            key.blend.at(i) = state.targets.at(i);
        }
    }
    return key;
}

FixedState ToFixedState(const PipelineState& state, const TargetFormats& formats)
{
    FixedState result;
    result.cullMode = ToVkCullMode(state.cull);
    result.frontFace = ToVkFrontFace(state.frontFaceFlipped);
    result.depthTest =
        formats.depth != VK_FORMAT_UNDEFINED && state.zTest != CompareFunction::Disabled;
    result.depthWrite = result.depthTest && state.zWrite;
    result.depthCompare = ToReversedDepthCompare(state.zTest);
    result.depthBias = state.offsetFactor != 0.0f || state.offsetUnits != 0.0f;
    // Farther is smaller in a reversed buffer, hence the signs.
    result.depthBiasConstant = -state.offsetUnits;
    result.depthBiasSlope = -state.offsetFactor;
    result.stencilTest = formats.stencil != VK_FORMAT_UNDEFINED && state.stencilEnabled;
    result.stencilFront = ToStencilFace(state, state.stencilFront);
    result.stencilBack = ToStencilFace(state, state.stencilBack);
    return result;
}

void RecordDynamicState(VkCommandBuffer commands, const PipelineState& state,
                        const TargetFormats& formats, int colorOutputs,
                        const VulkanContext& context)
{
    const FixedState fixed = ToFixedState(state, formats);
    vkCmdSetCullMode(commands, fixed.cullMode);
    vkCmdSetFrontFace(commands, fixed.frontFace);
    vkCmdSetPrimitiveTopology(commands, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST);
    RecordDepth(commands, fixed);
    vkCmdSetStencilTestEnable(commands, ToVkBool(fixed.stencilTest));
    RecordStencilFace(commands, VK_STENCIL_FACE_FRONT_BIT, fixed.stencilFront);
    RecordStencilFace(commands, VK_STENCIL_FACE_BACK_BIT, fixed.stencilBack);
    if (context.capabilities().dynamicBlend && !formats.colors.empty())
    {
        RecordBlend(commands, state, formats.colors.size(), colorOutputs, context.functions());
    }
}

} // namespace limn::vulkan
