#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// The next use of a texture's contents.
enum class NextUse
{
    None,
    Needs,
    Overwrites
};

const SampleResolve* FindResolve(const FrameNode& node, const RenderTexture& texture)
{
    const auto found = std::find_if(node.resolves.begin(), node.resolves.end(),
                                    [&](const auto& r) { return r.from.get() == &texture; });
    return found == node.resolves.end() ? nullptr : &*found;
}

/// Readers of a texture with several samples see what they were resolved to.
NextUse FindNextUse(const FrameNodes& nodes, std::size_t from, const RenderTexture& texture,
                    ClearFlag aspect)
{
    for (std::size_t i = from; i < nodes.size(); ++i)
    {
        const FrameNode& node = nodes[i];
        const auto is = [&](const auto& other)
        {
            return other.get() == &texture;
        };
        if (!HasSamples(texture) && Reads(node, texture))
        {
            return NextUse::Needs;
        }
        if (std::any_of(node.writes.begin(), node.writes.end(), is))
        {
            return NextUse::Needs;
        }
        const auto& colors = node.targets.colors;
        if (is(node.targets.depth) || std::any_of(colors.begin(), colors.end(), is))
        {
            const bool isColor = aspect == ClearFlag::Color;
            if (isColor ? Overwrites(node, texture) : Clears(node, aspect))
            {
                return NextUse::Overwrites;
            }
            if (!isColor || FindResolve(node, texture))
            {
                return NextUse::Needs; // depth decides what is drawn
            }
        }
    }
    return NextUse::None;
}

using Readers = std::pmr::unordered_map<std::uint64_t, ShaderStage>;

void AddReaders(const ShaderProgram& program, const DrawBindings& bindings, Readers& readers)
{
    for (const TextureSlot& slot : bindings.textures)
    {
        for (const TextureBinding& binding : program.layout.textures)
        {
            if (binding.binding == slot.binding)
            {
                ShaderStage& stages = readers[slot.texture->id()];
                stages = stages | binding.stages;
            }
        }
    }
}

/// Returns the shader stages that read a texture anywhere in the frame, by Texture::id.
Readers FindReaders(const FrameNodes& nodes, const FrameTables& tables)
{
    Readers readers(nodes.get_allocator());
    std::pmr::vector<bool> isDone(tables.setups.size(), false, nodes.get_allocator());
    for (const FrameNode& node : nodes)
    {
        for (const PassCommand& command : node.commands)
        {
            const auto* draw = std::get_if<DrawCommand>(&command);
            if (draw != nullptr && !isDone[draw->setup])
            {
                isDone[draw->setup] = true;
                const DrawSetup& setup = tables.Setup(*draw);
                if (setup.program && setup.bindings)
                {
                    AddReaders(*setup.program, *setup.bindings, readers);
                }
            }
            else if (const auto* dispatch = std::get_if<DispatchCommand>(&command))
            {
                const DispatchSetup& setup = tables.Setup(*dispatch);
                if (setup.program)
                {
                    AddReaders(*setup.program, *setup.bindings, readers);
                }
            }
        }
    }
    return readers;
}

/// Load, store and barriers of the nodes that are left.
class PassMaker
{
public:
    PassMaker(const FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame)
        : m_Nodes(nodes), m_Outputs(outputs), m_Frame(frame), m_Readers(FindReaders(nodes, frame))
    {
    }

