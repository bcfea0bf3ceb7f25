#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "view/ChangeBatch.h"
#include "view/Redrawer.h"
#include <limn/base/FileWatcher.h>

namespace limn
{

namespace
{

/// Waits until a file changed and it is time to draw.
/// @return the changes; nothing once a stop signal came
std::set<std::filesystem::path> WaitForChanges(FileWatcher& watcher, const StopSignals& signals)
{
    ChangeBatch batch;
    for (;;)
    {
        batch.Add(watcher.TakeChanges(), ChangeBatch::Clock::now());
        const auto remaining = batch.Remaining(ChangeBatch::Clock::now());
        if (!watcher.Wait(signals, remaining))
        {
            return {};
        }
        if (remaining && remaining->count() == 0)
        {
            return batch.Take();
        }
    }
}

void RequireStart(const RenderOptions& options)
{
    std::error_code ignored;
    if (!std::filesystem::exists(options.scene, ignored))
    {
        throw AssetError(options.scene, {}, "there is no such file");
    }
    const std::filesystem::path folder =
        std::filesystem::absolute(options.output, ignored).parent_path();
    if (!std::filesystem::is_directory(folder, ignored))
    {
        throw AssetError(options.output, {},
                         "the file cannot be written: No such file or directory");
    }
}

} // namespace

ExitCode RunWatch(const RenderOptions& options, Console& console)
{
    RequireStart(options);
    RequireKind(options.scene, {FileKind::Scene, FileKind::UnityScene}, "watch");
    const StopSignals signals;
    Redrawer redrawer(options, console);
    redrawer.Redraw({});
    while (console.out()) // else nobody sees what is drawn, which RunLimn says
    {
        const auto changes = WaitForChanges(redrawer.watcher(), signals);
        if (changes.empty())
        {
            break;
        }
        redrawer.Redraw(changes);
    }
    return ExitCode::Done;
}

} // namespace limn
