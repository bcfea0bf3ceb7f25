#include "frame/FrameNode.h"

#include <limn/base/Lists.h>
#include <typeinfo>

namespace limn
{

namespace
{

/// Adds a texture that the node reads. A texture from the CPU needs no wait, so it is not added.
void AddRead(FrameNode& node, const std::shared_ptr<const Texture>& texture)
{
    const Texture& read = *texture;
    if (!Reads(node, read) && typeid(read) == typeid(RenderTexture))
    {
        node.reads.push_back(texture);
    }
}

void AddUse(std::pmr::vector<BufferUse>& uses, const BufferSlot& slot)
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
        AddRead(node, slot.texture);
    }
    for (const StorageTextureSlot& slot : bindings.storageTextures)
    {
        AddOnce(slot.texture, node.writes);
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

FrameNode::FrameNode(const FrameAllocator& memory)
    : name(memory),
      commands(memory),
      reads(memory),
      writes(memory),
      buffers(memory),
      resolves(memory),
      whyLeftOut(memory)
{
}

FrameNode::FrameNode(FrameNode&& other, const FrameAllocator& memory) : FrameNode(memory)
{
    *this = std::move(other);
}

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
    return std::count(values, values + ChannelCount(format), 0.0f) == ChannelCount(format);
}

bool HasDraws(const FrameNode& node)
{
    return Has<DrawCommand>(node) || Has<DispatchCommand>(node);
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

bool HasTarget(const FrameNode& node, const Texture& texture)
{
    return AnyTarget(node, [&](const auto& target) { return target.get() == &texture; });
}

bool Reads(const FrameNode& node, const Texture& texture)
{
    return std::ranges::any_of(node.reads,
                               [&](const auto& read) { return read.get() == &texture; });
}

bool Uses(const FrameNode& node, const Texture& texture)
{
    return HasTarget(node, texture) || Reads(node, texture);
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

void AddClear(FrameNode& node, const ClearCommand& other)
{
    node.clear = node.clear ? *node.clear : ClearCommand{};
    Merge(*node.clear, other);
}

void EraseLeftOut(FrameNodes& nodes, FrameNodes& leftOut)
{
    std::erase_if(nodes,
                  [&](FrameNode& node)
                  {
                      if (node.whyLeftOut.empty())
                      {
                          return false;
                      }
                      leftOut.push_back(std::move(node));
                      return true;
                  });
}

void EraseEmptySamples(FrameNode& node)
{
    auto end = node.commands.begin(); // of those that are kept
    for (PassCommand& command : node.commands)
    {
        const bool endsAnEmptyOne = std::holds_alternative<EndSampleCommand>(command) &&
                                    end != node.commands.begin() &&
                                    std::holds_alternative<BeginSampleCommand>(*(end - 1));
        if (endsAnEmptyOne)
        {
            --end;
        }
        else
        {
            *end++ = command;
        }
    }
    node.commands.erase(end, node.commands.end());
}

} // namespace limn
