#include "graph/RenderGraphRun.h"

#include "material/PropertyValues.h"
#include "record/RecordedCommands.h"
#include "resolve/DrawRecorder.h"

#include <algorithm>
#include <limn/base/Lists.h>
#include <utility>

namespace limn
{

void BaseCommandBuffer::DrawRendererList(const RendererListHandle& rendererList)
{
    m_Run.DrawRendererList(rendererList);
}

CommandBuffer& BaseCommandBuffer::Globals(ShaderPropertyId id)
{
    m_Run.ExpectGlobalsAllowed("sets the global", id.name());
    return *this;
}

void BaseCommandBuffer::SetKeyword(const GlobalKeyword& keyword, bool value)
{
    m_Run.ExpectGlobalsAllowed("switches the keyword", keyword.name());
    CommandBuffer::SetKeyword(keyword, value);
}

void BaseCommandBuffer::SetGlobalTexture(ShaderPropertyId id, const RTHandle& value)
{
    m_Run.ExpectDeclared(value, id);
    Globals(id).SetGlobalTexture(id, value);
}

void BaseCommandBuffer::SetViewProjectionMatrices(const glm::dmat4& view,
                                                  const glm::mat4& gpuProjection,
                                                  bool setInverseMatrices)
{
    m_Run.ExpectGlobalsAllowed("sets the view and projection matrices");
    CommandBuffer::SetViewProjectionMatrices(view, gpuProjection, setInverseMatrices);
}

void BaseCommandBuffer::SetViewMatrix(const glm::dmat4& view)
{
    m_Run.ExpectGlobalsAllowed("sets the view matrix");
    CommandBuffer::SetViewMatrix(view);
}

void BaseCommandBuffer::SetProjectionMatrix(const glm::dmat4& proj)
{
    m_Run.ExpectGlobalsAllowed("sets the projection matrix");
    CommandBuffer::SetProjectionMatrix(proj);
}

AnyCommandBuffer::AnyCommandBuffer(BaseCommandBuffer& cmd) : m_Cmd(cmd) {}

ProfilingScope::ProfilingScope(BaseCommandBuffer& cmd, const ProfilingSampler& sampler)
    : ProfilingScope(static_cast<CommandBuffer&>(cmd), sampler)
{
}

ProfilingScope::ProfilingScope(ComputeCommandBuffer& cmd, const ProfilingSampler& sampler)
    : ProfilingScope(static_cast<CommandBuffer&>(cmd), sampler)
{
}

CommandBuffer& CommandBufferHelpers::GetNativeCommandBuffer(UnsafeCommandBuffer& cmd)
{
    return AnyCommandBuffer(cmd);
}

RTHandle RenderGraphRun::GlobalTexture(const ScriptableRenderContext& context, ShaderPropertyId id)
{
    return RTHandle(std::dynamic_pointer_cast<const RenderTexture>(
        CopyOf<std::shared_ptr<const Texture>>(context.m_Recorder->globals().Find(id))));
}

void RenderGraphRun::Run(RenderGraphPass& pass)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    m_Pass = &pass;
    m_Cmd = cmd.get();
    m_Problems.clear();
    m_RefusedGlobals.clear();
    m_HasEffect = false;
    m_SetHere.clear();
    m_LineToBeRun.clear();
    ExpectRunnable();
    ResolveGlobals();
    ExpectWritten();
    Clear();
    const std::size_t first = m_Context.m_Frame.commands.size();
    Bind();
    Record();
    ExpectAsDeclared(first);
    ThrowIfProblems();
    Finish();
}

