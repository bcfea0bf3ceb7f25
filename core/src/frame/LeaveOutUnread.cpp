#include "frame/TextureHistory.h"

#include <algorithm>
#include <unordered_set>

namespace limn
{

namespace
{

using Ids = std::unordered_set<std::uint64_t>;

/// The textures whose contents are read behind the frame's last node.
Ids ReadAfterwards(const std::vector<FrameNode>& nodes, OutputSpan outputs,
                   const TextureStates& states)
{
    Ids ids;
    for (const FrameNode& node : nodes)
    {
        for (const auto& target : TargetsOf(node))
        {
            const auto state = states.textures.find(target->id());
            // What is pending takes the place of all that was drawn.
            const bool isReplaced =
                state != states.textures.end() && state->second.isPending &&
                Only(state->second.constant.flags, AspectsOf(*target)) == AspectsOf(*target);
            if (OutlivesFrame(*target, states) && !isReplaced)
            {
                ids.insert(target->id());
            }
        }
    }
    for (const auto& output : outputs)
    {
        ids.insert(output->id());
    }
    return ids;
}

std::string NamesOf(const FrameNode& node)
{
    std::string names;
    for (const auto& target : TargetsOf(node))
    {
        names += (names.empty() ? "'" : ", '") + target->name() + "'";
    }
    return names;
}

} // namespace

void LeaveOutUnread(std::vector<FrameNode>& nodes, OutputSpan outputs, CompiledFrame& frame)
{
    Ids read = ReadAfterwards(nodes, outputs, frame.states);
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
    {
        const auto targets = TargetsOf(*node);
        const bool isRead =
            std::any_of(targets.begin(), targets.end(),
                        [&](const auto& target) { return read.contains(target->id()); });
        if (!isRead)
        {
            node->whyLeftOut = "nothing reads " + NamesOf(*node);
            continue;
        }
        for (const auto& target : targets)
        {
            if (Overwrites(*node, *target))
            {
                read.erase(target->id());
            }
            else if (IsDepthFormat(target->graphicsFormat()))
            {
                read.insert(target->id()); // it decides what of the colours is drawn
            }
        }
        for (const auto& texture : node->reads)
        {
            read.insert(texture->id());
        }
    }
    EraseLeftOut(nodes, frame);
}

} // namespace limn
