#include "frame/FrameNode.h"

#include <optional>

namespace limn
{

namespace
{

/// Returns the factor of a colour's component, or nothing if the factor depends on the contents of
/// the target.
std::optional<float> Factor(BlendMode mode, float component, float alpha)
{
    switch (mode)
    {
    case BlendMode::Zero:
        return 0.0f;
    case BlendMode::One:
        return 1.0f;
    case BlendMode::SrcColor:
        return component;
    case BlendMode::OneMinusSrcColor:
        return 1.0f - component;
    case BlendMode::SrcAlpha:
        return alpha;
    case BlendMode::OneMinusSrcAlpha:
        return 1.0f - alpha;
    case BlendMode::DstColor:
    case BlendMode::OneMinusDstColor:
    case BlendMode::DstAlpha:
    case BlendMode::OneMinusDstAlpha:
    case BlendMode::SrcAlphaSaturate:
        break;
    }
    return std::nullopt;
}

bool LeavesComponentAsItIs(BlendMode source, BlendMode destination, BlendOp op, float component,
                           float alpha)
{
    const std::optional<float> kept = Factor(destination, component, alpha);
    const std::optional<float> added = Factor(source, component, alpha);
    return op == BlendOp::Add && kept == 1.0f && added && component * *added == 0.0f;
}

} // namespace

bool LeavesTargetAsItIs(const RenderTargetBlendState& blend, const Color& color)
{
    const auto leavesColor = [&](int bit, float component)
    {
        return (blend.writeMask & bit) == 0 ||
               LeavesComponentAsItIs(blend.sourceColorBlendMode, blend.destinationColorBlendMode,
                                     blend.colorBlendOperation, component, color.a);
    };
    return leavesColor(ColorWriteMask::Red, color.r) &&
           leavesColor(ColorWriteMask::Green, color.g) &&
           leavesColor(ColorWriteMask::Blue, color.b) &&
           ((blend.writeMask & ColorWriteMask::Alpha) == 0 ||
            LeavesComponentAsItIs(blend.sourceAlphaBlendMode, blend.destinationAlphaBlendMode,
                                  blend.alphaBlendOperation, color.a, color.a));
}

bool ReplacesTarget(const RenderTargetBlendState& blend)
{
    return blend == RenderTargetBlendState();
}

bool ReplacesColor(const RenderTargetBlendState& blend)
{
    return blend.sourceColorBlendMode == BlendMode::One &&
           blend.destinationColorBlendMode == BlendMode::Zero &&
           blend.colorBlendOperation == BlendOp::Add;
}

bool FactorsReadAlpha(const RenderTargetBlendState& blend)
{
    const auto reads = [](BlendMode mode)
    {
        return mode == BlendMode::DstAlpha || mode == BlendMode::OneMinusDstAlpha ||
               mode == BlendMode::SrcAlphaSaturate;
    };
    return reads(blend.sourceColorBlendMode) || reads(blend.destinationColorBlendMode);
}

bool ReadsTargetAlpha(const RenderTargetBlendState& blend)
{
    return FactorsReadAlpha(blend) || blend.colorBlendOperation > BlendOp::Max;
}

} // namespace limn
