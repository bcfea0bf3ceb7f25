#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

namespace limn::test
{

namespace
{

/// Writes (1, 0.8, 0.6, 0.4) to eight targets.
PassPtr EightOutputPass()
{
    static const PassPtr pass = CompilePass(R"(
        struct Outputs
        {
            float4 a : SV_Target0; float4 b : SV_Target1; float4 c : SV_Target2;
            float4 d : SV_Target3; float4 e : SV_Target4; float4 f : SV_Target5;
            float4 g : SV_Target6; float4 h : SV_Target7;
        };
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        Outputs frag()
        {
            Outputs o;
            o.a = o.b = o.c = o.d = o.e = o.f = o.g = o.h = float4(1, 0.8, 0.6, 0.4);
            return o;
        })");
    return pass;
}

} // namespace

using ColorMask = GpuTest;

TEST_F(ColorMask, WritesTheNamedChannelsOfEachOfEightTargets)
{
    constexpr int k_Masks = 16;
    CompiledFrame frame;
    CompiledRenderPass pass;
    pass.name = "masks";
    pass.width = k_Masks;
    pass.height = 1;
    std::vector<TargetPtr> targets;
    for (int t = 0; t < 8; ++t)
    {
        targets.push_back(MakeTarget(k_Masks, 1));
        pass.barriers.push_back(
            {targets.back(), TextureUsage::Undefined, TextureUsage::ColorAttachment});
        pass.colors.push_back({targets.back(), LoadOp::Clear, StoreOp::Store, {0, 0, 0, 0}});
        frame.finalBarriers.push_back(
            {targets.back(), TextureUsage::ColorAttachment, TextureUsage::CopySource});
    }
    // Target t has mask (column + t) % 16: in no draw do two of them agree.
    PipelineState state = PlainState();
    const DrawCommand draw = MakeDraw(frame, EightOutputPass(), MakeQuad());
    for (int column = 0; column < k_Masks; ++column)
    {
        for (int t = 0; t < 8; ++t)
        {
            state.targets.at(static_cast<std::size_t>(t)).writeMask = (column + t) % k_Masks;
        }
        pass.commands.emplace_back(SetViewportCommand{{column, 0, 1, 1}});
        pass.commands.emplace_back(WithState(frame, draw, state));
    }
    frame.passes.push_back(std::move(pass));
    SharedDevice().Execute(frame);
    for (int t = 0; t < 8; ++t)
    {
        const Image image = ReadRows(*targets.at(static_cast<std::size_t>(t)));
        for (int column = 0; column < k_Masks; ++column)
        {
            const int mask = (column + t) % k_Masks; // 8 red, 4 green, 2 blue, 1 alpha
            const Rgba8 expected = {(mask & 8) != 0 ? 255 : 0, (mask & 4) != 0 ? 204 : 0,
                                    (mask & 2) != 0 ? 153 : 0, (mask & 1) != 0 ? 102 : 0};
            EXPECT_EQ(expected, Texel8(image, column, 0)) << "target " << t << ", mask " << mask;
        }
    }
}

} // namespace limn::test
