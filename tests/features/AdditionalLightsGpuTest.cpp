#include "Mentions.h"
#include "features/color_edges/PictureRun.h"

#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

constexpr int k_WallWidth = 40;
constexpr int k_WallHeight = 24;
constexpr int k_Panels = 4;
constexpr float k_PanelWidth = 10.0f;

/// A wall of upright panels seen from in front, a pixel a metre: its middle is at (0, 0, 10).
class AdditionalLightsGpu : public GpuTest
{
protected:
    AdditionalLightsGpu()
        : m_Wall(k_WallWidth, k_WallHeight),
          m_Run(m_Wall.scene, m_Wall.camera, k_WallWidth, k_WallHeight)
    {
        const auto shader = FindBuiltinShader("Limn/Half Lambert", Compiler());
        const auto material = std::make_shared<Material>(shader);
        material->SetVector(ShaderPropertyId("_BaseColor"), {0.6f, 0.3f, 0.9f, 1.0f});
        material->SetFloat(ShaderPropertyId("_Smoothness"), 0.0f); // no highlight
        for (int panel = 0; panel < k_Panels; ++panel)
        {
            const float left = k_PanelWidth * static_cast<float>(panel);
            m_Wall.Add({left, 0}, {left + k_PanelWidth, k_WallHeight}, 10, material);
        }
        m_Wall.scene.mainLight.intensity = 0.2f;
    }

    std::vector<Light>& lights() { return m_Wall.scene.additionalLights; }

    /// The wall's picture against the one without lights and what they add to it in double.
    /// @param limit  how many light a panel, the brightest; at most 8
    void ExpectLitByFormula(int limit = 4)
    {
        m_Run.SetLightLimit(limit);
        std::vector<Light> all = std::exchange(lights(), {});
        const Field dark = m_Run.Color(nullptr);
        lights() = all;
        const Field picture = m_Run.Color(nullptr);
        double most = 0.0;
        for (int y = 0; y < k_WallHeight; ++y)
        {
            for (int x = 0; x < k_WallWidth; ++x)
            {
                const glm::dvec3 place(x + 0.5 - k_WallWidth / 2.0, k_WallHeight / 2.0 - y - 0.5,
                                       10.0);
                glm::dvec3 added(0.0);
                for (const Light& light : BrightestOn(x / 10, all, limit))
                {
                    added += Received(light, place) * glm::dvec3(0.6, 0.3, 0.9);
                }
                for (int channel = 0; channel < 3; ++channel)
                {
                    const double wanted = dark.At(x, y, channel) + added[channel];
                    // Two roundings to halves, of 2^-11 each, and what lies between.
                    ASSERT_NEAR(picture.At(x, y, channel), wanted, 2e-3 * wanted + 1e-4)
                        << x << ", " << y << ", channel " << channel;
                }
                most = std::max(most, added.x);
            }
        }
        EXPECT_GT(most, 0.05) << "nothing is lit";
    }

    /// Of points and directional lights: their strength at the nearest point of a panel.
    static std::vector<Light> BrightestOn(int panel, std::vector<Light> all, int limit)
    {
        const auto strength = [&](const Light& light)
        {
            if (light.type == LightType::Directional)
            {
                return static_cast<double>(light.intensity);
            }
            const glm::dvec3 place(light.transform.localPosition);
            const double left = panel * 10.0 - 20.0;
            const glm::dvec3 nearest(std::clamp(place.x, left, left + 10.0),
                                     std::clamp(place.y, -12.0, 12.0), 10.0);
            const double distance = glm::distance(place, nearest);
            const double window =
                std::max(1.0 - std::pow(distance / static_cast<double>(light.range), 4), 0.0);
            return static_cast<double>(light.intensity) * window * window / (distance * distance);
        };
        if (all.size() > static_cast<std::size_t>(limit))
        {
            std::ranges::stable_sort(all, std::greater(), strength);
            all.resize(static_cast<std::size_t>(limit));
        }
        return all;
    }

    /// Karis 2013: the inverse square, to 0 at the range; a spot's cone squared; Lambert.
    static glm::dvec3 Received(const Light& light, const glm::dvec3& place)
    {
        const glm::dvec3 normal(0, 0, -1);
        const glm::dvec3 forward(light.transform.forward());
        const glm::dvec3 away = glm::dvec3(light.transform.localPosition) - place;
        const bool isDirectional = light.type == LightType::Directional;
        const double distance = glm::length(away);
        const glm::dvec3 toLight = isDirectional ? -forward : away / distance;
        double strength =
            static_cast<double>(light.intensity) * std::max(glm::dot(normal, toLight), 0.0);
        if (!isDirectional)
        {
            const double part = distance / static_cast<double>(light.range);
            const double window = std::clamp(1.0 - std::pow(part, 4), 0.0, 1.0);
            strength *= window * window / (distance * distance);
        }
        if (light.type == LightType::Spot)
        {
            const double outer = std::cos(glm::radians(static_cast<double>(light.spotAngle)) / 2);
            const double inner =
                std::cos(glm::radians(static_cast<double>(light.innerSpotAngle)) / 2);
            const double cone =
                std::clamp((glm::dot(-toLight, forward) - outer) / (inner - outer), 0.0, 1.0);
            strength *= cone * cone;
        }
        const Color color = light.color.linear();
        return strength * glm::dvec3(color.r, color.g, color.b);
    }

