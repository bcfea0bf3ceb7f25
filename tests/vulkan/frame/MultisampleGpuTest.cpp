#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "Mentions.h"
#include "core/ThrownMessage.h"
#include <cmath>
#include <limn/core/FrameCompiler.h>

namespace limn::test
{

namespace
{

// The standard places of four samples have x = 1/8, 3/8, 5/8 and 7/8 of the texel: a quad over the
// left k quarters of a texel covers k samples.

TargetPtr MakeSmooth(int width, GraphicsFormat format = GraphicsFormat::R32G32B32A32_SFloat)
{
    RenderTextureDescriptor descriptor{width, 1, format};
    descriptor.msaaSamples = 4;
    return std::make_shared<RenderTexture>("smooth", descriptor);
}

/// Over the quarters [first, last) of a texel.
MeshPtr Quarters(int first, int last, float z = 0.5f)
{
    return MakeQuad(-1.0f + 0.5f * static_cast<float>(first), -1.0f,
                    -1.0f + 0.5f * static_cast<float>(last), 1.0f, z);
}

/// Draws white over the left 0, 1, 2, 3 and 4 quarters of five texels.
CompiledFrame Staircase(const TargetPtr& target)
{
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    for (int k = 1; k <= 4; ++k)
    {
        frame.passes[0].commands.emplace_back(SetViewportCommand{{k, 0, 1, 1}});
        frame.passes[0].commands.emplace_back(MakeColorDraw(frame, Quarters(0, k), Color::white));
    }
    return frame;
}

/// Reads `_MainTex` at the texel's place.
DrawCommand MakeCopyDraw(FrameTables& frame, const std::shared_ptr<const Texture>& source)
{
    static const PassPtr pass = CompilePass(R"(
        Texture2D _MainTex;
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag(float4 position : SV_POSITION) : SV_Target
        {
            return _MainTex.Load(int3(position.xy, 0));
        })");
    DrawBindings bindings;
    bindings.textures = {{pass->layout.textures.at(0).binding, source, std::nullopt}};
    return MakeDraw(frame, pass, MakeQuad(), PlainState(), bindings);
}

/// What is left of white with this alpha, drawn with AlphaToMask on over black.
float Coverage(float alpha)
{
    const TargetPtr target = MakeSmooth(1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    PipelineState state = PlainState();
    state.alphaToMask = true;
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(), {1, 1, 1, alpha}, state));
    SharedDevice().Execute(frame);
    return TexelFloat(ReadRows(*target), 0, 0)[0];
}

bool IsLavapipe()
{
    return SharedDevice().deviceName().find("llvmpipe") != std::string::npos;
}

} // namespace

using Multisampling = GpuTest;

TEST_F(Multisampling, ReadsBackTheAverageOfTheSamples)
{
    const TargetPtr target = MakeSmooth(5);
    SharedDevice().Execute(Staircase(target));
    const Image image = ReadRows(*target);
    for (int k = 0; k <= 4; ++k)
    {
        EXPECT_EQ(0.25f * static_cast<float>(k), TexelFloat(image, k, 0)[0]);
    }
}

TEST_F(Multisampling, AveragesInTheFormatsOfCameraTargets)
{
    const TargetPtr bytes = MakeSmooth(5, GraphicsFormat::R8G8B8A8_UNorm);
    const TargetPtr halves = MakeSmooth(5, GraphicsFormat::R16G16B16A16_SFloat);
    SharedDevice().Execute(Staircase(bytes));
    const Image byteImage = ReadRows(*bytes);
    SharedDevice().Execute(Staircase(halves));
    const Image halfImage = ReadRows(*halves);
    constexpr std::array<std::uint16_t, 5> k_QuartersAsHalf = {0, 0x3400, 0x3800, 0x3A00, 0x3C00};
    for (int k = 0; k <= 4; ++k)
    {
        // Vulkan lets a device take either of the two integers that a normalized value lies
        // between.
        EXPECT_LT(std::abs(63.75 * k - Texel8(byteImage, k, 0)[0]), 1.0);
        std::uint16_t red = 0;
        std::memcpy(&red, &halfImage.texels.at(static_cast<std::size_t>(k) * 8), 2);
        EXPECT_EQ(k_QuartersAsHalf.at(static_cast<std::size_t>(k)), red);
    }
}

TEST_F(Multisampling, ShowsTheAverageToTheShaderThatReadsIt)
{
    const TargetPtr smooth = MakeSmooth(5);
    const TargetPtr copy = MakeTarget(5, 1, GraphicsFormat::R32G32B32A32_SFloat, "copy");
    CompiledFrame frame = Staircase(smooth);
    frame.passes.push_back(ClearPass(copy));
    frame.passes[1].barriers.push_back(
        {smooth, TextureUsage::ColorAttachment, TextureUsage::ShaderRead});
    frame.passes[1].commands.emplace_back(MakeCopyDraw(frame, smooth));
    frame.finalBarriers = {{copy, TextureUsage::ColorAttachment, TextureUsage::CopySource}};
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*copy);
    for (int k = 0; k <= 4; ++k)
    {
        EXPECT_EQ(0.25f * static_cast<float>(k), TexelFloat(image, k, 0)[0]);
    }
}

