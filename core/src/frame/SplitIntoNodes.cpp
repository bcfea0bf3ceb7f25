#include "frame/FrameNode.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/core/DrawError.h>

namespace limn
{

namespace
{

ViewportRect WholeOf(const SetRenderTargetCommand& target)
{
    const RenderTexture& any = target.colors.empty() ? *target.depth : *target.colors.front();
    return {0, 0, any.width(), any.height()};
}

ClearFlag AspectsOf(const SetRenderTargetCommand& target)
{
    return (target.colors.empty() ? ClearFlag::None : ClearFlag::Color) |
           (target.depth ? AspectsOf(*target.depth) : ClearFlag::None);
}

/// @throws DrawError if the draw samples what it draws into
void ExpectOtherTextures(const FrameNode& node, const DrawBindings& bindings)
{
    const auto& colors = node.targets.colors;
    for (const TextureSlot& slot : bindings.textures)
    {
        if (slot.texture == node.targets.depth ||
            std::find(colors.begin(), colors.end(), slot.texture) != colors.end())
        {
            throw DrawError("pass '" + std::string(node.name) + "' samples '" +
                            slot.texture->name() +
                            "' while drawing into it; draw into another texture and copy");
        }
    }
}

/// @throws DrawError if the kernel samples what it writes to
void ExpectOtherTextures(const DrawBindings& bindings)
{
    for (const TextureSlot& slot : bindings.textures)
    {
        for (const StorageTextureSlot& written : bindings.storageTextures)
        {
            if (slot.texture == written.texture)
            {
                throw DrawError("a dispatch samples '" + slot.texture->name() +
                                "' while it may write to it; read it through the writable texture, "
                                "or write to another texture");
            }
        }
    }
}

class NodeSplitter
{
public:
    NodeSplitter(const FrameTables& tables, FrameNodes& nodes)
        : m_Tables(tables),
          m_Nodes(nodes),
          m_Pending(nodes.get_allocator()),
          m_Samples(nodes.get_allocator())
    {
    }

    void Split(std::span<const FrameCommand> commands)
    {
        m_Nodes.reserve(static_cast<std::size_t>(std::ranges::count_if(commands, BeginsNode)));
        for (const FrameCommand& command : commands)
        {
            std::visit([&](const auto& c) { Take(c); }, command);
        }
        for (; !m_Samples.empty(); m_Samples.pop_back())
        {
            m_Pending.emplace_back(EndSampleCommand{});
        }
        if (!m_Nodes.empty())
        {
            FlushPending();
        }
    }

private:
    static bool BeginsNode(const FrameCommand& command)
    {
        return std::holds_alternative<SetRenderTargetCommand>(command) ||
               std::holds_alternative<DispatchCommand>(command);
    }

    void Take(const SetRenderTargetCommand& command)
    {
        m_Target = &command;
        m_Viewport.reset();
    }

    void Take(const SetViewportCommand& command) { m_Viewport = command.rect; }

    void Take(ClearCommand command)
    {
        command.flags = m_Target ? Only(command.flags, AspectsOf(*m_Target)) : command.flags;
        if (command.flags == ClearFlag::None)
        {
            return;
        }
        FrameNode& node = Node("a clear");
        if (!m_Started && !m_Viewport)
        {
            AddClear(node, command);
            return;
        }
        node.commands.emplace_back(command);
        m_Started = true;
    }

    void Take(const DrawCommand& command)
    {
        FrameNode& node = Node("a draw");
        const DrawBindings* bindings = m_Tables.Setup(command).bindings.get();
        if (!m_Started || bindings != m_LastBindings)
        {
            ExpectOtherTextures(node, *bindings);
            m_LastBindings = bindings;
        }
        node.commands.emplace_back(command);
        m_Started = true;
    }

    void Take(const DispatchCommand& command)
    {
        ExpectOtherTextures(*m_Tables.Setup(command).bindings);
        FrameNode& node = AddNode();
        node.isCompute = true;
        node.targets.isKept = command.isKept;
        node.targets.generatesMips = command.generatesMips;
        FlushPending();
        node.commands.emplace_back(command);
    }

