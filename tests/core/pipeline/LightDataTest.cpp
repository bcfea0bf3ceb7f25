#include "pipeline/RendererHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/UniversalFrameData.h>

#include "Mentions.h"
#include "pipeline/PipelineTest.h"

namespace limn::test
{
namespace
{

/// Keeps what a feature is told of the lights, old style and new.
class LightsReader final : public ScriptableRendererFeature
{
public:
    struct Seen
    {
        LightData data;
        std::vector<VisibleLight> lights;
        int countInGraph = -1;
        ShadowData shadows;
        ShadowData shadowsInGraph;
        std::vector<glm::vec4> biases;
        std::vector<int> resolutions;
    };
    explicit LightsReader(Seen& seen) : m_Pass(seen) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& data) override
    {
        m_Pass.seen.data = data.lightData;
        m_Pass.seen.lights = data.lightData.visibleLights();
        m_Pass.seen.shadows = data.shadowData;
        m_Pass.seen.biases = data.shadowData.bias();
        m_Pass.seen.resolutions = data.shadowData.resolution();
        renderer.EnqueuePass(m_Pass);
    }

private:
    class Pass final : public ScriptableRenderPass
    {
    public:
        explicit Pass(Seen& s) : seen(s) {}
        void RecordRenderGraph(RenderGraph&, ContextContainer& frameData) override
        {
            seen.countInGraph = frameData.Get<UniversalLightData>().additionalLightsCount;
            seen.shadowsInGraph = frameData.Get<UniversalShadowData>();
        }
        Seen& seen;
    };
    Pass m_Pass;
};

class LightDataOfAFrame : public PipelineTest<>
{
protected:
    LightDataOfAFrame() : PipelineTest(8, 8)
    {
        m_Renderer.AddFeature(std::make_unique<LightsReader>(m_Seen));
    }

    const LightsReader::Seen& Render()
    {
        m_Result = PipelineTest::Render();
        return m_Seen;
    }

    Light& Add(LightType type, const glm::vec3& position)
    {
        Light& light = m_Scene.additionalLights.emplace_back();
        light.type = type;
        light.transform.localPosition = position;
        light.range = 2.0f;
        return light;
    }

