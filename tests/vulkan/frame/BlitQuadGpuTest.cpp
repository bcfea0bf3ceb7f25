#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <cmath>
#include <functional>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

const std::shared_ptr<ShaderCompiler>& QuadCompiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>();
    return compiler;
}

/// Blitter's quads, and its colour with depth.
class BlitQuadGpu : public GpuTest
{
protected:
    BlitQuadGpu()
    {
        std::vector<std::byte> bytes;
        for (int i = 0; i < 8 * 4; ++i)
        {
            for (const int value :
                 {Value(i % 8, i / 8), 255 - Value(i % 8, i / 8), i % 2 * 255, 255})
            {
                bytes.push_back(static_cast<std::byte>(value));
            }
        }
        m_Source = std::make_shared<const Texture2D>("source", 8, 4, GraphicsFormat::R8G8B8A8_UNorm,
                                                     std::move(bytes), SamplerState(), true);
    }
    static int Value(int x, int y) { return (x * 31 + y * 67) % 256; }

    void Execute(const TargetPtr& output)
    {
        RenderReport report;
        ScriptableRenderContext context(report);
        context.BeginCamera({RTHandle(output), {}, &m_Pool, m_Copy});
        context.ExecuteCommandBuffer(m_Cmd);
        m_Cmd.Clear();
        SharedDevice().Execute(CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                                            std::span(&output, 1)));
        ExpectNoValidationMessages();
    }
    /// Makes a material that copies `_Source` by HLSL that follows the includes of URP.
    std::shared_ptr<Material> CopyWith(const std::string& vertex, const std::string& hlsl) const
    {
        const std::string universal = "#include \"Packages/com.unity.render-pipelines.universal/";
        auto material = std::make_shared<Material>(Shader::FromText(
            "Shader \"Test/Copy\" { SubShader { Pass { Cull Off ZTest Always ZWrite Off\n"
            "HLSLPROGRAM\n#pragma multi_compile _ _USE_DRAW_PROCEDURAL\n#pragma vertex " +
                vertex + "\n#pragma fragment frag\n" + universal + "ShaderLibrary/Core.hlsl\"\n" +
                universal + "Shaders/PostProcessing/Common.hlsl\"\n" +
                "TEXTURE2D(_Source); SAMPLER(sampler_PointClamp);\n" + hlsl + "\nENDHLSL } } }",
            "copy.shader", QuadCompiler()));
        material->SetTexture("_Source", m_Source);
        return material;
    }
    /// Expects that a draw fills a target with m_Source.
    void ExpectCopy(const std::function<void()>& draw)
    {
        const TargetPtr target = MakeTarget(8, 4);
        m_Cmd.SetRenderTarget(RTHandle(target));
        m_Cmd.ClearRenderTarget(ClearFlag::Color, Color::clear);
        draw();
        Execute(target);
        const Image image = ReadRows(*target);
        for (int i = 0; i < 32; ++i)
        {
            EXPECT_EQ(Texel8(image, i % 8, i / 8)[0], Value(i % 8, i / 8)) << i;
        }
    }
    /// Red at a place of level 0 in texels, each texel at its middle, clamped.
    static double Bilinear(double x, double y)
    {
        const auto at = [](double u, double v)
        {
            return Value(static_cast<int>(std::clamp(u, 0.0, 7.0)),
                         static_cast<int>(std::clamp(v, 0.0, 3.0)));
        };
        const double left = std::floor(x - 0.5);
        const double top = std::floor(y - 0.5);
        const double u = x - 0.5 - left;
        const double v = y - 0.5 - top;
        return (at(left, top) * (1 - u) + at(left + 1, top) * u) * (1 - v) +
               (at(left, top + 1) * (1 - u) + at(left + 1, top + 1) * u) * v;
    }

    CommandBuffer m_Cmd;
    RenderTexturePool m_Pool;
    std::shared_ptr<const Texture> m_Source;
    const std::shared_ptr<const Material> m_Copy = CoreUtils::CreateEngineMaterial(
        FindBuiltinShader("Hidden/Universal/CoreBlit", QuadCompiler()));
};

} // namespace

