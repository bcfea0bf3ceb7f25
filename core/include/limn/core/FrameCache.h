#pragma once

#include <limn/core/FrameCompiler.h>
#include <memory>
#include <memory_resource>

namespace limn
{

/// Compiles one frame after the other for one device. A frame that records what the one before did
/// is not worked out again: it only gets new uniform and per-draw data. Another one is worked out
/// in the memory of the frame before.
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

    std::shared_ptr<CompiledFrame> m_Frame;
    /// Compiling uses it for a time. The first frame makes it, so that caches can be moved.
    std::unique_ptr<std::pmr::unsynchronized_pool_resource> m_Memory;
    // What it was compiled from, without uniform and per-draw data.
    FrameCommands m_Commands;
    TextureStates m_States;
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs;
    FrameCompilerOptions m_Options;
};

} // namespace limn
