#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <limn/core/CoreUtils.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/ScriptableRenderContext.h>

#include <algorithm>
#include <random>

namespace limn::test
{

namespace
{

constexpr unsigned k_FrameSeed = 20'261'122;

/// Passes of the kinds that a frame compiler has to tell apart.
constexpr const char* k_FrameShader = R"(
Shader "Test/Frame"
{
    HLSLINCLUDE
    #pragma vertex V
    #pragma fragment F
    Texture2D _BlitTexture;
    float4 _Tint;
    float4 Fetch(float4 p) { return _BlitTexture.Load(int3(p.xy, 0)); }
    ENDHLSL
    SubShader
    {
        Cull Off ZWrite Off ZTest Always
        Pass // 0: a mesh, tested against depth
        {
            ZTest LEqual ZWrite On
            HLSLPROGRAM
            float4 V(float4 p : POSITION) : SV_POSITION { return float4(p.xy * _Tint.w * 2, p.z + 0.5, 1); }
            float4 F() : SV_Target { return _Tint; }
            ENDHLSL
        }
        Pass // 1: a mesh in two colours
        {
            ZTest LEqual
            HLSLPROGRAM
            struct Colors { float4 first : SV_Target0; float4 second : SV_Target1; };
            float4 V(float4 p : POSITION) : SV_POSITION { return float4(p.yx * 1.5, p.z + 0.5, 1); }
            Colors F()
            {
                Colors colors;
                colors.first = _Tint.gbra;
                colors.second = _Tint.brga;
                return colors;
            }
            ENDHLSL
        }
        Pass // 2: a mesh that adds what a texture holds
        {
            Blend One One
            HLSLPROGRAM
            float4 V(float4 p : POSITION) : SV_POSITION { return float4(p.xy, 0.5, 1); }
            float4 F(float4 p : SV_POSITION) : SV_Target { return Fetch(p) * 0.5 + _Tint * 0.25; }
            ENDHLSL
        }
        HLSLINCLUDE
        float4 V(uint id : SV_VertexID) : SV_POSITION
        {
            return float4(id == 1 ? 3 : -1, id == 2 ? 3 : -1, 0.5, 1);
        }
        ENDHLSL
        Pass // 3: mixed, promises to cover only
        {
            Tags { "LimnFullScreen" = "True" }
            HLSLPROGRAM
            float4 F(float4 p : SV_POSITION) : SV_Target { return Fetch(p) * 0.5 + _Tint * 0.5; }
            ENDHLSL
        }
        Pass // 4: nothing of nothing
        {
            Tags { "LimnFullScreen" = "0 0 0 0 where _BlitTexture is 0" }
            HLSLPROGRAM
            float4 F(float4 p : SV_POSITION) : SV_Target { return Fetch(p).grba; }
            ENDHLSL
        }
        Pass // 5: added, nothing of nothing
        {
            Tags { "LimnFullScreen" = "0 0 0 1 where _BlitTexture is 0" }
            Blend One SrcAlpha, Zero One
            HLSLPROGRAM
            float4 F(float4 p : SV_POSITION) : SV_Target { return float4(Fetch(p).rgb * _Tint.rgb, 1); }
            ENDHLSL
        }
        Pass // 6: a copy
        {
            Tags { "LimnFullScreen" = "_BlitTexture with alpha 1" }
            HLSLPROGRAM
            float4 F(float4 p : SV_POSITION) : SV_Target { return float4(Fetch(p).rgb, 1); }
            ENDHLSL
        }
    }
}
)";
constexpr int k_MeshPasses = 3;
constexpr int k_CopyPass = 6;
constexpr int k_FramePasses = 7;

/// The same frames for the same seed, on textures of its own.
class RandomDeviceFrames
{
public:
    RandomDeviceFrames(unsigned seed, bool leavesOut)
        : m_Random(seed), m_Options{.held = {}, .leavesOut = leavesOut}
    {
        if (leavesOut)
        {
            m_Options.footprint = [](const RenderTexture& texture)
            {
                return SharedDevice().Footprint(texture);
            };
        }
        for (int i = 0; i < 8; ++i)
        {
            RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8G8B8A8_UNorm);
            descriptor.msaaSamples = i < 6 ? 1 : 4;
            m_Colors.emplace_back(std::make_shared<RenderTexture>(
                "color" + std::to_string(i), descriptor, SamplerState{}, i % 2 == 1));
        }
    }

    /// Draws a frame; the texels of its outputs.
    std::vector<std::vector<std::byte>> Draw()
    {
        Record();
        return Repeat();
    }

    /// Records a frame.
    void Record()
    {
        std::erase_if(m_Known, [](const RTHandle& handle) { return handle.rt()->isTransient(); });
        CommandBuffer cmd;
        const int nodes = Pick(3, 8);
        for (int i = 0; i < nodes; ++i)
        {
            RecordNode(cmd);
        }
        m_Outputs.clear();
        for (const RTHandle& handle : m_Known)
        {
            if (!IsDepthFormat(handle.rt()->graphicsFormat()) &&
                (Pick(0, 1) == 0 || m_Outputs.empty()))
            {
                m_Outputs.push_back(handle.rt());
            }
        }
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        m_Commands = context.TakeCommands();
        m_Compiled.clear();
    }

