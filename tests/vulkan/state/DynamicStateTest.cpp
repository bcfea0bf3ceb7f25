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
    device.depthClamp = true;
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
    EXPECT_EQ("a draw has ZClip False, and the device lacks depthClamp; it draws ZClip True only",
              ThrownMessage<ContractError>([&] { MakePipelineKey(state, {}, {}); }));
}

TEST(PipelineKeys, RefuseConservativeRasterizationOnADeviceWithoutIt)
{
    PipelineState state;
    state.conservative = true;
    EXPECT_EQ("a draw has Conservative True, and the device lacks "
              "VK_EXT_conservative_rasterization; it draws the texels whose centre is covered only",
              ThrownMessage<ContractError>([&] { MakePipelineKey(state, {}, {}); }));
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
    EXPECT_EQ("a draw has BlendOp LogicalXor, and the device lacks logicOp; every device has Add, "
              "Sub, RevSub, Min and Max",
              Refusal(logical, one, device));
    EXPECT_EQ("a draw has BlendOp Multiply, and the device lacks VK_EXT_blend_operation_advanced; "
              "every device has Add, Sub, RevSub, Min and Max",
              Refusal(advanced, one, device));
    device.advancedBlendTargets = 1;
    EXPECT_NO_THROW(MakePipelineKey(advanced, one, device));
    EXPECT_EQ("a draw has BlendOp Multiply, and the device has it for 1 target(s) at most, not for "
              "2; every device has Add, Sub, RevSub, Min and Max",
              Refusal(advanced, Formats({VK_FORMAT_R8_UNORM, VK_FORMAT_R8_UNORM}), device));
    EXPECT_NO_THROW(MakePipelineKey(logical, {}, {})); // nothing to combine with
}

TEST(PipelineKeys, RefuseLogicalBlendOpsWhereThereAreNoBits)
{
    DeviceCapabilities device;
    device.logicOp = true;
    const PipelineState state = Blended(BlendOp::LogicalAnd, BlendOp::LogicalAnd);
    for (const VkFormat format : {VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R16G16B16A16_SFLOAT})
    {
        EXPECT_EQ("a draw has BlendOp LogicalAnd into a target of floats or sRGB values; a logical "
                  "operation wants R8_UNorm, R8G8B8A8_UNorm or R8G8B8A8_SNorm",
                  Refusal(state, Formats({VK_FORMAT_R8_UNORM, format}), device));
    }
}

TEST(PipelineKeys, RefuseLogicalAndAdvancedBlendOpsForAPart)
{
    DeviceCapabilities device;
    device.logicOp = true;
    const TargetFormats two = Formats({VK_FORMAT_R8_UNORM, VK_FORMAT_R8_UNORM});
    PipelineState oneTarget = Blended(BlendOp::LogicalOr, BlendOp::LogicalOr);
    oneTarget.targets[1] = {};
    EXPECT_NO_THROW(MakePipelineKey(oneTarget, Formats({VK_FORMAT_R8_UNORM}), device));
    const std::string said =
        "a draw has BlendOp LogicalOr for a part of its outputs; the device applies it to colour "
        "and alpha of all targets alike: write Blend and 'BlendOp "
        "LogicalOr' with neither a target nor a ','";
    EXPECT_EQ(said, Refusal(oneTarget, two, device));
    EXPECT_EQ(said, Refusal(Blended(BlendOp::LogicalOr, BlendOp::Add), two, device));
    EXPECT_EQ(said, Refusal(Blended(BlendOp::Max, BlendOp::LogicalOr), two, device));
}

TEST(PipelineKeys, BakeAdvancedBlendOpsIn)
{
    DeviceCapabilities device;
    device.dynamicBlend = true;
    device.logicOp = true;
    device.advancedBlendTargets = 1;
    const TargetFormats one = Formats({VK_FORMAT_R8_UNORM});
    EXPECT_FALSE(
        MakePipelineKey(Blended(BlendOp::Screen, BlendOp::Screen), one, device).dynamicBlend);
    EXPECT_TRUE(MakePipelineKey(Blended(BlendOp::LogicalSet, BlendOp::LogicalSet), one, device)
                    .dynamicBlend);
}

} // namespace limn::test
