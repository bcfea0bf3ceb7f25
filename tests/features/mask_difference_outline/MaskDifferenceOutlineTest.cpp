#include "Mentions.h"
#include "features/OutlineScene.h"
#include "features/color_edges/FlatPicture.h"
#include "features/outline/TechniqueFrame.h"

#include <gmock/gmock.h>
#include <limn/features/MaskDifferenceOutlineRendererFeature.h>
#include <set>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

// Else the difference to the mean of the neighbours overlooks a change.
TEST(MaskValue, IsTheMeanOfFourOnlyIfAllOfThemAreThatOne)
{
    constexpr int count = 24;
    std::set<double> ids;
    for (int i = 0; i < count; ++i)
    {
        ids.insert(IdOfGroup(i));
    }
    ASSERT_EQ(ids.size(), count);
    for (const double a : ids)
    {
        for (const double b : ids)
        {
            for (const double c : ids)
            {
                for (const double d : ids)
                {
                    const bool isOne = a == b && b == c && c == d;
                    ASSERT_EQ(ids.contains((a + b + c + d) / 4.0), isOne);
                }
            }
        }
    }
}

TEST(MaskValue, IsAWholeNumberOfWhichAFloatHoldsTheSumOfFour)
{
    std::set<float> ids;
    for (int i = 0; i < 1023; ++i)
    {
        const float id = IdOfGroup(i);
        EXPECT_EQ(id, std::floor(id));
        EXPECT_GT(id, 0.0f);
        EXPECT_LT(4.0f * id, 16777216.0f);
        ids.insert(id);
    }
    EXPECT_EQ(ids.size(), 1023u);
    EXPECT_EQ(IdOfGroup(1023), IdOfGroup(0));
    EXPECT_EQ(IdOfGroup(70000), IdOfGroup(70000 % 1023));
}

TEST(MaskValue, HasColoursThatAreBrightAndFarApart)
{
    for (int i = 0; i < 200; ++i)
    {
        const glm::vec3 color = ColorOfGroup(i);
        EXPECT_EQ(std::max({color.r, color.g, color.b}), 1.0f) << i;
        EXPECT_EQ(std::min({color.r, color.g, color.b}), 0.0f) << i;
        const glm::vec3 step = glm::abs(ColorOfGroup(i + 1) - color);
        EXPECT_GT(std::max({step.r, step.g, step.b}), 0.5f) << i;
    }
}

class MaskDifferenceFrame
    : public TechniqueFrame<MaskDifferenceOutlineRendererFeature, MaskDifferenceOutlineSettings,
                            MaskDifferenceOutline, OutlineScene>
{
protected:
    MaskDifferenceFrame() : TechniqueFrame("Outline")
    {
        m_Size = {320, 240};
        m_LeavesOut = false;
    }
};

void Defaults(MaskDifferenceOutline&) {}

TEST_F(MaskDifferenceFrame, HasAMaskAndALineAddedInPlace)
{
    const RenderResult result = Render(Defaults);
    EXPECT_THAT(TargetsOf(result), ElementsAre("_CameraColorAttachmentA", "t_tex0",
                                               "_CameraColorAttachmentA", "limn_Output"));
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(MaskDifferenceFrame, HasTheScenesDepthOnlyWhereLinesAreClipped)
{
    const auto clipped = ElementsAre("_CameraColorAttachmentA", "_CameraDepthTexture", "t_tex0",
                                     "_CameraColorAttachmentA", "limn_Output");
    EXPECT_THAT(TargetsOf(Render([](MaskDifferenceOutline& outline)
                                 { outline.outline_depth_threshold_clip_player.Override(1.0f); })),
                clipped);
    EXPECT_THAT(TargetsOf(Render([](MaskDifferenceOutline& outline)
                                 { outline.m_ClipDistance.Override(5.0f); })),
                clipped);
}

TEST_F(MaskDifferenceFrame, HasACopyOfThePictureWithoutFramebufferFetch)
{
    m_Settings.m_FramebufferFetch = false;
    EXPECT_THAT(TargetsOf(Render(Defaults)),
                ElementsAre("_CameraColorAttachmentA", "t_tex0", "t_tex1",
                            "_CameraColorAttachmentA", "limn_Output"));
}

TEST_F(MaskDifferenceFrame, HasAMaskNoLargerThanTheObjectsNeed)
{
    m_Settings.m_Grouping = OutlineGrouping::Together;
    m_Content.scene.Find("Cube")->activeSelf = false;
    m_Content.scene.Find("Sphere")->activeSelf = false;
    const RenderResult result = Render(Defaults);
    const CompiledRenderPass& mask = result.frame->passes.at(1);
    EXPECT_LT(mask.width * mask.height, 320 * 240);
    EXPECT_FALSE(mask.depth) << "which of them is in front does not matter";
}

TEST_F(MaskDifferenceFrame, CostsNoPassWhereNothingIsDrawnAndSaysWhy)
{
    ExpectNothingDrawn({{{"no volume", "MaskDifferenceOutline.m_Enable"}, {}},
                        {{"MaskDifferenceOutline.m_OutlineWidth is 0"},
                         [](MaskDifferenceOutline& outline)
                         {
                             outline.m_OutlineWidth.Override(0.0f);
                         }},
                        {{"MaskDifferenceOutline.m_OutlineWidth is 0.25", "no pixel"},
                         [](MaskDifferenceOutline& outline)
                         {
                             outline.m_OutlineWidth.Override(0.25f);
                         }},
                        {{"MaskDifferenceOutline.m_OutlineColor", "alpha 0"},
                         [](MaskDifferenceOutline& outline)
                         {
                             outline.m_OutlineColor.Override(Color::clear);
                         }},
                        {{"MaskDifferenceOutline.m_OutlineColor", "black"},
                         [](MaskDifferenceOutline& outline)
                         {
                             outline.m_OutlineColor.Override(Color::black);
                         }},
                        {{"every depth", "clipped"},
                         [](MaskDifferenceOutline& outline)
                         {
                             outline.outline_depth_threshold_clip_player.Override(0.0f);
                         }},
                        {{"every depth", "clipped"},
                         [](MaskDifferenceOutline& outline)
                         {
                             outline.m_ClipDistance.Override(0.25f);
                         }},
                        {{"0 of 0"}, Defaults, MoveObjectsAway}});
}

} // namespace
} // namespace limn::test
