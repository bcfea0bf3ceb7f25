#include "Mentions.h"
#include "features/shadows/ShadowScene.h"

#include <gmock/gmock.h>
#include <utility>

namespace limn::test
{
namespace
{

constexpr int k_AcrossPicture = 80;
constexpr int k_DownPicture = 56;
constexpr const char* k_Pass = "AdditionalLightsShadow";

/// What GetAdditionalLight says of a light's shadow.
std::shared_ptr<Material> ShadowOf(int index,
                                   const std::shared_ptr<ShaderCompiler>& compiler = Compiler())
{
    return Attenuation("GetAdditionalLight(" + std::to_string(index) +
                           ", positionWS, float4(1, 1, 1, 1))",
                       compiler);
}

std::shared_ptr<Material> Lit()
{
    return std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
}

Light Spot()
{
    Light light;
    light.type = LightType::Spot;
    light.transform.localPosition = {-6.0f, 7.0f, -3.0f};
    light.transform.localRotation =
        LookRotation(glm::vec3(0.5f, 0.5f, 3.5f) - light.transform.localPosition);
    light.range = 22.0f;
    light.spotAngle = 75.0f;
    light.intensity = 60.0f;
    light.shadows = LightShadows::Hard;
    return light;
}

Light Bulb()
{
    Light light;
    light.type = LightType::Point;
    light.transform.localPosition = {1.0f, 4.5f, 0.5f};
    light.range = 16.0f;
    light.intensity = 20.0f;
    light.shadows = LightShadows::Hard;
    return light;
}

/// Small pictures of boxes on a floor.
class AdditionalLightShadowGpu : public GpuTest
{
protected:
    AdditionalLightShadowGpu() : m_Pipeline(SharedDevice())
    {
        m_Pipeline.shadows.shadowDistance = 60.0f; // they fade behind all that is looked at
        m_Pipeline.shadows.shadowDepthBias = 0.5f;
        m_Pipeline.shadows.shadowNormalBias = 0.5f;
    }

    Field Draw(const ShadowScene& shadows) { return Draw(shadows, m_Renderer); }
    Field Draw(const ShadowScene& shadows, UniversalRenderer& renderer)
    {
        RenderRequest request;
        request.scene = &shadows.scene;
        request.camera = &shadows.camera;
        request.width = k_AcrossPicture;
        request.height = k_DownPicture;
        m_Result = m_Pipeline.RenderSingleCamera(renderer, request);
        return ToField(SharedDevice().ReadBack(*m_Result.output.rt()));
    }
    bool HasPass() const
    {
        return std::ranges::any_of(m_Result.report.passes, [](const ExecutedPassReport& pass)
                                   { return pass.name.name() == k_Pass; });
    }

    struct Agreement
    {
        int lit = 0;
        int shadowed = 0;
        int different = 0;
        int rim = 0;
    };
    /// @param rim  how far from a shadow's edge nothing is said, metres
    static Agreement Compare(const Field& picture, const ShadowScene& shadows, const Light& light,
                             double rim)
    {
        Agreement result;
        for (int y = 0; y < picture.height; ++y)
        {
            for (int x = 0; x < picture.width; ++x)
            {
                const auto expected = Expect(shadows, light, x + 0.5, y + 0.5, rim);
                if (!expected)
                {
                    ++result.rim;
                    continue;
                }
                (*expected ? result.lit : result.shadowed) += 1;
                const double wanted = *expected ? 1.0 : 0.0;
                // A texel of the map holds the depth of a place that may lie SubPixel() of it away
                // along each of two axes, and a comparison counts by a weight that grows by 1 a
                // texel: a face that just does not shade itself may do so by as much.
                const double allowed = std::max(0.01, 2.0 * SubPixel());
                result.different += std::abs(picture.At(x, y, 0) - wanted) > allowed ? 1 : 0;
            }
        }
        return result;
    }