void RenderGraphRun::ExpectRunnable() const
{
    if (!std::visit([](const auto& function) { return function != nullptr; }, m_Pass->function))
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

/// Clears the textures that the pass writes first, or reads although nothing has written them.
void RenderGraphRun::Clear()
{
    m_Cmd->BeginSample(m_Pass->name);
    for (RenderGraphTexture& texture : m_State.textures)
    {
        const RenderGraphPass::Use* use = m_Pass->FindUse(texture.texture);
        const bool isOwn = texture.owner == m_Pass;
        const bool writes = isOwn || (use != nullptr && (use->flags & AccessFlags::Write));
        const bool discards = use != nullptr && (use->flags & AccessFlags::Discard);
        const bool reads = use != nullptr && texture.isMade;
        if ((writes || reads) && !discards && !texture.isWritten && texture.clears)
        {
            const bool isDepth = IsDepthFormat(texture.texture.rt()->graphicsFormat());
            CoreUtils::SetRenderTarget(*m_Cmd, texture.texture,
                                       isDepth ? ClearFlag::DepthStencil : ClearFlag::Color,
                                       texture.clearColor);
            texture.isWritten = true;
        }
        texture.isWritten = texture.isWritten || writes;
    }
    m_Context.ExecuteCommandBuffer(*m_Cmd);
    m_Cmd->Clear();
}

void RenderGraphRun::Bind()
{
    for (const RenderGraphPass::GlobalTexture& input : m_Pass->inputs)
    {
        m_Cmd->SetGlobalTexture(input.id, input.texture);
    }
    if (!m_Pass->inputs.empty())
    {
        m_Context.ExecuteCommandBuffer(*m_Cmd);
        m_Cmd->Clear();
    }
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
    const auto record =
        [this]<typename Buffer>(const std::shared_ptr<RenderGraphFunction<Buffer>>& function)
    {
        Buffer buffer(std::move(*m_Cmd), *this); // with the memory of the pooled one
        CommandBuffer& native = buffer;
        CommandBuffer* const pooled = std::exchange(m_Cmd, &native);
        function->Record(buffer);
        Flush();
        *pooled = std::move(native);
        m_Cmd = pooled;
    };
    std::visit(record, m_Pass->function);
}

void RenderGraphRun::Flush()
{
    for (const RecordedCommand& command : m_Cmd->commands())
    {
        const auto* global = std::get_if<SetGlobalCommand>(&command);
        const auto* identified = std::get_if<SetGlobalIdentifierCommand>(&command);
        const auto* keyword = std::get_if<SetKeywordCommand>(&command);
        if (global != nullptr || identified != nullptr || keyword != nullptr)
        {
            m_HasEffect = true;
            if (keyword == nullptr)
            {
                m_SetHere.push_back(global != nullptr ? global->id : identified->id);
            }
            NoteNativeGlobal(keyword != nullptr  ? keyword->keyword.name()
                             : global != nullptr ? std::string_view(global->id.name())
                                                 : std::string_view(identified->id.name()));
        }
    }
    m_Context.ExecuteCommandBuffer(*m_Cmd);
    m_Cmd->Clear();
}

void RenderGraphRun::DrawRendererList(const RendererListHandle& list)
{
    const std::size_t index =
        m_Graph.IndexOf(list, {"pass '", m_Pass->name.name(), "': DrawRendererList"});
    if (!Has(m_Pass->rendererLists, index))
    {
        Fail(Subject() + " draws a renderer list without declaring it by UseRendererList, so that "
                         "Unity would draw nothing; add builder.UseRendererList(<its handle>);");
    }
    m_DrawnLists.push_back(index);
    Flush();
    const RendererListParams& params = m_State.rendererLists[index];
    m_Context.DrawRenderers(*params.cullingResults, params.drawSettings, params.filteringSettings,
                            params.stateBlock);
}

void RenderGraphRun::Finish()
{
    for (const RenderGraphPass::GlobalTexture& global : m_Pass->globalsAfter)
    {
        m_Cmd->SetGlobalTexture(global.id, global.texture);
    }
    m_Cmd->DisableScissorRect();
    m_Cmd->SetInvertCulling(false);
    m_Cmd->SetGlobalDepthBias(0.0f, 0.0f);
    m_Cmd->EndSample();
    m_Context.ExecuteCommandBuffer(*m_Cmd);
}

void RenderGraphRun::Fail(std::string problem)
{
    AddOnce(problem, m_Problems);
}

void RenderGraphRun::NoteOrFail(bool isDrawnRight, const std::string& what, const char* otherwise,
                                const std::string& line)
{
    if (isDrawnRight)
    {
        m_Report.notes.push_back(what + "; " + line + " declares it");
    }
    else
    {
        Fail(what + otherwise + "; add " + line);
    }
}

void RenderGraphRun::ThrowIfProblems()
{
    if (m_Problems.empty())
    {
        return;
    }
    std::string text;
    for (const std::string& problem : m_Problems)
    {
        text += (text.empty() ? "" : "\n") + problem;
    }
    throw ContractError(text);
}

std::string RenderGraphRun::LineFor(const RenderGraphTexture& texture, AccessFlags flags)
{
    const std::string handle = texture.handle.empty()
                                   ? "<handle of '" + texture.texture.rt()->name() + "'>"
                                   : std::string(texture.handle);
    return "builder.UseTexture(" + handle +
           (flags == AccessFlags::Read    ? ""
            : flags == AccessFlags::Write ? ", AccessFlags::Write"
                                          : ", AccessFlags::ReadWrite") +
           ");";
}

std::string RenderGraphRun::LineFor(const GraphicsBuffer& buffer, AccessFlags flags)
{
    return "builder.UseBuffer(<handle of '" + buffer.name() + "'>" +
           (flags == AccessFlags::Read ? "" : ", AccessFlags::ReadWrite") + ");";
}

bool RenderGraphRun::wasGlobal(const Texture& texture) const
{
    bool wasGlobal = false;
    m_Context.m_Recorder->globals().ForEach(
        [&](ShaderPropertyId id, const ShaderPropertyValue& value)
        {
            const auto* held = std::get_if<std::shared_ptr<const Texture>>(&value);
            const bool isIt = held != nullptr && held->get() == &texture;
            wasGlobal = wasGlobal || (isIt && !Has(m_SetHere, id));
        });
    return wasGlobal;
}

template <typename Resource>
bool RenderGraphRun::isDeclaredLater(const Resource& resource) const
{
    const auto later = m_State.passes.begin() + static_cast<std::ptrdiff_t>(m_State.ran) + 1;
    return std::any_of(later, m_State.passes.end(),
                       [&](const auto& pass) { return pass.FindUse(resource) != nullptr; });
}

bool RenderGraphRun::isAlive(const RenderGraphTexture& texture) const
{
    return !texture.isMade || (texture.isWritten && isDeclaredLater(texture.texture));
}

bool RenderGraphRun::isAlive(const RenderGraphBuffer& buffer) const
{
    return !buffer.isMade || (buffer.isWritten && isDeclaredLater(*buffer.buffer));
}

/// Adds the textures that are global now under the names that the pass uses.
void RenderGraphRun::ResolveGlobals()
{
    for (const RenderGraphPass::GlobalUse& global : m_Pass->globalUses)
    {
        const RTHandle texture = GlobalTexture(m_Context, global.id);
        if (!texture)
        {
            Fail(Subject() + ": UseGlobalTexture names '" + global.id.name() +
                 "', but no pass before it made a texture global under that name; call "
                 "SetGlobalTextureAfterPass in such a pass");
        }
        else if (m_Pass->FindUse(texture) == nullptr)
        {
            m_Pass->uses.push_back({texture, global.flags, false});
        }
    }
}

void RenderGraphRun::ExpectWritten()
{
    for (const RenderGraphPass::Use& use : m_Pass->uses)
    {
        const RenderGraphTexture* texture = m_State.Find(*use.texture.rt());
        const bool holdsNothing = texture != nullptr && texture->isMade && !texture->isWritten &&
                                  texture->owner != m_Pass;
        if (!holdsNothing || use.isAttachment || use.flags != AccessFlags::Read)
        {
            continue;
        }
        const std::string what =
            Subject() + " reads '" + use.texture.rt()->name() + "', which no pass before it writes";
        if (texture->clears)
        {
            m_Report.notes.push_back(what + ": the texture holds the clearColor");
        }
        else
        {
            Fail(what + ", and clearBuffer is false: its contents are undefined");
        }
    }
    for (const RenderGraphPass::BufferUse& use : m_Pass->buffers)
    {
        RenderGraphBuffer& buffer = *m_State.Find(*use.buffer);
        if (buffer.isMade && !buffer.isWritten && use.flags == AccessFlags::Read)
        {
            Fail(Subject() + " reads buffer '" + use.buffer->name() +
                 "', which no pass before it writes");
        }
        buffer.isWritten = buffer.isWritten || (use.flags & AccessFlags::Write);
    }
}

void RenderGraphRun::ExpectGlobalsAllowed(std::string_view what, std::string_view name)
{
    m_HasEffect = true;
    if (!m_Pass->allowsGlobalState)
    {
        const std::string quoted = name.empty() ? "" : " '" + std::string(name) + "'";
        m_RefusedGlobals.emplace_back(name);
        Fail(Subject() + " " + std::string(what) + quoted +
             ", for which Unity throws; add builder.AllowGlobalStateModification(true);");
    }
}

void RenderGraphRun::ExpectDeclared(const RTHandle& texture, ShaderPropertyId id)
{
    const RenderGraphTexture* known = texture.rt() ? m_State.Find(*texture.rt()) : nullptr;
    if (known != nullptr && known->owner != m_Pass && m_Pass->FindUse(known->texture) == nullptr)
    {
        Fail(Subject() + " sets '" + texture.rt()->name() + "' as the global '" + id.name() +
             "' and declares no use of it, for which Unity throws; add " +
             LineFor(*known, AccessFlags::Read));
    }
}

/// Unity lets a native command buffer set whatever it likes.
void RenderGraphRun::NoteNativeGlobal(std::string_view name)
{
    if (m_Pass->allowsGlobalState ||
        std::ranges::find(m_RefusedGlobals, name) != m_RefusedGlobals.end())
    {
        return;
    }
    m_RefusedGlobals.emplace_back(name);
    m_Report.notes.push_back(Subject() + " sets '" + std::string(name) +
                             "' for all that follow by a native command buffer; "
                             "builder.AllowGlobalStateModification(true); declares it");
}

void RenderGraphRun::ExpectAsDeclared(std::size_t firstCommand)
{
    m_Sampled.clear();
    m_Targets.clear();
    m_Buffers.clear();
    const bool isKept = !m_Pass->allowsCulling;
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
            m_HasEffect = true;
            ExpectReads(*last, true);
            ExpectWrites(*last);
            ExpectBuffers(*last);
            continue;
        }
        const auto* draw = std::get_if<DrawCommand>(&commands[i]);
        if (draw == nullptr && !std::holds_alternative<ClearCommand>(commands[i]))
        {
            continue;
        }
        m_HasEffect = true;
        ExpectTarget(target);
        const DrawBindings* bindings =
            draw != nullptr ? m_Context.m_Frame.Setup(*draw).bindings.get() : last;
        if (bindings != last)
        {
            last = bindings;
            ExpectReads(*bindings, false);
            ExpectBuffers(*bindings);
        }
    }
    ExpectRunByUnity();
    NoteUnused(last != nullptr);
}