TEST_F(Multisampling, WorksThroughTheFrameCompilerFrameAfterFrame)
{
    RenderTextureDescriptor descriptor{1, 1, GraphicsFormat::R32G32B32A32_SFloat, 0};
    descriptor.msaaSamples = 4;
    const auto smooth = std::make_shared<RenderTexture>("smooth", descriptor, SamplerState{}, true);
    descriptor.depthBufferBits = 24;
    const auto depth = std::make_shared<RenderTexture>("depth", descriptor, SamplerState{}, true);
    const TargetPtr copy = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat, "copy");
    const TargetPtr other = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat, "other");
    for (int frameNumber = 1; frameNumber <= 2; ++frameNumber)
    {
        CompiledFrame tables; // and uniforms
        FrameCommands recorded;
        const auto draw = [&](const MeshPtr& mesh)
        {
            recorded.commands.emplace_back(MakeColorDraw(tables, mesh, Color::white));
        };
        recorded.commands.emplace_back(SetRenderTargetCommand{{smooth}, depth});
        recorded.commands.emplace_back(ClearCommand{ClearFlag::All, Color::black, 1.0f, 0});
        draw(Quarters(0, frameNumber));
        recorded.commands.emplace_back(SetRenderTargetCommand{{other}, nullptr});
        recorded.commands.emplace_back(MakeCopyDraw(tables, smooth));
        recorded.commands.emplace_back(SetRenderTargetCommand{{smooth}, depth});
        draw(Quarters(3, 4));
        recorded.commands.emplace_back(SetRenderTargetCommand{{copy}, nullptr});
        recorded.commands.emplace_back(MakeCopyDraw(tables, smooth));
        recorded.uniformData = tables.uniformData;
        static_cast<FrameTables&>(recorded) = std::move(tables);
        const std::shared_ptr<const RenderTexture> outputs[] = {copy, other};
        SharedDevice().Execute(
            CompileFrame(std::move(recorded), SharedDevice().textureStates(), outputs));
        const float first = 0.25f * static_cast<float>(frameNumber);
        EXPECT_EQ(first, TexelFloat(ReadRows(*other), 0, 0)[0]);
        EXPECT_EQ(first + 0.25f, TexelFloat(ReadRows(*copy), 0, 0)[0]);
    }
}

TEST_F(Multisampling, KeepsTheSamplesFromPassToPass)
{
    const TargetPtr target = MakeSmooth(1);
    CompiledFrame frame = FrameOf({ClearPass(target), ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, Quarters(0, 1), Color::white));
    frame.passes[1].barriers[0].before = TextureUsage::ColorAttachment;
    frame.passes[1].colors[0].load = LoadOp::Load;
    frame.passes[1].commands.emplace_back(MakeColorDraw(frame, Quarters(1, 2), Color::white));
    SharedDevice().Execute(frame);
    EXPECT_EQ(0.5f, TexelFloat(ReadRows(*target), 0, 0)[0])
        << "7/16 if the first pass's average had been spread over the samples";
}

TEST_F(Multisampling, TestsDepthAndStencilSampleBySample)
{
    const TargetPtr target = MakeSmooth(1);
    RenderTextureDescriptor descriptor{1, 1, GraphicsFormat::D32_SFloat_S8_UInt};
    descriptor.msaaSamples = 4;
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    AddDepth(frame.passes[0], std::make_shared<RenderTexture>("smooth depth", descriptor));
    PipelineState state;
    state.stencilEnabled = true;
    state.stencilFront.pass = StencilOp::IncrementWrap;
    const auto draw = [&](const MeshPtr& mesh, Color color)
    {
        frame.passes[0].commands.emplace_back(MakeColorDraw(frame, mesh, color, state));
    };
    draw(Quarters(0, 2, 0.75f), Color::red);
    draw(Quarters(0, 3, 0.5f), Color::green); // the nearer red hides two quarters of it
    state.stencilReference = 0;
    state.stencilFront.compare = CompareFunction::Equal;
    draw(Quarters(0, 4, 0.25f), {0, 0, 1, 1}); // where nothing has been drawn
    SharedDevice().Execute(frame);
    const std::array<float, 4> texel = TexelFloat(ReadRows(*target), 0, 0);
    EXPECT_EQ((std::array<float, 4>{0.5f, 0.25f, 0.25f, 1.0f}), texel);
}

TEST_F(Multisampling, TurnsAlphaIntoCoveredSamplesWithAlphaToMask)
{
    float before = 0.0f;
    for (int i = 0; i <= 16; ++i)
    {
        const float alpha = static_cast<float>(i) / 16.0f;
        const float coverage = Coverage(alpha);
        EXPECT_EQ(std::round(coverage * 4.0f), coverage * 4.0f) << "whole samples";
        EXPECT_GE(coverage, before) << "more alpha never covers less";
        before = coverage;
        if (IsLavapipe()) // the rule between 0 and 1 is each driver's own; this one rounds up
        {
            EXPECT_EQ(std::ceil(alpha * 4.0f) / 4.0f, coverage) << "alpha " << alpha;
        }
    }
    EXPECT_EQ(0.0f, Coverage(0.0f));
    EXPECT_EQ(1.0f, Coverage(1.0f));
}

