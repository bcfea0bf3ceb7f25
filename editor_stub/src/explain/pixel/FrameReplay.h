#pragma once

#include <limn/core/CompiledFrame.h>
#include <limn/core/GraphicsDevice.h>
#include <span>

namespace limn
{

/// Runs a part of a recorded frame again, with changes. Each replay begins with the states of a
/// first frame, so that nothing remains from another one.
class FrameReplay
{
public:
    /// @param recorded  must be compiled with FrameCompilerOptions::leavesOut off
    explicit FrameReplay(const CompiledFrame& recorded);

    const FrameTables& tables() const { return m_Commands; }

    void AddPass(const CompiledRenderPass& pass); ///< the whole pass, as recorded
    /// Binds the targets of a pass, with the contents that they have when it begins.
    /// @param clearsUndefined  clears targets without contents to 0 and far
    void BindTargets(const CompiledRenderPass& pass, bool clearsUndefined = false);
    void Add(FrameCommand command) { m_Commands.commands.push_back(std::move(command)); }
    /// Adds a draw with another setup than its own.
    void AddDraw(DrawCommand draw, DrawSetup setup);

    /// Runs the added commands and returns the contents that they leave in these textures.
    std::vector<Image> Run(GraphicsDevice& device,
                           std::span<const std::shared_ptr<const RenderTexture>> outputs);
    /// Compiles the added commands, leaving out those that these textures do not need.
    CompiledFrame Compile(std::span<const std::shared_ptr<const RenderTexture>> outputs);

private:
    FrameCommands m_Commands;
};

} // namespace limn
