#include "shadows/ShadowCascades.h"

#include <gmock/gmock.h>
#include <limn/core/Camera.h>
#include <limn/core/Culling.h>
#include <random>

#include "scene/TestScene.h"

namespace limn
{
namespace
{

constexpr float k_Aspect = 1.5f;

class ShadowCascadesTest : public testing::Test
{
protected:
    ShadowCascadesTest()
    {
        m_Camera.transform.localPosition = {3.0f, 2.0f, -7.0f};
        m_Camera.transform.localRotation = EulerToRotation({20.0f, 130.0f, 5.0f});
        m_Settings.mainLightShadowmapResolution = 512;
    }

    ShadowCascades Make() const
    {
        return MakeShadowCascades(m_Camera, k_Aspect, {0.3, -1.0, 0.4}, m_Settings);
    }

    double Random(double low, double high)
    {
        return std::uniform_real_distribution(low, high)(m_Random);
    }

    std::mt19937 m_Random{11};
    Camera m_Camera;
    ShadowSettings m_Settings;
};

/// Where a place is in a cascade's tile, texels from its middle.
glm::dvec2 TexelOf(const ShadowCascade& cascade, const glm::dvec3& place)
{
    return glm::dvec2(cascade.view * glm::dvec4(place, 1.0)) / cascade.TexelSize();
}

TEST_F(ShadowCascadesTest, HoldAllThatTheCameraSeesUpToTheDistance)
{
    const double ends[][5] = {{0, 1}, {0, 0.25, 1}, {0, 0.1, 0.3, 1}, {0, 0.067, 0.2, 0.467, 1}};
    for (const bool orthographic : {false, true})
    {
        m_Camera.orthographic = orthographic;
        m_Camera.nearClipPlane = orthographic ? -5.0f : 0.3f;
        for (const int count : {1, 2, 3, 4})
        {
            m_Settings.shadowCascadeCount = count;
            const ShadowCascades cascades = Make();
            ASSERT_EQ(cascades.size(), static_cast<std::size_t>(count));
            const glm::dmat4 toWorld = glm::inverse(m_Camera.viewMatrix());
            const glm::dmat4 toView = glm::inverse(m_Camera.projectionMatrixFor(k_Aspect));
            for (int i = 0; i < 4000; ++i)
            {
                const double near = static_cast<double>(m_Camera.nearClipPlane);
                const double depth = Random(near, 50.0);
                const glm::dvec4 corner =
                    toView * glm::dvec4(Random(-1, 1), Random(-1, 1), 0.5, 1.0);
                glm::dvec3 inView = glm::dvec3(corner) / corner.w;
                inView = orthographic ? glm::dvec3(inView.x, inView.y, -depth)
                                      : inView * (-depth / inView.z);
                const glm::dvec3 place(toWorld * glm::dvec4(inView, 1.0));
                int part = 0;
                while (part + 1 < count && depth > ends[count - 1][part + 1] * 50.0)
                {
                    ++part;
                }
                const ShadowCascade& cascade = cascades[static_cast<std::size_t>(part)];
                EXPECT_LE(glm::distance(place, cascade.center), cascade.radius);
                const glm::dvec2 texel = glm::abs(TexelOf(cascade, place));
                EXPECT_LE(std::max(texel.x, texel.y), cascade.tile.width / 2 - 3.5);
                const double z = (cascade.view * glm::dvec4(place, 1.0)).z;
                EXPECT_GE(-z, cascade.nearest);
                EXPECT_LE(-z, cascade.farthest);
            }
        }
    }
}

TEST_F(ShadowCascadesTest, MoveByWholeTexelsAndKeepTheirSize)
{
    m_Settings.shadowCascadeCount = 3;
    const ShadowCascades before = Make();
    for (int step = 0; step < 50; ++step)
    {
        m_Camera.transform.localPosition += glm::vec3(Random(-1, 1), Random(-1, 1), Random(-1, 1));
        m_Camera.transform.localRotation =
            EulerToRotation(glm::vec3(Random(-80, 80), Random(0, 360), Random(-9, 9)));
        const ShadowCascades after = Make();
        for (std::size_t i = 0; i < before.size(); ++i)
        {
            EXPECT_EQ(after[i].radius, before[i].radius);
            EXPECT_EQ(after[i].halfSize, before[i].halfSize);
            const glm::dvec2 moved = TexelOf(after[i], {1, 2, 3}) - TexelOf(before[i], {1, 2, 3});
            EXPECT_NEAR(moved.x, std::round(moved.x), 1e-6);
            EXPECT_NEAR(moved.y, std::round(moved.y), 1e-6);
        }
    }
}

TEST_F(ShadowCascadesTest, ShareTheMapAsUnitysDo)
{
    const auto tilesOf = [&](int count)
    {
        m_Settings.shadowCascadeCount = count;
        std::vector<ViewportRect> tiles;
        for (const ShadowCascade& cascade : Make())
        {
            tiles.push_back(cascade.tile);
        }
        return tiles;
    };
    using testing::ElementsAre;
    EXPECT_THAT(tilesOf(1), ElementsAre(ViewportRect{0, 0, 512, 512}));
    EXPECT_EQ(ShadowMapSize(m_Settings), glm::ivec2(512, 512));
    EXPECT_THAT(tilesOf(2),
                ElementsAre(ViewportRect{0, 0, 256, 256}, ViewportRect{256, 0, 256, 256}));
    EXPECT_EQ(ShadowMapSize(m_Settings), glm::ivec2(512, 256));
    EXPECT_THAT(tilesOf(4),
                ElementsAre(ViewportRect{0, 0, 256, 256}, ViewportRect{256, 0, 256, 256},
                            ViewportRect{0, 256, 256, 256}, ViewportRect{256, 256, 256, 256}));
    EXPECT_EQ(ShadowMapSize(m_Settings), glm::ivec2(512, 512));
}

TEST_F(ShadowCascadesTest, EndWithTheFarPlaneAndBeforeTheNearOneAreNone)
{
    EXPECT_EQ(ShadowDistance(m_Camera, m_Settings), 50.0);
    m_Camera.farClipPlane = 20.0f;
    EXPECT_EQ(ShadowDistance(m_Camera, m_Settings), 20.0);
    m_Settings.shadowDistance = 0.25f;
    EXPECT_TRUE(Make().empty());
}

TEST_F(ShadowCascadesTest, RefuseNumbersOutsideTheirRange)
{
    const auto refuses = [](void (*change)(ShadowSettings&))
    {
        ShadowSettings settings;
        ExpectValid(settings);
        change(settings);
        EXPECT_THROW(ExpectValid(settings), ContractError);
    };
    refuses([](ShadowSettings& s) { s.mainLightShadowmapResolution = 32; });
    refuses([](ShadowSettings& s) { s.shadowDistance = -1.0f; });
    refuses([](ShadowSettings& s) { s.shadowCascadeCount = 0; });
    const auto spoil = [](ShadowSettings& s)
    {
        s.cascade2Split = 1.0f;
        s.cascade3Split = {0.3f, 0.3f};
        s.cascade4Split = {0.0f, 0.3f, 0.4f};
    };
    for (const int count : {1, 2, 3, 4})
    {
        ShadowSettings settings;
        settings.shadowCascadeCount = count;
        const ShadowSettings whole = settings;
        spoil(settings);
        settings.cascade2Split = count == 2 ? whole.cascade2Split : settings.cascade2Split;
        settings.cascade3Split = count == 3 ? whole.cascade3Split : settings.cascade3Split;
        settings.cascade4Split = count == 4 ? whole.cascade4Split : settings.cascade4Split;
        EXPECT_NO_THROW(ExpectValid(settings)) << "the splits of other counts than " << count;
        spoil(settings);
        if (count > 1)
        {
            EXPECT_THROW(ExpectValid(settings), ContractError) << count;
        }
    }
    refuses([](ShadowSettings& s) { s.cascadeBorder = 1.5f; });
    refuses([](ShadowSettings& s) { s.shadowNormalBias = 11.0f; });
}

/// Light from above falls into a box of 4 m around the origin; the camera sees no object.
class ShadowCasters : public testing::Test
{
protected:
    ShadowCasters()
    {
        m_Camera.transform.localPosition = {0.0f, 0.0f, 1000.0f};
        m_Light.view = glm::dmat4(1.0);
        m_Light.view[1] = {0.0, 0.0, 1.0, 0.0}; // up is against the light
        m_Light.view[2] = {0.0, 1.0, 0.0, 0.0};
        m_Light.halfSize = 2.0;
        m_Light.nearest = -2.0;
        m_Light.farthest = 2.0;
    }
    GameObject& Add(const glm::vec3& place, const std::string& mode = "ShadowCaster")
    {
        return test::AddCube(m_Scene, "cube", place,
                             {std::make_shared<Material>(test::ShaderWithModes({mode}))});
    }
    std::size_t Count(bool twoSided = false)
    {
        const CullingResults seen = Cull(m_Scene, m_Camera, 1.0f);
        EXPECT_TRUE(seen.items.empty());
        return CullShadowCasters(seen, m_Camera, m_Light.Projection(true) * m_Light.view, twoSided)
            .items.size();
    }

