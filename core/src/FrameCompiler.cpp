#include <algorithm>
#include <limn/core/FrameCompiler.h>
#include <limn/shaderlab/Diagnostic.h>

namespace limn
{

namespace
{

/// A pass before load, store and barriers are decided.
struct OpenPass
{
    std::string name;
    SetRenderTargetCommand targets;
    std::optional<ClearCommand> clear; ///< everything cleared before the first draw, together
    std::vector<PassCommand> commands;
    std::vector<std::shared_ptr<const Texture>> reads; ///< render textures sampled; no duplicates
};

bool SameTargets(const SetRenderTargetCommand& a, const SetRenderTargetCommand& b)
{
    return a.colors == b.colors && a.depth == b.depth;
}

/// Splits the command list into passes.
class PassSplitter
{
public:
    std::vector<OpenPass> Split(std::vector<FrameCommand> commands)
    {
        for (FrameCommand& command : commands)
        {
            std::visit([&](auto& c) { Take(c); }, command);
        }
        // What is left over after the last pass are ends of samples.
        if (!m_Passes.empty())
        {
            Append(m_Passes.back().commands, m_Pending);
        }
        return std::move(m_Passes);
    }

private:
    void Take(SetRenderTargetCommand& command)
    {
        if (m_Open && SameTargets(m_Passes.back().targets, command))
        {
            if (m_ViewportSet)
            {
                const RenderTexture& any = *AnyTarget(command);
                m_Passes.back().commands.emplace_back(
                    SetViewportCommand{{0, 0, any.width(), any.height()}});
            }
        }
        else
        {
            m_Open = false;
        }
        m_Target = std::move(command);
        m_ViewportSet = false;
        m_PendingViewport.reset();
    }

    void Take(const SetViewportCommand& command)
    {
        m_ViewportSet = true;
        if (m_Open)
        {
            m_Passes.back().commands.emplace_back(command);
        }
        else
        {
            m_PendingViewport = command;
        }
    }

    void Take(const ClearCommand& command)
    {
        OpenPass& pass = Pass("a clear");
        const bool drawnBefore = m_DrawnInPass || m_ViewportSet;
        if (drawnBefore)
        {
            pass.commands.emplace_back(command);
            return;
        }
        if (!pass.clear)
        {
            pass.clear = command;
            return;
        }
        if (command.flags & ClearFlag::Color)
        {
            pass.clear->color = command.color;
        }
        if (command.flags & ClearFlag::Depth)
        {
            pass.clear->depth = command.depth;
        }
        if (command.flags & ClearFlag::Stencil)
        {
            pass.clear->stencil = command.stencil;
        }
        pass.clear->flags = pass.clear->flags | command.flags;
    }

