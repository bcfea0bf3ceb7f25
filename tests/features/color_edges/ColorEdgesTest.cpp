#include "Mentions.h"
#include "features/OutlineScene.h"
#include "features/color_edges/FlatPicture.h"
#include "features/outline/TechniqueFrame.h"

#include <gmock/gmock.h>
#include <limn/features/ColorEdgesRendererFeature.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

class ColorEdgesFrame
    : public TechniqueFrame<ColorEdgesRendererFeature, ColorEdgesSettings, ColorEdges, OutlineScene>
{
protected:
    ColorEdgesFrame() : TechniqueFrame("Edges") { m_LeavesOut = false; }
};

void Nothing(ColorEdges&) {}

TEST_F(ColorEdgesFrame, HasThePictureReadAsBrightnessAndLinesDrawnOverIt)
{
    const RenderResult result = Render(Nothing);
    EXPECT_THAT(TargetsOf(result), ElementsAre("_CameraColorAttachmentA", "_ColorEdgesBrightness",
                                               "_CameraColorAttachmentA", "limn_Output"));
    EXPECT_THAT(result.report.notes, IsEmpty());
    EXPECT_EQ(result.frame->passes[1].width, 64);
    EXPECT_EQ(result.frame->passes[1].height, 48);
}

TEST_F(ColorEdgesFrame, HasAMaskWhereLinesAreLimitedToObjects)
{
    m_Settings.m_OnlyFilteredObjects = true;
    const RenderResult result = Render(Nothing);
    EXPECT_THAT(TargetsOf(result),
                ElementsAre("_CameraColorAttachmentA", "_ColorEdgesMask", "_ColorEdgesBrightness",
                            "_CameraColorAttachmentA", "limn_Output"));
    EXPECT_TRUE(result.frame->passes[1].depth) << "what hides an object hides its lines";
}

TEST_F(ColorEdgesFrame, TakesThePictureBeforeTransparentObjectsWhereAsked)
{
    m_Settings.m_RenderPassEvent = RenderPassEvent::AfterRenderingOpaques;
    std::vector<std::string> names;
    for (const ExecutedPassReport& pass : Render(Nothing).report.passes)
    {
        names.push_back(pass.name.name());
    }
    EXPECT_THAT(names, ElementsAre("Draw Opaque Objects", "Edges", "Draw Transparent Objects",
                                   "Final Blit"));
}

TEST_F(ColorEdgesFrame, HasOneInstancedDrawForEachMeshInTheMask)
{
    m_Settings.m_OnlyFilteredObjects = true;
    m_Content.scene = Scene();
    for (int i = 0; i < 100; ++i)
    {
        const float across = static_cast<float>(i % 10) * 0.2f - 1.0f;
        m_Content.Add("cube", PrimitiveType::Cube, {across, 0, static_cast<float>(i) * 0.1f},
                      Plain({1, 1, 1}), true);
        m_Content.scene.objects().back()->renderer->mesh = Cube();
    }
    const RenderResult result = Render(Nothing);
    EXPECT_EQ(std::ranges::count_if(result.frame->passes.at(1).commands,
                                    [](const PassCommand& command)
                                    { return std::holds_alternative<DrawCommand>(command); }),
              1);
}

// The taps of a row are 60 texels apart, 30 on each side of a border. Those of a column have no
// place for that; the longer ones decide how far a line lies from its object.
TEST_F(ColorEdgesFrame, ReachesAsFarAsTheLongerTapsOfAWidePicture)
{
    FlatScene flat(512, 32);
    flat.Add({200, 8}, {300, 24}, 5.0f, Plain({1, 1, 1}));
    m_Content.scene = std::move(flat.scene);
    m_Content.camera = flat.camera;
    m_Size = {512, 32};
    m_Settings.m_OnlyFilteredObjects = true;
    const RenderResult result =
        Render([](ColorEdges& edges) { edges.m_OutlineWidth.Override(60.0f); });
    const std::vector<PassCommand>& commands = result.frame->passes.at(3).commands;
    const auto viewport =
        std::ranges::find_if(commands, [](const PassCommand& command)
                             { return std::holds_alternative<SetViewportCommand>(command); });
    ASSERT_NE(viewport, commands.end());
    const ViewportRect part = std::get<SetViewportCommand>(*viewport).rect;
    EXPECT_LE(part.x, 170);
    EXPECT_GE(part.x + part.width, 330);
}

TEST_F(ColorEdgesFrame, CostsNoPassWhereNothingIsDrawnAndSaysWhy)
{
    m_Settings.m_OnlyFilteredObjects = true;
    m_Settings.m_LayerMask = LayerMask::FromIndex(k_FurnitureLayer);
    ExpectNothingDrawn({{{"no volume", "ColorEdges.m_Enable", "default"}, {}},
                        {{"ColorEdges.m_OutlineWidth is 0"},
                         [](ColorEdges& edges)
                         {
                             edges.m_OutlineWidth.Override(0.0f);
                         }},
                        {{"ColorEdges.m_OutlineColor", "alpha 0"},
                         [](ColorEdges& edges)
                         {
                             edges.m_OutlineColor.Override(Color::clear);
                         }},
                        {{"0 of 3", "layer mask leaves out 3"},
                         Nothing,
                         [](OutlineScene& content)
                         {
                             for (const auto& object : content.scene.objects())
                             {
                                 object->layer = 0;
                             }
                         }},
                        {{"0 of 0"}, Nothing, MoveObjectsAway}});
}

// The note says what the filter did; here nothing is filtered.
TEST_F(ColorEdgesFrame, HasLinesInAPictureWithoutObjects)
{
    m_Settings.m_LayerMask = LayerMask::Nothing();
    EXPECT_THAT(Render(Nothing).report.notes, IsEmpty());
}

TEST_F(ColorEdgesFrame, RefusesAnOperatorThatThereIsNot)
{
    EXPECT_THROW(
        Render([](ColorEdges& edges) { edges.m_Operator.Override(static_cast<EdgeOperator>(3)); }),
        ContractError);
}

} // namespace
} // namespace limn::test
