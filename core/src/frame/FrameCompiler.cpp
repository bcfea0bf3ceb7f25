#include "draw/UnusedStencil.h"
#include "frame/PassSplitter.h"

#include <algorithm>
#include <limn/core/FrameCompiler.h>

namespace limn
{

namespace
{

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
        const auto is = [&](const auto& other)
        {
            return other.get() == &texture;
        };
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
        const bool onlyReads =
            usage == TextureUsage::ShaderRead || usage == TextureUsage::CopySource;
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
    std::vector<OpenPass> passes = SplitIntoPasses(std::move(commands.commands));
    LeaveOutUnusedStencil(passes, outputs, m_DepthTwins);
    Run run(*this, std::move(passes), outputs);
    CompiledFrame frame;
    frame.passes = run.Passes();
    frame.finalBarriers = run.FinalBarriers();
    run.ForgetTransientContents();
    frame.uniformData = std::move(commands.uniformData);
    frame.perDraw = std::move(commands.perDraw);
    return frame;
}

} // namespace limn
