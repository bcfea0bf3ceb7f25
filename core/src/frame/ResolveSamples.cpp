#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns whether something reads the texture before the next node draws into it.
bool IsRead(std::span<const FrameNode> following,
            const std::shared_ptr<const RenderTexture>& target, OutputSpan outputs,
            const TextureStates& states)
{
    for (const FrameNode& node : following)
    {
        if (Reads(node, *target))
        {
            return true;
        }
        if (HasTarget(node, *target))
        {
            return false;
        }
    }
    return OutlivesFrame(*target, states) || Contains(outputs, *target);
}

} // namespace

void ResolveSamples(FrameNodes& nodes, OutputSpan outputs, const CompiledFrame& frame)
{
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const auto following = std::span<const FrameNode>(nodes).subspan(i + 1);
        const auto resolve = [&](const std::shared_ptr<const RenderTexture>& target)
        {
            if (target && HasSamples(*target) && IsRead(following, target, outputs, frame.states))
            {
                nodes[i].resolves.push_back({target, target});
            }
        };
        std::ranges::for_each(nodes[i].targets.colors, resolve);
        resolve(nodes[i].targets.depth);
    }
}

} // namespace limn
