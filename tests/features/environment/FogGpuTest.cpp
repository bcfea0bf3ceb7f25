#include "features/color_edges/PictureRun.h"

#include <cmath>

namespace limn::test
{
namespace
{

constexpr int k_FogWidth = 24;
constexpr int k_FogHeight = 4;
constexpr double k_FogNear = 1.0;
constexpr double k_FogFar = 11.0;
constexpr double k_Depths[] = {1.5, 4.0, 9.5};
const glm::dvec3 k_Color(0.8, 0.1, 0.3);
const glm::dvec3 k_FogColor(0.25, 0.5, 2.0); ///< linear

/// The way in which a shader's fog is worked out.
struct FogKind
{
    bool isByVertex; ///< the distance is what clip space has, from 0 at the near plane to far
    /// As a part of fogDensity: URP takes the number of ExponentialSquared for Exponential, too.
    double exponentialDensity;
};
const double k_UrpsDensity = std::sqrt(std::log(2.0));

/// Returns how much of a surface is seen through the fog, by the definitions of the modes.
double Seen(const RenderSettings& settings, double distance, const FogKind& kind)
{
    const double density = settings.fogDensity;
    const double start = settings.fogStartDistance;
    const double end = settings.fogEndDistance;
    switch (settings.fogMode)
    {
    case FogMode::Linear:
        return std::clamp((end - distance) / (end - start), 0.0, 1.0);
    case FogMode::Exponential:
        return std::exp(-density * kind.exponentialDensity * distance);
    case FogMode::ExponentialSquared:
        break;
    }
    return std::exp(-density * density * distance * distance);
}

std::shared_ptr<const Material> MaterialOf(const std::string& hlsl)
{
    return std::make_shared<const Material>(ShaderOf(
        "Shader \"Test/Fogged\" { SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" "
        "}\n"
        "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n#pragma multi_compile_fog\n" +
        hlsl + "\nENDHLSL\n} } }"));
}

/// URP's fog worked out for each vertex.
std::shared_ptr<const Material> FoggedByVertex()
{
    return MaterialOf(R"(
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
struct V { float4 p : SV_POSITION; float fog : TEXCOORD0; };
V Vert(float4 p : POSITION)
{
    V v;
    v.p = TransformObjectToHClip(p.xyz);
    v.fog = ComputeFogFactor(v.p.z);
    return v;
}
float4 Frag(V v) : SV_Target { return float4(MixFog(float3(0.8, 0.1, 0.3), v.fog), 1); })");
}

/// URP's fog worked out for each pixel.
std::shared_ptr<const Material> FoggedByPixel()
{
    return MaterialOf(R"(
#define _FOG_FRAGMENT 1
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
struct V { float4 p : SV_POSITION; float3 world : TEXCOORD0; };
V Vert(float4 p : POSITION)
{
    V v;
    v.p = TransformObjectToHClip(p.xyz);
    v.world = TransformObjectToWorld(p.xyz);
    return v;
}
float4 Frag(V v) : SV_Target
{
    float fog = InitializeInputDataFog(float4(v.world, 1), 0);
    return float4(MixFog(float3(0.8, 0.1, 0.3), fog), 1);
})");
}

/// The built-in pipeline's fog.
std::shared_ptr<const Material> FoggedByCg()
{
    return MaterialOf(R"(
#include "UnityCG.cginc"
struct V { float4 pos : SV_POSITION; UNITY_FOG_COORDS(0) };
V Vert(appdata_base v)
{
    V o;
    o.pos = UnityObjectToClipPos(v.vertex);
    UNITY_TRANSFER_FOG(o, o.pos);
    return o;
}
fixed4 Frag(V i) : SV_Target
{
    fixed4 color = fixed4(0.8, 0.1, 0.3, 1);
    UNITY_APPLY_FOG(i.fogCoord, color);
    return color;
})");
}

class FogGpu : public GpuTest
{
protected:
    FogGpu() : m_Flat(k_FogWidth, k_FogHeight) {}

