#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

namespace limn::test
{

namespace
{

/// Copies the red of `_MainTex`, point sampled at the texel's place, to all channels.
PassPtr CopyPass()
{
    static const PassPtr pass = CompilePass(R"(
        Texture2D _MainTex;
        SamplerState sampler_PointClamp;
        struct Between { float4 position : SV_POSITION; float2 uv : TEXCOORD0; };
        Between vert(float3 position : POSITION)
        {
            Between output;
            output.position = float4(position, 1);
            output.uv = float2(position.x, -position.y) * 0.5 + 0.5;
            return output;
        }
        float4 frag(Between input) : SV_Target
        {
            return _MainTex.SampleLevel(sampler_PointClamp, input.uv, 0).rrrr;
        })");
    return pass;
}

DrawCommand MakeCopy(FrameTables& frame, const std::shared_ptr<const Texture>& source)
{
    const PropertyLayout& layout = CopyPass()->layout;
    DrawBindings bindings;
    bindings.textures = {{layout.textures.at(0).binding, source, std::nullopt}};
    const SamplerState point = {FilterMode::Point, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                                TextureWrapMode::Clamp, false};
    bindings.samplers = {{layout.samplers.at(0).binding, point}};
    return MakeDraw(frame, CopyPass(), MakeQuad(), PlainState(), bindings);
}

/// A white mask over the top left quarter in one pass, copied to `target` in the next.
CompiledFrame MaskThenCopy(const TargetPtr& mask, const TargetPtr& target)
{
    CompiledFrame frame = FrameOf({ClearPass(mask, Color::black), ClearPass(target)}, target);
    frame.passes[0].name = "mask";
    frame.passes[1].name = "copy";
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, 0, 0, 1), Color::white));
    frame.passes[1].barriers.push_back(
        {mask, TextureUsage::ColorAttachment, TextureUsage::ShaderRead});
    frame.passes[1].commands.emplace_back(MakeCopy(frame, mask));
    return frame;
}

} // namespace

using Frames = GpuTest;

TEST_F(Frames, SampleInOnePassWhatTheOneBeforeDrew)
{
    const TargetPtr mask = MakeTarget(4, 4, GraphicsFormat::R8_UNorm, "mask");
    const TargetPtr target = MakeTarget(8, 8);
    SharedDevice().Execute(MaskThenCopy(mask, target));
    const Image image = ReadRows(*target);
    for (int y = 0; y < 8; ++y)
    {
        for (int x = 0; x < 8; ++x)
        {
            EXPECT_EQ(x < 4 && y < 4 ? 255 : 0, Texel8(image, x, y)[0]) << x << ", " << y;
        }
    }
}

TEST_F(Frames, SampleDepth)
{
    const TargetPtr color = MakeTarget(2, 2);
    const TargetPtr depth = MakeDepth(2, 2, true);
    const TargetPtr target = MakeTarget(2, 2, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(color), ClearPass(target)}, target);
    AddDepth(frame.passes[0], depth);
    PipelineState state;
    state.cull = CullMode::Off;
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(-1, 0, 1, 1, 0.625f), Color::white, state));
    frame.passes[1].barriers.push_back(
        {depth, TextureUsage::DepthStencilAttachment, TextureUsage::ShaderRead});
    frame.passes[1].commands.emplace_back(MakeCopy(frame, depth));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    EXPECT_FLOAT_EQ(0.625f, TexelFloat(image, 0, 0)[0]);
    EXPECT_EQ(0.0f, TexelFloat(image, 0, 1)[0]);
}

TEST_F(Frames, DrawIntoASingleTexel)
{
    const TargetPtr mask = MakeTarget(1, 1, GraphicsFormat::R8_UNorm, "mask");
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = MaskThenCopy(mask, target);
    frame.passes[0].commands.clear();
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), Color::white));
    SharedDevice().Execute(frame);
    EXPECT_EQ((Rgba8{255, 255, 255, 255}), Texel8(ReadRows(*target), 0, 0));
}

TEST_F(Frames, KeepContentsForTheNextFrame)
{
    const TargetPtr target = MakeTarget(2, 1);
    SharedDevice().Execute(FrameOf({ClearPass(target, Color::green)}, target));
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].barriers[0].before = TextureUsage::CopySource;
    frame.passes[0].colors[0].load = LoadOp::Load;
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(0, -1, 1, 1), Color::red));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    EXPECT_EQ((Rgba8{0, 255, 0, 255}), Texel8(image, 0, 0));
    EXPECT_EQ((Rgba8{255, 0, 0, 255}), Texel8(image, 1, 0));
}

TEST_F(Frames, OutliveWhatTheyDrawWith)
{
    const TargetPtr target = MakeTarget(1, 1);
    {
        const auto texture = std::make_shared<Texture2D>(
            "short-lived", 1, 1, GraphicsFormat::R8_UNorm, std::vector<std::byte>{std::byte{255}});
        CompiledFrame frame = FrameOf({ClearPass(target)}, target);
        frame.passes[0].commands.emplace_back(MakeCopy(frame, texture));
        SharedDevice().Execute(frame);
    } // texture, mesh and bindings go while the GPU may still draw
    EXPECT_EQ(255, Texel8(ReadRows(*target), 0, 0)[0]);
}