    /// Draws what is recorded with other numbers; the texels of its outputs.
    std::vector<std::vector<std::byte>> RepeatWithOtherTints()
    {
        for (std::size_t i = 0; i < m_Commands.uniformData.size(); i += sizeof(float))
        {
            const float part = Part();
            std::memcpy(m_Commands.uniformData.data() + i, &part, sizeof(part));
        }
        return Repeat();
    }

    /// Draws what is recorded.
    std::vector<std::vector<std::byte>> Repeat()
    {
        CompiledFrame frame =
            CompileFrame(m_Commands, SharedDevice().textureStates(), m_Outputs, m_Options);
        frame.structure = isRecordedOnce ? StructureOf(frame) : 0;
        leftOut += frame.leftOut.size();
        originals += static_cast<std::size_t>(
            std::ranges::count_if(frame.leftOut, [](const LeftOut& item)
                                  { return item.reason.starts_with("passes that read"); }));
        placed += frame.placed.size();
        EXPECT_TRUE(frame.notes.empty()) << frame.notes.front();
        SharedDevice().Execute(frame);
        std::vector<std::vector<std::byte>> texels;
        m_Compiled.push_back(frame);
        for (const TargetPtr& output : m_Outputs)
        {
            texels.push_back(ReadRows(*output).texels);
        }
        return texels;
    }

    std::size_t leftOut = 0;
    std::size_t originals = 0;   ///< copies of depth that went
    std::size_t placed = 0;      ///< textures in shared memory
    bool isRecordedOnce = false; ///< frames say of what structure they are

private:
    /// Of frames made of the same commands.
    static bool isSame(const CompiledFrame& a, const CompiledFrame& b)
    {
        return a.placed == b.placed && a.finalBarriers == b.finalBarriers &&
               std::ranges::equal(a.passes, b.passes,
                                  [](const CompiledRenderPass& x, const CompiledRenderPass& y)
                                  {
                                      return x.place == y.place && x.barriers == y.barriers &&
                                             x.colors == y.colors && x.depth == y.depth &&
                                             x.commands.size() == y.commands.size();
                                  });
    }

    std::uint64_t StructureOf(const CompiledFrame& frame) const
    {
        static std::uint64_t last = 0;
        const auto found = std::ranges::find_if(m_Compiled, [&](const CompiledFrame& other)
                                                { return isSame(frame, other); });
        return found != m_Compiled.end() ? found->structure : ++last;
    }

    int Pick(int least, int most) { return std::uniform_int_distribution(least, most)(m_Random); }
    float Part() { return static_cast<float>(Pick(0, 4)) / 4.0f; }

    bool IsKnown(const RTHandle& handle) const
    {
        return std::find(m_Known.begin(), m_Known.end(), handle) != m_Known.end();
    }

    void Know(const RTHandle& handle)
    {
        if (!IsKnown(handle))
        {
            m_Known.push_back(handle);
        }
    }

    /// As cameras copy theirs for those who read it.
    void RecordDepthCopy(CommandBuffer& cmd, const RTHandle& depth)
    {
        const auto material = std::make_shared<Material>(FrameShader());
        cmd.SetRenderTarget(m_CopiedDepth);
        Blitter::BlitTexture(cmd, depth, glm::vec4(1, 1, 0, 0), material, k_CopyPass);
        Know(m_CopiedDepth);
    }

    void RecordNode(CommandBuffer& cmd)
    {
        const RTHandle& copied = Pick(0, 2) == 0 ? m_SmoothDepth : m_Depth;
        if (IsKnown(copied) && Pick(0, 3) == 0)
        {
            RecordDepthCopy(cmd, copied);
            return;
        }
        const RTHandle color = m_Colors.at(static_cast<std::size_t>(Pick(0, 7)));
        const RTHandle second = m_Colors.at(static_cast<std::size_t>(Pick(0, 7)));
        RTHandle source = m_Colors.at(static_cast<std::size_t>(Pick(0, 7)));
        if (IsKnown(m_CopiedDepth) && Pick(0, 1) == 0)
        {
            source = m_CopiedDepth;
        }
        const int samples = color.rt()->descriptor().msaaSamples;
        std::vector<RTHandle> colors{color};
        if (second != color && second.rt()->descriptor().msaaSamples == samples && Pick(0, 2) == 0)
        {
            colors.push_back(second);
        }
        const bool canFetch = IsKnown(source) && source != color && source != colors.back();
        const RTHandle depth = Pick(0, 2) != 0 ? RTHandle() : samples > 1 ? m_SmoothDepth : m_Depth;
        cmd.SetRenderTarget(colors, depth);
        const bool clears = !IsKnown(color) || !IsKnown(colors.back()) || Pick(0, 3) == 0;
        const bool clearsDepth = depth && (!IsKnown(depth) || Pick(0, 3) == 0);
        const float level = Pick(0, 1) == 0 ? 0.0f : Part();
        cmd.ClearRenderTarget((clears ? ClearFlag::Color : ClearFlag::None) |
                                  (clearsDepth ? ClearFlag::Depth : ClearFlag::None),
                              {level, level, level, level}, Part());
        std::for_each(colors.begin(), colors.end(), [this](const RTHandle& c) { Know(c); });
        if (depth)
        {
            Know(depth);
        }
        const int draws = Pick(0, 2);
        for (int i = 0; i < draws; ++i)
        {
            RecordDraw(cmd, canFetch ? source : RTHandle());
        }
    }

