#include "features/selection_outline/SelectionRun.h"

#include <gmock/gmock.h>

using namespace limn;
using namespace limn::test;

namespace
{

constexpr int k_Side = 64; // pixels

class SelectionGpu : public GpuTest
{
protected:
    /// Pixels that the outline changes, row by row.
    static std::vector<bool> Changed(SelectionRun& run, double time = 1.0)
    {
        run.request().compile.leavesOut = false; // else the background is rounded otherwise
        run.Enable(false);
        const Image base = run.Output(time);
        run.Enable(true);
        const Image drawn = run.Output(time);
        run.request().compile.leavesOut = true;
        std::vector<bool> changed;
        for (std::size_t i = 0; i < base.texels.size(); i += 4)
        {
            changed.push_back(!std::equal(&base.texels[i], &base.texels[i] + 4, &drawn.texels[i]));
        }
        return changed;
    }
    /// @param x, y  from the middle, y up, as SquareScene places things
    static bool At(const std::vector<bool>& picture, double x, double y)
    {
        const auto column = static_cast<std::size_t>(x + k_Side / 2.0);
        const auto row = static_cast<std::size_t>(k_Side / 2.0 - y);
        return picture.at(row * k_Side + column);
    }
    static auto Count(const std::vector<bool>& picture)
    {
        return std::ranges::count(picture, true);
    }

    SquareScene content{k_Side};
};

} // namespace

// The article's flaw: both are in one texture, so that the small square is inside all around.
TEST_F(SelectionGpu, MeltsWhereSelectedObjectsOverlap)
{
    SelectionRun run(k_Side, k_Side, content.scene, content.camera);
    const auto changed = Changed(run);
    EXPECT_TRUE(At(changed, -21.5, 0.5)) << "beside the large one";
    EXPECT_FALSE(At(changed, -3.5, 0.5)) << "beside the small one, on the large one";
}

TEST_F(SelectionGpu, KeepsTheOutlineOfEachObjectWhereAsked)
{
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_Grouping = OutlineGrouping::PerObject;
    SelectionRun run(k_Side, k_Side, content.scene, content.camera, settings);
    const auto changed = Changed(run);
    EXPECT_TRUE(At(changed, -21.5, 0.5)) << "beside the large one";
    EXPECT_TRUE(At(changed, -3.5, 0.5)) << "beside the small one, on the large one";
    EXPECT_FALSE(At(changed, 4.5, 0.5)) << "inside the small one";

    content.small.transform.localPosition = {19.0f, 0.0f, 5.0f}; // across the border
    const auto across = Changed(run);
    EXPECT_TRUE(At(across, 11.5, 0.5)) << "on the large one";
    EXPECT_TRUE(At(across, 26.5, 0.5)) << "outside of both";
    EXPECT_FALSE(At(across, 23.5, 0.5)) << "inside the small one, beside the large one";
    ExpectNoValidationMessages();
}

TEST_F(SelectionGpu, TakesAWholeHierarchyForOneObjectWhereAsked)
{
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_Grouping = OutlineGrouping::PerGroup;
    SelectionRun run(k_Side, k_Side, content.scene, content.camera, settings);
    EXPECT_TRUE(At(Changed(run), -3.5, 0.5));
    content.small.transform.parent = &content.large.transform;
    content.small.transform.localScale = glm::vec3(0.3f);
    content.small.transform.localPosition = {0.1f, 0.0f, -0.1f};
    const auto changed = Changed(run);
    EXPECT_FALSE(At(changed, -3.5, 0.5));
    EXPECT_TRUE(At(changed, -21.5, 0.5));
}