    /// Whether a pixel is lit; nothing on an edge, of an object or a shadow, on faces that the
    /// light grazes, and where it does not reach.
    static std::optional<bool> Expect(const ShadowScene& shadows, const Light& light, double x,
                                      double y, double rim)
    {
        const ShadowScene::Ray ray = shadows.RayThrough(x, y);
        const auto hit = shadows.Cast(ray);
        if (!hit)
        {
            return std::nullopt;
        }
        for (const glm::dvec2& step :
             {glm::dvec2(0.6, 0), glm::dvec2(-0.6, 0), glm::dvec2(0, 0.6), glm::dvec2(0, -0.6)})
        {
            const auto other = shadows.Cast(shadows.RayThrough(x + step.x, y + step.y));
            if (!other || other->box != hit->box || other->normal != hit->normal)
            {
                return std::nullopt;
            }
        }
        const glm::dvec3 place = ray.origin + ray.direction * hit->distance;
        const glm::dvec3 away = glm::dvec3(light.transform.localPosition) - place;
        const double distance = glm::length(away);
        const double facing = glm::dot(hit->normal, away) / distance;
        const double angle = glm::degrees(
            std::acos(glm::dot(-away, glm::dvec3(light.transform.forward())) / distance));
        const bool isOutside =
            light.type == LightType::Spot && angle > static_cast<double>(light.spotAngle) / 2 - 1.0;
        if (std::abs(facing) < 0.15 || isOutside ||
            distance > 0.95 * static_cast<double>(light.range))
        {
            return std::nullopt;
        }
        const bool isLit = IsLit(shadows, light, place, hit->normal);
        for (const glm::dvec2& moved : MovedPlaces({x, y}))
        {
            const ShadowScene::Ray other = shadows.RayThrough(moved.x, moved.y);
            const glm::dvec3 taken = other.origin + other.direction * shadows.Cast(other)->distance;
            if (!IsAllLit(shadows, light, taken, hit->normal, rim / std::abs(facing), isLit))
            {
                return std::nullopt;
            }
        }
        return isLit;
    }

    /// Whether a place and those around it, as far as this, are all lit or all not.
    static bool IsAllLit(const ShadowScene& shadows, const Light& light, const glm::dvec3& place,
                         const glm::dvec3& normal, double radius, bool isLit)
    {
        const glm::dvec3 across = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.8)));
        for (int step = 0; step < 16; ++step)
        {
            const glm::dquat turn = glm::angleAxis(step * glm::radians(22.5), normal);
            for (const double part : {0.5, 1.0})
            {
                const glm::dvec3 other = place + turn * across * (part * radius);
                if (IsLit(shadows, light, other, normal) != isLit)
                {
                    return false;
                }
            }
        }
        return true;
    }

    static bool IsLit(const ShadowScene& shadows, const Light& light, const glm::dvec3& place,
                      const glm::dvec3& normal)
    {
        const glm::dvec3 away = glm::dvec3(light.transform.localPosition) - place;
        if (glm::dot(normal, away) < 0.0)
        {
            return false;
        }
        const auto hit = shadows.Cast({place, glm::normalize(away)});
        return !hit || hit->distance >= glm::length(away);
    }

    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
    RenderResult m_Result;
};

TEST_F(AdditionalLightShadowGpu, FallsWhereADoublePrecisionRayMeetsABox)
{
    ShadowScene shadows(k_AcrossPicture, k_DownPicture, ShadowOf(0));
    shadows.scene.mainLight.shadows = LightShadows::None;
    shadows.AddBoxes();
    for (Light light : {Spot(), Bulb()})
    {
        for (const int softness : {0, 1, 2, 3})
        {
            SCOPED_TRACE(std::to_string(static_cast<int>(light.type)) + ", soft " +
                         std::to_string(softness));
            light.shadows = softness > 0 ? LightShadows::Soft : LightShadows::Hard;
            light.softShadowQuality = static_cast<SoftShadowQuality>(softness);
            shadows.scene.additionalLights = {light};
            // Texels at the light's range: a side of the point's cube has 512 of 0.06 m, the spot's
            // square 2048 of 0.016 m. A filter reaches up to 3.5 of them and a half, and the bias
            // is half of that, along the light and the normal.
            const double texel = light.type == LightType::Point ? 0.06 : 0.016;
            const double rim = texel * (1.5 + softness * 1.5) + 0.05;
            const Field picture = Draw(shadows);
            EXPECT_TRUE(HasPass());
            const Agreement agreement = Compare(picture, shadows, light, rim);
            EXPECT_EQ(agreement.different, 0);
            EXPECT_GT(agreement.lit, 500);
            EXPECT_GT(agreement.shadowed, 100);
            EXPECT_LT(agreement.rim, k_AcrossPicture * k_DownPicture * 3 / 4);
        }
    }
}

TEST_F(AdditionalLightShadowGpu, IsEachLightsOwn)
{
    Light dark = Bulb();
    dark.shadows = LightShadows::None;
    dark.transform.localPosition.x += 1.0f;
    std::vector<Light> lights{Spot(), dark, Bulb()};
    Light& other = lights.emplace_back(Spot());
    other.transform.localPosition = {6.0f, 6.0f, -2.0f};
    other.transform.localRotation =
        LookRotation(glm::vec3(0.0f, 0.5f, 3.0f) - other.transform.localPosition);
    for (int i = 0; i < 4; ++i)
    {
        SCOPED_TRACE(i);
        ShadowScene shadows(k_AcrossPicture, k_DownPicture, ShadowOf(i));
        shadows.scene.mainLight.shadows = LightShadows::None;
        shadows.AddBoxes();
        shadows.scene.additionalLights = lights;
        const Field picture = Draw(shadows);
        if (i == 1)
        {
            EXPECT_TRUE(
                std::ranges::all_of(picture.values, [](double v) { return v == 1.0 || v == 0.0; }));
            continue;
        }
        const Agreement agreement =
            Compare(picture, shadows, lights[static_cast<std::size_t>(i)], 0.15);
        EXPECT_EQ(agreement.different, 0);
        EXPECT_GT(agreement.shadowed, 100);
    }
}

TEST_F(AdditionalLightShadowGpu, IsTheSameWhicheverWayRoundDepthIs)
{
    for (const bool reversed : {true, false})
    {
        ShaderCompilerOptions options;
        options.usesReversedZBuffer = reversed;
        const auto compiler = std::make_shared<ShaderCompiler>(options);
        UniversalRenderer renderer(compiler);
        ShadowScene shadows(k_AcrossPicture, k_DownPicture, ShadowOf(0, compiler));
        shadows.scene.mainLight.shadows = LightShadows::None;
        shadows.AddBoxes();
        shadows.scene.additionalLights = {Bulb()};
        const Agreement agreement = Compare(Draw(shadows, renderer), shadows, Bulb(), 0.15);
        EXPECT_EQ(agreement.different, 0) << reversed;
        EXPECT_GT(agreement.shadowed, 100);
    }
}

TEST_F(AdditionalLightShadowGpu, TakesItsStrengthAndFadesToTheDistance)
{
    ShadowScene shadows(k_AcrossPicture, k_DownPicture, ShadowOf(0));
    shadows.scene.mainLight.shadows = LightShadows::None;
    GameObject& roof = shadows.Add({0.0f, 20.0f, 0.0f}, {180.0f, 1.0f, 180.0f});
    roof.renderer->shadowCastingMode = ShadowCastingMode::ShadowsOnly;
    Light bulb = Bulb();
    bulb.transform.localPosition = {0.0f, 40.0f, 0.0f};
    bulb.range = 100.0f;
    bulb.shadowStrength = 0.75f;
    shadows.scene.additionalLights = {bulb};
    m_Pipeline.shadows.shadowDistance = 20.0f;
    PictureRun run(shadows.scene, shadows.camera, k_AcrossPicture, k_DownPicture);
    run.SetShadows(m_Pipeline.shadows);
    const Field picture = run.Color(nullptr);
    shadows.boxes.clear(); // rays pass the roof
    int between = 0;
    for (int y = 0; y < k_DownPicture; ++y)
    {
        for (int x = 0; x < k_AcrossPicture; ++x)
        {
            const auto hit = shadows.Cast(shadows.RayThrough(x + 0.5, y + 0.5));
            if (!hit || hit->distance > 50.0)
            {
                continue;
            }
            const auto [low, high] = FadeAt(shadows, x, y);
            between += low > 0.0 && high < 1.0 ? 1 : 0;
            const double seen = picture.At(x, y, 0);
            ASSERT_NEAR(seen, std::clamp(seen, 0.25 + 0.75 * low, 0.25 + 0.75 * high), 1e-3)
                << x << ", " << y;
        }
    }
    EXPECT_GT(between, 100);
}

/// A picture in the shade is the one without the light, and elsewhere the one without shadows.
TEST_F(AdditionalLightShadowGpu, TakesTheLightFromLit)
{
    ShadowScene shadows(k_AcrossPicture, k_DownPicture, Lit());
    shadows.scene.mainLight.shadows = LightShadows::None;
    shadows.scene.mainLight.intensity = 0.3f;
    shadows.AddBoxes();
    const Field dark = Draw(shadows);
    for (const Light& light : {Spot(), Bulb()})
    {
        shadows.scene.additionalLights = {light};
        const Field picture = Draw(shadows);
        shadows.scene.additionalLights[0].shadows = LightShadows::None;
        const Field bright = Draw(shadows);
        int shaded = 0;
        for (int y = 0; y < k_DownPicture; ++y)
        {
            for (int x = 0; x < k_AcrossPicture; ++x)
            {
                const auto isLit = Expect(shadows, light, x + 0.5, y + 0.5, 0.15);
                if (isLit)
                {
                    const Field& wanted = *isLit ? bright : dark;
                    shaded += !*isLit && bright.At(x, y, 0) > dark.At(x, y, 0) ? 1 : 0;
                    ASSERT_EQ(picture.At(x, y, 0), wanted.At(x, y, 0)) << x << ", " << y;
                }
            }
        }
        EXPECT_GT(shaded, 50);
    }
}