    void Fill(const std::shared_ptr<const Material>& material)
    {
        for (std::size_t i = 0; i < std::size(k_Depths); ++i)
        {
            const auto left = 8.0f * static_cast<float>(i);
            m_Flat.Add({left, 0}, {left + 8, k_FogHeight}, static_cast<float>(k_Depths[i]),
                       material);
        }
    }
    void SetFog(FogMode mode)
    {
        Scene& scene = m_Flat.scene;
        scene.fog = true;
        scene.fogMode = mode;
        scene.fogColor = Color(0.25f, 0.5f, 2.0f).gamma();
        scene.fogDensity = 0.17f;
        scene.fogStartDistance = 2.0f;
        scene.fogEndDistance = 8.0f;
    }
    void ExpectFog(PictureRun& run, const FogKind& kind)
    {
        const Field picture = run.Color(nullptr);
        for (std::size_t i = 0; i < std::size(k_Depths); ++i)
        {
            const double behindNear = k_Depths[i] - k_FogNear;
            const double distance =
                kind.isByVertex ? behindNear * k_FogFar / (k_FogFar - k_FogNear) : behindNear;
            const double seen = m_Flat.scene.fog ? Seen(m_Flat.scene, distance, kind) : 1.0;
            for (int channel = 0; channel < 3; ++channel)
            {
                const double wanted =
                    k_FogColor[channel] + (m_Color[channel] - k_FogColor[channel]) * seen;
                // A half and what a float's exp2 and clip depth lose.
                EXPECT_NEAR(wanted, picture.At(8 * static_cast<int>(i) + 4, 2, channel),
                            1e-3 * wanted + 2e-4)
                    << "depth " << k_Depths[i] << ", channel " << channel;
            }
        }
    }
    void ExpectFogInEachMode(const std::shared_ptr<const Material>& material, const FogKind& kind)
    {
        Fill(material);
        PictureRun run(m_Flat.scene, m_Flat.camera, k_FogWidth, k_FogHeight);
        m_Flat.scene.fog = false;
        ExpectFog(run, kind);
        for (const FogMode mode :
             {FogMode::Linear, FogMode::Exponential, FogMode::ExponentialSquared})
        {
            SCOPED_TRACE(static_cast<int>(mode));
            SetFog(mode);
            ExpectFog(run, kind);
            m_Flat.scene.fogDensity = 0.4f; // in the same frame, which may be kept
            m_Flat.scene.fogStartDistance = -1.0f;
            ExpectFog(run, kind);
        }
        m_Flat.scene.fog = false;
        ExpectFog(run, kind);
    }

    FlatScene m_Flat;
    glm::dvec3 m_Color = k_Color; ///< of what is veiled
};

TEST_F(FogGpu, VeilsByTheModesFormulaInOrthographicPictures)
{
    ExpectFogInEachMode(FoggedByVertex(), {true, k_UrpsDensity});
}

TEST_F(FogGpu, VeilsByTheModesFormulaInPerspective)
{
    m_Flat.MakePerspective();
    ExpectFogInEachMode(FoggedByVertex(), {true, k_UrpsDensity});
}

TEST_F(FogGpu, VeilsWhatAPassWithoutAProgramDraws)
{
    m_Color = glm::dvec3(1.0);
    ExpectFogInEachMode(std::make_shared<const Material>(
                            ShaderOf("Shader \"Test/White\" { SubShader { Pass { } } }")),
                        {true, k_UrpsDensity});
}

TEST_F(FogGpu, VeilsEachPixelByItsDistanceInOrthographicPictures)
{
    ExpectFogInEachMode(FoggedByPixel(), {false, k_UrpsDensity});
}

TEST_F(FogGpu, VeilsEachPixelByItsDistanceInPerspective)
{
    m_Flat.MakePerspective();
    ExpectFogInEachMode(FoggedByPixel(), {false, k_UrpsDensity});
}

TEST_F(FogGpu, VeilsShadersOfTheBuiltInPipelineAlike)
{
    m_Flat.MakePerspective();
    ExpectFogInEachMode(FoggedByCg(), {true, 1.0});
}

TEST_F(FogGpu, VeilsUnlit)
{
    m_Flat.MakePerspective();
    ExpectFogInEachMode(Plain(glm::vec3(k_Color)), {true, k_UrpsDensity});
}

TEST_F(FogGpu, IsAWallWhereItBeginsAndEndsAtOnce)
{
    Fill(FoggedByPixel());
    SetFog(FogMode::Linear);
    m_Flat.scene.fogStartDistance = m_Flat.scene.fogEndDistance = 5.0f;
    const Field picture =
        PictureRun(m_Flat.scene, m_Flat.camera, k_FogWidth, k_FogHeight).Color(nullptr);
    EXPECT_NEAR(k_Color.x, picture.At(4, 2, 0), 1e-3);
    EXPECT_NEAR(k_Color.x, picture.At(12, 2, 0), 1e-3);
    EXPECT_NEAR(k_FogColor.x, picture.At(20, 2, 0), 1e-3);
}

TEST_F(FogGpu, LeavesTheSkyAsItIs)
{
    m_Flat.MakePerspective();
    m_Flat.camera.clearFlags = CameraClearFlags::Skybox;
    const auto shader = FindBuiltinShader("Skybox/Procedural", Compiler());
    m_Flat.scene.skybox = std::make_shared<const Material>(shader);
    m_Flat.Add({0, 0}, {8, k_FogHeight}, 6.0f, Plain(glm::vec3(k_Color)));
    PictureRun run(m_Flat.scene, m_Flat.camera, k_FogWidth, k_FogHeight);
    const Field clear = run.Color(nullptr);
    SetFog(FogMode::Exponential);
    const Field veiled = run.Color(nullptr);
    EXPECT_GT(std::abs(clear.At(4, 2, 2) - veiled.At(4, 2, 2)), 0.2);
    for (int x = 9; x < k_FogWidth; ++x)
    {
        for (int channel = 0; channel < 3; ++channel)
        {
            EXPECT_EQ(clear.At(x, 1, channel), veiled.At(x, 1, channel)) << x;
        }
    }
}

} // namespace
} // namespace limn::test
