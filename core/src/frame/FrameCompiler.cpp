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
    std::vector<FrameNode> nodes = SplitIntoNodes(std::move(commands.commands));
    std::vector<std::uint64_t> overwritten;
    if (options.leavesOut)
    {
        FindAccess(nodes);
        overwritten = LearnHistory(nodes, outputs, frame);
        if (options.isLast)
        {
            KeepNothing(frame.states);
        }
        FoldConstants(nodes, outputs, frame);
        ForwardCopies(nodes, outputs, frame);
        LeaveOutUnread(nodes, outputs, frame);
        if (options.limitsRegions)
        {
            LimitRegions(nodes);
        }
        MergeNodes(nodes);
        std::for_each(nodes.begin(), nodes.end(), EraseEmptySamples);
    }
    std::for_each(nodes.begin(), nodes.end(), CollectReads);
    LeaveOutStencil(nodes, outputs, frame);
    ResolveSamples(nodes, outputs, frame);
    PlaceTextures(nodes, outputs, options.footprint, frame);
    MakePasses(std::move(nodes), outputs, frame);
    ForgetContents(frame.states);
    RememberOverwritten(overwritten, frame.states);
    frame.uniformData = std::move(commands.uniformData);
    static_cast<FrameInstances&>(frame) = std::move(static_cast<FrameInstances&>(commands));
    return frame;
}

} // namespace limn