TEST_F(AdditionalLightShadowGpu, IsTheSameFarAwayFromTheWorldsOrigin)
{
    ShadowScene shadows(k_AcrossPicture, k_DownPicture, Lit());
    shadows.scene.mainLight.shadows = LightShadows::None;
    shadows.AddBoxes();
    shadows.scene.additionalLights = {Spot(), Bulb()};
    Transform away;
    shadows.camera.transform.parent = &away;
    for (const auto& object : shadows.scene.objects())
    {
        object->transform.parent = &away;
    }
    for (Light& light : shadows.scene.additionalLights)
    {
        light.transform.parent = &away;
    }
    const Field near = Draw(shadows);
    for (const glm::vec3& place : {glm::vec3(1e5f, 2e5f, -1e5f), glm::vec3(1e7f, -1e7f, 5e6f)})
    {
        away.localPosition = place;
        const Field far = Draw(shadows);
        EXPECT_TRUE(HasPass());
        int different = 0;
        for (std::size_t i = 0; i < near.values.size(); ++i)
        {
            different += std::abs(near.values[i] - far.values[i]) > 2.0 / 255.0 ? 1 : 0;
        }
        EXPECT_LT(different, k_AcrossPicture * k_DownPicture / 100) << "rims fall between texels";
    }
}

TEST_F(AdditionalLightShadowGpu, CostsNothingWhereNothingThrowsOrShowsIt)
{
    ShadowScene shadows(k_AcrossPicture, k_DownPicture, Lit());
    shadows.scene.mainLight.shadows = LightShadows::None;
    shadows.AddBoxes();
    Light light = Bulb();
    const auto expectNone = [&](const std::string& why)
    {
        SCOPED_TRACE(why);
        shadows.scene.additionalLights = {light};
        const Field picture = Draw(shadows);
        EXPECT_FALSE(HasPass());
        for (const CompiledRenderPass& pass : m_Result.frame->passes)
        {
            EXPECT_EQ(pass.width, k_AcrossPicture) << pass.name;
        }
        for (const DrawSetup& setup : m_Result.frame->setups)
        {
            for (const UniformBuffer& buffer : setup.program->layout.buffers)
            {
                EXPECT_NE(buffer.name, "AdditionalLightShadows");
            }
        }
        return picture;
    };
    light.shadows = LightShadows::None;
    const Field without = expectNone("the light throws none");
    light.shadows = LightShadows::Soft;
    light.shadowStrength = 0.0f;
    EXPECT_EQ(CountDifferent(without, expectNone("they have no strength")), 0);
    light.shadowStrength = 1.0f;
    const float intensity = std::exchange(light.intensity, 0.0f);
    expectNone("the light has no intensity");
    light.intensity = intensity;
    m_Pipeline.shadows.additionalLightShadowsSupported = false;
    EXPECT_EQ(CountDifferent(without, expectNone("the pipeline has none")), 0);
    m_Pipeline.shadows.additionalLightShadowsSupported = true;
    m_Pipeline.shadows.shadowDistance = 0.1f;
    EXPECT_EQ(CountDifferent(without, expectNone("they end before all that is seen")), 0);
    m_Pipeline.shadows.shadowDistance = 60.0f;
    m_Pipeline.maxAdditionalLightsCount = 0;
    expectNone("nothing is lit by it");
    m_Pipeline.maxAdditionalLightsCount = 4;
    Draw(shadows);
    EXPECT_TRUE(HasPass());
    light.type = LightType::Directional;
    expectNone("directional ones have none");
    light.type = LightType::Point;
    for (const auto& object : shadows.scene.objects())
    {
        object->renderer->shadowCastingMode = ShadowCastingMode::Off;
    }
    EXPECT_EQ(CountDifferent(without, expectNone("no object throws one")), 0);
    for (const auto& object : shadows.scene.objects())
    {
        object->renderer->shadowCastingMode = ShadowCastingMode::On;
        object->renderer->sharedMaterials = {Plain({0.5f, 0.5f, 0.5f})};
    }
    expectNone("no shader shows one");
}

TEST_F(AdditionalLightShadowGpu, SaysWhichHaveNoRoom)
{
    ShadowScene shadows(k_AcrossPicture, k_DownPicture, Lit());
    shadows.AddBoxes();
    shadows.scene.additionalLights.assign(11, Bulb());
    m_Pipeline.shadows.additionalLightsShadowmapResolution = 256;
    Draw(shadows);
    EXPECT_TRUE(HasPass());
    EXPECT_THAT(m_Result.report.notes,
                testing::Contains(testing::AllOf(testing::StartsWith("1 light throws"),
                                                 Mentions("no shadows", "64 squares"))));
    m_Pipeline.shadows.additionalLightsShadowmapResolution = 32;
    EXPECT_THAT([&] { Draw(shadows); }, testing::ThrowsMessage<ContractError>(testing::HasSubstr(
                                            "additionalLightsShadowmapResolution")));
}

} // namespace
} // namespace limn::test
