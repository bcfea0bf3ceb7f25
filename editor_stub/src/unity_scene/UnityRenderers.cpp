#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>
#include <cmath>
#include <limn/base/NumberText.h>

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
            loader.materials.Load(reader.Reference(path), reader, path));
    }
}

/// Returns the bones of a renderer in the order of a skin's poses: each leads from the bone's space
/// into the world.
/// @param missing  gets the number of bones that there are not
std::vector<glm::dmat4> FindBones(const UnitySceneLoader& loader, const UnityReader& renderer,
                                  const MeshSkin& skin, std::size_t& missing)
{
    std::map<std::string, glm::dmat4> byName;
    std::vector<std::optional<glm::dmat4>> bones;
    const std::size_t count = renderer.Count("m_Bones");
    for (std::size_t i = 0; i < count; ++i)
    {
        const UnityTarget target =
            renderer.Reference("m_Bones.Array.data[" + std::to_string(i) + "]");
        const UnityGameObject* bone = loader.hierarchy.Find(target.object);
        bones.emplace_back();
        if (bone != nullptr)
        {
            bones.back() = bone->drawn->transform.worldMatrix();
            byName.try_emplace(bone->drawn->name, *bones.back());
        }
    }
    std::vector<glm::dmat4> found;
    for (std::size_t i = 0; i < skin.bindPoses.size(); ++i)
    {
        // A list that Unity wrote may be in another order than limn's reader of models has.
        const auto named = i < skin.bones.size() ? byName.find(skin.bones[i]) : byName.end();
        const bool isListed = i < bones.size() && bones[i];
        missing += named == byName.end() && !isListed ? 1 : 0;
        found.push_back(named != byName.end() ? named->second
                        : isListed            ? *bones[i]
                                              : glm::dmat4(1.0));
    }
    return found;
}

/// Returns the mesh of a SkinnedMeshRenderer where its bones, as the scene saves them, put it. The
/// place of the object itself does not matter to it, as in Unity.
std::shared_ptr<const Mesh> Pose(UnitySceneLoader& loader, const UnityGameObject& object,
                                 const UnityReader& renderer,
                                 const std::shared_ptr<const Mesh>& mesh)
{
    const MeshSkin* skin = loader.materials.FindSkin(*mesh);
    if (skin == nullptr && renderer.Count("m_Bones") == 0)
    {
        return mesh; // it has blend shapes alone
    }
    if (skin == nullptr)
    {
        renderer.Note("m_Bones", "limn finds no bone weights in the mesh " + mesh->name() +
                                     ", so it is drawn at rest, where its object is");
        return mesh;
    }
    std::size_t missing = 0;
    std::vector<glm::dmat4> bones = FindBones(loader, renderer, *skin, missing);
    if (missing > 0)
    {
        renderer.Note("m_Bones", "the scene lacks " + CountText(missing, "bone") + " of the " +
                                     std::to_string(bones.size()) + " that the mesh " +
                                     mesh->name() +
                                     " follows, so it is drawn at rest, where its object is");
        return mesh;
    }
    const glm::dmat4 toObject = glm::inverse(glm::dmat4(object.drawn->transform.worldMatrix()));
    for (glm::dmat4& bone : bones)
    {
        bone = toObject * bone;
    }
    try
    {
        return PoseMesh(mesh, *skin, bones);
    }
    catch (const ContractError&)
    {
        renderer.Note("m_Bones", "a vertex of the mesh " + mesh->name() +
                                     " gets no place from its bones, because a scale of the object "
                                     "is 0 or a place is too large, so it is drawn at rest");
        return mesh;
    }
}

void AddRenderer(UnitySceneLoader& loader, const UnityGameObject& object,
                 const std::set<const UnityInstance*>& hidden)
{
    const UnityInstance* filter = object.Find(UnityClass::MeshFilter);
    if (const UnityInstance* sprite = object.Find(UnityClass::SpriteRenderer))
    {
        AddUnitySprite(loader, object, *sprite);
        return;
    }
    const UnityInstance* renderer = object.Find(UnityClass::MeshRenderer);
    const UnityInstance* skinned = object.Find(UnityClass::SkinnedMeshRenderer);
    if (skinned != nullptr)
    {
        filter = renderer = skinned;
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
        made.mesh =
            made.mesh && skinned != nullptr ? Pose(loader, object, reader, made.mesh) : made.mesh;
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
