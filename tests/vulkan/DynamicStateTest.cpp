#include "core/ThrownMessage.h"
#include <DynamicState.h>

namespace limn::test
{

using namespace limn::vulkan;

TEST(PipelineKeys, TellOnlyWhatIsNotDynamicApart)
{
    DeviceCapabilities device;
    device.dynamicBlend = true;
    device.depthClamp = true;
    PipelineState plain;
    PipelineState other;
    other.stencilEnabled = true;
    other.stencilReference = 7;
    other.zTest = CompareFunction::Greater;
    other.cull = CullMode::Off;
    other.targets[0].enabled = true;
    EXPECT_EQ(MakePipelineKey(plain, {}, device), MakePipelineKey(other, {}, device));
    other.alphaToMask = true;
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

TEST(PipelineKeys, RefuseConservativeRasterization)
{
    PipelineState state;
    state.conservative = true;
    EXPECT_EQ("a draw has Conservative True; limn draws the texels whose centre is covered only",
              ThrownMessage<ContractError>([&] { MakePipelineKey(state, {}, {}); }));
}

} // namespace limn::test
