#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "ThrownMessage.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

/// A camera at the origin that looks along +z, 90 degrees wide and high, from 1 to 100 metres.
class Culling : public testing::Test
{
protected:
    Culling()
    {
        m_Camera.fieldOfView = 90.0f;
        m_Camera.nearClipPlane = 1.0f;
        m_Camera.farClipPlane = 100.0f;
    }

    GameObject& Add(const glm::vec3& position, float size = 1.0f)
    {
        GameObject& object = test::AddCube(m_Scene, "cube", position, {m_Material});
        object.transform.localScale = glm::vec3(size);
        return object;
    }
    bool Sees(const glm::vec3& position, float size = 1.0f)
    {
        m_Scene = Scene();
        Add(position, size);
        const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
        EXPECT_EQ(results.items.size() + static_cast<std::size_t>(results.outsideFrustum), 1u);
        return !results.items.empty();
    }

    const std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithModes({"A"}));
    Scene m_Scene;
    Camera m_Camera;
};

TEST_F(Culling, KeepsBoxesInsideTheFrustum)
{
    EXPECT_TRUE(Sees({0, 0, 10}));
    EXPECT_TRUE(Sees({9, 9, 10}));
    EXPECT_TRUE(Sees({0, 0, 99}));
}

TEST_F(Culling, DropsBoxesOutsideEachPlane)
{
    EXPECT_FALSE(Sees({0, 0, -10})) << "behind";
    EXPECT_FALSE(Sees({0, 0, 0.2f})) << "before the near plane";
    EXPECT_FALSE(Sees({0, 0, 101})) << "behind the far plane";
    EXPECT_FALSE(Sees({-12, 0, 10})) << "left";
    EXPECT_FALSE(Sees({12, 0, 10})) << "right";
    EXPECT_FALSE(Sees({0, 12, 10})) << "above";
    EXPECT_FALSE(Sees({0, -12, 10})) << "below";
}

TEST_F(Culling, KeepsBoxesThatStraddleAPlane)
{
    EXPECT_TRUE(Sees({10, 0, 10}));
    EXPECT_TRUE(Sees({0, -10, 10}));
    EXPECT_TRUE(Sees({0, 0, 100}));
    EXPECT_TRUE(Sees({0, 0, 0.75f}));
}

TEST_F(Culling, KeepsABoxAroundTheCamera)
{
    EXPECT_TRUE(Sees({0, 0, 0}, 50.0f));
    EXPECT_TRUE(Sees({0, 0, 0}, 1000.0f));
}

TEST_F(Culling, GoesByTheCamerasOwnProjection)
{
    glm::dmat4 matrix = m_Camera.projectionMatrixFor(1.0f);
    matrix[2][0] = 2.0; // from one to three metres to the right, a metre away
    m_Camera.projectionMatrix = matrix;
    EXPECT_TRUE(Sees({20, 0, 10}));
    EXPECT_FALSE(Sees({8, 0, 10}));
    m_Camera.projectionMatrix.reset();
    EXPECT_TRUE(Sees({5, 0, 5}));
    m_Camera.projectionMatrix = m_Camera.CalculateObliqueMatrix({-1, 0, -1, -2}, 1.0f);
    EXPECT_FALSE(Sees({5, 0, 5})) << "before the oblique near plane";
    EXPECT_TRUE(Sees({-4, 0, 5}));
}

TEST_F(Culling, MovesWithTheCamera)
{
    m_Camera.transform.localPosition = {100, 0, 0};
    m_Camera.transform.localRotation = EulerToRotation({0, -90, 0});
    EXPECT_TRUE(Sees({50, 0, 0}));
    EXPECT_FALSE(Sees({150, 0, 0}));
}

TEST_F(Culling, WidensWithTheAspect)
{
    Add({15, 0, 10});
    EXPECT_TRUE(Cull(m_Scene, m_Camera, 1.0f).items.empty());
    EXPECT_EQ(Cull(m_Scene, m_Camera, 2.0f).items.size(), 1u);
}

