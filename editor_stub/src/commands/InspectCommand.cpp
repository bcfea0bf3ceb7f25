#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "explain/InspectReport.h"

#include <algorithm>
#include <limn/editor_stub/UnityRendererData.h>

namespace limn
{

namespace
{

InspectReport InspectScene(const std::string& file, AssetContext& assets, Console& console)
{
    const SceneAsset asset = LoadScene(file, assets, InactiveObjects::Check);
    console.Print(asset.notes);
    InspectReport report;
    report.kind = "scene";
    for (const Volume& volume : asset.volumes)
    {
        if (!volume.sharedProfile)
        {
            continue; // it does nothing, as a note has said
        }
        const VolumeProfile& profile = *volume.sharedProfile;
        report.volumes.push_back({volume.name, volume.enabled, volume.isGlobal, volume.priority,
                                  volume.weight, volume.blendDistance, profile.name,
                                  InspectProfile(profile, assets.volumeComponents())});
    }
    report.features =
        InspectFeatures(asset.renderer, assets.features(), asset.layers, asset.renderingLayers);
    return report;
}

InspectReport InspectOwn(const std::vector<YamlNode>& documents, const std::string& file,
                         AssetContext& assets, Console& console)
{
    // Without a camera it is no scene; a wrong one should still be called a scene.
    if (FileKindOf(file) == FileKind::Scene || documents.front().Find("camera"))
    {
        return InspectScene(file, assets, console);
    }
    InspectReport report;
    report.kind = "profile";
    report.volumes.emplace_back().components = InspectProfileFile(file, documents, assets, console);
    return report;
}

InspectReport InspectUnity(const UnityAsset& asset, AssetContext& assets, Console& console)
{
    InspectReport report;
    report.kind = KindOfUnityAsset(asset);
    if (report.kind == "profile")
    {
        report.volumes.emplace_back().components =
            InspectProfileFile(asset.file(), {YamlNode()}, assets, console);
    }
    else if (report.kind == "renderer")
    {
        const UnityRendererDataLoadResult result = LoadUnityRendererData(asset.file(), assets);
        console.Print(result.notes);
        report.asset = InspectRenderer(asset);
        report.features = InspectFeatures(result.renderer, assets.features(), {}, {});
    }
    else if (report.kind == "pipeline")
    {
        report.asset = InspectPipeline(asset);
    }
    else
    {
        report.asset = InspectMaterial(asset, assets);
    }
    return report;
}

/// Returns whether a word that is no file may be a name: it has no ending that files have.
bool MayBeName(const std::string& word)
{
    std::error_code ignored;
    return !std::filesystem::exists(word, ignored) && FileKindOf(word) == FileKind::Unknown &&
           std::filesystem::path(word).extension().empty();
}

} // namespace

InspectReport InspectFile(const InspectOptions& options, Console& console)
{
    const std::string& file = options.file;
    ShaderCompilerOptions compilerOptions;
    compilerOptions.includeFolders.assign(options.roots.begin(), options.roots.end());
    AssetContext assets(std::move(compilerOptions));
    assets.AddRootsAround(file);
    std::ranges::for_each(options.plugins, [&](const auto& each) { assets.LoadPlugin(each); });
    if (MayBeName(file))
    {
        return InspectName(file, assets);
    }
    if (FileKindOf(file) == FileKind::UnityScene)
    {
        return InspectScene(file, assets, console);
    }
    const std::string text = ReadYamlText(file);
    return IsUnityAsset(text) ? InspectUnity(UnityAsset(text, file), assets, console)
                              : InspectOwn(ParseYaml(text, file), file, assets, console);
}

ExitCode RunInspect(const InspectOptions& options, Console& console)
{
    if (FileKindOf(options.file) != FileKind::UnityMaterial)
    {
        RequireKind(options.file, {FileKind::Scene, FileKind::Profile, FileKind::UnityScene},
                    "inspect");
    }
    const InspectReport report = InspectFile(options, console);
    options.json ? console.Data(ToJson(report)) : console.Results(ToText(report));
    return ExitCode::Done;
}

} // namespace limn