    void Take(DrawCommand& command)
    {
        OpenPass& pass = Pass("a draw");
        for (const TextureSlot& slot : command.bindings->textures)
        {
            AddRead(pass, slot.texture);
        }
        m_DrawnInPass = true;
        pass.commands.emplace_back(std::move(command));
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

    template <typename Command>
    void Place(const Command& command)
    {
        (m_Open ? m_Passes.back().commands : m_Pending).emplace_back(command);
    }

    /// The pass that a draw or clear goes into, begun if need be.
    OpenPass& Pass(const char* what)
    {
        if (!m_Target)
        {
            throw ContractError(std::string(what) + " was recorded " +
                                (m_Samples.empty() ? "" : "in '" + m_Samples.back() + "' ") +
                                "before any render target was set");
        }
        if (!m_Open)
        {
            OpenPass pass;
            pass.name = m_Samples.empty() ? std::string() : m_Samples.back();
            pass.targets = *m_Target;
            Append(pass.commands, m_Pending);
            if (m_PendingViewport)
            {
                pass.commands.emplace_back(*m_PendingViewport);
            }
            m_Passes.push_back(std::move(pass));
            m_Open = true;
            m_DrawnInPass = false;
        }
        return m_Passes.back();
    }

    static void AddRead(OpenPass& pass, const std::shared_ptr<const Texture>& texture)
    {
        if (dynamic_cast<const RenderTexture*>(texture.get()) == nullptr)
        {
            return; // contents come from the CPU: nothing to wait for
        }
        const auto& targets = pass.targets;
        if (texture == targets.depth || std::find(targets.colors.begin(), targets.colors.end(),
                                                  texture) != targets.colors.end())
        {
            throw ContractError("pass '" + pass.name + "' samples '" + texture->name() +
                                "' while drawing into it; draw into another texture and copy");
        }
        if (std::find(pass.reads.begin(), pass.reads.end(), texture) == pass.reads.end())
        {
            pass.reads.push_back(texture);
        }
    }

    static void Append(std::vector<PassCommand>& to, std::vector<PassCommand>& from)
    {
        to.insert(to.end(), std::make_move_iterator(from.begin()),
                  std::make_move_iterator(from.end()));
        from.clear();
    }

    static const RenderTexture* AnyTarget(const SetRenderTargetCommand& target)
    {
        return target.colors.empty() ? target.depth.get() : target.colors.front().get();
    }

    std::vector<OpenPass> m_Passes;
    std::optional<SetRenderTargetCommand> m_Target;
    bool m_Open = false; ///< the last pass is on m_Target and still grows
    bool m_DrawnInPass = false;
    bool m_ViewportSet = false;
    std::optional<SetViewportCommand> m_PendingViewport;
    std::vector<PassCommand> m_Pending; ///< samples begun or ended between passes
    std::vector<std::string> m_Samples;
};

bool Clears(const OpenPass& pass, ClearFlag flag)
{
    return pass.clear && (pass.clear->flags & flag);
}

/// How a texture's next appearance treats what is in it.
enum class NextUse
{
    None,
    Needs,
    Overwrites
};

NextUse FindNextUse(const std::vector<OpenPass>& passes, std::size_t from, const Texture& texture,
                    ClearFlag aspect)
{
    for (std::size_t i = from; i < passes.size(); ++i)
    {
        const OpenPass& pass = passes[i];
        const auto is = [&](const auto& other) { return other.get() == &texture; };
        if (std::any_of(pass.reads.begin(), pass.reads.end(), is))
        {
            return NextUse::Needs;
        }
        const auto& targets = pass.targets;
        if (is(targets.depth) || std::any_of(targets.colors.begin(), targets.colors.end(), is))
        {
            return Clears(pass, aspect) ? NextUse::Overwrites : NextUse::Needs;
        }
    }
    return NextUse::None;
}

} // namespace

/// One Compile call.
class FrameCompiler::Run
{
public:
    Run(FrameCompiler& compiler, std::vector<OpenPass> passes,
        std::span<const std::shared_ptr<const RenderTexture>> outputs)
        : m_Compiler(compiler), m_Passes(std::move(passes)), m_Outputs(outputs)
    {
    }

    std::vector<CompiledRenderPass> Passes()
    {
        std::vector<CompiledRenderPass> result;
        for (std::size_t i = 0; i < m_Passes.size(); ++i)
        {
            result.push_back(CompilePass(i));
        }
        return result;
    }

    std::vector<TextureBarrier> FinalBarriers()
    {
        std::vector<TextureBarrier> barriers;
        for (const auto& output : m_Outputs)
        {
            Transition(output, TextureUsage::CopySource, barriers);
        }
        return barriers;
    }

    void ForgetTransientContents()
    {
        for (auto& [id, known] : m_Compiler.m_Known)
        {
            const auto texture = known.texture.lock();
            const auto* target = dynamic_cast<const RenderTexture*>(texture.get());
            if (target != nullptr && target->isTransient())
            {
                m_Compiler.m_Filled.erase(id);
            }
        }
    }

private:
    CompiledRenderPass CompilePass(std::size_t index)
    {
        OpenPass& pass = m_Passes[index];
        CompiledRenderPass result;
        result.name = pass.name;
        for (const auto& texture : pass.reads)
        {
            Transition(texture, TextureUsage::ShaderRead, result.barriers);
        }
        for (const auto& texture : pass.targets.colors)
        {
            result.colors.push_back(Color(index, texture, result.barriers));
            result.width = texture->width();
            result.height = texture->height();
        }
        if (const auto& depth = pass.targets.depth)
        {
            result.depth = Depth(index, depth, result.barriers);
            result.width = depth->width();
            result.height = depth->height();
        }
        result.commands = std::move(pass.commands);
        return result;
    }

