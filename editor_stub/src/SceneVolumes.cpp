#include "SceneLoader.h"

namespace limn
{

namespace
{

void ReadCollider(const YamlNode& node, const std::string& subject, Volume& volume,
                  AssetDiagnostics& diagnostics)
{
    BoxCollider& box = volume.colliders.emplace_back();
    YamlMapReader map(node, subject, diagnostics);
    map.Read("enabled", box.enabled);
    map.Read("center", box.center);
    map.Read("size", box.size);
    map.Finish();
}

void ReadPlace(YamlMapReader& map, Volume& volume, const std::string& subject,
               AssetDiagnostics& diagnostics)
{
    Transform transform;
    ReadTransform(map, transform, diagnostics);
    volume.position = transform.localPosition;
    volume.rotation = transform.localRotation;
    volume.scale = transform.localScale;
    if (const YamlNode* colliders = map.Find("colliders"))
    {
        const std::string list = subject + ".colliders";
        int index = 0;
        for (const YamlNode& item : ReadItems(*colliders, list, diagnostics))
        {
            ReadCollider(item, list + "[" + std::to_string(index++) + "]", volume, diagnostics);
        }
    }
    if (!volume.isGlobal && volume.colliders.empty())
    {
        diagnostics.Note(map.node().location(),
                         subject + ": does nothing, it is not global and has no colliders");
    }
}

void ReadProfile(YamlMapReader& map, Volume& volume, SceneLoader& loader)
{
    const YamlNode* node = map.Require("profile");
    if (!node)
    {
        return;
    }
    References& references = loader.references;
    const auto load = [&references](const std::filesystem::path& path)
    {
        return references.assets().LoadProfile(path);
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
    YamlMapReader map(node, subject, loader.diagnostics);
    map.Read("name", volume.name);
    map.Read("enabled", volume.enabled);
    map.Read("isGlobal", volume.isGlobal);
    map.Read("priority", volume.priority);
    map.Read("weight", volume.weight, {0.0, 1.0});
    map.Read("blendDistance", volume.blendDistance, {0.0, 1e9});
    if (const YamlNode* layer = map.Find("layer"))
    {
        volume.layer =
            ReadLayerIndex(*layer, map.SubjectOf("layer"), loader.layers(), loader.diagnostics)
                .value_or(0);
    }
    ReadProfile(map, volume, loader);
    ReadPlace(map, volume, subject, loader.diagnostics);
    map.Finish();
}

} // namespace

void ReadVolumes(const YamlNode& node, SceneLoader& loader)
{
    int index = 0;
    for (const YamlNode& item : ReadItems(node, "volumes", loader.diagnostics))
    {
        ReadVolume(item, "volumes[" + std::to_string(index++) + "]", loader);
    }
}

} // namespace limn
