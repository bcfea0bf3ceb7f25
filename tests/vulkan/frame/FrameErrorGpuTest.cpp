#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
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
    EXPECT_EQ("a draw binds no texture for '_MainTex' " + BindingText(binding) +
                  ", which its shader reads",
              ErrorOf(TexturedFrame({})));
}

TEST_F(FrameErrors, NameASamplerThatADrawDoesNotBind)
{
    DrawBindings bindings;
    bindings.textures = {{TexturedPass()->layout.textures.at(0).binding,
                          std::make_shared<Texture2D>("grey", 1, 1, GraphicsFormat::R8_UNorm,
                                                      std::vector<std::byte>(1)),
                          std::nullopt}};
    const std::uint32_t binding = TexturedPass()->layout.samplers.at(0).binding;
    EXPECT_EQ("a draw binds no sampler for 'sampler_MainTex' " + BindingText(binding) +
                  ", which its shader reads",
              ErrorOf(TexturedFrame(bindings)));
}

TEST_F(FrameErrors, NameUniformsThatADrawDoesNotBind)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeDraw(frame, ColorPass(), MakeQuad()));
    const std::uint32_t binding = ColorPass()->layout.buffers.at(0).binding;
    EXPECT_EQ("a draw binds no uniform data for 'Material' " + BindingText(binding) +
                  ", which its shader reads",
              ErrorOf(frame));
}

TEST_F(FrameErrors, RefuseUniformsBeyondTheFramesData)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), Color::red));
    frame.uniformData.resize(8);
    EXPECT_EQ("the uniform data of 'Material' are 16 bytes at 0; the shader reads 16, at a "
              "multiple of 256, of the frame's 8",
              ErrorOf(frame));
}

TEST_F(FrameErrors, RefuseATextureThatNoBarrierMadeReadable)
{
    DrawBindings bindings;
    const TargetPtr source = MakeTarget(1, 1, GraphicsFormat::R8_UNorm, "source");
    bindings.textures = {{TexturedPass()->layout.textures.at(0).binding, source, std::nullopt}};
    bindings.samplers = {{TexturedPass()->layout.samplers.at(0).binding, {}}};
    EXPECT_EQ("texture 'source' is read as '_MainTex' while its use is Undefined; a barrier must "
              "make it ShaderRead",
              ErrorOf(TexturedFrame(bindings)));
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
    EXPECT_EQ("texture 'sky' is read as '_MainTex': it is a Cube texture; the shader reads a 2D",
              ErrorOf(TexturedFrame(bindings)));
}

TEST_F(FrameErrors, RefuseABarrierFromAUseThatIsNot)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].barriers[0].before = TextureUsage::ShaderRead;
    EXPECT_EQ("pass 'test pass': texture 'target': the barrier takes it from ShaderRead, and its "
              "use is Undefined",
              ErrorOf(frame));
}

TEST_F(FrameErrors, RefuseATargetThatNoBarrierMadeOne)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].barriers.clear();
    EXPECT_EQ("pass 'test pass': target 'target': its use is Undefined; a barrier must make it "
              "ColorAttachment",
              ErrorOf(frame));
}

TEST_F(FrameErrors, RefuseATargetSmallerThanThePass)
{
    const TargetPtr target = MakeTarget(2, 2);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].width = 4;
    EXPECT_EQ("pass 'test pass': target 'target': it is 2x2, the pass draws 4x2", ErrorOf(frame));
}

TEST_F(FrameErrors, RefuseAColorTextureAsDepthTarget)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    AddDepth(frame.passes[0], MakeTarget(1, 1, GraphicsFormat::R8_UNorm, "no depth"));
    frame.passes[0].barriers.pop_back();
    EXPECT_EQ("pass 'test pass': target 'no depth': R8_UNorm is no depth format", ErrorOf(frame));
}

TEST_F(FrameErrors, RefuseAnEmptyViewport)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(SetViewportCommand{{0, 0, 0, 1}});
    EXPECT_EQ("pass 'test pass': the viewport has the size 0x1; it must be positive",
              ErrorOf(frame));
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
                testing::StartsWith("pass 'test pass': the viewport is 1073741824x1 at (0, 0); the "
                                    "device draws at most "));
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
    EXPECT_EQ("a draw asks for sub-mesh 1 of mesh 'quad', which has 1", ErrorOf(frame));
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
    EXPECT_EQ("pass 'test pass': texture 'target': the barrier takes it from CopySource, and its "
              "use is ColorAttachment",
              ErrorOf(wrong));

    EXPECT_EQ(before.meshes, SharedDevice().statistics().meshes);
    EXPECT_EQ((Rgba8{0, 255, 0, 255}), Texel8(ReadRows(*target), 0, 0));
    wrong.passes.pop_back();
    SharedDevice().Execute(wrong);
    EXPECT_EQ((Rgba8{255, 0, 0, 255}), Texel8(ReadRows(*target), 0, 0));
}

TEST_F(FrameErrors, ReadBackNamesATextureNeverDrawn)
{
    const TargetPtr target = MakeTarget(1, 1);
    EXPECT_EQ("texture 'target' cannot be read back: no frame has drawn it",
              ThrownMessage<ContractError>([&] { ReadRows(*target); }));
}

TEST_F(FrameErrors, ReadBackNamesATextureThatIsNoOutput)
{
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.finalBarriers.clear();
    SharedDevice().Execute(frame);
    EXPECT_EQ("texture 'target' cannot be read back: the last frame left it as ColorAttachment; "
              "make it an output (CopySource)",
              ThrownMessage<ContractError>([&] { ReadRows(*target); }));
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
    EXPECT_EQ("texture 'depth' cannot be read back: the last pass that drew into it did not "
              "resolve its 4 samples per texel",
              ThrownMessage<ContractError>([&] { ReadRows(*depth); }));
}

} // namespace limn::test
