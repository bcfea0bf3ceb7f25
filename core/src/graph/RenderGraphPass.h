#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <limn/core/RenderGraph.h>

namespace limn
{

template <typename T>
using PooledVector = std::vector<T, PooledAllocator<T>>;
template <typename T>
using PooledDeque = std::deque<T, PooledAllocator<T>>;

template <typename T>
bool Has(const PooledVector<T>& list, const T& value)
{
    return std::ranges::find(list, value) != list.end();
}

/// The beginning of a message, which is put together only when there is a message.
struct RenderGraphCall
{
    std::string_view before;
    std::string_view name; ///< the name of a pass
    std::string_view behind;

    std::string text() const;
};

/// A pass as its author declared it.
struct RenderGraphPass
{
    struct Use
    {
        RTHandle texture;
        AccessFlags flags = AccessFlags::None;
        bool isAttachment = false;
    };
    struct BufferUse
    {
        std::shared_ptr<const GraphicsBuffer> buffer;
        AccessFlags flags = AccessFlags::None;
    };
    struct GlobalUse
    {
        ShaderPropertyId id;
        AccessFlags flags = AccessFlags::None;
    };
    struct GlobalTexture
    {
        ShaderPropertyId id;
        RTHandle texture;
    };

    SampleName name;
    AnyRenderGraphFunction function;
    PooledVector<Use> uses;
    PooledVector<BufferUse> buffers;
    std::array<RTHandle, k_MostColors> colors;
    RTHandle depth;
    PooledVector<GlobalUse> globalUses;
    PooledVector<GlobalTexture> inputs; ///< global while the pass records
    PooledVector<GlobalTexture> globalsAfter;
    PooledVector<std::size_t> rendererLists;
    bool usesAllGlobals = false;
    bool allowsCulling = true;
    bool allowsGlobalState = false;

    const Use* FindUse(const RTHandle& texture) const;
    const BufferUse* FindUse(const GraphicsBuffer& buffer) const;
    bool Declares(const RTHandle& texture, AccessFlags flags) const;
};

/// A texture that a handle stands for.
struct RenderGraphTexture
{
    RTHandle texture;
    bool isMade = false;                    ///< by the graph
    bool clears = false;                    ///< if true, it is cleared before it is first written
    Color clearColor;                       ///< linear
    bool isWritten = false;                 ///< by a pass that has run
    const RenderGraphPass* owner = nullptr; ///< the pass of a transient one
    /// The feature's name for the handle if it is one of UniversalResourceData; "" = one of its
    /// own.
    std::string_view handle = {};
};

/// A buffer that a handle stands for.
struct RenderGraphBuffer
{
    std::shared_ptr<const GraphicsBuffer> buffer;
    bool isMade = false;    ///< by the graph
    bool isWritten = false; ///< by a pass that has run
};

/// The state of one camera, except for the textures and buffers, which later frames use again.
struct RenderGraphState
{
    struct Kept
    {
        RTHandle texture;
        bool isTaken = false;
        int idleFrames = 0; ///< since it was last taken
    };

    struct KeptBuffer
    {
        BufferDesc desc;
        std::shared_ptr<const GraphicsBuffer> buffer;
        bool isTaken = false;
        int idleFrames = 0; ///< since it was last taken
    };

    std::uint64_t frame = 1; ///< of the handles that are given out
    std::vector<Kept> kept;
    std::vector<KeptBuffer> keptBuffers;
    std::vector<RenderGraphTexture> textures;
    std::vector<RenderGraphBuffer> buffers;
    PooledDeque<RendererListParams> rendererLists;
    PooledDeque<RenderGraphPass> passes; ///< of the camera so far
    std::size_t ran = 0;                 ///< of them, these have run
    std::shared_ptr<const Material> copy;

    RenderGraphTexture* Find(const Texture& texture);
    RenderGraphBuffer* Find(const GraphicsBuffer& buffer);
};

} // namespace limn
