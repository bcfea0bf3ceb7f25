#include "Mentions.h"
#include "features/RecordingFeature.h"
#include "features/color_edges/PictureRun.h"
#include "vulkan/GpuTestFrame.h"

#include <functional>
#include <gmock/gmock.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/UniversalFrameData.h>

namespace limn::test
{
namespace
{

constexpr int k_TestedWidth = 8;
constexpr int k_TestedHeight = 6;
constexpr float k_BlitDepth = 8.0f; ///< metres: where blits that test the depth lie

/// A pass's render state, and where in the picture it lets a white blit through.
struct TestedState
{
    const char* state;
    bool (*passes)(bool isStencilOne, float depth);
};
const TestedState k_TestedStates[] = {{"ZTest Always Stencil { Ref 1 Comp Equal }",
                                       [](bool one, float)
                                       {
                                           return one;
                                       }},
                                      {"ZTest Always Stencil { Ref 1 Comp NotEqual }",
                                       [](bool one, float)
                                       {
                                           return !one;
                                       }},
                                      {"ZTest LEqual",
                                       [](bool, float depth)
                                       {
                                           return k_BlitDepth <= depth;
                                       }},
                                      {"ZTest Greater", [](bool, float depth)
                                       {
                                           return k_BlitDepth > depth;
                                       }}};

/// How a feature draws over the camera's colour and depth.
enum class BlitStyle
{
    CameraTarget,   ///< cmd.Blit(source, BuiltinRenderTextureType.CameraTarget)
    CurrentActive,  ///< SetRenderTarget, then cmd.Blit(source, CurrentActive)
    OldColorTarget, ///< cmd.Blit(source, renderer.cameraColorTarget) of URP 7 to 10
    Handles,        ///< CoreUtils.SetRenderTarget and Blitter.BlitTexture of URP 14
    Graph           ///< a raster pass of Unity 6
};

/// The orthographic camera's: 1 m is at 1, 11 m at 0.
constexpr auto k_ToDepth = "o.positionCS.z = o.positionCS.w * (11.0 - 8.0) / 10.0;";

std::shared_ptr<Material> OldBlit(const std::string& state)
{
    return std::make_shared<Material>(ShaderOf(
        "Shader \"Test/OldBlit\" { Properties { _MainTex (\"\", 2D) = \"white\" {} }\n"
        "SubShader { Pass { ZWrite Off Cull Off " +
        state +
        "\nCGPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n#include \"UnityCG.cginc\"\n"
        "struct v2f { float4 positionCS : SV_POSITION; };\n"
        "v2f vert(appdata_img v) { v2f o; o.positionCS = UnityObjectToClipPos(v.vertex); " +
        k_ToDepth + " return o; }\nfloat4 frag() : SV_Target { return 1; }\nENDCG\n} } }"));
}

std::shared_ptr<Material> NewBlit(const std::string& state)
{
    return std::make_shared<Material>(ShaderOf(
        "Shader \"Test/NewBlit\" { SubShader { Pass { ZWrite Off Cull Off " + state +
        "\nHLSLPROGRAM\n#pragma vertex VertAtDepth\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "#include \"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n"
        "Varyings VertAtDepth(Attributes i) { Varyings o = Vert(i); " +
        k_ToDepth + " return o; }\nfloat4 Frag() : SV_Target { return 1; }\nENDHLSL\n} } }"));
}

/// A material that leaves 1 in the stencil.
std::shared_ptr<Material> Marking()
{
    return std::make_shared<Material>(ShaderOf(
        "Shader \"Test/Marking\" { SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" "
        "} Stencil { Ref 1 Pass Replace }\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment "
        "Frag\n#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "float4 Vert(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }\n"
        "float4 Frag() : SV_Target { return float4(0.25, 0.25, 0.25, 1); }\nENDHLSL\n} } }"));
}

/// Left of the picture a rectangle at 5 m that marks the stencil, right a plain one at 9 m, below
/// both the background.
class DepthOfTargetGpu : public GpuTest
{
protected:
    DepthOfTargetGpu() : m_Flat(k_TestedWidth, k_TestedHeight)
    {
        m_Flat.Add({0, 0}, {3, 4}, 5.0f, Marking());
        m_Flat.Add({3, 0}, {k_TestedWidth, 4}, 9.0f, Plain({0.25f, 0.25f, 0.25f}));
    }

