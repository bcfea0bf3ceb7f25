#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "scene/SettingsEdit.h"

#include <limn/editor_stub/RunLimn.h>
#include <limn/volume/UnityAsset.h>

namespace limn
{

namespace
{

/// Whether the file has features, and not a profile's components.
bool HasFeatures(const std::string& file)
{
    const FileKind kind = FileKindOf(file);
    return kind == FileKind::Scene ||
           (kind == FileKind::UnityAsset &&
            LoadUnityAsset(file).FindWithField("m_RendererFeatures").has_value());
}

} // namespace

int RunSet(const SetOptions& options, Console& console)
{
    AssetContext assets;
    for (const std::string& plugin : options.plugins)
    {
        assets.LoadPlugin(plugin);
    }
    std::vector<ValueAssignment> edits;
    for (const std::string& text : options.edits)
    {
        edits.push_back(ValueAssignment::Parse(text, text));
    }
    RequireKind(options.file, {FileKind::Scene, FileKind::Profile}, "set");
    const std::vector<ScalarChange> changes =
        HasFeatures(options.file) ? SetFeatureSettings(options.file, edits, assets)
                                  : SetScalars(options.file, edits, assets.volumeComponents());
    for (const ScalarChange& change : changes)
    {
        console.Result(change.subject + ": " + change.before +
                       (change.before == change.after ? ", as it was" : " → " + change.after));
    }
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn
