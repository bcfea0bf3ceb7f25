#include "commands/InspectCommand.h"

#include "assets/FileKind.h"
#include "reports/InspectProfileFile.h"

#include <algorithm>
#include <limn/editor_stub/RunLimn.h>
#include <limn/editor_stub/UnityRendererData.h>
#include <limn/volume/UnityAsset.h>

namespace limn
{

namespace
{

std::string KindOfUnityAsset(const std::string& text, const std::string& file)
{
    return UnityAsset(text, file).FindWithField("m_RendererFeatures") ? "renderer" : "profile";
}

std::string KindOf(const std::filesystem::path& path, const std::vector<YamlNode>& documents)
{
    // Without a camera it is no scene; a wrong one should still be called a scene.
    const bool isScene =
        FileKindOf(path) == FileKind::Scene || documents.front().Find("camera") != nullptr;
    return isScene ? "scene" : "profile";
}

InspectReport InspectScene(const std::string& file, AssetContext& assets, Console& console)
{
    const SceneAsset asset = LoadScene(file, assets);
    console.Print(asset.notes);
    InspectReport report;
    for (const Volume& volume : asset.volumes)
    {
        const VolumeProfile& profile = *volume.sharedProfile;
        report.volumes.push_back({volume.name, volume.enabled, volume.isGlobal, volume.priority,
                                  volume.weight, volume.blendDistance, profile.name,
                                  InspectProfile(profile, assets.volumeComponents())});
    }
    report.features =
        InspectFeatures(asset.renderer, assets.features(), asset.layers, asset.renderingLayers);
    return report;
}

InspectReport Inspect(const InspectOptions& options, Console& console)
{
    const std::string& file = options.file;
    ShaderCompilerOptions compilerOptions;
    compilerOptions.includeFolders.assign(options.roots.begin(), options.roots.end());
    AssetContext assets(std::move(compilerOptions));
    assets.AddRootsAround(file);
    for (const std::string& plugin : options.plugins)
    {
        assets.LoadPlugin(plugin);
    }
    const std::string text = ReadYamlText(file);
    const bool isUnity = IsUnityAsset(text);
    const std::vector<YamlNode> documents =
        isUnity ? std::vector<YamlNode>(1) : ParseYaml(text, file);
    const std::string kind = isUnity ? KindOfUnityAsset(text, file) : KindOf(file, documents);
    InspectReport report;
    if (kind == "scene")
    {
        report = InspectScene(file, assets, console);
    }
    else if (kind == "renderer")
    {
        const UnityRendererDataLoadResult result = LoadUnityRendererData(file, assets);
        console.Print(result.notes);
        report.features = InspectFeatures(result.renderer, assets.features(), {}, {});
    }
    else
    {
        report.volumes.emplace_back().components =
            InspectProfileFile(file, documents, assets, console);
    }
    report.kind = kind;
    return report;
}

} // namespace

int RunInspect(const InspectOptions& options, Console& console)
{
    RequireKind(options.file, {FileKind::Scene, FileKind::Profile}, "inspect");
    const InspectReport report = Inspect(options, console);
    console.Results(options.json ? ToJson(report) : ToText(report));
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn
