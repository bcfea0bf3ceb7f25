#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns whether what is pending takes the place of all that was drawn.
bool IsReplaced(const RenderTexture& texture, const TextureStates& states)
{
    const TextureState* state = FindState(states, texture);
    return state && state->isPending &&
           Only(state->constant.flags, AspectsOf(texture)) == AspectsOf(texture);
}

/// Returns the textures whose contents are read behind the frame's last node.
TextureIds ReadAfterwards(const FrameNodes& nodes, OutputSpan outputs, const TextureStates& states)
{
    TextureIds ids(nodes.get_allocator());
    for (const FrameNode& node : nodes)
    {
        ForEachTarget(node,
                      [&](const auto& target)
                      {
                          if (OutlivesFrame(*target, states) && !IsReplaced(*target, states))
                          {
                              ids.insert(target->id());
                          }
                      });
    }
    for (const auto& output : outputs)
    {
        ids.insert(output->id());
    }
    return ids;
}

void SayThatNothingReads(FrameNode& node)
{
    ForEachTarget(node,
                  [&](const auto& target)
                  {
                      Append(node.whyLeftOut, {node.whyLeftOut.empty() ? "nothing reads '" : ", '",
                                               target->name(), "'"});
                  });
}

/// Notes that the node reads what it needs of textures, but not what it writes itself.
void NoteReads(const FrameNode& node, TextureIds& read)
{
    for (const SampleResolve& resolve : node.resolves)
    {
        read.insert(resolve.from->id());
    }
    ForEachTarget(node,
                  [&](const auto& target)
                  {
                      if (Overwrites(node, *target))
                      {
                          read.erase(target->id());
                      }
                      else if (IsDepthFormat(target->graphicsFormat()) || node.isCompute)
                      {
                          // It decides what of the colours is drawn; a kernel may read what it
                          // writes to.
                          read.insert(target->id());
                      }
                  });
    for (const auto& texture : node.reads)
    {
        read.insert(texture->id());
    }
}

} // namespace

void CullPasses(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame)
{
    TextureIds read = ReadAfterwards(nodes, outputs, frame.states);
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
    {
        const bool isRead =
            node->targets.isKept ||
            AnyTarget(*node, [&](const auto& target) { return read.contains(target->id()); }) ||
            std::ranges::any_of(node->buffers, &BufferUse::isWritten); // it outlives the frame
        if (isRead)
        {
            NoteReads(*node, read);
        }
        else
        {
            SayThatNothingReads(*node);
        }
    }
}

} // namespace limn
