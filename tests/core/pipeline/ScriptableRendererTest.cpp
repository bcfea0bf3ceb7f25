#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

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
using testing::ElementsAre;
using testing::IsEmpty;

/// The order in which features and passes are called.
class ScriptableRendererOrder : public testing::Test
{
protected:
    /// Names of the passes in the order they executed.
    Log ExecutedPasses() const
    {
        Log names;
        for (const ExecutedPassReport& pass : m_Harness.report.passes)
        {
            names.push_back(pass.name.name());
        }
        return names;
    }

    Log m_Log;
    test::RendererHarness m_Harness;
};

TEST_F(ScriptableRendererOrder, CallsAllFeaturesAndPassesStepByStep)
{
    LoggingPass late("late", RenderPassEvent::AfterRenderingTransparents, m_Log);
    LoggingPass first("first", RenderPassEvent::AfterRenderingOpaques, m_Log);
    LoggingPass second("second", RenderPassEvent::AfterRenderingOpaques, m_Log);
    LoggingPass builtIn("builtIn", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&late, &first});
    m_Harness.AddFeature("g", m_Log, {&second});
    m_Harness.renderer.builtIn = {&builtIn};
    m_Harness.renderer.log = &m_Log;
    m_Harness.Render();
    EXPECT_THAT(m_Log,
                ElementsAre("f.Create", "g.Create", "f.AddRenderPasses", "g.AddRenderPasses",
                            "Setup", "f.SetupRenderPasses", "g.SetupRenderPasses",
                            "late.OnCameraSetup", "first.OnCameraSetup", "second.OnCameraSetup",
                            "builtIn.OnCameraSetup", "first.Configure", "second.Configure",
                            "builtIn.Configure", "late.Configure", "first.Execute",
                            "second.Execute", "builtIn.Execute", "late.Execute",
                            "first.OnCameraCleanup", "second.OnCameraCleanup",
                            "builtIn.OnCameraCleanup", "late.OnCameraCleanup"));
}

TEST_F(ScriptableRendererOrder, CallsNoSetupRenderPassesForAPreview)
{
    LoggingPass pass("pass", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&pass});
    m_Harness.camera.cameraType = CameraType::Preview;
    m_Harness.Render();
    EXPECT_THAT(m_Log, ElementsAre("f.Create", "f.AddRenderPasses", "pass.OnCameraSetup",
                                   "pass.Configure", "pass.Execute", "pass.OnCameraCleanup"));
}

TEST_F(ScriptableRendererOrder, SortsByEventAndKeepsEqualEventsAsEnqueued)
{
    LoggingPass a("A", RenderPassEvent::AfterRenderingOpaques, m_Log);
    LoggingPass b("B", RenderPassEvent::BeforeRenderingOpaques, m_Log);
    LoggingPass c("C", RenderPassEvent::AfterRenderingOpaques, m_Log);
    LoggingPass d("D", RenderPassEvent::BeforeRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&a, &b, &c, &d});
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("B", "D", "A", "C"));
}

TEST_F(ScriptableRendererOrder, HonoursOffsetsOfEvents)
{
    using enum RenderPassEvent;
    LoggingPass a("301", AfterRenderingOpaques + 1, m_Log);
    LoggingPass b("299", AfterRenderingOpaques - 1, m_Log);
    LoggingPass c("300", AfterRenderingOpaques, m_Log);
    LoggingPass d("255", static_cast<RenderPassEvent>(255), m_Log);
    LoggingPass e("1002", AfterRendering + 2, m_Log);
    LoggingPass f("-1", BeforeRendering - 1, m_Log);
    a.ConfigureTarget(m_Harness.renderer.color);
    m_Harness.AddFeature("f", m_Log, {&a, &b, &c, &d, &e, &f});
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("-1", "255", "299", "300", "301", "1002"));
}

TEST_F(ScriptableRendererOrder, RunsAPassAsOftenAsItIsEnqueued)
{
    LoggingPass pass("twice", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&pass, &pass});
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("twice", "twice"));
}

TEST_F(ScriptableRendererOrder, RunsAFeaturesPassBeforeTheBuiltInOneOfTheSameEvent)
{
    LoggingPass user("user", RenderPassEvent::BeforeRenderingOpaques, m_Log);
    LoggingPass opaque("opaque", RenderPassEvent::BeforeRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&user});
    m_Harness.renderer.builtIn = {&opaque};
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("user", "opaque"));
}

/// Passes that were given no name.
class GlowPass : public ScriptableRenderPass
{
public:
    void Execute(ScriptableRenderContext&, RenderingData&) override {}
};

TEST_F(ScriptableRendererOrder, CallsAPassAfterItsClassUnlessItIsNamed)
{
    GlowPass unnamed;
    GlowPass named;
    named.profilingSampler = ProfilingSampler("Halo");
    m_Harness.AddFeature("f", m_Log, {&unnamed, &named});
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("GlowPass", "Halo"));
}

