#include "view/Redrawer.h"

#include "assets/OutputFiles.h"
#include "plugins/LoadPlugin.h"
#include "shaders/UsedShaders.h"

#include <cmath>
#include <limn/core/DrawError.h>
#include <limn/vulkan/VulkanError.h>

namespace limn
{

namespace
{

constexpr int k_MaxLost = 3; ///< devices in a row

} // namespace

Redrawer::Drawing::Drawing(const RenderOptions& options,
                           const ShaderCompilerOptions& compilerOptions)
    : anyDevicesOptions(compilerOptions),
      device({options.device, options.validate, compilerOptions.cacheFolder}),
      assets(MakeAssets()),
      pipeline(device)
{
}

std::unique_ptr<AssetContext> Redrawer::Drawing::MakeAssets() const
{
    ShaderCompilerOptions options = anyDevicesOptions;
    options.missingFeatures = device.missingShaderFeatures();
    return std::make_unique<AssetContext>(std::move(options), PluginLoading::Copy);
}

Redrawer::Redrawer(const RenderOptions& options, Console& console)
    : m_Options(options),
      m_Console(console),
      m_CompilerOptions(ChooseCompilerOptions(options, console))
{
    m_Drawing.emplace(options, m_CompilerOptions);
    m_Console.Verbose(device().ChoiceSentence());
    m_Watcher.Watch({options.scene});
}

void Redrawer::Redraw(const std::set<std::filesystem::path>& changes)
{
    for (int lost = 0;; ++lost)
    {
        try
        {
            RedrawOnce(changes);
            return;
        }
        catch (const VulkanError& error)
        {
            if (!error.isDeviceLost() || lost == k_MaxLost)
            {
                throw;
            }
            m_Console.Warning(std::string(error.what()) + "; drawing goes on with a new device");
        }
        m_Drawing.emplace(m_Options, m_CompilerOptions);
    }
}

void Redrawer::RedrawOnce(const std::set<std::filesystem::path>& changes)
{
    const Clock::time_point start = Clock::now();
    const auto readSince = std::chrono::system_clock::now();
    bool isSceneStale = !m_Drawing->view || m_Drawing->nextAssets;
    bool isProfileNew = false;
    for (const std::filesystem::path& path : changes)
    {
        if (!NoteEmbedded(path))
        {
            Guard([&] { (ReadAgain(path) ? isProfileNew : isSceneStale) = true; });
        }
    }
    const bool isSceneNew = isSceneStale && Guard([&] { LoadScene(); });
    if (m_Drawing->view && (isSceneNew || isProfileNew))
    {
        Guard([&] { Draw(start); });
    }
    m_Watcher.Watch(m_Drawing->assets->reachedFiles(), readSince);
    std::set<std::filesystem::path> embedded;
    for (const auto& [file, plugin] : EmbeddedShaderFiles())
    {
        embedded.insert(file);
    }
    m_Watcher.Watch(embedded);
    if (m_Drawing->nextAssets)
    {
        m_Watcher.Watch(m_Drawing->nextAssets->reachedFiles(), readSince);
    }
}

/// Adds a note about a shader that a plug-in contains, because the file itself is not read.
/// @return whether it is one that the scene does not use in another way
bool Redrawer::NoteEmbedded(const std::filesystem::path& path)
{
    const auto embedded = EmbeddedShaderFiles();
    const auto found = embedded.find(path);
    if (found == embedded.end())
    {
        return false;
    }
    m_Console.Note(path.generic_string() + " is compiled into " + found->second +
                   "; the picture shows the change once the plug-in is built again");
    return m_Drawing->assets->reachedFiles().count(path) == 0;
}

/// Returns whether the work was done. It prints an error, but lets failures of the driver pass.
template <typename Work>
bool Redrawer::Guard(Work&& work)
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
    catch (const DrawError& error)
    {
        m_Console.Error(error.what());
    }
    catch (const ContractError& error)
    {
        m_Console.Bug(error.what());
    }
    return false;
}

/// A profile is read into the picture that there is. After any other change the scene has to be
/// loaded again, which reads only what the assets do not have; after a plug-in's into other assets,
/// as these know what it registered before.
/// @return whether it was a profile
bool Redrawer::ReadAgain(const std::filesystem::path& path)
{
    Drawing& drawing = *m_Drawing;
    if (drawing.assets->ReloadPlugin(path) ||
        (drawing.nextAssets && drawing.nextAssets->ReloadPlugin(path)))
    {
        drawing.nextAssets = drawing.MakeAssets();
        return false;
    }
    if (drawing.nextAssets)
    {
        drawing.nextAssets->Forget(path);
    }
    if (const VolumeProfileLoadResult* profile = drawing.assets->ReloadProfile(path))
    {
        PrintNew(profile->notes);
        return true;
    }
    drawing.assets->Forget(path);
    return false;
}

void Redrawer::LoadScene()
{
    Drawing& drawing = *m_Drawing;
    std::unique_ptr<AssetContext>& source =
        drawing.nextAssets ? drawing.nextAssets : drawing.assets;
    SceneAsset asset = LoadForRendering(m_Options, *source);
    m_Console.Print(CompileOrReplaceShaders(asset, source->compiler()));
    PrintNew(asset.notes);
    drawing.view = std::make_unique<SceneView>(std::move(asset), *source);
    if (drawing.nextAssets)
    {
        drawing.assets = std::move(drawing.nextAssets);
    }
}

void Redrawer::Draw(Clock::time_point start)
{
    RequireOwnFiles({&m_Options.output, 1}, m_Drawing->assets->reachedFiles());
    const RenderResult result = m_Drawing->view->Render(m_Drawing->pipeline, m_Options.time);
    Image image = m_Drawing->device.ReadBack(*result.output.rt());
    MakeOpaque(image);
    PrintNew(result.report);
    WritePng(m_Options.output, image);
    const std::chrono::duration<double, std::milli> duration = Clock::now() - start;
    m_Console.Result(m_Options.output + " " + std::to_string(image.width) + "x" +
                     std::to_string(image.height) + " " +
                     std::to_string(std::lround(duration.count())) + " ms");
    m_Console.out().flush();
}

// A note is not printed again at every save.

void Redrawer::PrintNew(const RenderReport& report)
{
    const std::vector<std::string> notes = NotesOf(report);
    for (const std::string& note : notes)
    {
        if (m_RenderNotes.count(note) == 0)
        {
            m_Console.Note(note);
        }
    }
    m_RenderNotes = {notes.begin(), notes.end()};
}

void Redrawer::PrintNew(const std::vector<Diagnostic>& notes)
{
    for (const Diagnostic& note : notes)
    {
        if (m_LoadNotes.insert(ToString(note)).second)
        {
            m_Console.Print(note);
        }
    }
}

} // namespace limn
