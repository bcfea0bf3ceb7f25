#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/CurrentCamera.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "pipeline/RendererHarness.h"

namespace limn
{
namespace
{

using test::Log;
using test::LoggingPass;
using test::Mentions;
using testing::IsEmpty;

/// A pass that does what a test says when it is set up.
class SetupPass final : public LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void OnCameraSetup(CommandBuffer&, RenderingData& data) override { onCameraSetup(data); }
    std::function<void(RenderingData&)> onCameraSetup;
};

/// A feature that does what a test says when it adds passes.
class AddFeature final : public ScriptableRendererFeature
{
public:
    explicit AddFeature(std::function<void(RenderingData&)> action) : m_Action(std::move(action)) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData& data) override { m_Action(data); }

private:
    std::function<void(RenderingData&)> m_Action;
};

/// What passes draw into and what is cleared.
class ScriptableRendererTargets : public testing::Test
{
protected:
    CompiledFrame RenderWith(std::vector<ScriptableRenderPass*> passes)
    {
        m_Harness.AddFeature("f", m_Log, std::move(passes));
        return m_Harness.Render();
    }

    Log m_Log;
    test::RendererHarness m_Harness;
    LoggingPass m_Pass{"pass", RenderPassEvent::AfterRenderingOpaques, m_Log};
    LoggingPass m_Other{"other", RenderPassEvent::AfterRenderingOpaques + 1, m_Log};
    const RTHandle m_Mask{test::Target("Mask")};
};

TEST_F(ScriptableRendererTargets, DoNotExistWhenFeaturesAddPasses)
{
    m_Harness.renderer.AddFeature(std::make_unique<AddFeature>(
        [](RenderingData& data)
        { static_cast<void>(data.cameraData.renderer->cameraColorTargetHandle()); }));
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { m_Harness.Render(); }),
        Mentions("cameraColorTargetHandle", "only while", "OnCameraSetup", "AddRenderPasses"));
}

TEST_F(ScriptableRendererTargets, DoNotExistOutsideRendering)
{
    m_Harness.Render();
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { m_Harness.renderer.cameraDepthTargetHandle(); }),
        Mentions("cameraDepthTargetHandle", "only while", "OnCameraSetup", "AddRenderPasses"));
}

TEST_F(ScriptableRendererTargets, ExistFromOnCameraSetupOn)
{
    RTHandle color;
    RTHandle depth;
    SetupPass pass("pass", RenderPassEvent::AfterRenderingOpaques, m_Log);
    pass.onCameraSetup = [&](RenderingData& data)
    {
        color = data.cameraData.renderer->cameraColorTargetHandle();
        depth = data.cameraData.renderer->cameraDepthTargetHandle();
    };
    RenderWith({&pass});
    EXPECT_EQ(color, m_Harness.renderer.color);
    EXPECT_EQ(depth, m_Harness.renderer.depth);
}

TEST_F(ScriptableRendererTargets, AreTheCamerasUnlessAPassConfiguresItsOwn)
{
    const CompiledFrame frame = RenderWith({&m_Pass});
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_EQ(frame.passes[0].name, "pass");
    EXPECT_EQ(frame.passes[0].colors.at(0).texture, m_Harness.renderer.color.rt());
    EXPECT_EQ(frame.passes[0].depth->texture, m_Harness.renderer.depth.rt());
}

TEST_F(ScriptableRendererTargets, HaveNoDepthWhereAPassConfiguresAColorOnly)
{
    m_Pass.ConfigureTarget(m_Mask);
    m_Pass.ConfigureClear(ClearFlag::All, Color::clear);
    const CompiledFrame frame = RenderWith({&m_Pass});
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_EQ(frame.passes[0].colors.at(0).texture, m_Mask.rt());
    EXPECT_FALSE(frame.passes[0].depth);
}

TEST_F(ScriptableRendererTargets, AreTheCamerasAgainAfterResetTarget)
{
    m_Pass.ConfigureTarget(m_Mask);
    m_Pass.ResetTarget();
    EXPECT_EQ(RenderWith({&m_Pass}).passes.at(0).colors.at(0).texture,
              m_Harness.renderer.color.rt());
}

