#include "Mentions.h"
#include "blending/VolumeScene.h"

#include <cmath>
#include <core/ThrownMessage.h>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/PrimitiveMesh.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::VolumeScene;

constexpr float k_InfiniteFloat = std::numeric_limits<float>::infinity();

Collider CubeMesh()
{
    return MeshCollider(CreatePrimitive(PrimitiveType::Cube));
}

/// Where a volume's object is, and where its surface then is: at `surface`, seen along `outwards`.
struct Placement
{
    const char* name;
    Collider collider;
    glm::quat rotation;
    glm::vec3 scale;
    glm::vec3 surface;
    glm::vec3 outwards;
};

/// Half a turn about the axis between +x and +z: swaps the two and turns y around.
const glm::quat k_Swap(0.0f, std::sqrt(0.5f), 0.0f, std::sqrt(0.5f));
const glm::quat k_None(1.0f, 0.0f, 0.0f, 0.0f);

/// All volumes stand at (10, 0, 0); the surfaces are worked out by hand.
std::vector<Placement> Placements()
{
    const BoxCollider box{true, {}, glm::vec3(2.0f)};
    const SphereCollider sphere{true, {}, 1.0f};
    const CapsuleCollider capsule{true, {}, 1.0f, 4.0f, 1};
    const glm::vec3 x(1, 0, 0);
    const glm::vec3 y(0, 1, 0);
    return {
        {"box", box, k_None, glm::vec3(1), {11, 0, 0}, x},
        {"box, turned and scaled", box, k_Swap, {1, 1, 3}, {13, 0, 0}, x},
        {"box, mirrored", box, k_None, {-2, 1, 1}, {12, 0, 0}, x},
        {"sphere", sphere, k_None, glm::vec3(1), {11, 0, 0}, x},
        {"sphere, turned",
         SphereCollider{true, {0, 0, 2}, 1.0f},
         k_Swap,
         glm::vec3(1),
         {13, 0, 0},
         x},
        {"sphere, longest axis", sphere, k_None, {1, 3, 2}, {13, 0, 0}, x},
        {"sphere, mirrored", sphere, k_None, {1, -3, 2}, {10, 3, 0}, y},
        {"capsule, side", capsule, k_None, glm::vec3(1), {11, 0, 0}, x},
        {"capsule, tip", capsule, k_None, glm::vec3(1), {10, 2, 0}, y},
        {"capsule, turned",
         CapsuleCollider{true, {}, 1.0f, 4.0f, 2},
         k_Swap,
         glm::vec3(1),
         {12, 0, 0},
         x},
        {"capsule, scaled side", capsule, k_None, {1, 5, 2}, {12, 0, 0}, x},
        {"capsule, scaled tip", capsule, k_None, {1, 5, 2}, {10, 10, 0}, y},
        {"capsule, mirrored tip", capsule, k_None, {1, -5, -2}, {10, 10, 0}, y},
        {"capsule, wider than high", capsule, k_None, {1, 1, 3}, {10, 3, 0}, y},
        {"mesh", CubeMesh(), k_None, glm::vec3(2), {11, 0, 0}, x},
        {"mesh, turned and scaled", CubeMesh(), k_Swap, {2, 2, 6}, {13, 0, 0}, x},
        {"mesh, mirrored", CubeMesh(), k_None, {-4, 2, 2}, {12, 0, 0}, x},
    };
}

/// A volume that sets TestVolume.param, by default 123, from 0 to 10.
class ColliderTest : public ::testing::Test
{
protected:
    ColliderTest()
    {
        m_Base.priority = -1.0f;
        m_Volume.isGlobal = false;
        m_Volume.blendDistance = 4.0f;
        m_Scene.manager.Register(&m_Base);
        m_Scene.manager.Register(&m_Volume);
    }

    float ParamAt(const glm::vec3& trigger)
    {
        m_Scene.Update(trigger);
        return m_Scene.Param();
    }

    VolumeScene m_Scene;
    Volume m_Base = test::GlobalVolume(test::ParamProfile(0.0f));
    Volume m_Volume = test::GlobalVolume(test::ParamProfile(10.0f));
};

TEST_F(ColliderTest, EveryShapeFadesWithTheSquareOfTheDistanceToItsSurface)
{
    const std::pair<float, float> expected[] = {{0.0f, 10.0f},  {1.0f, 9.375f}, {2.0f, 7.5f},
                                                {3.0f, 4.375f}, {4.0f, 0.0f},   {4.1f, 0.0f}};
    m_Volume.position = {10.0f, 0.0f, 0.0f};
    for (const Placement& place : Placements())
    {
        m_Volume.colliders = {place.collider};
        m_Volume.rotation = place.rotation;
        m_Volume.scale = place.scale;
        for (const auto& [distance, value] : expected)
        {
            EXPECT_NEAR(value, ParamAt(place.surface + place.outwards * distance), 1e-4f)
                << place.name << " at " << distance;
        }
        EXPECT_EQ(10.0f, ParamAt(place.surface - place.outwards * 0.5f)) << place.name;
    }
}

TEST_F(ColliderTest, TheNearestOfDifferentShapesCounts)
{
    m_Volume.colliders = {SphereCollider{true, {-5, 0, 0}, 1.0f}, CubeMesh(),
                          BoxCollider{true, {5, 0, 0}, glm::vec3(2.0f)}};
    EXPECT_EQ(10.0f, ParamAt({-5, 0.5f, 0}));
    EXPECT_EQ(7.5f, ParamAt({8, 0, 0}));
    std::get<BoxCollider>(m_Volume.colliders[2]).enabled = false;
    EXPECT_EQ(0.0f, ParamAt({8, 0, 0}));
    m_Volume.colliders.push_back(SphereCollider{true, {-5, 0, 0}, 2.0f});
    EXPECT_EQ(10.0f, ParamAt({-5, 0.5f, 0})); // inside two
}

