#include "Mentions.h"
#include "features/inflated_outline/BodiesScene.h"
#include "features/outline/TechniqueFrame.h"

#include <gmock/gmock.h>
#include <limn/features/InflatedOutlineRendererFeature.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

class InflatedOutlineFrame
    : public TechniqueFrame<InflatedOutlineRendererFeature, InflatedOutlineSettings,
                            InflatedOutline, BodiesScene>
{
protected:
    InflatedOutlineFrame() : TechniqueFrame("Hull")
    {
        m_Settings.m_RenderingLayerMask = k_SelectedLayer;
    }
};

} // namespace

TEST_F(InflatedOutlineFrame, IsDrawnBeforeWhatIsTransparent)
{
    const RenderResult result = Render([](InflatedOutline&) {});
    EXPECT_THAT(result.report.notes, IsEmpty());
    EXPECT_THAT(PassesOf(result), ElementsAre("Draw Opaque Objects", "Hull",
                                              "Draw Transparent Objects", "Final Blit"));
}

TEST_F(InflatedOutlineFrame, SaysWhyItDrawsNothing)
{
    EXPECT_THAT(NoteOf({}),
                Mentions("Hull", "not drawn", "no volume", "InflatedOutline.m_Enable", "default"));
    EXPECT_THAT(NoteOf([](InflatedOutline& outline) { outline.m_OutlineWidth.Override(0.0f); }),
                Mentions("Hull", "not drawn", "InflatedOutline.m_OutlineWidth is 0"));
    EXPECT_THAT(
        NoteOf([](InflatedOutline& outline) { outline.m_OutlineColor.Override(Color::clear); }),
        Mentions("Hull", "not drawn", "InflatedOutline.m_OutlineColor", "alpha 0"));
    const auto inMetres = [](InflatedOutline& outline)
    {
        outline.m_WidthUnit.Override(InflatedWidthUnit::Metres);
        outline.m_WidthInMetres.Override(0.0f);
    };
    EXPECT_THAT(NoteOf(inMetres),
                Mentions("Hull", "not drawn", "InflatedOutline.m_WidthInMetres is 0"));
    m_Settings.m_RenderingLayerMask = 30;
    EXPECT_THAT(NoteOf([](InflatedOutline&) {}),
                Mentions("Hull", "not drawn", "rendering layer mask leaves out 5"));
}

TEST_F(InflatedOutlineFrame, RefusesAUnitThatThereIsNot)
{
    EXPECT_THROW(Render([](InflatedOutline& outline)
                        { outline.m_WidthUnit.Override(static_cast<InflatedWidthUnit>(2)); }),
                 ContractError);
}

} // namespace limn::test
