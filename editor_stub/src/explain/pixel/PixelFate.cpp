#include "explain/pixel/PassProbe.h"

#include <algorithm>
#include <limn/shaderlab/PrintShaderLab.h>
#include <sstream>

namespace limn
{

namespace
{

std::string CullReason(CullMode cull)
{
    return cull == CullMode::Back
               ? "it shows its back here, and Cull Back leaves back faces out"
               : "it shows its front here, and Cull Front leaves front faces out";
}

std::string StencilReason(const PipelineState& state, bool isFront, const TargetTexels& before)
{
    const StencilFace& face = isFront ? state.stencilFront : state.stencilBack;
    const int stored = before.stencil.empty() ? 0 : std::to_integer<int>(before.stencil.front());
    const int mask = state.stencilReadMask & 255;
    return "the stencil test fails: Ref " + std::to_string(state.stencilReference) + " Comp " +
           StateText(StateValue<CompareFunction>(face.compare)) + ", and " +
           std::to_string(stored) + " is there" +
           (mask == 255 ? "" : " (ReadMask " + std::to_string(mask) + ")");
}

std::string DepthReason(const PipelineState& state, float own, const TargetTexels& before)
{
    const bool isPlain =
        state.zTest == CompareFunction::Less || state.zTest == CompareFunction::LessEqual;
    const std::string stored =
        before.depth.empty() ? "none"
                             : NumbersText(TexelValue(before.depth, GraphicsFormat::D32_SFloat));
    return std::string(isPlain ? "it is behind the surface that is there"
                               : "the depth test fails") +
           ": its depth is " + NumbersText({own}) + ", that of the target " + stored +
           " (1 is near), ZTest " + StateText(StateValue<CompareFunction>(state.zTest));
}

bool Blends(const RenderTargetBlendState& blend)
{
    RenderTargetBlendState plain;
    plain.writeMask = blend.writeMask;
    return blend != plain;
}

/// Finds the reason for a draw that gets past all tests.
std::pair<PixelFate, std::string> WhyItAddsNothing(const PassProbe& probe, std::size_t which,
                                                   std::size_t colors)
{
    const PipelineState state = probe.SetupOf(which).state;
    const auto targets = std::span(state.targets).first(colors);
    if (colors > 0 &&
        std::ranges::all_of(targets, [](const auto& blend) { return (blend.writeMask & 15) == 0; }))
    {
        return {PixelFate::ColorMask, "it writes no colour: ColorMask 0"};
    }
    const std::optional<std::vector<float>> output =
        colors > 0 ? probe.OutputOf(which) : std::nullopt;
    const std::string given = output ? "; its shader gives " + NumbersText(*output) : "";
    if (std::ranges::any_of(targets, Blends))
    {
        const bool isClear = output && output->back() == 0.0f;
        return {PixelFate::Blend,
                (isClear ? "it adds nothing here: its alpha is 0"
                         : "it adds nothing here: blending leaves the colour as it is") +
                    given};
    }
    return {PixelFate::Same, "it writes the value that is there already" + given};
}

} // namespace

std::string NumbersText(const std::vector<float>& numbers)
{
    std::ostringstream text;
    text.precision(4);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        text << (i == 0 ? (numbers.size() > 1 ? "(" : "") : ", ") << numbers[i];
    }
    return text.str() + (numbers.size() > 1 ? ")" : "");
}

std::pair<PixelFate, std::string> WhyUnchanged(const PassProbe& probe, std::size_t which,
                                               const TargetTexels& before, bool isEmpty)
{
    const PipelineState state = probe.SetupOf(which).state;
    if (!probe.LiesInScissor(which))
    {
        return {PixelFate::Scissor, "the scissor leaves the pixel out"};
    }
    if (!probe.Reaches(which, state.cull))
    {
        return {PixelFate::Culled, CullReason(state.cull)};
    }
    PipelineState tried = state; // without the tests behind the fragment function
    tried.zTest = CompareFunction::Always;
    tried.zWrite = false;
    tried.stencilEnabled = false;
    if (!probe.Passes(which, tried))
    {
        return {PixelFate::Discarded, state.alphaToMask
                                          ? "its shader discards it, or AlphaToMask does"
                                          : "its shader discards it: clip, discard or alpha test"};
    }
    tried.stencilEnabled = state.stencilEnabled;
    if (state.stencilEnabled && !probe.Passes(which, tried))
    {
        const bool isFront = state.cull != CullMode::Front && probe.Reaches(which, CullMode::Back);
        return {PixelFate::Stencil, StencilReason(state, isFront, before)};
    }
    const bool testsDepth =
        state.zTest != CompareFunction::Always && state.zTest != CompareFunction::Disabled;
    if (testsDepth && !before.depth.empty() && !probe.Passes(which, state))
    {
        return {PixelFate::Depth, DepthReason(state, probe.DepthOf(which), before)};
    }
    if (isEmpty)
    {
        return {
            PixelFate::OutOfReach,
            "the pixel is out of its reach: the texture that it reads is empty around the pixel"};
    }
    return WhyItAddsNothing(probe, which, before.colors.size());
}

} // namespace limn
