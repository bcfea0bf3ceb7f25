#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

bool ReadsTargetOf(const FrameNode& reader, const FrameNode& node)
{
    const auto targets = TargetsOf(node);
    return std::any_of(
        reader.reads.begin(), reader.reads.end(),
        [&](const auto& texture)
        { return std::find(targets.begin(), targets.end(), texture) != targets.end(); });
}

/// Whether `next` can go on where `node` ends.
bool CanContinue(const FrameNode& node, const FrameNode& next)
{
    const auto& depth = node.targets.depth;
    const auto& nextDepth = next.targets.depth;
    return !node.targets.colors.empty() && node.targets.colors == next.targets.colors &&
           (depth == nextDepth || !depth || !nextDepth) && !next.clear && !next.coversColor &&
           !ReadsTargetOf(next, node) && !ReadsTargetOf(node, next);
}

/// As it was where no depth was attached.
void IgnoreDepth(FrameNode& node)
{
    for (PassCommand& command : node.commands)
    {
        if (auto* draw = std::get_if<DrawCommand>(&command))
        {
            draw->state.zTest = CompareFunction::Disabled;
            draw->state.stencilEnabled = false;
        }
    }
}

void Continue(FrameNode& node, FrameNode& next)
{
    if (node.targets.depth != next.targets.depth)
    {
        IgnoreDepth(node.targets.depth ? next : node);
        node.targets.depth = node.targets.depth ? node.targets.depth : next.targets.depth;
    }
    const bool hasViewport =
        std::any_of(node.commands.begin(), node.commands.end(),
                    [](const PassCommand& command)
                    { return std::holds_alternative<SetViewportCommand>(command); });
    if (hasViewport)
    {
        const RenderTexture& target = *node.targets.colors.front();
        node.commands.emplace_back(SetViewportCommand{{0, 0, target.width(), target.height()}});
    }
    node.commands.insert(node.commands.end(), std::make_move_iterator(next.commands.begin()),
                         std::make_move_iterator(next.commands.end()));
    CollectReads(node);
}

} // namespace

void MergeNodes(std::vector<FrameNode>& nodes)
{
    std::vector<FrameNode> merged;
    for (FrameNode& node : nodes)
    {
        if (!merged.empty() && CanContinue(merged.back(), node))
        {
            Continue(merged.back(), node);
        }
        else
        {
            merged.push_back(std::move(node));
        }
    }
    nodes = std::move(merged);
}

} // namespace limn