void RenderGraphRun::ExpectTarget(const SetRenderTargetCommand* target)
{
    if (target == nullptr)
    {
        Fail(Subject() + (m_Pass->function.index() == 0
                              ? " draws, yet declares no SetRenderAttachment"
                              : " draws before it sets a render target"));
        return;
    }
    const auto expect = [this](const std::shared_ptr<const RenderTexture>& texture)
    {
        if (texture && !Has<const Texture*>(m_Targets, texture.get()))
        {
            m_Targets.push_back(texture.get());
            ExpectTarget(*texture);
        }
    };
    std::ranges::for_each(target->colors, expect);
    expect(target->depth);
}

void RenderGraphRun::ExpectTarget(const RenderTexture& texture)
{
    RenderGraphTexture* known = m_State.Find(texture);
    if (known == nullptr || known->owner == m_Pass)
    {
        return;
    }
    const RenderGraphPass::Use* use = m_Pass->FindUse(known->texture);
    const bool isDepth = IsDepthFormat(texture.graphicsFormat());
    // A depth that is read is bound as one that draws are tested against.
    if (use != nullptr && (use->isAttachment || use->flags & AccessFlags::Write || isDepth))
    {
        return;
    }
    const AccessFlags wanted = use != nullptr ? AccessFlags::ReadWrite : AccessFlags::Write;
    m_LineToBeRun = LineFor(*known, wanted);
    const std::string what =
        Subject() + " declares no write of '" + texture.name() + "', yet draws into it";
    NoteOrFail(use != nullptr || isAlive(*known), what,
               ", where its handle stands for no texture in Unity", m_LineToBeRun);
    known->isWritten = true;
}

