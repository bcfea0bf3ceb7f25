#include "graph/RenderGraphPass.h"

#include <algorithm>

namespace limn
{

namespace
{

std::string Quoted(const RTHandle& texture)
{
    return "'" + texture.rt()->name() + "'";
}

/// @param call  "': UseTexture"
RenderGraphCall Subject(const RenderGraphPass& pass, std::string_view call)
{
    return {"pass '", pass.name.name(), call};
}

/// A texture has one use in a pass; reading it twice is one.
void AddUse(RenderGraphPass& pass, std::string_view call, RenderGraphPass::Use use)
{
    const RenderGraphPass::Use* other = pass.FindUse(use.texture);
    if (other == nullptr)
    {
        pass.uses.push_back(std::move(use));
        return;
    }
    const bool isReadTwice = !other->isAttachment && !use.isAttachment &&
                             !(use.flags & AccessFlags::Write) &&
                             !(other->flags & AccessFlags::Write);
    if (!isReadTwice)
    {
        throw ContractError(Subject(pass, call).text() + ": the pass " +
                            (other->isAttachment                 ? "draws into "
                             : other->flags & AccessFlags::Write ? "writes "
                                                                 : "reads ") +
                            Quoted(use.texture) +
                            " already; declare one use of a texture in a pass");
    }
}

void ExpectIndex(const RenderGraphCall& subject, const RTHandle& texture, int index)
{
    if (index < 0 || index >= static_cast<int>(k_MostColors))
    {
        throw ContractError(subject.text() + " of " + Quoted(texture) + ": the index is " +
                            std::to_string(index) + "; it must be 0 to " +
                            std::to_string(k_MostColors - 1));
    }
}

} // namespace

const RenderGraphPass::Use* RenderGraphPass::FindUse(const RTHandle& texture) const
{
    const auto use = std::ranges::find(uses, texture, &Use::texture);
    return use == uses.end() ? nullptr : &*use;
}

const RenderGraphPass::BufferUse* RenderGraphPass::FindUse(const GraphicsBuffer& buffer) const
{
    const auto use = std::ranges::find_if(buffers, [&](const BufferUse& candidate)
                                          { return candidate.buffer.get() == &buffer; });
    return use == buffers.end() ? nullptr : &*use;
}

bool RenderGraphPass::Declares(const RTHandle& texture, AccessFlags flags) const
{
    const Use* use = FindUse(texture);
    return use != nullptr && (use->flags & flags);
}

void BaseRenderGraphBuilder::ExpectUsable(const TextureHandle& texture,
                                          const RenderGraphCall& subject) const
{
    m_Graph.ExpectOfFrame(texture, subject);
    const RenderGraphPass* owner = m_Graph.m_State->Find(*texture.rt())->owner;
    if (owner != nullptr && owner != &m_Pass)
    {
        throw ContractError(subject.text() + ": " + Quoted(texture) +
                            " is a transient texture of pass '" + owner->name.name() + "'");
    }
}

void BaseRenderGraphBuilder::UseTexture(const TextureHandle& input, AccessFlags flags)
{
    ExpectUsable(input, Subject(m_Pass, "': UseTexture"));
    AddUse(m_Pass, "': UseTexture", {input, flags, false});
}

BufferHandle BaseRenderGraphBuilder::UseBuffer(const BufferHandle& input, AccessFlags flags)
{
    const RenderGraphCall subject = Subject(m_Pass, "': UseBuffer");
    m_Graph.ExpectOfFrame(input, subject);
    if (m_Pass.FindUse(*input.buffer()) != nullptr)
    {
        throw ContractError(subject.text() + ": the pass uses '" + input.buffer()->name() +
                            "' already; declare Read and Write in one call");
    }
    m_Pass.buffers.push_back({input.buffer(), flags});
    return input;
}

void BaseRenderGraphBuilder::UseGlobalTexture(ShaderPropertyId propertyId, AccessFlags flags)
{
    m_Pass.globalUses.push_back({propertyId, flags});
}

void BaseRenderGraphBuilder::UseAllGlobalTextures(bool enable)
{
    m_Pass.usesAllGlobals = enable;
}

void BaseRenderGraphBuilder::SetGlobalTextureAfterPass(const TextureHandle& input,
                                                       ShaderPropertyId propertyId)
{
    ExpectUsable(input, Subject(m_Pass, "': SetGlobalTextureAfterPass"));
    m_Pass.globalsAfter.push_back({propertyId, input});
}

TextureHandle BaseRenderGraphBuilder::CreateTransientTexture(const TextureDesc& desc)
{
    TextureHandle texture = m_Graph.CreateTexture(desc);
    m_Graph.m_State->textures.back().owner = &m_Pass;
    return texture;
}

TextureHandle BaseRenderGraphBuilder::CreateTransientTexture(const TextureHandle& texture)
{
    return CreateTransientTexture(texture.GetDescriptor(m_Graph));
}

BufferHandle BaseRenderGraphBuilder::CreateTransientBuffer(const BufferDesc& desc)
{
    return UseBuffer(m_Graph.CreateBuffer(desc), AccessFlags::ReadWrite);
}

BufferHandle BaseRenderGraphBuilder::CreateTransientBuffer(const BufferHandle& computebuffer)
{
    return CreateTransientBuffer(m_Graph.GetBufferDesc(computebuffer));
}

void BaseRenderGraphBuilder::UseRendererList(const RendererListHandle& input)
{
    m_Pass.rendererLists.push_back(m_Graph.IndexOf(input, Subject(m_Pass, "': UseRendererList")));
}

void BaseRenderGraphBuilder::AllowPassCulling(bool value)
{
    m_Pass.allowsCulling = value && (m_Pass.allowsCulling || !m_Pass.allowsGlobalState);
}

void BaseRenderGraphBuilder::AllowGlobalStateModification(bool value)
{
    m_Pass.allowsGlobalState = value;
    m_Pass.allowsCulling = m_Pass.allowsCulling && !value;
}

void BaseRenderGraphBuilder::SetRenderAttachment(const TextureHandle& texture, int index,
                                                 AccessFlags flags)
{
    const RenderGraphCall subject = Subject(m_Pass, "': SetRenderAttachment");
    ExpectUsable(texture, subject);
    if (IsDepthFormat(texture.rt()->graphicsFormat()))
    {
        throw ContractError(subject.text() + ": " + Quoted(texture) +
                            " is a depth texture; call SetRenderAttachmentDepth");
    }
    ExpectIndex(subject, texture, index);
    RTHandle& slot = m_Pass.colors[static_cast<std::size_t>(index)];
    if (slot)
    {
        throw ContractError(subject.text() + " of " + Quoted(texture) + ": index " +
                            std::to_string(index) + " has " + Quoted(slot) + " already");
    }
    AddUse(m_Pass, "': SetRenderAttachment", {texture, flags, true});
    slot = texture;
}

void BaseRenderGraphBuilder::SetRenderAttachmentDepth(const TextureHandle& texture,
                                                      AccessFlags flags)
{
    const RenderGraphCall subject = Subject(m_Pass, "': SetRenderAttachmentDepth");
    ExpectUsable(texture, subject);
    if (!IsDepthFormat(texture.rt()->graphicsFormat()))
    {
        throw ContractError(subject.text() + ": " + Quoted(texture) +
                            " is no depth texture; call SetRenderAttachment");
    }
    if (m_Pass.depth)
    {
        throw ContractError(subject.text() + " of " + Quoted(texture) + ": the pass has " +
                            Quoted(m_Pass.depth) + " already");
    }
    AddUse(m_Pass, "': SetRenderAttachmentDepth", {texture, flags, true});
    m_Pass.depth = texture;
}

void BaseRenderGraphBuilder::SetInputAttachment(const TextureHandle& texture, int index,
                                                AccessFlags flags)
{
    static const std::array<ShaderPropertyId, k_MostColors> s_Names = {
        "_UnityFBInput0", "_UnityFBInput1", "_UnityFBInput2", "_UnityFBInput3",
        "_UnityFBInput4", "_UnityFBInput5", "_UnityFBInput6", "_UnityFBInput7"};
    const RenderGraphCall subject = Subject(m_Pass, "': SetInputAttachment");
    ExpectUsable(texture, subject);
    ExpectIndex(subject, texture, index);
    const ShaderPropertyId id = s_Names[static_cast<std::size_t>(index)];
    const auto same = std::ranges::find(m_Pass.inputs, id, &RenderGraphPass::GlobalTexture::id);
    if (same != m_Pass.inputs.end())
    {
        throw ContractError(subject.text() + " of " + Quoted(texture) + ": index " +
                            std::to_string(index) + " has " + Quoted(same->texture) + " already");
    }
    AddUse(m_Pass, "': SetInputAttachment", {texture, flags, false});
    m_Pass.inputs.push_back({id, texture});
}

void BaseRenderGraphBuilder::SetFunction(AnyRenderGraphFunction function)
{
    m_Pass.function = std::move(function);
}

} // namespace limn