TEST_F(SelectionGpu, DrawsTheSameByASecondCameraAndItsLayer)
{
    content.large.layer = 6;
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    SelectionRun direct(k_Side, k_Side, content.scene, content.camera, settings);
    settings.m_Stencil = SelectionStencil::HighlightLayer;
    SelectionRun layered(k_Side, k_Side, content.scene, content.camera, settings);
    EXPECT_EQ(layered.Output(1.0), direct.Output(1.0));
    EXPECT_EQ(content.large.layer, 6) << "it is moved back";
    EXPECT_EQ(content.small.layer, 0);
    ExpectNoValidationMessages();
}

TEST_F(SelectionGpu, MovesObjectsBackBeforeWhatIsDrawnNext)
{
    content.small.activeSelf = false;
    content.large.layer = 6;
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_RenderPassEvent = RenderPassEvent::BeforeRenderingOpaques;
    SelectionRun direct(k_Side, k_Side, content.scene, content.camera, settings);
    settings.m_Stencil = SelectionStencil::HighlightLayer;
    SelectionRun layered(k_Side, k_Side, content.scene, content.camera, settings);
    for (SelectionRun* run : {&direct, &layered})
    {
        run->renderer().opaqueLayerMask = LayerMask::FromIndex(6);
    }
    const Image expected = direct.Output(1.0);
    EXPECT_NE(expected.texels, std::vector<std::byte>(expected.texels.size(), expected.texels[0]));
    EXPECT_EQ(layered.Output(1.0), expected);
}

// The flaw that the article names: what is in the layer anyway gets an edge in its own colour, a
// lit gray.
TEST_F(SelectionGpu, GivesAnEdgeToWhatIsInTheReservedLayerAnywayOnlyWhereAsked)
{
    content.large.activeSelf = false;
    content.small.transform.localPosition.x = -16.0f;
    GameObject& other = content.Add("Other", {16.0f, 0.0f, 5.0f}, 12.0f);
    other.layer = 7;
    other.renderer->renderingLayerMask = RenderingLayerMask::FromIndex(0);
    auto gray = std::make_shared<Material>(
        FindBuiltinShader("Universal Render Pipeline/Unlit", Compiler()));
    gray->SetColor(ShaderPropertyId("_BaseColor"), Color{0.5f, 0.5f, 0.5f, 1.0f});
    other.renderer->sharedMaterials = {gray};

    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    settings.m_Stencil = SelectionStencil::HighlightLayer;
    SelectionRun ours(k_Side, k_Side, content.scene, content.camera, settings);
    const auto avoided = Changed(ours);
    EXPECT_TRUE(At(avoided, -23.5, 0.5)) << "beside the selected one";
    EXPECT_FALSE(At(avoided, 23.5, 0.5)) << "beside the other";

    settings.m_OnlySelected = false;
    SelectionRun flawed(k_Side, k_Side, content.scene, content.camera, settings);
    const auto changed = Changed(flawed);
    EXPECT_TRUE(At(changed, -23.5, 0.5));
    EXPECT_TRUE(At(changed, 23.5, 0.5));
    flawed.RenderForReading(1.0);
    const Field blur = flawed.Blur();
    const int x = k_Side / 2 + 23;
    EXPECT_GT(blur.At(x, k_Side / 2, 3), 0.2);
    EXPECT_NEAR(blur.At(x, k_Side / 2, 0), 0.214, 0.005) << "linear";
    EXPECT_EQ(blur.At(x, k_Side / 2, 0), blur.At(x, k_Side / 2, 1));
    EXPECT_EQ(blur.At(x, k_Side / 2, 0), blur.At(x, k_Side / 2, 2));
    ExpectNoValidationMessages();
}

TEST_F(SelectionGpu, ShowsTheColourThatVolumesSetWhereItDoesNotVary)
{
    content.small.activeSelf = false;
    SelectionRun run(k_Side, k_Side, content.scene, content.camera);
    run.component().m_VaryingColor.Override(false);
    run.component().m_OutlineColor.Override(Color{1.0f, 0.5f, 0.0f, 0.8f});
    run.RenderForReading(5.0);
    const Field stencil = run.Stencil();
    const double expected[] = {1.0, 0.21404, 1.0 / 255.0, 0.8}; // linear; no black
    for (int channel = 0; channel < 4; ++channel)
    {
        EXPECT_NEAR(stencil.At(32, 32, channel), expected[channel], 0.51 / 255.0) << channel;
    }
    run.component().m_OutlineColor.Override(Color::black);
    EXPECT_FALSE(At(Changed(run), 0.5, 0.5)) << "what is black is inside as well";
}