TEST_F(ScriptableRendererTargets, AreNotBoundBeforeTheFirstBlockOfTheCamera)
{
    m_Pass.renderPassEvent = static_cast<RenderPassEvent>(149);
    m_Pass.ConfigureClear(ClearFlag::All, Color::red);
    EXPECT_THAT(RenderWith({&m_Pass}).passes, IsEmpty());
}

/// sRGB to linear, in double.
double Linear(double s)
{
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

TEST_F(ScriptableRendererTargets, AreClearedByTheFirstPassWithTheBackgroundInsteadOfItsOwnColor)
{
    m_Harness.camera.backgroundColor = {0.2f, 0.5f, 0.8f, 0.25f};
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    const CompiledRenderPass pass = RenderWith({&m_Pass}).passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::Clear);
    EXPECT_NEAR(pass.colors[0].clearColor.r, Linear(0.2), 1e-6);
    EXPECT_NEAR(pass.colors[0].clearColor.g, Linear(0.5), 1e-6);
    EXPECT_NEAR(pass.colors[0].clearColor.b, Linear(0.8), 1e-6);
    EXPECT_EQ(pass.colors[0].clearColor.a, 0.25f);
    EXPECT_EQ(pass.depth->load, LoadOp::Clear);
    EXPECT_EQ(pass.depth->clearDepth, 1.0f);
    EXPECT_EQ(pass.depth->clearStencil, 0);
}

TEST_F(ScriptableRendererTargets, AreNotClearedAgainByTheSecondPass)
{
    const CompiledFrame frame = RenderWith({&m_Pass, &m_Other});
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(frame.passes[0].commands.size(), 4u); // two begins and two ends
}

TEST_F(ScriptableRendererTargets, AreClearedByALaterPassThatAsksForIt)
{
    m_Other.ConfigureClear(ClearFlag::Color, Color::red);
    const CompiledFrame frame = RenderWith({&m_Pass, &m_Other});
    EXPECT_EQ(frame.passes.at(0).colors[0].clearColor, Color::red);
}

TEST_F(ScriptableRendererTargets, AreClearedOnFirstUseInEveryFrame)
{
    RenderWith({&m_Pass});
    EXPECT_EQ(m_Harness.Render().passes.at(0).colors[0].load, LoadOp::Clear);
}

TEST_F(ScriptableRendererTargets, KeepTheirColorForACameraThatClearsNothing)
{
    m_Harness.camera.clearFlags = CameraClearFlags::Nothing;
    RenderWith({&m_Pass});
    const CompiledRenderPass pass = m_Harness.Render().passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::Load);
    EXPECT_EQ(pass.depth->load, LoadOp::Clear);
}

TEST_F(ScriptableRendererTargets, AreClearedToTheBackgroundByAPassOfACameraThatClearsNothing)
{
    m_Harness.camera.clearFlags = CameraClearFlags::Nothing;
    m_Harness.camera.backgroundColor = Color::green;
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    const CompiledRenderPass pass = RenderWith({&m_Pass}).passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(pass.colors[0].clearColor, Color::green);
}

TEST_F(ScriptableRendererTargets, ClearDepthOnItsFirstUseBesideAnotherColor)
{
    m_Pass.ConfigureTarget(m_Mask, m_Harness.renderer.depth);
    m_Pass.ConfigureClear(ClearFlag::Color, Color::clear);
    const CompiledFrame frame = RenderWith({&m_Pass, &m_Other});
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_EQ(frame.passes[0].colors[0].clearColor, Color::clear);
    EXPECT_EQ(frame.passes[0].depth->load, LoadOp::Clear);
    EXPECT_EQ(frame.passes[1].colors[0].load, LoadOp::Clear);
    EXPECT_EQ(frame.passes[1].depth->load, LoadOp::Load);
}

TEST_F(ScriptableRendererTargets, UseThePassesColorForItsOwnTarget)
{
    m_Pass.ConfigureTarget(m_Mask);
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    EXPECT_EQ(RenderWith({&m_Pass}).passes.at(0).colors[0].clearColor, Color::red);
}