    void Make()
    {
        m_Frame.passes.resize(m_Nodes.size());
        for (std::size_t i = 0; i < m_Nodes.size(); ++i)
        {
            Make(i, m_Frame.passes[i]);
        }
        for (const auto& output : m_Outputs)
        {
            Transition(output, TextureUsage::CopySource, m_Frame.finalBarriers);
        }
    }

private:
    /// @param result  gets all that it has anew
    void Make(std::size_t index, CompiledRenderPass& result)
    {
        const FrameNode& node = m_Nodes[index];
        result.name = node.name;
        result.barriers.clear();
        result.bufferBarriers.clear();
        result.colors.clear();
        result.depth.reset();
        result.mips.clear();
        result.width = 0;
        result.height = 0;
        result.place = node.place;
        for (const auto& texture : node.reads)
        {
            Transition(texture, TextureUsage::ShaderRead, result.barriers);
        }
        for (const auto& texture : node.writes)
        {
            Transition(texture, TextureUsage::RandomWrite, result.barriers);
            StateOf(texture).isFilled = true;
            if (node.targets.generatesMips && texture->mipmapCount() > 1)
            {
                result.mips.push_back(texture);
            }
        }
        for (const BufferUse& use : node.buffers)
        {
            Transition(use, result.bufferBarriers);
        }
        for (const auto& texture : node.targets.colors)
        {
            result.colors.push_back(Color(index, texture, result.barriers));
            result.width = texture->width();
            result.height = texture->height();
        }
        if (const auto& depth = node.targets.depth)
        {
            result.depth = Depth(index, depth, result.barriers);
            result.width = depth->width();
            result.height = depth->height();
        }
        result.commands.assign(node.commands.begin(), node.commands.end());
    }

    ColorAttachment Color(std::size_t index, const std::shared_ptr<const RenderTexture>& texture,
                          std::vector<TextureBarrier>& barriers)
    {
        ColorAttachment attachment;
        attachment.texture = texture;
        attachment.store = Store(index, *texture, ClearFlag::Color);
        const bool isSeen =
            attachment.store == StoreOp::Store || FindResolve(m_Nodes[index], *texture);
        attachment.load =
            isSeen ? Load(m_Nodes[index], *texture, ClearFlag::Color) : LoadOp::DontCare;
        if (attachment.load == LoadOp::Clear)
        {
            attachment.clearColor = *ClearColorOf(m_Nodes[index], *texture);
        }
        Transition(texture, TextureUsage::ColorAttachment, barriers);
        StateOf(texture).isFilled = true;
        attachment.resolve = ResolveOf(m_Nodes[index], texture, barriers);
        attachment.generatesMips = GeneratesMips(attachment, m_Nodes[index]);
        return attachment;
    }

    static bool GeneratesMips(const ColorAttachment& attachment, const FrameNode& node)
    {
        const RenderTexture& seen = attachment.resolve ? *attachment.resolve : *attachment.texture;
        const bool isStored = attachment.resolve || attachment.store == StoreOp::Store;
        return isStored && !(HasSamples(seen) && !attachment.resolve) && seen.mipmapCount() > 1 &&
               (seen.descriptor().autoGenerateMips || node.targets.generatesMips);
    }

    DepthAttachment Depth(std::size_t index, const std::shared_ptr<const RenderTexture>& texture,
                          std::vector<TextureBarrier>& barriers)
    {
        const FrameNode& node = m_Nodes[index];
        DepthAttachment attachment;
        attachment.texture = texture;
        attachment.load = Load(node, *texture, ClearFlag::Depth);
        attachment.store = Store(index, *texture, ClearFlag::Depth);
        attachment.stencilLoad = Load(node, *texture, ClearFlag::Stencil);
        attachment.stencilStore = Store(index, *texture, ClearFlag::Stencil);
        if (node.clear)
        {
            attachment.clearDepth = node.clear->depth;
            attachment.clearStencil = node.clear->stencil;
        }
        Transition(texture, TextureUsage::DepthStencilAttachment, barriers);
        StateOf(texture).isFilled = true;
        attachment.resolve = ResolveOf(node, texture, barriers);
        return attachment;
    }

    std::shared_ptr<const RenderTexture>
    ResolveOf(const FrameNode& node, const std::shared_ptr<const RenderTexture>& texture,
              std::vector<TextureBarrier>& barriers)
    {
        const SampleResolve* resolve = FindResolve(node, *texture);
        if (resolve == nullptr)
        {
            return nullptr;
        }
        if (resolve->to != texture)
        {
            Transition(resolve->to, TextureUsage::ColorAttachment, barriers);
            StateOf(resolve->to).isFilled = true;
        }
        return resolve->to;
    }

