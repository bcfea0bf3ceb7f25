#include "features/OutlineGpuReference.h"
#include "vulkan/GpuTestDevice.h"

#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/FullScreenPassRendererFeature.h>

#include "core/scene/TestScene.h"

namespace limn::test
{
namespace
{

constexpr int k_PictureSide = 32;
/// Where four samples are in a pixel, from its left top, as Vulkan and D3D have them.
constexpr glm::dvec2 k_SamplePlaces[] = {
    {0.375, 0.875}, {0.875, 0.625}, {0.125, 0.375}, {0.625, 0.125}};

/// A square before a camera that sees 2 m of black, in linear colour.
class MultisampledCameraGpu : public GpuTest
{
protected:
    MultisampledCameraGpu()
    {
        m_Camera.transform.localPosition = {0.0f, 0.0f, -2.0f};
        m_Camera.orthographic = true;
        m_Camera.orthographicSize = 1.0f;
        m_Camera.backgroundColor = Color::black;
        m_Request.scene = &m_Scene;
        m_Request.camera = &m_Camera;
        m_Request.width = k_PictureSide;
        m_Request.height = k_PictureSide;
        m_Pipeline.msaaSampleCount = 4;
    }

    struct Pictures
    {
        Image all;
        Image lean;
    };
    /// The picture with nothing left out, in two passes, and straight into the output, in one.
    Pictures DrawBothWays()
    {
        m_Request.compile.leavesOut = false;
        const RenderResult all = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        EXPECT_EQ(all.frame->passes.size(), 2u);
        Pictures pictures;
        pictures.all = SharedDevice().ReadBack(*all.output.rt());
        m_Request.compile.leavesOut = true;
        const RenderResult lean = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        EXPECT_EQ(lean.frame->passes.size(), 1u);
        pictures.lean = SharedDevice().ReadBack(*lean.output.rt());
        return pictures;
    }

    /// @param state   of the pass
    /// @param result  of the fragment function; p is its SV_POSITION
    void AddSquare(const std::string& state, const std::string& result, float degrees, float side,
                   int queue = 2000)
    {
        const auto material = std::make_shared<Material>(
            ShaderOf("Shader \"Test/Square\" { SubShader { Pass { Tags { \"LightMode\" = "
                     "\"UniversalForward\" } " +
                     state +
                     "\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n#include "
                     "\"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
                     "float4 Vert(float4 p : POSITION) : SV_POSITION "
                     "{ return TransformObjectToHClip(p.xyz); }\n"
                     "float4 Frag(float4 p : SV_POSITION) : SV_Target { return " +
                     result + "; }\nENDHLSL\n} } }"));
        material->SetRenderQueue(queue);
        GameObject& square = m_Scene.Add("square");
        square.transform.localRotation = EulerToRotation({0.0f, 0.0f, degrees});
        square.transform.localScale = glm::vec3(side);
        square.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Quad), {material}};
    }

    /// The camera's colour before it goes to the output.
    Field Draw()
    {
        m_Request.alsoReadBack.clear();
        m_Request.compile.leavesOut = false;
        const RenderResult first = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        m_Request.compile.leavesOut = true;
        m_Request.alsoReadBack = {RTHandle(first.frame->passes.at(0).colors.at(0).texture)};
        m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        return ToField(SharedDevice().ReadBack(*m_Request.alsoReadBack.at(0).rt()));
    }

    Scene m_Scene;
    Camera m_Camera;
    UniversalRenderer m_Renderer{Compiler()};
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
    RenderRequest m_Request;
};

