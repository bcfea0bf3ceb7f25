#include "scene/RendererTable.h"
#include "scene/TestScene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "ThrownMessage.h"

namespace limn
{
namespace
{

using Materials = std::vector<std::shared_ptr<const Material>>;

/// Two triangles, each a sub-mesh, one beside the other.
std::shared_ptr<const Mesh> Pair()
{
    MeshData data;
    data.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 1}, {3, 0, 0}};
    data.triangles = {0, 1, 2, 3, 4, 5};
    data.subMeshes = {{0, 3}, {3, 3}};
    return std::make_shared<Mesh>("pair", data);
}

/// What an item is of, to be compared.
struct Seen
{
    const GameObject* object = nullptr;
    const Material* material = nullptr;
    int materialIndex = 0;
    int subMesh = 0;
    FilterItem filter;

    bool operator==(const Seen&) const = default;
};

/// A scene that changes in every way that it can, and what culling has to find in it.
class ManyRenderers : public testing::Test
{
protected:
    ManyRenderers()
    {
        for (const char* queue : {"Geometry", "Transparent"})
        {
            for (int i = 0; i < 2; ++i)
            {
                m_Materials.push_back(
                    std::make_shared<Material>(test::ShaderWithModes({"A"}, queue)));
            }
        }
        m_Materials.push_back(nullptr);
        m_Camera.fieldOfView = 90.0f;
        m_Camera.nearClipPlane = 1.0f;
        m_Camera.farClipPlane = 100.0f;
    }

    int Number(int count) { return static_cast<int>(m_Random() % static_cast<unsigned>(count)); }
    std::uint32_t Bits() { return static_cast<std::uint32_t>(m_Random()); }
    float Real(float reach)
    {
        return std::uniform_real_distribution<float>(-reach, reach)(m_Random);
    }
    glm::vec3 Vector(float reach) { return {Real(reach), Real(reach), Real(reach)}; }
    GameObject& Any() { return *m_Scene.objects()[m_Random() % m_Scene.objects().size()]; }

    void Add()
    {
        GameObject& object = m_Scene.Add("object " + std::to_string(m_Scene.objects().size()));
        object.transform.localPosition = Vector(100.0f);
        object.layer = Number(4);
        object.renderer = MeshRenderer{Number(2) == 0 ? test::Cube() : m_Pair, SomeMaterials()};
    }
    Materials SomeMaterials()
    {
        Materials materials;
        for (int i = Number(4); i > 0; --i)
        {
            materials.push_back(m_Materials[m_Random() % m_Materials.size()]);
        }
        return materials;
    }

    /// One of all changes that a scene allows.
    void Change()
    {
        GameObject& object = Any();
        Transform& transform = object.transform;
        switch (Number(14))
        {
        case 0:
            transform.localPosition.x += Real(20.0f);
            break;
        case 1:
            transform.localRotation = EulerToRotation(Vector(180.0f));
            break;
        case 2:
            transform.localScale = Vector(4.0f);
            break;
        case 3:
            object.layer = Number(4);
            break;
        case 4:
            object.activeSelf = !object.activeSelf;
            break;
        case 5:
            object.renderer.reset();
            break;
        case 6:
            object.renderer = MeshRenderer{m_Pair, SomeMaterials()};
            break;
        case 7:
            Add();
            break;
        case 8:
            transform.parent = transform.parent == nullptr ? &m_Parent : nullptr;
            break;
        case 9:
            m_Parent.localPosition = Vector(30.0f);
            break;
        case 10:
            m_Grandparent.localRotation = EulerToRotation(Vector(180.0f));
            break;
        case 11:
            m_Materials[static_cast<std::size_t>(Number(4))]->SetRenderQueue(2000 + Number(2000));
            break;
        default:
            ChangeRenderer(object);
            break;
        }
    }
    void ChangeRenderer(GameObject& object)
    {
        if (!object.renderer)
        {
            return;
        }
        MeshRenderer& renderer = *object.renderer;
        switch (Number(4))
        {
        case 0:
            renderer.enabled = !renderer.enabled;
            break;
        case 1:
            renderer.renderingLayerMask = RenderingLayerMask(Bits() & 3u);
            break;
        case 2:
            renderer.mesh = renderer.mesh == m_Pair ? test::Cube() : m_Pair;
            break;
        default:
            if (!renderer.sharedMaterials.empty())
            {
                renderer.sharedMaterials.back() = m_Materials[m_Random() % m_Materials.size()];
            }
            break;
        }
    }