TEST_F(Frames, KeepTheirUniformsWhileInFlight)
{
    const PassPtr slow = CompilePass(R"(
        cbuffer Material { float4 _Color; };
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag(float4 position : SV_POSITION) : SV_Target
        {
            float sum = position.x;
            for (int i = 0; i < 1000; ++i)
            {
                sum = sin(sum) + 1;
            }
            return sum < -100 ? 0 : _Color;
        })");
    std::vector<TargetPtr> targets;
    for (int i = 0; i < 6; ++i) // more than can be in flight: memory is used again
    {
        targets.push_back(MakeTarget(128, 128, GraphicsFormat::R32G32B32A32_SFloat));
        CompiledFrame frame = FrameOf({ClearPass(targets.back())}, targets.back());
        DrawBindings bindings;
        bindings.uniforms = {AddUniform(frame, slow->layout.buffers.at(0).binding,
                                        glm::vec4(static_cast<float>(i)))};
        frame.passes[0].commands.emplace_back(
            MakeDraw(frame, slow, MakeQuad(), PlainState(), bindings));
        SharedDevice().Execute(frame);
    }
    for (int i = 0; i < 6; ++i)
    {
        const Image image = ReadRows(*targets[static_cast<std::size_t>(i)]);
        EXPECT_EQ(static_cast<float>(i), TexelFloat(image, 127, 127)[0]);
    }
}

TEST_F(Frames, KeepThePipelinesOfAPassThatIsCompiledAnew)
{
    ShaderCompiler compiler;
    const TargetPtr output = MakeTarget(1, 1);
    const auto draw = [&]
    {
        const PassPtr pass = CompilePass(R"(
            float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
            float4 frag() : SV_Target { return 0.25; })",
                                         compiler);
        CompiledFrame frame = FrameOf({ClearPass(output)}, output);
        frame.passes[0].commands.emplace_back(MakeDraw(frame, pass, MakeQuad()));
        SharedDevice().Execute(frame);
        return pass.get();
    };
    const ShaderProgram* first = draw();
    const VulkanDeviceStatistics before = SharedDevice().statistics();
    EXPECT_EQ(draw(), first);
    EXPECT_EQ(SharedDevice().statistics().pipelines, before.pipelines);
}

TEST_F(Frames, FreeWhatNobodyOwns)
{
    constexpr int k_Idle = 12; // an empty block of memory is kept for a few frames
    const TargetPtr output = MakeTarget(1, 1);
    const CompiledFrame idle = FrameOf({ClearPass(output)}, output);
    for (int i = 0; i < k_Idle; ++i)
    {
        SharedDevice().Execute(idle);
    }
    const VulkanDeviceStatistics before = SharedDevice().statistics();
    {
        const PassPtr pass = CompilePass(R"(
            float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
            float4 frag() : SV_Target { return 0.5; })");
        const TargetPtr large = MakeTarget(1024, 1024, GraphicsFormat::R32G32B32A32_SFloat);
        CompiledFrame frame = FrameOf({ClearPass(large)}, large);
        frame.passes[0].commands.emplace_back(MakeDraw(frame, pass, MakeQuad()));
        SharedDevice().Execute(frame);
    }
    const VulkanDeviceStatistics during = SharedDevice().statistics();
    EXPECT_EQ(before.images + 1, during.images);
    EXPECT_EQ(before.meshes + 1, during.meshes);
    EXPECT_EQ(before.pipelines + 1, during.pipelines);
    EXPECT_GE(during.usedBytes, before.usedBytes + 1024u * 1024u * 16u);
    for (int i = 0; i < k_Idle; ++i)
    {
        SharedDevice().Execute(idle);
    }
    const VulkanDeviceStatistics after = SharedDevice().statistics();
    EXPECT_EQ(before.images, after.images);
    EXPECT_EQ(before.meshes, after.meshes);
    EXPECT_EQ(before.pipelines, after.pipelines);
    EXPECT_EQ(before.usedBytes, after.usedBytes);
    EXPECT_EQ(before.allocatedBytes, after.allocatedBytes);
}

TEST_F(Frames, WriteNoDescriptorsThatDidNotChange)
{
    const TargetPtr mask = MakeTarget(4, 4, GraphicsFormat::R8_UNorm, "mask");
    const TargetPtr target = MakeTarget(8, 8);
    const CompiledFrame frame = MaskThenCopy(mask, target);
    SharedDevice().Execute(frame);
    ReadRows(*target); // what other tests drew is done, and what they made goes in the next frame
    SharedDevice().Execute(frame);
    SharedDevice().Execute(frame); // one for each of the frames in flight
    const VulkanDeviceStatistics before = SharedDevice().statistics();
    for (int i = 0; i < 10; ++i)
    {
        SharedDevice().Execute(frame);
    }
    EXPECT_EQ(before.descriptorWrites, SharedDevice().statistics().descriptorWrites);
    const auto other = MakeTarget(4, 4, GraphicsFormat::R8_UNorm, "other");
    SharedDevice().Execute(MaskThenCopy(other, target));
    EXPECT_EQ(before.descriptorWrites + 1, SharedDevice().statistics().descriptorWrites);
}