    static bool IsMarked(int x, int row) { return x < 3 && row < 4; }
    static float DepthAt(int x, int row) { return row >= 4 ? 11.0f : x < 3 ? 5.0f : 9.0f; }

    static std::unique_ptr<ScriptableRendererFeature> Make(BlitStyle style,
                                                           const std::string& state)
    {
        constexpr auto k_Event = RenderPassEvent::AfterRenderingTransparents;
        const auto white = RenderTargetIdentifier(DefaultTexture("white"));
        if (style == BlitStyle::Graph)
        {
            return std::make_unique<GraphRecordingFeature>(
                k_Event, [material = NewBlit(state)](RenderGraph& graph, ContextContainer& data)
                { RecordGraph(graph, data, material); });
        }
        if (style == BlitStyle::Handles)
        {
            return std::make_unique<RecordingFeature>(
                k_Event,
                [material = NewBlit(state)](CommandBuffer& cmd, RenderingData& data)
                {
                    ScriptableRenderer& renderer = *data.cameraData.renderer;
                    CoreUtils::SetRenderTarget(cmd, renderer.cameraColorTargetHandle(),
                                               renderer.cameraDepthTargetHandle());
                    Blitter::BlitTexture(cmd, {1, 1, 0, 0}, material, 0);
                });
        }
        return std::make_unique<RecordingFeature>(
            k_Event,
            [=, material = OldBlit(state)](CommandBuffer& cmd, RenderingData& data)
            {
                if (style == BlitStyle::CameraTarget)
                {
                    cmd.Blit(white, BuiltinRenderTextureType::CameraTarget, material, 0);
                }
                else if (style == BlitStyle::OldColorTarget)
                {
                    cmd.Blit(white, data.cameraData.renderer->cameraColorTarget(), material, 0);
                }
                else
                {
                    cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
                    cmd.Blit(white, BuiltinRenderTextureType::CurrentActive, material, 0);
                }
            });
    }

    static void RecordGraph(RenderGraph& graph, ContextContainer& frameData,
                            const std::shared_ptr<const Material>& material)
    {
        struct PassData
        {
        };
        const auto& resources = frameData.Get<UniversalResourceData>();
        PassData* data = nullptr;
        auto builder = graph.AddRasterRenderPass<PassData>("Tested blit", data);
        builder.SetRenderAttachment(resources.activeColorTexture(), 0);
        builder.SetRenderAttachmentDepth(resources.activeDepthTexture(), AccessFlags::Read);
        builder.SetRenderFunc(
            [material](PassData&, RasterGraphContext& context) {
                Blitter::BlitTexture(context.cmd, {1, 1, 0, 0}, material, 0);
            });
    }

    Image Draw(BlitStyle style, const std::string& state, int version, bool leavesOut)
    {
        UniversalRenderPipeline pipeline(SharedDevice());
        pipeline.pipelineVersion = version;
        UniversalRenderer renderer(Compiler());
        renderer.AddFeature(Make(style, state));
        RenderRequest request;
        request.scene = &m_Flat.scene;
        request.camera = &m_Flat.camera;
        request.width = k_TestedWidth;
        request.height = k_TestedHeight;
        request.compile.leavesOut = leavesOut;
        const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
        m_Notes = result.report.notes;
        return SharedDevice().ReadBack(*result.output.rt());
    }