    /// How far the object's box reaches into the frustum, metres, by its corners in double: 90
    /// degrees wide and high.
    double Inside(const GameObject& object) const
    {
        const glm::dmat4 view = glm::inverse(m_Camera.transform.worldMatrix());
        const glm::dmat4 world = object.transform.worldMatrix();
        const Bounds& bounds = object.renderer->mesh->bounds();
        // The world's axes hold the box together.
        glm::dvec3 extents(0.0);
        for (int axis = 0; axis < 3; ++axis)
        {
            extents +=
                glm::abs(glm::dvec3(world[axis])) * static_cast<double>(bounds.extents[axis]);
        }
        const glm::dvec3 center(world * glm::dvec4(bounds.center, 1.0));
        double most[6];
        std::ranges::fill(most, -1e300);
        for (int corner = 0; corner < 8; ++corner)
        {
            const glm::dvec3 side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                  (corner & 4) != 0 ? 1 : -1);
            const glm::dvec3 p(view * glm::dvec4(center + side * extents, 1.0)); // looks along +z
            const double depths[] = {p.z + p.x, p.z - p.x, p.z + p.y,
                                     p.z - p.y, p.z - 1.0, 100.0 - p.z};
            for (int plane = 0; plane < 6; ++plane)
            {
                most[plane] = std::max(most[plane], depths[plane]);
            }
        }
        return *std::ranges::min_element(most);
    }

    void ExpectRight(const CullingResults& results)
    {
        std::vector<Seen> expected;
        std::set<const GameObject*> unclear;
        int renderers = 0;
        int masked = 0;
        int outside = 0;
        for (const auto& object : m_Scene.objects())
        {
            if (!object->activeSelf || !object->renderer || !object->renderer->enabled)
            {
                continue;
            }
            ++renderers;
            if (((m_Camera.cullingMask.bits >> object->layer) & 1u) == 0)
            {
                ++masked;
                continue;
            }
            const double inside = Inside(*object);
            if (std::abs(inside) < 1e-3)
            {
                unclear.insert(object.get());
            }
            else if (inside < 0.0)
            {
                ++outside;
            }
            else
            {
                AddExpected(*object, expected);
            }
        }
        std::vector<Seen> seen;
        for (const RendererItem& item : results.items)
        {
            if (!unclear.contains(item.object))
            {
                seen.push_back({item.object, item.material.get(), item.materialIndex, item.subMesh,
                                item.filter});
            }
        }
        EXPECT_EQ(seen, expected);
        EXPECT_EQ(results.rendererCount, renderers);
        EXPECT_EQ(results.outsideCullingMask, masked);
        EXPECT_GE(results.outsideFrustum, outside);
        EXPECT_LE(results.outsideFrustum, outside + static_cast<int>(unclear.size()));
    }
    static void AddExpected(const GameObject& object, std::vector<Seen>& expected)
    {
        const MeshRenderer& renderer = *object.renderer;
        for (std::size_t i = 0; i < renderer.sharedMaterials.size(); ++i)
        {
            if (const Material* material = renderer.sharedMaterials[i].get())
            {
                const int index = static_cast<int>(i);
                const int last = static_cast<int>(renderer.mesh->data().subMeshes.size()) - 1;
                expected.push_back({&object,
                                    material,
                                    index,
                                    std::min(index, last),
                                    {material->renderQueue(), object.layer,
                                     renderer.renderingLayerMask, material->shader().get()}});
            }
        }
    }

    std::mt19937 m_Random{20261122};
    std::vector<std::shared_ptr<Material>> m_Materials;
    const std::shared_ptr<const Mesh> m_Pair = Pair();
    Transform m_Grandparent;
    Transform m_Parent{.parent = &m_Grandparent};
    Scene m_Scene;
    Camera m_Camera;
};

