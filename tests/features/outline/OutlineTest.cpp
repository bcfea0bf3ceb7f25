#include "Mentions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>
#include <limn/limn.h>

namespace limn
{
namespace
{

using testing::HasSubstr;
using testing::IsEmpty;

/// A torus before a camera, and a device that draws nothing.
class OutlineSetup : public testing::Test
{
protected:
    OutlineSetup() { m_Camera.transform.localPosition = {0.0f, 0.0f, -2.0f}; }

    template <typename Feature>
    GameObject& AddTorus(Outline<Feature>& outline)
    {
        GameObject& torus = m_Scene.Add("Torus");
        torus.transform.localRotation = EulerToRotation({60.0f, 0.0f, 20.0f});
        torus.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Torus),
                                      {outline.CreateMaterial("Universal Render Pipeline/Lit")}};
        return torus;
    }

    static std::size_t CountPasses(const RenderResult& result, std::string_view name)
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(result.report.passes, [&](const ExecutedPassReport& pass)
                                  { return pass.name.name() == name; }));
    }

    RecordingDevice m_Device;
    Scene m_Scene;
    Camera m_Camera;
};

TEST_F(OutlineSetup, DrawsAnOutlineAroundANewObject)
{
    Outline<StrokeOutlineRendererFeature> outline(m_Device);
    AddTorus(outline);
    const RenderResult result = outline.Render(m_Scene, m_Camera, 64, 36);
    EXPECT_THAT(result.report.notes, IsEmpty());
    EXPECT_EQ(1u, CountPasses(result, "StrokeOutlineRendererFeature"));
    EXPECT_EQ(1u, m_Device.frames().size());
}

TEST_F(OutlineSetup, SaysWhyThereIsNoOutlineAroundAnotherRenderingLayer)
{
    StrokeOutlineSettings settings;
    settings.m_RenderingLayerMask = 8;
    Outline<StrokeOutlineRendererFeature> outline(m_Device, settings);
    GameObject& torus = AddTorus(outline);
    const RenderResult result = outline.Render(m_Scene, m_Camera, 64, 36);
    EXPECT_EQ(0u, CountPasses(result, "StrokeOutlineRendererFeature"));
    EXPECT_THAT(result.report.notes,
                testing::Contains(HasSubstr("StrokeOutlineRendererFeature: it is not drawn")));

    torus.renderer->renderingLayerMask = outline.settings().renderingLayer();
    EXPECT_EQ(256u, torus.renderer->renderingLayerMask.bits);
    EXPECT_THAT(outline.Render(m_Scene, m_Camera, 64, 36).report.notes, IsEmpty());
}

TEST_F(OutlineSetup, BlendsItsVolumeWithOthers)
{
    Outline<AutoOutlineRendererFeature> outline(m_Device);
    AddTorus(outline);
    outline.component().m_OutlineWidth.Override(6.0f);
    const auto width = [&]
    {
        outline.Render(m_Scene, m_Camera, 64, 36);
        return outline.stack().GetComponent<AutoOutline>()->m_OutlineWidth.value();
    };
    EXPECT_EQ(6.0f, width());

    const auto profile = std::make_shared<VolumeProfile>();
    profile->Add<AutoOutline>().m_OutlineWidth.Override(10.0f);
    Volume half;
    half.sharedProfile = profile;
    half.weight = 0.5f;
    half.priority = 1.0f;
    outline.volumes().Register(&half);
    EXPECT_EQ(8.0f, width()) << "half-way between 6 and 10";

    outline.volume().enabled = false;
    EXPECT_EQ(6.5f, width()) << "half-way between the default, 3, and 10";
}

TEST_F(OutlineSetup, TakesATechniqueThatHasItsShaderInItsSettings)
{
    ScreenSpaceOutlineSettings settings;
    settings.m_LayerMask = LayerMask::Everything();
    settings.m_ScreenSpaceOutlineShader =
        FindShippedShader("Hidden/ScreenSpaceOutline", std::make_shared<ShaderCompiler>());
    Outline<ScreenSpaceOutlineRenderFeature> outline(m_Device, settings);
    AddTorus(outline);
    EXPECT_THAT(outline.Render(m_Scene, m_Camera, 64, 36).report.notes, IsEmpty());
}

TEST_F(OutlineSetup, NamesTheNearestShader)
{
    const Outline<StrokeOutlineRendererFeature> outline(m_Device);
    try
    {
        outline.CreateMaterial("Universal Render Pipeline/Lid");
        FAIL() << "a material of no shader";
    }
    catch (const ContractError& error)
    {
        EXPECT_THAT(error.what(), test::Mentions("no shader", "'Universal Render Pipeline/Lid'",
                                                 "'Universal Render Pipeline/Lit'"));
    }
}

} // namespace
} // namespace limn