    FlatScene m_Wall;
    PictureRun m_Run;
};

Light Spot(const glm::vec3& position, const glm::vec3& degrees)
{
    Light light;
    light.type = LightType::Spot;
    light.transform.localPosition = position;
    light.transform.localRotation = EulerToRotation(degrees);
    light.intensity = 40.0f;
    light.range = 30.0f;
    light.spotAngle = 70.0f;
    light.innerSpotAngle = 25.0f;
    return light;
}

TEST_F(AdditionalLightsGpu, FadesWithTheDistanceUpToTheRange)
{
    Light light;
    light.transform.localPosition = {-6.0f, 2.0f, 7.0f};
    light.color = {1.0f, 0.7f, 0.4f, 1.0f};
    light.intensity = 5.0f;
    light.range = 9.0f;
    lights() = {light};
    ExpectLitByFormula();
}

TEST_F(AdditionalLightsGpu, FadesToTheBorderOfASpot)
{
    lights() = {Spot({4.0f, 1.0f, 0.0f}, {20.0f, -15.0f, 0.0f})};
    ExpectLitByFormula();
}

TEST_F(AdditionalLightsGpu, AddsUp)
{
    Light sun;
    sun.type = LightType::Directional;
    sun.transform.localRotation = EulerToRotation({30.0f, 20.0f, 0.0f});
    sun.intensity = 0.3f;
    Light bulb;
    bulb.transform.localPosition = {10.0f, -5.0f, 8.0f};
    Light behindTheWall = bulb;
    behindTheWall.transform.localPosition.z = 12.0f;
    lights() = {sun, bulb, Spot({-8.0f, 0.0f, 2.0f}, {0.0f, 0.0f, 0.0f}), behindTheWall};
    ExpectLitByFormula();
}

TEST_F(AdditionalLightsGpu, LightsTheWallFromOutsideOfThePicture)
{
    Light light;
    light.transform.localPosition = {24.0f, 0.0f, 8.0f}; // 4 m to the right of it
    light.intensity = 20.0f;
    lights() = {light};
    ExpectLitByFormula();
}

TEST_F(AdditionalLightsGpu, LightTheSameFarAwayFromTheWorldsOrigin)
{
    Transform away;
    m_Wall.camera.transform.parent = &away;
    for (const auto& object : m_Wall.scene.objects())
    {
        object->transform.parent = &away;
    }
    Light bulb;
    bulb.transform.localPosition = {-6.25f, 2.5f, 7.125f};
    bulb.intensity = 5.0f;
    Light sun;
    sun.type = LightType::Directional;
    sun.transform.localRotation = EulerToRotation({30.0f, 20.0f, 0.0f});
    sun.intensity = 0.3f;
    lights() = {bulb, sun, Spot({4.25f, 1.5f, 0.0f}, {20.0f, -15.0f, 0.0f})};
    for (Light& light : lights())
    {
        light.transform.parent = &away;
    }
    for (const glm::vec3& place : {glm::vec3(0.0f), glm::vec3(1e5f, 2e5f, -1e5f),
                                   glm::vec3(1e7f, -1e7f, 5e6f), glm::vec3(1e9f, 0.0f, 1e9f)})
    {
        SCOPED_TRACE(place.x);
        away.localPosition = place;
        ExpectLitByFormula();
    }
}

/// How many uniforms of lights what is drawn in a frame has.
std::size_t LightsOf(const RenderResult& result)
{
    for (const DrawSetup& setup : result.frame->setups)
    {
        for (const UniformBuffer& buffer : setup.program->layout.buffers)
        {
            if (buffer.name == "AdditionalLights")
            {
                return buffer.members.size();
            }
        }
    }
    return 0;
}

TEST_F(AdditionalLightsGpu, CostNothingWhereNoneReachesIntoThePicture)
{
    m_Run.Render(nullptr, true);
    EXPECT_EQ(LightsOf(m_Run.result()), 0u);
    Light light;
    lights() = {light};
    m_Run.Render(nullptr, true);
    EXPECT_GT(LightsOf(m_Run.result()), 0u);
    lights()[0].transform.localPosition = {0.0f, 23.0f, 10.0f}; // 11 m above it, 10 m range
    m_Run.Render(nullptr, true);
    EXPECT_EQ(LightsOf(m_Run.result()), 0u);
}

