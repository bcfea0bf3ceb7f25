#include "graph/RenderGraphPass.h"
#include "texture/ScaledTexture.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limn/base/NumberText.h>
#include <limn/core/UniversalRenderer.h>

namespace limn
{

namespace
{

SamplerState SamplerOf(const TextureDesc& desc)
{
    SamplerState sampler{desc.filterMode, desc.wrapMode, desc.wrapMode, desc.wrapMode};
    sampler.anisoLevel = desc.anisoLevel;
    sampler.mipMapBias = desc.mipMapBias;
    return sampler;
}

glm::ivec2 SizeForCamera(const TextureDesc& desc)
{
    static constexpr const char* k_Call = "CreateTexture";
    const std::string& name = desc.name.name();
    const RTHandles::ScaleFunc scale = desc.sizeMode == TextureSizeMode::Scale
                                           ? ScaleBy(desc.scale, k_Call, name)
                                           : ScaleBy(desc.func, k_Call, name);
    return glm::max(scale({RTHandles::maxWidth(), RTHandles::maxHeight()}), glm::ivec2(1));
}

std::string Describe(const RenderTexture& texture)
{
    return "'" + texture.name() + "' is " + texture.DescribeSize() + " " +
           ToString(texture.graphicsFormat()) + " with " +
           CountText(static_cast<std::size_t>(texture.descriptor().msaaSamples), "sample") +
           " per texel";
}

void ExpectHandle(bool isValid, const RenderGraphCall& subject)
{
    if (!isValid)
    {
        throw ContractError(subject.text() + ": the handle is empty");
    }
}

/// @param nameless  what it is called if it has no name
[[noreturn]] void FailOfEarlierFrame(const RenderGraphCall& subject, const char* nameless,
                                     const std::string& name)
{
    throw ContractError(
        subject.text() + ": " + (name.empty() ? nameless : "'" + name + "'") +
        " is a handle of an earlier frame; a handle is valid in one camera's frame only");
}

/// The data of a blit's render function.
struct BlitData
{
    TextureHandle source;
    glm::vec4 scaleBias;
    std::shared_ptr<const Material> material;
    int shaderPass = 0;
    ShaderPropertyId name; ///< of the source; none: _BlitTexture
};

} // namespace

TextureDesc::TextureDesc(const RenderTextureDescriptor& descriptor)
    : width(descriptor.width),
      height(descriptor.height),
      format(descriptor.graphicsFormat),
      depthBufferBits(static_cast<DepthBits>(descriptor.depthBufferBits)),
      msaaSamples(static_cast<MSAASamples>(descriptor.msaaSamples)),
      enableRandomWrite(descriptor.enableRandomWrite),
      useMipMap(descriptor.useMipMap),
      autoGenerateMips(descriptor.autoGenerateMips),
      dimension(descriptor.dimension),
      slices(descriptor.volumeDepth),
      bindTextureMS(descriptor.bindMS)
{
}

RenderTextureDescriptor TextureDesc::descriptor() const
{
    const glm::ivec2 size =
        sizeMode == TextureSizeMode::Explicit ? glm::ivec2(width, height) : SizeForCamera(*this);
    const int depthBits = static_cast<int>(DepthBits(depthBufferBits));
    RenderTextureDescriptor result(size.x, size.y, depthBits == 0 ? format : GraphicsFormat::None,
                                   depthBits);
    result.msaaSamples = static_cast<int>(msaaSamples);
    result.enableRandomWrite = enableRandomWrite;
    result.useMipMap = useMipMap;
    result.autoGenerateMips = autoGenerateMips;
    result.dimension = dimension;
    result.volumeDepth = slices;
    result.bindMS = bindTextureMS;
    return result;
}

TextureDesc TextureHandle::GetDescriptor(const RenderGraph& renderGraph) const
{
    return renderGraph.GetTextureDesc(*this);
}

RenderGraphTexture* RenderGraphState::Find(const Texture& texture)
{
    const auto found = std::ranges::find_if(textures, [&](const RenderGraphTexture& candidate)
                                            { return candidate.texture.rt().get() == &texture; });
    return found == textures.end() ? nullptr : &*found;
}

RenderGraphBuffer* RenderGraphState::Find(const GraphicsBuffer& buffer)
{
    const auto found = std::ranges::find_if(buffers, [&](const RenderGraphBuffer& candidate)
                                            { return candidate.buffer.get() == &buffer; });
    return found == buffers.end() ? nullptr : &*found;
}

TextureHandle UniversalRenderer::CreateRenderGraphTexture(RenderGraph& renderGraph,
                                                          const RenderTextureDescriptor& desc,
                                                          ResourceName name, bool clear,
                                                          FilterMode filterMode,
                                                          TextureWrapMode wrapMode)
{
    TextureDesc texture(desc);
    texture.name = name;
    texture.clearBuffer = clear;
    texture.filterMode = filterMode;
    texture.wrapMode = wrapMode;
    return renderGraph.CreateTexture(texture);
}

RenderGraph::RenderGraph() : m_State(std::make_unique<RenderGraphState>()) {}
RenderGraph::~RenderGraph() = default;

TextureHandle RenderGraph::HandleOf(const RTHandle& texture) const
{
    return {texture, m_State->frame};
}

std::string RenderGraphCall::text() const
{
    return std::string(before).append(name).append(behind);
}

void RenderGraph::ExpectOfFrame(const TextureHandle& texture, const RenderGraphCall& subject) const
{
    ExpectHandle(texture.IsValid(), subject);
    if (texture.m_Frame != m_State->frame || m_State->Find(*texture.rt()) == nullptr)
    {
        FailOfEarlierFrame(subject, "the texture", texture.rt()->name());
    }
}

void RenderGraph::ExpectOfFrame(const BufferHandle& buffer, const RenderGraphCall& subject) const
{
    ExpectHandle(buffer.IsValid(), subject);
    if (buffer.m_Frame != m_State->frame || m_State->Find(*buffer.buffer()) == nullptr)
    {
        FailOfEarlierFrame(subject, "the buffer", buffer.buffer()->name());
    }
}

BufferHandle RenderGraph::CreateBuffer(const BufferDesc& desc)
{
    auto& kept = m_State->keptBuffers;
    auto place = std::ranges::find_if(kept, [&](const RenderGraphState::KeptBuffer& candidate)
                                      { return !candidate.isTaken && candidate.desc == desc; });
    if (place == kept.end())
    {
        auto buffer = std::make_shared<GraphicsBuffer>(desc.target, desc.count, desc.stride);
        buffer->SetName(desc.name.name());
        kept.push_back({desc, std::move(buffer)});
        place = kept.end() - 1;
    }
    place->isTaken = true;
    m_State->buffers.push_back({place->buffer, true, false});
    return {place->buffer, m_State->frame};
}

BufferHandle RenderGraph::ImportBuffer(const std::shared_ptr<const GraphicsBuffer>& graphicsBuffer)
{
    if (!graphicsBuffer)
    {
        throw ContractError("ImportBuffer: there is no buffer");
    }
    if (m_State->Find(*graphicsBuffer) == nullptr)
    {
        m_State->buffers.push_back({graphicsBuffer, false, false});
    }
    return {graphicsBuffer, m_State->frame};
}

std::size_t RenderGraph::IndexOf(const RendererListHandle& list,
                                 const RenderGraphCall& subject) const
{
    if (!list.IsValid() || list.m_Frame != m_State->frame)
    {
        throw ContractError(subject.text() + (list.IsValid()
                                                  ? ": the list is one of an earlier frame"
                                                  : ": the handle is empty"));
    }
    return list.m_Index;
}

TextureHandle RenderGraph::CreateTexture(const TextureDesc& desc)
{
    const RenderTextureDescriptor descriptor = desc.descriptor();
    const SamplerState sampler = SamplerOf(desc);
    auto& kept = m_State->kept;
    auto place =
        std::ranges::find_if(kept,
                             [&](const RenderGraphState::Kept& candidate)
                             {
                                 const RenderTexture& texture = *candidate.texture.rt();
                                 return !candidate.isTaken && texture.descriptor() == descriptor &&
                                        texture.sampler() == sampler && desc.name == texture.name();
                             });
    if (place == kept.end())
    {
        kept.push_back({RTHandle(
            std::make_shared<const RenderTexture>(desc.name.name(), descriptor, sampler, true))});
        place = kept.end() - 1;
    }
    place->isTaken = true;
    RenderGraphTexture texture;
    texture.texture = place->texture;
    texture.isMade = true;
    texture.clears = desc.clearBuffer;
    texture.clearColor = desc.clearColor;
    m_State->textures.push_back(std::move(texture));
    return HandleOf(place->texture);
}

TextureHandle RenderGraph::CreateTexture(const TextureHandle& texture, std::string_view name,
                                         bool clear)
{
    TextureDesc desc = GetTextureDesc(texture);
    desc.name = name;
    desc.clearBuffer = clear;
    return CreateTexture(desc);
}

TextureHandle RenderGraph::ImportTexture(const RTHandle& rt,
                                         const ImportResourceParams& importParams)
{
    if (!rt.rt())
    {
        throw ContractError("ImportTexture: the handle has no texture");
    }
    if (m_State->Find(*rt.rt()) == nullptr)
    {
        RenderGraphTexture texture;
        texture.texture = rt;
        texture.clears = importParams.clearOnFirstUse;
        texture.clearColor = importParams.clearColor;
        m_State->textures.push_back(std::move(texture));
    }
    return HandleOf(rt);
}

TextureDesc RenderGraph::GetTextureDesc(const TextureHandle& texture) const
{
    ExpectOfFrame(texture, {"GetTextureDesc", {}, {}});
    const RenderGraphTexture& known = *m_State->Find(*texture.rt());
    TextureDesc desc(texture.rt()->descriptor());
    desc.filterMode = texture.rt()->sampler().filterMode;
    desc.wrapMode = texture.rt()->sampler().wrapModeU;
    desc.clearBuffer = known.clears;
    desc.clearColor = known.clearColor;
    desc.name = texture.rt()->name();
    return desc;
}

RenderTargetInfo RenderGraph::GetRenderTargetInfo(const TextureHandle& texture) const
{
    ExpectOfFrame(texture, {"GetRenderTargetInfo", {}, {}});
    const RenderTexture& target = *texture.rt();
    return {target.width(),
            target.height(),
            1,
            target.descriptor().msaaSamples,
            target.graphicsFormat(),
            false};
}

void RenderGraph::CreateTextureIfInvalid(const TextureDesc& desc, TextureHandle& texture)
{
    if (!texture.IsValid())
    {
        texture = CreateTexture(desc);
    }
}

BufferDesc RenderGraph::GetBufferDesc(const BufferHandle& graphicsBuffer) const
{
    ExpectOfFrame(graphicsBuffer, {"GetBufferDesc", {}, {}});
    const GraphicsBuffer& buffer = *graphicsBuffer.buffer();
    BufferDesc desc(buffer.count(), buffer.stride(), buffer.target());
    desc.name = buffer.name();
    return desc;
}

RendererListHandle RenderGraph::CreateRendererList(const RendererListParams& desc)
{
    m_State->rendererLists.push_back(desc);
    return {m_State->rendererLists.size() - 1, m_State->frame};
}

RenderGraphPass& RenderGraph::AddPass(std::string_view name, bool allowsGlobalState)
{
    RenderGraphPass& pass = m_State->passes.emplace_back();
    pass.name = SampleName(name);
    pass.allowsGlobalState = allowsGlobalState;
    return pass;
}

const std::shared_ptr<const Material>& RenderGraph::CopyMaterial(std::string_view call) const
{
    if (!m_State->copy)
    {
        throw ContractError(std::string(call) + ": the renderer has no shaders; give a material");
    }
    return m_State->copy;
}

void RenderGraph::AddBlitPass(const RenderGraphUtils::BlitMaterialParameters& blitParameters,
                              std::string_view passName)
{
    if (!blitParameters.material)
    {
        throw ContractError("AddBlitPass '" + std::string(passName) + "': the material is null");
    }
    BlitData* passData = nullptr;
    auto builder = AddRasterRenderPass<BlitData>(passName, passData);
    *passData = {blitParameters.source, glm::vec4(blitParameters.scale, blitParameters.offset),
                 blitParameters.material, blitParameters.shaderPass,
                 blitParameters.sourceTexturePropertyID};
    builder.UseTexture(blitParameters.source);
    builder.SetRenderAttachment(blitParameters.destination, 0);
    builder.UseAllGlobalTextures(true); // nobody else can declare what its material samples
    builder.SetRenderFunc(
        [](BlitData& data, RasterGraphContext& context)
        {
            if (data.name == ShaderPropertyId())
            {
                Blitter::BlitTexture(context.cmd, data.source, data.scaleBias, data.material,
                                     data.shaderPass);
                return;
            }
            MaterialPropertyBlock properties;
            properties.SetTexture(data.name, data.source.rt());
            properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias, data.scaleBias);
            CoreUtils::DrawFullScreen(context.cmd, data.material, properties, data.shaderPass);
        });
}