    ColorAttachment Color(std::size_t index, const std::shared_ptr<const RenderTexture>& texture,
                          std::vector<TextureBarrier>& barriers)
    {
        ColorAttachment attachment;
        attachment.texture = texture;
        attachment.load = Load(m_Passes[index], *texture, ClearFlag::Color);
        attachment.store = Store(index, *texture, ClearFlag::Color);
        if (attachment.load == LoadOp::Clear)
        {
            attachment.clearColor = m_Passes[index].clear->color;
        }
        Transition(texture, TextureUsage::ColorAttachment, barriers);
        m_Compiler.m_Filled.insert(texture->id());
        return attachment;
    }

    DepthAttachment Depth(std::size_t index, const std::shared_ptr<const RenderTexture>& texture,
                          std::vector<TextureBarrier>& barriers)
    {
        const OpenPass& pass = m_Passes[index];
        DepthAttachment attachment;
        attachment.texture = texture;
        attachment.load = Load(pass, *texture, ClearFlag::Depth);
        attachment.store = Store(index, *texture, ClearFlag::Depth);
        attachment.stencilLoad = Load(pass, *texture, ClearFlag::Stencil);
        attachment.stencilStore = Store(index, *texture, ClearFlag::Stencil);
        if (pass.clear)
        {
            attachment.clearDepth = pass.clear->depth;
            attachment.clearStencil = pass.clear->stencil;
        }
        Transition(texture, TextureUsage::DepthStencilAttachment, barriers);
        m_Compiler.m_Filled.insert(texture->id());
        return attachment;
    }

    LoadOp Load(const OpenPass& pass, const Texture& texture, ClearFlag aspect) const
    {
        if (Clears(pass, aspect))
        {
            return LoadOp::Clear;
        }
        return m_Compiler.m_Filled.contains(texture.id()) ? LoadOp::Load : LoadOp::DontCare;
    }

    StoreOp Store(std::size_t index, const RenderTexture& texture, ClearFlag aspect) const
    {
        switch (FindNextUse(m_Passes, index + 1, texture, aspect))
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
        return isOutput || !texture.isTransient() ? StoreOp::Store : StoreOp::DontCare;
    }

    void Transition(const std::shared_ptr<const Texture>& texture, TextureUsage usage,
                    std::vector<TextureBarrier>& barriers)
    {
        KnownTexture& known = m_Compiler.m_Known[texture->id()];
        known.texture = texture;
        const bool onlyReads = usage == TextureUsage::ShaderRead || usage == TextureUsage::CopySource;
        if (known.usage == usage && onlyReads)
        {
            return;
        }
        barriers.push_back({texture, known.usage, usage});
        known.usage = usage;
    }

    FrameCompiler& m_Compiler;
    std::vector<OpenPass> m_Passes;
    std::span<const std::shared_ptr<const RenderTexture>> m_Outputs;
};

CompiledFrame FrameCompiler::Compile(FrameCommands commands,
                                     std::span<const std::shared_ptr<const RenderTexture>> outputs)
{
    std::erase_if(m_Known,
                  [&](const auto& entry)
                  {
                      const bool gone = entry.second.texture.expired();
                      if (gone)
                      {
                          m_Filled.erase(entry.first);
                      }
                      return gone;
                  });
    Run run(*this, PassSplitter().Split(std::move(commands.commands)), outputs);
    CompiledFrame frame;
    frame.passes = run.Passes();
    frame.finalBarriers = run.FinalBarriers();
    run.ForgetTransientContents();
    frame.uniformData = std::move(commands.uniformData);
    frame.perDraw = std::move(commands.perDraw);
    return frame;
}

} // namespace limn
