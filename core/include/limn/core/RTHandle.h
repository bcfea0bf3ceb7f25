#pragma once

#include <limn/core/RenderTexture.h>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace limn
{

class RenderTargetIdentifier;

/// A shared reference to a render texture, or a name that stands for one when a command buffer is
/// executed, or none. Copies refer to the same texture, which lives as long as some handle to it;
/// there is nothing to release by hand.
/// Unity: UnityEngine.Rendering.RTHandle (core 14).
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

    explicit operator bool() const { return m_Texture != nullptr || m_Identifier != nullptr; }

    /// The texture; null for an empty handle and for one that wraps an identifier.
    const std::shared_ptr<const RenderTexture>& rt() const { return m_Texture; }
    /// What stands for it in a command buffer; none for an empty handle.
    RenderTargetIdentifier nameID() const;

    /// Lets go of the texture or identifier now.
    void Release() { *this = RTHandle(); }

    bool operator==(const RTHandle&) const = default;

private:
    std::shared_ptr<const RenderTexture> m_Texture;
    std::shared_ptr<const RenderTargetIdentifier> m_Identifier; ///< null = it wraps none
};

namespace RTHandles
{

/// A new texture of exactly the descriptor's size. Unity: RTHandles.Alloc.
/// @throws ContractError as RenderTexture does, for a size below 1 among others
RTHandle Alloc(const RenderTextureDescriptor& descriptor, FilterMode filterMode = FilterMode::Point,
               TextureWrapMode wrapMode = TextureWrapMode::Repeat, std::string name = {});

} // namespace RTHandles

namespace RenderingUtils
{

/// Makes `handle` a texture of this descriptor, filter, wrap mode and name, keeping the one it has
/// where all of them match. Contents of a new texture are undefined. A size below 1 becomes 1, so
/// that a half-size descriptor of a 1x1 camera still is a texture.
/// @return true if the texture was replaced
/// @throws ContractError as RenderTexture does; the handle then keeps what it has
/// @source Unity: RenderingUtils.ReAllocateIfNeeded (URP 14)
bool ReAllocateIfNeeded(RTHandle& handle, RenderTextureDescriptor descriptor,
                        FilterMode filterMode = FilterMode::Point,
                        TextureWrapMode wrapMode = TextureWrapMode::Repeat,
                        std::string_view name = {});

} // namespace RenderingUtils

} // namespace limn
