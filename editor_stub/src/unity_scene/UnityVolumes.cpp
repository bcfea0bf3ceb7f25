#include "unity_scene/UnitySceneLoader.h"

namespace limn
{

namespace
{

template <typename Collider>
void AddCollider(const UnityReader& reader, Collider collider, Volume& volume)
{
    reader.Read("m_Enabled", collider.enabled);
    reader.Read("m_Center", collider.center);
    if constexpr (requires { collider.size; })
    {
        reader.Read("m_Size", collider.size);
    }
    if constexpr (requires { collider.radius; })
    {
        reader.Read("m_Radius", collider.radius);
    }
    if constexpr (requires { collider.direction; })
    {
        reader.Read("m_Height", collider.height);
        reader.ReadEnum("m_Direction", 2, collider.direction);
    }
    volume.colliders.emplace_back(collider);
}

void AddColliders(const UnitySceneLoader& loader, const UnityGameObject& object, Volume& volume)
{
    for (const UnityInstance* component : object.components)
    {
        const UnityReader reader = loader.ReaderOf(object, *component);
        switch (component->classID)
        {
        case UnityClass::BoxCollider:
            AddCollider(reader, BoxCollider(), volume);
            break;
        case UnityClass::SphereCollider:
            AddCollider(reader, SphereCollider(), volume);
            break;
        case UnityClass::CapsuleCollider:
            AddCollider(reader, CapsuleCollider(), volume);
            break;
        default:
            break;
        }
    }
    const glm::dmat4 world = object.drawn->transform.worldMatrix();
    for (int axis = 0; axis < 3; ++axis)
    {
        volume.scale[axis] = static_cast<float>(glm::length(glm::dvec3(world[axis])));
    }
}

void ReadProfile(UnitySceneLoader& loader, const UnityReader& reader, Volume& volume)
{
    const UnityReference profile = reader.Reference("sharedProfile").asset;
    if (profile.isNull())
    {
        return;
    }
    const std::filesystem::path* path = loader.database.Find(profile.guid);
    if (path == nullptr)
    {
        reader.Note("sharedProfile",
                    loader.database.WhyNotFound(profile) + ", so the volume does nothing");
        return;
    }
    try
    {
        const VolumeProfileLoadResult& result =
            loader.assets.LoadProfile(*path, loader.asset.layers);
        volume.sharedProfile = result.profile;
        loader.notes.Add(result.notes);
    }
    catch (const AssetError& error)
    {
        loader.notes.Add(error.diagnostics());
    }
}

} // namespace

void ReadUnityVolumes(UnitySceneLoader& loader)
{
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        const UnityInstance* component = object->FindScript(k_Volume);
        if (component == nullptr || !object->isActive)
        {
            continue;
        }
        const UnityReader reader = loader.ReaderOf(*object, *component);
        Volume& volume = loader.asset.volumes.emplace_back();
        volume.name = object->drawn->name;
        volume.layer = object->drawn->layer;
        reader.Read("m_Enabled", volume.enabled);
        reader.Read(reader.Has("m_IsGlobal") ? "m_IsGlobal" : "isGlobal", volume.isGlobal);
        reader.Read("priority", volume.priority);
        reader.ReadIn("blendDistance", 0.0f, 1e9f, volume.blendDistance);
        reader.Read("weight", volume.weight);
        volume.position = object->drawn->transform.position();
        volume.rotation = object->drawn->transform.rotation();
        AddColliders(loader, *object, volume);
        ReadProfile(loader, reader, volume);
    }
}

} // namespace limn