void RenderGraphRun::ExpectWrites(const DrawBindings& bindings)
{
    for (const StorageTextureSlot& slot : bindings.storageTextures)
    {
        RenderGraphTexture* known = m_State.Find(*slot.texture);
        const bool isNew = !Has<const Texture*>(m_Targets, slot.texture.get());
        m_Targets.push_back(slot.texture.get());
        if (!isNew || known == nullptr || known->owner == m_Pass ||
            m_Pass->Declares(known->texture, AccessFlags::Write))
        {
            continue;
        }
        const bool isRead = m_Pass->FindUse(known->texture) != nullptr;
        m_LineToBeRun = LineFor(*known, isRead ? AccessFlags::ReadWrite : AccessFlags::Write);
        const std::string what = Subject() + " declares no write of '" + slot.texture->name() +
                                 "', yet a kernel may write to it";
        NoteOrFail(isRead, what, ", for which Unity throws", m_LineToBeRun);
        known->isWritten = true;
    }
}

void RenderGraphRun::ExpectBuffers(const DrawBindings& bindings)
{
    for (const BufferSlot& slot : bindings.buffers)
    {
        const bool isNew = !Has<const GraphicsBuffer*>(m_Buffers, slot.buffer.get());
        m_Buffers.push_back(slot.buffer.get());
        RenderGraphBuffer* known = m_State.Find(*slot.buffer);
        const RenderGraphPass::BufferUse* use = m_Pass->FindUse(*slot.buffer);
        const AccessFlags wanted = slot.isWritten ? AccessFlags::Write : AccessFlags::Read;
        if (!isNew || known == nullptr || (use != nullptr && (use->flags & wanted)))
        {
            continue;
        }
        const std::string line =
            LineFor(*slot.buffer, slot.isWritten ? AccessFlags::ReadWrite : AccessFlags::Read);
        m_LineToBeRun = slot.isWritten ? line : m_LineToBeRun;
        const std::string what = Subject() + " declares no " + (slot.isWritten ? "write" : "read") +
                                 " of buffer '" + slot.buffer->name() + "', yet " +
                                 (slot.isWritten ? "a kernel may write to it" : "reads it");
        NoteOrFail(use != nullptr || isAlive(*known), what,
                   ", where its handle stands for no buffer in Unity", line);
        known->isWritten = known->isWritten || slot.isWritten;
    }
}

