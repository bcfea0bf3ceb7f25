#pragma once

#include <limn/core/PooledAllocator.h>
#include <limn/core/RenderGraphCommandBuffer.h>

namespace limn
{

struct RenderGraphPass;
struct RenderGraphCall;

/// Records a pass of a render graph.
template <typename Commands>
struct RenderGraphFunction
{
    virtual ~RenderGraphFunction() = default;
    virtual void Record(Commands& cmd) = 0;
};

namespace detail
{

/// An author's render function with the data that it is given.
template <typename Commands, typename Context, typename PassData, typename Function>
struct AuthorsRenderFunction final : RenderGraphFunction<Commands>
{
    std::shared_ptr<PassData> data;
    Function function;

    AuthorsRenderFunction(std::shared_ptr<PassData> passData, Function&& toCall)
        : data(std::move(passData)), function(std::move(toCall))
    {
    }
    void Record(Commands& cmd) override
    {
        Context context{cmd};
        function(*data, context);
    }
};

template <typename Commands, typename Context, typename PassData, typename Function>
std::shared_ptr<RenderGraphFunction<Commands>>
MakeRenderFunction(const std::shared_ptr<PassData>& data, Function&& function)
{
    using Made = AuthorsRenderFunction<Commands, Context, PassData, Function>;
    return std::allocate_shared<Made>(PooledAllocator<Made>(), data, std::move(function));
}

} // namespace detail

/// Declares what a pass of a render graph does. Each call throws ContractError, naming pass and
/// texture, for an empty handle, one of an earlier frame or of another pass's transient texture,
/// and for what it says itself. Whether the pass does as declared is found out when it has run.
/// In C# it is disposed of; here its scope ends, and nothing happens.
/// Unity: UnityEngine.Rendering.RenderGraphModule.IBaseRenderGraphBuilder (core 17).
class BaseRenderGraphBuilder
{
public:
    BaseRenderGraphBuilder(const BaseRenderGraphBuilder&) = delete;
    BaseRenderGraphBuilder& operator=(const BaseRenderGraphBuilder&) = delete;

    /// @throws ContractError if the texture is an attachment of the pass, or written twice
    void UseTexture(const TextureHandle& input, AccessFlags flags = AccessFlags::Read);
    /// @throws ContractError if the pass uses the buffer otherwise already
    BufferHandle UseBuffer(const BufferHandle& input, AccessFlags flags = AccessFlags::Read);
    /// What is global under the name when the pass runs. @throws ContractError behind it, if
    /// nothing is
    void UseGlobalTexture(ShaderPropertyId propertyId, AccessFlags flags = AccessFlags::Read);
    /// Shaders may sample whatever is global: nothing is said about textures that they read.
    void UseAllGlobalTextures(bool enable);
    void SetGlobalTextureAfterPass(const TextureHandle& input, ShaderPropertyId propertyId);
    /// A texture that this pass alone reads and writes.
    TextureHandle CreateTransientTexture(const TextureDesc& desc);
    TextureHandle CreateTransientTexture(const TextureHandle& texture);
    /// A buffer for this pass, with whatever is in it.
    BufferHandle CreateTransientBuffer(const BufferDesc& desc);
    BufferHandle CreateTransientBuffer(const BufferHandle& computebuffer);
    void UseRendererList(const RendererListHandle& input);
    /// False: what it draws is run whoever reads it. As by default it is left out where nothing
    /// does.
    void AllowPassCulling(bool value);
    /// True: the pass may set globals, and is not culled.
    void AllowGlobalStateModification(bool value);
    /// No effect: limn has one queue, and the pass runs where it stands.
    void EnableAsyncCompute(bool) {}

protected:
    BaseRenderGraphBuilder(RenderGraph& graph, RenderGraphPass& pass) : m_Graph(graph), m_Pass(pass)
    {
    }
    ~BaseRenderGraphBuilder() = default;
    void SetAttachment(const TextureHandle& texture, int index, AccessFlags flags);
    void SetDepthAttachment(const TextureHandle& texture, AccessFlags flags);
    void SetFunction(std::shared_ptr<RenderGraphFunction<RasterCommandBuffer>> function);
    void SetFunction(std::shared_ptr<RenderGraphFunction<UnsafeCommandBuffer>> function);
    void SetFunction(std::shared_ptr<RenderGraphFunction<ComputeCommandBuffer>> function);

private:
    void ExpectUsable(const TextureHandle& texture, const RenderGraphCall& subject) const;

