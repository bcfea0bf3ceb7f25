#include "Mentions.h"
#include "blending/VolumeScene.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/PrimitiveMesh.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::Mixed;
using test::ScreenSpaceOutline;
using test::VolumeScene;

/// A box of edge 2 around the origin that sets every parameter of Mixed to 10, true or white, with
/// a blend distance of 4; its surface to the right is at x = 1.
class LocalVolume : public ::testing::Test
{
protected:
    LocalVolume()
    {
        auto profile = std::make_shared<VolumeProfile>();
        Mixed& mixed = profile->Add<Mixed>(true);
        mixed.number.Override(10.0f);
        mixed.whole.Override(10);
        mixed.flag.Override(true);
        mixed.tint.Override(Color::white);
        m_Volume.sharedProfile = profile;
        m_Volume.isGlobal = false;
        m_Volume.blendDistance = 4.0f;
        m_Volume.colliders.push_back(BoxCollider{true, glm::vec3(0.0f), glm::vec3(2.0f)});
        m_Scene.manager.Register(&m_Volume);
    }

    float NumberAt(const glm::vec3& trigger)
    {
        m_Scene.Update(trigger);
        return m_Scene.Get<Mixed>().number.value();
    }

    BoxCollider& Box(std::size_t index) { return std::get<BoxCollider>(m_Volume.colliders[index]); }

    VolumeScene m_Scene;
    Volume m_Volume;
};

TEST_F(LocalVolume, SaysWhyItChangesNothing)
{
    const auto why = [&](const glm::vec3& trigger, LayerMask layers = LayerMask::Everything())
    {
        return WhyIdle(m_Volume, trigger, layers);
    };
    EXPECT_EQ("", why({5.0f, 0.0f, 0.0f}));
    EXPECT_THAT(why({22.0f, 0.0f, 0.0f}), Mentions("21 m", "collider", "4 m"));
    m_Volume.layer = 9;
    EXPECT_THAT(why(glm::vec3(0.0f), LayerMask::FromIndex(0)), Mentions("layer", "9", "camera"));
    m_Volume.weight = 0.0f;
    EXPECT_EQ("its weight is 0", why(glm::vec3(0.0f)));
    m_Volume.weight = 1.0f;
    Box(0).enabled = false;
    EXPECT_THAT(why(glm::vec3(0.0f)), Mentions("not global", "no collider"));
    m_Volume.isGlobal = true;
    EXPECT_EQ("", why(glm::vec3(0.0f)));
    m_Volume.sharedProfile = std::make_shared<VolumeProfile>();
    EXPECT_THAT(why(glm::vec3(0.0f)), Mentions("no component", "active"));
    m_Volume.sharedProfile = nullptr;
    EXPECT_EQ("it has no profile", why(glm::vec3(0.0f)));
    m_Volume.enabled = false;
    EXPECT_EQ("it is off", why(glm::vec3(0.0f)));
}

TEST_F(LocalVolume, FadesWithTheSquareOfTheDistance)
{
    EXPECT_EQ(NumberAt({0.0f, 0.0f, 0.0f}), 10.0f);
    EXPECT_EQ(NumberAt({1.0f, 0.0f, 0.0f}), 10.0f);
    EXPECT_EQ(NumberAt({2.0f, 0.0f, 0.0f}), 9.375f);
    EXPECT_EQ(NumberAt({3.0f, 0.0f, 0.0f}), 7.5f);
    EXPECT_EQ(NumberAt({4.0f, 0.0f, 0.0f}), 4.375f);
    EXPECT_EQ(NumberAt({5.0f, 0.0f, 0.0f}), 0.0f);
    EXPECT_EQ(NumberAt({5.5f, 0.0f, 0.0f}), 0.0f);
}

TEST_F(LocalVolume, MeasuresToTheNearestPointOfTheBox)
{
    EXPECT_EQ(NumberAt({0.5f, -3.0f, 0.5f}), 7.5f);
    // From the corner (1, 1, 1) by (2, 1, 2): distance 3.
    EXPECT_EQ(NumberAt({3.0f, 2.0f, 3.0f}), 4.375f);
}

