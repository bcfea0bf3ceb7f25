#include "commands/SetCommand.h"

#include "assets/FileKind.h"
#include "plugins/LoadPlugin.h"

#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Features.h>
#include <limn/volume/ProfileEdit.h>

namespace limn
{

int RunSet(const SetOptions& options, Console& console)
{
    FeatureRegistry features;
    VolumeComponentRegistry registry;
    RegisterFeatures(features, registry);
    for (const std::string& plugin : options.plugins)
    {
        LoadPlugin(plugin, features, registry);
    }
    std::vector<ScalarEdit> edits;
    for (const std::string& text : options.edits)
    {
        edits.push_back(ScalarEdit::Parse(text));
    }
    RequireKind(options.file, {FileKind::Profile}, "set");
    for (const ScalarChange& change : SetScalars(options.file, edits, registry))
    {
        console.Result(change.subject + ": " + change.before +
                       (change.before == change.after ? ", as it was" : " → " + change.after));
    }
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn
