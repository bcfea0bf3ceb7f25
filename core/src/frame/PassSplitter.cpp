#include "frame/PassSplitter.h"

#include <algorithm>
#include <limn/core/DrawError.h>
#include <limn/shaderlab/Diagnostic.h>

namespace limn
{

namespace
{

ViewportRect WholeOf(const SetRenderTargetCommand& target)
{
    const RenderTexture& any = target.colors.empty() ? *target.depth : *target.colors.front();
    return {0, 0, any.width(), any.height()};
}

/// Adds a clear to those that the pass begins with.
void MergeClear(std::optional<ClearCommand>& clear, const ClearCommand& command)
{
    if (!clear)
    {
        clear = command;
        return;
    }
    if (command.flags & ClearFlag::Color)
    {
        clear->color = command.color;
    }
    if (command.flags & ClearFlag::Depth)
    {
        clear->depth = command.depth;
    }
    if (command.flags & ClearFlag::Stencil)
    {
        clear->stencil = command.stencil;
    }
    clear->flags = clear->flags | command.flags;
}

void AddRead(OpenPass& pass, const std::shared_ptr<const Texture>& texture)
{
    if (dynamic_cast<const RenderTexture*>(texture.get()) == nullptr)
    {
        return; // contents come from the CPU: nothing to wait for
    }
    const auto& colors = pass.targets.colors;
    if (texture == pass.targets.depth ||
        std::find(colors.begin(), colors.end(), texture) != colors.end())
    {
        throw DrawError("pass '" + pass.name + "' samples '" + texture->name() +
                        "' while drawing into it; draw into another texture and copy");
    }
    if (std::find(pass.reads.begin(), pass.reads.end(), texture) == pass.reads.end())
    {
        pass.reads.push_back(texture);
    }
}

class PassSplitter
{
public:
    std::vector<OpenPass> Split(std::vector<FrameCommand> commands)
    {
        for (FrameCommand& command : commands)
        {
            std::visit([&](auto& c) { Take(c); }, command);
        }
        for (; !m_Samples.empty(); m_Samples.pop_back())
        {
            m_Pending.emplace_back(EndSampleCommand{});
        }
        if (!m_Passes.empty())
        {
            FlushPending();
        }
        return std::move(m_Passes);
    }

private:
    void Take(SetRenderTargetCommand& command)
    {
        m_Target = std::move(command);
        m_Viewport.reset();
    }

    void Take(const SetViewportCommand& command) { m_Viewport = command.rect; }

    void Take(const ClearCommand& command)
    {
        if (command.flags == ClearFlag::None)
        {
            return;
        }
        OpenPass& pass = Pass("a clear");
        if (!m_Started && !m_Viewport)
        {
            MergeClear(pass.clear, command);
            return;
        }
        pass.commands.emplace_back(command);
        m_Started = true;
    }

    void Take(DrawCommand& command)
    {
        OpenPass& pass = Pass("a draw");
        for (const TextureSlot& slot : command.bindings->textures)
        {
            AddRead(pass, slot.texture);
        }
        pass.commands.emplace_back(std::move(command));
        m_Started = true;
    }

    void Take(const BeginSampleCommand& command)
    {
        m_Samples.push_back(command.name);
        Place(command);
    }

    void Take(const EndSampleCommand& command)
    {
        if (m_Samples.empty())
        {
            throw ContractError("EndSample without a BeginSample before it");
        }
        m_Samples.pop_back();
        Place(command);
    }

    void Place(const PassCommand& sample)
    {
        m_Pending.push_back(sample);
        if (IsOnTarget())
        {
            FlushPending();
        }
    }

    /// The pass that a draw or clear goes into, begun if need be, with the viewport in effect.
    OpenPass& Pass(const char* what)
    {
        if (!m_Target)
        {
            throw ContractError(std::string(what) + " was recorded " +
                                (m_Samples.empty() ? "" : "in '" + m_Samples.back() + "' ") +
                                "before any render target was set");
        }
        if (!IsOnTarget())
        {
            OpenPass& pass = m_Passes.emplace_back();
            pass.name = m_Samples.empty() ? std::string() : m_Samples.back();
            pass.targets = *m_Target;
            m_PassViewport.reset();
            m_Started = false;
        }
        FlushPending();
        if (m_Viewport != m_PassViewport)
        {
            m_Passes.back().commands.emplace_back(
                SetViewportCommand{m_Viewport ? *m_Viewport : WholeOf(*m_Target)});
            m_PassViewport = m_Viewport;
        }
        return m_Passes.back();
    }

    /// Whether the last pass draws into what is bound.
    bool IsOnTarget() const
    {
        return m_Target && !m_Passes.empty() &&
               m_Passes.back().targets.colors == m_Target->colors &&
               m_Passes.back().targets.depth == m_Target->depth;
    }

    void FlushPending()
    {
        auto& commands = m_Passes.back().commands;
        commands.insert(commands.end(), std::make_move_iterator(m_Pending.begin()),
                        std::make_move_iterator(m_Pending.end()));
        m_Pending.clear();
    }

    std::vector<OpenPass> m_Passes;
    std::optional<SetRenderTargetCommand> m_Target;
    bool m_Started = false;                     ///< the last pass holds a draw or a clear
    std::optional<ViewportRect> m_Viewport;     ///< as recorded; none = the whole target
    std::optional<ViewportRect> m_PassViewport; ///< in effect at the end of the last pass
    std::vector<PassCommand> m_Pending;         ///< samples begun or ended between passes
    std::vector<std::string> m_Samples;         ///< open ones, outermost first
};

} // namespace

std::vector<OpenPass> SplitIntoPasses(std::vector<FrameCommand> commands)
{
    return PassSplitter().Split(std::move(commands));
}

} // namespace limn
