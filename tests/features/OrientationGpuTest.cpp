#include "features/RecordingFeature.h"
#include "features/color_edges/PictureRun.h"
#include "vulkan/GpuTestFrame.h"

#include <cmath>
#include <limn/core/AsyncGPUReadback.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/PrimitiveMesh.h>

namespace limn::test
{
namespace
{

// Neither square nor even in halves, so that what is turned or mirrored shows.
constexpr int k_OrientedWidth = 6;
constexpr int k_OrientedHeight = 10;

constexpr auto k_PassBegin =
    "Shader \"Test/Oriented\" { Properties { _MainTex (\"\", 2D) = \"white\" {} }\n"
    "SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" }\nHLSLPROGRAM\n"
    "#pragma vertex Vert\n#pragma fragment Frag\n"
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
    "DeclareOpaqueTexture.hlsl\"\n"
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
    "DeclareDepthTexture.hlsl\"\n"
    "TEXTURE2D(_MainTex); SAMPLER(sampler_MainTex);\n";
constexpr auto k_PassEnd = "\nENDHLSL\n} } }";

/// Draws over the whole target with Blit.hlsl's vertex function.
/// @param value  HLSL of a float, from `input`
std::shared_ptr<Material> FullScreenOf(const std::string& value)
{
    return std::make_shared<Material>(ShaderOf(
        std::string(k_PassBegin) +
        "#include \"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n"
        "float4 Frag(Varyings input) : SV_Target { float x = " +
        value + "; return float4(x, x, x, 1); }" + k_PassEnd));
}

/// Draws a mesh where it is.
/// @param value  HLSL of a float, from `i.positionCS`, `i.screen` (ComputeScreenPos) and `i.uv`
std::shared_ptr<Material> OnObject(const std::string& value)
{
    return std::make_shared<Material>(
        ShaderOf(std::string(k_PassBegin) +
                 "struct V { float4 positionCS : SV_POSITION; float4 screen : TEXCOORD0; "
                 "float2 uv : TEXCOORD1; };\n"
                 "V Vert(float4 p : POSITION, float2 uv : TEXCOORD0)\n"
                 "{ V o; o.positionCS = TransformObjectToHClip(p.xyz);\n"
                 "  o.screen = ComputeScreenPos(o.positionCS); o.uv = uv; return o; }\n"
                 "float4 Frag(V i) : SV_Target { float x = " +
                 value + "; return float4(x, x, x, 1); }" + k_PassEnd));
}

int SrgbOf(double linear)
{
    const double encoded =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255.0 * encoded));
}

/// How far up in a picture the middle of a row is; rows count from the top, as in images.
double HeightOf(int row)
{
    return 1.0 - (row + 0.5) / k_OrientedHeight;
}

/// A texture whose texels are as bright as they are high up, bottom row first.
std::shared_ptr<const Texture2D> MakeRamp()
{
    std::vector<std::byte> texels;
    for (int row = 0; row < k_OrientedHeight; ++row)
    {
        for (int i = 0; i < k_OrientedWidth * 4; ++i)
        {
            texels.push_back(static_cast<std::byte>((2 * row + 1) * 12));
        }
    }
    const SamplerState point{FilterMode::Point, TextureWrapMode::Repeat, TextureWrapMode::Repeat,
                             TextureWrapMode::Repeat, false};
    return std::make_shared<const Texture2D>("ramp", k_OrientedWidth, k_OrientedHeight,
                                             GraphicsFormat::R8G8B8A8_UNorm, texels, point);
}
double RampAt(double v)
{
    const double row = std::floor((v - std::floor(v)) * k_OrientedHeight);
    return (2.0 * row + 1.0) * 12.0 / 255.0;
}

class OrientationGpu : public GpuTest
{
protected:
    using Wanted = std::function<double(int x, int row)>;

    OrientationGpu() : m_Flat(k_OrientedWidth, k_OrientedHeight)
    {
        m_Flat.camera.allowHDR = false; // a texture between rounds as the output does
    }

    /// In place of what was to be recorded before.
    /// @param event  of the first call
    void Record(RecordingFeature::Record record,
                RenderPassEvent event = RenderPassEvent::AfterRenderingTransparents)
    {
        if (!m_Record)
        {
            m_Renderer.AddFeature(std::make_unique<RecordingFeature>(
                event, [this](CommandBuffer& cmd, RenderingData& data) { m_Record(cmd, data); }));
        }
        m_Record = std::move(record);
    }

    RenderResult Render(bool leavesOut)
    {
        RenderRequest request;
        request.scene = &m_Flat.scene;
        request.camera = &m_Flat.camera;
        request.width = k_OrientedWidth;
        request.height = k_OrientedHeight;
        request.compile.leavesOut = leavesOut;
        return m_Pipeline.RenderSingleCamera(m_Renderer, request);
    }

