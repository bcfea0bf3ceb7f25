#include "features/inflated_outline/BodiesScene.h"

#include <gmock/gmock.h>
#include <limn/core/RecordingDevice.h>
#include <limn/features/InflatedOutlineRendererFeature.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

class InflatedOutlineFrame : public testing::Test
{
protected:
    InflatedOutlineFrame() { m_Settings.m_RenderingLayerMask = k_SelectedLayer; }

    RenderResult Render(const std::function<void(InflatedOutline&)>& set)
    {
        UniversalRenderPipeline pipeline(m_Device);
        UniversalRenderer renderer(Compiler());
        auto feature = std::make_unique<InflatedOutlineRendererFeature>(m_Settings);
        feature->name = "Hull";
        renderer.AddFeature(std::move(feature));
        RenderRequest request;
        request.scene = &m_Content.scene;
        request.camera = &m_Content.camera;
        request.width = 64;
        request.height = 48;
        request.volumeStack = set ? &m_Volumes.With(set) : nullptr;
        return pipeline.RenderSingleCamera(renderer, request);
    }

    /// The note of a frame without the outline.
    std::string NoteOf(const std::function<void(InflatedOutline&)>& set)
    {
        const RenderResult result = Render(set);
        EXPECT_THAT(PassesOf(result), testing::Not(testing::Contains("Hull")));
        return result.report.notes.empty() ? "" : result.report.notes.front();
    }

    static std::vector<std::string> PassesOf(const RenderResult& result)
    {
        std::vector<std::string> names;
        for (const ExecutedPassReport& pass : result.report.passes)
        {
            names.push_back(pass.name.name());
        }
        return names;
    }

    InflatedOutlineSettings m_Settings;
    BodiesScene m_Content;
    RecordingDevice m_Device;
    BlendedComponent<InflatedOutline> m_Volumes;
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
    EXPECT_EQ("Hull: not drawn, no volume at the camera sets InflatedOutline.m_Enable, which is "
              "false by default",
              NoteOf({}));
    EXPECT_EQ("Hull: not drawn, InflatedOutline.m_OutlineWidth is 0",
              NoteOf([](InflatedOutline& outline) { outline.m_OutlineWidth.Override(0.0f); }));
    EXPECT_EQ(
        "Hull: not drawn, InflatedOutline.m_OutlineColor has alpha 0",
        NoteOf([](InflatedOutline& outline) { outline.m_OutlineColor.Override(Color::clear); }));
    const auto inMetres = [](InflatedOutline& outline)
    {
        outline.m_WidthUnit.Override(InflatedWidthUnit::Metres);
        outline.m_WidthInMetres.Override(0.0f);
    };
    EXPECT_EQ("Hull: not drawn, InflatedOutline.m_WidthInMetres is 0", NoteOf(inMetres));
    m_Settings.m_RenderingLayerMask = 30;
    EXPECT_EQ("Hull: not drawn, 0 of 5 renderers drawn: 5 rendering layer mask",
              NoteOf([](InflatedOutline&) {}));
}

TEST_F(InflatedOutlineFrame, RefusesAUnitThatThereIsNot)
{
    EXPECT_THROW(Render([](InflatedOutline& outline)
                        { outline.m_WidthUnit.Override(static_cast<InflatedWidthUnit>(2)); }),
                 ContractError);
}

} // namespace limn::test
