#include "graph/RenderGraphRun.h"

#include "material/PropertyValues.h"
#include "resolve/DrawRecorder.h"

#include <algorithm>
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

CommandBuffer& detail::NativeOf(BaseCommandBuffer& cmd)
{
    return cmd;
}

CommandBuffer& CommandBufferHelpers::GetNativeCommandBuffer(UnsafeCommandBuffer& cmd)
{
    return detail::NativeOf(cmd);
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
        RecordWith<RasterCommandBuffer>(*m_Pass->raster);
    }
    else if (m_Pass->compute)
    {
        RecordWith<ComputeCommandBuffer>(*m_Pass->compute);
    }
    else
    {
        RecordWith<UnsafeCommandBuffer>(*m_Pass->unsafe);
    }
}

template <typename Buffer, typename Pass>
void RenderGraphRun::RecordWith(Pass& pass)
{
    Buffer buffer(std::move(*m_Cmd), *this); // with the memory of the pooled one
    CommandBuffer& native = buffer;
    CommandBuffer* const pooled = std::exchange(m_Cmd, &native);
    pass.Record(buffer);
    Flush();
    *pooled = std::move(native);
    m_Cmd = pooled;
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
