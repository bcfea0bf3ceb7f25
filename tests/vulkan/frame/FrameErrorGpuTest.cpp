#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "Mentions.h"
#include "core/ThrownMessage.h"
#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

std::string ErrorOf(const CompiledFrame& frame)
{
    return ThrownMessage<ContractError>([&] { SharedDevice().Execute(frame); });
}

PassPtr TexturedPass()
{
    static const PassPtr pass = CompilePass(R"(
        Texture2D _MainTex;
        SamplerState sampler_MainTex;
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag() : SV_Target { return _MainTex.SampleLevel(sampler_MainTex, 0.5, 0); })");
    return pass;
}

/// One draw of TexturedPass.
CompiledFrame TexturedFrame(const DrawBindings& bindings)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(
        MakeDraw(frame, TexturedPass(), MakeQuad(), PlainState(), bindings));
    return frame;
}

std::string BindingText(std::uint32_t binding)
{
    return "(binding " + std::to_string(binding) + ")";
}

} // namespace

using FrameErrors = GpuTest;

TEST_F(FrameErrors, NameATextureThatADrawDoesNotBind)
{
    const std::uint32_t binding = TexturedPass()->layout.textures.at(0).binding;
    EXPECT_THAT(ErrorOf(TexturedFrame({})),
                Mentions("no texture", "'_MainTex' " + BindingText(binding)));
}

TEST_F(FrameErrors, NameASamplerThatADrawDoesNotBind)
{
    DrawBindings bindings;
    bindings.textures = {{TexturedPass()->layout.textures.at(0).binding,
                          std::make_shared<Texture2D>("grey", 1, 1, GraphicsFormat::R8_UNorm,
                                                      std::vector<std::byte>(1)),
                          std::nullopt}};
    const std::uint32_t binding = TexturedPass()->layout.samplers.at(0).binding;
    EXPECT_THAT(ErrorOf(TexturedFrame(bindings)),
                Mentions("no sampler", "'sampler_MainTex' " + BindingText(binding)));
}

TEST_F(FrameErrors, NameUniformsThatADrawDoesNotBind)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeDraw(frame, ColorPass(), MakeQuad()));
    const std::uint32_t binding = ColorPass()->layout.buffers.at(0).binding;
    EXPECT_THAT(ErrorOf(frame), Mentions("no uniform data", "'Material' " + BindingText(binding)));
}

TEST_F(FrameErrors, RefuseUniformsBeyondTheFramesData)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), Color::red));
    frame.uniformData.resize(8);
    EXPECT_THAT(ErrorOf(frame), Mentions("'Material'", "16 bytes", "byte 0", "reads 16 bytes",
                                         "multiple of 256", "frame's 8 bytes"));
}

TEST_F(FrameErrors, RefuseATextureThatNoBarrierMadeReadable)
{
    DrawBindings bindings;
    const TargetPtr source = MakeTarget(1, 1, GraphicsFormat::R8_UNorm, "source");
    bindings.textures = {{TexturedPass()->layout.textures.at(0).binding, source, std::nullopt}};
    bindings.samplers = {{TexturedPass()->layout.samplers.at(0).binding, {}}};
    EXPECT_THAT(ErrorOf(TexturedFrame(bindings)),
                Mentions("'source'", "read as '_MainTex'", "Undefined", "barrier", "ShaderRead"));
}

TEST_F(FrameErrors, RefuseATextureOfAnotherDimension)
{
    const std::vector<std::byte> texel(1);
    DrawBindings bindings;
    bindings.textures = {
        {TexturedPass()->layout.textures.at(0).binding,
         std::make_shared<Cubemap>("sky", 1, GraphicsFormat::R8_UNorm,
                                   CubemapFaces{texel, texel, texel, texel, texel, texel}),
         std::nullopt}};
    bindings.samplers = {{TexturedPass()->layout.samplers.at(0).binding, {}}};
    EXPECT_THAT(ErrorOf(TexturedFrame(bindings)),
                Mentions("'sky'", "read as '_MainTex'", "a Cube", "a 2D"));
}

TEST_F(FrameErrors, RefuseABarrierFromAUseThatIsNot)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].barriers[0].before = TextureUsage::ShaderRead;
    EXPECT_THAT(ErrorOf(frame),
                Mentions("'test pass'", "'target'", "barrier", "from ShaderRead", "is Undefined"));
}

TEST_F(FrameErrors, RefuseATargetThatNoBarrierMadeOne)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].barriers.clear();
    EXPECT_THAT(ErrorOf(frame),
                Mentions("'test pass'", "'target'", "Undefined", "barrier", "ColorAttachment"));
}

TEST_F(FrameErrors, RefuseATargetSmallerThanThePass)
{
    const TargetPtr target = MakeTarget(2, 2);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].width = 4;
    EXPECT_THAT(ErrorOf(frame), Mentions("'test pass'", "'target'", "2x2", "4x2"));
}

