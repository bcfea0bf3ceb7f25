#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limn/core/PipelineState.h>

namespace limn::test
{

using Double4 = std::array<double, 4>;

// The blend equation, written anew from the names of Unity's factors.

inline double Factor(BlendMode mode, const Double4& source, const Double4& destination,
                     std::size_t c)
{
    switch (mode)
    {
    case BlendMode::Zero:
        return 0.0;
    case BlendMode::One:
        return 1.0;
    case BlendMode::DstColor:
        return destination[c];
    case BlendMode::SrcColor:
        return source[c];
    case BlendMode::OneMinusDstColor:
        return 1.0 - destination[c];
    case BlendMode::SrcAlpha:
        return source[3];
    case BlendMode::OneMinusSrcColor:
        return 1.0 - source[c];
    case BlendMode::DstAlpha:
        return destination[3];
    case BlendMode::OneMinusDstAlpha:
        return 1.0 - destination[3];
    case BlendMode::SrcAlphaSaturate:
        return c == 3 ? 1.0 : std::min(source[3], 1.0 - destination[3]);
    case BlendMode::OneMinusSrcAlpha:
        return 1.0 - source[3];
    }
    return 0.0;
}

/// A blended channel and the size of its larger term, which its rounding error goes with.
struct Blended
{
    double value = 0.0;
    double scale = 0.0;
};

inline Blended Blend(const RenderTargetBlendState& blend, const Double4& source,
                     const Double4& destination, std::size_t c)
{
    const bool alpha = c == 3;
    const BlendOp op = alpha ? blend.alphaBlendOperation : blend.colorBlendOperation;
    if (op == BlendOp::Min || op == BlendOp::Max)
    {
        const auto [least, most] = std::minmax(source[c], destination[c]);
        return {op == BlendOp::Min ? least : most, std::max(std::abs(least), std::abs(most))};
    }
    const double src =
        source[c] * Factor(alpha ? blend.sourceAlphaBlendMode : blend.sourceColorBlendMode, source,
                           destination, c);
    const double dst = destination[c] * Factor(alpha ? blend.destinationAlphaBlendMode
                                                     : blend.destinationColorBlendMode,
                                               source, destination, c);
    const double scale = std::max(std::abs(src), std::abs(dst));
    switch (op)
    {
    case BlendOp::Subtract:
        return {src - dst, scale};
    case BlendOp::ReverseSubtract:
        return {dst - src, scale};
    default:
        return {src + dst, scale};
    }
}

} // namespace limn::test
