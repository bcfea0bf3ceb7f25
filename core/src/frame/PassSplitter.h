#pragma once

#include <limn/core/CompiledFrame.h>

namespace limn
{

/// A pass before load, store and barriers are decided.
struct OpenPass
{
    std::string name;
    SetRenderTargetCommand targets;
    std::optional<ClearCommand> clear; ///< everything cleared before the first draw, together
    std::vector<PassCommand> commands;
    std::vector<std::shared_ptr<const Texture>> reads; ///< render textures sampled; no duplicates
};

/// Splits a frame's commands into passes. Targets and viewports take effect when something is drawn
/// or cleared, so binding alone makes no pass and ends none. Samples left open end with the frame.
/// @throws ContractError as FrameCompiler::Compile
std::vector<OpenPass> SplitIntoPasses(std::vector<FrameCommand> commands);

} // namespace limn
