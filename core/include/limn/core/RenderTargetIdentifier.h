#pragma once

#include <limn/core/RTHandle.h>
#include <limn/core/ShaderId.h>
#include <variant>

namespace limn
{

/// The built-in targets that limn has, with Unity's values.
/// Unity: UnityEngine.Rendering.BuiltinRenderTextureType (2022.3).
enum class BuiltinRenderTextureType
{
    None = 0,
    CurrentActive = 1, ///< the target that is bound when the command is executed
    /// The target of the camera, colour and depth, as ScriptableRenderer's cameraColorTargetHandle.
    /// (Unity: the back buffer, which URP's final blit overwrites.)
    CameraTarget = 2,
    CameraColor = 256 ///< limn's own: the camera's colour alone, see cameraColorTarget
};

// These are the actions with which a target is bound. From what is read later, limn derives by
// itself what must be loaded and stored, and keeps no less than is requested.

/// Unity: UnityEngine.Rendering.RenderBufferLoadAction (2022.3).
enum class RenderBufferLoadAction
{
    Load = 0,
    Clear = 1,
    DontCare = 2
};

/// Unity: UnityEngine.Rendering.RenderBufferStoreAction (2022.3).
enum class RenderBufferStoreAction
{
    Store = 0,
    Resolve = 1,
    StoreAndResolve = 2,
    DontCare = 3
};

/// Names what a command buffer draws into or reads, and is looked up when the buffer is executed: a
/// texture, a name given by CommandBuffer::GetTemporaryRT or SetGlobalTexture, or a built-in
/// target. Unity: UnityEngine.Rendering.RenderTargetIdentifier (2022.3).
class RenderTargetIdentifier
{
public:
    using Content =
        std::variant<BuiltinRenderTextureType, ShaderPropertyId, std::shared_ptr<const Texture>>;

    RenderTargetIdentifier() = default; ///< none
    RenderTargetIdentifier(BuiltinRenderTextureType type) : m_Content(type) {}
    RenderTargetIdentifier(ShaderPropertyId name) : m_Content(name) {}
    template <std::convertible_to<std::string_view> Text>
    RenderTargetIdentifier(const Text& name) : m_Content(ShaderPropertyId(name))
    {
    }
    /// Makes the identifier of a handle, its nameID(). @throws ContractError for an empty handle
    RenderTargetIdentifier(const RTHandle& handle);
    /// @param texture  null = none
    RenderTargetIdentifier(std::shared_ptr<const Texture> texture);

    const Content& content() const { return m_Content; }
    bool operator==(const RenderTargetIdentifier&) const = default;

private:
    Content m_Content = BuiltinRenderTextureType::None;
};

namespace RTHandles
{

/// Makes a handle for the texture that a name, a texture or CameraTarget stands for when a command
/// buffer is executed, for functions that take handles; its rt() is null.
/// @throws ContractError if the identifier is none
/// @source Unity: RTHandles.Alloc(RenderTargetIdentifier), Alloc(Texture) (core 14)
RTHandle Alloc(RenderTargetIdentifier texture);
/// Makes a handle of the texture itself. @throws ContractError if it is null
/// @source Unity: RTHandles.Alloc(RenderTexture) (core 14), whose Release destroys the texture
RTHandle Alloc(std::shared_ptr<const RenderTexture> texture);
RTHandle Alloc(const RTHandle&) = delete; ///< it is one already

} // namespace RTHandles

/// The name of a temporary texture, or the camera's target if it was not initialised.
/// Unity: UnityEngine.Rendering.Universal.RenderTargetHandle (URP 12).
class RenderTargetHandle
{
public:
    ShaderPropertyId id; ///< for CommandBuffer::GetTemporaryRT; empty unless initialised by a name

    static const RenderTargetHandle CameraTarget;

    RenderTargetHandle() = default;
    explicit RenderTargetHandle(RenderTargetIdentifier identifier)
        : m_Identifier(std::move(identifier))
    {
    }

    void Init(ShaderPropertyId shaderProperty)
    {
        id = shaderProperty;
        m_Identifier = shaderProperty;
    }
    template <std::convertible_to<std::string_view> Text>
    void Init(const Text& shaderProperty)
    {
        Init(ShaderPropertyId(shaderProperty));
    }
    void Init(RenderTargetIdentifier renderTargetIdentifier)
    {
        id = {};
        m_Identifier = std::move(renderTargetIdentifier);
    }
    const RenderTargetIdentifier& Identifier() const { return m_Identifier; }

    bool operator==(const RenderTargetHandle&) const = default;

private:
    RenderTargetIdentifier m_Identifier = BuiltinRenderTextureType::CameraTarget;
};

inline const RenderTargetHandle RenderTargetHandle::CameraTarget{};

} // namespace limn
