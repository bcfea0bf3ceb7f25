#include "commands/SetCommand.h"

#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Features.h>
#include <limn/volume/ProfileEdit.h>

namespace limn
{

int RunSet(const SetOptions& options)
{
    VolumeComponentRegistry registry;
    RegisterVolumeComponents(registry);
    std::vector<ScalarEdit> edits;
    for (const std::string& text : options.edits)
    {
        edits.push_back(ScalarEdit::Parse(text));
    }
    SetScalars(options.file, edits, registry);
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn
