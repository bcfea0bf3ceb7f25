#include "WatchCommand.h"

#include "FileWatcher.h"
#include "SceneView.h"
#include "StopSignals.h"
#include "UsedShaders.h"

#include <chrono>
#include <cmath>
#include <limn/editor_stub/RunLimn.h>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>
#include <poll.h>

namespace limn
{

namespace
{

/// A save can be several events; it is over when there was none for so long.
constexpr int k_QuietMilliseconds = 30;

using Clock = std::chrono::steady_clock;

class Redrawer
{
public:
    Redrawer(const RenderOptions& options, Console& console)
        : m_Options(options),
          m_Console(console),
          m_CompilerOptions(ChooseCompilerOptions(options, console)),
          m_Assets(m_CompilerOptions),
          m_Device({options.device, options.validate, m_CompilerOptions.cacheFolder}),
          m_Pipeline(m_Device)
    {
        m_Console.Line(m_Device.ChoiceSentence());
        m_Watcher.Watch({options.scene});
    }

    /// Reads what changed again and draws, if any of it is usable; what is wrong is printed. The
    /// first call loads the scene.
    void Redraw(const std::set<std::filesystem::path>& changes)
    {
        const Clock::time_point start = Clock::now();
        bool isSceneStale = !m_View;
        bool isProfileNew = false;
        for (const std::filesystem::path& path : changes)
        {
            Guard([&] { (ReadAgain(path) ? isProfileNew : isSceneStale) = true; });
        }
        const bool isSceneNew = isSceneStale && Guard([&] { LoadScene(); });
        if (m_View && (isSceneNew || isProfileNew))
        {
            Guard([&] { Draw(start); });
        }
        m_Watcher.Watch(m_Assets.reachedFiles());
    }

    FileWatcher& watcher() { return m_Watcher; }

private:
    /// Whether the work was done; an error is printed. The driver's failures go on.
    template <typename Work>
    bool Guard(Work&& work)
    {
        try
        {
            work();
            return true;
        }
        catch (const AssetError& error)
        {
            m_Console.Print(error.diagnostics());
        }
        catch (const ContractError& error)
        {
            m_Console.Error(error.what());
        }
        return false;
    }

    /// A profile is read into the picture that there is. After any other change the scene has to be
    /// loaded again, which reads only what the assets do not have.
    /// @return whether it was a profile
    bool ReadAgain(const std::filesystem::path& path)
    {
        const VolumeProfileLoadResult* profile = m_Assets.ReloadProfile(path);
        if (profile)
        {
            PrintNew(profile->notes);
            return true;
        }
        m_Assets.Forget(path);
        return false;
    }

    void LoadScene()
    {
        SceneAsset asset = LoadForRendering(m_Options, m_Assets);
        m_Watcher.Watch(m_Assets.reachedFiles());
        CompileUsedShaders(asset);
        PrintNew(asset.notes);
        m_View = std::make_unique<SceneView>(std::move(asset), m_Assets);
    }

    void Draw(Clock::time_point start)
    {
        const RenderResult result = m_View->Render(m_Pipeline, static_cast<float>(m_Options.time));
        Image image = m_Device.ReadBack(*result.output.rt());
        MakeOpaque(image);
        PrintNew(result.report);
        WritePng(m_Options.output, image);
        const std::chrono::duration<double, std::milli> duration = Clock::now() - start;
        m_Console.out() << m_Options.output << ' ' << image.width << 'x' << image.height << ' '
                        << std::lround(duration.count()) << " ms" << std::endl;
    }

    // What was said before is not said at every save.

    void PrintNew(const RenderReport& report)
    {
        const std::set<std::string> notes(report.notes.begin(), report.notes.end());
        for (const std::string& note : notes)
        {
            if (m_RenderNotes.count(note) == 0)
            {
                m_Console.Note(note);
            }
        }
        m_RenderNotes = notes;
    }

    void PrintNew(const std::vector<Diagnostic>& notes)
    {
        for (const Diagnostic& note : notes)
        {
            if (m_LoadNotes.insert(ToString(note)).second)
            {
                m_Console.Print(note);
            }
        }
    }

    const RenderOptions& m_Options;
    Console& m_Console;
    const ShaderCompilerOptions m_CompilerOptions;
    AssetContext m_Assets;
    VulkanDevice m_Device;
    UniversalRenderPipeline m_Pipeline;
    FileWatcher m_Watcher;
    std::unique_ptr<SceneView> m_View; ///< the last that could be loaded; null before the first
    std::set<std::string> m_LoadNotes;
    std::set<std::string> m_RenderNotes; ///< of the last frame
};

/// Waits until a file changed and its folder is quiet again.
/// @return the changes; nothing once a stop signal came
std::set<std::filesystem::path> WaitForChanges(FileWatcher& watcher, const StopSignals& signals)
{
    std::set<std::filesystem::path> changes;
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
