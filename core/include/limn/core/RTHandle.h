#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <limn/core/RenderTexture.h>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace limn
{

class RenderTargetIdentifier;
class ScaledTexture;

/// The sizes of handles that follow the camera's size: the part of a texture that is in use, which
/// is all of it. Unity: UnityEngine.Rendering.RTHandleProperties (core 14).
struct RTHandleProperties
{
    glm::ivec2 previousViewportSize{1};     ///< texels; the camera's before this one
    glm::ivec2 previousRenderTargetSize{1}; ///< texels; equal to it
    glm::ivec2 currentViewportSize{1};      ///< texels; the camera's
    glm::ivec2 currentRenderTargetSize{1};  ///< texels; equal to it
    /// The factor by which shaders multiply coordinates: 1, since textures are never larger than
    /// the part in use.
    glm::vec4 rtHandleScale{1.0f};
};

/// A shared reference to a render texture, or a name that stands for one when a command buffer is
/// executed, or empty. Copies refer to the same texture, which lives as long as some handle to it;
/// nothing has to be released by hand. Unity: UnityEngine.Rendering.RTHandle (core 14).
class RTHandle
{
public:
    RTHandle() = default;
    explicit RTHandle(std::shared_ptr<const RenderTexture> texture) : m_Texture(std::move(texture))
    {
    }

    /// Wraps an identifier: RTHandles::Alloc(RenderTargetIdentifier).
    explicit RTHandle(std::shared_ptr<const RenderTargetIdentifier> identifier)
        : m_Identifier(std::move(identifier))
    {
    }

    /// Makes a handle whose size follows the camera's: RTHandles::Alloc with a scale.
    explicit RTHandle(std::shared_ptr<ScaledTexture> texture) : m_Scaled(std::move(texture)) {}

    explicit operator bool() const
    {
        return m_Texture != nullptr || m_Identifier != nullptr || m_Scaled != nullptr;
    }

    /// Returns the texture, or null for an empty handle and for one that wraps an identifier. If
    /// the size follows the camera's and that has changed, this makes the texture anew.
    const std::shared_ptr<const RenderTexture>& rt() const
    {
        return m_Scaled ? ScaledToCamera() : m_Texture;
    }
    /// Returns whether the size follows the camera's.
    bool useScaling() const { return m_Scaled != nullptr; }
    /// Returns the factor to the camera's size; 0 if the size does not follow it, or follows it by
    /// a function (Unity: 1 then).
    glm::vec2 scaleFactor() const;
    bool isMSAAEnabled() const { return rt() && rt()->descriptor().msaaSamples > 1; }
    /// Returns the size for a camera of the size `refSize`, or the handle's own size if it does not
    /// follow the camera's.
    glm::ivec2 GetScaledSize(const glm::ivec2& refSize) const;
    RTHandleProperties rtHandleProperties() const;
    /// Returns the identifier that stands for it in a command buffer; none for an empty handle.
    RenderTargetIdentifier nameID() const;

    /// Releases the texture or identifier now.
    void Release() { *this = RTHandle(); }
    /// Releases the texture or identifier, for `m_Handle = nullptr`.
    RTHandle& operator=(std::same_as<std::nullptr_t> auto)
    {
        Release();
        return *this;
    }

    bool operator==(const RTHandle&) const = default;
    bool operator==(std::nullptr_t) const { return !*this; }

private:
    const std::shared_ptr<const RenderTexture>& ScaledToCamera() const;

    std::shared_ptr<const RenderTexture> m_Texture;
    std::shared_ptr<ScaledTexture> m_Scaled;                    ///< null = it does not follow
    std::shared_ptr<const RenderTargetIdentifier> m_Identifier; ///< null = it wraps none
};

namespace RTHandles
{

/// Makes a new texture of exactly the descriptor's size. With depthBufferBits it is a depth
/// texture, whatever the colour format is. Unity: RTHandles.Alloc.
/// @throws ContractError as RenderTexture does, for a size below 1 among others
RTHandle Alloc(const RenderTextureDescriptor& descriptor, FilterMode filterMode = FilterMode::Point,
               TextureWrapMode wrapMode = TextureWrapMode::Repeat, std::string name = {});

/// Returns the size of a texture for the size of the camera, in texels. Unity: ScaleFunc (core 14).
using ScaleFunc = std::function<glm::ivec2(const glm::ivec2& size)>;

/// Makes a texture as large as the camera times `scaleFactor`, rounded, and at least 1x1; the
/// descriptor's size is ignored. When the camera's size changes, the handle gets another texture of
/// undefined contents. (Unity: it never shrinks, and shaders must look up the part in use.) Only
/// one thread may use a handle of this kind.
/// @throws ContractError as RenderTexture does; for a factor that is not positive
/// @source Unity: RTHandles.Alloc(Vector2, RenderTextureDescriptor, ...) (core 14)
RTHandle Alloc(const glm::vec2& scaleFactor, const RenderTextureDescriptor& descriptor,
               FilterMode filterMode = FilterMode::Point,
               TextureWrapMode wrapMode = TextureWrapMode::Repeat, std::string name = {});
/// Makes a texture whose size a function computes. @throws ContractError if the function is empty
RTHandle Alloc(ScaleFunc scaleFunc, const RenderTextureDescriptor& descriptor,
               FilterMode filterMode = FilterMode::Point,
               TextureWrapMode wrapMode = TextureWrapMode::Repeat, std::string name = {});
/// Sets the camera's size that those handles follow, in texels, for this thread. The pipeline calls
/// it for each camera that it renders.
/// @throws ContractError unless both are positive
void SetReferenceSize(int width, int height);
// These exist so that lines of C# can be ported as they are.
inline void Initialize(int width, int height)
{
    SetReferenceSize(width, height);
}
inline void ResetReferenceSize(int width, int height)
{
    SetReferenceSize(width, height);
}
int maxWidth();  ///< texels, the camera's
int maxHeight(); ///< texels, the camera's
RTHandleProperties rtHandleProperties();
/// Releases the handle's texture.
inline void Release(RTHandle& handle)
{
    handle.Release();
}

} // namespace RTHandles

/// The arguments of ReAllocateIfNeeded that C# passes by name: `wrapMode: W, name: "_X"` is
/// `{.wrapMode = W, .name = "_X"}`, in this order.
struct ReAllocateArguments
{
    FilterMode filterMode = FilterMode::Point;
    TextureWrapMode wrapMode = TextureWrapMode::Repeat;
    bool isShadowMap = false; ///< a depth that samplers compare with
    int anisoLevel = 1;       ///< see SamplerState
    float mipMapBias = 0.0f;  ///< see SamplerState
    std::string_view name = {};
};

namespace RenderingUtils
{

/// Makes `handle` a texture of this descriptor, filter, wrap mode and name, and keeps the one that
/// it has if all of them match. The contents of a new texture are undefined. A size below 1 becomes
/// 1, so that a half-size descriptor of a 1x1 camera still gives a texture.
/// @return true if the texture was replaced
/// @throws ContractError as RenderTexture does; the handle then keeps what it has
/// @source Unity: RenderingUtils.ReAllocateIfNeeded (URP 14)
bool ReAllocateIfNeeded(RTHandle& handle, RenderTextureDescriptor descriptor,
                        FilterMode filterMode = FilterMode::Point,
                        TextureWrapMode wrapMode = TextureWrapMode::Repeat,
                        std::string_view name = {});
/// Does the same with all arguments of Unity's call.
bool ReAllocateIfNeeded(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                        const ReAllocateArguments& arguments);
bool ReAllocateIfNeeded(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                        FilterMode filterMode, TextureWrapMode wrapMode,
                        std::same_as<bool> auto isShadowMap, int anisoLevel = 1,
                        float mipMapBias = 0.0f, std::string_view name = {})
{
    return ReAllocateIfNeeded(
        handle, descriptor,
        ReAllocateArguments{filterMode, wrapMode, isShadowMap, anisoLevel, mipMapBias, name});
}
/// Unity: RenderingUtils.ReAllocateHandleIfNeeded (URP 17).
inline bool ReAllocateHandleIfNeeded(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                                     FilterMode filterMode, TextureWrapMode wrapMode,
                                     int anisoLevel = 1, float mipMapBias = 0.0f,
                                     std::string_view name = {})
{
    return ReAllocateIfNeeded(
        handle, descriptor,
        ReAllocateArguments{filterMode, wrapMode, false, anisoLevel, mipMapBias, name});
}
inline bool ReAllocateHandleIfNeeded(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                                     const ReAllocateArguments& arguments = {})
{
    return ReAllocateIfNeeded(handle, descriptor, arguments);
}
/// Does the same for a handle whose size follows the camera's.
/// @source Unity: RenderingUtils.ReAllocateIfNeeded(ref RTHandle, Vector2, ...) (URP 14)
bool ReAllocateIfNeeded(RTHandle& handle, const glm::vec2& scaleFactor,
                        const RenderTextureDescriptor& descriptor,
                        FilterMode filterMode = FilterMode::Point,
                        TextureWrapMode wrapMode = TextureWrapMode::Repeat,
                        std::string_view name = {});
bool ReAllocateIfNeeded(RTHandle& handle, const glm::vec2& scaleFactor,
                        const RenderTextureDescriptor& descriptor,
                        const ReAllocateArguments& arguments);
inline bool ReAllocateHandleIfNeeded(RTHandle& handle, const glm::vec2& scaleFactor,
                                     const RenderTextureDescriptor& descriptor,
                                     const ReAllocateArguments& arguments = {})
{
    return ReAllocateIfNeeded(handle, scaleFactor, descriptor, arguments);
}

} // namespace RenderingUtils

} // namespace limn