    RenderGraph& m_Graph;
    RenderGraphPass& m_Pass;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.IRasterRenderGraphBuilder (core 17).
template <typename PassData>
class RasterRenderGraphBuilder : public BaseRenderGraphBuilder
{
public:
    /// What the texture holds stays where nothing is drawn, whatever `flags` are; with WriteAll it
    /// need not.
    /// @param index  0 ... 7; none below it may be left out
    /// @throws ContractError if the texture is used otherwise by the pass, the index is taken, or
    ///         it is a depth texture
    void SetRenderAttachment(const TextureHandle& tex, int index,
                             AccessFlags flags = AccessFlags::Write)
    {
        SetAttachment(tex, index, flags);
    }
    /// @throws ContractError as SetRenderAttachment, and if it is no depth texture
    void SetRenderAttachmentDepth(const TextureHandle& tex,
                                  AccessFlags flags = AccessFlags::ReadWrite)
    {
        SetDepthAttachment(tex, flags);
    }
    /// @param function  (PassData&, RasterGraphContext&): records the pass, once
    template <std::invocable<PassData&, RasterGraphContext&> Function>
    void SetRenderFunc(Function function)
    {
        SetFunction(detail::MakeRenderFunction<RasterCommandBuffer, RasterGraphContext>(
            m_Data, std::move(function)));
    }

private:
    friend class RenderGraph;
    RasterRenderGraphBuilder(RenderGraph& graph, RenderGraphPass& pass,
                             std::shared_ptr<PassData> data)
        : BaseRenderGraphBuilder(graph, pass), m_Data(std::move(data))
    {
    }
    std::shared_ptr<PassData> m_Data;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.IUnsafeRenderGraphBuilder (core 17).
template <typename PassData>
class UnsafeRenderGraphBuilder : public BaseRenderGraphBuilder
{
public:
    /// As of a raster pass: it is bound when the render function begins.
    void SetRenderAttachment(const TextureHandle& tex, int index,
                             AccessFlags flags = AccessFlags::Write)
    {
        SetAttachment(tex, index, flags);
    }
    void SetRenderAttachmentDepth(const TextureHandle& tex,
                                  AccessFlags flags = AccessFlags::ReadWrite)
    {
        SetDepthAttachment(tex, flags);
    }
    /// @param function  (PassData&, UnsafeGraphContext&): records the pass, once. It may set
    ///                  targets itself
    template <std::invocable<PassData&, UnsafeGraphContext&> Function>
    void SetRenderFunc(Function function)
    {
        SetFunction(detail::MakeRenderFunction<UnsafeCommandBuffer, UnsafeGraphContext>(
            m_Data, std::move(function)));
    }

private:
    friend class RenderGraph;
    UnsafeRenderGraphBuilder(RenderGraph& graph, RenderGraphPass& pass,
                             std::shared_ptr<PassData> data)
        : BaseRenderGraphBuilder(graph, pass), m_Data(std::move(data))
    {
    }
    std::shared_ptr<PassData> m_Data;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.IComputeRenderGraphBuilder (core 17).
template <typename PassData>
class ComputeRenderGraphBuilder : public BaseRenderGraphBuilder
{
public:
    /// @param function  (PassData&, ComputeGraphContext&): records the pass, once
    template <std::invocable<PassData&, ComputeGraphContext&> Function>
    void SetRenderFunc(Function function)
    {
        SetFunction(detail::MakeRenderFunction<ComputeCommandBuffer, ComputeGraphContext>(
            m_Data, std::move(function)));
    }

private:
    friend class RenderGraph;
    ComputeRenderGraphBuilder(RenderGraph& graph, RenderGraphPass& pass,
                              std::shared_ptr<PassData> data)
        : BaseRenderGraphBuilder(graph, pass), m_Data(std::move(data))
    {
    }
    std::shared_ptr<PassData> m_Data;
};

} // namespace limn
