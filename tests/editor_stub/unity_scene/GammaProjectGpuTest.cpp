// Projects whose colour space is gamma: what a pixel shows is computed here from the definition of
// sRGB.

#include "Paths.h"
#include "commands/CommandRun.h"
#include "vulkan/GpuTestDevice.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/QualitySettings.h>

namespace limn::test
{
namespace
{

/// Stripes of four pixels, each of which shows one thing that depends on the colour space.
constexpr const char* k_Stripes = R"(Shader "Test/Stripes" {
Properties { _Tint ("Tint", Color) = (0.5, 0.5, 0.5, 1) _MainTex ("Picture", 2D) = "white" {}
  _Grey ("Grey", 2D) = "grey" {} _LinearGrey ("Linear grey", 2D) = "linearGrey" {}
  [Gamma] _Number ("Number", Range(0, 2)) = 0.5 [Gamma] _Numbers ("Numbers", Vector) = (0.25, 0.5, 2, 0.5) }
SubShader { Tags { "Queue" = "Transparent" } Pass {
Blend SrcAlpha OneMinusSrcAlpha
HLSLPROGRAM
#pragma vertex V
#pragma fragment F
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
float4 _Tint;
float _Number;
float4 _Numbers;
TEXTURE2D(_MainTex);
TEXTURE2D(_Grey);
TEXTURE2D(_LinearGrey);
SAMPLER(sampler_MainTex);
float4 V(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }
float4 F(float4 p : SV_POSITION) : SV_Target
{
    switch ((int)p.x / 4)
    {
    case 0: return _Tint;
    case 1: return _Tint * SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, float2(0.5, 0.5));
    case 2: return float4(_MainLightColor.rgb, 1);
    case 3: return float4(SampleSH(float3(0, 1, 0)), 1);
    case 4: return float4(unity_AmbientSky.rgb, 1);
    case 5: return float4(1, 1, 1, 0.5);
    case 6: return float4(_Number, _Numbers.x, _Numbers.y, 1);
    case 7: return float4(_Numbers.zzz / 8, 1);
    case 8: return float4(_Grey.Load(0).r, _LinearGrey.Load(0).r, _Grey.Load(0).a, 1);
    case 9: return float4(unity_FogColor.rgb, 1);
    }
#ifdef UNITY_COLORSPACE_GAMMA
    return float4(0, 1, 0, 1);
#else
    return float4(1, 0, 0, 1);
#endif
}
ENDHLSL } } })";

constexpr const char* k_StripesScene = R"(%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!104 &2
RenderSettings:
  m_AmbientSkyColor: {r: 0.25, g: 0.5, b: 0.75, a: 1}
  m_AmbientMode: 3
  m_Fog: 1
  m_FogColor: {r: 0.75, g: 0.5, b: 0.25, a: 1}
--- !u!1 &100
GameObject: {m_Name: Camera, m_TagString: MainCamera, m_IsActive: 1}
--- !u!4 &104
Transform:
  m_GameObject: {fileID: 100}
  m_LocalPosition: {x: 0, y: 0, z: -5}
  m_Father: {fileID: 0}
--- !u!20 &120
Camera:
  m_GameObject: {fileID: 100}
  m_ClearFlags: 2
  m_BackGroundColor: {r: 0.25, g: 0.25, b: 0.25, a: 0}
  orthographic: 1
  orthographic size: 1
  m_HDR: 1
--- !u!114 &130
MonoBehaviour:
  m_GameObject: {fileID: 100}
  m_Script: {fileID: 11500000, guid: a79441f348de89743a2939f4d699eac1, type: 3}
  m_RenderPostProcessing: 1
--- !u!1 &200
GameObject: {m_Name: Sun, m_IsActive: 1}
--- !u!4 &204
Transform:
  m_GameObject: {fileID: 200}
  m_Father: {fileID: 0}
