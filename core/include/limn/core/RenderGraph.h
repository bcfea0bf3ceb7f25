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

/// What AddBlitPass draws: the source as _BlitTexture, with one triangle over the destination.
struct BlitMaterialParameters
{
    TextureHandle source;
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

/// Unity 6's way to write a ScriptableRenderPass: its RecordRenderGraph adds passes, each with what
/// it reads and writes and a function that records it. They run in their order when
/// RecordRenderGraph returns, and the frame compiler does with them what it does with all passes:
/// culling, load and store, memory. Beside that each is compared with what its author declared:
/// what Unity throws for or draws otherwise is a ContractError with all of it, with the lines to
/// add; what is missing and harmless there, and what is declared for nothing, a note in the report.
/// Unity: UnityEngine.Rendering.RenderGraphModule.RenderGraph (core 17).
class RenderGraph
{
public:
    RenderGraph();
    ~RenderGraph();
    RenderGraph(const RenderGraph&) = delete;
    RenderGraph& operator=(const RenderGraph&) = delete;

    /// A texture until the camera is done. A frame that asks for the same as the one before gets
    /// the same textures.
    /// @throws ContractError as RenderTexture does
    TextureHandle CreateTexture(const TextureDesc& desc);
    TextureHandle CreateTexture(const TextureHandle& texture); ///< one like it
    /// One like it of another name; `clear`: a pass that draws into it first clears it.
    TextureHandle CreateTexture(const TextureHandle& texture, std::string_view name,
                                bool clear = false);
    /// A texture of the pass's own; once more gives the same handle.
    /// @throws ContractError if there is no texture
    TextureHandle ImportTexture(const RTHandle& rt, const ImportResourceParams& importParams = {});
    /// A buffer until the camera is done. A frame that asks for the same as the one before gets the
    /// same buffers, with what is in them.
    /// @throws ContractError as GraphicsBuffer does
    BufferHandle CreateBuffer(const BufferDesc& desc);
    /// A buffer of the pass's own; once more gives the same handle.
    /// @throws ContractError if it is null
    BufferHandle ImportBuffer(const std::shared_ptr<const GraphicsBuffer>& graphicsBuffer);
    /// @throws ContractError if there is no texture, or it is one of an earlier frame
    TextureDesc GetTextureDesc(const TextureHandle& texture) const;
    RenderTargetInfo GetRenderTargetInfo(const TextureHandle& texture) const;
    /// Makes a texture where the handle has none. Unity: RenderGraph.CreateTextureIfInvalid.
    void CreateTextureIfInvalid(const TextureDesc& desc, TextureHandle& texture);
    /// @throws ContractError if there is no buffer, or it is one of an earlier frame
    BufferDesc GetBufferDesc(const BufferHandle& graphicsBuffer) const;
    RendererListHandle CreateRendererList(const RendererListParams& desc);
    RendererListHandle CreateRendererList(const RendererListDesc& desc);

    /// @param passData  becomes the pass's data, made anew, which the render function is given
    template <typename PassData>
    RasterRenderGraphBuilder<PassData> AddRasterRenderPass(std::string_view passName,
                                                           PassData*& passData)
    {
        auto data = std::allocate_shared<PassData>(PooledAllocator<PassData>());
        passData = data.get();
        return {*this, AddPass(passName), std::move(data)};
    }
    template <typename PassData>
    UnsafeRenderGraphBuilder<PassData> AddUnsafePass(std::string_view passName, PassData*& passData)
    {
        auto data = std::allocate_shared<PassData>(PooledAllocator<PassData>());
        passData = data.get();
        return {*this, AddPass(passName), std::move(data)};
    }
    template <typename PassData>
    ComputeRenderGraphBuilder<PassData> AddComputePass(std::string_view passName,
                                                       PassData*& passData)
    {
        auto data = std::allocate_shared<PassData>(PooledAllocator<PassData>());
        passData = data.get();
        return {*this, AddPass(passName), std::move(data)};
    }

    // The same with a sampler, which changes nothing: a pass is shown by its name.
    template <typename PassData>
    RasterRenderGraphBuilder<PassData>
    AddRasterRenderPass(std::string_view passName, PassData*& passData, const ProfilingSampler&)
    {
        return AddRasterRenderPass<PassData>(passName, passData);
    }
    template <typename PassData>
    UnsafeRenderGraphBuilder<PassData> AddUnsafePass(std::string_view passName, PassData*& passData,
                                                     const ProfilingSampler&)
    {
        return AddUnsafePass<PassData>(passName, passData);
    }
    template <typename PassData>
    ComputeRenderGraphBuilder<PassData> AddComputePass(std::string_view passName,
                                                       PassData*& passData, const ProfilingSampler&)
    {
        return AddComputePass<PassData>(passName, passData);
    }

    /// Draws the source through the material over the whole destination, whose contents stay where
    /// it blends. The material may sample whatever is global.
    /// @throws ContractError if the material is null
    void AddBlitPass(const RenderGraphUtils::BlitMaterialParameters& blitParameters,
                     std::string_view passName = "BlitMaterial");
    /// Draws a part of the source, of size `scale` from `offset` on (1 = the whole), over the whole
    /// destination.
    void AddBlitPass(const TextureHandle& source, const TextureHandle& destination,
                     const glm::vec2& scale, const glm::vec2& offset,
                     RenderGraphUtils::BlitFilterMode filterMode =
                         RenderGraphUtils::BlitFilterMode::ClampBilinear,
                     std::string_view passName = "BlitTexture");
    /// Copies texel for texel.
    /// @throws ContractError unless both are colours of one size, format and number of samples
    void AddCopyPass(const TextureHandle& source, const TextureHandle& destination,
                     std::string_view passName = "CopyTexture");

private:
    friend class BaseRenderGraphBuilder;
    friend class RenderGraphCamera;
    friend class RenderGraphRun;
    RenderGraphPass& AddPass(std::string_view name);
    TextureHandle HandleOf(const RTHandle& texture) const;
    /// @throws ContractError beginning with `subject`, unless the handle is of this frame
    void ExpectOfFrame(const TextureHandle& texture, const RenderGraphCall& subject) const;
    void ExpectOfFrame(const BufferHandle& buffer, const RenderGraphCall& subject) const;
    std::size_t IndexOf(const RendererListHandle& list, const RenderGraphCall& subject) const;
    const std::shared_ptr<const Material>& CopyMaterial(std::string_view call) const;

    std::unique_ptr<RenderGraphState> m_State;
};

} // namespace limn
