#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "pipeline/RendererHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// A pass that draws what its filter lets through.
class FilteredPass final : public test::LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void Execute(ScriptableRenderContext& context, RenderingData& data) override
    {
        context.DrawRenderers(data.cullResults,
                              CreateDrawingSettings(ShaderTagId("UniversalForward"), data,
                                                    SortingCriteria::CommonOpaque),
                              filtering);
    }
    FilteringSettings filtering;
};

/// What the user is told about a frame.
class Reports : public testing::Test
{
protected:
    Reports()
    {
        const auto shown = std::make_shared<Material>(test::ShaderWithProgram(""));
        const auto unmatched = std::make_shared<Material>(test::ShaderWithModes({"Other"}));
        test::AddCube(m_Scene, "a", {0, 0, 10}, {shown});
        test::AddCube(m_Scene, "b", {0, 0, 10}, {shown});
        test::AddCube(m_Scene, "c", {0, 0, 10}, {unmatched}).layer = 6;
        m_Harness.cullResults = Cull(m_Scene, m_Harness.camera, 2.0f);
    }

    test::Log m_Log;
    Scene m_Scene;
    test::RendererHarness m_Harness;
    FilteredPass m_Pass{"Outline", RenderPassEvent::AfterRenderingOpaques, m_Log};
};

TEST_F(Reports, ListPassesInTheOrderTheyRan)
{
    test::LoggingPass early("Early", RenderPassEvent::BeforeRenderingOpaques + 3, m_Log);
    m_Harness.AddFeature("f", m_Log, {&m_Pass, &early});
    m_Harness.Render();
    ASSERT_EQ(m_Harness.report.passes.size(), 2u);
    EXPECT_EQ(m_Harness.report.passes[0].name, "Early");
    EXPECT_EQ(static_cast<int>(m_Harness.report.passes[0].renderPassEvent), 253);
    EXPECT_EQ(m_Harness.report.passes[1].name, "Outline");
}

TEST_F(Reports, CountWhatEachRuleDecided)
{
    m_Harness.AddFeature("f", m_Log, {&m_Pass});
    m_Harness.Render();
    ASSERT_EQ(m_Harness.report.draws.size(), 1u);
    EXPECT_EQ(m_Harness.report.draws[0].pass, "Outline");
    EXPECT_EQ(m_Harness.report.draws[0].counts, (FilterCounts{2, 0, 0, 0, 1}));
    EXPECT_THAT(m_Harness.report.notes, IsEmpty());
}

TEST_F(Reports, SayWhyAFeaturesPassDrewNothing)
{
    m_Pass.filtering.layerMask = LayerMask::FromIndex(6);
    m_Harness.AddFeature("f", m_Log, {&m_Pass});
    m_Harness.Render();
    EXPECT_THAT(m_Harness.report.notes,
                ElementsAre(test::Mentions("Outline", "0 of 3", "layer mask leaves out 2",
                                           "1 has no pass", "LightMode")));
}

TEST_F(Reports, SayThatAFeaturesMaskIsEmpty)
{
    m_Pass.filtering.layerMask = LayerMask::Nothing();
    m_Harness.AddFeature("f", m_Log, {&m_Pass});
    m_Harness.Render();
    EXPECT_THAT(m_Harness.report.notes,
                ElementsAre(test::Mentions("Outline", "0 of 3", "layer mask leaves out 3",
                                           "layerMask is 0")));
}

TEST_F(Reports, SayOnceWhyAPassThatRanTwiceDrewNothing)
{
    m_Pass.filtering.layerMask = LayerMask::Nothing();
    m_Harness.AddFeature("f", m_Log, {&m_Pass, &m_Pass});
    m_Harness.Render();
    EXPECT_EQ(m_Harness.report.draws.size(), 2u);
    EXPECT_EQ(m_Harness.report.notes.size(), 1u);
}

TEST_F(Reports, SayNothingOfABuiltInPassWithNothingToDo)
{
    m_Pass.filtering.layerMask = LayerMask::Nothing();
    m_Harness.renderer.builtIn = {&m_Pass};
    m_Harness.Render();
    EXPECT_EQ(m_Harness.report.draws.size(), 1u);
    EXPECT_THAT(m_Harness.report.notes, IsEmpty());
}

/// A feature that adds no pass, and what it says and asks while it decides that.
class SilentFeature final : public ScriptableRendererFeature
{
public:
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData& data) override
    {
        FilteringSettings layers;
        layers.layerMask = LayerMask::FromIndex(6);
        for (int i = 0; i < 2; ++i) // the second time for a pass that it hands its work to
        {
            data.report->filters.push_back({{}, layers, {}, {0, 3, 0, 0, 0}});
        }
        data.report->notes.push_back(name + ": it is not drawn; it has no shader");
    }
};

TEST_F(Reports, TellForEachFeatureItsPassesItsNotesAndItsFilters)
{
    test::LoggingPass builtIn("Built In", RenderPassEvent::BeforeRenderingOpaques, m_Log);
    m_Harness.renderer.builtIn = {&builtIn};
    m_Harness.AddFeature("first", m_Log, {});
    m_Harness.renderer.AddFeature(std::make_unique<SilentFeature>()).name = "Silent";
    m_Harness.AddFeature("drawing", m_Log, {&m_Pass});
    m_Harness.Render();
    const RenderReport& report = m_Harness.report;
    ASSERT_EQ(report.features.size(), 3u);
    EXPECT_EQ(report.features[0].passes, 0u);
    EXPECT_EQ(report.features[0].noteCount, 0u);
    EXPECT_EQ(report.features[1].name, "Silent");
    EXPECT_EQ(report.features[1].passes, 0u);
    ASSERT_EQ(report.features[1].noteCount, 1u);
    EXPECT_THAT(report.notes.at(report.features[1].firstNote),
                test::Mentions("Silent", "not drawn", "no shader"));
    EXPECT_EQ(report.features[2].passes, 1u);
    ASSERT_EQ(report.draws.size(), 1u);
    EXPECT_EQ(report.draws[0].feature, 2u);
    ASSERT_EQ(report.filters.size(), 1u) << "the same filter twice is one";
    EXPECT_EQ(report.filters[0].feature, 1u);
    EXPECT_EQ(report.filters[0].pass, "Silent");
}

} // namespace
} // namespace limn