void RenderGraph::AddBlitPass(const TextureHandle& source, const TextureHandle& destination,
                              const glm::vec2& scale, const glm::vec2& offset,
                              RenderGraphUtils::BlitFilterMode filterMode,
                              std::string_view passName)
{
    const bool isNearest = filterMode == RenderGraphUtils::BlitFilterMode::ClampNearest;
    RenderGraphUtils::BlitMaterialParameters parameters(
        source, destination, CopyMaterial("AddBlitPass"),
        isNearest ? CameraTargets::k_NearestPass : CameraTargets::k_BilinearPass);
    parameters.scale = scale;
    parameters.offset = offset;
    AddBlitPass(parameters, passName);
}

void RenderGraph::AddCopyPass(const TextureHandle& source, const TextureHandle& destination,
                              std::string_view passName)
{
    const RenderGraphCall subject{"AddCopyPass '", passName, "'"};
    ExpectOfFrame(source, subject);
    ExpectOfFrame(destination, subject);
    if (source.rt()->descriptor() != destination.rt()->descriptor() ||
        IsDepthFormat(source.rt()->graphicsFormat()))
    {
        throw ContractError(subject.text() + ": " + Describe(*source.rt()) + " and " +
                            Describe(*destination.rt()) +
                            "; both must be colours of one size, format and number of samples");
    }
    AddBlitPass(source, destination, glm::vec2(1.0f), glm::vec2(0.0f),
                RenderGraphUtils::BlitFilterMode::ClampNearest, passName);
}

} // namespace limn
