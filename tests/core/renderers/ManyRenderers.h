#pragma once

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

    void SeeEverything()
    {
        m_Camera.orthographic = true;
        m_Camera.orthographicSize = 1000.0f;
        m_Camera.nearClipPlane = -1000.0f;
        m_Camera.farClipPlane = 1000.0f;
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
                expected.push_back(
                    {&object,
                     material,
                     index,
                     std::min(index, last),
                     {material->renderQueue(), object.layer, renderer.renderingLayerMask,
                      material->shader().get(), material}});
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

} // namespace
} // namespace limn
