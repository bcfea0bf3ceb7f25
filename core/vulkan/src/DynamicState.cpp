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

void RecordDepth(VkCommandBuffer commands, const PipelineState& state, bool hasDepth)
{
    const bool tests = hasDepth && state.zTest != CompareFunction::Disabled;
    vkCmdSetDepthTestEnable(commands, ToVkBool(tests));
    vkCmdSetDepthWriteEnable(commands, ToVkBool(tests && state.zWrite));
    vkCmdSetDepthCompareOp(commands, ToReversedDepthCompare(state.zTest));
    // Farther is smaller in a reversed buffer, hence the signs.
    const bool biased = state.offsetFactor != 0.0f || state.offsetUnits != 0.0f;
    vkCmdSetDepthBiasEnable(commands, ToVkBool(biased));
    vkCmdSetDepthBias(commands, -state.offsetUnits, 0.0f, -state.offsetFactor);
}

void RecordStencilFace(VkCommandBuffer commands, VkStencilFaceFlags which, const StencilFace& face)
{
    vkCmdSetStencilOp(commands, which, ToVkStencilOp(face.fail), ToVkStencilOp(face.pass),
                      ToVkStencilOp(face.zFail), ToStencilCompare(face.compare));
}

void RecordStencil(VkCommandBuffer commands, const PipelineState& state, bool hasStencil)
{
    vkCmdSetStencilTestEnable(commands, ToVkBool(hasStencil && state.stencilEnabled));
    RecordStencilFace(commands, VK_STENCIL_FACE_FRONT_BIT, state.stencilFront);
    RecordStencilFace(commands, VK_STENCIL_FACE_BACK_BIT, state.stencilBack);
    constexpr VkStencilFaceFlags both = VK_STENCIL_FACE_FRONT_AND_BACK;
    const auto byte = [](int value)
    {
        return static_cast<std::uint32_t>(value) & 0xFFU;
    };
    vkCmdSetStencilCompareMask(commands, both, byte(state.stencilReadMask));
    vkCmdSetStencilWriteMask(commands, both, byte(state.stencilWriteMask));
    vkCmdSetStencilReference(commands, both, byte(state.stencilReference));
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

void RecordDynamicState(VkCommandBuffer commands, const PipelineState& state,
                        const TargetFormats& formats, int colorOutputs,
                        const VulkanContext& context)
{
    vkCmdSetCullMode(commands, ToVkCullMode(state.cull));
    vkCmdSetFrontFace(commands, ToVkFrontFace(state.frontFaceFlipped));
    vkCmdSetPrimitiveTopology(commands, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST);
    RecordDepth(commands, state, formats.depth != VK_FORMAT_UNDEFINED);
    RecordStencil(commands, state, formats.stencil != VK_FORMAT_UNDEFINED);
    if (context.capabilities().dynamicBlend && !formats.colors.empty())
    {
        RecordBlend(commands, state, formats.colors.size(), colorOutputs, context.functions());
    }
}

} // namespace limn::vulkan