    Image Picture(bool leavesOut)
    {
        return SharedDevice().ReadBack(*Render(leavesOut).output.rt());
    }

    static void ExpectTexels(const Image& picture, const Wanted& wanted)
    {
        for (int row = 0; row < k_OrientedHeight; ++row)
        {
            for (int x = 0; x < k_OrientedWidth; ++x)
            {
                ASSERT_NEAR(Texel8(picture, x, row)[0], SrgbOf(wanted(x, row)), 1)
                    << x << ", row " << row << " from the top";
            }
        }
    }

    /// Through a texture of the camera's, and straight into the output: the same.
    /// @param wanted  linear, by x and the row from the top
    void ExpectPicture(const Wanted& wanted)
    {
        const Image through = Picture(false);
        const Image straight = Picture(true);
        ExpectTexels(through, wanted);
        EXPECT_EQ(through.texels, straight.texels);
        ExpectNoValidationMessages();
    }

    FlatScene m_Flat;
    RecordingFeature::Record m_Record;
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
    UniversalRenderer m_Renderer{Compiler()};
};

TEST_F(OrientationGpu, FullScreenCoordinatesRiseFromTheBottom)
{
    for (const char* value : {"input.texcoord.y", "input.positionCS.y / _ScreenParams.y",
                              "GetNormalizedScreenSpaceUV(input.positionCS).y"})
    {
        SCOPED_TRACE(value);
        Record(
            [material = FullScreenOf(value)](CommandBuffer& cmd, RenderingData&) {
                Blitter::BlitTexture(cmd, {1, 1, 0, 0}, material, 0);
            });
        ExpectPicture([](int, int row) { return HeightOf(row); });
    }
}

TEST_F(OrientationGpu, ScreenPositionsOfObjectsRiseFromTheBottom)
{
    for (const char* value :
         {"i.screen.y / i.screen.w", "GetNormalizedScreenSpaceUV(i.positionCS).y",
          "i.positionCS.y / _ScaledScreenParams.y", "i.uv.y"})
    {
        SCOPED_TRACE(value);
        FlatScene flat(k_OrientedWidth, k_OrientedHeight);
        flat.Add({0, 0}, {k_OrientedWidth, k_OrientedHeight}, 5.0f, OnObject(value));
        m_Flat.scene = std::move(flat.scene);
        ExpectPicture([](int, int row) { return HeightOf(row); });
    }
}

/// What full-screen shaders write that make their clip positions themselves.
TEST_F(OrientationGpu, ShadersThatTurnThemselvesOverForTexturesAreUpright)
{
    const std::shared_ptr<const Texture2D> ramp = MakeRamp();
    for (const char* turn :
         {"#if UNITY_UV_STARTS_AT_TOP\no.p.y = -o.p.y;\n#endif\n",
          "#if UNITY_UV_STARTS_AT_TOP\no.uv.y = 1 - o.uv.y;\n#endif\n",
          "o.p.y *= _ProjectionParams.x;\n", "if (_ProjectionParams.x < 0) o.uv.y = 1 - o.uv.y;\n"})
    {
        SCOPED_TRACE(turn);
        const auto material = std::make_shared<Material>(ShaderOf(
            "Shader \"Test/Turned\" { SubShader { Pass { ZTest Always ZWrite Off Cull Off\n"
            "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
            "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
            "TEXTURE2D(_MainTex); SAMPLER(sampler_MainTex);\n"
            "struct V { float4 p : SV_POSITION; float2 uv : TEXCOORD0; };\n"
            "V Vert(uint id : SV_VertexID) { V o; o.uv = float2((id << 1) & 2, id & 2);\n"
            "o.p = float4(o.uv * 2 - 1, 0.5, 1);\n" +
            std::string(turn) +
            "return o; }\nfloat4 Frag(V i) : SV_Target\n"
            "{ return SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, i.uv); }\nENDHLSL\n} } }"));
        material->SetTexture("_MainTex", ramp);
        Record([material](CommandBuffer& cmd, RenderingData&)
               { cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3); });
        ExpectPicture([](int, int row) { return RampAt(HeightOf(row)); });
    }
}

TEST_F(OrientationGpu, ATextureScrollsTheWayItDoesInUnity)
{
    const auto material = OnObject("SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, i.uv + "
                                   "float2(0, 0.2)).r");
    material->SetTexture("_MainTex", MakeRamp());
    m_Flat.Add({0, 0}, {k_OrientedWidth, k_OrientedHeight}, 5.0f, material);
    ExpectPicture([](int, int row) { return RampAt(HeightOf(row) + 0.2); });
}