// scaleBiasRT is a share of the target from its top left, as core's VertQuad has it.
TEST_F(BlitQuadGpu, CoversItsPartOfTheTarget)
{
    const TargetPtr target = MakeTarget(16, 8);
    m_Cmd.SetRenderTarget(RTHandle(target));
    m_Cmd.ClearRenderTarget(ClearFlag::Color, Color::clear);
    Blitter::BlitQuad(m_Cmd, m_Source, {1, 1, 0, 0}, {0.5f, 0.5f, 0.25f, 0.125f}, 0, false);
    Execute(target);
    const Image image = ReadRows(*target);
    for (int y = 0; y < 8; ++y)
    {
        for (int x = 0; x < 16; ++x)
        {
            const bool isIn = x >= 4 && x < 12 && y >= 1 && y < 5;
            EXPECT_EQ(Texel8(image, x, y)[0], isIn ? Value(x - 4, y - 1) : 0) << x << ", " << y;
            EXPECT_EQ(Texel8(image, x, y)[3], isIn ? 255 : 0) << x << ", " << y;
        }
    }
}

TEST_F(BlitQuadGpu, TakesItsPartOfTheTextureAndOfItsLevels)
{
    const TargetPtr target = MakeTarget(16, 8, GraphicsFormat::R32G32B32A32_SFloat);
    m_Cmd.SetRenderTarget(RTHandle(target));
    // The right half of the texture, mirrored: u goes from 1 down to 0.5.
    Blitter::BlitQuad(m_Cmd, m_Source, {-0.5f, 1, 1, 0}, {1, 1, 0, 0}, 0, true);
    Execute(target);
    Image image = ReadRows(*target);
    for (int y = 0; y < 8; ++y)
    {
        for (int x = 0; x < 16; ++x)
        {
            const double expected = Bilinear(8.0 - (x + 0.5) / 4.0, (y + 0.5) / 2.0);
            // Vulkan lets filters place texels to 1/256, of differences up to 255 each way.
            EXPECT_NEAR(TexelFloat(image, x, y)[0] * 255.0, expected, 2.0) << x << ", " << y;
        }
    }
    m_Cmd.SetRenderTarget(RTHandle(target));
    Blitter::BlitQuad(m_Cmd, m_Source, {1, 1, 0, 0}, {1, 1, 0, 0}, 2, false);
    Execute(target);
    image = ReadRows(*target);
    double mean = 0.0;
    for (int i = 0; i < 16; ++i)
    {
        mean += Value(i % 4, i / 4) / 16.0;
    }
    EXPECT_NEAR(TexelFloat(image, 0, 0)[0] * 255.0, mean,
                1.2); // two levels, each rounded by 0.6 of a step at most
}

TEST_F(BlitQuadGpu, WritesColourWithDepthOrAlone)
{
    const TargetPtr color = MakeTarget(8, 4);
    const TargetPtr depth = MakeDepth(8, 4);
    const TargetPtr source = MakeDepth(8, 4);
    // A depth that differs from row to row.
    for (int y = 0; y < 4; ++y)
    {
        m_Cmd.SetRenderTarget(RTHandle(), RTHandle(source));
        m_Cmd.SetViewport({0, y, 8, 1});
        m_Cmd.ClearRenderTarget(ClearFlag::Depth, Color::clear, 0.25f * static_cast<float>(y));
    }
    for (const bool blitsDepth : {true, false})
    {
        m_Cmd.SetRenderTarget(RTHandle(color), RTHandle(depth));
        m_Cmd.ClearRenderTarget(ClearFlag::All, Color::clear, 0.125f);
        Blitter::BlitColorAndDepth(m_Cmd, m_Source, blitsDepth ? source : nullptr, {1, 1, 0, 0},
                                   0.0f, blitsDepth);
        Execute(depth);
        const Image depths = ReadRows(*depth);
        for (int y = 0; y < 4; ++y)
        {
            // ReadBack has 1 at the near plane, a clear at the far one.
            const float cleared = blitsDepth ? 0.25f * static_cast<float>(y) : 0.125f;
            EXPECT_FLOAT_EQ(TexelFloat<1>(depths, 3, y)[0], 1.0f - cleared) << y;
        }
        m_Cmd.SetRenderTarget(RTHandle(color), RTHandle(depth));
        Blitter::BlitColorAndDepth(m_Cmd, m_Source, source, {1, 1, 0, 0}, 0.0f, blitsDepth);
        Execute(color);
        const Image image = ReadRows(*color);
        for (int i = 0; i < 32; ++i)
        {
            EXPECT_EQ(Texel8(image, i % 8, i / 8)[0], Value(i % 8, i / 8));
        }
    }
    EXPECT_THROW(Blitter::BlitColorAndDepth(m_Cmd, m_Source, color, {1, 1, 0, 0}, 0.0f, true),
                 ContractError);
}

