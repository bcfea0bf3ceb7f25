#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns whether the draw replaces the whole colour.
bool Covers(const FrameNode& node, const DrawSetup& draw)
{
    return draw.fullScreen && node.targets.colors.size() == 1 && !Has<SetViewportCommand>(node) &&
           !(node.targets.depth && UsesDepth(draw.state)) && !draw.state.alphaToMask &&
           ReplacesTarget(draw.state.targets.at(0));
}

/// Drops the commands before a draw that covers the colour, unless depth or stencil need them.
void DropWhatIsCovered(FrameNode& node, const FrameTables& tables, std::size_t& covering)
{
    auto end = node.commands.begin(); // of those that are kept
    for (std::size_t i = 0; i < covering; ++i)
    {
        PassCommand& command = node.commands[i];
        const auto* draw = std::get_if<DrawCommand>(&command);
        auto* clear = std::get_if<ClearCommand>(&command);
        if (clear)
        {
            clear->flags = Without(clear->flags, ClearFlag::Color);
        }
        const bool isOfUse = draw    ? node.targets.depth && UsesDepth(tables.Setup(*draw).state)
                             : clear ? clear->flags != ClearFlag::None
                                     : true;
        if (isOfUse)
        {
            *end++ = command;
        }
    }
    const auto first = node.commands.begin();
    node.commands.erase(end, first + static_cast<std::ptrdiff_t>(covering));
    covering = static_cast<std::size_t>(end - first);
    if (node.clear)
    {
        node.clear->flags = Without(node.clear->flags, ClearFlag::Color);
    }
}

} // namespace

bool UsesDepth(const PipelineState& state)
{
    const bool isTested =
        state.zTest != CompareFunction::Disabled && state.zTest != CompareFunction::Always;
    const bool isWritten = state.zTest != CompareFunction::Disabled && state.zWrite;
    return isTested || isWritten || state.stencilEnabled;
}

void FindAccess(FrameNodes& nodes, const FrameTables& tables)
{
    for (FrameNode& node : nodes)
    {
        for (std::size_t i = 0; i < node.commands.size(); ++i)
        {
            const auto* draw = std::get_if<DrawCommand>(&node.commands[i]);
            if (draw && Covers(node, tables.Setup(*draw)))
            {
                DropWhatIsCovered(node, tables, i);
                node.coversColor = true;
            }
        }
        CollectReads(node, tables);
    }
}

} // namespace limn