--- !u!108 &208
Light:
  m_GameObject: {fileID: 200}
  m_Type: 1
  m_Color: {r: 0.5, g: 0.5, b: 0.5, a: 1}
  m_Intensity: 0.5
)";
constexpr const char* k_StripesWall = R"(--- !u!1 &300
GameObject: {m_Name: Wall, m_IsActive: 1}
--- !u!4 &304
Transform:
  m_GameObject: {fileID: 300}
  m_LocalScale: {x: 40, y: 40, z: 1}
  m_Father: {fileID: 0}
--- !u!33 &303
MeshFilter:
  m_GameObject: {fileID: 300}
  m_Mesh: {fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}
--- !u!23 &302
MeshRenderer:
  m_GameObject: {fileID: 300}
  m_Enabled: 1
  m_Materials:
  - {fileID: 2100000, guid: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa, type: 2}
)";

double DecodeSrgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
double EncodeSrgb(double linear)
{
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

using Rgb = std::array<double, 3>;
constexpr Rgb Grey(double value)
{
    return {value, value, value};
}

/// The yard's settings with a scene and a material of one's own.
class GammaProject : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        std::filesystem::copy(SourcePath("tests/editor_stub/data/yard"), m_Folder / "yard",
                              std::filesystem::copy_options::recursive);
        m_Folder.Write("yard/Assets/Settings/Renderer.asset",
                       "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &11400000\n"
                       "MonoBehaviour:\n  m_Script: {fileID: 11500000, guid: "
                       "de640fe3d0db1804a85f9fc8f5cadab6, type: 3}\n  m_RendererFeatures: []\n"
                       "  postProcessData: {fileID: 11400000, guid: "
                       "41439944d30ece34e96484bdb6645b55, type: 2}\n");
        m_Folder.Write("yard/Assets/Stripes.shader", k_Stripes);
        m_Folder.Write("yard/Assets/Stripes.shader.meta",
                       "guid: bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb\n");
        m_Folder.Write("yard/Assets/Stripes.mat",
                       "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!21 &2100000\nMaterial:\n"
                       "  m_Shader: {fileID: 4800000, guid: bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb, "
                       "type: 3}\n  m_SavedProperties:\n    m_TexEnvs:\n    - _MainTex:\n"
                       "        m_Texture: {fileID: 2800000, guid: "
                       "000000000000000000000000ca7e0006, type: 3}\n");
        m_Folder.Write("yard/Assets/Stripes.mat.meta", "guid: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\n");
    }
    void TearDown() override { PlayerSettings::SetColorSpace(ColorSpace::Linear); }

    Image Draw(const std::string& scene, ColorSpace space, const std::string& profile = "")
    {
        m_Folder.Write("yard/Assets/Scenes/Yard.unity", scene);
        m_Folder.Write("yard/ProjectSettings/ProjectSettings.asset",
                       "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!129 &1\n"
                       "PlayerSettings:\n  m_ActiveColorSpace: " +
                           std::to_string(static_cast<int>(space)) + "\n");
        std::vector<std::string> args = {
            "render", m_Folder / "yard", "-o", m_Folder / "out.png", "--size", "44x4",
            "-q",     "--validate"};
        if (!profile.empty())
        {
            m_Folder.Write("p.profile.yaml", profile);
            args.insert(args.end(), {"--profile", m_Folder / "p.profile.yaml"});
        }
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(0, run.exitCode) << run.err;
        EXPECT_EQ("", run.err);
        return ReadPng(m_Folder / "out.png");
    }

    /// @param allowed  steps of 8 bits
    static void ExpectStripe(const Image& picture, int stripe, const Rgb& wanted,
                             double allowed = 1.0)
    {
        const std::size_t texel = static_cast<std::size_t>(picture.width + 4 * stripe + 1);
        for (std::size_t channel = 0; channel < 3; ++channel)
        {
            EXPECT_NEAR(std::to_integer<int>(picture.texels[4 * texel + channel]),
                        wanted[channel] * 255.0, allowed)
                << "stripe " << stripe << ", channel " << channel;
        }
    }

    TemporaryFolder m_Folder;
};

