#include "graph/RenderGraphRun.h"

#include <algorithm>

namespace limn
{

namespace
{

template <typename T>
bool Has(const PooledVector<T>& list, const T& value)
{
    return std::ranges::find(list, value) != list.end();
}

} // namespace

void BaseCommandBuffer::DrawRendererList(const RendererListHandle& rendererList)
{
    m_Run.DrawRendererList(rendererList);
}

CommandBuffer& BaseCommandBuffer::Globals(ShaderPropertyId id)
{
    m_Run.ExpectGlobalsAllowed("sets the global", id.name());
    return m_Native;
}

void BaseCommandBuffer::SetViewProjectionMatrices(const glm::dmat4& view,
                                                  const glm::mat4& gpuProjection,
                                                  bool setInverseMatrices)
{
    m_Run.ExpectGlobalsAllowed("sets the view and projection matrices");
    m_Native.SetViewProjectionMatrices(view, gpuProjection, setInverseMatrices);
}

void BaseCommandBuffer::SetViewMatrix(const glm::dmat4& view)
{
    m_Run.ExpectGlobalsAllowed("sets the view matrix");
    m_Native.SetViewMatrix(view);
}

void BaseCommandBuffer::SetProjectionMatrix(const glm::dmat4& proj)
{
    m_Run.ExpectGlobalsAllowed("sets the projection matrix");
    m_Native.SetProjectionMatrix(proj);
}

CommandBuffer& detail::NativeOf(BaseCommandBuffer& cmd)
{
    return cmd.m_Native;
}

CommandBuffer& CommandBufferHelpers::GetNativeCommandBuffer(UnsafeCommandBuffer& cmd)
{
    return cmd.native();
}

RTHandle RenderGraphRun::GlobalTexture(const ScriptableRenderContext& context, ShaderPropertyId id)
{
    const ShaderPropertyValue* value = context.m_Globals.Find(id);
    const auto* texture =
        value != nullptr ? std::get_if<std::shared_ptr<const Texture>>(value) : nullptr;
    return texture != nullptr ? RTHandle(std::dynamic_pointer_cast<const RenderTexture>(*texture))
                              : RTHandle();
}

void RenderGraphRun::Run(RenderGraphPass& pass)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    m_Pass = &pass;
    m_Cmd = cmd.get();
    ExpectRunnable();
    ResolveGlobals();
    ExpectWritten();
    Clear();
    const std::size_t first = m_Context.m_Frame.commands.size();
    Bind();
    Record();
    ExpectAsDeclared(first);
    Finish();
}

void RenderGraphRun::ExpectRunnable() const
{
    if (!m_Pass->raster && !m_Pass->unsafe && !m_Pass->compute)
    {
        throw ContractError(Subject() + " has no render function; SetRenderFunc gives it one");
    }
    const auto& colors = m_Pass->colors;
    const auto gap = std::ranges::find(colors, RTHandle());
    const auto behind = std::find_if(gap, colors.end(), [](const RTHandle& c) { return bool(c); });
    if (behind != colors.end())
    {
        throw ContractError(Subject() + " has '" + behind->rt()->name() + "' at index " +
                            std::to_string(behind - colors.begin()) + ", yet nothing at " +
                            std::to_string(gap - colors.begin()) + "; leave no index out");
    }
}

/// What is global now under the names that the pass uses.
void RenderGraphRun::ResolveGlobals()
{
    for (const RenderGraphPass::GlobalUse& global : m_Pass->globalUses)
    {
        const RTHandle texture = GlobalTexture(m_Context, global.id);
        if (!texture)
        {
            throw ContractError(Subject() + ": UseGlobalTexture of '" + global.id.name() +
                                "', but no pass before it made a texture global under that name; "
                                "SetGlobalTextureAfterPass does");
        }
        if (m_Pass->FindUse(texture) == nullptr)
        {
            m_Pass->uses.push_back({texture, global.flags, false});
        }
    }
}