TEST_F(ScriptableRendererOrder, NamesAPassWithoutAName)
{
    GlowPass pass;
    pass.ConfigureTarget(RTHandle());
    m_Harness.AddFeature("f", m_Log, {&pass});
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Harness.Render(); }),
                Mentions("'GlowPass'", "ConfigureTarget", "empty handles", "OnCameraSetup"));
}

/// A feature that sets its pass up from outside, as Unity's do.
class OutsideFeature final : public ScriptableRendererFeature
{
public:
    GlowPass pass;
    RTHandle target;

    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& data) override
    {
        pass.ConfigureInput(ScriptableRenderPassInput::Depth);
        pass.ResetTarget();
        pass.ConfigureTarget(target);
        pass.ConfigureClear(ClearFlag::Color, Color::red);
        const DrawingSettings drawing = pass.CreateDrawingSettings(
            ShaderTagId("UniversalForward"), data, SortingCriteria::CommonOpaque);
        EXPECT_THAT(drawing.shaderTagIds, ElementsAre(ShaderTagId("UniversalForward")));
        renderer.EnqueuePass(pass);
    }
};

TEST_F(ScriptableRendererOrder, LetsAFeatureSetUpItsPassFromOutside)
{
    auto feature = std::make_unique<OutsideFeature>();
    feature->target = RTHandle(test::Target("Mask"));
    const auto target = feature->target.rt();
    m_Harness.renderer.AddFeature(std::move(feature));
    const CompiledFrame frame = m_Harness.Render();
    ASSERT_EQ(frame.passes.size(), 1u);
    ASSERT_EQ(frame.passes[0].colors.size(), 1u);
    EXPECT_EQ(frame.passes[0].colors[0].texture, target);
    EXPECT_EQ(frame.passes[0].colors[0].load, LoadOp::Clear);
    EXPECT_EQ(frame.passes[0].colors[0].clearColor, Color::red);
}

/// A pass that moves to another event when the camera is set up.
class MovingPass final : public LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void OnCameraSetup(CommandBuffer&, RenderingData&) override
    {
        renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
    }
};

TEST_F(ScriptableRendererOrder, SortsBehindOnCameraSetup)
{
    MovingPass moving("moving", RenderPassEvent::BeforeRenderingOpaques, m_Log);
    LoggingPass still("still", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&moving, &still});
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("still", "moving"));
}

TEST_F(ScriptableRendererOrder, StartsEachCameraWithAnEmptyQueue)
{
    LoggingPass pass("pass", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&pass});
    m_Harness.Render();
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("pass"));
}

TEST_F(ScriptableRendererOrder, CallsNothingOfAnInactiveFeatureAndSaysSo)
{
    LoggingPass pass("pass", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("Outline", m_Log, {&pass});
    m_Log.clear();
    m_Harness.renderer.rendererFeatures().front()->SetActive(false);
    m_Harness.Render();
    EXPECT_THAT(m_Log, IsEmpty());
    EXPECT_THAT(ExecutedPasses(), IsEmpty());
    EXPECT_THAT(m_Harness.report.notes, ElementsAre(Mentions("Outline", "not drawn", "inactive")));
}

TEST_F(ScriptableRendererOrder, CreatesAFeatureOnceWhenItIsAdded)
{
    m_Harness.AddFeature("f", m_Log, {});
    m_Harness.renderer.rendererFeatures().front()->SetActive(false);
    m_Harness.renderer.rendererFeatures().front()->SetActive(true);
    EXPECT_THAT(m_Log, ElementsAre("f.Create"));
}

TEST_F(ScriptableRendererOrder, RefusesAFeatureThatIsNull)
{
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { m_Harness.renderer.AddFeature(nullptr); }),
              "AddFeature: the feature is null");
}

/// A pass that fails on request.
class FailingPass final : public LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void Execute(ScriptableRenderContext&, RenderingData&) override
    {
        if (fails)
        {
            throw std::runtime_error("the mask is missing");
        }
    }
    bool fails = true;
};

TEST_F(ScriptableRendererOrder, CanRenderAgainAfterAPassHasThrown)
{
    FailingPass failing("failing", RenderPassEvent::AfterRenderingOpaques, m_Log);
    LoggingPass other("other", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&failing, &other});
    EXPECT_EQ(test::ThrownMessage<std::runtime_error>([&] { m_Harness.Render(); }),
              "the mask is missing");
    EXPECT_THROW(m_Harness.renderer.cameraColorTargetHandle(), ContractError);
    failing.fails = false;
    m_Harness.Render();
    EXPECT_THAT(ExecutedPasses(), ElementsAre("failing", "other"));
}

TEST_F(ScriptableRendererOrder, CleansUpEveryPassAfterOneHasThrown)
{
    FailingPass failing("failing", RenderPassEvent::BeforeRenderingOpaques, m_Log);
    LoggingPass other("other", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&other, &failing});
    m_Log.clear();
    EXPECT_EQ(test::ThrownMessage<std::runtime_error>([&] { m_Harness.Render(); }),
              "the mask is missing");
    EXPECT_THAT(m_Log,
                ElementsAre("f.AddRenderPasses", "f.SetupRenderPasses", "other.OnCameraSetup",
                            "failing.OnCameraSetup", "failing.Configure", "other.Configure",
                            "failing.OnCameraCleanup", "other.OnCameraCleanup"));
}

