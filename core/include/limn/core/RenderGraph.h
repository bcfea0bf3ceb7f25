#pragma once

#include <limn/core/ContextContainer.h>
#include <limn/core/ProfilingScope.h>
#include <limn/core/RenderGraphBuilder.h>

namespace limn
{

struct RenderGraphState;
struct RenderGraphCall;

/// Unity: UnityEngine.Rendering.RenderGraphModule.Util.RenderGraphUtils (core 17).
namespace RenderGraphUtils
{

enum class BlitFilterMode
{
    ClampNearest = 0,
    ClampBilinear = 1
};

/// The arguments of AddBlitPass, which draws the source with one triangle over the destination. A
/// shader sees the source as _BlitTexture, or by the name that is set here.
struct BlitMaterialParameters
{
    TextureHandle source;
    ShaderPropertyId sourceTexturePropertyID = {};
    TextureHandle destination;
    glm::vec2 scale{1.0f};
    glm::vec2 offset{0.0f};
    std::shared_ptr<const Material> material;
    int shaderPass = 0;

    BlitMaterialParameters(TextureHandle from, TextureHandle to,
                           std::shared_ptr<const Material> with, int pass)
        : source(std::move(from)),
          destination(std::move(to)),
          material(std::move(with)),
          shaderPass(pass)
    {
    }
};

} // namespace RenderGraphUtils

/// A render graph, with which Unity 6 writes a ScriptableRenderPass: its RecordRenderGraph adds
/// passes, each with what it reads and writes and a function that records it. They run in their
/// order when RecordRenderGraph returns, and the frame compiler treats them as it treats all
/// passes: culling, load and store, memory. In addition each is compared with what its author
/// declared. Where Unity throws or draws something else, a ContractError names all of it, with the
/// lines to add. What is missing but harmless in Unity, and what is declared but not used, is a
/// note in the report. Unity: UnityEngine.Rendering.RenderGraphModule.RenderGraph (core 17).
class RenderGraph
{
public:
    RenderGraph();
    ~RenderGraph();
    RenderGraph(const RenderGraph&) = delete;
    RenderGraph& operator=(const RenderGraph&) = delete;

    /// Makes a texture that lives until the camera is done. A frame that asks for the same textures
    /// as the one before gets the same ones.
    /// @throws ContractError as RenderTexture does
    TextureHandle CreateTexture(const TextureDesc& desc);
    /// like this one
    TextureHandle CreateTexture(const TextureHandle& texture)
    {
        return CreateTexture(GetTextureDesc(texture));
    }
    /// Makes a texture like another one with another name. If `clear` is true, a pass that draws
    /// into it first clears it.
    TextureHandle CreateTexture(const TextureHandle& texture, std::string_view name,
                                bool clear = false);
    /// Imports a texture of the pass's own; importing it again returns the same handle.
    /// @throws ContractError if there is no texture
    TextureHandle ImportTexture(const RTHandle& rt, const ImportResourceParams& importParams = {});
    /// Makes a buffer that lives until the camera is done. A frame that asks for the same buffers
    /// as the one before gets the same ones, with their contents.
    /// @throws ContractError as GraphicsBuffer does
    BufferHandle CreateBuffer(const BufferDesc& desc);
    /// Imports a buffer of the pass's own; importing it again returns the same handle.
    /// @throws ContractError if it is null
    BufferHandle ImportBuffer(const std::shared_ptr<const GraphicsBuffer>& graphicsBuffer);
    /// @throws ContractError if there is no texture, or it is one of an earlier frame
    TextureDesc GetTextureDesc(const TextureHandle& texture) const;
    RenderTargetInfo GetRenderTargetInfo(const TextureHandle& texture) const;
    /// Makes a texture if the handle has none. Unity: RenderGraph.CreateTextureIfInvalid.
    void CreateTextureIfInvalid(const TextureDesc& desc, TextureHandle& texture);
    /// @throws ContractError if there is no buffer, or it is one of an earlier frame
    BufferDesc GetBufferDesc(const BufferHandle& graphicsBuffer) const;
    RendererListHandle CreateRendererList(const RendererListParams& desc);
    RendererListHandle CreateRendererList(const RendererListDesc& desc)
    {
        return CreateRendererList(desc.ToParams());
    }

    // A sampler behind the data changes nothing: a pass is shown by its name.
    /// @param passData  set to the new data of the pass, which its render function receives
    template <typename PassData, std::derived_from<ProfilingSampler>... Sampler>
    RasterRenderGraphBuilder<PassData> AddRasterRenderPass(std::string_view passName,
                                                           PassData*& passData, const Sampler&...)
    {
        return Add<RasterRenderGraphBuilder<PassData>>(passName, passData);
    }
    template <typename PassData, std::derived_from<ProfilingSampler>... Sampler>
    UnsafeRenderGraphBuilder<PassData> AddUnsafePass(std::string_view passName, PassData*& passData,
                                                     const Sampler&...)
    {
        return Add<UnsafeRenderGraphBuilder<PassData>>(passName, passData, true);
    }
    template <typename PassData, std::derived_from<ProfilingSampler>... Sampler>
    ComputeRenderGraphBuilder<PassData> AddComputePass(std::string_view passName,
                                                       PassData*& passData, const Sampler&...)
    {
        return Add<ComputeRenderGraphBuilder<PassData>>(passName, passData);
    }

    /// Draws the source with the material over the whole destination, whose contents stay where the
    /// material blends. The material may sample any global texture.
    /// @throws ContractError if the material is null
    void AddBlitPass(const RenderGraphUtils::BlitMaterialParameters& blitParameters,
                     std::string_view passName = "BlitMaterial");
    /// Draws the part of the source of size `scale` that begins at `offset` (1 = the whole) over
    /// the whole destination.
    void AddBlitPass(const TextureHandle& source, const TextureHandle& destination,
                     const glm::vec2& scale, const glm::vec2& offset,
                     RenderGraphUtils::BlitFilterMode filterMode =
                         RenderGraphUtils::BlitFilterMode::ClampBilinear,
                     std::string_view passName = "BlitTexture");
    /// Copies texel for texel.
    /// @throws ContractError unless both are colours of the same size, format and number of samples
    void AddCopyPass(const TextureHandle& source, const TextureHandle& destination,
                     std::string_view passName = "CopyTexture");

private:
    friend class BaseRenderGraphBuilder;
    friend class RenderGraphCamera;
    friend class RenderGraphRun;
    RenderGraphPass& AddPass(std::string_view name, bool allowsGlobalState);
    template <typename Builder, typename PassData>
    Builder Add(std::string_view passName, PassData*& passData, bool allowsGlobalState = false)
    {
        auto data = std::allocate_shared<PassData>(PooledAllocator<PassData>());
        passData = data.get();
        return {*this, AddPass(passName, allowsGlobalState), std::move(data)};
    }
    TextureHandle HandleOf(const RTHandle& texture) const;
    /// @throws ContractError beginning with `subject`, unless the handle is of this frame
    void ExpectOfFrame(const TextureHandle& texture, const RenderGraphCall& subject) const;
    void ExpectOfFrame(const BufferHandle& buffer, const RenderGraphCall& subject) const;
    std::size_t IndexOf(const RendererListHandle& list, const RenderGraphCall& subject) const;
    const std::shared_ptr<const Material>& CopyMaterial(std::string_view call) const;

    std::unique_ptr<RenderGraphState> m_State;
};

} // namespace limn