TEST_F(Culling, UsesTheBoundsOfTheRotatedBox)
{
    // A cube turned by 45 degrees reaches 0.71 m along x and z instead of 0.5 m.
    GameObject& object = Add({10.6f, 0, 10});
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 1u);
    object.transform.localPosition = {11.2f, 0, 10};
    EXPECT_TRUE(Cull(m_Scene, m_Camera, 1.0f).items.empty());
    object.transform.localRotation = EulerToRotation({0, 45, 0});
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 1u);
}

TEST_F(Culling, JudgesTheSmallestAndTheLargestBoxes)
{
    constexpr float k_Max = std::numeric_limits<float>::max();
    EXPECT_TRUE(Sees({0, 0, 10}, k_Max)) << "around everything";
    EXPECT_TRUE(Sees({0, 0, 10}, 1e-38f));
    EXPECT_TRUE(Sees({0, 0, 10}, 0.0f)) << "a point before the camera";
    EXPECT_TRUE(Sees({1e-38f, 0, 10}));
    EXPECT_FALSE(Sees({0, 0, 0}, 0.0f)) << "a point at the camera";
    EXPECT_FALSE(Sees({0, 0, 0}, 1e-38f));
    EXPECT_FALSE(Sees({k_Max, 0, 10})) << "far to the right";
    EXPECT_FALSE(Sees({-k_Max, 0, 10}));
    EXPECT_FALSE(Sees({0, 0, k_Max})) << "far behind the far plane";
}

TEST_F(Culling, KeepsWhatIsNoNumberSoThatNothingVanishesSilently)
{
    constexpr float k_Nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float k_Infinity = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(Sees(glm::vec3(k_Nan)));
    EXPECT_TRUE(Sees({k_Nan, 0, 10}));
    EXPECT_TRUE(Sees({0, 0, 10}, k_Nan));
    EXPECT_TRUE(Sees({0, 0, 10}, k_Infinity));
    EXPECT_TRUE(Sees({0, 0, 10}, -k_Infinity));
}

TEST_F(Culling, LeavesOutLayersOutsideTheCullingMask)
{
    Add({0, 0, 10}).layer = 6;
    Add({0, 0, 10}).layer = 31;
    m_Camera.cullingMask = LayerMask::FromIndex(31);
    const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
    ASSERT_EQ(results.items.size(), 1u);
    EXPECT_EQ(results.items[0].filter.layer, 31);
    EXPECT_EQ(results.rendererCount, 2);
    EXPECT_EQ(results.outsideCullingMask, 1);
}

TEST_F(Culling, RefusesALayerThatIsNone)
{
    Add({0, 0, 10}).layer = 32;
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { Cull(m_Scene, m_Camera, 1.0f); }),
              "layer index 32 is outside 0...31");
}

TEST_F(Culling, LeavesOutWhatIsOffOrIncomplete)
{
    Add({0, 0, 10}).activeSelf = false;
    Add({0, 0, 10}).renderer->enabled = false;
    Add({0, 0, 10}).renderer->mesh = nullptr;
    Add({0, 0, 10}).renderer.reset();
    const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
    EXPECT_TRUE(results.items.empty());
    EXPECT_EQ(results.rendererCount, 0);
}

TEST_F(Culling, JudgesAlikeFarAwayFromTheOrigin)
{
    for (const float distance : {0.0f, 1e5f, 1e7f, 1e8f, 1e9f})
    {
        Transform away;
        away.localPosition = {distance, -distance, distance};
        m_Camera.transform.parent = &away;
        m_Scene = Scene();
        for (const glm::vec3& place : {glm::vec3(9, 9, 10), {9, 9, 11}, {12, 0, 10}, {0, 0, 0.2f}})
        {
            Add(place).transform.parent = &away;
        }
        const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
        EXPECT_EQ(results.outsideFrustum, 2) << distance;
        ASSERT_EQ(results.items.size(), 2u) << distance;
        EXPECT_NEAR(results.items[1].boundsCenter.z - results.items[0].boundsCenter.z, 1.0, 1e-6)
            << distance << ": for sorting";
    }
}

