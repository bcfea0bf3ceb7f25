#include "command_line/SharedFlags.h"
#include "console/Texts.h"
#include "explain/Explanation.h"
#include "explain/InspectReport.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace limn
{

namespace
{

/// Returns what `limn inspect` knows of a file, or nothing if the file is wrong: a person who is
/// typing is not told yet.
InspectReport InspectQuietly(const InspectOptions& file)
{
    std::ostringstream nowhere;
    Console console(nowhere, nowhere);
    try
    {
        return InspectFile(file, console);
    }
    catch (const std::exception&)
    {
        return {};
    }
}

/// Adds "NAME." of a group, or "NAME.value=" of each of its values if the word has the name.
void AddGroup(Candidates& candidates, const std::string& word, const std::string& name,
              const InspectedGroup& group)
{
    if (!word.starts_with(name + "."))
    {
        candidates.push_back(name + ".");
        return;
    }
    for (const InspectedValue& value : group.values)
    {
        candidates.push_back(name + "." + value.name + "=");
    }
}

void AddComponents(Candidates& candidates, const std::string& word, const InspectReport& report)
{
    for (const InspectedVolume& volume : report.volumes)
    {
        for (const InspectedGroup& component : volume.components)
        {
            AddGroup(candidates, word, component.type, component);
        }
    }
}

} // namespace

Candidates FileCandidates(const std::string& word, const std::vector<std::string>& endings)
{
    const std::string folder = word.substr(0, word.rfind('/') + 1); // of -1 as well
    const std::string begin = word.substr(folder.size());
    Candidates candidates;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    {
        const std::string name = entry->path().filename().string();
        std::error_code ignored;
        const bool isFolder = entry->is_directory(ignored);
        const bool isHidden = name.starts_with('.') && !begin.starts_with('.');
        const bool isOfKind = std::ranges::any_of(endings, [&](const std::string& ending)
                                                  { return name.ends_with(ending); });
        if (name.starts_with(begin) && !isHidden && (isFolder || isOfKind))
        {
            candidates.push_back(folder + name + (isFolder ? "/" : ""));
        }
    }
    std::ranges::sort(candidates);
    return word.starts_with('~') ? Candidates() : candidates;
}

Candidates SettingCandidates(const std::string& word, const InspectOptions& file)
{
    if (word.find('=') != std::string::npos)
    {
        return {};
    }
    const InspectReport report = InspectQuietly(file);
    Candidates candidates;
    AddComponents(candidates, word, report);
    for (const InspectedGroup& feature : report.features)
    {
        AddGroup(candidates, word, feature.name, feature);
        AddGroup(candidates, word, feature.type, feature);
    }
    if (std::ranges::none_of(candidates, [&word](const std::string& candidate)
                             { return candidate.starts_with(word); }))
    {
        const AssetContext assets;
        const VolumeComponentRegistry& known = assets.volumeComponents();
        InspectReport all;
        VolumeProfile profile;
        for (const auto& entry : known.entries())
        {
            profile.Add(entry->create());
        }
        all.volumes.emplace_back().components = InspectProfile(profile, known);
        AddComponents(candidates, word, all);
    }
    return candidates;
}

Candidates ObjectCandidates(const RenderOptions& scene)
{
    ShaderCompilerOptions options;
    options.includeFolders.assign(scene.roots.begin(), scene.roots.end());
    AssetContext assets(std::move(options));
    const SceneAsset asset = LoadForRendering(scene, assets);
    std::set<std::string> names;
    for (const GameObject* object : ObjectsOf(asset.scene))
    {
        names.insert(object->name);
    }
    return {names.begin(), names.end()};
}

Candidates TechniqueCandidates(const std::vector<std::string>& plugins)
{
    AssetContext assets;
    std::ranges::for_each(plugins, [&](const auto& each) { assets.LoadPlugin(each); });
    Candidates names;
    std::ranges::transform(assets.features().techniques(), std::back_inserter(names),
                           &Technique::name);
    return names;
}

Candidates NameCandidates()
{
    const AssetContext assets;
    return KnownNames(assets);
}

Candidates ComponentCandidates()
{
    const AssetContext assets;
    const std::vector<std::string_view> names = assets.volumeComponents().names();
    return {names.begin(), names.end()};
}

} // namespace limn
