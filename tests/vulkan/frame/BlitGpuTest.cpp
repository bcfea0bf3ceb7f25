#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

const std::shared_ptr<ShaderCompiler>& BlitCompiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>();
    return compiler;
}

std::shared_ptr<const Material> BlitMaterial(const std::string& fragment)
{
    // Nothing is switched off: the quad must face the viewer and lie between near and far.
    return std::make_shared<const Material>(Shader::FromText(
        R"(Shader "Test/Blit" { SubShader { Pass {
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            sampler2D _MainTex;
            float4 _MainTex_TexelSize;
            struct v2f { float4 pos : SV_POSITION; float2 uv : TEXCOORD0; float2 at : TEXCOORD1; };
            v2f vert(float4 vertex : POSITION, float2 texcoord : TEXCOORD0)
            {
                v2f o;
                o.pos = UnityObjectToClipPos(vertex);
                o.uv = texcoord;
                o.at = vertex.xy;
                return o;
            }
            float4 frag(v2f i) : SV_Target { return )" +
            fragment + "; }\nENDCG } } }",
        "blit.shader", BlitCompiler()));
}

/// Runs command buffers with an origin of the frame's.
class BlitGpu : public GpuTest
{
protected:
    Image Draw(const RTHandle& output, const glm::dvec3& origin = glm::dvec3(0.0))
    {
        RenderReport report;
        ScriptableRenderContext context(report, origin);
        context.BeginCamera({dest, {}, &pool, copyMaterial});
        context.ExecuteCommandBuffer(cmd);
        cmd.Clear();
        const auto texture = output.rt();
        SharedDevice().Execute(CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                                            std::span(&texture, 1)));
        return ReadRows(*texture);
    }

    CommandBuffer cmd;
    RenderTexturePool pool;
    const std::shared_ptr<const Material> copyMaterial = CoreUtils::CreateEngineMaterial(
        FindBuiltinShader("Hidden/Universal/CoreBlit", BlitCompiler()));
    const RTHandle source{MakeTarget(7, 5)};
    const RTHandle dest{MakeTarget(7, 5)};
    const RTHandle other{MakeTarget(2, 3)};
};

} // namespace

TEST_F(BlitGpu, CopiesTexelForTexelWhereverTheFrameIs)
{
    const auto paint = BlitMaterial("float4(floor(i.pos.xy) * 20.0 / 255.0, 1, 0.4)");
    const auto copy = BlitMaterial("tex2D(_MainTex, i.uv)");
    for (const double distance : {0.0, 1e7})
    {
        cmd.Blit(other, source, paint);
        cmd.Blit(source, dest, copy);
        const Image image = Draw(dest, glm::dvec3(distance, -distance, distance));
        for (int y = 0; y < 5; ++y)
        {
            for (int x = 0; x < 7; ++x)
            {
                EXPECT_EQ(Texel8(image, x, y), (Rgba8{20 * x, 20 * y, 255, 102}))
                    << x << ", " << y << " at " << distance;
            }
        }
    }
    ExpectNoValidationMessages();
}

/// The older way to draw over a target.
TEST_F(BlitGpu, IsTheSameWithTheFullscreenMesh)
{
    cmd.Blit(other, source, BlitMaterial("float4(floor(i.pos.xy) * 20.0 / 255.0, 1, 0.4)"));
    cmd.SetRenderTarget(dest);
    cmd.SetViewProjectionMatrices(glm::dmat4(1.0), glm::dmat4(1.0)); // as C# has it
    cmd.SetGlobalTexture("_MainTex", source);
    cmd.DrawMesh(RenderingUtils::fullscreenMesh(), glm::mat4(1.0f),
                 BlitMaterial("tex2D(_MainTex, i.uv)"));
    const Image image = Draw(dest);
    for (int y = 0; y < 5; ++y)
    {
        for (int x = 0; x < 7; ++x)
        {
            EXPECT_EQ(Texel8(image, x, y), (Rgba8{20 * x, 20 * y, 255, 102})) << x << ", " << y;
        }
    }
    ExpectNoValidationMessages();
}

TEST_F(BlitGpu, GivesVerticesFromZeroBottomLeftToOneTopRight)
{
    cmd.Blit(other, dest, BlitMaterial("float4(i.at, 0, 1)"));
    const Image image = Draw(dest);
    for (int y = 0; y < 5; ++y)
    {
        for (int x = 0; x < 7; ++x)
        {
            EXPECT_NEAR(Texel8(image, x, y)[0], (x + 0.5) / 7.0 * 255.0, 0.51);
            EXPECT_NEAR(Texel8(image, x, y)[1], (y + 0.5) / 5.0 * 255.0, 0.51);
        }
    }
    ExpectNoValidationMessages();
}