TEST_F(LocalVolume, MultipliesTheFadeByTheWeight)
{
    m_Volume.weight = 0.5f;
    EXPECT_EQ(NumberAt({0.0f, 0.0f, 0.0f}), 5.0f);
    EXPECT_EQ(NumberAt({3.0f, 0.0f, 0.0f}), 3.75f);
    EXPECT_EQ(NumberAt({4.0f, 0.0f, 0.0f}), 2.1875f);
}

TEST_F(LocalVolume, HasAHardEdgeWithoutABlendDistance)
{
    m_Volume.blendDistance = 0.0f;
    EXPECT_EQ(NumberAt({1.0f, 0.0f, 0.0f}), 10.0f);
    EXPECT_EQ(NumberAt({1.001f, 0.0f, 0.0f}), 0.0f);
}

TEST_F(LocalVolume, SwitchesStepTypesAnywhereInsideTheBlendZone)
{
    m_Scene.Update(glm::vec3(4.9f, 0.0f, 0.0f));
    EXPECT_TRUE(m_Scene.Get<Mixed>().flag.value());
    EXPECT_EQ(m_Scene.Get<Mixed>().whole.value(), 0); // below 1, rounded toward zero
}

TEST_F(LocalVolume, MarksParametersButMovesNoneExactlyAtTheEndOfTheBlendZone)
{
    m_Scene.Update(glm::vec3(5.0f, 0.0f, 0.0f));
    EXPECT_FALSE(m_Scene.Get<Mixed>().flag.value());
    EXPECT_TRUE(m_Scene.Get<Mixed>().flag.overrideState());
    m_Scene.Update(glm::vec3(5.01f, 0.0f, 0.0f));
    EXPECT_FALSE(m_Scene.Get<Mixed>().flag.overrideState());
}

TEST_F(LocalVolume, BlendsColoursWithAlpha)
{
    m_Scene.Update(glm::vec3(3.0f, 0.0f, 0.0f));
    EXPECT_EQ(m_Scene.Get<Mixed>().tint.value(), (Color{0.75f, 0.75f, 0.75f, 0.75f}));
}

TEST_F(LocalVolume, IsSkippedWithoutATrigger)
{
    m_Scene.Update(std::nullopt);
    EXPECT_FALSE(m_Scene.Get<Mixed>().number.overrideState());
}

TEST_F(LocalVolume, IsSkippedWithoutAnEnabledCollider)
{
    m_Volume.blendDistance = std::numeric_limits<float>::infinity();
    Box(0).enabled = false;
    EXPECT_EQ(NumberAt({0.0f, 0.0f, 0.0f}), 0.0f);
    m_Volume.colliders.clear();
    EXPECT_EQ(NumberAt({0.0f, 0.0f, 0.0f}), 0.0f);
}

TEST_F(LocalVolume, IsGlobalWhateverItsCollidersWhenItSaysSo)
{
    m_Volume.isGlobal = true;
    EXPECT_EQ(NumberAt({1000.0f, 0.0f, 0.0f}), 10.0f);
    m_Scene.Update(std::nullopt);
    EXPECT_EQ(m_Scene.Get<Mixed>().number.value(), 10.0f);
}

TEST_F(LocalVolume, TakesTheClosestOfItsEnabledColliders)
{
    m_Volume.colliders.push_back(BoxCollider{true, {10.0f, 0.0f, 0.0f}, glm::vec3(2.0f)});
    EXPECT_EQ(NumberAt({7.0f, 0.0f, 0.0f}), 7.5f); // 2 from the second, 6 from the first
    Box(1).enabled = false;
    EXPECT_EQ(NumberAt({7.0f, 0.0f, 0.0f}), 0.0f);
}

TEST_F(LocalVolume, MovesScalesAndTurnsWithItsObject)
{
    // Scaled to edges 4, 2, 8, turned by 90 degrees about +y, which carries +z to +x: 8 wide in x.
    m_Volume.position = {100.0f, 0.0f, 0.0f};
    m_Volume.scale = {2.0f, 1.0f, -4.0f};
    const float half = std::sqrt(0.5f);
    m_Volume.rotation = glm::quat(half, 0.0f, half, 0.0f);
    EXPECT_EQ(NumberAt({103.9f, 0.0f, 0.0f}), 10.0f);
    EXPECT_NEAR(NumberAt({106.0f, 0.0f, 0.0f}), 7.5f, 1e-4f);
    EXPECT_NEAR(NumberAt({100.0f, 0.0f, 4.0f}), 7.5f, 1e-4f);
    EXPECT_NEAR(NumberAt({100.0f, 3.0f, 0.0f}), 7.5f, 1e-4f);
    EXPECT_EQ(NumberAt({100.0f, 0.0f, 6.1f}), 0.0f);
}

