#pragma once

#include "scene/SceneView.h"
#include "view/RenderOptions.h"
#include <limn/base/FileWatcher.h>

#include <chrono>
#include <limn/vulkan/VulkanDevice.h>
#include <optional>

namespace limn
{

/// Draws a scene into a PNG and keeps everything for the next time. After a change, only what
/// depends on the changed files is made again; after a change of a plug-in, everything but the
/// device. If something is wrong with a file, that is printed and the last good picture and the
/// last good plug-in stay. If a shader of objects does not compile, those objects are drawn in
/// magenta.
class Redrawer
{
public:
    /// Makes the device; draws nothing yet.
    /// @param options, console  must outlive this
    /// @throws VulkanError
    Redrawer(const RenderOptions& options, Console& console);

    /// Reads what changed again, and draws if any of it is usable. The first call loads the scene.
    /// A device that is lost is replaced, and everything is read and drawn again on the new one.
    /// @throws VulkanError for any other failure of the driver, and if devices are lost again and
    ///     again
    void Redraw(const std::set<std::filesystem::path>& changes);

    /// Returns the watcher, which watches every file that the scene reached so far.
    FileWatcher& watcher() { return m_Watcher; }
    const AssetContext& assets() const { return *m_Drawing->assets; }
    const VulkanDevice& device() const { return m_Drawing->device; }

private:
    using Clock = std::chrono::steady_clock;

    /// A device and all that depends on it or on its capabilities.
    struct Drawing
    {
        Drawing(const RenderOptions& options, const ShaderCompilerOptions& compilerOptions);

        /// Returns assets for the device's capabilities.
        std::unique_ptr<AssetContext> MakeAssets() const;

        const ShaderCompilerOptions& anyDevicesOptions; ///< the compiler's options for any device
        VulkanDevice device;
        std::unique_ptr<AssetContext> assets;
        /// The assets with newer plug-ins, for the next view. Null while there are no newer
        /// plug-ins.
        std::unique_ptr<AssetContext> nextAssets;
        UniversalRenderPipeline pipeline;
        /// The last view that could be loaded; null before the first.
        std::unique_ptr<SceneView> view;
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
    std::optional<Drawing> m_Drawing; ///< always set, unless no device could be made
    FileWatcher m_Watcher;
    std::set<std::string> m_LoadNotes;
    std::set<std::string> m_RenderNotes; ///< the notes of the last frame
};

} // namespace limn