TEST_F(ManyRenderers, AreCulledAsTheyAreAfterEveryChange)
{
    for (int i = 0; i < 40; ++i)
    {
        Add();
    }
    for (int step = 0; step < 400; ++step)
    {
        SCOPED_TRACE("step " + std::to_string(step));
        for (int changes = Number(4); changes > 0; --changes)
        {
            Change();
        }
        m_Camera.cullingMask = LayerMask(Bits() | 1u);
        m_Camera.transform.localPosition = Vector(20.0f);
        m_Camera.transform.localRotation = EulerToRotation(Vector(180.0f));
        ExpectRight(Cull(m_Scene, m_Camera, 1.0f));
        if (HasFailure())
        {
            break;
        }
    }
}

TEST_F(ManyRenderers, AreKnownToAFrameThatOutlivesTheirScene)
{
    Add();
    m_Scene.objects()[0]->transform.localPosition = {3.0f, 0.0f, 0.0f};
    const auto objects = Cull(m_Scene, m_Camera, 1.0f).objects;
    m_Scene = Scene();
    EXPECT_EQ(objects->Get(0).objectToWorld[12], 3.0f);
}

TEST_F(ManyRenderers, HaveThePerDrawDataOfTheirPlace)
{
    for (int i = 0; i < 20; ++i)
    {
        Add();
    }
    std::uint64_t version = 0;
    for (int step = 0; step < 200; ++step)
    {
        const auto before = Cull(m_Scene, m_Camera, 1.0f).objects;
        std::vector<PerDrawData> old;
        for (std::uint32_t i = 0; i < before->count(); ++i)
        {
            old.push_back(before->Get(i));
        }
        version = before->version();
        Change();
        const auto objects = Cull(m_Scene, m_Camera, 1.0f).objects;
        const auto changed = objects->ChangedSince(version);
        ASSERT_TRUE(changed.has_value());
        for (std::uint32_t i = 0; i < objects->count(); ++i)
        {
            const GameObject& object = *m_Scene.objects()[i];
            const PerDrawData data = objects->Get(i);
            const glm::mat4 world = object.transform.localToWorldMatrix();
            for (int k = 0; k < 16; ++k)
            {
                ASSERT_EQ(data.objectToWorld[k], world[k / 4][k % 4]) << "step " << step;
            }
            if (object.renderer)
            {
                EXPECT_EQ(data.renderingLayer[0], object.renderer->renderingLayerMask.bits);
            }
            const bool isListed = std::ranges::count(*changed, i) == 1;
            const bool isOther = i >= old.size() || std::memcmp(&old[i], &data, sizeof data) != 0;
            EXPECT_TRUE(isListed || !isOther) << "object " << i << " of step " << step;
        }
    }
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).objects->ChangedSince(version + 1)->size(), 0u)
        << "nothing has changed";
    EXPECT_FALSE(Cull(m_Scene, m_Camera, 1.0f).objects->ChangedSince(0).has_value())
        << "that is too long ago to tell";
}

TEST_F(ManyRenderers, LetGoOfWhatNoneOfThemHasAnyMore)
{
    GameObject& object = test::AddCube(m_Scene, "cube", {0, 0, 10}, {});
    auto material = std::make_shared<Material>(test::ShaderWithModes({"A"}));
    object.renderer->sharedMaterials = {material};
    object.renderer->mesh = Pair();
    const std::weak_ptr<const Mesh> mesh = object.renderer->mesh;
    const std::weak_ptr<const Material> old = material;
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 1u);
    material = nullptr;
    object.renderer->sharedMaterials = {m_Materials[0]};
    object.renderer->mesh = test::Cube();
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.at(0).material, m_Materials[0]);
    EXPECT_TRUE(mesh.expired());
    EXPECT_TRUE(old.expired());
}

