#include "frame/FrameNode.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn
{
namespace
{

/// What blending gives, component by component, by the definition of the factors.
float Blended(BlendMode mode, float source, float sourceAlpha, float target, float targetAlpha)
{
    switch (mode)
    {
    case BlendMode::Zero:
        return 0;
    case BlendMode::One:
        return 1;
    case BlendMode::DstColor:
        return target;
    case BlendMode::SrcColor:
        return source;
    case BlendMode::OneMinusDstColor:
        return 1 - target;
    case BlendMode::SrcAlpha:
        return sourceAlpha;
    case BlendMode::OneMinusSrcColor:
        return 1 - source;
    case BlendMode::DstAlpha:
        return targetAlpha;
    case BlendMode::OneMinusDstAlpha:
        return 1 - targetAlpha;
    case BlendMode::SrcAlphaSaturate:
        return std::min(sourceAlpha, 1 - targetAlpha);
    case BlendMode::OneMinusSrcAlpha:
        return 1 - sourceAlpha;
    }
    return NAN;
}

/// Whether all of some texels come out of blending as they went in.
bool KeepsTexels(const RenderTargetBlendState& blend, const Color& c)
{
    for (const float t : {0.0f, 0.25f, 1.0f, 3.0f})
    {
        for (const float ta : {0.0f, 0.5f, 1.0f})
        {
            for (const float s : {c.r, c.g, c.b})
            {
                const float color = s * Blended(blend.sourceColorBlendMode, s, c.a, t, ta) +
                                    t * Blended(blend.destinationColorBlendMode, s, c.a, t, ta);
                if (color != t)
                {
                    return false;
                }
            }
            const float alpha = c.a * Blended(blend.sourceAlphaBlendMode, c.a, c.a, ta, ta) +
                                ta * Blended(blend.destinationAlphaBlendMode, c.a, c.a, ta, ta);
            if (alpha != ta)
            {
                return false;
            }
        }
    }
    return true;
}

/// The factors that do not take what the target holds.
constexpr BlendMode k_Modes[] = {BlendMode::Zero,     BlendMode::One,
                                 BlendMode::SrcColor, BlendMode::OneMinusSrcColor,
                                 BlendMode::SrcAlpha, BlendMode::OneMinusSrcAlpha};

} // namespace

TEST(ConstantBlend, LeavesATargetAsItIsWhereBlendingGivesEveryTexelBack)
{
    RenderTargetBlendState blend;
    int left = 0;
    for (const Color& color : {Color{0, 0, 0, 0}, Color{0, 0, 0, 1}, Color{1, 1, 1, 0},
                               Color{0, 0.5f, 0, 1}, Color{1, 1, 1, 1}})
    {
        for (int i = 0; i < 6 * 6 * 6 * 6; ++i)
        {
            blend.sourceColorBlendMode = k_Modes[i % 6];
            blend.destinationColorBlendMode = k_Modes[i / 6 % 6];
            blend.sourceAlphaBlendMode = k_Modes[i / 36 % 6];
            blend.destinationAlphaBlendMode = k_Modes[i / 216];
            const bool keeps = KeepsTexels(blend, color);
            left += keeps ? 1 : 0;
            ASSERT_EQ(keeps, LeavesTargetAsItIs(blend, color))
                << "mode " << i << ", colour " << color.r << " " << color.g << " " << color.b << " "
                << color.a;
        }
    }
    EXPECT_GT(left, 0);
}

TEST(ConstantBlend, KnowsNothingOfFactorsOfTheTargetAndOfOtherOperations)
{
    RenderTargetBlendState blend;
    blend.destinationColorBlendMode = BlendMode::DstColor;
    EXPECT_FALSE(LeavesTargetAsItIs(blend, Color::clear));
    blend.destinationColorBlendMode = BlendMode::One;
    blend.destinationAlphaBlendMode = BlendMode::One;
    EXPECT_TRUE(LeavesTargetAsItIs(blend, Color::clear));
    blend.colorBlendOperation = BlendOp::ReverseSubtract;
    EXPECT_FALSE(LeavesTargetAsItIs(blend, Color::clear));
}

TEST(ConstantBlend, ReplacesATargetThatItDoesNotLookAt)
{
    RenderTargetBlendState blend;
    EXPECT_TRUE(ReplacesTarget(blend));
    blend.destinationAlphaBlendMode = BlendMode::One;
    EXPECT_FALSE(ReplacesTarget(blend));
    blend = {};
    blend.writeMask = ColorWriteMask::Red;
    EXPECT_FALSE(ReplacesTarget(blend));
}

TEST(ConstantBlend, LooksAtTheComponentsThatAreWrittenOnly)
{
    RenderTargetBlendState blend;
    EXPECT_FALSE(LeavesTargetAsItIs(blend, Color::clear)) << "it is replaced";
    blend.writeMask = 0;
    EXPECT_TRUE(LeavesTargetAsItIs(blend, Color::white));
    blend.destinationColorBlendMode = BlendMode::One;
    blend.writeMask = ColorWriteMask::Red | ColorWriteMask::Blue;
    EXPECT_TRUE(LeavesTargetAsItIs(blend, {0, 1, 0, 1}));
    EXPECT_FALSE(LeavesTargetAsItIs(blend, {0, 0, 1, 1}));
}

} // namespace limn
