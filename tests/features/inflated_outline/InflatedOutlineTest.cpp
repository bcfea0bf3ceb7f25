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
    EXPECT_EQ(
        "Hull: it is not drawn; no volume at the camera sets InflatedOutline.m_Enable, which is "
        "false by default",
        NoteOf({}));
    EXPECT_EQ("Hull: it is not drawn; InflatedOutline.m_OutlineWidth is 0",
              NoteOf([](InflatedOutline& outline) { outline.m_OutlineWidth.Override(0.0f); }));
    EXPECT_EQ(
        "Hull: it is not drawn; InflatedOutline.m_OutlineColor has alpha 0",
        NoteOf([](InflatedOutline& outline) { outline.m_OutlineColor.Override(Color::clear); }));
    const auto inMetres = [](InflatedOutline& outline)
    {
        outline.m_WidthUnit.Override(InflatedWidthUnit::Metres);
        outline.m_WidthInMetres.Override(0.0f);
    };
    EXPECT_EQ("Hull: it is not drawn; InflatedOutline.m_WidthInMetres is 0", NoteOf(inMetres));
    m_Settings.m_RenderingLayerMask = 30;
    EXPECT_EQ("Hull: it is not drawn; 0 of 5 renderers drawn: 5 rendering layer mask",
              NoteOf([](InflatedOutline&) {}));
}

TEST_F(InflatedOutlineFrame, RefusesAUnitThatThereIsNot)
{
    EXPECT_THROW(Render([](InflatedOutline& outline)
                        { outline.m_WidthUnit.Override(static_cast<InflatedWidthUnit>(2)); }),
                 ContractError);
}

} // namespace limn::test