TEST_F(ColliderTest, AMeshIsMeasuredToFacesEdgesAndCorners)
{
    m_Volume.colliders = {CubeMesh()};
    m_Volume.scale = glm::vec3(2.0f);
    EXPECT_NEAR(7.5f, ParamAt({0.3f, -3.0f, 0.2f}), 1e-4f);
    EXPECT_NEAR(10.0f * (1.0f - 5.0f / 16.0f), ParamAt({3, 2, 0.1f}), 1e-4f); // squares of 2, 1
    EXPECT_NEAR(4.375f, ParamAt({3, 2, 3}), 1e-4f);                           // of 2, 1, 2
}

TEST_F(ColliderTest, AFlatMeshIsASurface)
{
    m_Volume.colliders = {MeshCollider(CreatePrimitive(PrimitiveType::Quad))};
    EXPECT_EQ(7.5f, ParamAt({0, 0, 2}));
    EXPECT_EQ(7.5f, ParamAt({0, 0, -2}));
    m_Volume.colliders = {CubeMesh()};
    m_Volume.scale = {1, 1, 0};
    EXPECT_EQ(7.5f, ParamAt({0, 0, 2}));
}

TEST(MeshCollider, RefusesWhatIsNotAConvexSolid)
{
    EXPECT_EQ("a mesh collider needs a mesh",
              test::ThrownMessage<ContractError>([] { MeshCollider(nullptr); }));
    MeshData corner;
    corner.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto empty = std::make_shared<const Mesh>("points", corner);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { MeshCollider{empty}; }),
                Mentions("'points'", "collider", "no triangle"));
    corner.triangles = {0, 1, 2, 0, 2, 3};
    const auto open = std::make_shared<const Mesh>("tent", corner);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { MeshCollider{open}; }),
                Mentions("'tent'", "collider", "open"));
    corner.vertices.push_back({0, 0, -1});
    const auto twoSided = std::make_shared<const Mesh>("dart", corner);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { MeshCollider{twoSided}; }),
                Mentions("'dart'", "collider", "not convex", "triangle 0"));
}

TEST(CapsuleCollider, RefusesADirectionThatIsNoAxis)
{
    const CapsuleCollider capsule{true, {}, 1.0f, 2.0f, 3};
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { capsule.ClosestPoint({}, {}, glm::quat(1, 0, 0, 0), glm::vec3(1)); }),
                Mentions("capsule", "direction is 3", "0 (x)", "1 (y)", "2 (z)"));
}

TEST_F(ColliderTest, ExtremeBlendDistancesGiveNumbers)
{
    m_Volume.colliders = {SphereCollider{true, {}, 1.0f}};
    for (const float edge : {0.0f, 1e-30f})
    {
        m_Volume.blendDistance = edge;
        EXPECT_EQ(10.0f, ParamAt({1, 0, 0}));
        EXPECT_EQ(0.0f, ParamAt({1.001f, 0, 0}));
    }
    for (const float endless : {1e30f, k_InfiniteFloat})
    {
        m_Volume.blendDistance = endless;
        EXPECT_EQ(10.0f, ParamAt({1e7f, 0, 0}));
    }
    m_Volume.blendDistance = 4.0f;
    EXPECT_EQ(0.0f, ParamAt({1e7f, 0, 0}));
    EXPECT_EQ(0.0f, ParamAt({1e30f, 0, 0}));
}

TEST_F(ColliderTest, ExtremeWeightsGiveNumbers)
{
    m_Volume.colliders = {SphereCollider{true, {}, 1.0f}};
    const std::pair<float, float> expected[] = {
        {-1.0f, 0.0f}, {0.0f, 0.0f}, {2.0f, 10.0f}, {std::nanf(""), 0.0f}};
    for (const auto& [weight, value] : expected)
    {
        m_Volume.weight = weight;
        EXPECT_EQ(value, ParamAt({0, 0, 0})) << weight;
    }
    m_Volume.weight = 1e-38f;
    EXPECT_NEAR(1e-37f, ParamAt({0, 0, 0}), 1e-43f);
}

TEST_F(ColliderTest, ABoxOfNoScaleIsAPoint)
{
    m_Volume.colliders = {BoxCollider{}};
    m_Volume.scale = glm::vec3(0.0f);
    EXPECT_EQ(10.0f, ParamAt({0, 0, 0}));
    EXPECT_EQ(7.5f, ParamAt({0, 2, 0}));
}

TEST_F(ColliderTest, InfinitePrioritiesAreFirstAndLast)
{
    m_Volume.isGlobal = true;
    m_Volume.priority = -k_InfiniteFloat;
    EXPECT_EQ(0.0f, ParamAt({0, 0, 0}));
    m_Volume.priority = k_InfiniteFloat;
    EXPECT_EQ(10.0f, ParamAt({0, 0, 0}));
}

TEST(VolumeManager, TheLastOfTenThousandVolumesOfEqualPriorityWins)
{
    VolumeScene scene;
    std::vector<Volume> volumes(9999, test::GlobalVolume(test::ParamProfile(1.0f)));
    volumes.push_back(test::GlobalVolume(test::ParamProfile(2.0f)));
    for (const Volume& volume : volumes)
    {
        scene.manager.Register(&volume);
    }
    scene.Update();
    EXPECT_EQ(2.0f, scene.Param());
}

} // namespace

} // namespace limn