void RenderGraphRun::ExpectWritten() const
{
    for (const RenderGraphPass::Use& use : m_Pass->uses)
    {
        const RenderGraphTexture* texture = m_State.Find(*use.texture.rt());
        const bool holdsNothing = texture != nullptr && texture->isMade && !texture->isWritten &&
                                  texture->owner != m_Pass;
        if (holdsNothing && !use.isAttachment && use.flags == AccessFlags::Read)
        {
            throw ContractError(Subject() + " reads '" + use.texture.rt()->name() +
                                "', which no pass before it writes");
        }
    }
    for (const RenderGraphPass::BufferUse& use : m_Pass->buffers)
    {
        RenderGraphBuffer& buffer = *m_State.Find(*use.buffer);
        if (buffer.isMade && !buffer.isWritten && use.flags == AccessFlags::Read)
        {
            throw ContractError(Subject() + " reads buffer '" + use.buffer->name() +
                                "', which no pass before it writes");
        }
        buffer.isWritten = buffer.isWritten || (use.flags & AccessFlags::Write);
    }
}

/// What is written for the first time.
void RenderGraphRun::Clear()
{
    m_Cmd->BeginSample(m_Pass->name);
    for (RenderGraphTexture& texture : m_State.textures)
    {
        const RenderGraphPass::Use* use = m_Pass->FindUse(texture.texture);
        const bool isOwn = texture.owner == m_Pass;
        const bool writes = isOwn || (use != nullptr && (use->flags & AccessFlags::Write));
        const bool discards = use != nullptr && (use->flags & AccessFlags::Discard);
        if (writes && !discards && !texture.isWritten && texture.clears)
        {
            const bool isDepth = IsDepthFormat(texture.texture.rt()->graphicsFormat());
            CoreUtils::SetRenderTarget(*m_Cmd, texture.texture,
                                       isDepth ? ClearFlag::DepthStencil : ClearFlag::Color,
                                       texture.clearColor);
        }
        texture.isWritten = texture.isWritten || writes;
    }
    m_Context.ExecuteCommandBuffer(*m_Cmd);
    m_Cmd->Clear();
}

void RenderGraphRun::Bind()
{
    const auto& colors = m_Pass->colors;
    const auto count =
        static_cast<std::size_t>(std::ranges::find(colors, RTHandle()) - colors.begin());
    if (count > 0 || m_Pass->depth)
    {
        m_Cmd->SetRenderTarget(std::span<const RTHandle>(colors.data(), count), m_Pass->depth);
    }
}

void RenderGraphRun::Record()
{
    m_DrawnLists.clear();
    m_Context.SetPassName(m_Pass->name);
    if (m_Pass->raster)
    {
        RasterCommandBuffer raster(*m_Cmd, *this);
        m_Pass->raster->Record(raster);
    }
    else if (m_Pass->compute)
    {
        ComputeCommandBuffer compute(*m_Cmd, *this);
        m_Pass->compute->Record(compute);
    }
    else
    {
        UnsafeCommandBuffer unsafe(*m_Cmd, *this);
        m_Pass->unsafe->Record(unsafe);
    }
    Flush();
}

void RenderGraphRun::Flush()
{
    for (const RecordedCommand& command : m_Cmd->commands())
    {
        const auto* global = std::get_if<SetGlobalCommand>(&command);
        const auto* identified = std::get_if<SetGlobalIdentifierCommand>(&command);
        if (const auto* keyword = std::get_if<SetKeywordCommand>(&command))
        {
            ExpectGlobalsAllowed("switches the keyword", keyword->keyword.name());
        }
        if (global != nullptr || identified != nullptr)
        {
            const ShaderPropertyId id = global != nullptr ? global->id : identified->id;
            ExpectGlobalsAllowed("sets the global", id.name());
        }
    }
    m_Context.ExecuteCommandBuffer(*m_Cmd);
    m_Cmd->Clear();
}

