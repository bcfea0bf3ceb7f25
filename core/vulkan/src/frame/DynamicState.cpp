#include "frame/DynamicState.h"

#include "device/Translate.h"
#include <algorithm>
#include <limn/base/NumberText.h>
#include <limn/core/DrawError.h>
#include <limn/shaderlab/PrintShaderLab.h>
#include <span>

namespace limn::vulkan
{

namespace
{

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

BlendState ToBlendState(const PipelineState& state, std::size_t targets, int colorOutputs)
{
    BlendState result;
    result.isDynamic = true;
    result.targets = static_cast<std::uint32_t>(targets);
    for (std::size_t i = 0; i < targets; ++i)
    {
        const VkPipelineColorBlendAttachmentState blend =
            ToBlendAttachment(state.targets.at(i), i, colorOutputs);
        result.enables.at(i) = blend.blendEnable;
        result.equations.at(i) = {blend.srcColorBlendFactor, blend.dstColorBlendFactor,
                                  blend.colorBlendOp,        blend.srcAlphaBlendFactor,
                                  blend.dstAlphaBlendFactor, blend.alphaBlendOp};
        result.masks.at(i) = blend.colorWriteMask;
    }
    return result;
}

void RequireSupport(const PipelineState& state, const DeviceCapabilities& capabilities)
{
    if (!state.zClip && !capabilities.features.depthClamp)
    {
        throw DrawError("a draw has ZClip False, and the device lacks depthClamp; it draws "
                        "ZClip True only");
    }
    if (state.conservative && !capabilities.conservative)
    {
        throw DrawError("a draw has Conservative True, and the device lacks "
                        "VK_EXT_conservative_rasterization; it draws the texels whose centre "
                        "is covered only");
    }
}

bool isBeyondBlending(const RenderTargetBlendState& blend)
{
    return std::max(blend.colorBlendOperation, blend.alphaBlendOperation) > BlendOp::Max;
}

/// The logical or advanced operation of a draw, else Add.
BlendOp WholeOperation(const PipelineState& state, std::size_t targets)
{
    const std::span used = std::span(state.targets).first(targets);
    const auto found = std::find_if(used.begin(), used.end(), isBeyondBlending);
    if (found == used.end())
    {
        return BlendOp::Add;
    }
    const BlendOp op = std::max(found->colorBlendOperation, found->alphaBlendOperation);
    for (const RenderTargetBlendState& blend : used)
    {
        if (blend.colorBlendOperation != op || blend.alphaBlendOperation != op)
        {
            const std::string name = BlendOpName(op);
            throw DrawError("a draw has BlendOp " + name +
                            " for a part of its outputs; the device applies it to colour and alpha "
                            "of all targets alike: write Blend and 'BlendOp " +
                            name + "' with neither a target nor a ','");
        }
    }
    return op;
}

/// Floats and sRGB values have no bits to combine: Vulkan would write them as they are.
bool HasPlainBits(VkFormat format)
{
    return format == VK_FORMAT_R8_UNORM || format == VK_FORMAT_R8G8B8A8_UNORM ||
           format == VK_FORMAT_R8G8B8A8_SNORM;
}

/// "" where the device can.
std::string ReasonAgainst(BlendOp op, std::size_t targets, const DeviceCapabilities& capabilities)
{
    if (isLogical(op) && !capabilities.features.logicOp)
    {
        return "lacks logicOp";
    }
    if (isAdvanced(op) && capabilities.advancedBlendTargets == 0)
    {
        return "lacks VK_EXT_blend_operation_advanced";
    }
    if (isAdvanced(op) && capabilities.advancedBlendTargets < targets)
    {
        return "has it for at most " + CountText(capabilities.advancedBlendTargets, "target") +
               " at once, not for " + std::to_string(targets);
    }
    return {};
}

void RequireOperation(BlendOp op, const TargetFormats& formats,
                      const DeviceCapabilities& capabilities)
{
    const std::string reason = ReasonAgainst(op, formats.colors.size(), capabilities);
    if (!reason.empty())
    {
        throw DrawError("a draw has BlendOp " + BlendOpName(op) + ", and the device " + reason +
                        "; every device has Add, Sub, RevSub, Min and Max");
    }
    if (isLogical(op) && !std::all_of(formats.colors.begin(), formats.colors.end(), HasPlainBits))
    {
        throw DrawError("a draw has BlendOp " + BlendOpName(op) +
                        " into a target of floats or sRGB values; a logical operation wants "
                        "R8_UNorm, R8G8B8A8_UNorm or R8G8B8A8_SNorm");
    }
}

} // namespace

PipelineKey MakePipelineKey(const PipelineState& state, const TargetFormats& formats,
                            const DeviceCapabilities& capabilities)
{
    RequireSupport(state, capabilities);
    const BlendOp op = WholeOperation(state, formats.colors.size());
    RequireOperation(op, formats, capabilities);
    PipelineKey key;
    key.formats = formats;
    key.alphaToMask = state.alphaToMask;
    key.depthClamp = !state.zClip;
    key.conservative = state.conservative;
    key.topology = ToVkTopology(state.topology);
    key.topology = key.topology == VK_PRIMITIVE_TOPOLOGY_LINE_STRIP
                       ? VK_PRIMITIVE_TOPOLOGY_LINE_LIST // of one class
                       : key.topology;
    key.logicOp = isLogical(op) ? std::optional(ToVkLogicOp(op)) : std::nullopt;
    // The command that sets a blend equation knows the plain operations only, and at least one
    // target.
    key.dynamicBlend = capabilities.dynamicBlend && !isAdvanced(op) && !formats.colors.empty();
    if (!key.dynamicBlend)
    {
        for (std::size_t i = 0; i < formats.colors.size(); ++i)
        {
            key.blend.at(i) = state.targets.at(i);
        }
    }
    return key;
}

FixedState ToFixedState(const PipelineState& state, const TargetFormats& formats,
                        bool usesReversedZBuffer)
{
    FixedState result;
    result.topology = ToVkTopology(state.topology);
    result.cullMode = ToVkCullMode(state.cull);
    result.frontFace = ToVkFrontFace(state.frontFaceFlipped);
    result.depthTest =
        formats.depth != VK_FORMAT_UNDEFINED && state.zTest != CompareFunction::Disabled;
    result.depthWrite = result.depthTest && state.zWrite;
    result.depthCompare =
        usesReversedZBuffer ? ToReversedDepthCompare(state.zTest) : ToStencilCompare(state.zTest);
    result.depthBias = state.offsetFactor != 0.0f || state.offsetUnits != 0.0f;
    const float farther = usesReversedZBuffer ? -1.0f : 1.0f;
    result.depthBiasConstant = farther * state.offsetUnits;
    result.depthBiasSlope = farther * state.offsetFactor;
    result.stencilTest = formats.stencil != VK_FORMAT_UNDEFINED && state.stencilEnabled;
    result.stencilFront = ToStencilFace(state, state.stencilFront);
    result.stencilBack = ToStencilFace(state, state.stencilBack);
    return result;
}

DynamicState ToDynamicState(const PipelineState& state, const PipelineKey& key, int colorOutputs,
                            bool usesReversedZBuffer)
{
    DynamicState result;
    result.fixed = ToFixedState(state, key.formats, usesReversedZBuffer);
    if (key.dynamicBlend)
    {
        result.blend = ToBlendState(state, key.formats.colors.size(), colorOutputs);
    }
    return result;
}

} // namespace limn::vulkan
