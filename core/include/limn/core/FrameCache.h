#pragma once

#include <limn/core/FrameCompiler.h>
#include <memory>

namespace limn
{

/// Compiles one frame after the other for one device. A frame that records what the one before did
/// is not worked out again: it only gets new uniform and per-draw data.
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
    // What it was compiled from, without uniform and per-draw data.
    FrameCommands m_Commands;
    TextureStates m_States;
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs;
    FrameCompilerOptions m_Options;
};

} // namespace limn