TEST_F(Culling, WorksEachParentOfALongChainOutOnce)
{
    // Going up from each would be 5e9 matrices, more than the time that tests may take.
    constexpr int k_Length = 100'000;
    const Transform* parent = nullptr;
    for (int i = 0; i < k_Length; ++i)
    {
        GameObject& object = Add({0, 0, i == 0 ? 10.0f : 1.0f / 1024.0f});
        object.transform.parent = parent;
        parent = &object.transform;
    }
    const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
    // Up to where the near side of the box is behind the far plane.
    ASSERT_NEAR(static_cast<double>(results.items.size()), (100.5 - 10) * 1024, 1.0);
    EXPECT_NEAR(results.items.back().boundsCenter.z, 100.5, 1.0 / 1024);
}

TEST_F(Culling, TellsFilteringWhatItNeedsOfEachItem)
{
    const auto material = std::make_shared<Material>(test::ShaderWithModes({"A"}, "Overlay"));
    GameObject& object = Add({1, 2, 10}, 2.0f);
    object.layer = 6;
    object.renderer->sharedMaterials = {material};
    object.renderer->renderingLayerMask = RenderingLayerMask(5);
    const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
    const RendererItem item = results.items.at(0);
    EXPECT_EQ(item.object, &object);
    EXPECT_EQ(item.material, material);
    EXPECT_EQ(item.filter, (FilterItem{4000, 6, RenderingLayerMask(5), material->shader().get(),
                                       material.get()}));
    EXPECT_EQ(item.boundsCenter, glm::dvec3(1, 2, 10));
    EXPECT_THAT(results.objects->Get(item.objectIndex).objectToWorld,
                testing::ElementsAre(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 2, 10, 1));
}

/// A mesh of two triangles, each a sub-mesh.
std::shared_ptr<const Mesh> TwoSubMeshes()
{
    MeshData data;
    data.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    data.triangles = {0, 1, 2, 0, 1, 2};
    data.subMeshes = {{0, 3}, {3, 3}};
    return std::make_shared<const Mesh>("two", data);
}

std::vector<int> SubMeshes(const CullingResults& results)
{
    std::vector<int> indices;
    for (const RendererItem& item : results.items)
    {
        indices.push_back(item.subMesh);
    }
    return indices;
}

TEST_F(Culling, PairsSubMeshesWithMaterials)
{
    GameObject& object = Add({0, 0, 10});
    object.renderer->mesh = TwoSubMeshes();
    object.renderer->sharedMaterials = {m_Material, m_Material};
    EXPECT_THAT(SubMeshes(Cull(m_Scene, m_Camera, 1.0f)), testing::ElementsAre(0, 1));
    object.renderer->sharedMaterials = {m_Material};
    EXPECT_THAT(SubMeshes(Cull(m_Scene, m_Camera, 1.0f)), testing::ElementsAre(0));
}

TEST_F(Culling, DrawsTheLastSubMeshAgainForFurtherMaterials)
{
    GameObject& object = Add({0, 0, 10});
    object.renderer->mesh = TwoSubMeshes();
    object.renderer->sharedMaterials = {m_Material, m_Material, m_Material, m_Material};
    EXPECT_THAT(SubMeshes(Cull(m_Scene, m_Camera, 1.0f)), testing::ElementsAre(0, 1, 1, 1));
}

TEST_F(Culling, SkipsAnEmptyMaterialSlot)
{
    GameObject& object = Add({0, 0, 10});
    object.renderer->mesh = TwoSubMeshes();
    object.renderer->sharedMaterials = {nullptr, m_Material};
    EXPECT_THAT(SubMeshes(Cull(m_Scene, m_Camera, 1.0f)), testing::ElementsAre(1));
}

TEST(Scene, FindsTheFirstObjectOfAName)
{
    Scene scene;
    GameObject& first = scene.Add("cube");
    scene.Add("cube");
    EXPECT_EQ(scene.Find("cube"), &first);
    EXPECT_EQ(scene.Find("sphere"), nullptr);
}

TEST(Scene, KeepsTheAddressesOfItsObjects)
{
    Scene scene;
    const GameObject* first = &scene.Add("first");
    for (int i = 0; i < 1000; ++i)
    {
        scene.Add("more");
    }
    EXPECT_EQ(scene.objects().front().get(), first);
}

} // namespace
} // namespace limn
