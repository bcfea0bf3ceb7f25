#pragma once

#include "view/SceneView.h"
#include <limn/base/FileWatcher.h>

#include <chrono>
#include <limn/vulkan/VulkanDevice.h>
#include <optional>

namespace limn
{

/// Draws a scene into a PNG and keeps all that it took, so that after a change only what hangs on
/// the changed files is made again; after a plug-in's, everything but the device. What is wrong
/// with a file is printed; the last good picture and the last good plug-in stay, or, if a shader of
/// objects does not compile, those objects are drawn in magenta.
class Redrawer
{
public:
    /// Draws nothing yet.
    /// @param options, console  must outlive this
    /// @throws VulkanError
    Redrawer(const RenderOptions& options, Console& console);

    /// Reads what changed again and draws, if any of it is usable. The first call loads the scene.
    /// A device that is lost is replaced, and all is read and drawn again on the new one.
    /// @throws VulkanError for any other failure of the driver, and if no device stays
    void Redraw(const std::set<std::filesystem::path>& changes);

    /// Watches every file that the scene reached so far.
    FileWatcher& watcher() { return m_Watcher; }
    const AssetContext& assets() const { return *m_Drawing->assets; }
    const VulkanDevice& device() const { return m_Drawing->device; }

private:
    using Clock = std::chrono::steady_clock;

    /// A device and all that hangs on it or on what it can do.
    struct Drawing
    {
        Drawing(const RenderOptions& options, const ShaderCompilerOptions& compilerOptions);

        /// Assets for what the device can do.
        std::unique_ptr<AssetContext> MakeAssets() const;

        const ShaderCompilerOptions& anyDevicesOptions; ///< of the compiler, for any device
        VulkanDevice device;
        std::unique_ptr<AssetContext> assets;
        /// With newer plug-ins, for the next view; null while there are none.
        std::unique_ptr<AssetContext> nextAssets;
        UniversalRenderPipeline pipeline;
        std::unique_ptr<SceneView> view; ///< the last that could be loaded; null before the first
    };

    void RedrawOnce(const std::set<std::filesystem::path>& changes);
    template <typename Work>
    bool Guard(Work&& work);
    bool NoteEmbedded(const std::filesystem::path& path);
    bool ReadAgain(const std::filesystem::path& path);
    void LoadScene();
    void Draw(Clock::time_point start);
    void PrintNew(const RenderReport& report);
    void PrintNew(const std::vector<Diagnostic>& notes);

    const RenderOptions& m_Options;
    Console& m_Console;
    const ShaderCompilerOptions m_CompilerOptions;
    std::optional<Drawing> m_Drawing; ///< always, but where no device could be made
    FileWatcher m_Watcher;
    std::set<std::string> m_LoadNotes;
    std::set<std::string> m_RenderNotes; ///< of the last frame
};

} // namespace limn
