#include "draw/UnusedStencil.h"

#include <unordered_set>

namespace limn
{

namespace
{

bool UsesStencil(const OpenPass& pass)
{
    for (const PassCommand& command : pass.commands)
    {
        const auto* draw = std::get_if<DrawCommand>(&command);
        if (draw != nullptr && draw->state.stencilEnabled)
        {
            return true;
        }
    }
    return false;
}

/// The ids of textures that have to stay as they are.
std::unordered_set<std::uint64_t>
Kept(const std::vector<OpenPass>& passes,
     std::span<const std::shared_ptr<const RenderTexture>> outputs)
{
    std::unordered_set<std::uint64_t> kept;
    for (const auto& output : outputs)
    {
        kept.insert(output->id());
    }
    for (const OpenPass& pass : passes)
    {
        for (const auto& texture : pass.reads)
        {
            kept.insert(texture->id());
        }
        if (pass.targets.depth && UsesStencil(pass))
        {
            kept.insert(pass.targets.depth->id());
        }
    }
    return kept;
}

ClearFlag WithoutStencil(ClearFlag flags)
{
    return static_cast<ClearFlag>(static_cast<int>(flags) & ~static_cast<int>(ClearFlag::Stencil));
}

void LeaveOutClears(OpenPass& pass)
{
    if (pass.clear)
    {
        pass.clear->flags = WithoutStencil(pass.clear->flags);
    }
    for (PassCommand& command : pass.commands)
    {
        if (auto* clear = std::get_if<ClearCommand>(&command))
        {
            clear->flags = WithoutStencil(clear->flags);
        }
    }
    std::erase_if(pass.commands,
                  [](const PassCommand& command)
                  {
                      const auto* clear = std::get_if<ClearCommand>(&command);
                      return clear != nullptr && clear->flags == ClearFlag::None;
                  });
}

const std::shared_ptr<const RenderTexture>&
TwinOf(const std::shared_ptr<const RenderTexture>& original, DepthTwins& twins)
{
    DepthTwin& twin = twins[original->id()];
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

} // namespace

void LeaveOutUnusedStencil(std::vector<OpenPass>& passes,
                           std::span<const std::shared_ptr<const RenderTexture>> outputs,
                           DepthTwins& twins)
{
    std::erase_if(twins, [](const auto& entry) { return entry.second.original.expired(); });
    const std::unordered_set<std::uint64_t> kept = Kept(passes, outputs);
    for (OpenPass& pass : passes)
    {
        std::shared_ptr<const RenderTexture>& depth = pass.targets.depth;
        if (depth && depth->isTransient() && HasStencil(depth->graphicsFormat()) &&
            !kept.contains(depth->id()))
        {
            depth = TwinOf(depth, twins);
            LeaveOutClears(pass);
        }
    }
}

} // namespace limn