constexpr Rgb k_WoodColor = {200 / 255.0, 120 / 255.0, 40 / 255.0};
constexpr Rgb k_AmbientSky = {0.25, 0.5, 0.75};

TEST_F(GammaProject, WorksWithColoursAsTheyAreWritten)
{
    const Image picture = Draw(std::string(k_StripesScene) + k_StripesWall, ColorSpace::Gamma);
    ExpectStripe(picture, 0, Grey(0.5));
    ExpectStripe(picture, 1, {0.5 * k_WoodColor[0], 0.5 * k_WoodColor[1], 0.5 * k_WoodColor[2]});
    ExpectStripe(picture, 2, Grey(0.5 * 0.5));
    ExpectStripe(picture, 3, k_AmbientSky);
    ExpectStripe(picture, 4, k_AmbientSky);
    ExpectStripe(picture, 5, Grey(0.5 * 1 + 0.5 * 0.25));
    ExpectStripe(picture, 6, {0.5, 0.25, 0.5});
    ExpectStripe(picture, 7, Grey(2.0 / 8));
    ExpectStripe(picture, 8, Grey(128 / 255.0));
    ExpectStripe(picture, 9, {0.75, 0.5, 0.25});
    ExpectStripe(picture, 10, {0, 1, 0});
}

TEST_F(GammaProject, IsNoLinearOne)
{
    Draw(std::string(k_StripesScene) + k_StripesWall, ColorSpace::Gamma);
    const Image picture = Draw(std::string(k_StripesScene) + k_StripesWall, ColorSpace::Linear);
    const double half = DecodeSrgb(0.5);
    ExpectStripe(picture, 0, Grey(0.5));
    ExpectStripe(picture, 1,
                 {EncodeSrgb(half * DecodeSrgb(k_WoodColor[0])),
                  EncodeSrgb(half * DecodeSrgb(k_WoodColor[1])),
                  EncodeSrgb(half * DecodeSrgb(k_WoodColor[2]))});
    ExpectStripe(picture, 2, Grey(EncodeSrgb(half * 0.5)));
    ExpectStripe(picture, 3, k_AmbientSky);
    ExpectStripe(picture, 4, k_AmbientSky);
    ExpectStripe(picture, 5, Grey(EncodeSrgb(0.5 * 1 + 0.5 * DecodeSrgb(0.25))));
    ExpectStripe(picture, 6, {0.5, 0.25, 0.5}); // it decodes what the picture encodes
    ExpectStripe(picture, 7, Grey(EncodeSrgb(std::pow(2.0, 2.2) / 8)));
    const double shown = EncodeSrgb(128 / 255.0);
    ExpectStripe(picture, 8, {128 / 255.0, shown, shown});
    ExpectStripe(picture, 9, {0.75, 0.5, 0.25});
    ExpectStripe(picture, 10, {1, 0, 0});
}

// URP works effects out in linear light in both. Only the glow's source is what the camera drew.
TEST_F(GammaProject, HasEffectsInLinearLight)
{
    const Image exposed =
        Draw(k_StripesScene, ColorSpace::Gamma, "ColorAdjustments: {postExposure: 1}\n");
    ExpectStripe(exposed, 0, Grey(EncodeSrgb(2 * DecodeSrgb(0.25))));
    const Image glowing =
        Draw(k_StripesScene, ColorSpace::Gamma, "Bloom: {threshold: 0, intensity: 0.5}\n");
    // The glow's pictures have 5 bits of blue. What they cut off a root costs the glow twice as
    // much.
    const double glow = 0.5 * 0.25;
    const double lit = EncodeSrgb(DecodeSrgb(0.25) + glow);
    const double leastLit = EncodeSrgb(DecodeSrgb(0.25) + glow * (1.0 - 2.0 / 32));
    ExpectStripe(glowing, 0, Grey(lit), 1.0 + 255.0 * (lit - leastLit));
}

} // namespace
} // namespace limn::test
