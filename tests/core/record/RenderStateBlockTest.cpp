#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/RenderStateBlock.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

/// A state that differs from every default, so that whatever is replaced shows.
PipelineState Authored()
{
    PipelineState state;
    state.cull = CullMode::Front;
    state.zTest = CompareFunction::Greater;
    state.zWrite = false;
    state.zClip = false;
    state.offsetFactor = 2.0f;
    state.offsetUnits = 3.0f;
    state.alphaToMask = true;
    state.conservative = true;
    for (RenderTargetBlendState& target : state.targets)
    {
        target = {ColorWriteMask::Red, BlendMode::SrcAlpha, BlendMode::One, BlendMode::Zero,
                  BlendMode::One,      BlendOp::Max,        BlendOp::Min};
    }
    state.stencilEnabled = true;
    state.stencilReference = 7;
    state.stencilReadMask = 15;
    state.stencilWriteMask = 3;
    state.stencilFront = {CompareFunction::Less, StencilOp::Invert, StencilOp::Zero,
                          StencilOp::Replace};
    state.stencilBack = state.stencilFront;
    return state;
}

TEST(RenderStateBlock, HasUnitysNumbersAndDefaults)
{
    EXPECT_EQ(static_cast<int>(RenderStateMask::Blend), 1);
    EXPECT_EQ(static_cast<int>(RenderStateMask::Raster), 2);
    EXPECT_EQ(static_cast<int>(RenderStateMask::Depth), 4);
    EXPECT_EQ(static_cast<int>(RenderStateMask::Stencil), 8);
    EXPECT_EQ(static_cast<int>(RenderStateMask::Everything), 15);
    const RenderStateBlock block;
    EXPECT_EQ(block.mask, RenderStateMask::Nothing);
    EXPECT_EQ(block.depthState.compareFunction, CompareFunction::Less);
    EXPECT_TRUE(block.depthState.writeEnabled);
    EXPECT_TRUE(block.stencilState.enabled);
    EXPECT_EQ(block.stencilState.readMask, 255);
    EXPECT_EQ(block.stencilState.writeMask, 255);
    EXPECT_EQ(block.rasterState.cullingMode, CullMode::Back);
    EXPECT_TRUE(block.rasterState.depthClip);
}

TEST(RenderStateBlock, LeavesWhatIsOutsideItsMask)
{
    RenderStateBlock block;
    block.rasterState.cullingMode = CullMode::Off;
    block.stencilReference = 99;
    EXPECT_EQ(Override(Authored(), block), Authored());
}

TEST(RenderStateBlock, ReplacesDepthWholesale)
{
    RenderStateBlock block(RenderStateMask::Depth);
    PipelineState expected = Authored();
    expected.zTest = CompareFunction::Less;
    expected.zWrite = true;
    EXPECT_EQ(Override(Authored(), block), expected);
}

TEST(RenderStateBlock, ReplacesTheStencilWholesale)
{
    RenderStateBlock block(RenderStateMask::Stencil);
    block.stencilReference = 1;
    block.stencilState.SetCompareFunction(CompareFunction::Equal);
    block.stencilState.SetPassOperation(StencilOp::Replace);
    PipelineState expected = Authored();
    expected.stencilReference = 1;
    expected.stencilReadMask = 255;
    expected.stencilWriteMask = 255;
    expected.stencilFront = {CompareFunction::Equal, StencilOp::Replace, StencilOp::Keep,
                             StencilOp::Keep};
    expected.stencilBack = expected.stencilFront;
    EXPECT_EQ(Override(Authored(), block), expected);
}

TEST(RenderStateBlock, SwitchesTheStencilOff)
{
    RenderStateBlock block(RenderStateMask::Stencil);
    block.stencilState.enabled = false;
    EXPECT_FALSE(Override(Authored(), block).stencilEnabled);
}

TEST(RenderStateBlock, ReplacesRasterWholesale)
{
    RenderStateBlock block(RenderStateMask::Raster);
    block.rasterState.offsetUnits = -1.0f;
    PipelineState expected = Authored();
    expected.cull = CullMode::Back;
    expected.offsetFactor = 0.0f;
    expected.offsetUnits = -1.0f;
    expected.zClip = true;
    expected.conservative = false;
    EXPECT_EQ(Override(Authored(), block), expected);
}

TEST(RenderStateBlock, ReplacesBlendingOfAllTargetsByTheFirst)
{
    RenderStateBlock block(RenderStateMask::Blend);
    block.blendState.blendStates[0].sourceColorBlendMode = BlendMode::SrcAlpha;
    block.blendState.blendStates[0].destinationColorBlendMode = BlendMode::OneMinusSrcAlpha;
    block.blendState.blendStates[3].writeMask = 0;
    const PipelineState result = Override(Authored(), block);
    EXPECT_FALSE(result.alphaToMask);
    for (const RenderTargetBlendState& target : result.targets)
    {
        EXPECT_EQ(target, block.blendState.blendStates[0]);
    }
}

TEST(RenderStateBlock, ReplacesBlendingTargetByTargetWhereAsked)
{
    RenderStateBlock block(RenderStateMask::Blend);
    block.blendState.separateMRTBlendStates = true;
    block.blendState.blendStates[3].writeMask = ColorWriteMask::Alpha;
    const PipelineState result = Override(Authored(), block);
    EXPECT_EQ(result.targets[0], RenderTargetBlendState());
    EXPECT_EQ(result.targets[3], (RenderTargetBlendState{ColorWriteMask::Alpha}));
}

TEST(RenderStateBlock, RefusesNumbersThatNoStencilHas)
{
    RenderStateBlock block(RenderStateMask::Stencil);
    block.stencilReference = 256;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Override(Authored(), block); }),
                test::Mentions("RenderStateBlock", "stencilReference", "256", "0...255"));
    block.stencilReference = 0;
    block.stencilState.readMask = -1;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Override(Authored(), block); }),
                test::Mentions("RenderStateBlock", "stencilState.readMask", "-1", "0...255"));
}

} // namespace
} // namespace limn