// What is made anew may get the handles of what has gone.
TEST_F(Frames, ReadTexturesThatTakeThePlaceOfOthers)
{
    const TargetPtr target = MakeTarget(8, 8);
    for (int i = 0; i < 40; ++i)
    {
        const std::vector<std::byte> texel(4, std::byte(6 * i));
        const auto texture =
            std::make_shared<Texture2D>("texture", 1, 1, GraphicsFormat::R8G8B8A8_UNorm, texel);
        CompiledFrame frame = FrameOf({ClearPass(target)}, target);
        frame.passes[0].commands.emplace_back(MakeCopy(frame, texture));
        SharedDevice().Execute(frame);
        EXPECT_EQ(6 * i, Texel8(ReadRows(*target), 0, 0)[0]);
    }
}

TEST_F(Frames, DoNotGrowInMemory)
{
    const auto draw = []
    {
        const TargetPtr mask = MakeTarget(8, 8, GraphicsFormat::R8_UNorm, "mask");
        const TargetPtr target = MakeTarget(8, 8);
        SharedDevice().Execute(MaskThenCopy(mask, target));
        return target;
    };
    // Of the frames in flight it is one that has anything, however fast the device is.
    const auto measure = [&]
    {
        ReadRows(*draw());
        draw();
        return SharedDevice().statistics();
    };
    for (int i = 0; i < 10; ++i)
    {
        draw();
    }
    const VulkanDeviceStatistics early = measure();
    for (int i = 0; i < 300; ++i)
    {
        draw();
    }
    const VulkanDeviceStatistics late = measure();
    EXPECT_EQ(early.usedBytes, late.usedBytes);
    EXPECT_EQ(early.allocatedBytes, late.allocatedBytes);
    EXPECT_EQ(early.images, late.images);
    EXPECT_EQ(early.meshes, late.meshes);
    EXPECT_EQ(early.pipelines, late.pipelines);
}

TEST_F(Frames, UploadMoreThanAChunkOfUniforms)
{
    const TargetPtr target = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.uniformData.resize(5u << 20);
    frame.passes[0].commands.emplace_back(
        MakeColorDraw(frame, MakeQuad(), {1.0f, 2.0f, 3.0f, 4.0f}));
    SharedDevice().Execute(frame);
    EXPECT_EQ((std::array<float, 4>{1, 2, 3, 4}), TexelFloat(ReadRows(*target), 0, 0));
}

TEST_F(Frames, BindManySetsInOneFrame)
{
    const TargetPtr target = MakeTarget(64, 32, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    const MeshPtr quad = MakeQuad();
    for (int i = 0; i < 2048; ++i) // four pools of descriptor sets
    {
        frame.passes[0].commands.emplace_back(SetViewportCommand{{i % 64, i / 64, 1, 1}});
        frame.passes[0].commands.emplace_back(
            MakeColorDraw(frame, quad, {static_cast<float>(i), 0.0f, 0.0f, 1.0f}));
    }
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int i = 0; i < 2048; ++i)
    {
        ASSERT_EQ(static_cast<float>(i), TexelFloat(image, i % 64, i / 64)[0]);
    }
}

TEST_F(Frames, TimeEachPassByName)
{
    const TargetPtr mask = MakeTarget(4, 4, GraphicsFormat::R8_UNorm, "mask");
    const TargetPtr target = MakeTarget(4, 4);
    SharedDevice().Execute(MaskThenCopy(mask, target));
    ReadRows(*target);
    const std::vector<PassTiming> timings = SharedDevice().LastFrameTimings();
    ASSERT_EQ(2u, timings.size());
    EXPECT_EQ("mask", timings[0].name);
    EXPECT_EQ("copy", timings[1].name);
    EXPECT_GE(timings[0].milliseconds, 0.0);
    EXPECT_LT(timings[1].milliseconds, 10000.0);
}

TEST_F(Frames, NestSamplesThatGoOnIntoTheNextPass)
{
    const TargetPtr mask = MakeTarget(4, 4, GraphicsFormat::R8_UNorm, "mask");
    const TargetPtr target = MakeTarget(4, 4);
    CompiledFrame frame = MaskThenCopy(mask, target);
    auto& first = frame.passes[0].commands;
    first.insert(first.begin(), BeginSampleCommand{SampleName("outline")});
    frame.passes[1].commands.emplace_back(EndSampleCommand{});
    SharedDevice().Execute(frame);
    EXPECT_EQ(255, Texel8(ReadRows(*target), 0, 0)[0]);
}

} // namespace limn::test