TEST_F(ManyRenderers, AreRightAgainOnceParentsNoLongerGoRoundInACircle)
{
    GameObject& moved = test::AddCube(m_Scene, "moved", {0, 0, 10}, {m_Materials[0]});
    GameObject& object = test::AddCube(m_Scene, "cube", {0, 0, 10}, {m_Materials[0]});
    GameObject& other = test::AddCube(m_Scene, "other", {0, 0, 10}, {m_Materials[0]});
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 3u);
    moved.transform.localPosition = {0, 0, -10}; // out of sight, while the frame fails
    object.transform.parent = &other.transform;
    other.transform.parent = &object.transform;
    for (int again = 0; again < 2; ++again)
    {
        EXPECT_THROW(Cull(m_Scene, m_Camera, 1.0f), ContractError);
    }
    object.transform.parent = nullptr;
    other.transform.parent = nullptr;
    const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
    ASSERT_EQ(results.items.size(), 2u);
    EXPECT_EQ(results.items.at(0).object, &object);
}

TEST_F(ManyRenderers, AreJudgedTogetherAsOneByOne)
{
    for (int i = 0; i < 300; ++i)
    {
        Add();
        Change();
    }
    m_Camera.orthographic = true;
    m_Camera.orthographicSize = 1000.0f;
    m_Camera.nearClipPlane = -1000.0f;
    m_Camera.farClipPlane = 1000.0f;
    const RendererItems items = Cull(m_Scene, m_Camera, 1.0f).items;
    ASSERT_GT(items.size(), 100u);
    for (int round = 0; round < 50; ++round)
    {
        const FilteringSettings filtering(RenderQueueRange{1900 + Number(300), 2100 + Number(2000)},
                                          LayerMask(Bits()), RenderingLayerMask(Bits()));
        DrawingSettings drawing;
        drawing.shaderTagIds = {ShaderTagId(Number(4) == 0 ? "B" : "A")};
        FilterCounts counts{};
        std::vector<const Material*> drawn;
        for (const RendererItem& item : items)
        {
            const FilterVerdict verdict = Judge(item.filter, filtering, drawing);
            ++counts[static_cast<std::size_t>(verdict)];
            if (verdict == FilterVerdict::Drawn)
            {
                drawn.push_back(item.material.get());
            }
        }
        const JudgedItems judged = Judge(items, filtering, drawing);
        EXPECT_EQ(judged.counts, counts);
        std::vector<const Material*> together;
        for (const RendererItem& item : judged.drawn)
        {
            together.push_back(item.material.get());
        }
        EXPECT_EQ(together, drawn);
    }
}

TEST_F(ManyRenderers, AreSortedTogetherAsAListOfThemIs)
{
    for (int i = 0; i < 300; ++i)
    {
        Add();
        Any().transform.localPosition = glm::vec3(0, 0, Number(20)); // many at equal distances
    }
    m_Camera.orthographic = true;
    m_Camera.orthographicSize = 1000.0f;
    m_Camera.nearClipPlane = -1000.0f;
    m_Camera.farClipPlane = 1000.0f;
    const RendererItems items = Cull(m_Scene, m_Camera, 1.0f).items;
    std::vector<RendererItem> list;
    for (const RendererItem& item : items)
    {
        list.push_back(item);
    }
    for (int criteria = 0; criteria < 64; ++criteria)
    {
        SortingSettings sorting;
        sorting.criteria = static_cast<SortingCriteria>(criteria);
        sorting.distanceMetric =
            criteria % 3 == 0 ? DistanceMetric::Orthographic : DistanceMetric::Perspective;
        RendererItems together = items;
        Sort(together, sorting);
        std::vector<int> order(list.size());
        std::iota(order.begin(), order.end(), 0);
        Sort(list, sorting, order);
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            const RendererItem& item = list[static_cast<std::size_t>(order[i])];
            ASSERT_EQ(together[i].object, item.object)
                << "criteria " << criteria << ", place " << i;
            ASSERT_EQ(together[i].materialIndex, item.materialIndex);
        }
    }
}

} // namespace
} // namespace limn
