#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// What comes from the CPU is there: nothing to wait for.
void AddRead(std::vector<std::shared_ptr<const Texture>>& reads,
             const std::shared_ptr<const Texture>& texture)
{
    const bool isDrawn = dynamic_cast<const RenderTexture*>(texture.get()) != nullptr;
    if (isDrawn && std::find(reads.begin(), reads.end(), texture) == reads.end())
    {
        reads.push_back(texture);
    }
}

void AddUse(std::vector<BufferUse>& uses, const BufferSlot& slot)
{
    const auto known = std::ranges::find(uses, slot.buffer, &BufferUse::buffer);
    if (known == uses.end())
    {
        uses.push_back({slot.buffer, slot.stages, slot.isWritten});
        return;
    }
    known->stages = known->stages | slot.stages;
    known->isWritten = known->isWritten || slot.isWritten;
}

void AddBindings(FrameNode& node, const DrawBindings& bindings)
{
    for (const TextureSlot& slot : bindings.textures)
    {
        AddRead(node.reads, slot.texture);
    }
    for (const StorageTextureSlot& slot : bindings.storageTextures)
    {
        if (std::ranges::find(node.writes, slot.texture) == node.writes.end())
        {
            node.writes.push_back(slot.texture);
        }
    }
    for (const BufferSlot& slot : bindings.buffers)
    {
        AddUse(node.buffers, slot);
    }
}

const DrawBindings* BindingsOf(const PassCommand& command, const FrameTables& tables)
{
    const auto* draw = std::get_if<DrawCommand>(&command);
    const auto* dispatch = std::get_if<DispatchCommand>(&command);
    return draw       ? tables.Setup(*draw).bindings.get()
           : dispatch ? tables.Setup(*dispatch).bindings.get()
                      : nullptr;
}

/// The only draw of a node; null where there are others, or clears.
const DrawCommand* OnlyDraw(const FrameNode& node)
{
    const DrawCommand* only = nullptr;
    for (const PassCommand& command : node.commands)
    {
        const auto* draw = std::get_if<DrawCommand>(&command);
        if (std::holds_alternative<ClearCommand>(command) || (draw && only))
        {
            return nullptr;
        }
        only = draw ? draw : only;
    }
    return only;
}

} // namespace

ClearFlag AspectsOf(const RenderTexture& texture)
{
    const GraphicsFormat format = texture.graphicsFormat();
    return !IsDepthFormat(format) ? ClearFlag::Color
           : HasStencil(format)   ? ClearFlag::DepthStencil
                                  : ClearFlag::Depth;
}

bool Clears(const FrameNode& node, ClearFlag aspects)
{
    return node.clear && Only(node.clear->flags, aspects) == aspects;
}

std::optional<Color> ClearColorOf(const FrameNode& node, const RenderTexture& target)
{
    const auto& colors = node.targets.colors;
    for (std::size_t i = 0; i < colors.size(); ++i)
    {
        if (colors[i].get() == &target)
        {
            return Clears(node, ClearFlag::Color)  ? std::optional(node.clear->color)
                   : i < node.clearedColors.size() ? node.clearedColors[i]
                                                   : std::nullopt;
        }
    }
    return std::nullopt;
}

bool HasSamples(const RenderTexture& texture)
{
    return texture.descriptor().msaaSamples > 1;
}

bool IsZero(const Color& color, GraphicsFormat format)
{
    const float values[] = {color.r, color.g, color.b, color.a};
    return std::all_of(values, values + ChannelCount(format),
                       [](float value) { return value == 0.0f; });
}

bool HasDraws(const FrameNode& node)
{
    return std::any_of(node.commands.begin(), node.commands.end(),
                       [](const PassCommand& command)
                       {
                           return std::holds_alternative<DrawCommand>(command) ||
                                  std::holds_alternative<DispatchCommand>(command);
                       });
}

bool Overwrites(const FrameNode& node, const RenderTexture& target)
{
    const auto isResolved = [&](const SampleResolve& resolve)
    {
        return resolve.to.get() == &target && resolve.from.get() != &target;
    };
    if (std::any_of(node.resolves.begin(), node.resolves.end(), isResolved))
    {
        return true;
    }
    const ClearFlag aspects = AspectsOf(target);
    return aspects == ClearFlag::Color ? node.coversColor || ClearColorOf(node, target)
                                       : Clears(node, aspects);
}