TEST_F(OrientationGpu, ABlitBetweenTexturesTurnsNothing)
{
    const RTHandle first(MakeTarget(k_OrientedWidth, k_OrientedHeight,
                                    GraphicsFormat::R16G16B16A16_SFloat, "first"));
    const auto ramp = std::make_shared<Material>(ShaderOf(
        "Shader \"Test/Old\" { SubShader { Pass { ZTest Always ZWrite Off Cull Off\nCGPROGRAM\n"
        "#pragma vertex vert_img\n#pragma fragment frag\n#include \"UnityCG.cginc\"\n"
        "sampler2D _MainTex;\nfloat4 frag(v2f_img i) : SV_Target\n"
        "{ return tex2D(_MainTex, i.uv - float2(0, 0.3)); }\nENDCG\n} } }"));
    const auto texture = RenderTargetIdentifier(std::shared_ptr<const Texture>(MakeRamp()));
    Record(
        [=](CommandBuffer& cmd, RenderingData& data)
        {
            cmd.Blit(texture, first.nameID(), ramp, 0);
            Blitter::BlitCameraTexture(cmd, first,
                                       data.cameraData.renderer->cameraColorTargetHandle());
        });
    ExpectPicture([](int, int row) { return RampAt(HeightOf(row) - 0.3); });
}

TEST_F(OrientationGpu, ViewportsCountFromTheBottom)
{
    Record(
        [material = FullScreenOf("1")](CommandBuffer& cmd, RenderingData&)
        {
            cmd.SetViewport({1, 2, 3, 4});
            Blitter::BlitTexture(cmd, {1, 1, 0, 0}, material, 0);
        });
    ExpectPicture(
        [](int x, int row)
        {
            const int y = k_OrientedHeight - 1 - row;
            return x >= 1 && x < 4 && y >= 2 && y < 6 ? 1.0 : 0.0;
        });
}

TEST_F(OrientationGpu, ScissorsCountFromTheBottom)
{
    Record(
        [material = FullScreenOf("1")](CommandBuffer& cmd, RenderingData&)
        {
            cmd.EnableScissorRect({0, 0, 5, 3});
            Blitter::BlitTexture(cmd, {1, 1, 0, 0}, material, 0);
            cmd.DisableScissorRect();
        });
    ExpectPicture([](int x, int row) { return x < 5 && row >= k_OrientedHeight - 3 ? 1.0 : 0.0; });
}

TEST_F(OrientationGpu, AReadBackBeginsWithTheBottomRow)
{
    const auto target = MakeTarget(k_OrientedWidth, k_OrientedHeight);
    m_Flat.camera.targetTexture = target;
    m_Flat.Add({0, 0}, {k_OrientedWidth, 4}, 5.0f, Plain({1, 1, 1})); // the four upper rows
    Render(true);
    AsyncGPUReadbackRequest request = AsyncGPUReadback::Request(SharedDevice(), *target);
    const Image picture = SharedDevice().ReadBack(*target);
    request.WaitForCompletion();
    const auto rows = request.GetData<std::array<std::uint8_t, 4>>();
    for (int y = 0; y < k_OrientedHeight; ++y)
    {
        const auto at = static_cast<std::size_t>(y * k_OrientedWidth);
        EXPECT_EQ(rows[at][0], y >= 6 ? 255 : 0) << y << " from the bottom";
        EXPECT_EQ(Texel8(picture, 0, y)[0], y < 4 ? 255 : 0) << y << " from the top";
    }
    ExpectNoValidationMessages();
}

/// What is drawn behind, upper and lower half.
TEST_F(OrientationGpu, AGrabIsWhereItWasDrawn)
{
    m_Flat.Add({0, 0}, {k_OrientedWidth, 3}, 9.0f, Plain({0.25f, 0.25f, 0.25f}));
    m_Flat.Add({0, 3}, {2, 9}, 7.0f, Plain({0.5f, 0.5f, 0.5f}));
    const auto color = [](int x, int row)
    {
        return row < 3 ? 0.25 : x < 2 && row < 9 ? 0.5 : 0.0;
    };
    const auto depth = [](int x, int row)
    {
        return (row < 3 ? 9.0 : x < 2 && row < 9 ? 7.0 : 11.0) / 11.0;
    };
    const std::pair<const char*, Wanted> grabs[] = {
        {"SampleSceneColor(i.screen.xy / i.screen.w).r", color},
        {"SampleSceneColor(GetNormalizedScreenSpaceUV(i.positionCS)).r", color},
        {"LoadSceneColor(uint2(i.positionCS.xy)).r", color},
        {"(_ProjectionParams.z + (_ProjectionParams.y - _ProjectionParams.z) * "
         "SampleSceneDepth(i.screen.xy / i.screen.w)) / 11",
         depth}};
    for (const auto& [value, wanted] : grabs)
    {
        SCOPED_TRACE(value);
        const auto material = OnObject(value);
        material->SetRenderQueue(3000);
        GameObject& glass = m_Flat.Add({0, 0}, {k_OrientedWidth, k_OrientedHeight}, 2.0f, material);
        ExpectPicture(wanted);
        glass.activeSelf = false;
    }
}

