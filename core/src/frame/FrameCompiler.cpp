#include "frame/FrameNode.h"

#include <algorithm>
#include <limn/core/FrameCompiler.h>
#include <unordered_set>

namespace limn
{

namespace
{

/// How a texture's next appearance treats what is in it.
enum class NextUse
{
    None,
    Needs,
    Overwrites
};

NextUse FindNextUse(const std::vector<FrameNode>& nodes, std::size_t from, const Texture& texture,
                    ClearFlag aspect)
{
    for (std::size_t i = from; i < nodes.size(); ++i)
    {
        const FrameNode& node = nodes[i];
        const auto is = [&](const auto& other)
        {
            return other.get() == &texture;
        };
        if (std::any_of(node.reads.begin(), node.reads.end(), is))
        {
            return NextUse::Needs;
        }
        const auto& colors = node.targets.colors;
        if (is(node.targets.depth) || std::any_of(colors.begin(), colors.end(), is))
        {
            return Clears(node, aspect) || (aspect == ClearFlag::Color && node.coversColor)
                       ? NextUse::Overwrites
                       : NextUse::Needs;
        }
    }
    return NextUse::None;
}

/// Looks at the first thing the frame does with each texture: whether it reads what a frame before
/// left in it.
/// @return the textures that it overwrites
std::vector<std::uint64_t> LearnHistory(const std::vector<FrameNode>& nodes, CompiledFrame& frame)
{
    std::vector<std::uint64_t> overwritten;
    std::unordered_set<std::uint64_t> seen;
    const auto learn = [&](const FrameNode& node, const std::shared_ptr<const Texture>& texture,
                           bool isOverwritten)
    {
        if (!seen.insert(texture->id()).second)
        {
            return;
        }
        TextureState& state = frame.states.textures[texture->id()];
        state.texture = texture;
        if (isOverwritten)
        {
            overwritten.push_back(texture->id());
        }
        else if (state.history == TextureHistory::Overwritten)
        {
            frame.notes.push_back("pass '" + node.name + "' reads what the frame before left in '" +
                                  texture->name() +
                                  "', which was not kept, because the frames before that had "
                                  "overwritten it first; it is kept from now on");
            state.history = TextureHistory::Read;
        }
        else if (state.isFilled || state.isPending)
        {
            state.history = TextureHistory::Read;
        }
    };
    for (const FrameNode& node : nodes)
    {
        for (const auto& texture : node.reads)
        {
            learn(node, texture, false);
        }
        for (const auto& target : TargetsOf(node))
        {
            learn(node, target, Overwrites(node, *target));
        }
    }
    return overwritten;
}

} // namespace

/// Load, store and barriers of the nodes that are left.
class PassMaker
{
public:
    PassMaker(std::vector<FrameNode>& nodes, Outputs outputs, CompiledFrame& frame)
        : m_Nodes(nodes), m_Outputs(outputs), m_Frame(frame)
    {
    }

