#include "Mentions.h"
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
    EXPECT_THAT(NoteOf({}),
                Mentions("Rim", "not drawn", "no volume", "RimOutline.m_Enable", "default"));
    const auto withoutWidth = [](RimVariant variant)
    {
        return [variant](RimOutline& outline)
        {
            outline.m_Variant.Override(variant);
            outline.m_OutlineWidth.Override(0.0f);
        };
    };
    EXPECT_THAT(NoteOf(withoutWidth(RimVariant::Pixels)),
                Mentions("Rim", "not drawn", "RimOutline.m_OutlineWidth is 0"));
    EXPECT_EQ("", NoteOf(withoutWidth(RimVariant::Soft)));
    EXPECT_EQ("", NoteOf(withoutWidth(RimVariant::Threshold)));
    EXPECT_THAT(NoteOf([](RimOutline& outline) { outline.m_OutlineColor.Override(Color::clear); }),
                Mentions("Rim", "not drawn", "RimOutline.m_OutlineColor", "alpha 0"));
    m_Settings.m_RenderingLayerMask = 30;
    EXPECT_THAT(NoteOf([](RimOutline&) {}),
                Mentions("Rim", "not drawn", "rendering layer mask leaves out 5"));
}

TEST_F(RimOutlineFrame, RefusesAVariantThatThereIsNot)
{
    EXPECT_THROW(
        Render([](RimOutline& outline) { outline.m_Variant.Override(static_cast<RimVariant>(3)); }),
        ContractError);
}

} // namespace limn::test
