#pragma once

#include <limn/core/FrameCompiler.h>
#include <memory>
#include <memory_resource>

namespace limn
{

/// Compiles one frame after the other for one device. A frame that records what the one before did
/// is not worked out again: it only gets new uniform and per-draw data. Another one is worked out
/// in the memory of the frame before.
///
/// The regions that draws are seen in change whenever the camera or an object moves. Where nothing
/// else changes, the frame is compiled for regions that are a little wider, by 1/32 of the target
/// at each side, and kept while the draws stay within them; where they rest for 16 frames, it is
/// compiled for their regions once more. Pictures do not depend on it.
class FrameCache
{
public:
    /// As CompileFrame; takes what it needs out of `commands`, whose lists keep their memory where
    /// they can.
    /// @param options  its `footprint` is the same function in every call
    /// @return never null. It stays as it is for as long as somebody else holds it
    std::shared_ptr<const CompiledFrame>
    Compile(FrameCommands& commands, const TextureStates& states,
            std::span<const std::shared_ptr<const RenderTexture>> outputs,
            const FrameCompilerOptions& options);

    /// The next frame is worked out anew.
    void Clear() { m_Frame = nullptr; }

private:
    bool IsSame(const FrameCommands& commands, const TextureStates& states,
                std::span<const std::shared_ptr<const RenderTexture>> outputs,
                const FrameCompilerOptions& options) const;
    /// Returns whether the draws are seen where they were in enough frames before.
    bool HasComeToRest(std::span<FrameCommand> commands);

    std::shared_ptr<CompiledFrame> m_Frame;
    /// Compiling uses it for a time. The first frame makes it, so that caches can be moved.
    std::unique_ptr<std::pmr::unsynchronized_pool_resource> m_Memory;
    bool m_IsWidened = false;                ///< `m_Frame` is compiled for wider regions
    int m_FramesAtRest = 0;                  ///< since then
    std::vector<TargetRegion> m_LastRegions; ///< of the last frame since then
    // What it was compiled from, without uniform and per-draw data.
    FrameCommands m_Commands;
    TextureStates m_States;
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs;
    FrameCompilerOptions m_Options;
};

} // namespace limn
