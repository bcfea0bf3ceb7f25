#pragma once

#include <limn/core/RTHandle.h>
#include <limn/core/ShaderId.h>
#include <variant>

namespace limn
{

/// Targets that are there by themselves, values Unity's.
/// Unity: UnityEngine.Rendering.BuiltinRenderTextureType (2022.3), the members that limn has.
enum class BuiltinRenderTextureType
{
    None = 0,
    CurrentActive = 1, ///< what is bound when the command is executed
    /// What the camera is drawn into, colour and depth, as ScriptableRenderer's
    /// cameraColorTargetHandle. (Unity: the back buffer, which URP's final blit writes over.)
    CameraTarget = 2,
    CameraColor = 256 ///< limn's own: the camera's colour alone, see cameraColorTarget
};

// What a target is bound with; limn works out by itself what has to be loaded and stored, from what
// is read later, and keeps no less than is asked for.

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

/// What a command buffer draws into or reads, looked up when the buffer is executed: a texture, a
/// name given by CommandBuffer::GetTemporaryRT or SetGlobalTexture, or one of the built-in ones.
/// Unity: UnityEngine.Rendering.RenderTargetIdentifier (2022.3).
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
    /// Its nameID(). @throws ContractError for an empty handle
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

/// A handle for whoever takes handles, around what a name, a texture or CameraTarget stands for
/// when a command buffer is executed; its rt() is null.
/// @throws ContractError if the identifier is none
/// @source Unity: RTHandles.Alloc(RenderTargetIdentifier), Alloc(Texture) (core 14)
RTHandle Alloc(RenderTargetIdentifier texture);
/// Wraps the texture itself. @throws ContractError if it is null
/// @source Unity: RTHandles.Alloc(RenderTexture) (core 14), whose Release destroys the texture
RTHandle Alloc(std::shared_ptr<const RenderTexture> texture);
RTHandle Alloc(const RTHandle&) = delete; ///< it is one already

} // namespace RTHandles

/// A name for a temporary texture, or the camera's target, which one that was not initialised is.
/// Unity: UnityEngine.Rendering.Universal.RenderTargetHandle (URP 12).
class RenderTargetHandle
{
public:
    ShaderPropertyId id; ///< for CommandBuffer::GetTemporaryRT; the empty name unless by a name

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