void RenderGraphRun::ExpectReads(const DrawBindings& bindings, bool isDispatch)
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
        if (use != nullptr && (use->isAttachment || use->flags & AccessFlags::Read))
        {
            continue;
        }
        const std::string line =
            LineFor(*known, use != nullptr ? AccessFlags::ReadWrite : AccessFlags::Read);
        const std::string what =
            Subject() + " declares no read of '" + texture->name() + "', yet samples it";
        // A global texture stays bound; the pass got any other from a handle. A kernel gets its
        // textures by a call that throws.
        const bool isGlobal = wasGlobal(*texture);
        NoteOrFail(use != nullptr || isGlobal || (!isDispatch && isAlive(*known)), what,
                   isDispatch ? ", for which Unity throws"
                              : ", where its handle stands for no texture in Unity",
                   line);
    }
}

/// A pass that declares no write and may be left out is left out by Unity.
void RenderGraphRun::ExpectRunByUnity()
{
    const auto writes = [](const auto& use)
    {
        return bool(use.flags & AccessFlags::Write);
    };
    const bool isRun = !m_Pass->allowsCulling || std::ranges::any_of(m_Pass->uses, writes) ||
                       std::ranges::any_of(m_Pass->buffers, writes);
    if (m_HasEffect && !isRun && m_Problems.empty())
    {
        Fail(Subject() + " declares no write, so that Unity leaves it out; add " +
             (m_LineToBeRun.empty() ? "builder.AllowPassCulling(false);" : m_LineToBeRun));
    }
}

/// Adds a note for each use that is declared and not needed.
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
        // A renderer list may have nothing to draw.
        if ((use.flags & AccessFlags::Write) && !isWritten && !isRead && m_DrawnLists.empty())
        {
            notes.push_back(Subject() + " declares a write of '" + texture->name() +
                            "', yet draws nothing into it");
        }
    }
    for (const RenderGraphPass::BufferUse& use : m_Pass->buffers)
    {
        if (!Has(m_Buffers, use.buffer.get()))
        {
            notes.push_back(Subject() + " declares a use of buffer '" + use.buffer->name() +
                            "', yet uses it nowhere");
        }
    }
}

} // namespace limn