    void Take(const BeginSampleCommand& command)
    {
        m_Samples.push_back(command);
        m_Pending.emplace_back(command);
        ++m_PendingBegins;
    }

    void Take(const EndSampleCommand& command)
    {
        if (m_Samples.empty())
        {
            throw ContractError("EndSample is called without a BeginSample before it");
        }
        m_Samples.pop_back();
        m_Pending.emplace_back(command);
        m_PendingBegins = std::max(m_PendingBegins - 1, 0);
        if (m_PendingBegins == 0 && !m_Nodes.empty())
        {
            FlushPending();
        }
    }

    /// The node that a draw or clear goes into, begun if need be, with the viewport in effect.
    FrameNode& Node(const char* what)
    {
        if (!m_Target)
        {
            throw ContractError(
                std::string(what) + " was recorded " +
                (m_Samples.empty() ? "" : "in '" + m_Samples.back().name.name() + "' ") +
                "before any render target was set");
        }
        if (!IsOnTarget())
        {
            AddNode().targets = *m_Target;
        }
        SetRenderTargetCommand& targets = m_Nodes.back().targets;
        targets.isKept = targets.isKept || m_Target->isKept;
        targets.generatesMips = targets.generatesMips || m_Target->generatesMips;
        FlushPending();
        if (m_Viewport != m_NodeViewport)
        {
            m_Nodes.back().commands.emplace_back(
                SetViewportCommand{m_Viewport ? *m_Viewport : WholeOf(*m_Target)});
            m_NodeViewport = m_Viewport;
        }
        return m_Nodes.back();
    }

    /// Samples that are open end with the node before and begin anew in this one, so that each node
    /// stands for itself.
    FrameNode& AddNode()
    {
        const auto open = static_cast<std::ptrdiff_t>(m_Samples.size()) - m_PendingBegins;
        if (!m_Nodes.empty())
        {
            auto& commands = m_Nodes.back().commands;
            commands.insert(commands.end(), static_cast<std::size_t>(open), EndSampleCommand{});
        }
        FrameNode& node = m_Nodes.emplace_back();
        node.commands.assign(m_Samples.begin(), m_Samples.begin() + open);
        if (!m_Samples.empty())
        {
            node.name = m_Samples.back().name.name();
        }
        node.place = m_Nodes.size();
        m_NodeViewport.reset();
        m_Started = false;
        return node;
    }

    /// Returns whether the last node draws into what is bound.
    bool IsOnTarget() const
    {
        return m_Target && !m_Nodes.empty() && !m_Nodes.back().isCompute &&
               m_Nodes.back().targets.colors == m_Target->colors &&
               m_Nodes.back().targets.depth == m_Target->depth;
    }

    void FlushPending()
    {
        auto& commands = m_Nodes.back().commands;
        commands.insert(commands.end(), m_Pending.begin(), m_Pending.end());
        m_Pending.clear();
        m_PendingBegins = 0;
    }

    const FrameTables& m_Tables;
    const DrawBindings* m_LastBindings = nullptr; ///< of the last draw
    FrameNodes& m_Nodes;
    const SetRenderTargetCommand* m_Target = nullptr; ///< bound; null = none yet
    bool m_Started = false;                           ///< the last node holds a draw or a clear
    std::optional<ViewportRect> m_Viewport;           ///< as recorded; none = the whole target
    std::optional<ViewportRect> m_NodeViewport;       ///< in effect at the end of the last node
    std::pmr::vector<PassCommand> m_Pending; ///< samples begun, which are the next node's, or empty
    int m_PendingBegins = 0;                 ///< of them, those that have not ended
    std::pmr::vector<BeginSampleCommand> m_Samples; ///< open ones, outermost first
};

} // namespace

void SplitIntoNodes(std::span<const FrameCommand> commands, const FrameTables& tables,
                    FrameNodes& nodes)
{
    NodeSplitter(tables, nodes).Split(commands);
}

} // namespace limn
