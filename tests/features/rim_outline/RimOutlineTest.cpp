#include "features/inflated_outline/BodiesScene.h"
#include "features/outline/TechniqueFrame.h"

#include <gmock/gmock.h>
#include <limn/features/RimOutlineRendererFeature.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

class RimOutlineFrame
    : public TechniqueFrame<RimOutlineRendererFeature, RimOutlineSettings, RimOutline, BodiesScene>
{
protected:
    RimOutlineFrame() : TechniqueFrame("Rim") { m_Settings.m_RenderingLayerMask = k_SelectedLayer; }
};

} // namespace

TEST_F(RimOutlineFrame, IsDrawnBeforeWhatIsTransparent)
{
    const RenderResult result = Render([](RimOutline&) {});
    EXPECT_THAT(PassesOf(result), ElementsAre("Draw Opaque Objects", "Rim",
                                              "Draw Transparent Objects", "Final Blit"));
    EXPECT_THAT(result.report.notes, IsEmpty());
}

// The width counts where the rim is asked for in pixels.
TEST_F(RimOutlineFrame, SaysWhyItDrawsNothing)
{
    EXPECT_EQ(
        "Rim: it is not drawn; no volume at the camera sets RimOutline.m_Enable, which is false by "
        "default",
        NoteOf({}));
    const auto withoutWidth = [](RimVariant variant)
    {
        return [variant](RimOutline& outline)
        {
            outline.m_Variant.Override(variant);
            outline.m_OutlineWidth.Override(0.0f);
        };
    };
    EXPECT_EQ("Rim: it is not drawn; RimOutline.m_OutlineWidth is 0",
              NoteOf(withoutWidth(RimVariant::Pixels)));
    EXPECT_EQ("", NoteOf(withoutWidth(RimVariant::Soft)));
    EXPECT_EQ("", NoteOf(withoutWidth(RimVariant::Threshold)));
    EXPECT_EQ("Rim: it is not drawn; RimOutline.m_OutlineColor has alpha 0",
              NoteOf([](RimOutline& outline) { outline.m_OutlineColor.Override(Color::clear); }));
    m_Settings.m_RenderingLayerMask = 30;
    EXPECT_EQ("Rim: it is not drawn; 0 of 5 renderers drawn: 5 rendering layer mask",
              NoteOf([](RimOutline&) {}));
}

TEST_F(RimOutlineFrame, RefusesAVariantThatThereIsNot)
{
    EXPECT_THROW(
        Render([](RimOutline& outline) { outline.m_Variant.Override(static_cast<RimVariant>(3)); }),
        ContractError);
}

} // namespace limn::test