    FlatScene m_Flat;
    std::vector<std::string> m_Notes; ///< of the last Draw
};

TEST_F(DepthOfTargetGpu, ABlitTestsDepthAndStencilOfTheCameraInEveryStyle)
{
    for (const TestedState& tested : k_TestedStates)
    {
        std::optional<Image> first;
        for (const BlitStyle style :
             {BlitStyle::CameraTarget, BlitStyle::CurrentActive, BlitStyle::OldColorTarget,
              BlitStyle::Handles, BlitStyle::Graph})
        {
            for (const bool leavesOut : {false, true})
            {
                SCOPED_TRACE(std::string(tested.state) + ", style " +
                             std::to_string(static_cast<int>(style)));
                const int version = style == BlitStyle::OldColorTarget ? 10 : 14;
                const Image picture = Draw(style, tested.state, version, leavesOut);
                for (int row = 0; row < k_TestedHeight; ++row)
                {
                    for (int x = 0; x < k_TestedWidth; ++x)
                    {
                        const bool isWhite = tested.passes(IsMarked(x, row), DepthAt(x, row));
                        ASSERT_EQ(Texel8(picture, x, row)[0] == 255, isWhite)
                            << x << ", row " << row;
                    }
                }
                EXPECT_THAT(m_Notes, testing::IsEmpty());
                first = first ? first : picture;
                EXPECT_EQ(picture.texels, first->texels);
            }
        }
    }
    ExpectNoValidationMessages();
}

/// As in URP 12 and later, whose colour is made without a depth.
TEST_F(DepthOfTargetGpu, TheCamerasColourAloneHasNoDepthAndTheReportSaysSo)
{
    const Image picture =
        Draw(BlitStyle::OldColorTarget, "ZTest Always Stencil { Ref 1 Comp Equal }", 14, true);
    for (int row = 0; row < k_TestedHeight; ++row)
    {
        EXPECT_EQ(Texel8(picture, 7, row)[0], 255);
    }
    ASSERT_EQ(m_Notes.size(), 1u);
    EXPECT_THAT(m_Notes[0],
                Mentions("Blit: pass 0", "'Test/OldBlit'", "stencil", "'_CameraColorAttachmentA'",
                         "BuiltinRenderTextureType::CameraTarget", "depthBufferBits",
                         "CurrentActive", "pipelineVersion"));
}

/// Marks the stencil of a temporary texture by drawing a quad over its left half, then blits where
/// it is marked.
TEST_F(DepthOfTargetGpu, ATemporaryTextureMadeWithDepthBitsHasBoth)
{
    for (const int bits : {24, 0})
    {
        UniversalRenderPipeline pipeline(SharedDevice());
        UniversalRenderer renderer(Compiler());
        FlatScene left(k_TestedWidth, k_TestedHeight);
        const glm::mat4 place =
            left.Add({0, 0}, {4, k_TestedHeight}, 5.0f, nullptr).transform.localToWorldMatrix();
        renderer.AddFeature(std::make_unique<RecordingFeature>(
            RenderPassEvent::AfterRenderingTransparents,
            [&, marking = Marking(), blit = OldBlit("ZTest Always Stencil { Ref 1 Comp Equal }")](
                CommandBuffer& cmd, RenderingData&)
            {
                const ShaderPropertyId _Temp{"_Temp"};
                cmd.GetTemporaryRT(_Temp, k_TestedWidth, k_TestedHeight, bits);
                cmd.SetRenderTarget(_Temp);
                cmd.ClearRenderTarget(true, true, Color::black);
                cmd.DrawMesh(CreatePrimitive(PrimitiveType::Quad), place, marking);
                cmd.Blit(RenderTargetIdentifier(DefaultTexture("white")), _Temp, blit, 0);
                cmd.Blit(_Temp, BuiltinRenderTextureType::CameraTarget);
                cmd.ReleaseTemporaryRT(_Temp);
            }));
        RenderRequest request;
        request.scene = &m_Flat.scene;
        request.camera = &m_Flat.camera;
        request.width = k_TestedWidth;
        request.height = k_TestedHeight;
        const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
        const Image picture = SharedDevice().ReadBack(*result.output.rt());
        for (int x = 0; x < k_TestedWidth; ++x)
        {
            EXPECT_EQ(Texel8(picture, x, 5)[0], bits == 0 || x < 4 ? 255 : 0) << x << ", " << bits;
        }
        EXPECT_EQ(result.report.notes.size(), bits == 0 ? 1u : 0u);
    }
    ExpectNoValidationMessages();
}

} // namespace
} // namespace limn::test
