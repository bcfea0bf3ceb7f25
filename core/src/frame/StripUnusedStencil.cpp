#include "frame/FrameNode.h"

#include <algorithm>
#include <limn/base/Lists.h>

namespace limn
{

namespace
{

using RenderTexturePtr = std::shared_ptr<const RenderTexture>;

/// The ids of textures that have to stay as they are.
TextureIds Kept(const FrameNodes& nodes, OutputSpan outputs, const FrameTables& tables)
{
    TextureIds kept(nodes.get_allocator());
    for (const auto& output : outputs)
    {
        kept.insert(output->id());
    }
    for (const FrameNode& node : nodes)
    {
        if (node.isCompute)
        {
            std::ranges::for_each(node.reads, [&](const auto& read) { kept.insert(read->id()); });
        }
        const auto usesStencil = [](const DrawSetup& draw)
        {
            return draw.state.stencilEnabled;
        };
        if (node.targets.depth && AnyDraw(node, tables, usesStencil))
        {
            kept.insert(node.targets.depth->id());
        }
    }
    return kept;
}

void LeaveOutClears(FrameNode& node)
{
    if (node.clear)
    {
        node.clear->flags = Without(node.clear->flags, ClearFlag::Stencil);
    }
    for (PassCommand& command : node.commands)
    {
        if (auto* clear = std::get_if<ClearCommand>(&command))
        {
            clear->flags = Without(clear->flags, ClearFlag::Stencil);
        }
    }
    std::erase_if(node.commands,
                  [](const PassCommand& command)
                  {
                      const auto* clear = std::get_if<ClearCommand>(&command);
                      return clear != nullptr && clear->flags == ClearFlag::None;
                  });
}

const RenderTexturePtr& TwinOf(const RenderTexturePtr& original,
                               std::unordered_map<std::uint64_t, TextureStates::DepthTwin>& twins)
{
    TextureStates::DepthTwin& twin = twins[original->id()];
    if (!twin.texture)
    {
        RenderTextureDescriptor descriptor = original->descriptor();
        descriptor.graphicsFormat = GraphicsFormat::D32_SFloat;
        descriptor.depthBufferBits = 0;
        twin = {original, std::make_shared<const RenderTexture>(original->name(), descriptor,
                                                                original->sampler(), true)};
    }
    return twin.texture;
}

void ReadTwins(FrameNodes& nodes, std::span<const RenderTexturePtr> originals, CompiledFrame& frame)
{
    for (FrameNode& node : nodes)
    {
        for (const RenderTexturePtr& original : originals)
        {
            if (Reads(node, *original))
            {
                ReadInstead(node, frame, *original,
                            frame.states.depthTwins.at(original->id()).texture);
            }
        }
    }
}

} // namespace

void StripUnusedStencil(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame)
{
    auto& twins = frame.states.depthTwins;
    std::erase_if(twins, [](const auto& entry) { return entry.second.original.expired(); });
    const TextureIds kept = Kept(nodes, outputs, frame);
    std::pmr::vector<RenderTexturePtr> replaced(nodes.get_allocator());
    for (FrameNode& node : nodes)
    {
        RenderTexturePtr& depth = node.targets.depth;
        if (depth && !OutlivesFrame(*depth, frame.states) && HasStencil(depth->graphicsFormat()) &&
            !kept.contains(depth->id()))
        {
            AddOnce(depth, replaced);
            depth = TwinOf(depth, twins);
            LeaveOutClears(node);
        }
    }
    ReadTwins(nodes, replaced, frame);
}

} // namespace limn
