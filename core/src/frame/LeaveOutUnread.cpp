#include "frame/TextureHistory.h"

#include <algorithm>
#include <unordered_set>

namespace limn
{

namespace
{

using Ids = std::unordered_set<std::uint64_t>;

/// Whether what is pending takes the place of all that was drawn.
bool IsReplaced(const RenderTexture& texture, const TextureStates& states)
{
    const auto state = states.textures.find(texture.id());
    return state != states.textures.end() && state->second.isPending &&
           Only(state->second.constant.flags, AspectsOf(texture)) == AspectsOf(texture);
}

/// Returns the textures whose contents are read behind the frame's last node.
Ids ReadAfterwards(const std::vector<FrameNode>& nodes, OutputSpan outputs,
                   const TextureStates& states)
{
    Ids ids;
    for (const FrameNode& node : nodes)
    {
        for (const auto& target : TargetsOf(node))
        {
            if (OutlivesFrame(*target, states) && !IsReplaced(*target, states))
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
            node->targets.isKept ||
            std::any_of(targets.begin(), targets.end(),
                        [&](const auto& target) { return read.contains(target->id()); }) ||
            std::ranges::any_of(node->buffers, &BufferUse::isWritten); // it outlives the frame
        if (!isRead)
        {
            node->whyLeftOut = "nothing reads " + NamesOf(*node);
            continue;
        }
        for (const SampleResolve& resolve : node->resolves)
        {
            read.insert(resolve.from->id());
        }
        for (const auto& target : targets)
        {
            if (Overwrites(*node, *target))
            {
                read.erase(target->id());
            }
            else if (IsDepthFormat(target->graphicsFormat()) || node->isCompute)
            {
                // It decides what of the colours is drawn; a kernel may read what it writes to.
                read.insert(target->id());
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
