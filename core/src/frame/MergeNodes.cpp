#include "frame/FrameNode.h"

#include <algorithm>
#include <optional>

namespace limn
{

namespace
{

bool SharesTarget(const FrameNode& a, const FrameNode& b)
{
    return AnyTarget(a, [&](const auto& target) { return HasTarget(b, *target); });
}

bool ReadsTargetOf(const FrameNode& reader, const FrameNode& node)
{
    return AnyTarget(node, [&](const auto& target) { return Reads(reader, *target); });
}

/// Returns whether one writes a buffer that the other uses.
bool DisputesBuffer(const FrameNode& a, const FrameNode& b)
{
    return std::ranges::any_of(
        a.buffers,
        [&](const BufferUse& use)
        {
            const auto other = std::ranges::find(b.buffers, use.buffer, &BufferUse::buffer);
            return other != b.buffers.end() && (use.isWritten || other->isWritten);
        });
}

bool MayChangePlaces(const FrameNode& a, const FrameNode& b)
{
    return !SharesTarget(a, b) && !ReadsTargetOf(a, b) && !ReadsTargetOf(b, a) &&
           !DisputesBuffer(a, b);
}

const RenderTexture& AnyTarget(const FrameNode& node)
{
    return node.targets.colors.empty() ? *node.targets.depth : *node.targets.colors.front();
}

/// Returns whether the node's commands mean the same beside further colours, which they leave
/// alone.
bool CanHaveMoreColors(const FrameNode& node, const FrameTables& tables)
{
    return std::none_of(node.commands.begin(), node.commands.end(),
                        [&](const PassCommand& command)
                        {
                            const auto* clear = std::get_if<ClearCommand>(&command);
                            const auto* draw = std::get_if<DrawCommand>(&command);
                            const RenderTargetBlendState* blend =
                                draw ? &tables.Setup(*draw).state.targets[0] : nullptr;
                            // An operation beyond blending is one for all colours, and not every
                            // format has it.
                            return (clear && (clear->flags & ClearFlag::Color)) ||
                                   (blend && std::max(blend->colorBlendOperation,
                                                      blend->alphaBlendOperation) > BlendOp::Max);
                        });
}

/// Returns whether the colours of one are the first colours of the other, so that the other's
/// further colours can be added.
bool ColorsFit(const FrameNode& node, const FrameNode& next, const FrameTables& tables)
{
    const auto& colors = node.targets.colors;
    const auto& nextColors = next.targets.colors;
    const std::size_t common = std::min(colors.size(), nextColors.size());
    if (!std::equal(colors.begin(), colors.begin() + static_cast<std::ptrdiff_t>(common),
                    nextColors.begin()))
    {
        return false;
    }
    const bool clearsCommon =
        common > 0 &&
        (Clears(next, ClearFlag::Color) || next.coversColor ||
         std::any_of(nextColors.begin(), nextColors.begin() + static_cast<std::ptrdiff_t>(common),
                     [&](const auto& c) { return ClearColorOf(next, *c); }));
    const bool coversSome = node.coversColor && nextColors.size() > colors.size();
    return !clearsCommon && !coversSome &&
           (colors.size() >= nextColors.size() || CanHaveMoreColors(node, tables)) &&
           (colors.size() <= nextColors.size() || CanHaveMoreColors(next, tables));
}

bool DepthFits(const FrameNode& node, const FrameNode& next)
{
    const bool clears = next.clear && (next.clear->flags & ClearFlag::DepthStencil);
    return !node.targets.depth || !next.targets.depth ||
           (node.targets.depth == next.targets.depth && !clears);
}

/// Returns whether `next` can continue the pass of `node`.
bool CanContinue(const FrameNode& node, const FrameNode& next, const FrameTables& tables)
{
    if (node.targets.generatesMips != next.targets.generatesMips)
    {
        return false; // they are made at the end of all that is in a node
    }
    if (node.isCompute || next.isCompute)
    {
        return node.isCompute && next.isCompute && MayChangePlaces(node, next);
    }
    return AnyTarget(node).HasSizeOf(AnyTarget(next)) && ColorsFit(node, next, tables) &&
           DepthFits(node, next) && !ReadsTargetOf(next, node) && !ReadsTargetOf(node, next);
}

/// Makes the node's draws ignore the depth, as they did while no depth was attached.
void IgnoreDepth(FrameNode& node, FrameTables& tables)
{
    ChangeSetups(node, tables,
                 [](DrawSetup& setup)
                 {
                     setup.state.zTest = CompareFunction::Disabled;
                     setup.state.stencilEnabled = false;
                 });
}

/// Makes the node's draws ignore further colours, as they did while only the first ones were
/// attached.
void IgnoreColors(FrameNode& node, FrameTables& tables, std::size_t first)
{
    ChangeSetups(node, tables,
                 [&](DrawSetup& setup)
                 {
                     auto& targets = setup.state.targets;
                     for (std::size_t i = first; i < targets.size(); ++i)
                     {
                         targets[i].writeMask = 0;
                     }
                 });
}

void JoinColors(FrameNode& node, FrameNode& next, FrameTables& tables)
{
    const std::size_t count = node.targets.colors.size();
    const std::size_t nextCount = next.targets.colors.size();
    if (nextCount <= count)
    {
        if (nextCount < count)
        {
            IgnoreColors(next, tables, nextCount);
        }
        return;
    }
    IgnoreColors(node, tables, count);
    FixedList<std::optional<Color>, k_MostColors> cleared;
    for (std::size_t i = 0; i < nextCount; ++i)
    {
        cleared.push_back(ClearColorOf(i < count ? node : next, *next.targets.colors[i]));
    }
    if (node.clear)
    {
        node.clear->flags = Without(node.clear->flags, ClearFlag::Color);
    }
    node.clearedColors = std::move(cleared);
    node.targets.colors = next.targets.colors;
    node.coversColor = next.coversColor;
}

void JoinDepth(FrameNode& node, FrameNode& next, FrameTables& tables)
{
    if (node.targets.depth == next.targets.depth)
    {
        return;
    }
    IgnoreDepth(node.targets.depth ? next : node, tables);
    if (next.targets.depth)
    {
        node.targets.depth = next.targets.depth;
        if (next.clear)
        {
            ClearCommand clear = *next.clear;
            clear.flags = Only(clear.flags, ClearFlag::DepthStencil);
            AddClear(node, clear);
        }
    }
}

void Continue(FrameNode& node, FrameNode& next, FrameTables& tables)
{
    JoinColors(node, next, tables);
    JoinDepth(node, next, tables);
    node.resolves.insert(node.resolves.end(), next.resolves.begin(), next.resolves.end());
    if (Has<SetViewportCommand>(node))
    {
        const RenderTexture& target = AnyTarget(node);
        node.commands.emplace_back(SetViewportCommand{{0, 0, target.width(), target.height()}});
    }
    node.commands.insert(node.commands.end(), next.commands.begin(), next.commands.end());
    CollectReads(node, tables);
}

/// The node that `next` can go on with, and the ones behind it that have to run before both.
struct Begun
{
    std::size_t node = 0;
    std::pmr::vector<std::size_t> before; ///< last one first
};

std::optional<Begun> FindBegun(const FrameNodes& nodes, const FrameNode& next,
                               const FrameTables& tables)
{
    Begun begun{0, std::pmr::vector<std::size_t>(nodes.get_allocator())};
    for (begun.node = nodes.size(); begun.node-- > 0;)
    {
        const FrameNode& node = nodes[begun.node];
        const bool canWait = std::ranges::all_of(begun.before, [&](std::size_t i)
                                                 { return MayChangePlaces(node, nodes[i]); });
        const bool isNeighbour = begun.node + 1 == nodes.size();
        const bool sharesTarget = SharesTarget(node, next);
        if (canWait && (isNeighbour || sharesTarget) && CanContinue(node, next, tables))
        {
            return begun;
        }
        if (sharesTarget)
        {
            return std::nullopt; // whatever draws into it before that has to stay before
        }
        if (!canWait || !MayChangePlaces(node, next))
        {
            begun.before.push_back(begun.node);
        }
    }
    return std::nullopt;
}

/// Moves the node behind all that has to run before.
/// @return where it is then
std::size_t Delay(FrameNodes& nodes, const Begun& begun)
{
    std::size_t at = begun.node;
    for (auto i = begun.before.rbegin(); i != begun.before.rend(); ++i)
    {
        const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(at++);
        const auto moved = nodes.begin() + static_cast<std::ptrdiff_t>(*i);
        std::rotate(first, moved, moved + 1);
    }
    return at;
}

} // namespace

void MergeNodes(FrameNodes& nodes, FrameTables& tables)
{
    FrameNodes merged(nodes.get_allocator());
    merged.reserve(nodes.size());
    for (FrameNode& node : nodes)
    {
        if (const auto begun = FindBegun(merged, node, tables))
        {
            Continue(merged[Delay(merged, *begun)], node, tables);
        }
        else
        {
            merged.push_back(std::move(node));
        }
    }
    nodes = std::move(merged);
}

} // namespace limn