TEST_F(OrientationGpu, OnlyFacesTowardsTheCameraAreDrawnWhateverTheTargetIs)
{
    m_Flat.Add({0, 0}, {3, k_OrientedHeight}, 5.0f, Plain({1, 1, 1})).transform.localScale.x *=
        -1.0f; // mirrored: it still faces the camera
    m_Flat.Add({3, 0}, {6, k_OrientedHeight}, 5.0f, Plain({1, 1, 1})).transform.localRotation =
        EulerToRotation({0, 180, 0}); // turned away
    ExpectPicture([](int x, int) { return x < 3 ? 1.0 : 0.0; });
}

/// A window's or a host's image: Unity's back buffer.
TEST_F(OrientationGpu, ATargetOfTheTopRowFirstGetsTheSamePictureTheOtherWayUp)
{
    RenderTextureDescriptor descriptor(k_OrientedWidth, k_OrientedHeight,
                                       GraphicsFormat::R8G8B8A8_SRGB);
    const auto plain = std::make_shared<const RenderTexture>("plain", descriptor);
    descriptor.isTopRowFirst = true;
    const auto turned = std::make_shared<const RenderTexture>("turned", descriptor);
    m_Flat.Add({0, 0}, {k_OrientedWidth, 7}, 5.0f, OnObject("i.screen.y / i.screen.w"));
    std::vector<std::byte> stored[2];
    Image pictures[2];
    for (const int i : {0, 1})
    {
        const auto& target = i == 0 ? plain : turned;
        m_Flat.camera.targetTexture = target;
        Render(true);
        auto request = AsyncGPUReadback::Request(SharedDevice(), *target);
        pictures[i] = SharedDevice().ReadBack(*target);
        request.WaitForCompletion();
        const auto bytes = request.GetData<std::byte>();
        stored[i].assign(bytes.begin(), bytes.end());
    }
    ExpectTexels(pictures[0], [](int, int row) { return row < 7 ? HeightOf(row) : 0.0; });
    EXPECT_EQ(pictures[0].texels, pictures[1].texels);
    EXPECT_NE(stored[0], stored[1]);
    EXPECT_EQ(stored[0], FlipRows(stored[1], k_OrientedHeight));
    ExpectNoValidationMessages();
}

/// Behind the final blit, as features that draw on the back buffer do.
TEST_F(OrientationGpu, WhatIsDrawnIntoATargetOfTheTopRowFirstIsUpright)
{
    RenderTextureDescriptor descriptor(k_OrientedWidth, k_OrientedHeight,
                                       GraphicsFormat::R8G8B8A8_SRGB);
    descriptor.isTopRowFirst = true;
    const auto screen = std::make_shared<const RenderTexture>("screen", descriptor);
    m_Flat.camera.targetTexture = screen;
    FlatScene other(k_OrientedWidth, k_OrientedHeight);
    const glm::mat4 place = other.Add({0, 0}, {3, 7}, 5.0f, nullptr).transform.localToWorldMatrix();
    const auto onObject = OnObject("i.screen.y / i.screen.w");
    const auto ramp = std::make_shared<Material>(ShaderOf(
        "Shader \"Test/OldRamp\" { SubShader { Pass { ZTest Always ZWrite Off Cull Back\n"
        "CGPROGRAM\n#pragma vertex vert_img\n#pragma fragment frag\n#include \"UnityCG.cginc\"\n"
        "sampler2D _MainTex;\nfloat4 frag(v2f_img i) : SV_Target\n"
        "{ return tex2D(_MainTex, i.uv); }\nENDCG\n} } }"));
    const auto texture = RenderTargetIdentifier(std::shared_ptr<const Texture>(MakeRamp()));
    Record(
        [=](CommandBuffer& cmd, RenderingData& data)
        {
            EXPECT_TRUE(data.cameraData.IsCameraProjectionMatrixFlipped());
            EXPECT_FALSE(data.cameraData.IsHandleYFlipped(RTHandle(screen)));
            EXPECT_FALSE(data.cameraData.IsRenderTargetProjectionMatrixFlipped(RTHandle(screen)));
            cmd.Blit(texture, RenderTargetIdentifier(std::shared_ptr<const Texture>(screen)), ramp,
                     0);
            cmd.DrawMesh(CreatePrimitive(PrimitiveType::Quad), place, onObject);
        },
        RenderPassEvent::AfterRendering + 2);
    Render(true);
    ExpectTexels(SharedDevice().ReadBack(*screen), [](int x, int row)
                 { return x < 3 && row < 7 ? HeightOf(row) : RampAt(HeightOf(row)); });
    ExpectNoValidationMessages();
}

} // namespace
} // namespace limn::test