TEST_F(BlitGpu, GivesTheTexelSizeOfTheSource)
{
    cmd.Blit(other, dest,
             BlitMaterial("float4(_MainTex_TexelSize.xy, _MainTex_TexelSize.zw / 10)"));
    const Rgba8 texel = Texel8(Draw(dest), 3, 2);
    EXPECT_NEAR(texel[0], 255.0 / 2.0, 0.51);
    EXPECT_NEAR(texel[1], 255.0 / 3.0, 0.51);
    EXPECT_NEAR(texel[2], 255.0 * 0.2, 0.51);
    EXPECT_NEAR(texel[3], 255.0 * 0.3, 0.51);
    ExpectNoValidationMessages();
}

TEST_F(BlitGpu, CopiesAPartOfATextureIntoAPartOfATarget)
{
    const RTHandle wide(MakeTarget(8, 5));
    cmd.Blit(other, wide, BlitMaterial("float4(floor(i.pos.xy) * 20.0 / 255.0, 1, 0.4)"));
    cmd.SetRenderTarget(dest);
    cmd.ClearRenderTarget(ClearFlag::Color, Color::clear);
    cmd.SetViewport({2, 0, 4, 5});
    Blitter::BlitTexture(cmd, wide, {0.5f, 1.0f, 0.5f, 0.0f}, 0, false); // the right half
    const Image image = Draw(dest);
    for (int y = 0; y < 5; ++y)
    {
        for (int x = 0; x < 7; ++x)
        {
            const bool isIn = x >= 2 && x < 6;
            EXPECT_EQ(Texel8(image, x, y),
                      (isIn ? Rgba8{20 * (x - 2 + 4), 20 * y, 255, 102} : Rgba8{}))
                << x << ", " << y;
        }
    }
    ExpectNoValidationMessages();
}

// Texel centre x of 14 lies at (x + 0.5) / 2 of the 7, whose centres lie at k + 0.5.
TEST_F(BlitGpu, ScalesWithoutAMaterialByTheSourcesFilter)
{
    const auto paint = BlitMaterial("float4(floor(i.pos.xy) * 20.0 / 255.0, 1, 0.4)");
    const RTHandle large(MakeTarget(14, 10));
    for (const FilterMode filter : {FilterMode::Point, FilterMode::Bilinear})
    {
        cmd.GetTemporaryRT("_Temp", {7, 5, GraphicsFormat::R8G8B8A8_UNorm}, filter);
        cmd.Blit(other, "_Temp", paint);
        cmd.Blit("_Temp", large);
        cmd.ReleaseTemporaryRT("_Temp");
        const Image image = Draw(large);
        const auto expected = [&](int texel, int last)
        {
            const double place = std::clamp((texel + 0.5) / 2.0 - 0.5, 0.0, double(last));
            return 20.0 * (filter == FilterMode::Point ? texel / 2 : place);
        };
        for (int y = 0; y < 10; ++y)
        {
            for (int x = 0; x < 14; ++x)
            {
                const Rgba8 texel = Texel8(image, x, y);
                EXPECT_NEAR(texel[0], expected(x, 6), 0.6) << x << ", " << y;
                EXPECT_NEAR(texel[1], expected(y, 4), 0.6) << x << ", " << y;
                EXPECT_EQ(texel[2], 255);
                EXPECT_EQ(texel[3], 102);
            }
        }
    }
    ExpectNoValidationMessages();
}

TEST_F(BlitGpu, CopiesTexturesTexelForTexelBesideWhatIsBound)
{
    const auto paint = BlitMaterial("float4(floor(i.pos.xy) * 20.0 / 255.0, 1, 0.4)");
    cmd.Blit(other, source, paint);
    cmd.SetRenderTarget(other);
    cmd.CopyTexture(source, BuiltinRenderTextureType::CameraTarget);
    cmd.ClearRenderTarget(ClearFlag::All, Color::red); // of `other`, not of the copy
    const Image image = Draw(dest);
    for (int y = 0; y < 5; ++y)
    {
        for (int x = 0; x < 7; ++x)
        {
            EXPECT_EQ(Texel8(image, x, y), (Rgba8{20 * x, 20 * y, 255, 102})) << x << ", " << y;
        }
    }
    ExpectNoValidationMessages();
}

} // namespace limn::test
