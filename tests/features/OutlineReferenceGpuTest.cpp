#include "features/OutlineGpuReference.h"
#include "features/OutlineScene.h"
#include "vulkan/GpuTestDevice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

using namespace limn;
using namespace limn::test;

namespace
{

constexpr double k_Widths[] = {1.0, 1.5, 2.0, 3.0, 3.9, 7.0, 10.0};

/// Independent of Color::linear: IEC 61966-2-1 in double precision.
double DecodeSrgb(double s)
{
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double EncodeSrgb(double linear)
{
    const double l = std::clamp(linear, 0.0, 1.0);
    return l <= 0.0031308 ? l * 12.92 : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
}

/// Renders the outline scene and gives the textures of the last frame by name.
class OutlineRun
{
public:
    OutlineRun(int width, int height, std::shared_ptr<const Shader> shader = OutlineShader())
        : m_Pipeline(SharedDevice())
    {
        ScreenSpaceOutlineSettings settings = Settings();
        settings.m_ScreenSpaceOutlineShader = std::move(shader);
        AddOutline(m_Renderer, settings);
        m_Request.scene = &m_Content.scene;
        m_Request.camera = &m_Content.camera;
        m_Request.width = width;
        m_Request.height = height;
    }

    OutlineScene& content() { return m_Content; }
    void SetSamples(int count) { m_Pipeline.msaaSampleCount = count; }

    void Render(bool enable, const Color& color, double width)
    {
        m_Request.volumeStack = &m_Volumes.With(enable, color, static_cast<float>(width));
        m_Request.alsoReadBack.clear();
        m_Request.compile.leavesOut = false;
        RenderResult result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        m_Request.compile.leavesOut = true;
        // The textures are known only now; the second frame keeps them readable.
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            const RTHandle handle(pass.colors.front().texture);
            if (handle != result.output && !Contains(handle))
            {
                m_Request.alsoReadBack.push_back(handle);
            }
        }
        m_Result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
    }

    Image Output() { return ReadRows(*m_Result.output.rt()); }

    Field Texture(const std::string& name)
    {
        for (const RTHandle& handle : m_Request.alsoReadBack)
        {
            if (handle.rt()->name() == name)
            {
                return ToField(ReadRows(*handle.rt()));
            }
        }
        throw std::runtime_error("no texture " + name + " in the frame");
    }

private:
    bool Contains(const RTHandle& handle) const
    {
        return std::find(m_Request.alsoReadBack.begin(), m_Request.alsoReadBack.end(), handle) !=
               m_Request.alsoReadBack.end();
    }

    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
    OutlineScene m_Content;
    BlendedOutline m_Volumes;
    RenderRequest m_Request;
    RenderResult m_Result;
};

class OutlineAtSizeGpu : public GpuTest, public testing::WithParamInterface<std::pair<int, int>>
{
};

/// @param leastShare  of the edges' texels that are within 1/255
void ExpectReference(OutlineRun& run, double leastShare = 0.999)
{
    const Color color{0.1f, 0.8f, 0.3f, 1.0f};
    run.Render(false, color, 3.0);
    const Field base = run.Texture("_CameraColorAttachmentA");
    double edgeShare = 0.0; // over all widths: lavapipe filters with 8-bit weights, see below
    for (const double outlineWidth : k_Widths)
    {
        SCOPED_TRACE("outline width " + std::to_string(outlineWidth));
        run.Render(true, color, outlineWidth);

        const Field mask = run.Texture("_RendererDrawingTexture");
        const Field edge = QuantiseToR8(RobertsReference(mask, outlineWidth));
        const Difference edges = Compare(run.Texture("_OutlineTexture"), edge);
        EXPECT_LE(edges.largest, 2.0);
        edgeShare += edges.shareWithinOne / std::size(k_Widths);

        const Field expected = CompositeReference(
            base, edge, {DecodeSrgb(color.r), DecodeSrgb(color.g), DecodeSrgb(color.b)});
        const Difference composite = Compare(run.Texture("_CameraColorAttachmentA"), expected);
        EXPECT_LE(composite.largest, 2.0);
        EXPECT_GE(composite.shareWithinOne, 0.999);
    }
    // At 64x64 and width 10 two of 1024 texels are 2/255 off: all taps fall between texels there,
    // and the four reads of a tap are rounded one after the other.
    EXPECT_GE(edgeShare, leastShare);
}

TEST_P(OutlineAtSizeGpu, AgreesWithTheDoublePrecisionReferenceForEveryWidth)
{
    OutlineRun run(GetParam().first, GetParam().second);
    ExpectReference(run);
    ExpectNoValidationMessages();
}

INSTANTIATE_TEST_SUITE_P(Sizes, OutlineAtSizeGpu,
                         testing::Values(std::pair(1280, 720), std::pair(641, 359),
                                         std::pair(64, 64), std::pair(2, 2), std::pair(1, 1)),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

class OutlineGpu : public GpuTest
{
};

TEST_F(OutlineGpu, WritesTheCameraColourAsSrgbToTheOutput)
{
    OutlineRun run(64, 48);
    run.Render(true, Color::green, 4.0);
    const Field linear = run.Texture("_CameraColorAttachmentA");
    const Image output = run.Output();
    ASSERT_EQ(output.format, GraphicsFormat::R8G8B8A8_SRGB);
    for (std::size_t i = 0; i < output.texels.size(); ++i)
    {
        if (i % 4 != 3)
        {
            EXPECT_NEAR(std::to_integer<int>(output.texels[i]),
                        EncodeSrgb(linear.values[i]) * 255.0, 1.0);
        }
    }
    ExpectNoValidationMessages();
}

// As in Unity: the pass takes its textures from the camera's descriptor, samples included.
TEST_F(OutlineGpu, AgreesWithTheReferenceForACameraOfFourSamplesAndSmoothsItsMask)
{
    OutlineRun run(320, 180);
    run.SetSamples(4);
    ExpectReference(run, 0.998); // taps of parts of the mask are rounded, those of 0 and 1 are not
    int partly = 0;
    for (const double value : run.Texture("_RendererDrawingTexture").values)
    {
        EXPECT_NEAR(value * 4.0, std::round(value * 4.0), 4.0 * 0.5 / 255.0) << "whole samples";
        partly += value > 0.1 && value < 0.9 ? 1 : 0;
    }
    EXPECT_GT(partly, 50) << "texels at the edges";
    ExpectNoValidationMessages();
}

TEST_F(OutlineGpu, MasksExactlyTheTexelsWhoseCentresAQuadCovers)
{
    OutlineRun run(64, 64);
    Scene& scene = run.content().scene;
    for (const auto& object : scene.objects())
    {
        object->activeSelf = false;
    }
    const auto material = std::make_shared<const Material>(
        FindBuiltinShader("Universal Render Pipeline/Unlit", Compiler()));
    run.content().Add("Quad", PrimitiveType::Quad, {1.0f, -0.5f, 0.0f}, material, true);
    run.content().Add("In front", PrimitiveType::Quad, {1.0f, -0.5f, -1.0f}, material, false);
    Camera& camera = run.content().camera;
    camera.orthographic = true;
    camera.orthographicSize = 2.0f; // the picture shows x and y from -2 to 2; a mask texel is 1/8
    run.Render(true, Color::green, 4.0);
    const Field mask = run.Texture("_RendererDrawingTexture");
    ASSERT_EQ(mask.width, 32);
    for (int y = 0; y < 32; ++y)
    {
        for (int x = 0; x < 32; ++x)
        {
            const double worldX = -2.0 + (x + 0.5) / 8.0;
            const double worldY = -2.0 + (y + 0.5) / 8.0; // the bottom row first
            const bool inside = worldX > 0.5 && worldX < 1.5 && worldY > -1.0 && worldY < 0.0;
            EXPECT_EQ(mask.At(x, y), inside ? 1.0 : 0.0) << x << ", " << y;
        }
    }
    ExpectNoValidationMessages();
}

TEST_F(OutlineGpu, ChangesNoPixelFartherFromTheSelectionThanItsWidth)
{
    OutlineRun run(128, 96);
    run.Render(false, Color::green, 10.0);
    const Field before = run.Texture("_CameraColorAttachmentA");
    run.Render(true, Color::green, 10.0);
    const Field after = run.Texture("_CameraColorAttachmentA");
    const Field mask = run.Texture("_RendererDrawingTexture");
    int changed = 0;
    for (int y = 0; y < before.height; ++y)
    {
        for (int x = 0; x < before.width; ++x)
        {
            if (before.At(x, y, 1) == after.At(x, y, 1))
            {
                continue;
            }
            ++changed;
            // Half the width in mask texels, one for each of the two bilinear reads.
            bool near = false;
            for (int dy = -5; dy <= 5; ++dy)
            {
                for (int dx = -5; dx <= 5; ++dx)
                {
                    const int mx = std::clamp(x / 2 + dx, 0, mask.width - 1);
                    const int my = std::clamp(y / 2 + dy, 0, mask.height - 1);
                    near = near || mask.At(mx, my) > 0.0;
                }
            }
            EXPECT_TRUE(near) << x << ", " << y;
        }
    }
    EXPECT_GT(changed, 100);
}

TEST_F(OutlineGpu, GivesTheSamePixelsWithTheArticlesShader)
{
    const char* corpus = std::getenv("LIMN_CORPUS_DIR");
    const std::filesystem::path path =
        std::filesystem::path(corpus != nullptr ? corpus : "") / "s0_ScreenSpaceOutline.shader";
    if (!std::filesystem::exists(path))
    {
        GTEST_SKIP() << "LIMN_CORPUS_DIR names no folder with s0_ScreenSpaceOutline.shader";
    }
    for (const double width : k_Widths)
    {
        OutlineRun ours(320, 180);
        ours.Render(true, Color{0.0f, 0.5f, 1.0f, 1.0f}, width);
        OutlineRun theirs(320, 180, Shader::Load(path, Compiler()));
        theirs.Render(true, Color{0.0f, 0.5f, 1.0f, 1.0f}, width);
        EXPECT_EQ(ours.Output(), theirs.Output()) << "outline width " << width;
    }
    ExpectNoValidationMessages();
}

} // namespace