TEST_F(AdditionalLightsGpu, SaysThatTheyAreTooMany)
{
    Light light;
    light.transform.localPosition = {0.0f, 0.0f, 5.0f};
    light.intensity = 1.0f;
    lights().assign(33, light);
    m_Run.Render(nullptr);
    EXPECT_THAT(m_Run.result().report.notes, testing::Contains(Mentions("33 lights", "first 32")));
    lights().pop_back();
    ExpectLitByFormula();
}

TEST_F(AdditionalLightsGpu, AreTheBrightestOnesOfEachPanel)
{
    Light sun;
    sun.type = LightType::Directional;
    sun.transform.localRotation = EulerToRotation({30.0f, 20.0f, 0.0f});
    sun.intensity = 0.02f;
    lights() = {sun};
    for (int i = 0; i < 20; ++i)
    {
        Light& bulb = lights().emplace_back();
        bulb.transform.localPosition = {2.0f * static_cast<float>(i) - 19.0f,
                                        static_cast<float>(i * 7 % 20) - 10.0f, 7.5f};
        bulb.intensity = 0.5f + 0.25f * static_cast<float>(i % 7);
        bulb.range = 14.0f;
        bulb.color = {1.0f, 0.1f * static_cast<float>(i % 10), 0.3f, 1.0f};
    }
    for (const int limit : {1, 3, 4, 8})
    {
        SCOPED_TRACE(limit);
        ExpectLitByFormula(limit);
    }
    m_Run.SetLightLimit(0);
    const Field none = m_Run.Color(nullptr);
    EXPECT_EQ(LightsOf(m_Run.result()), 0u);
    lights().clear();
    EXPECT_EQ(CountDifferent(none, m_Run.Color(nullptr)), 0);
}

/// Draws objects by cmd.DrawMesh or cmd.DrawRenderer, which the camera does not see itself.
class PanelsByHand final : public ScriptableRendererFeature
{
public:
    PanelsByHand(const Scene& scene, bool asRenderers)
    {
        m_Pass.scene = &scene;
        m_Pass.asRenderers = asRenderers;
    }
    void Create() override { m_Pass.renderPassEvent = RenderPassEvent::AfterRenderingOpaques; }
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    struct Pass final : ScriptableRenderPass
    {
        void Execute(ScriptableRenderContext& context, RenderingData&) override
        {
            const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
            for (const auto& object : scene->objects())
            {
                const std::shared_ptr<const Material> material = object->renderer->sharedMaterial();
                if (asRenderers)
                {
                    cmd->DrawRenderer(*object, material, 0, 0);
                }
                else
                {
                    cmd->DrawMesh(object->renderer->mesh, object->transform.localToWorldMatrix(),
                                  material);
                }
            }
            context.ExecuteCommandBuffer(*cmd);
        }
        const Scene* scene = nullptr;
        bool asRenderers = false;
    };
    Pass m_Pass;
};

TEST_F(AdditionalLightsGpu, AreTheSameForPanelsThatACommandBufferDraws)
{
    for (int i = 0; i < 16; ++i)
    {
        Light& bulb = lights().emplace_back();
        bulb.transform.localPosition = {2.5f * static_cast<float>(i) - 19.0f, 2.0f, 8.0f};
        bulb.range = 9.0f;
        bulb.intensity = 1.0f + static_cast<float>(i % 5);
    }
    m_Run.SetLightLimit(2);
    const Field byCamera = m_Run.Color(nullptr);
    for (const bool asRenderers : {false, true})
    {
        SCOPED_TRACE(asRenderers);
        PictureRun run(m_Wall.scene, m_Wall.camera, k_WallWidth, k_WallHeight);
        run.SetLightLimit(2);
        run.Add(std::make_unique<PanelsByHand>(m_Wall.scene, asRenderers));
        const LayerMask all = std::exchange(m_Wall.camera.cullingMask, LayerMask::Nothing());
        EXPECT_EQ(CountDifferent(byCamera, run.Color(nullptr)), 0);
        m_Wall.camera.cullingMask = all;
    }
}

TEST_F(AdditionalLightsGpu, AreTheSameBitForBitWhereNoPanelHasMoreThanTheLimit)
{
    for (int i = 0; i < 8; ++i)
    {
        Light& bulb = lights().emplace_back();
        bulb.transform.localPosition = {5.0f * static_cast<float>(i) - 17.5f, 3.0f, 8.0f};
        bulb.range = 6.0f; // four of them reach a panel
        bulb.intensity = 1.0f + static_cast<float>(i);
    }
    m_Run.SetLightLimit(8);
    const Field all = m_Run.Color(nullptr);
    m_Run.SetLightLimit(4);
    EXPECT_EQ(CountDifferent(all, m_Run.Color(nullptr)), 0);
    m_Run.SetLightLimit(3);
    EXPECT_GT(CountDifferent(all, m_Run.Color(nullptr)), 0);
}

} // namespace
} // namespace limn::test