    RenderResult m_Result;
    LightsReader::Seen m_Seen;
};

TEST_F(LightDataOfAFrame, HasTheMainLightAlone)
{
    m_Scene.mainLight.direction = {0.0f, 0.0f, 1.0f};
    m_Scene.mainLight.color = Color(0.5f, 1.0f, 0.0f, 1.0f);
    m_Scene.mainLight.intensity = 2.0f;
    const LightsReader::Seen& seen = Render();
    EXPECT_EQ(seen.data.mainLightIndex, 0);
    EXPECT_EQ(seen.data.additionalLightsCount, 0);
    ASSERT_EQ(seen.lights.size(), 1u);
    const VisibleLight& main = seen.lights[0];
    EXPECT_EQ(main.light, nullptr);
    EXPECT_EQ(main.lightType, LightType::Directional);
    EXPECT_NEAR(main.finalColor.r, 2.0 * 0.21404114, 1e-6) << "sRGB 0.5 is 0.214 (IEC 61966-2-1)";
    EXPECT_EQ(main.finalColor.g, 2.0f);
    EXPECT_EQ(main.localToWorldMatrix, glm::dmat4(1.0)) << "it shines along +z, x is level";
}

TEST_F(LightDataOfAFrame, HasThoseThatReachIntoTheViewInTheirOrder)
{
    Add(LightType::Point, {0, 0, -9}); // behind the camera
    Add(LightType::Spot, {1, 0, 5}).spotAngle = 40.0f;
    Add(LightType::Point, {0, 0, 6}).intensity = 0.0f;
    Add(LightType::Directional, {0, 0, -9}).intensity = 3.0f;
    Add(LightType::Point, {100, 0, 5});
    m_Scene.mainLight.intensity = 0.0f;
    const LightsReader::Seen& seen = Render();
    EXPECT_EQ(seen.data.mainLightIndex, -1);
    EXPECT_EQ(seen.data.additionalLightsCount, 2);
    EXPECT_EQ(seen.countInGraph, 2);
    ASSERT_EQ(seen.lights.size(), 2u);
    EXPECT_EQ(seen.lights[0].light, &m_Scene.additionalLights[1]);
    EXPECT_EQ(seen.lights[0].lightType, LightType::Spot);
    EXPECT_EQ(seen.lights[0].range, 2.0f);
    EXPECT_EQ(seen.lights[0].spotAngle, 40.0f);
    EXPECT_EQ(glm::dvec3(seen.lights[0].localToWorldMatrix[3]), glm::dvec3(1, 0, 5));
    EXPECT_EQ(seen.lights[1].light, &m_Scene.additionalLights[3]);
    EXPECT_EQ(seen.lights[1].range, 0.0f) << "without end";
    EXPECT_EQ(seen.lights[1].spotAngle, 0.0f) << "no cone";
    EXPECT_EQ(seen.lights[1].finalColor.r, 3.0f);
}

TEST_F(LightDataOfAFrame, HasNoMoreThanShadersHaveRoomFor)
{
    for (int i = 0; i < 40; ++i)
    {
        Add(LightType::Point, {0, 0, 5});
    }
    const LightsReader::Seen& seen = Render();
    EXPECT_EQ(seen.data.additionalLightsCount, 32);
    EXPECT_EQ(seen.data.maxPerObjectAdditionalLightsCount, 4) << "URP's default";
    EXPECT_EQ(seen.lights.size(), 33u);
    EXPECT_THAT(m_Result.report.notes,
                testing::Contains(testing::HasSubstr("40 lights reach into the picture")));
}

TEST_F(LightDataOfAFrame, SaysWhatShadowsThePipelineAndTheLightsAskFor)
{
    m_Pipeline.shadows.mainLightShadowmapResolution = 1024;
    m_Pipeline.shadows.additionalLightsShadowmapResolution = 512;
    m_Pipeline.shadows.shadowCascadeCount = 3;
    m_Pipeline.shadows.cascade3Split = {0.2f, 0.5f};
    m_Pipeline.shadows.cascadeBorder = 0.3f;
    Add(LightType::Spot, {0, 0, 5});
    const ShadowData none = Render().shadows;
    EXPECT_FALSE(none.supportsMainLightShadows) << "it throws none";
    EXPECT_FALSE(none.supportsAdditionalLightShadows);
    EXPECT_FALSE(none.supportsSoftShadows);

    m_Scene.mainLight.shadows = LightShadows::Hard;
    for (const ShadowData& data : {Render().shadows, m_Seen.shadowsInGraph})
    {
        EXPECT_TRUE(data.supportsMainLightShadows);
        EXPECT_FALSE(data.supportsAdditionalLightShadows);
        EXPECT_TRUE(data.supportsSoftShadows);
        EXPECT_EQ(data.mainLightShadowmapWidth, 1024);
        EXPECT_EQ(data.mainLightShadowmapHeight, 1024);
        EXPECT_EQ(data.additionalLightsShadowmapWidth, 512);
        EXPECT_EQ(data.additionalLightsShadowmapHeight, 512);
        EXPECT_EQ(data.mainLightShadowCascadesCount, 3);
        EXPECT_EQ(data.mainLightShadowCascadesSplit, glm::vec3(0.2f, 0.5f, 0.0f));
        EXPECT_EQ(data.mainLightShadowCascadeBorder, 0.3f);
        EXPECT_EQ(data.shadowmapDepthBufferBits, 32);
    }
    m_Scene.additionalLights[0].shadows = LightShadows::Hard;
    m_Scene.mainLight.intensity = 0.0f;
    EXPECT_TRUE(Render().shadows.supportsAdditionalLightShadows);
    EXPECT_FALSE(m_Seen.shadows.supportsMainLightShadows) << "there is no main light";
    m_Pipeline.maxAdditionalLightsCount = 0;
    EXPECT_FALSE(Render().shadows.supportsAdditionalLightShadows);
    EXPECT_FALSE(m_Seen.data.supportsAdditionalLights);
}

TEST_F(LightDataOfAFrame, HasSplitsAsUrpHasThemForEachNumberOfCascades)
{
    ShadowSettings& settings = m_Pipeline.shadows;
    settings.cascade2Split = 0.4f;
    settings.cascade4Split = {0.1f, 0.2f, 0.3f};
    const std::vector<glm::vec3> expected{
        {1, 0, 0}, {0.4f, 1, 0}, {0.1f, 0.3f, 0}, {0.1f, 0.2f, 0.3f}};
    for (int count = 1; count <= 4; ++count)
    {
        settings.shadowCascadeCount = count;
        EXPECT_EQ(Render().shadows.mainLightShadowCascadesSplit,
                  expected[static_cast<std::size_t>(count) - 1]);
    }
}

/// Shadow passes bias what they draw, and nothing that is drawn behind them.
TEST_F(LightDataOfAFrame, BiasesTheDepthOfShadowPassesOnly)
{
    const auto shader =
        ShaderOf("Shader \"Test/Caster\" { SubShader {\n"
                 "Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n" +
                 Program("#pragma multi_compile _ _ADDITIONAL_LIGHT_SHADOWS") +
                 "}\nPass { Tags { \"LightMode\" = \"ShadowCaster\" }\n" + Program() + "} } }");
    AddCube(m_Scene, "Cube", {0, 0, 3}, {std::make_shared<Material>(shader)});
    m_Camera.transform.localPosition = {0, 0, -3};
    Light& spot = Add(LightType::Spot, {0, 0, 0});
    spot.range = 20.0f;
    spot.shadows = LightShadows::Hard;
    m_Request.compile.leavesOut = false; // nothing reads the shadow map here
    ASSERT_TRUE(Render().shadows.supportsAdditionalLightShadows);
    int biased = 0;
    int plain = 0;
    for (const CompiledRenderPass& pass : m_Result.frame->passes)
    {
        for (const PassCommand& command : pass.commands)
        {
            if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                const bool isShadow = pass.colors.empty();
                const PipelineState& state = m_Result.frame->Setup(*draw).state;
                EXPECT_EQ(state.offsetFactor != 0.0f, isShadow) << pass.name;
                EXPECT_EQ(state.offsetUnits != 0.0f, isShadow) << pass.name;
                ++(isShadow ? biased : plain);
            }
        }
    }
    EXPECT_GT(biased, 0);
    EXPECT_GT(plain, 0);
}

