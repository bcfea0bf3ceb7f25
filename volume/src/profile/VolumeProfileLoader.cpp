#include <limn/volume/VolumeProfileLoader.h>

#include "profile/UnityVolumeProfile.h"

#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

void ReadComponent(const YamlEntry& entry, VolumeComponent& component,
                   AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    YamlMapReader map(entry.value, entry.key, diagnostics, "parameter");
    map.Read("active", component.active);
    for (VolumeParameter* parameter : component.parameters())
    {
        if (const YamlNode* value = map.Find(parameter->name()))
        {
            parameter->ReadYaml(*value, map.SubjectOf(parameter->name()), diagnostics, context);
            parameter->SetOverrideState(true);
        }
    }
    map.Finish();
}

std::shared_ptr<VolumeProfile> ReadOwnProfile(const std::vector<YamlNode>& documents,
                                              const VolumeComponentRegistry& registry,
                                              AssetDiagnostics& diagnostics,
                                              const ProfileContext& context)
{
    auto profile = std::make_shared<VolumeProfile>();
    const YamlNode& root = documents.front();
    if (documents.size() > 1)
    {
        diagnostics.Error(
            documents[1].location(),
            "a second document begins here, but a profile is a single one; remove the line '---'");
    }
    if (!root.isMap())
    {
        diagnostics.Error(root.location(), "found " + root.Describe() +
                                               "; a profile begins with a component's name, "
                                               "'ScreenSpaceOutline:'");
    }
    const VolumeComponent* last = nullptr;
    std::string above;
    for (const YamlEntry& entry : root.entries())
    {
        if (!registry.Find(entry.key))
        {
            diagnostics.Error(
                entry.keyLocation,
                last && last->FindParameter(entry.key)
                    ? "'" + entry.key + "' is a parameter of " + above +
                          "; put spaces in front of it, so that it stands below '" + above + ":'"
                    : "unknown volume component " + UnknownName(entry.key, registry.names()));
            continue;
        }
        VolumeComponent& component = profile->Add(registry.Create(entry.key));
        last = &component;
        above = entry.key;
        ReadComponent(entry, component, diagnostics, context);
    }
    return profile;
}

} // namespace

VolumeProfileLoadResult ParseVolumeProfile(std::string_view text, const std::string& file,
                                           const VolumeComponentRegistry& registry,
                                           const ProfileContext& context)
{
    AssetDiagnostics diagnostics(file);
    std::shared_ptr<VolumeProfile> profile;
    if (IsUnityAsset(text))
    {
        const UnityAsset asset(std::string(text), file);
        profile = ReadUnityVolumeProfile(asset, registry, diagnostics, context);
    }
    else
    {
        profile = ReadOwnProfile(ParseYaml(text, file), registry, diagnostics, context);
        profile->name = std::filesystem::path(file).stem().stem().generic_string();
    }
    diagnostics.ThrowIfErrors();
    return {std::move(profile), diagnostics.notes()};
}

VolumeProfileLoadResult LoadVolumeProfile(const std::filesystem::path& path,
                                          const VolumeComponentRegistry& registry,
                                          const ProfileContext& context)
{
    return ParseVolumeProfile(ReadYamlText(path), path.generic_string(), registry, context);
}

} // namespace limn
