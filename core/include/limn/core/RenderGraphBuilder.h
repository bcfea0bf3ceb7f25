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

/// The render function of a pass of any kind; null if the pass has none.
using AnyRenderGraphFunction =
    std::variant<std::shared_ptr<RenderGraphFunction<RasterCommandBuffer>>,
                 std::shared_ptr<RenderGraphFunction<UnsafeCommandBuffer>>,
                 std::shared_ptr<RenderGraphFunction<ComputeCommandBuffer>>>;

namespace detail
{

template <typename Context>
using CommandsOf = std::remove_reference_t<decltype(Context::cmd)>;

/// An author's render function with the data that it receives.
template <typename Context, typename PassData, typename Function>
struct AuthorsRenderFunction final : RenderGraphFunction<CommandsOf<Context>>
{
    std::shared_ptr<PassData> data;
    Function function;

    AuthorsRenderFunction(std::shared_ptr<PassData> passData, Function&& toCall)
        : data(std::move(passData)), function(std::move(toCall))
    {
    }
    void Record(CommandsOf<Context>& cmd) override
    {
        Context context{cmd};
        function(*data, context);
    }
};

} // namespace detail

/// Declares what a pass of a render graph does. Each call throws ContractError, naming pass and
/// texture, for an empty handle, a handle of an earlier frame or of another pass's transient
/// texture, and in the cases that it documents itself. Whether the pass does as declared is checked
/// when it has run. In C# a builder is disposed of; here its scope ends, and nothing happens.
/// Unity: UnityEngine.Rendering.RenderGraphModule.IBaseRenderGraphBuilder (core 17).
class BaseRenderGraphBuilder
{
public:
    BaseRenderGraphBuilder(const BaseRenderGraphBuilder&) = delete;
    BaseRenderGraphBuilder& operator=(const BaseRenderGraphBuilder&) = delete;

    /// @throws ContractError if the texture is an attachment of the pass, or written twice
    void UseTexture(const TextureHandle& input, AccessFlags flags = AccessFlags::Read);
    /// @throws ContractError if the pass already uses the buffer in another way
    BufferHandle UseBuffer(const BufferHandle& input, AccessFlags flags = AccessFlags::Read);
    /// Declares that the pass uses the texture that is global under the name when it runs.
    /// @throws ContractError after the pass, if no texture is
    void UseGlobalTexture(ShaderPropertyId propertyId, AccessFlags flags = AccessFlags::Read);
    /// Allows shaders to sample any global texture: the textures that they read are not checked.
    void UseAllGlobalTextures(bool enable);
    void SetGlobalTextureAfterPass(const TextureHandle& input, ShaderPropertyId propertyId);
    /// Makes a texture that only this pass reads and writes.
    TextureHandle CreateTransientTexture(const TextureDesc& desc);
    TextureHandle CreateTransientTexture(const TextureHandle& texture);
    /// Makes a buffer for this pass, whose contents are undefined.
    BufferHandle CreateTransientBuffer(const BufferDesc& desc);
    BufferHandle CreateTransientBuffer(const BufferHandle& computebuffer);
    void UseRendererList(const RendererListHandle& input);
    /// Sets whether the pass may be culled. If false, it is run even if nothing reads what it
    /// draws; by default it is left out then.
    void AllowPassCulling(bool value);
    /// Sets whether the pass may set globals; if true, it is not culled. An unsafe pass may set
    /// them without that.
    void AllowGlobalStateModification(bool value);
    /// Has no effect: limn has one queue, and the pass runs in its place.
    void EnableAsyncCompute(bool) {}

protected:
    BaseRenderGraphBuilder(RenderGraph& graph, RenderGraphPass& pass) : m_Graph(graph), m_Pass(pass)
    {
    }
    ~BaseRenderGraphBuilder() = default;
    void SetRenderAttachment(const TextureHandle& tex, int index,
                             AccessFlags flags = AccessFlags::Write);
    void SetRenderAttachmentDepth(const TextureHandle& tex,
                                  AccessFlags flags = AccessFlags::ReadWrite);
    void SetInputAttachment(const TextureHandle& tex, int index,
                            AccessFlags flags = AccessFlags::Read);
    void SetFunction(AnyRenderGraphFunction function);

private:
    void ExpectUsable(const TextureHandle& texture, const RenderGraphCall& subject) const;

    RenderGraph& m_Graph;
    RenderGraphPass& m_Pass;
};

/// A builder that knows the data of its pass.
template <typename PassData, typename Context>
class RenderGraphBuilderWith : public BaseRenderGraphBuilder
{
public:
    RenderGraphBuilderWith(RenderGraph& graph, RenderGraphPass& pass,
                           std::shared_ptr<PassData> data)
        : BaseRenderGraphBuilder(graph, pass), m_Data(std::move(data))
    {
    }
    /// @param function  (PassData&, Context&): records the pass; it is called once. That of an
    ///     unsafe pass may set targets itself.
    template <std::invocable<PassData&, Context&> Function>
    void SetRenderFunc(Function function)
    {
        using Made = detail::AuthorsRenderFunction<Context, PassData, Function>;
        SetFunction(
            std::allocate_shared<Made>(PooledAllocator<Made>(), m_Data, std::move(function)));
    }

private:
    std::shared_ptr<PassData> m_Data;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.IRasterRenderGraphBuilder (core 17).
template <typename PassData>
class RasterRenderGraphBuilder : public RenderGraphBuilderWith<PassData, RasterGraphContext>
{
    using Base = RenderGraphBuilderWith<PassData, RasterGraphContext>;

public:
    using Base::Base;
    /// Binds a colour target. The texture's contents stay where nothing is drawn, whatever `flags`
    /// are; with WriteAll they need not.
    /// @param index  0 ... 7; no lower index may be left out
    /// @throws ContractError if the pass uses the texture in another way, the index is taken, or it
    ///     is a depth texture
    using Base::SetRenderAttachment;
    /// @throws ContractError as SetRenderAttachment does, and if it is no depth texture
    using Base::SetRenderAttachmentDepth;
    /// Lets shaders read the texture with LOAD_FRAMEBUFFER_INPUT_X(index, positionCS.xy): the texel
    /// at their own place. The texture is global as _UnityFBInput0 ... 7 from then on, as in Unity
    /// where the device cannot keep it within a tile.
    /// @param index  0 ... 7
    /// @throws ContractError if the pass uses the texture in another way, or the index is taken
    using Base::SetInputAttachment;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.IUnsafeRenderGraphBuilder (core 17).
template <typename PassData>
class UnsafeRenderGraphBuilder : public RenderGraphBuilderWith<PassData, UnsafeGraphContext>
{
    using Base = RenderGraphBuilderWith<PassData, UnsafeGraphContext>;

public:
    using Base::Base;
    /// Binds a colour target as a raster pass does; it is bound when the render function begins.
    using Base::SetRenderAttachment;
    using Base::SetRenderAttachmentDepth;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.IComputeRenderGraphBuilder (core 17).
template <typename PassData>
class ComputeRenderGraphBuilder : public RenderGraphBuilderWith<PassData, ComputeGraphContext>
{
public:
    using RenderGraphBuilderWith<PassData, ComputeGraphContext>::RenderGraphBuilderWith;
};

} // namespace limn