    void RecordDraw(CommandBuffer& cmd, const RTHandle& source)
    {
        const int pass = Pick(0, source ? k_FramePasses - 1 : 1);
        const auto material = std::make_shared<Material>(FrameShader());
        material->SetVector(ShaderPropertyId("_Tint"), {Part(), Part(), Part(), Part()});
        if (source)
        {
            material->SetTexture(ShaderPropertyId("_BlitTexture"), source.rt());
        }
        if (pass < k_MeshPasses)
        {
            cmd.DrawMesh(MakeQuad(-0.5f, -0.5f, 0.5f, 0.5f, Part() * 0.5f), glm::mat4(1.0f),
                         material, 0, pass);
        }
        else
        {
            Blitter::BlitTexture(cmd, source, glm::vec4(1, 1, 0, 0), material, pass);
        }
    }

    static RTHandle MakeDepth(int samples)
    {
        RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::None, 32);
        descriptor.msaaSamples = samples;
        return RTHandle(std::make_shared<RenderTexture>("depth", descriptor, SamplerState{}, true));
    }

    static std::shared_ptr<const Shader> FrameShader()
    {
        static const auto shader =
            Shader::FromText(k_FrameShader, "frame.shader", std::make_shared<ShaderCompiler>());
        return shader;
    }

    std::mt19937 m_Random;
    FrameCompilerOptions m_Options;
    std::vector<RTHandle> m_Colors;
    RTHandle m_Depth = MakeDepth(1);
    RTHandle m_SmoothDepth = MakeDepth(4);
    RTHandle m_CopiedDepth{std::make_shared<RenderTexture>(
        "copied depth", RenderTextureDescriptor(4, 4, GraphicsFormat::R32_SFloat), SamplerState{},
        true)};
    std::vector<RTHandle> m_Known;
    FrameCommands m_Commands; ///< of the last frame recorded
    std::vector<TargetPtr> m_Outputs;
    std::vector<CompiledFrame> m_Compiled; ///< of `m_Commands`
};

} // namespace

TEST(RandomFrameOnDevice, GivesTheSameTexelsWithAndWithoutWhatCanBeLeftOut)
{
    std::size_t leftOut = 0;
    std::size_t placed = 0;
    std::size_t originals = 0;
    int frames = 0;
    for (unsigned seed = k_FrameSeed; seed < k_FrameSeed + 200; ++seed)
    {
        RandomDeviceFrames all(seed, false);
        RandomDeviceFrames lean(seed, true);
        for (int i = 0; i < 4; ++i)
        {
            const auto expected = all.Draw();
            const auto texels = lean.Draw();
            ASSERT_EQ(expected, texels) << "seed " << seed << ", frame " << i;
            ++frames;
        }
        leftOut += lean.leftOut;
        placed += lean.placed;
        originals += lean.originals;
    }
    EXPECT_EQ(frames, 800);
    EXPECT_GT(originals, 20u);
    RecordProperty("originals", static_cast<int>(originals));
    EXPECT_GT(leftOut, 100u);
    EXPECT_GT(placed, 50u);
    EXPECT_TRUE(Environment().NewMessages().empty()) << "validation is silent";
}

TEST(RandomFrameOnDevice, GivesTheSameTexelsWhenItIsRecordedOnce)
{
    const std::uint64_t before = SharedDevice().statistics().recordedFrames;
    std::uint64_t frames = 0;
    for (unsigned seed = k_FrameSeed; seed < k_FrameSeed + 30; ++seed)
    {
        RandomDeviceFrames all(seed, false);
        RandomDeviceFrames lean(seed, true);
        lean.isRecordedOnce = true;
        for (int i = 0; i < 2; ++i)
        {
            all.Record();
            lean.Record();
            for (int j = 0; j < 12; ++j)
            {
                const auto expected = all.RepeatWithOtherTints();
                const auto texels = lean.RepeatWithOtherTints();
                ASSERT_EQ(expected, texels) << "seed " << seed << ", frame " << i << ", " << j;
                frames += 2;
            }
        }
    }
    EXPECT_LT(SharedDevice().statistics().recordedFrames - before, frames)
        << "not all was recorded";
    EXPECT_TRUE(Environment().NewMessages().empty()) << "validation is silent";
}

} // namespace limn::test