/// A pass that fails while it is set up or cleaned up.
class FailingSetupPass final : public LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override
    {
        LoggingPass::OnCameraSetup(cmd, renderingData);
        if (failsInSetup)
        {
            throw std::runtime_error("no target");
        }
    }
    void OnCameraCleanup(CommandBuffer& cmd) override
    {
        LoggingPass::OnCameraCleanup(cmd);
        throw std::runtime_error("cannot let go");
    }
    bool failsInSetup = true;
};

TEST_F(ScriptableRendererOrder, CleansUpThePassesWhoseSetupWasCalledAfterOneHasThrownThere)
{
    LoggingPass first("first", RenderPassEvent::AfterRenderingOpaques, m_Log);
    FailingSetupPass failing("failing", RenderPassEvent::AfterRenderingOpaques, m_Log);
    LoggingPass last("last", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&first, &failing, &last});
    m_Log.clear();
    EXPECT_EQ(test::ThrownMessage<std::runtime_error>([&] { m_Harness.Render(); }), "no target")
        << "what went wrong first is what is reported";
    EXPECT_THAT(m_Log, ElementsAre("f.AddRenderPasses", "f.SetupRenderPasses",
                                   "first.OnCameraSetup", "failing.OnCameraSetup",
                                   "first.OnCameraCleanup", "failing.OnCameraCleanup"));
}

/// Cleans up as URP 8 had it, and behind the camera's stack.
class OldCleanupPass final : public LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void FrameCleanup(CommandBuffer&) override { Write("FrameCleanup"); }
    void OnFinishCameraStackRendering(CommandBuffer&) override { Write("OnFinish"); }
};

TEST_F(ScriptableRendererOrder, EndsPassesUnderTheNamesOfAllVersions)
{
    OldCleanupPass old("old", RenderPassEvent::AfterRenderingOpaques, m_Log);
    LoggingPass last("last", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&old, &last});
    m_Harness.Render();
    const std::vector<std::string> ends(m_Log.end() - 3, m_Log.end());
    EXPECT_THAT(ends, ElementsAre("old.FrameCleanup", "last.OnCameraCleanup", "old.OnFinish"));
}

TEST_F(ScriptableRendererOrder, CleansUpThePassesBehindOneThatCannot)
{
    FailingSetupPass failing("failing", RenderPassEvent::AfterRenderingOpaques, m_Log);
    failing.failsInSetup = false;
    LoggingPass last("last", RenderPassEvent::AfterRenderingOpaques, m_Log);
    m_Harness.AddFeature("f", m_Log, {&failing, &last});
    EXPECT_EQ(test::ThrownMessage<std::runtime_error>([&] { m_Harness.Render(); }),
              "cannot let go");
    EXPECT_EQ(m_Log.back(), "last.OnCameraCleanup");
}

/// Notes what it is asked to let go of.
class DisposedFeature final : public test::LoggingFeature
{
public:
    DisposedFeature(Log& log, bool throws) : LoggingFeature("f", log), m_Seen(log), m_Throws(throws)
    {
    }
    ~DisposedFeature() override { m_Seen.push_back("destroyed"); }

protected:
    void Dispose(bool disposing) override
    {
        m_Seen.push_back(disposing ? "Dispose(true)" : "Dispose(false)");
        if (m_Throws)
        {
            throw std::runtime_error("cannot");
        }
    }

private:
    Log& m_Seen;
    bool m_Throws;
};

TEST(ScriptableRenderer, DisposesOfItsFeaturesBeforeTheyGo)
{
    Log log;
    {
        test::TestRenderer renderer;
        renderer.AddFeature(std::make_unique<DisposedFeature>(log, true));
        renderer.AddFeature(std::make_unique<DisposedFeature>(log, false));
    }
    EXPECT_THAT(log, ElementsAre("f.Create", "f.Create", "Dispose(true)", "Dispose(true)",
                                 "destroyed", "destroyed"));
}

TEST(RenderPassBlock, DividesTheFrameAt150And300And600)
{
    const auto block = [](int event)
    {
        return BlockOf(static_cast<RenderPassEvent>(event));
    };
    EXPECT_EQ(static_cast<int>(block(0)), 0);
    EXPECT_EQ(static_cast<int>(block(149)), 0);
    EXPECT_EQ(static_cast<int>(block(150)), 1);
    EXPECT_EQ(static_cast<int>(block(299)), 1);
    EXPECT_EQ(static_cast<int>(block(300)), 2);
    EXPECT_EQ(static_cast<int>(block(599)), 2);
    EXPECT_EQ(static_cast<int>(block(600)), 3);
    EXPECT_EQ(static_cast<int>(block(1002)), 3);
}

} // namespace
} // namespace limn
