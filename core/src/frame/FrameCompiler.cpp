#include "frame/FrameNode.h"

#include <algorithm>
#include <limn/core/FrameCompiler.h>

namespace limn
{

namespace
{

void WriteLeftOut(const FrameNodes& nodes, std::vector<LeftOut>& leftOut)
{
    leftOut.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        leftOut[i].pass = nodes[i].name;
        leftOut[i].reason = nodes[i].whyLeftOut;
        leftOut[i].place = nodes[i].place;
        std::size_t count = 0;
        ForEachTarget(nodes[i],
                      [&](const auto& target)
                      {
                          leftOut[i].targets.resize(std::max(leftOut[i].targets.size(), count + 1));
                          leftOut[i].targets[count++] = target->name();
                      });
        leftOut[i].targets.resize(count);
    }
}

/// Forgets what no texture or buffer is left of.
void TakeStates(const TextureStates& from, const FrameCompilerOptions& options, TextureStates& to)
{
    to = from;
    std::erase_if(to.textures, [](const auto& entry) { return entry.second.texture.expired(); });
    std::erase_if(to.buffers, [](const auto& entry) { return entry.second.buffer.expired(); });
    to.held = options.held;
    to.isLast = options.isLast && options.leavesOut;
}

} // namespace

void CompileInto(CompiledFrame& frame, const FrameCommands& commands, const TextureStates& states,
                 OutputSpan outputs, const FrameCompilerOptions& options,
                 std::pmr::memory_resource& memory)
{
    frame.placed.clear();
    frame.finalBarriers.clear();
    frame.notes.clear();
    TakeStates(states, options, frame.states);
    FrameNodes nodes(&memory);
    FrameNodes leftOut(&memory);
    SplitIntoNodes(commands.commands, frame, nodes);
    NoteMissingAlpha(nodes, frame);
    if (options.leavesOut)
    {
        FindAccess(nodes, frame);
        for (const auto step : {ElideConstantDraws, EliminateCopies, ReadOriginals, CullPasses})
        {
            step(nodes, outputs, frame);
            EraseLeftOut(nodes, leftOut);
        }
        if (options.limitsRegions)
        {
            ScissorFullScreenPasses(nodes, frame);
        }
        MergeNodes(nodes, frame);
        std::for_each(nodes.begin(), nodes.end(), EraseEmptySamples);
    }
    for (FrameNode& node : nodes)
    {
        CollectReads(node, frame);
    }
    StripUnusedStencil(nodes, outputs, frame);
    ResolveSamples(nodes, outputs, frame);
    AliasTransientMemory(nodes, outputs, options.footprint, frame);
    AssignLoadStoreBarriers(nodes, outputs, frame);
    ForgetContents(frame.states);
    WriteLeftOut(leftOut, frame.leftOut);
}

CompiledFrame CompileFrame(FrameCommands commands, const TextureStates& states, OutputSpan outputs,
                           const FrameCompilerOptions& options)
{
    CompiledFrame frame;
    static_cast<FrameTables&>(frame) = std::move(static_cast<FrameTables&>(commands));
    frame.uniformData = std::move(commands.uniformData);
    std::pmr::monotonic_buffer_resource memory;
    CompileInto(frame, commands, states, outputs, options, memory);
    return frame;
}

} // namespace limn