    void Make()
    {
        for (std::size_t i = 0; i < m_Nodes.size(); ++i)
        {
            m_Frame.passes.push_back(Pass(i));
        }
        for (const auto& output : m_Outputs)
        {
            Transition(output, TextureUsage::CopySource, m_Frame.finalBarriers);
        }
    }

private:
    CompiledRenderPass Pass(std::size_t index)
    {
        FrameNode& node = m_Nodes[index];
        CompiledRenderPass result;
        result.name = node.name;
        for (const auto& texture : node.reads)
        {
            Transition(texture, TextureUsage::ShaderRead, result.barriers);
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
        result.commands = std::move(node.commands);
        return result;
    }

    ColorAttachment Color(std::size_t index, const std::shared_ptr<const RenderTexture>& texture,
                          std::vector<TextureBarrier>& barriers)
    {
        ColorAttachment attachment;
        attachment.texture = texture;
        attachment.load = Load(m_Nodes[index], *texture, ClearFlag::Color);
        attachment.store = Store(index, *texture, ClearFlag::Color);
        if (attachment.load == LoadOp::Clear)
        {
            attachment.clearColor = m_Nodes[index].clear->color;
        }
        Transition(texture, TextureUsage::ColorAttachment, barriers);
        StateOf(texture).isFilled = true;
        return attachment;
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
        return attachment;
    }

    TextureState& StateOf(const std::shared_ptr<const Texture>& texture)
    {
        TextureState& state = m_Frame.states.textures[texture->id()];
        state.texture = texture;
        return state;
    }

    LoadOp Load(const FrameNode& node, const RenderTexture& texture, ClearFlag aspect) const
    {
        if (Clears(node, aspect))
        {
            return LoadOp::Clear;
        }
        const auto state = m_Frame.states.textures.find(texture.id());
        const bool isFilled = state != m_Frame.states.textures.end() && state->second.isFilled;
        return isFilled && !Overwrites(node, texture) ? LoadOp::Load : LoadOp::DontCare;
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
        const bool isOutput =
            std::any_of(m_Outputs.begin(), m_Outputs.end(),
                        [&](const auto& output) { return output.get() == &texture; });
        return isOutput || OutlivesFrame(texture, m_Frame.states) ? StoreOp::Store
                                                                  : StoreOp::DontCare;
    }

    void Transition(const std::shared_ptr<const Texture>& texture, TextureUsage usage,
                    std::vector<TextureBarrier>& barriers)
    {
        TextureState& state = StateOf(texture);
        const bool onlyReads =
            usage == TextureUsage::ShaderRead || usage == TextureUsage::CopySource;
        if (state.usage == usage && onlyReads)
        {
            return;
        }
        barriers.push_back({texture, state.usage, usage});
        state.usage = usage;
    }

    std::vector<FrameNode>& m_Nodes;
    Outputs m_Outputs;
    CompiledFrame& m_Frame;
};

/// Of textures that no next frame reads, only their use counts.
void ForgetContents(Outputs outputs, TextureStates& states)
{
    for (auto& [id, state] : states.textures)
    {
        const auto texture = std::static_pointer_cast<const RenderTexture>(state.texture.lock());
        const bool isOutput = std::any_of(outputs.begin(), outputs.end(),
                                          [&](const auto& output) { return output == texture; });
        if (texture && !isOutput && !OutlivesFrame(*texture, states))
        {
            state.isFilled = false;
            state.isPending = false;
            state.constant.flags = ClearFlag::None;
        }
    }
}

/// As if all frames to come overwrote all textures.
void KeepNothing(TextureStates& states)
{
    for (auto& [id, state] : states.textures)
    {
        state.history = TextureHistory::Overwritten;
    }
}

void RememberOverwritten(std::span<const std::uint64_t> textures, TextureStates& states)
{
    for (const std::uint64_t id : textures)
    {
        TextureHistory& history = states.textures[id].history;
        history = history == TextureHistory::Unknown ? TextureHistory::Overwritten : history;
    }
}

} // namespace

CompiledFrame CompileFrame(FrameCommands commands, const TextureStates& states, Outputs outputs,
                           bool isLast)
{
    CompiledFrame frame;
    frame.states = states;
    std::erase_if(frame.states.textures,
                  [](const auto& entry) { return entry.second.texture.expired(); });
    std::vector<FrameNode> nodes = SplitIntoNodes(std::move(commands.commands));
    FindAccess(nodes);
    const std::vector<std::uint64_t> overwritten = LearnHistory(nodes, frame);
    if (isLast)
    {
        KeepNothing(frame.states);
    }
    FoldConstants(nodes, outputs, frame);
    ForwardCopies(nodes, outputs, frame);
    LeaveOutUnread(nodes, outputs, frame);
    LeaveOutStencil(nodes, outputs, frame);
    MergeNodes(nodes);
    PassMaker(nodes, outputs, frame).Make();
    ForgetContents(outputs, frame.states);
    RememberOverwritten(overwritten, frame.states);
    frame.uniformData = std::move(commands.uniformData);
    frame.perDraw = std::move(commands.perDraw);
    return frame;
}

} // namespace limn