TEST_F(FrameErrors, RefuseAColorTextureAsDepthTarget)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    AddDepth(frame.passes[0], MakeTarget(1, 1, GraphicsFormat::R8_UNorm, "no depth"));
    frame.passes[0].barriers.pop_back();
    EXPECT_THAT(ErrorOf(frame),
                Mentions("'test pass'", "'no depth'", "R8_UNorm", "no depth format"));
}

TEST_F(FrameErrors, RefuseAnEmptyViewport)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(SetViewportCommand{{0, 0, 0, 1}});
    EXPECT_THAT(ErrorOf(frame), Mentions("'test pass'", "viewport", "0x1", "positive"));
}

TEST_F(FrameErrors, RefuseAViewportThatTheDeviceDoesNotReach)
{
    const auto errorOf = [](const ViewportRect& rect)
    {
        const TargetPtr target = MakeTarget(1, 1);
        CompiledFrame frame = FrameOf({ClearPass(target)}, target);
        frame.passes[0].commands.emplace_back(SetViewportCommand{rect});
        return ErrorOf(frame);
    };
    constexpr int k_Far = 1 << 30;
    EXPECT_THAT(errorOf({0, 0, k_Far, 1}),
                Mentions("'test pass'", "viewport", "1073741824x1 at (0, 0)", "at most"));
    EXPECT_THAT(errorOf({0, 0, 1, k_Far}), testing::HasSubstr("is 1x1073741824 at (0, 0)"));
    EXPECT_THAT(errorOf({-k_Far, 0, 1, 1}), testing::HasSubstr("is 1x1 at (-1073741824, 0)"));
    EXPECT_THAT(errorOf({0, k_Far, 1, 1}), testing::HasSubstr("is 1x1 at (0, 1073741824)"));
}

TEST_F(FrameErrors, RefuseASubMeshThatIsNot)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    DrawCommand draw = MakeColorDraw(frame, MakeQuad(), Color::red);
    draw.subMesh = 1;
    frame.passes[0].commands.emplace_back(draw);
    EXPECT_THAT(ErrorOf(frame), Mentions("sub-mesh 1", "'quad'", "has 1"));
}

TEST_F(FrameErrors, LeaveNothingOfTheFrameBehind)
{
    const TargetPtr target = MakeTarget(1, 1);
    SharedDevice().Execute(FrameOf({ClearPass(target, Color::green)}, target));
    const VulkanDeviceStatistics before = SharedDevice().statistics();

    CompiledFrame wrong = FrameOf({ClearPass(target, Color::red)}, target);
    wrong.passes.push_back(wrong.passes[0]); // its barrier is right for the first pass only
    wrong.passes[0].barriers[0].before = TextureUsage::CopySource;
    wrong.passes[1].barriers[0].before = TextureUsage::CopySource;
    wrong.passes[0].commands.emplace_back(MakeColorDraw(wrong, MakeQuad(), Color::red));
    EXPECT_THAT(ErrorOf(wrong), Mentions("'test pass'", "'target'", "barrier", "from CopySource",
                                         "is ColorAttachment"));

    EXPECT_EQ(before.meshes, SharedDevice().statistics().meshes);
    EXPECT_EQ((Rgba8{0, 255, 0, 255}), Texel8(ReadRows(*target), 0, 0));
    wrong.passes.pop_back();
    SharedDevice().Execute(wrong);
    EXPECT_EQ((Rgba8{255, 0, 0, 255}), Texel8(ReadRows(*target), 0, 0));
}

TEST_F(FrameErrors, ReadBackNamesATextureNeverDrawn)
{
    const TargetPtr target = MakeTarget(1, 1);
    EXPECT_THAT(ThrownMessage<ContractError>([&] { ReadRows(*target); }),
                Mentions("'target'", "read back", "no frame"));
}

TEST_F(FrameErrors, ReadBackNamesATextureThatIsNoOutput)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.finalBarriers.clear();
    SharedDevice().Execute(frame);
    EXPECT_THAT(ThrownMessage<ContractError>([&] { ReadRows(*target); }),
                Mentions("'target'", "read back", "ColorAttachment", "CopySource"));
}

TEST_F(FrameErrors, ReadBackRefusesSamplesThatAreNotResolved)
{
    RenderTextureDescriptor descriptor{1, 1, GraphicsFormat::R8G8B8A8_UNorm};
    descriptor.msaaSamples = 4;
    const auto target = std::make_shared<RenderTexture>("smooth", descriptor);
    descriptor.graphicsFormat = GraphicsFormat::D32_SFloat;
    const auto depth = std::make_shared<RenderTexture>("depth", descriptor);
    CompiledFrame frame = FrameOf({ClearPass(target)}, depth);
    AddDepth(frame.passes[0], depth);
    SharedDevice().Execute(frame);
    EXPECT_THAT(ThrownMessage<ContractError>([&] { ReadRows(*depth); }),
                Mentions("'depth'", "read back", "not resolve", "4 samples"));
}

} // namespace limn::test