// Beside a straight edge seven blurs of offset o leave the upper tails of a binomial distribution.
// Each rounds to 8 bits, by half a step, and hands the steps of those before it on as they are.
TEST_F(SelectionGpu, FadesInFourStepsDownToItsWidth)
{
    content.small.activeSelf = false;
    content.large.transform.localScale = glm::vec3(200.0f);
    content.large.transform.localPosition.x = -120.0f; // to 20 pixels left of the middle
    content.camera.backgroundColor = Color::black;
    SelectionRun run(k_Side, k_Side, content.scene, content.camera);
    run.component().m_VaryingColor.Override(false);
    for (const int offset : {1, 2, 3, 5})
    {
        run.component().m_OutlineWidth.Override(7.0f * static_cast<float>(offset));
        run.RenderForReading(0.0);
        const Field picture = run.CameraColor();
        for (int d = 0; d < 8 * offset; ++d)
        {
            const double tails[] = {64.0, 29.0, 29.0, 8.0, 8.0, 1.0, 1.0, 0.0};
            EXPECT_NEAR(picture.At(12 + d, 32), 3.0 * tails[d / offset] / 128.0, 3.0 * 3.51 / 255.0)
                << d << " pixels beside the edge, offset " << offset;
        }
    }
}

TEST_F(SelectionGpu, DrawsNoLineAlongTheBorderOfThePicture)
{
    content.large.transform.localScale = glm::vec3(100.0f); // more than all of the picture
    SelectionRun run(k_Side, k_Side, content.scene, content.camera);
    EXPECT_EQ(Count(Changed(run)), 0);
    content.small.activeSelf = false;
    content.large.transform.localPosition.x = -40.0f; // to 10 pixels right of the middle
    const auto changed = Changed(run);
    EXPECT_TRUE(At(changed, 11.5, 0.5));
    EXPECT_FALSE(At(changed, -31.5, 31.5));
    EXPECT_FALSE(At(changed, 31.5, 0.5));
}

TEST_F(SelectionGpu, DrawsTheSamePixelsInRegionsOnly)
{
    content.large.activeSelf = false;
    SelectionRun run(k_Side, k_Side, content.scene, content.camera);
    run.component().iterate.Override(1);
    run.component().m_OutlineWidth.Override(3.0f);
    run.request().compile.limitsRegions = false;
    const Image whole = run.Output(0.8);
    run.request().compile.limitsRegions = true;
    EXPECT_EQ(run.Output(0.8), whole);
    int limited = 0;
    for (const CompiledRenderPass& pass : run.Render(0.8).frame->passes)
    {
        for (const PassCommand& command : pass.commands)
        {
            const auto* draw = std::get_if<DrawCommand>(&command);
            limited += draw != nullptr && draw->scissor ? 1 : 0;
        }
    }
    EXPECT_EQ(limited, 4) << "three blurs and the composite";
    ExpectNoValidationMessages();
}

TEST_F(SelectionGpu, SmoothsNothingButDrawsTheSameOverSeveralSamples)
{
    SelectionRun run(k_Side, k_Side, content.scene, content.camera);
    const Image one = run.Output(0.8);
    SelectionOutlineSettings settings = SelectionRun::MakeSettings();
    SelectionRun four(k_Side, k_Side, content.scene, content.camera, settings);
    four.SetSamples(4);
    // Edges of the squares fall between pixels: what is resolved is what one sample gives.
    EXPECT_EQ(four.Output(0.8), one);
    ExpectNoValidationMessages();
}
