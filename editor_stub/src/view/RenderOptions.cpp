#include "view/RenderOptions.h"

#include "console/CacheFolder.h"

#include <limn/base/WorkerProcess.h>
#include <limn/editor_stub/Overrides.h>

namespace limn
{

namespace
{

/// "" if nothing is to be kept.
std::filesystem::path ChooseCacheFolder(const RenderOptions& options, Console& console)
{
    if (options.noCache)
    {
        return {};
    }
    const bool isDefault = options.cacheFolder.empty();
    const std::filesystem::path folder =
        isDefault ? DefaultCacheFolder() : std::filesystem::path(options.cacheFolder);
    const std::string problem = folder.empty() ? std::string() : MakeFolder(folder);
    if (problem.empty())
    {
        return folder;
    }
    if (!isDefault)
    {
        throw AssetError(folder.string(), {}, "the cache folder cannot be made: " + problem);
    }
    console.Note("nothing is cached: " + folder.string() + " cannot be made: " + problem);
    return {};
}

} // namespace

ShaderCompilerOptions ChooseCompilerOptions(const RenderOptions& options, Console& console)
{
    ShaderCompilerOptions result;
    result.cacheFolder = ChooseCacheFolder(options, console);
    result.cacheLimit = CacheLimit(result.cacheLimit);
    result.packages.insert(options.packages.begin(), options.packages.end());
    result.includeFolders.assign(options.roots.begin(), options.roots.end());
    result.process = std::make_shared<WorkerProcess>();
    return result;
}

SceneAsset LoadForRendering(const RenderOptions& options, AssetContext& assets)
{
    for (const std::string& plugin : options.plugins)
    {
        assets.LoadPlugin(plugin);
    }
    SceneAsset asset = LoadScene(options.scene, assets, InactiveObjects::Check);
    if (!options.profile.empty())
    {
        ReplaceProfile(asset, options.profile, assets);
    }
    ApplyOverrides(asset, options.overrides, assets);
    asset.width = options.width > 0 ? options.width : asset.width;
    asset.height = options.height > 0 ? options.height : asset.height;
    if (const std::string problem = ScaledSizeProblem(asset); !problem.empty())
    {
        throw AssetError(options.scene, {}, problem);
    }
    ApplySelection(asset, options.selection);
    return asset;
}

} // namespace limn
