#include "features/shadows/ShadowScene.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

constexpr int k_ShadowedWidth = 80;
constexpr int k_ShadowedHeight = 56;
constexpr float k_Distance = 20.0f;

std::vector<std::string> PassesOf(const RenderResult& result)
{
    std::vector<std::string> names;
    for (const ExecutedPassReport& pass : result.report.passes)
    {
        names.emplace_back(pass.name.name());
    }
    return names;
}

/// Small pictures of boxes on a floor.
class MainLightShadowGpu : public GpuTest
{
protected:
    MainLightShadowGpu() : m_Pipeline(SharedDevice())
    {
        m_Pipeline.shadows.shadowDistance = k_Distance;
        m_Pipeline.shadows.mainLightShadowmapResolution = 1024;
        m_Pipeline.shadows.shadowDepthBias = 0.5f;
        m_Pipeline.shadows.shadowNormalBias = 0.5f;
    }

    /// The camera's colour.
    Field Draw(const Scene& scene, const Camera& camera, int width = k_ShadowedWidth,
               int height = k_ShadowedHeight)
    {
        RenderRequest request;
        request.scene = &scene;
        request.camera = &camera;
        request.width = width;
        request.height = height;
        m_Result = m_Pipeline.RenderSingleCamera(m_Renderer, request);
        return ToField(SharedDevice().ReadBack(*m_Result.output.rt()));
    }
    Field Draw(const ShadowScene& shadows) { return Draw(shadows.scene, shadows.camera); }

    struct Agreement
    {
        int lit = 0;
        int shadowed = 0;
        int different = 0;
        int rim = 0;
    };
    /// @param rim  how far from a shadow's edge nothing is said, metres
    static Agreement Compare(const Field& picture, const ShadowScene& shadows, double rim)
    {
        Agreement result;
        for (int y = 0; y < picture.height; ++y)
        {
            for (int x = 0; x < picture.width; ++x)
            {
                const auto expected = Expect(shadows, x + 0.5, y + 0.5, rim);
                if (!expected)
                {
                    ++result.rim;
                    continue;
                }
                (*expected ? result.lit : result.shadowed) += 1;
                result.different += (picture.At(x, y, 0) > 0.5) != *expected ? 1 : 0;
            }
        }
        return result;
    }

    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
    RenderResult m_Result;

private:
    /// Whether a pixel is lit; nothing on an edge, of an object or a shadow, and on faces that the
    /// light grazes.
    static std::optional<bool> Expect(const ShadowScene& shadows, double x, double y, double rim)
    {
        const ShadowScene::Ray ray = shadows.RayThrough(x, y);
        const auto hit = shadows.Cast(ray);
        if (!hit || hit->distance > static_cast<double>(k_Distance) ||
            hit->distance < static_cast<double>(shadows.camera.nearClipPlane))
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
        const double facing = glm::dot(hit->normal, shadows.toLight());
        if (std::abs(facing) < 0.1)
        {
            return std::nullopt;
        }
        const glm::dvec3 place = ray.origin + ray.direction * hit->distance;
        const bool isLit = shadows.IsLit(place);
        const glm::dvec3 across =
            glm::normalize(glm::cross(hit->normal, glm::dvec3(0.3, 0.5, 0.8)));
        for (int step = 0; step < 16; ++step)
        {
            const glm::dquat turn = glm::angleAxis(step * glm::radians(22.5), hit->normal);
            if (shadows.IsLit(place + turn * across * (rim / std::abs(facing))) != isLit)
            {
                return std::nullopt;
            }
        }
        return isLit;
    }
};

TEST_F(MainLightShadowGpu, FallsWhereADoublePrecisionRayMeetsABox)
{
    ShadowScene shadows(k_ShadowedWidth, k_ShadowedHeight, Attenuation());
    shadows.AddBoxes();
    for (const bool orthographic : {false, true})
    {
        shadows.camera.orthographic = orthographic;
        for (const int cascades : {1, 2, 3, 4})
        {
            SCOPED_TRACE(std::to_string(cascades) + (orthographic ? ", orthographic" : ""));
            m_Pipeline.shadows.shadowCascadeCount = cascades;
            // A ball of up to 18 m radius on half the map: texels of up to 0.07 m. The bias is half
            // of one along the light and along the normal, and sampling blurs by a whole one.
            const Agreement agreement = Compare(Draw(shadows), shadows, 0.15);
            EXPECT_EQ(agreement.different, 0);
            EXPECT_GT(agreement.lit, 1000);
            EXPECT_GT(agreement.shadowed, 100);
            EXPECT_LT(agreement.rim, k_ShadowedWidth * k_ShadowedHeight / 2);
        }
    }
}

/// Shaders of the built-in pipeline know nothing of URP's bias, so the device's own has to keep
/// surfaces from shadowing themselves.
TEST_F(MainLightShadowGpu, FallsFromShadersWhoseFallbackIsUnitysToo)
{
    for (const char* fallback : {"Diffuse", "Legacy Shaders/Transparent/Cutout/VertexLit"})
    {
        SCOPED_TRACE(fallback);
        ShadowScene shadows(k_ShadowedWidth, k_ShadowedHeight,
                            Attenuation("GetMainLight(TransformWorldToShadowCoord(positionWS))",
                                        Compiler(), fallback));
        shadows.AddBoxes();
        const Agreement agreement = Compare(Draw(shadows), shadows, 0.15);
        EXPECT_EQ(agreement.different, 0);
        EXPECT_GT(agreement.lit, 1000);
        EXPECT_GT(agreement.shadowed, 100);
    }
}

TEST_F(MainLightShadowGpu, IsSharperWithMoreCascades)
{
    ShadowScene shadows(k_ShadowedWidth, k_ShadowedHeight, Attenuation());
    shadows.AddBoxes();
    m_Pipeline.shadows.shadowCascadeCount = 4;
    m_Pipeline.shadows.mainLightShadowmapResolution = 512;
    const int four = Compare(Draw(shadows), shadows, 0.02).different;
    m_Pipeline.shadows.shadowCascadeCount = 1;
    const int one = Compare(Draw(shadows), shadows, 0.02).different;
    EXPECT_LT(four, one);
}

TEST_F(MainLightShadowGpu, FadesToTheDistanceAndTakesItsStrengthAllOver)
{
    // Below a roof all is in shadow, in each cascade and between them.
    for (const int cascades : {1, 2, 3, 4})
    {
        SCOPED_TRACE(cascades);
        ShadowScene shadows(k_ShadowedWidth, k_ShadowedHeight,
                            Attenuation("GetMainLight(TransformWorldToShadowCoord(positionWS), "
                                        "positionWS, float4(1, 1, 1, 1))"));
        shadows.scene.mainLight.shadowStrength = 0.75f;
        GameObject& roof = shadows.Add({0.0f, 20.0f, 0.0f}, {180.0f, 1.0f, 180.0f});
        roof.renderer->shadowCastingMode = ShadowCastingMode::ShadowsOnly;
        m_Pipeline.shadows.shadowCascadeCount = cascades;
        m_Pipeline.shadows.shadowDistance = 20.0f;
        PictureRun run(shadows.scene, shadows.camera, k_ShadowedWidth, k_ShadowedHeight);
        run.SetShadows(m_Pipeline.shadows);
        const Field picture = run.Color(nullptr);
        shadows.boxes.clear(); // rays pass the roof
        int between = 0;
        for (int y = 0; y < k_ShadowedHeight; ++y)
        {
            for (int x = 0; x < k_ShadowedWidth; ++x)
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
}

TEST_F(MainLightShadowGpu, IsThrownByTheSidesThatTheCastingModeSays)
{
    ShadowScene shadows(k_ShadowedWidth, k_ShadowedHeight, Attenuation());
    GameObject& box = shadows.Add({0.0f, 2.0f, 2.0f}, {2.0f, 2.0f, 2.0f});
    using enum ShadowCastingMode;
    const Field on = Draw(shadows);
    box.renderer->shadowCastingMode = Off;
    const Field off = Draw(shadows);
    EXPECT_THAT(PassesOf(m_Result), testing::Contains("MainLightShadow")) << "the floor's";
    EXPECT_GT(CountDifferent(on, off), 50);
    for (int y = 0; y < k_ShadowedHeight; ++y)
    {
        for (int x = 0; x < k_ShadowedWidth; ++x)
        {
            const auto hit = shadows.Cast(shadows.RayThrough(x + 0.5, y + 0.5));
            ASSERT_TRUE(!hit || hit->distance > static_cast<double>(k_Distance) ||
                        off.At(x, y, 0) == 1.0)
                << "in shadow: " << x << ", " << y;
        }
    }

    // A sheet that looks up casts no shadow from below but with both sides.
    ShadowScene sheets(k_ShadowedWidth, k_ShadowedHeight, Attenuation());
    GameObject& sheet = sheets.scene.Add("sheet");
    sheet.transform.localPosition = {0.0f, 1.5f, 2.0f};
    sheet.transform.localRotation = EulerToRotation({-90.0f, 0.0f, 0.0f}); // a quad faces -z: down
    sheet.transform.localScale = {3.0f, 3.0f, 1.0f};
    sheet.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Quad),
                                  {sheets.scene.Find("floor")->renderer->sharedMaterials[0]}};
    const Field oneSided = Draw(sheets);
    sheet.renderer->shadowCastingMode = TwoSided;
    const Field twoSided = Draw(sheets);
    EXPECT_GT(CountDifferent(oneSided, twoSided), 100);
    sheet.renderer->shadowCastingMode = ShadowsOnly;
    sheet.transform.localRotation = EulerToRotation({90.0f, 0.0f, 0.0f}); // up
    const Field unseen = Draw(sheets);
    EXPECT_EQ(m_Result.report.draws.back().counts[0], 0);
    EXPECT_LT(CountDifferent(unseen, twoSided), CountDifferent(oneSided, twoSided));
}