void RenderGraphRun::ExpectGlobalsAllowed(std::string_view what, std::string_view name) const
{
    if (!m_Pass->allowsGlobalState)
    {
        const std::string quoted = name.empty() ? "" : " '" + std::string(name) + "'";
        throw ContractError(Subject() + " " + std::string(what) + quoted +
                            ", yet declares no AllowGlobalStateModification(true)");
    }
}

void RenderGraphRun::DrawRendererList(const RendererListHandle& list)
{
    const std::size_t index =
        m_Graph.IndexOf(list, {"pass '", m_Pass->name.name(), "': DrawRendererList"});
    if (!Has(m_Pass->rendererLists, index))
    {
        throw ContractError(Subject() +
                            " declares no UseRendererList of a renderer list, yet draws it");
    }
    m_DrawnLists.push_back(index);
    Flush();
    const RendererListParams& params = m_State.rendererLists[index];
    m_Context.DrawRenderers(*params.cullingResults, params.drawSettings, params.filteringSettings,
                            params.stateBlock);
}

void RenderGraphRun::ExpectAsDeclared(std::size_t firstCommand)
{
    m_Sampled.clear();
    m_Targets.clear();
    m_Buffers.clear();
    const bool isKept = !m_Pass->allowsCulling || m_Pass->allowsGlobalState;
    const SetRenderTargetCommand* target = nullptr;
    const DrawBindings* last = nullptr;
    auto& commands = m_Context.m_Frame.commands;
    for (std::size_t i = firstCommand; i < commands.size(); ++i)
    {
        if (auto* bound = std::get_if<SetRenderTargetCommand>(&commands[i]))
        {
            bound->isKept = isKept;
            target = bound;
            continue;
        }
        if (auto* dispatch = std::get_if<DispatchCommand>(&commands[i]))
        {
            dispatch->isKept = isKept;
            last = m_Context.m_Frame.Setup(*dispatch).bindings.get();
            ExpectReads(*last);
            ExpectWrites(*last);
            ExpectBuffers(*last);
            continue;
        }
        const auto* draw = std::get_if<DrawCommand>(&commands[i]);
        if (draw == nullptr && !std::holds_alternative<ClearCommand>(commands[i]))
        {
            continue;
        }
        ExpectTarget(target);
        const DrawBindings* bindings =
            draw != nullptr ? m_Context.m_Frame.Setup(*draw).bindings.get() : last;
        if (bindings != last)
        {
            last = bindings;
            ExpectReads(*bindings);
            ExpectBuffers(*bindings);
        }
    }
    NoteUnused(last != nullptr);
    NoteUnusedBuffers();
}

void RenderGraphRun::ExpectTarget(const SetRenderTargetCommand* target)
{
    if (target == nullptr)
    {
        throw ContractError(Subject() + (m_Pass->raster
                                             ? " draws, yet declares no SetRenderAttachment"
                                             : " draws before it sets a render target"));
    }
    const auto expect = [&](const std::shared_ptr<const RenderTexture>& texture)
    {
        if (!texture || Has<const Texture*>(m_Targets, texture.get()))
        {
            return;
        }
        m_Targets.push_back(texture.get());
        const RenderGraphTexture* known = m_State.Find(*texture);
        const RenderGraphPass::Use* use = m_Pass->FindUse(RTHandle(texture));
        const bool isDeclared =
            use != nullptr && (use->isAttachment || use->flags & AccessFlags::Write);
        if (known != nullptr && known->owner != m_Pass && !isDeclared)
        {
            throw ContractError(Subject() + " declares no write of '" + texture->name() +
                                "', yet draws into it; UseTexture(…, AccessFlags::Write) "
                                "declares it");
        }
    };
    std::ranges::for_each(target->colors, expect);
    expect(target->depth);
}

void RenderGraphRun::ExpectWrites(const DrawBindings& bindings)
{
    for (const StorageTextureSlot& slot : bindings.storageTextures)
    {
        const RenderGraphTexture* known = m_State.Find(*slot.texture);
        m_Targets.push_back(slot.texture.get());
        if (known != nullptr && known->owner != m_Pass &&
            !m_Pass->Declares(known->texture, AccessFlags::Write))
        {
            throw ContractError(Subject() + " declares no write of '" + slot.texture->name() +
                                "', yet a kernel may write to it; UseTexture(…, "
                                "AccessFlags::Write) declares it");
        }
    }
}