TEST_F(ScriptableRendererTargets, AcceptADepthTextureInThePlaceOfTheColor)
{
    const RTHandle shadow(test::DepthTarget("Shadow"));
    m_Pass.ConfigureTarget(shadow);
    m_Pass.ConfigureClear(ClearFlag::All, Color::clear);
    const CompiledFrame frame = RenderWith({&m_Pass});
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(frame.passes[0].colors, IsEmpty());
    ASSERT_TRUE(frame.passes[0].depth);
    EXPECT_EQ(frame.passes[0].depth->texture, shadow.rt());
    EXPECT_EQ(frame.passes[0].depth->load, LoadOp::Clear);
}

TEST_F(ScriptableRendererTargets, CannotBeEmptyHandles)
{
    m_Pass.ConfigureTarget(RTHandle());
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { RenderWith({&m_Pass}); }),
                Mentions("'pass'", "ConfigureTarget", "empty handles", "OnCameraSetup"));
}

TEST(ScriptableRenderPass, BeginsWithUnitysDefaults)
{
    Log log;
    LoggingPass pass("pass", RenderPassEvent::AfterRenderingOpaques, log);
    EXPECT_EQ(pass.input(), ScriptableRenderPassInput::None);
    EXPECT_FALSE(pass.overrideCameraTarget());
    EXPECT_EQ(pass.clearFlag(), ClearFlag::None);
    EXPECT_EQ(pass.clearColor(), (Color{0, 0, 0, 1}));
}

TEST(CurrentCamera, GivesTheSizeOfThePictureThatIsRendered)
{
    RenderingData data;
    data.cameraData.cameraTargetDescriptor.width = 30;
    data.cameraData.cameraTargetDescriptor.height = 20;
    {
        const CurrentCamera camera(data);
        EXPECT_EQ(30, Screen::width());
        EXPECT_EQ(20, Screen::height());
        EXPECT_EQ(&data, &CurrentCamera::Rendered());
    }
    EXPECT_THROW(Screen::width(), ContractError);
    EXPECT_THROW(Screen::height(), ContractError);
    EXPECT_THROW(CurrentCamera::Rendered(), ContractError);
}

TEST(ScriptableRenderPass, SortsByTheCurrentCamera)
{
    Log log;
    const LoggingPass pass("pass", RenderPassEvent::AfterRenderingOpaques, log);
    Camera camera;
    camera.transform.localPosition = {1, 2, 3};
    camera.orthographic = true;
    RenderingData data;
    data.cameraData.camera = &camera;
    const DrawingSettings settings = pass.CreateDrawingSettings(
        ShaderTagId("UniversalForward"), data, SortingCriteria::CommonTransparent);
    EXPECT_THAT(settings.shaderTagIds, testing::ElementsAre(ShaderTagId("UniversalForward")));
    EXPECT_EQ(settings.sortingSettings.criteria, SortingCriteria::CommonTransparent);
    EXPECT_EQ(settings.sortingSettings.cameraPosition, glm::dvec3(1, 2, 3));
    EXPECT_EQ(settings.sortingSettings.cameraForward, glm::vec3(0, 0, 1));
    EXPECT_EQ(settings.sortingSettings.distanceMetric, DistanceMetric::Orthographic);
    EXPECT_EQ(settings.overrideMaterial, nullptr);
}

TEST(ScriptableRenderPass, DrawsWithOneToSixteenTags)
{
    Log log;
    const LoggingPass pass("pass", RenderPassEvent::AfterRenderingOpaques, log);
    const Camera camera;
    RenderingData data;
    data.cameraData.camera = &camera;
    const auto errorOf = [&](std::size_t count)
    {
        const std::vector<ShaderTagId> tags(count, ShaderTagId("A"));
        return test::ThrownMessage<ContractError>(
            [&] {
                static_cast<void>(
                    pass.CreateDrawingSettings(tags, data, SortingCriteria::CommonOpaque));
            });
    };
    EXPECT_THAT(errorOf(0), Mentions("CreateDrawingSettings", "0 LightMode tags", "1 to 16"));
    EXPECT_THAT(errorOf(17), Mentions("CreateDrawingSettings", "17 LightMode tags", "1 to 16"));
}

} // namespace
} // namespace limn
