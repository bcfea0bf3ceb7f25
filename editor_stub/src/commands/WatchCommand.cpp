#include "commands/WatchCommand.h"

#include "assets/FileKind.h"
#include "console/StopSignals.h"
#include "view/Redrawer.h"

#include <limn/editor_stub/RunLimn.h>
#include <poll.h>

namespace limn
{

namespace
{

/// A save can be several events; it is over when there was none for so long.
constexpr int k_QuietMilliseconds = 30;

/// Waits until a file changed and its folder is quiet again.
/// @return the changes; nothing once a stop signal came
std::set<std::filesystem::path> WaitForChanges(FileWatcher& watcher, const StopSignals& signals)
{
    std::set<std::filesystem::path> changes = watcher.TakeChanges();
    for (;;)
    {
        pollfd waits[] = {{signals.descriptor(), POLLIN, 0}, {watcher.descriptor(), POLLIN, 0}};
        const int ready = poll(waits, 2, changes.empty() ? -1 : k_QuietMilliseconds);
        if (waits[0].revents != 0)
        {
            return {};
        }
        const std::set<std::filesystem::path> more = watcher.TakeChanges();
        changes.insert(more.begin(), more.end());
        if (!changes.empty() && (ready == 0 || more.empty()))
        {
            return changes;
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
        throw AssetError(options.output, {}, "cannot be written: No such file or directory");
    }
}

} // namespace

int RunWatch(const RenderOptions& options, Console& console)
{
    RequireStart(options);
    RequireKind(options.scene, {FileKind::Scene}, "watch");
    const StopSignals signals;
    Redrawer redrawer(options, console);
    redrawer.Redraw({});
    for (;;)
    {
        const auto changes = WaitForChanges(redrawer.watcher(), signals);
        if (changes.empty())
        {
            return static_cast<int>(ExitCode::Done);
        }
        redrawer.Redraw(changes);
    }
}

} // namespace limn
