#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

using RenderTexturePtr = std::shared_ptr<const RenderTexture>;

/// Returns whether draws into `from` can go to `to`, directly or resolved.
bool SameShape(const RenderTexture& from, const RenderTexture& to)
{
    return from.width() == to.width() && from.height() == to.height() && !HasSamples(to) &&
           from.mipmapCount() == to.mipmapCount() &&
           (!HasSamples(from) || from.graphicsFormat() == to.graphicsFormat());
}

/// Returns whether the node would draw the same in another format, except for rounding, or in the
/// same format with an alpha of 1.
bool DrawsTheSame(const FrameNode& node, const FrameTables& tables, bool isSameFormat)
{
    const auto differs = [&](const DrawSetup& draw)
    {
        const RenderTargetBlendState& blend = draw.state.targets.at(0);
        return !ReplacesColor(blend) && (!isSameFormat || ReadsTargetAlpha(blend));
    };
    return node.targets.colors.size() == 1 && !AnyDraw(node, tables, differs);
}

/// Returns whether the contents of `from` are used by the copy alone, which is node `copy`.
bool CanForward(const FrameNodes& nodes, const FrameTables& tables, std::size_t copy,
                const RenderTexture& from)
{
    const RenderTexture& to = *nodes[copy].targets.colors.front();
    const bool isSameFormat = from.graphicsFormat() == to.graphicsFormat();
    bool isBegun = false;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const FrameNode& node = nodes[i];
        const bool usesFrom = Uses(node, from);
        if (i == copy)
        {
            continue;
        }
        if ((i < copy && Uses(node, to)) || (i > copy && usesFrom) ||
            (usesFrom &&
             (node.targets.colors.empty() || node.targets.colors.front().get() != &from ||
              !DrawsTheSame(node, tables, isSameFormat))))
        {
            return false;
        }
        if (usesFrom && !isBegun && !Overwrites(node, from))
        {
            return false;
        }
        isBegun = isBegun || usesFrom;
    }
    return isBegun;
}

/// The copy has alpha 1, so that is what draws leave there.
void DrawInto(FrameNode& node, FrameTables& tables, const RenderTexturePtr& to)
{
    node.targets.colors.front() = to;
    if (node.coversColor)
    {
        node.coversColor = false; // of the alpha something has to be left
        AddClear(node, {ClearFlag::Color, Color::black});
    }
    if (node.clear)
    {
        node.clear->color.a = 1.0f;
    }
    for (PassCommand& command : node.commands)
    {
        if (auto* clear = std::get_if<ClearCommand>(&command))
        {
            clear->color.a = 1.0f;
        }
    }
    ChangeSetups(node, tables,
                 [](DrawSetup& setup)
                 { setup.state.targets.at(0).writeMask &= ~ColorWriteMask::Alpha; });
}

} // namespace

void EliminateCopies(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame)
{
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const RenderTexturePtr from = CopiedBy(nodes[i], frame);
        const bool isKept = !from || OutlivesFrame(*from, frame.states) ||
                            Contains(outputs, *from) ||
                            !SameShape(*from, *nodes[i].targets.colors.front()) ||
                            !CanForward(nodes, frame, i, *from);
        if (isKept)
        {
            continue;
        }
        const RenderTexturePtr to = nodes[i].targets.colors.front();
        FrameNode* last = nullptr;
        for (FrameNode& node : nodes)
        {
            if (Uses(node, *from) && node.whyLeftOut.empty() && &node != &nodes[i])
            {
                DrawInto(node, frame, HasSamples(*from) ? from : to);
                last = &node;
            }
        }
        if (HasSamples(*from))
        {
            last->resolves.push_back({from, to});
        }
        Append(nodes[i].whyLeftOut,
               {"'", to->name(), "' is ", HasSamples(*from) ? "resolved" : "drawn",
                " into directly: nothing else reads '", from->name(), "', nor blends with it"});
    }
}

} // namespace limn