TEST_F(LightDataOfAFrame, HasABiasOfEachVisibleLight)
{
    m_Pipeline.shadows.shadowDepthBias = 3.0f;
    m_Pipeline.shadows.shadowNormalBias = 2.0f;
    Light& own = Add(LightType::Spot, {0, 0, 5});
    own.usePipelineSettings = false;
    own.shadowBias = 0.25f;
    own.shadowNormalBias = 0.75f;
    EXPECT_THAT(Render().biases,
                testing::ElementsAre(glm::vec4(3, 2, 0, 0), glm::vec4(0.25f, 0.75f, 0, 0)));
    m_Scene.mainLight.intensity = 0.0f;
    EXPECT_THAT(Render().biases, testing::ElementsAre(glm::vec4(0.25f, 0.75f, 0, 0)));
}

TEST_F(LightDataOfAFrame, HasTheResolutionThatEachVisibleLightAsksFor)
{
    using Tier = AdditionalLightsShadowResolutionTier;
    m_Pipeline.shadows.additionalLightsShadowResolutionTierLow = 64;
    Add(LightType::Spot, {0, 0, 5}).additionalLightsShadowResolutionTier = Tier::Low;
    Add(LightType::Spot, {0, 0, 5}).additionalLightsShadowResolutionTier = Tier::Medium;
    Light& own = Add(LightType::Point, {0, 0, 5});
    own.additionalLightsShadowResolutionTier = Tier::Custom;
    own.shadowResolution = 96;
    Add(LightType::Spot, {0, 0, 5});
    EXPECT_THAT(Render().resolutions, testing::ElementsAre(1024, 64, 512, 96, 1024));
    m_Scene.mainLight.intensity = 0.0f;
    EXPECT_THAT(Render().resolutions, testing::ElementsAre(64, 512, 96, 1024));
}

TEST_F(LightDataOfAFrame, SaysHowManyAnObjectMayHave)
{
    m_Pipeline.maxAdditionalLightsCount = 7;
    EXPECT_EQ(Render().data.maxPerObjectAdditionalLightsCount, 7);
    for (const int count : {-1, 9})
    {
        m_Pipeline.maxAdditionalLightsCount = count;
        EXPECT_THAT([&] { Render(); },
                    testing::ThrowsMessage<ContractError>(
                        Mentions("maxAdditionalLightsCount", std::to_string(count), "0 to 8")));
    }
}

TEST_F(LightDataOfAFrame, TurnsAMainLightThatShinesDown)
{
    m_Scene.mainLight.direction = {0.0f, -1.0f, 0.0f};
    const glm::dmat4& matrix = Render().lights.at(0).localToWorldMatrix;
    EXPECT_EQ(glm::dvec3(matrix[2]), glm::dvec3(0, -1, 0));
    EXPECT_NEAR(glm::determinant(glm::dmat3(matrix)), 1.0, 1e-12);
}

} // namespace
} // namespace limn::test
