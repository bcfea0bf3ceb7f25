#include "frame/TextureHistory.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Whether something reads what the texture holds before the next node draws into it.
bool IsRead(std::span<const FrameNode> following,
            const std::shared_ptr<const RenderTexture>& target, OutputSpan outputs,
            const TextureStates& states)
{
    for (const FrameNode& node : following)
    {
        const auto targets = TargetsOf(node);
        if (std::find(node.reads.begin(), node.reads.end(), target) != node.reads.end())
        {
            return true;
        }
        if (std::find(targets.begin(), targets.end(), target) != targets.end())
        {
            return false;
        }
    }
    return OutlivesFrame(*target, states) ||
           std::find(outputs.begin(), outputs.end(), target) != outputs.end();
}

} // namespace

void ResolveSamples(std::vector<FrameNode>& nodes, OutputSpan outputs, const CompiledFrame& frame)
{
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const auto following = std::span<const FrameNode>(nodes).subspan(i + 1);
        for (const auto& target : TargetsOf(nodes[i]))
        {
            if (HasSamples(*target) && IsRead(following, target, outputs, frame.states))
            {
                nodes[i].resolves.push_back({target, target});
            }
        }
    }
}

} // namespace limn