TEST_F(LocalVolume, ScalesAndTurnsTheCentreOfItsBox)
{
    // The centre (0, 0, 3) doubled and turned as above is (6, 0, 0); the edge is 4.
    const float half = std::sqrt(0.5f);
    m_Volume.rotation = glm::quat(half, 0.0f, half, 0.0f);
    m_Volume.scale = glm::vec3(2.0f);
    Box(0).center = {0.0f, 0.0f, 3.0f};
    EXPECT_EQ(NumberAt({4.1f, 0.0f, 0.0f}), 10.0f);
    EXPECT_NEAR(NumberAt({10.0f, 0.0f, 0.0f}), 7.5f, 1e-4f);
    EXPECT_NEAR(NumberAt({2.0f, 0.0f, 0.0f}), 7.5f, 1e-4f);
}

TEST_F(LocalVolume, MeasuresAlongTheTurnedEdges)
{
    // Turned by 45 degrees about +y, the corners of the square of edge 2 are at x = sqrt(2).
    const float angle = 3.14159265f / 8.0f;
    m_Volume.rotation = glm::quat(std::cos(angle), 0.0f, std::sin(angle), 0.0f);
    EXPECT_NEAR(NumberAt({std::sqrt(2.0f) + 2.0f, 0.0f, 0.0f}), 7.5f, 1e-4f);
    // Straight off a face: 1 + 2 along the diagonal.
    const float along = 3.0f * std::sqrt(0.5f);
    EXPECT_NEAR(NumberAt({along, 0.0f, along}), 7.5f, 1e-4f);
}

TEST_F(LocalVolume, BlendsOntoAGlobalVolumeOfLowerPriority)
{
    auto profile = std::make_shared<VolumeProfile>();
    profile->Add<Mixed>().number.Override(2.0f);
    const Volume global = test::GlobalVolume(profile, -1.0f);
    m_Scene.manager.Register(&global);
    EXPECT_EQ(NumberAt({3.0f, 0.0f, 0.0f}), 8.0f); // 2 + 0.75 * 8
    EXPECT_EQ(NumberAt({9.0f, 0.0f, 0.0f}), 2.0f);
}

TEST_F(LocalVolume, MeasuresDistancesWhoseSquaresNoFloatHolds)
{
    m_Volume.blendDistance = 2e30f;
    const auto cube = CreatePrimitive(PrimitiveType::Cube);
    for (const Collider& shape : {Collider(BoxCollider{}), Collider(SphereCollider{}),
                                  Collider(CapsuleCollider{}), Collider(MeshCollider(cube))})
    {
        m_Volume.colliders = {shape};
        EXPECT_FLOAT_EQ(NumberAt({1e30f, 0.0f, 0.0f}), 7.5f);
        EXPECT_EQ(NumberAt({0.0f, -3e30f, 0.0f}), 0.0f);
    }
    m_Volume.blendDistance = std::numeric_limits<float>::infinity();
    EXPECT_EQ(NumberAt({0.0f, 1e30f, -1e30f}), 10.0f);
    m_Volume.blendDistance = 1e30f;
    m_Volume.colliders = {SphereCollider{true, {}, 5e29f}};
    EXPECT_FLOAT_EQ(NumberAt({1e30f, 0.0f, 0.0f}), 7.5f);
    m_Volume.colliders = {MeshCollider(cube)};
    m_Volume.scale = glm::vec3(1e30f); // the faces are 5e29 m from the middle
    EXPECT_FLOAT_EQ(NumberAt({1e30f, 0.0f, 0.0f}), 7.5f);
    EXPECT_EQ(NumberAt({4e29f, 0.0f, 1e29f}), 10.0f);
}

} // namespace

} // namespace limn