TEST_F(MultisampledCameraGpu, ShowsOfAPixelThePartOfItsSamplesThatIsCovered)
{
    constexpr double k_Turned = -20.0;
    constexpr float k_HalfSide = 0.55f;
    AddSquare("", "1", k_Turned, 2.0f * k_HalfSide);
    const Field picture = Draw();
    const double angle = glm::radians(k_Turned);
    int partly = 0;
    for (int y = 0; y < k_PictureSide; ++y)
    {
        for (int x = 0; x < k_PictureSide; ++x)
        {
            int covered = 0;
            bool isClear = true; // no sample is so near to an edge that rounding decides
            for (const glm::dvec2& sample : k_SamplePlaces)
            {
                const glm::dvec2 at = (glm::dvec2(x, y) + sample) * (2.0 / k_PictureSide) - 1.0;
                const double u = std::abs(at.x * std::cos(angle) - at.y * std::sin(angle));
                const double v = std::abs(at.x * std::sin(angle) + at.y * std::cos(angle));
                const double inside = static_cast<double>(k_HalfSide) - std::max(u, v);
                covered += inside > 0.0 ? 1 : 0;
                isClear = isClear && std::abs(inside) * k_PictureSide / 2.0 > 0.02;
            }
            if (isClear)
            {
                ASSERT_EQ(picture.At(x, y, 0), covered / 4.0) << x << ", " << y;
                partly += covered % 4 != 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(partly, 40) << "pixels at the edges";
    ExpectNoValidationMessages();
}

TEST_F(MultisampledCameraGpu, CoversAsManySamplesAsAlphaSaysWithAlphaToMask)
{
    AddSquare("AlphaToMask On", "float4(1, 1, 1, (floor(p.x) + 0.5) / 32)", 0.0f, 2.0f);
    const Field picture = Draw();
    const bool isLavapipe = SharedDevice().deviceName().find("llvmpipe") != std::string::npos;
    for (int x = 0; x < k_PictureSide; ++x)
    {
        const double alpha = (x + 0.5) / k_PictureSide;
        const double shown = picture.At(x, k_PictureSide / 2, 0);
        EXPECT_EQ(shown * 4.0, std::round(shown * 4.0)) << "whole samples";
        EXPECT_LT(std::abs(shown - alpha), isLavapipe ? 0.25 : 0.5);
        if (isLavapipe) // how many samples an alpha stands for is each driver's own
        {
            EXPECT_EQ(shown, std::ceil(alpha * 4.0) / 4.0) << "alpha " << alpha;
        }
    }
}

TEST_F(MultisampledCameraGpu, TellsOpaqueShadersThatAlphaToMaskWorks)
{
    const auto shown = [this](int queue, int samples)
    {
        m_Scene = Scene();
        AddSquare("", "float4(_AlphaToMaskAvailable, 0, 0, 1)", 0.0f, 2.0f, queue);
        m_Pipeline.msaaSampleCount = samples;
        return Draw().At(k_PictureSide / 2, k_PictureSide / 2, 0);
    };
    EXPECT_EQ(shown(2000, 4), 1.0);
    EXPECT_EQ(shown(3000, 4), 0.0);
    EXPECT_EQ(shown(2000, 1), 0.0);
}

TEST_F(MultisampledCameraGpu, GivesFullScreenPassesTheAverageOfTheSamples)
{
    AddSquare("", "float4(1, 0.5, 0.25, 1)", 20.0f, 1.1f);
    const Field before = Draw();
    auto feature = std::make_unique<FullScreenPassRendererFeature>();
    feature->passMaterial = std::make_shared<Material>(ShaderOf(
        "Shader \"Test/Swap\" { SubShader { Pass { ZTest Always ZWrite Off Cull Off\n"
        "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "#include \"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n"
        "float4 Frag(Varyings input) : SV_Target { return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, "
        "sampler_PointClamp, input.texcoord, 0).bgra; }\nENDHLSL\n} } }"));
    m_Renderer.AddFeature(std::move(feature));
    const Field after = Draw();
    for (int y = 0; y < k_PictureSide; ++y)
    {
        for (int x = 0; x < k_PictureSide; ++x)
        {
            ASSERT_EQ(after.At(x, y, 0), before.At(x, y, 2)) << x << ", " << y;
            ASSERT_EQ(after.At(x, y, 2), before.At(x, y, 0)) << x << ", " << y;
        }
    }
    ExpectNoValidationMessages();
}

TEST_F(MultisampledCameraGpu, IsDrawnStraightIntoAnOutputThatHoldsTheSame)
{
    m_Camera.allowHDR = false;
    m_Camera.backgroundColor = {0.2f, 0.4f, 0.6f, 0.0f};
    AddSquare("", "float4(1, 0.5, 0.25, 0)", 20.0f, 1.1f);
    AddSquare("Blend SrcAlpha OneMinusSrcAlpha", "float4(0.3, 0.9, 0.1, 0.37)", 50.0f, 0.9f, 3000);
    for (const int samples : {1, 4})
    {
        m_Pipeline.msaaSampleCount = samples;
        const auto [all, lean] = DrawBothWays();
        EXPECT_EQ(lean, all) << samples;
    }
    ExpectNoValidationMessages();
}

/// The most that a byte of two pictures differs by.
int LargestDifference(const Image& a, const Image& b)
{
    int largest = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
    {
        largest = std::max(largest, std::abs(std::to_integer<int>(a.texels[i]) -
                                             std::to_integer<int>(b.texels.at(i))));
    }
    return largest;
}

// Half floats have 11 bits, so that what goes through them may be rounded to the next of 255 steps.
TEST_F(MultisampledCameraGpu, IsDrawnStraightIntoAnOutputWithinOneStepWhereNoColourIsBlended)
{
    m_Pipeline.msaaSampleCount = 1;
    m_Camera.backgroundColor = {0.2f, 0.4f, 0.6f, 0.0f};
    AddSquare("", "float4(p.x / 16, -p.y / 64, p.x * p.y / 1024, 0.3)", 20.0f, 1.3f);
    AddSquare("ZTest Always ColorMask RG", "float4(p.y / 77, 3, 0.5, 1)", 50.0f, 0.9f, 2001);
    AddSquare("ZTest Always ColorMask B Blend One Zero, One One", "float4(0, 0, p.x / 31, 0.2)",
              0.0f, 0.6f, 2002);
    const auto [all, lean] = DrawBothWays();
    EXPECT_LE(LargestDifference(lean, all), 1);
    ExpectNoValidationMessages();
}

// Values above 1 are why the camera's own colour has to stay: half of 5 is white, and so is a pixel
// of which one sample in four is 5; of what an output holds of them, 1, it would be grey.
TEST_F(MultisampledCameraGpu, KeepsWhatIsBrighterThanAnOutputHoldsToBlendAndToResolve)
{
    AddSquare("", "float4(5, 5, 5, 1)", 20.0f, 1.1f);
    for (const int samples : {4, 1})
    {
        if (samples == 1)
        {
            AddSquare("ZTest Always Blend SrcAlpha OneMinusSrcAlpha", "float4(0, 0, 0, 0.5)", 20.0f,
                      1.1f, 3000);
        }
        m_Pipeline.msaaSampleCount = samples;
        const RenderResult result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        EXPECT_GE(result.frame->passes.size(), 2u);
        const Image image = SharedDevice().ReadBack(*result.output.rt());
        std::size_t white = 0;
        for (std::size_t i = 0; i < image.texels.size(); i += 4)
        {
            const int red = std::to_integer<int>(image.texels[i]);
            EXPECT_TRUE(red == 0 || red == 255) << red << " at " << i / 4 << ", " << samples;
            white += red == 255 ? 1 : 0;
        }
        EXPECT_GT(white, 100u);
    }
    ExpectNoValidationMessages();
}

// Steps of 8 bits, as colours are written; between two of them the copy is drawn.
TEST_F(MultisampledCameraGpu, OfNothingIsTheBackgroundThatACopyWouldShow)
{
    const auto step = [](int r, int g, int b)
    {
        return Color(static_cast<float>(r) / 255.0f, static_cast<float>(g) / 255.0f,
                     static_cast<float>(b) / 255.0f, 0.4f);
    };
    for (const Color& background : {step(0, 0, 0), step(255, 1, 254), step(49, 77, 121),
                                    step(11, 12, 187), Color(0.0031f, 0.7071f, 0.9999f)})
    {
        for (const bool isHdr : {true, false})
        {
            m_Camera.allowHDR = isHdr;
            m_Camera.backgroundColor = background;
            const auto [all, lean] = DrawBothWays();
            EXPECT_EQ(lean.texels, all.texels) << background.g << ", " << isHdr;
        }
    }
    ExpectNoValidationMessages();
}

// Between two steps the device decides; some of these are a little more or less than the middle.
TEST_F(MultisampledCameraGpu, OfNothingIsTheSameBetweenTwoSteps)
{
    for (const float step : {0.1f, 0.3f, 0.5f, 0.7f, 0.9f})
    {
        m_Camera.backgroundColor = {step, step, step};
        m_Request.compile.leavesOut = false;
        const RenderResult all = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        const Image expected = SharedDevice().ReadBack(*all.output.rt());
        m_Request.compile.leavesOut = true;
        const RenderResult lean = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        EXPECT_EQ(SharedDevice().ReadBack(*lean.output.rt()).texels, expected.texels) << step;
        EXPECT_EQ(lean.frame->passes.at(0).colors.at(0).texture->descriptor().msaaSamples, 1);
    }
    ExpectNoValidationMessages();
}

/// What the precision of the camera's colour changes of a picture, in steps of 8 bits.
TEST_F(MultisampledCameraGpu, DiffersIn32BitsByWhatTheyRound)
{
    constexpr auto k_Format = GraphicsFormat::B10G11R11_UFloatPack32;
    if (!SharedDevice().IsFormatSupported(k_Format, FormatUsage::Blend))
    {
        GTEST_SKIP() << "the device does not blend " << ToString(k_Format);
    }
    AddSquare("", "float4(p.x / 32, p.y / 32, p.x * p.y / 1024, 1)", 20.0f, 1.8f);
    const auto draw = [this](HDRColorBufferPrecision precision)
    {
        m_Pipeline.hdrColorBufferPrecision = precision;
        const RenderResult result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        const auto& color = result.frame->passes.at(0).colors.at(0);
        EXPECT_EQ(color.texture->graphicsFormat() == k_Format,
                  precision == HDRColorBufferPrecision::_32Bits);
        return SharedDevice().ReadBack(*result.output.rt());
    };
    const Image exact = draw(HDRColorBufferPrecision::_64Bits);
    const Image coarse = draw(HDRColorBufferPrecision::_32Bits);
    std::array<int, 3> largest{};
    double sum = 0.0;
    for (std::size_t i = 0; i < exact.texels.size(); ++i)
    {
        const int error = std::abs(std::to_integer<int>(exact.texels[i]) -
                                   std::to_integer<int>(coarse.texels[i]));
        if (i % 4 != 3)
        {
            largest[i % 4] = std::max(largest[i % 4], error);
            sum += error;
        }
    }
    RecordProperty("mean",
                   std::to_string(sum * 4.0 / 3.0 / static_cast<double>(exact.texels.size())));
    // Red and green have 6 bits behind the first one, blue 5, so that a device that cuts the rest
    // off loses up to a 64th and a 32nd: of 255 steps of sRGB 1.8 and 3.5, and the rounding of
    // both.
    EXPECT_LE(largest[0], 2);
    EXPECT_LE(largest[1], 2);
    EXPECT_LE(largest[2], 4);
    EXPECT_GT(sum, 0.0) << "they are not the same picture";
    ExpectNoValidationMessages();
}

} // namespace
} // namespace limn::test