/// Whether any draw of a frame is of a variant with shadows.
bool HasShadowVariant(const RenderResult& result)
{
    return std::ranges::any_of(result.frame->setups,
                               [](const DrawSetup& setup)
                               {
                                   return std::ranges::any_of(
                                       setup.program->layout.buffers,
                                       [](const UniformBuffer& buffer)
                                       { return buffer.name == "LightShadows"; });
                               });
}

TEST_F(MainLightShadowGpu, CostsNothingWhereNothingThrowsOrShowsIt)
{
    const auto lit = std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
    ShadowScene shadows(k_ShadowedWidth, k_ShadowedHeight, lit);
    shadows.AddBoxes();
    const auto expectNone = [&](const std::string& why)
    {
        SCOPED_TRACE(why);
        const Field picture = Draw(shadows);
        EXPECT_THAT(PassesOf(m_Result), testing::Not(testing::Contains("MainLightShadow")));
        EXPECT_FALSE(HasShadowVariant(m_Result));
        for (const CompiledRenderPass& pass : m_Result.frame->passes)
        {
            EXPECT_EQ(pass.width, k_ShadowedWidth) << pass.name;
        }
        return picture;
    };
    Draw(shadows);
    EXPECT_THAT(PassesOf(m_Result), testing::ElementsAre("MainLightShadow", "Draw Opaque Objects",
                                                         "Draw Transparent Objects", "Final Blit"));
    EXPECT_TRUE(HasShadowVariant(m_Result));
    shadows.scene.mainLight.shadows = LightShadows::None;
    const Field without = expectNone("the light throws none");
    shadows.scene.mainLight.shadows = LightShadows::Soft;
    m_Pipeline.shadows.mainLightShadowsSupported = false;
    EXPECT_EQ(CountDifferent(without, expectNone("the pipeline has none")), 0);
    m_Pipeline.shadows.mainLightShadowsSupported = true;
    const DirectionalLight shining = shadows.scene.mainLight;
    shadows.scene.mainLight.intensity = 0.0f;
    expectNone("the light has no intensity");
    shadows.scene.mainLight = shining;
    shadows.scene.mainLight.color = Color::black;
    expectNone("the light is black");
    shadows.scene.mainLight = shining;
    m_Pipeline.shadows.shadowDistance = 0.1f;
    EXPECT_EQ(CountDifferent(without, expectNone("they end before the near plane")), 0);
    m_Pipeline.shadows.shadowDistance = k_Distance;
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

TEST_F(MainLightShadowGpu, OfLitIsDarkerInShadowAndGoneWhereAMaterialDoesNotReceiveIt)
{
    for (const char* name : {"Limn/Half Lambert", "Universal Render Pipeline/Lit",
                             "Universal Render Pipeline/Simple Lit"})
    {
        SCOPED_TRACE(name);
        const auto lit = std::make_shared<Material>(FindBuiltinShader(name, Compiler()));
        ShadowScene shadows(k_ShadowedWidth, k_ShadowedHeight, lit);
        shadows.AddBoxes();
        const Field with = Draw(shadows);
        shadows.scene.mainLight.shadows = LightShadows::None;
        const Field without = Draw(shadows);
        shadows.scene.mainLight.shadows = LightShadows::Hard;
        int darker = 0;
        for (std::size_t i = 0; i < with.values.size(); ++i)
        {
            EXPECT_LE(with.values[i], without.values[i] + 1.0 / 255.0);
            darker += with.values[i] < without.values[i] - 0.05 ? 1 : 0;
        }
        EXPECT_GT(darker, 200);
        lit->EnableKeyword("_RECEIVE_SHADOWS_OFF");
        EXPECT_EQ(CountDifferent(Draw(shadows), without), 0);
    }
}

/// The scene below a parent that carries it away.
void Carry(ShadowScene& shadows, Transform& away, const glm::dvec3& place)
{
    away.localPosition = place;
    shadows.camera.transform.parent = &away;
    for (const auto& object : shadows.scene.objects())
    {
        object->transform.parent = &away;
    }
}

TEST_F(MainLightShadowGpu, IsTheSameFarAwayFromTheWorldsOrigin)
{
    const auto lit = std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
    for (const int cascades : {1, 4})
    {
        m_Pipeline.shadows.shadowCascadeCount = cascades;
        ShadowScene here(k_ShadowedWidth, k_ShadowedHeight, lit);
        here.AddBoxes();
        const Field expected = Draw(here);
        Transform away;
        ShadowScene there(k_ShadowedWidth, k_ShadowedHeight, lit);
        there.AddBoxes();
        Carry(there, away, {1e7, -1e7, 5e6});
        const Field picture = Draw(there);
        int different = 0;
        for (int y = 0; y < k_ShadowedHeight; ++y)
        {
            for (int x = 0; x < k_ShadowedWidth; ++x)
            {
                if (std::abs(expected.At(x, y, 0) - picture.At(x, y, 0)) <= 2.0 / 255.0)
                {
                    continue;
                }
                ++different;
                // The map's texels lie elsewhere: only within a pixel of an edge.
                double low = 1.0;
                double high = 0.0;
                for (int dy = -1; dy <= 1; ++dy)
                {
                    for (int dx = -1; dx <= 1; ++dx)
                    {
                        const double value =
                            expected.At(std::clamp(x + dx, 0, k_ShadowedWidth - 1),
                                        std::clamp(y + dy, 0, k_ShadowedHeight - 1), 0);
                        low = std::min(low, value);
                        high = std::max(high, value);
                    }
                }
                EXPECT_GT(high - low, 0.05) << x << ", " << y;
            }
        }
        EXPECT_LT(different, k_ShadowedWidth * k_ShadowedHeight / 20) << cascades << " cascades";
    }
}

TEST_F(MainLightShadowGpu, IsTheSameWhicheverWayRoundDepthIs)
{
    std::vector<Field> pictures;
    for (const bool reversed : {true, false})
    {
        ShaderCompilerOptions options;
        options.usesReversedZBuffer = reversed;
        const auto compiler = std::make_shared<ShaderCompiler>(options);
        ShadowScene shadows(
            k_ShadowedWidth, k_ShadowedHeight,
            Attenuation("GetMainLight(TransformWorldToShadowCoord(positionWS))", compiler));
        shadows.AddBoxes();
        m_Pipeline.shadows.shadowCascadeCount = 2;
        UniversalRenderer renderer(compiler);
        RenderRequest request;
        request.scene = &shadows.scene;
        request.camera = &shadows.camera;
        request.width = k_ShadowedWidth;
        request.height = k_ShadowedHeight;
        const RenderResult result = m_Pipeline.RenderSingleCamera(renderer, request);
        pictures.push_back(ToField(SharedDevice().ReadBack(*result.output.rt())));
        const Agreement agreement = Compare(pictures.back(), shadows, 0.15);
        EXPECT_EQ(agreement.different, 0) << reversed;
    }
    EXPECT_LT(CountDifferent(pictures[0], pictures[1]), k_ShadowedWidth * k_ShadowedHeight / 100);
}

TEST_F(MainLightShadowGpu, RefusesSettingsOutsideTheirRange)
{
    ShadowScene shadows(8, 8, Attenuation());
    shadows.AddBoxes();
    m_Pipeline.shadows.shadowCascadeCount = 5;
    EXPECT_THROW(Draw(shadows), ContractError);
}

} // namespace
} // namespace limn::test
