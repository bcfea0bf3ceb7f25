#include "Mentions.h"
#include "core/ThrownMessage.h"
#include <frame/DynamicState.h>

namespace limn::test
{

using namespace limn::vulkan;

TEST(FixedStates, CompareAndMoveDepthTheOtherWayRoundWithoutReversedZ)
{
    TargetFormats formats;
    formats.depth = VK_FORMAT_D32_SFLOAT;
    PipelineState state;
    state.zTest = CompareFunction::LessEqual;
    state.offsetFactor = 1.0f;
    state.offsetUnits = 2.0f;
    const FixedState reversed = ToFixedState(state, formats, true);
    EXPECT_EQ(reversed.depthCompare, VK_COMPARE_OP_GREATER_OR_EQUAL);
    EXPECT_EQ(reversed.depthBiasSlope, -1.0f);
    EXPECT_EQ(reversed.depthBiasConstant, -2.0f);
    const FixedState standard = ToFixedState(state, formats, false);
    EXPECT_EQ(standard.depthCompare, VK_COMPARE_OP_LESS_OR_EQUAL);
    EXPECT_EQ(standard.depthBiasSlope, 1.0f);
    EXPECT_EQ(standard.depthBiasConstant, 2.0f);
}

TEST(PipelineKeys, TellOnlyWhatIsNotDynamicApart)
{
    DeviceCapabilities device;
    device.dynamicBlend = true;
    device.features.depthClamp = VK_TRUE;
    device.conservative = true;
    PipelineState plain;
    PipelineState other;
    other.stencilEnabled = true;
    other.stencilReference = 7;
    other.zTest = CompareFunction::Greater;
    other.cull = CullMode::Off;
    other.targets[0].destinationColorBlendMode = BlendMode::One;
    EXPECT_EQ(MakePipelineKey(plain, {}, device), MakePipelineKey(other, {}, device));
    other.alphaToMask = true;
    EXPECT_FALSE(MakePipelineKey(plain, {}, device) == MakePipelineKey(other, {}, device));
    other = plain;
    other.conservative = true;
    EXPECT_FALSE(MakePipelineKey(plain, {}, device) == MakePipelineKey(other, {}, device));
    other = plain;
    other.zClip = false;
    EXPECT_FALSE(MakePipelineKey(plain, {}, device) == MakePipelineKey(other, {}, device));
}

TEST(PipelineKeys, RefuseZClipOffOnADeviceThatAlwaysClips)
{
    PipelineState state;
    state.zClip = false;
    EXPECT_THAT(ThrownMessage<ContractError>([&] { MakePipelineKey(state, {}, {}); }),
                Mentions("ZClip False", "lacks depthClamp", "ZClip True"));
}

TEST(PipelineKeys, RefuseConservativeRasterizationOnADeviceWithoutIt)
{
    PipelineState state;
    state.conservative = true;
    EXPECT_THAT(ThrownMessage<ContractError>([&] { MakePipelineKey(state, {}, {}); }),
                Mentions("Conservative True", "lacks VK_EXT_conservative_rasterization"));
}

namespace
{

PipelineState Blended(BlendOp color, BlendOp alpha)
{
    PipelineState state;
    for (RenderTargetBlendState& target : state.targets)
    {
        target.colorBlendOperation = color;
        target.alphaBlendOperation = alpha;
    }
    return state;
}

TargetFormats Formats(const std::vector<VkFormat>& colors)
{
    TargetFormats formats;
    formats.colors.assign(colors.begin(), colors.end());
    return formats;
}

std::string Refusal(const PipelineState& state, const TargetFormats& formats,
                    const DeviceCapabilities& device)
{
    return ThrownMessage<ContractError>([&] { MakePipelineKey(state, formats, device); });
}

} // namespace

TEST(PipelineKeys, RefuseBlendOpsThatTheDeviceLacks)
{
    DeviceCapabilities device;
    const TargetFormats one = Formats({VK_FORMAT_R8G8B8A8_UNORM});
    const PipelineState logical = Blended(BlendOp::LogicalXor, BlendOp::LogicalXor);
    const PipelineState advanced = Blended(BlendOp::Multiply, BlendOp::Multiply);
    EXPECT_THAT(Refusal(logical, one, device),
                Mentions("BlendOp LogicalXor", "lacks logicOp", "every device", "Add"));
    EXPECT_THAT(Refusal(advanced, one, device),
                Mentions("BlendOp Multiply", "lacks VK_EXT_blend_operation_advanced",
                         "every device", "Add"));
    device.advancedBlendTargets = 1;
    EXPECT_NO_THROW(MakePipelineKey(advanced, one, device));
    EXPECT_THAT(
        Refusal(advanced, Formats({VK_FORMAT_R8_UNORM, VK_FORMAT_R8_UNORM}), device),
        Mentions("BlendOp Multiply", "at most 1 target at once", "2", "every device", "Add"));
    EXPECT_NO_THROW(MakePipelineKey(logical, {}, {})); // nothing to combine with
}

TEST(PipelineKeys, RefuseLogicalBlendOpsWhereThereAreNoBits)
{
    DeviceCapabilities device;
    device.features.logicOp = VK_TRUE;
    const PipelineState state = Blended(BlendOp::LogicalAnd, BlendOp::LogicalAnd);
    for (const VkFormat format : {VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R16G16B16A16_SFLOAT})
    {
        EXPECT_THAT(Refusal(state, Formats({VK_FORMAT_R8_UNORM, format}), device),
                    Mentions("BlendOp LogicalAnd", "target of floats", "R8G8B8A8_UNorm"));
    }
}

TEST(PipelineKeys, RefuseLogicalAndAdvancedBlendOpsForAPart)
{
    DeviceCapabilities device;
    device.features.logicOp = VK_TRUE;
    const TargetFormats two = Formats({VK_FORMAT_R8_UNORM, VK_FORMAT_R8_UNORM});
    PipelineState oneTarget = Blended(BlendOp::LogicalOr, BlendOp::LogicalOr);
    oneTarget.targets[1] = {};
    EXPECT_NO_THROW(MakePipelineKey(oneTarget, Formats({VK_FORMAT_R8_UNORM}), device));
    const auto said = Mentions("BlendOp LogicalOr", "a part", "all targets", "'BlendOp LogicalOr'");
    EXPECT_THAT(Refusal(oneTarget, two, device), said);
    EXPECT_THAT(Refusal(Blended(BlendOp::LogicalOr, BlendOp::Add), two, device), said);
    EXPECT_THAT(Refusal(Blended(BlendOp::Max, BlendOp::LogicalOr), two, device), said);
}

TEST(PipelineKeys, BakeAdvancedBlendOpsIn)
{
    DeviceCapabilities device;
    device.dynamicBlend = true;
    device.features.logicOp = VK_TRUE;
    device.advancedBlendTargets = 1;
    const TargetFormats one = Formats({VK_FORMAT_R8_UNORM});
    EXPECT_FALSE(
        MakePipelineKey(Blended(BlendOp::Screen, BlendOp::Screen), one, device).dynamicBlend);
    EXPECT_TRUE(MakePipelineKey(Blended(BlendOp::LogicalSet, BlendOp::LogicalSet), one, device)
                    .dynamicBlend);
}

} // namespace limn::test