std::vector<std::shared_ptr<const RenderTexture>> TargetsOf(const FrameNode& node)
{
    std::vector<std::shared_ptr<const RenderTexture>> targets(node.targets.colors.begin(),
                                                              node.targets.colors.end());
    if (node.targets.depth)
    {
        targets.push_back(node.targets.depth);
    }
    for (const SampleResolve& resolve : node.resolves)
    {
        if (resolve.to != resolve.from)
        {
            targets.push_back(resolve.to);
        }
    }
    targets.insert(targets.end(), node.writes.begin(), node.writes.end());
    return targets;
}

bool Uses(const FrameNode& node, const Texture& texture)
{
    const auto is = [&](const auto& other)
    {
        return other.get() == &texture;
    };
    const auto targets = TargetsOf(node);
    return std::any_of(targets.begin(), targets.end(), is) ||
           std::any_of(node.reads.begin(), node.reads.end(), is);
}

std::shared_ptr<const RenderTexture> CopiedBy(const FrameNode& node, const FrameTables& tables)
{
    const DrawCommand* draw = OnlyDraw(node);
    if (draw == nullptr || !node.coversColor || node.targets.depth || node.reads.size() != 1)
    {
        return nullptr;
    }
    const auto& copied = tables.Setup(*draw).fullScreen->copied;
    return copied == node.reads.front() ? std::static_pointer_cast<const RenderTexture>(copied)
                                        : nullptr;
}

void CollectReads(FrameNode& node, const FrameTables& tables)
{
    node.reads.clear();
    node.writes.clear();
    node.buffers.clear();
    const DrawBindings* last = nullptr;
    for (const PassCommand& command : node.commands)
    {
        const DrawBindings* bindings = BindingsOf(command, tables);
        if (bindings != nullptr && bindings != last)
        {
            last = bindings;
            AddBindings(node, *bindings);
        }
    }
}

std::shared_ptr<const DrawBindings> WithTexture(const DrawBindings& bindings,
                                                const Texture& replaced,
                                                const std::shared_ptr<const Texture>& texture)
{
    auto changed = std::make_shared<DrawBindings>(bindings);
    for (TextureSlot& slot : changed->textures)
    {
        slot.texture = slot.texture.get() == &replaced ? texture : slot.texture;
    }
    return changed;
}

void ReadInstead(FrameNode& node, FrameTables& tables, const Texture& replaced,
                 const std::shared_ptr<const Texture>& texture)
{
    ChangeSetups(node, tables,
                 [&](DrawSetup& setup)
                 { setup.bindings = WithTexture(*setup.bindings, replaced, texture); });
    CollectReads(node, tables);
}

void Merge(ClearCommand& clear, const ClearCommand& other)
{
    if (other.flags & ClearFlag::Color)
    {
        clear.color = other.color;
    }
    if (other.flags & ClearFlag::Depth)
    {
        clear.depth = other.depth;
    }
    if (other.flags & ClearFlag::Stencil)
    {
        clear.stencil = other.stencil;
    }
    clear.flags = clear.flags | other.flags;
}

void EraseLeftOut(std::vector<FrameNode>& nodes, CompiledFrame& frame)
{
    std::erase_if(nodes,
                  [&](FrameNode& node)
                  {
                      if (node.whyLeftOut.empty())
                      {
                          return false;
                      }
                      LeftOut leftOut{node.name, std::move(node.whyLeftOut), {}, node.place};
                      for (const auto& target : TargetsOf(node))
                      {
                          leftOut.targets.push_back(target->name());
                      }
                      frame.leftOut.push_back(std::move(leftOut));
                      return true;
                  });
}

void EraseEmptySamples(FrameNode& node)
{
    std::vector<PassCommand> kept;
    for (PassCommand& command : node.commands)
    {
        const bool endsAnEmptyOne = std::holds_alternative<EndSampleCommand>(command) &&
                                    !kept.empty() &&
                                    std::holds_alternative<BeginSampleCommand>(kept.back());
        if (endsAnEmptyOne)
        {
            kept.pop_back();
        }
        else
        {
            kept.push_back(std::move(command));
        }
    }
    node.commands = std::move(kept);
}

} // namespace limn
