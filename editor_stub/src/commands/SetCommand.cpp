#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "console/CacheFolder.h"
#include "console/Json.h"
#include "scene/SettingsEdit.h"

#include <algorithm>
#include <limn/base/FileCache.h>
#include <limn/base/HashContent.h>
#include <limn/base/WriteFile.h>
#include <limn/volume/UnityAsset.h>

namespace limn
{

namespace
{

/// Returns whether the file has features, and not a profile's components.
bool HasFeatures(const std::string& file)
{
    const FileKind kind = FileKindOf(file);
    return kind == FileKind::Scene ||
           (kind == FileKind::UnityAsset &&
            LoadUnityAsset(file).FindWithField("m_RendererFeatures").has_value());
}

/// Returns the last changes of files, 16 MiB of them, by FileKey.
FileCache Changes()
{
    return FileCache(DefaultCacheFolder(), ".limnundo", "limn undo 1\n", 16u << 20u);
}

std::string FileKey(const std::string& file)
{
    return std::to_string(HashContent(std::filesystem::weakly_canonical(file).generic_string()));
}

/// Keeps a change for --undo, if the file has changed.
void KeepForUndo(const std::string& file, const FileEdit& edit)
{
    if (edit.before != edit.after)
    {
        Changes().Store(FileKey(file),
                        Json({{"before", edit.before}, {"after", edit.after}}).dump());
    }
}

/// @throws AssetError if no change is kept, or the file has been changed since
void Undo(const std::string& file)
{
    const FileLock lock(file);
    const std::string text = ReadYamlText(file);
    const std::optional<FileCache::Entry> entry = Changes().Load(FileKey(file));
    if (!entry)
    {
        throw AssetError(file, {}, "no change of this file by 'limn set' is kept");
    }
    const Json kept = Json::parse(entry->payload());
    const FileEdit edit{kept["after"].get<std::string>(), kept["before"].get<std::string>()};
    if (text != edit.before)
    {
        throw AssetError(file, {},
                         "the file has been changed since 'limn set' wrote it, and stays as it is");
    }
    ReplaceContent(file, edit.before, edit.after);
    KeepForUndo(file, edit);
}

Json ChangeJson(const ScalarChange& change)
{
    return {{"name", change.subject}, {"before", change.before}, {"after", change.after}};
}

void PrintChanges(const SetOptions& options, const std::vector<ScalarChange>& changes,
                  Console& console)
{
    if (options.json)
    {
        console.Data(
            JsonText({{"file", options.file}, {"changes", JsonList(changes, ChangeJson)}}));
        return;
    }
    for (const ScalarChange& change : changes)
    {
        console.Results(
            OneLine(change.subject + ": " + change.before +
                    (change.before == change.after ? ", as it was" : " → " + change.after)) +
            "\n");
    }
}

} // namespace

ExitCode RunSet(const SetOptions& options, Console& console)
{
    RequireKind(options.file, {FileKind::Scene, FileKind::Profile}, "set");
    if (options.undo)
    {
        Undo(options.file);
        options.json ? console.Data(JsonText({{"file", options.file}, {"undone", true}}))
                     : console.Result("the last change is undone; --undo once more brings it back");
        return ExitCode::Done;
    }
    AssetContext assets;
    std::ranges::for_each(options.plugins, [&](const auto& each) { assets.LoadPlugin(each); });
    std::vector<ValueAssignment> edits;
    for (const std::string& text : options.edits)
    {
        edits.push_back(ValueAssignment::Parse(text, text));
    }
    FileEdit written;
    const std::vector<ScalarChange> changes =
        HasFeatures(options.file)
            ? SetFeatureSettings(options.file, edits, assets, &written)
            : SetScalars(options.file, edits, assets.volumeComponents(), &written);
    KeepForUndo(options.file, written);
    PrintChanges(options, changes, console);
    return ExitCode::Done;
}

} // namespace limn