    TextureState& StateOf(const std::shared_ptr<const Texture>& texture)
    {
        return limn::StateOf(m_Frame.states, texture);
    }

    LoadOp Load(const FrameNode& node, const RenderTexture& texture, ClearFlag aspect) const
    {
        if (aspect == ClearFlag::Color ? ClearColorOf(node, texture).has_value()
                                       : Clears(node, aspect))
        {
            return LoadOp::Clear;
        }
        const TextureState* state = FindState(m_Frame.states, texture);
        return state && state->isFilled && !Overwrites(node, texture) ? LoadOp::Load
                                                                      : LoadOp::DontCare;
    }

    StoreOp Store(std::size_t index, const RenderTexture& texture, ClearFlag aspect) const
    {
        switch (FindNextUse(m_Nodes, index + 1, texture, aspect))
        {
        case NextUse::Needs:
            return StoreOp::Store;
        case NextUse::Overwrites:
            return StoreOp::DontCare;
        case NextUse::None:
            break;
        }
        const bool isOutput = !HasSamples(texture) && Contains(m_Outputs, texture);
        return isOutput || OutlivesFrame(texture, m_Frame.states) ? StoreOp::Store
                                                                  : StoreOp::DontCare;
    }

    /// Returns the readers in the whole frame, so that a texture needs no other barrier for the
    /// next reader.
    ShaderStage ReadersOf(const Texture& texture, TextureUsage usage) const
    {
        const auto found = m_Readers.find(texture.id());
        return usage == TextureUsage::ShaderRead && found != m_Readers.end() ? found->second
                                                                             : ShaderStage::None;
    }

    void Transition(const std::shared_ptr<const Texture>& texture, TextureUsage usage,
                    std::vector<TextureBarrier>& barriers)
    {
        TextureState& state = StateOf(texture);
        const bool onlyReads =
            usage == TextureUsage::ShaderRead || usage == TextureUsage::CopySource;
        const bool isRead = state.usage == TextureUsage::ShaderRead && usage == state.usage;
        ShaderStage readers = ReadersOf(*texture, usage);
        if (isRead && readers != ShaderStage::None)
        {
            readers = readers | state.readers;
        }
        const bool isNew = state.readers != ShaderStage::None && readers != state.readers;
        if (state.usage == usage && onlyReads && !(isRead && isNew))
        {
            return;
        }
        barriers.push_back({texture, state.usage, usage, readers});
        state.usage = usage;
        state.readers = readers;
    }

    void Transition(const BufferUse& use, std::vector<BufferBarrier>& barriers)
    {
        BufferState& state = m_Frame.states.buffers[use.buffer->id()];
        state.buffer = use.buffer;
        const ShaderStage writer = state.isWritten ? ShaderStage::Compute : ShaderStage::None;
        if (use.isWritten)
        {
            const ShaderStage before = state.readers | writer;
            if (before != ShaderStage::None)
            {
                barriers.push_back({use.buffer, before, state.isWritten, use.stages, true});
            }
            state = {use.buffer, true, ShaderStage::None, ShaderStage::None};
            return;
        }
        if (state.isWritten && !HasAll(state.visible, use.stages))
        {
            barriers.push_back({use.buffer, writer, true, use.stages, false});
            state.visible = state.visible | use.stages;
        }
        state.readers = state.readers | use.stages;
    }

    const FrameNodes& m_Nodes;
    OutputSpan m_Outputs;
    CompiledFrame& m_Frame;
    Readers m_Readers;
};

} // namespace

void AssignLoadStoreBarriers(const FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame)
{
    PassMaker(nodes, outputs, frame).Make();
}

} // namespace limn
