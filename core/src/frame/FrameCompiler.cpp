#include "frame/TextureHistory.h"

#include <algorithm>
#include <limn/core/FrameCompiler.h>

namespace limn
{

CompiledFrame CompileFrame(FrameCommands commands, const TextureStates& states, OutputSpan outputs,
                           const FrameCompilerOptions& options)
{
    CompiledFrame frame;
    frame.states = states;
    std::erase_if(frame.states.textures,
                  [](const auto& entry) { return entry.second.texture.expired(); });
    std::erase_if(frame.states.buffers,
                  [](const auto& entry) { return entry.second.buffer.expired(); });
    frame.states.held = options.held;
    frame.states.isLast = options.isLast && options.leavesOut;
    static_cast<FrameTables&>(frame) = std::move(static_cast<FrameTables&>(commands));
    std::vector<FrameNode> nodes = SplitIntoNodes(std::move(commands.commands), frame);
    NoteMissingAlpha(nodes, frame);
    if (options.leavesOut)
    {
        FindAccess(nodes, frame);
        FoldConstants(nodes, outputs, frame);
        ForwardCopies(nodes, outputs, frame);
        ReadOriginals(nodes, outputs, frame);
        LeaveOutUnread(nodes, outputs, frame);
        if (options.limitsRegions)
        {
            LimitRegions(nodes, frame);
        }
        MergeNodes(nodes, frame);
        std::for_each(nodes.begin(), nodes.end(), EraseEmptySamples);
    }
    for (FrameNode& node : nodes)
    {
        CollectReads(node, frame);
    }
    LeaveOutStencil(nodes, outputs, frame);
    ResolveSamples(nodes, outputs, frame);
    PlaceTextures(nodes, outputs, options.footprint, frame);
    MakePasses(std::move(nodes), outputs, frame);
    ForgetContents(frame.states);
    frame.uniformData = std::move(commands.uniformData);
    return frame;
}

} // namespace limn