    Scene m_Scene;
    Camera m_Camera;
    ShadowCascade m_Light;
};

TEST_F(ShadowCasters, AreThoseInTheBoxAndBeforeItHoweverFar)
{
    Add({0, 0, 0});
    Add({1, 500, 1});
    EXPECT_EQ(Count(), 2u);
    Add({4, 0, 0});
    Add({0, 0, -4});
    Add({0, -4, 0}); // behind all that shadows could fall on
    EXPECT_EQ(Count(), 2u);
}

TEST_F(ShadowCasters, HaveThePassAndThrowShadowsAndAreInTheCamerasMask)
{
    Add({0, 0, 0}, "UniversalForward");
    GameObject& object = Add({0, 0, 0});
    EXPECT_EQ(Count(), 1u);
    object.renderer->shadowCastingMode = ShadowCastingMode::Off;
    EXPECT_EQ(Count(), 0u);
    object.renderer->shadowCastingMode = ShadowCastingMode::TwoSided;
    EXPECT_EQ(Count(), 0u);
    EXPECT_EQ(Count(true), 1u);
    object.renderer->shadowCastingMode = ShadowCastingMode::ShadowsOnly;
    EXPECT_EQ(Count(), 1u);
    object.layer = 3;
    m_Camera.cullingMask = LayerMask::FromIndex(0);
    EXPECT_EQ(Count(), 0u);
    object.layer = 0;
    const auto without = std::make_shared<Material>(*object.renderer->sharedMaterials[0]);
    without->SetShaderPassEnabled("ShadowCaster", false);
    object.renderer->sharedMaterials = {without};
    EXPECT_EQ(Count(), 0u);
    without->SetShaderPassEnabled("ShadowCaster", true);
    EXPECT_EQ(Count(), 1u);
    object.activeSelf = false;
    EXPECT_EQ(Count(), 0u);
}

TEST_F(ShadowCasters, AreNotSeenWhereTheyAreShadowsOnly)
{
    GameObject& object = Add({0, 0, 1005});
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 1u);
    object.renderer->shadowCastingMode = ShadowCastingMode::ShadowsOnly;
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 0u);
}

} // namespace
} // namespace limn
