#pragma once

#include <limn/core/CompiledFrame.h>
#include <limn/core/GraphicsDevice.h>
#include <map>
#include <span>

namespace limn
{

/// Runs a part of a recorded frame anew, with changes. Each has the states that a first frame
/// begins with, so that no other leaves anything to it.
class FrameReplay
{
public:
    /// @param recorded  compiled with FrameCompilerOptions::leavesOut off
    explicit FrameReplay(const CompiledFrame& recorded);

    const FrameTables& tables() const { return m_Commands; }

    void AddPass(const CompiledRenderPass& pass); ///< all of it, as recorded
    /// The targets of a pass are bound and hold what they do when it begins.
    /// @param clearsUndefined  what holds nothing yet is made 0 and far
    void BindTargets(const CompiledRenderPass& pass, bool clearsUndefined = false);
    void Add(FrameCommand command) { m_Commands.commands.push_back(std::move(command)); }
    /// Adds a draw with another setup than its own.
    void AddDraw(DrawCommand draw, DrawSetup setup);

    /// Runs what was added and returns what it leaves in these textures.
    std::vector<Image> Run(GraphicsDevice& device,
                           std::span<const std::shared_ptr<const RenderTexture>> outputs);
    /// Compiles what was added, with what those textures do without left out.
    CompiledFrame Compile(std::span<const std::shared_ptr<const RenderTexture>> outputs);

private:
    FrameCommands m_Commands;
};

} // namespace limn