// Passes of URP 7 to 13 have FullscreenVert from PostProcessing/Common.hlsl, and `uv`.
TEST_F(BlitQuadGpu, FullscreenVertCopiesByMeshAndByVertexNumber)
{
    const auto material =
        CopyWith("FullscreenVert", "half4 frag(Varyings input) : SV_Target { return "
                                   "SAMPLE_TEXTURE2D(_Source, sampler_PointClamp, input.uv); }");
    const glm::mat4 identity(1.0f);
    ExpectCopy(
        [&]
        {
            m_Cmd.Blit(BuiltinRenderTextureType::None, BuiltinRenderTextureType::CurrentActive,
                       material, 0);
        });
    ExpectCopy(
        [&]
        {
            m_Cmd.SetViewProjectionMatrices(glm::dmat4(1.0), glm::dmat4(1.0));
            m_Cmd.DrawMesh(RenderingUtils::fullscreenMesh(), identity, material);
        });
    material->EnableKeyword("_USE_DRAW_PROCEDURAL");
    m_Cmd.SetGlobalVector("_ScaleBias", {1, 1, 0, 0});
    ExpectCopy([&] { m_Cmd.DrawProcedural(identity, material, 0, MeshTopology::Quads, 4); });
}

TEST_F(BlitQuadGpu, QuadsOfAShadersOwnAreNotMirrored)
{
    const auto material = CopyWith(
        "vert", "struct Interpolated { float4 position : SV_POSITION; float2 uv : TEXCOORD0; };\n"
                "Interpolated vert(uint id : SV_VertexID)\n"
                "{ Interpolated o; float4 corner = GetQuadVertexPosition(id);\n"
                "o.position = float4(corner.xy * float2(2, -2) + float2(-1, 1), corner.zw);\n"
                "o.uv = GetQuadTexCoord(id); return o; }\n"
                "half4 frag(Interpolated input) : SV_Target { return "
                "SAMPLE_TEXTURE2D(_Source, sampler_PointClamp, input.uv); }");
    ExpectCopy([&] { m_Cmd.DrawProcedural(glm::mat4(1.0f), material, 0, MeshTopology::Quads, 4); });
}

// VertQuadPadding adds half of the padding on each side: a texture of 4x2 texels with a padding of
// 2 fills the middle of a target of 6x4.
TEST_F(BlitQuadGpu, PaddingSurroundsTheTexture)
{
    const auto material = CopyWith("VertQuadPadding", "half4 frag(Varyings input) : SV_Target "
                                                      "{ return half4(input.texcoord, 0, 1); }");
    m_Cmd.SetGlobalVector("_BlitScaleBias", {1, 1, 0, 0});
    m_Cmd.SetGlobalVector("_BlitScaleBiasRt", {1, 1, 0, 0});
    m_Cmd.SetGlobalVector("_BlitTextureSize", {4, 2, 0, 0});
    m_Cmd.SetGlobalInteger("_BlitPaddingSize", 2);
    const TargetPtr target = MakeTarget(6, 4, GraphicsFormat::R32G32B32A32_SFloat);
    m_Cmd.SetRenderTarget(RTHandle(target));
    m_Cmd.DrawProcedural(glm::mat4(1.0f), material, 0, MeshTopology::Quads, 4);
    Execute(target);
    const Image image = ReadRows(*target);
    for (int i = 0; i < 24; ++i)
    {
        // The texture's first texel is at (1, 1) of the target.
        EXPECT_NEAR(TexelFloat(image, i % 6, i / 6)[0], (i % 6 - 1 + 0.5) / 4.0, 1e-6) << i;
        EXPECT_NEAR(TexelFloat(image, i % 6, i / 6)[1], (i / 6 - 1 + 0.5) / 2.0, 1e-6) << i;
    }
}

} // namespace limn::test