TEST_F(Multisampling, CoversAllSamplesWhateverTheAlphaWithoutAlphaToMask)
{
    const TargetPtr target = MakeSmooth(1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(), {1, 1, 1, 0.25f}, PlainState()));
    SharedDevice().Execute(frame);
    EXPECT_EQ((std::array<float, 4>{1, 1, 1, 0.25f}), TexelFloat(ReadRows(*target), 0, 0));
}

/// A pass that draws what covers the texel's samples from the left: depth 0.75, 0.5, 0.25, nothing.
/// The first sample is the second from the left.
CompiledRenderPass SlopePass(CompiledFrame& frame, const TargetPtr& target, const TargetPtr& depth)
{
    CompiledRenderPass pass = ClearPass(target);
    AddDepth(pass, depth);
    PipelineState state;
    state.stencilEnabled = true;
    state.stencilFront.pass = StencilOp::Replace;
    for (int k = 0; k < 3; ++k)
    {
        state.stencilReference = k + 1;
        pass.commands.emplace_back(MakeColorDraw(
            frame, Quarters(k, k + 1, 0.75f - 0.25f * static_cast<float>(k)), Color::red, state));
    }
    return pass;
}

TEST_F(Multisampling, ShowsDepthAndStencilOfTheFirstSample)
{
    const TargetPtr depth = MakeSmooth(1, GraphicsFormat::D32_SFloat_S8_UInt);
    const TargetPtr copy = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat, "copy");
    CompiledFrame frame;
    frame.passes = {SlopePass(frame, MakeSmooth(1), depth), ClearPass(copy)};
    frame.passes[0].depth->resolve = depth;
    frame.passes[1].barriers.push_back(
        {depth, TextureUsage::DepthStencilAttachment, TextureUsage::ShaderRead});
    frame.passes[1].commands.emplace_back(MakeCopyDraw(frame, depth));
    frame.finalBarriers = {{copy, TextureUsage::ColorAttachment, TextureUsage::CopySource},
                           {depth, TextureUsage::ShaderRead, TextureUsage::CopySource}};
    SharedDevice().Execute(frame);
    EXPECT_EQ(0.5f, TexelFloat(ReadRows(*copy), 0, 0)[0]);
    EXPECT_EQ(0.5f, TexelFloat<1>(ReadRows(*depth), 0, 0)[0]);
    EXPECT_EQ(std::byte{2}, SharedDevice().ReadBackStencil(*depth).texels.at(0));
}

TEST_F(Multisampling, ResolvesIntoAnotherTexture)
{
    const TargetPtr smooth = MakeSmooth(5);
    const TargetPtr target = MakeTarget(5, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = Staircase(smooth);
    frame.passes[0].colors[0].store = StoreOp::DontCare;
    frame.passes[0].colors[0].resolve = target;
    frame.passes[0].barriers.push_back(
        {target, TextureUsage::Undefined, TextureUsage::ColorAttachment});
    frame.finalBarriers = {{target, TextureUsage::ColorAttachment, TextureUsage::CopySource}};
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int k = 0; k <= 4; ++k)
    {
        EXPECT_EQ(0.25f * static_cast<float>(k), TexelFloat(image, k, 0)[0]);
    }
}

TEST_F(Multisampling, RefusesToResolveIntoAnotherFormat)
{
    const TargetPtr other = MakeTarget(5, 1);
    CompiledFrame frame = Staircase(MakeSmooth(5));
    frame.passes[0].colors[0].resolve = other;
    frame.passes[0].barriers.push_back(
        {other, TextureUsage::Undefined, TextureUsage::ColorAttachment});
    EXPECT_THAT(
        ThrownMessage<ContractError>([&] { SharedDevice().Execute(frame); }),
        Mentions("'test pass'", "'smooth'", "resolved into 'target'", "one sample", "same format"));
}

TEST_F(Multisampling, RefusesToShowDepthThatIsNotResolved)
{
    const TargetPtr depth = MakeSmooth(1, GraphicsFormat::D32_SFloat);
    const TargetPtr target = MakeSmooth(1);
    const TargetPtr copy = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target), ClearPass(copy)}, copy);
    AddDepth(frame.passes[0], depth);
    frame.passes[1].barriers.push_back(
        {depth, TextureUsage::DepthStencilAttachment, TextureUsage::ShaderRead});
    frame.passes[1].commands.emplace_back(MakeCopyDraw(frame, depth));
    EXPECT_THAT(ThrownMessage<ContractError>([&] { SharedDevice().Execute(frame); }),
                Mentions("'smooth'", "read as '_MainTex'", "not resolve", "4 samples"));
}

} // namespace limn::test
