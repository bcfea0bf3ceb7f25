#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>
#include <cmath>

namespace limn
{

namespace
{

/// The part of the picture's height that a LOD group takes, as Unity reckons it.
float HeightOnScreen(const UnityGameObject& object, const UnityReader& group, const Camera& camera,
                     float lodBias)
{
    glm::vec3 point(0.0f);
    float size = 1.0f;
    group.Read("m_LocalReferencePoint", point);
    group.Read("m_Size", size);
    const glm::dmat4 world = object.drawn->transform.worldMatrix();
    double scale = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
        scale = std::max(scale, glm::length(glm::dvec3(world[axis])));
    }
    const double whole = static_cast<double>(size) * scale * static_cast<double>(lodBias);
    if (camera.orthographic)
    {
        return static_cast<float>(whole / (2.0 * static_cast<double>(camera.orthographicSize)));
    }
    const glm::dvec3 place(world * glm::dvec4(glm::dvec3(point), 1.0));
    const double distance = glm::length(place - glm::dvec3(camera.transform.position()));
    const double tangent = std::tan(glm::radians(static_cast<double>(camera.fieldOfView)) * 0.5);
    return static_cast<float>(whole / std::max(2.0 * distance * tangent, 1e-9));
}

/// Finds the renderers that a LOD group does not show at the camera's distance.
std::set<const UnityInstance*> FindHiddenLods(UnitySceneLoader& loader, float lodBias)
{
    std::set<const UnityInstance*> all;
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        const UnityInstance* group = object->Find(UnityClass::LODGroup);
        if (group == nullptr || !object->isActive)
        {
            continue;
        }
        const UnityReader reader = loader.ReaderOf(*object, *group);
        bool isEnabled = true;
        reader.Read("m_Enabled", isEnabled);
        const float height = HeightOnScreen(*object, reader, loader.asset.camera, lodBias);
        const std::size_t count = isEnabled ? reader.Count("m_LODs") : 0;
        bool isShown = false; // one of the LODs so far
        std::set<const UnityInstance*> shown;
        std::set<const UnityInstance*> hidden;
        for (std::size_t i = 0; i < count; ++i)
        {
            const std::string lod = "m_LODs.Array.data[" + std::to_string(i) + "].";
            float least = 0.0f;
            reader.Read(lod + "screenRelativeHeight", least);
            const bool isThis = !isShown && height >= least;
            isShown = isShown || isThis;
            const std::size_t renderers = reader.Count(lod + "renderers");
            for (std::size_t r = 0; r < renderers; ++r)
            {
                (isThis ? shown : hidden)
                    .insert(reader
                                .Reference(lod + "renderers.Array.data[" + std::to_string(r) +
                                           "].renderer")
                                .object);
            }
        }
        std::ranges::set_difference(hidden, shown, std::inserter(all, all.end()));
    }
    return all;
}

void AddMaterials(UnitySceneLoader& loader, const UnityReader& reader, MeshRenderer& renderer)
{
    const std::size_t count = reader.Count("m_Materials");
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::string path = "m_Materials.Array.data[" + std::to_string(i) + "]";
        renderer.sharedMaterials.push_back(
            loader.materials.Load(reader.Reference(path).asset, reader, path));
    }
}

void AddRenderer(UnitySceneLoader& loader, const UnityGameObject& object,
                 const std::set<const UnityInstance*>& hidden)
{
    const UnityInstance* filter = object.Find(UnityClass::MeshFilter);
    const UnityInstance* renderer = object.Find(UnityClass::MeshRenderer);
    const UnityInstance* skinned = object.Find(UnityClass::SkinnedMeshRenderer);
    if (skinned != nullptr)
    {
        filter = renderer = skinned; // at its rest pose
    }
    if (renderer == nullptr || filter == nullptr)
    {
        return;
    }
    const UnityReader reader = loader.ReaderOf(object, *renderer);
    MeshRenderer made;
    reader.Read("m_Enabled", made.enabled);
    const UnityReader mesh = loader.ReaderOf(object, *filter);
    const UnityTarget target = mesh.Reference("m_Mesh");
    if (target.isNull())
    {
        return;
    }
    if (object.isActive && made.enabled)
    {
        made.mesh = loader.materials.LoadMesh(target, mesh);
    }
    made.enabled = made.enabled && hidden.count(renderer) == 0;
    reader.ReadEnum("m_CastShadows", ShadowCastingMode::ShadowsOnly, made.shadowCastingMode);
    reader.Read("m_RenderingLayerMask", made.renderingLayerMask);
    if (made.mesh)
    {
        AddMaterials(loader, reader, made);
    }
    object.drawn->renderer = std::move(made);
}

} // namespace

void AddUnityObjects(UnitySceneLoader& loader)
{
    for (UnityGameObject* object : loader.hierarchy.objects())
    {
        const UnityReader reader(*object->object, object->path, loader.notes);
        std::string name;
        reader.Read("m_Name", name);
        GameObject& drawn = loader.asset.scene.Add(std::move(name));
        object->drawn = &drawn;
        reader.Read("m_Layer", drawn.layer);
        if (drawn.layer < 0 || drawn.layer > 31)
        {
            reader.Note("m_Layer", "it is none of 0 to 31, so it is 0");
            drawn.layer = 0;
        }
        drawn.activeSelf = object->isActive;
        const UnityReader transform = loader.ReaderOf(*object, *object->transform);
        transform.Read("m_LocalPosition", drawn.transform.localPosition);
        transform.Read("m_LocalRotation", drawn.transform.localRotation);
        transform.Read("m_LocalScale", drawn.transform.localScale);
        drawn.transform.parent =
            object->parent != nullptr ? &object->parent->drawn->transform : nullptr;
    }
}

void AddUnityRenderers(UnitySceneLoader& loader, float lodBias)
{
    const std::set<const UnityInstance*> hidden = FindHiddenLods(loader, lodBias);
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        AddRenderer(loader, *object, hidden);
    }
}

} // namespace limn
