#include "Mentions.h"
#include "features/OutlineScene.h"
#include "features/color_edges/FlatPicture.h"
#include "features/outline/TechniqueFrame.h"

#include <gmock/gmock.h>
#include <limn/features/DepthNormalsOutlineRendererFeature.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using SetOutline = std::function<void(DepthNormalsOutline&)>;

class DepthNormalsFrame
    : public TechniqueFrame<DepthNormalsOutlineRendererFeature, DepthNormalsOutlineSettings,
                            DepthNormalsOutline, OutlineScene>
{
protected:
    DepthNormalsFrame() : TechniqueFrame("Lines")
    {
        m_Settings.m_LayerMask = LayerMask::FromIndex(k_FurnitureLayer);
        m_Settings.m_RenderingLayerMask = k_SelectedLayer;
    }
};

void AsItIs(DepthNormalsOutline&) {}
void LikeTheArticle(DepthNormalsOutline& outline)
{
    outline.m_Technique.Override(DepthNormalsTechnique::Article);
}

TEST_F(DepthNormalsFrame, HasDepthAndNormalsMadeAndTheObjectsDrawnOnceMoreBeforeTransparentOnes)
{
    const RenderResult result = Render(AsItIs);
    EXPECT_THAT(PassesOf(result), ElementsAre("DepthNormalPrepass", "Draw Opaque Objects", "Lines",
                                              "Draw Transparent Objects", "Final Blit"));
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(DepthNormalsFrame, HasTheBuiltInPipelinesTextureMadeForTheArticlesTechnique)
{
    EXPECT_THAT(PassesOf(Render(LikeTheArticle)),
                ElementsAre("DepthNormalPrepass", "EncodeDepthNormals", "Draw Opaque Objects",
                            "Lines", "Draw Transparent Objects", "Final Blit"));
}

struct WhyNoLines
{
    std::vector<std::string> why;
    SetOutline set;
    std::function<void(OutlineScene&)> change = [](OutlineScene&) {
    };
};

TEST_F(DepthNormalsFrame, HasNoPassNorPrepassWhereNothingIsDrawnAndSaysWhy)
{
    const WhyNoLines cases[] = {{{"no volume", "DepthNormalsOutline.m_Enable", "default"}, {}},
                                {{"DepthNormalsOutline.m_OutlineWidth is 0"},
                                 [](DepthNormalsOutline& outline)
                                 {
                                     outline.m_OutlineWidth.Override(0.0f);
                                 }},
                                {{"DepthNormalsOutline.m_OutlineColor", "alpha 0"},
                                 [](DepthNormalsOutline& outline)
                                 {
                                     outline.m_OutlineColor.Override(Color::clear);
                                 }},
                                {{"0 of 3", "layer mask leaves out 3"},
                                 AsItIs,
                                 [](OutlineScene& content)
                                 {
                                     for (const auto& object : content.scene.objects())
                                     {
                                         object->layer = 0;
                                     }
                                 }},
                                {{"0 of 1", "rendering layer mask leaves out 1"},
                                 AsItIs,
                                 [](OutlineScene& content)
                                 {
                                     content.scene.Find("Torus")->transform.localPosition.x =
                                         1000.0f;
                                     content.scene.Find("Cube")->transform.localPosition.x =
                                         1000.0f;
                                 }}};
    for (const WhyNoLines& c : cases)
    {
        m_Content = OutlineScene();
        c.change(m_Content);
        const RenderResult result = Render(c.set);
        EXPECT_THAT(PassesOf(result),
                    ElementsAre("Draw Opaque Objects", "Draw Transparent Objects", "Final Blit"))
            << testing::PrintToString(c.why);
        EXPECT_THAT(result.report.notes, ElementsAre(testing::AllOf(Mentions("Lines", "not drawn"),
                                                                    MentionsInOrder(c.why))));
    }
}

TEST_F(DepthNormalsFrame, RefusesATechniqueThatThereIsNot)
{
    EXPECT_THROW(Render([](DepthNormalsOutline& outline)
                        { outline.m_Technique.Override(static_cast<DepthNormalsTechnique>(2)); }),
                 ContractError);
}

} // namespace
} // namespace limn::test
