#include "scene/Loader.h"

#include "console/Texts.h"

#include <algorithm>

namespace limn
{

namespace
{

void ReadDirection(SceneMapReader& map, int& direction, AssetDiagnostics& diagnostics)
{
    const YamlNode* node = map.Find("direction");
    const auto name = node ? ReadString(*node, map.SubjectOf("direction"), diagnostics)
                           : std::optional<std::string>();
    if (!name)
    {
        return; // not there, or reported already
    }
    const std::size_t axis = name->size() == 1 ? std::string_view("xyz").find(*name) : 3;
    if (axis > 2)
    {
        diagnostics.Error(node->location(), map.SubjectOf("direction") + ": '" + *name +
                                                "' is no axis; x, y or z is expected");
        return;
    }
    direction = static_cast<int>(axis);
}

void ReadMeshCollider(SceneMapReader& map, bool enabled, Volume& volume, SceneLoader& loader)
{
    const YamlNode* node = map.Find("mesh");
    const auto mesh = node ? ReadMesh(*node, map.SubjectOf("mesh"), loader) : nullptr;
    if (!mesh)
    {
        return; // reported elsewhere
    }
    try
    {
        MeshCollider collider(mesh);
        collider.enabled = enabled;
        volume.colliders.push_back(std::move(collider));
    }
    catch (const ContractError& error)
    {
        loader.diagnostics.Error(node->location(), map.SubjectOf("mesh") + ": " + error.what());
    }
}

void ReadShape(SceneMapReader& map, std::string_view type, bool enabled, Volume& volume,
               SceneLoader& loader)
{
    if (type == "mesh")
    {
        ReadMeshCollider(map, enabled, volume, loader);
    }
    else if (type == "sphere")
    {
        SphereCollider sphere{enabled};
        map.Read("center", sphere.center);
        map.Read("radius", sphere.radius);
        volume.colliders.push_back(sphere);
    }
    else if (type == "capsule")
    {
        CapsuleCollider capsule{enabled};
        map.Read("center", capsule.center);
        map.Read("radius", capsule.radius);
        map.Read("height", capsule.height);
        ReadDirection(map, capsule.direction, loader.diagnostics);
        volume.colliders.push_back(capsule);
    }
    else
    {
        BoxCollider box{enabled};
        map.Read("center", box.center);
        map.Read("size", box.size);
        volume.colliders.push_back(box);
    }
}

/// A box unless the collider says otherwise; null, with an error, if there is no such shape.
const ColliderShape* ReadColliderType(const YamlNode& collider, const std::string& subject,
                                      AssetDiagnostics& diagnostics)
{
    const auto& shapes = scene_keys::k_ColliderShapes;
    const YamlNode* node = collider.Find("type");
    const auto type = node ? ReadString(*node, subject, diagnostics) : std::nullopt;
    if (!type)
    {
        return &shapes[0];
    }
    const auto found = std::ranges::find(shapes, *type, &ColliderShape::type);
    if (found == shapes.end())
    {
        diagnostics.Error(node->location(),
                          subject + ": unknown shape " +
                              UnknownName(*type, NamesOf(shapes, &ColliderShape::type)));
        return nullptr;
    }
    return &*found;
}

void ReadCollider(const YamlNode& node, const std::string& subject, Volume& volume,
                  SceneLoader& loader)
{
    const ColliderShape* shape = ReadColliderType(node, subject + ".type", loader.diagnostics);
    if (!shape)
    {
        return;
    }
    SceneMapReader map(node, subject, shape->keys, loader.diagnostics);
    map.Find("type");
    bool enabled = true;
    map.Read("enabled", enabled);
    ReadShape(map, shape->type, enabled, volume, loader);
    map.Finish();
}

void ReadPlace(SceneMapReader& map, Volume& volume, const std::string& subject, SceneLoader& loader)
{
    AssetDiagnostics& diagnostics = loader.diagnostics;
    Transform transform;
    ReadTransform(map, transform, diagnostics);
    volume.position = transform.localPosition;
    volume.rotation = transform.localRotation;
    volume.scale = transform.localScale;
    for (const auto& [item, place] : ReadItems(map, "colliders", diagnostics))
    {
        ReadCollider(item, place, volume, loader);
    }
    if (volume.isGlobal && !volume.colliders.empty())
    {
        diagnostics.Note(map.node().location(),
                         subject + ": it is global, so its colliders count for nothing; "
                                   "'isGlobal: false' limits it to them");
    }
    if (!volume.isGlobal && volume.colliders.empty())
    {
        diagnostics.Note(map.node().location(),
                         subject +
                             ": it does nothing, because it is not global and has no colliders");
    }
}

void ReadProfile(SceneMapReader& map, Volume& volume, SceneLoader& loader)
{
    const YamlNode* node = map.Find("profile");
    if (!node)
    {
        return;
    }
    References& references = loader.references;
    const std::string extension = std::filesystem::path(node->scalar()).extension().string();
    if (node->isScalar() && extension != ".yaml" && extension != ".yml" && extension != ".asset")
    {
        // Any other file would be printed line by line, as so many unknown components.
        loader.diagnostics.Error(node->location(),
                                 map.SubjectOf("profile") + ": '" + node->scalar() +
                                     "' is no profile; a .profile.yaml file, or Unity's .asset, "
                                     "is expected");
        return;
    }
    const auto load = [&references, &loader](const std::filesystem::path& path)
    {
        return references.assets().LoadProfile(path, loader.asset.layers);
    };
    VolumeProfileLoadResult result = references.Read(*node, map.SubjectOf("profile"), load);
    volume.sharedProfile = result.profile;
    loader.AddNotes(result.notes);
}

void ReadVolume(const YamlNode& node, const std::string& place, SceneLoader& loader)
{
    Volume& volume = loader.asset.volumes.emplace_back();
    const YamlNode* name = node.Find("name");
    volume.name = name && name->isScalar() ? name->scalar() : place;
    const std::string subject = name ? "volume '" + volume.name + "'" : place;
    SceneMapReader map(node, subject, scene_keys::k_Volume, loader.diagnostics);
    map.Read("name", volume.name);
    map.Read("enabled", volume.enabled);
    map.Read("isGlobal", volume.isGlobal);
    map.Read("priority", volume.priority);
    map.Read("weight", volume.weight);
    map.Read("blendDistance", volume.blendDistance);
    if (const YamlNode* layer = map.Find("layer"))
    {
        volume.layer =
            ReadLayerIndex(*layer, map.SubjectOf("layer"), loader.layers(), loader.diagnostics)
                .value_or(0);
    }
    ReadProfile(map, volume, loader);
    ReadPlace(map, volume, subject, loader);
    map.Finish();
}

} // namespace

void ReadVolumes(const YamlNode& node, SceneLoader& loader)
{
    for (const auto& [item, place] : ReadItems(node, "volumes", loader.diagnostics))
    {
        ReadVolume(item, place, loader);
    }
}

} // namespace limn