void RenderGraphRun::ExpectBuffers(const DrawBindings& bindings)
{
    for (const BufferSlot& slot : bindings.buffers)
    {
        m_Buffers.push_back(slot.buffer.get());
        if (m_State.Find(*slot.buffer) == nullptr)
        {
            continue;
        }
        const RenderGraphPass::BufferUse* use = m_Pass->FindUse(*slot.buffer);
        const AccessFlags wanted = slot.isWritten ? AccessFlags::Write : AccessFlags::Read;
        if (use == nullptr || !(use->flags & wanted))
        {
            throw ContractError(Subject() + " declares no " + (slot.isWritten ? "write" : "read") +
                                " of buffer '" + slot.buffer->name() + "', yet " +
                                (slot.isWritten ? "a kernel may write to it" : "reads it") +
                                "; UseBuffer declares it");
        }
    }
}

void RenderGraphRun::ExpectReads(const DrawBindings& bindings)
{
    for (const TextureSlot& slot : bindings.textures)
    {
        const Texture* texture = slot.texture.get();
        if (Has(m_Sampled, texture))
        {
            continue;
        }
        m_Sampled.push_back(texture);
        const RenderGraphTexture* known = m_State.Find(*texture);
        if (known == nullptr || known->owner == m_Pass || m_Pass->usesAllGlobals)
        {
            continue;
        }
        const RenderGraphPass::Use* use = m_Pass->FindUse(known->texture);
        if (use == nullptr || (!use->isAttachment && !(use->flags & AccessFlags::Read)))
        {
            throw ContractError(Subject() + " declares no read of '" + texture->name() +
                                "', yet samples it; UseTexture declares it");
        }
    }
}

/// What is declared for nothing.
void RenderGraphRun::NoteUnused(bool draws)
{
    std::vector<std::string>& notes = m_Report.notes;
    const auto isDrawn = [&](std::size_t list)
    {
        return Has(m_DrawnLists, list);
    };
    if (!std::ranges::all_of(m_Pass->rendererLists, isDrawn))
    {
        notes.push_back(Subject() + " declares UseRendererList of a list that it does not draw");
    }
    for (const RenderGraphPass::Use& use : m_Pass->uses)
    {
        const Texture* texture = use.texture.rt().get();
        const bool isRead = Has(m_Sampled, texture);
        const bool isWritten = Has(m_Targets, texture);
        if (!use.isAttachment && (use.flags & AccessFlags::Read) && draws && !isRead && !isWritten)
        {
            notes.push_back(Subject() + " declares a read of '" + texture->name() +
                            "', yet samples it nowhere");
        }
        // Of a list there may be nothing to draw.
        if ((use.flags & AccessFlags::Write) && !isWritten && !isRead && m_DrawnLists.empty())
        {
            notes.push_back(Subject() + " declares a write of '" + texture->name() +
                            "', yet draws nothing into it");
        }
    }
}

void RenderGraphRun::NoteUnusedBuffers()
{
    for (const RenderGraphPass::BufferUse& use : m_Pass->buffers)
    {
        if (!Has(m_Buffers, use.buffer.get()))
        {
            m_Report.notes.push_back(Subject() + " declares a use of buffer '" +
                                     use.buffer->name() + "', yet uses it nowhere");
        }
    }
}

void RenderGraphRun::Finish()
{
    for (const RenderGraphPass::GlobalAfter& global : m_Pass->globalsAfter)
    {
        m_Cmd->SetGlobalTexture(global.id, global.texture);
    }
    m_Cmd->DisableScissorRect();
    m_Cmd->SetInvertCulling(false);
    m_Cmd->SetGlobalDepthBias(0.0f, 0.0f);
    m_Cmd->EndSample();
    m_Context.ExecuteCommandBuffer(*m_Cmd);
}

} // namespace limn
