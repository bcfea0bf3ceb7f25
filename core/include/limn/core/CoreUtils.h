#pragma once

#include <limn/core/CommandBuffer.h>
#include <limn/core/SystemInfo.h>
#include <utility>

namespace limn
{

class BaseCommandBuffer;
class ScriptableRenderContext;
struct Camera;

/// A command buffer, or the one of a render graph's pass, for calls that record into either. A
/// graph pass declares what such a call reads as it does for any other draw.
class AnyCommandBuffer
{
public:
    AnyCommandBuffer(CommandBuffer& cmd) : m_Cmd(cmd) {}
    AnyCommandBuffer(BaseCommandBuffer& cmd);

    operator CommandBuffer&() const { return m_Cmd; }
    CommandBuffer* operator->() const { return &m_Cmd; }

private:
    CommandBuffer& m_Cmd;
};

/// Unity: UnityEngine.Rendering.CoreUtils (core 14).
namespace CoreUtils
{

/// Binds a target and clears the aspects in `clearFlag`; depth clears to far, stencil to 0.
void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);
void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color, const RTHandle& depth,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);
void SetRenderTarget(CommandBuffer& cmd, std::span<const RTHandle> colors, const RTHandle& depth,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);

void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);
void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color, RenderTargetIdentifier depth,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);
// These ignore the load and store actions, because limn derives them.
// @throws ContractError for RenderBufferLoadAction::Clear
void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color, RenderBufferLoadAction loadAction,
                     RenderBufferStoreAction storeAction, ClearFlag clearFlag = ClearFlag::None,
                     const Color& clearColor = Color::clear);
void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color,
                     RenderBufferLoadAction colorLoadAction,
                     RenderBufferStoreAction colorStoreAction, const RTHandle& depth,
                     RenderBufferLoadAction depthLoadAction,
                     RenderBufferStoreAction depthStoreAction,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);
void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color,
                     RenderBufferLoadAction loadAction, RenderBufferStoreAction storeAction,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);
void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color,
                     RenderBufferLoadAction colorLoadAction,
                     RenderBufferStoreAction colorStoreAction, RenderTargetIdentifier depth,
                     RenderBufferLoadAction depthLoadAction,
                     RenderBufferStoreAction depthStoreAction,
                     ClearFlag clearFlag = ClearFlag::None, const Color& clearColor = Color::clear);

/// Clears the bound target; depth clears to far, stencil to 0.
inline void ClearRenderTarget(CommandBuffer& cmd, ClearFlag clearFlag, const Color& clearColor)
{
    cmd.ClearRenderTarget(clearFlag, clearColor);
}
/// Sets a viewport as large as the target. @throws ContractError for a handle without a texture
void SetViewport(CommandBuffer& cmd, const RTHandle& target);

/// Makes a material for a pass of one's own.
/// @throws ContractError if shader is null (Unity logs and returns null, which crashes later)
std::shared_ptr<Material> CreateEngineMaterial(std::shared_ptr<const Shader> shader);
/// Makes a material with the shader that Shader::Find(shaderPath) returns.
/// @throws ContractError that names the shader, if there is none of this name
std::shared_ptr<Material> CreateEngineMaterial(const std::string& shaderPath);

/// Draws one triangle over the whole of the bound target: three vertices, of which the shader's
/// vertex function sees SV_VertexID only.
/// @throws ContractError if the material is null or has no such pass
void DrawFullScreen(AnyCommandBuffer cmd, std::shared_ptr<const Material> material,
                    const MaterialPropertyBlock& properties = {}, int shaderPassId = 0);

/// Switches a keyword, for all draws that follow or for a material.
void SetKeyword(CommandBuffer& cmd, std::string_view keyword, bool state);
void SetKeyword(Material& material, const std::string& keyword, bool state);
void SetKeyword(ComputeShader& cs, std::string_view keyword, bool state);

/// Draws a renderer list; it exists so that lines of C# can be ported as they are. @throws
/// ContractError for an empty list
void DrawRendererList(ScriptableRenderContext& renderContext, CommandBuffer& cmd,
                      const RendererList& rendererList);

/// Returns an sRGB colour, or a linear one, in the colour space of the process, as Unity's
/// functions of these names do (core 14). See QualitySettings::activeColorSpace.
Color ConvertSRGBToActiveColorSpace(const Color& color);
Color ConvertLinearToActiveColorSpace(const Color& color);

// Unity's scene views can switch these off; limn has no editor. Unity: CoreUtils (core 14).
inline bool IsSceneViewFogEnabled(const Camera&)
{
    return true;
}
inline bool ArePostProcessesEnabled(const Camera&)
{
    return true;
}

/// Makes a box of eight vertices without normals, for effects that are drawn inside or outside of
/// it.
/// @param min, max  opposite corners
/// @source Unity: CoreUtils.CreateCubeMesh (core 14)
std::shared_ptr<const Mesh> CreateCubeMesh(const glm::vec3& min, const glm::vec3& max);

/// Returns how many groups of `divisor` hold `value`. Unity: CoreUtils.DivRoundUp.
constexpr int DivRoundUp(int value, int divisor)
{
    return (value + divisor - 1) / divisor;
}

/// Unity: CoreUtils.HasFlag.
template <typename Flags>
constexpr bool HasFlag(Flags mask, Flags flag)
{
    return (static_cast<int>(mask) & static_cast<int>(flag)) == static_cast<int>(flag);
}

/// Releases a buffer; does nothing for null. Unity: CoreUtils.SafeRelease.
inline void SafeRelease(const std::shared_ptr<GraphicsBuffer>& buffer)
{
    if (buffer)
    {
        buffer->Release();
    }
}

/// Unity: CoreUtils.Swap.
template <typename T>
void Swap(T& a, T& b)
{
    std::swap(a, b);
}

/// Releases a material or texture, which is destroyed when nothing else holds it. C++ does the same
/// where the member's life ends; this exists so that lines of C# can be ported as they are.
template <typename T>
void Destroy(std::shared_ptr<T>& object)
{
    object.reset();
}

} // namespace CoreUtils

/// Unity: UnityEngine.Rendering.Universal.RenderingUtils (URP 14).
namespace RenderingUtils
{

/// Sets the matrices through which draws that follow see the world.
/// @param viewMatrix           world to view space, looking along -z; a matrix of floats is enough
///     near the world's origin
/// @param gpuProjectionMatrix  as Camera::gpuProjectionMatrix returns it
/// @param setInverseMatrices   if true, sets unity_MatrixInvV and its like as well, which few
///     vertex functions need
inline void SetViewAndProjectionMatrices(CommandBuffer& cmd, const glm::dmat4& viewMatrix,
                                         const glm::mat4& gpuProjectionMatrix,
                                         bool setInverseMatrices)
{
    cmd.SetViewProjectionMatrices(viewMatrix, gpuProjectionMatrix, setInverseMatrices);
}

/// Returns a quad for DrawMesh that covers the target where view and projection are the identity;
/// its uv stands upright. Every call returns the same mesh.
/// @source Unity: RenderingUtils.fullscreenMesh (URP 14)
const std::shared_ptr<const Mesh>& fullscreenMesh();

/// Unity: RenderingUtils.SupportsRenderTextureFormat, SupportsGraphicsFormat (URP 14).
inline bool SupportsRenderTextureFormat(RenderTextureFormat format)
{
    return SystemInfo::SupportsRenderTextureFormat(format);
}
inline bool SupportsGraphicsFormat(GraphicsFormat format, FormatUsage usage)
{
    return SystemInfo::IsFormatSupported(format, usage);
}

} // namespace RenderingUtils

/// Unity: UnityEngine.Rendering.Blitter (core 14).
namespace Blitter
{

/// The names under which blits hand their source to the shader. Unity: Blitter.BlitShaderIDs.
namespace BlitShaderIDs
{
inline const ShaderPropertyId _BlitTexture{"_BlitTexture"};
inline const ShaderPropertyId _BlitScaleBias{"_BlitScaleBias"};
} // namespace BlitShaderIDs

/// Draws one triangle over the whole of `destination`, whose contents are kept where the pass
/// blends, with `source` as _BlitTexture (and its size as _BlitTexture_TexelSize) and
/// _BlitScaleBias (1, 1, 0, 0). No depth is bound: tests against depth or stencil pass. A source
/// that wraps an identifier is global as _BlitTexture from then on, as in Unity.
/// @throws ContractError if a handle is empty or both are the same texture
void BlitCameraTexture(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
                       std::shared_ptr<const Material> material, int passIndex);

/// Ignores the load and store actions, because limn derives them.
inline void BlitCameraTexture(CommandBuffer& cmd, const RTHandle& source,
                              const RTHandle& destination, RenderBufferLoadAction,
                              RenderBufferStoreAction, std::shared_ptr<const Material> material,
                              int passIndex)
{
    BlitCameraTexture(cmd, source, destination, std::move(material), passIndex);
}
/// Copies `source` to `destination` without a material.
/// @param mipLevel  of the source; between two levels, its filter decides
/// @param bilinear  if false, takes the nearest texel
/// @throws ContractError if a handle is empty; when executed, if both are the same texture, the
///     source has no such level, or no camera is rendered
void BlitCameraTexture(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
                       float mipLevel = 0.0f, bool bilinear = false);
/// Copies `source` to a part of the destination.
void BlitCameraTexture(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
                       const ViewportRect& destViewport, float mipLevel = 0.0f,
                       bool bilinear = false);

// Unity's versions differ from the others for XR, which limn does not have. These exist so that
// lines of C# can be ported as they are.
inline void BlitCameraTexture2D(CommandBuffer& cmd, const RTHandle& source,
                                const RTHandle& destination, float mipLevel = 0.0f,
                                bool bilinear = false)
{
    BlitCameraTexture(cmd, source, destination, mipLevel, bilinear);
}

// These draw onto the target that is already bound, with other texture coordinates: scale in x and
// y, offset in z and w.
void BlitTexture(AnyCommandBuffer cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
/// Draws with `source`, which is global as _BlitTexture from then on, as in Unity. The report notes
/// that for a graph pass unless the pass has AllowGlobalStateModification.
void BlitTexture(AnyCommandBuffer cmd, RenderTargetIdentifier source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
/// Draws without a source: _BlitTexture stays as it is.
void BlitTexture(AnyCommandBuffer cmd, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
/// Copies without a material, as BlitCameraTexture does.
void BlitTexture(AnyCommandBuffer cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 float mipLevel, bool bilinear);
inline void BlitTexture2D(AnyCommandBuffer cmd, const RTHandle& source, const glm::vec4& scaleBias,
                          float mipLevel, bool bilinear)
{
    BlitTexture(cmd, source, scaleBias, mipLevel, bilinear);
}
/// Draws a quad over a part of the target that is already bound, with the texture's texels.
/// @param scaleBiasTex  of the texture, as BlitTexture's
/// @param scaleBiasRT   of the target: size in x and y, left and top border in z and w; a size of 1
///     is all
/// @throws ContractError  when executed: the source is null, has no such level, or no camera is
///     rendered
/// @source Unity: Blitter.BlitQuad (core 14)
void BlitQuad(AnyCommandBuffer cmd, const std::shared_ptr<const Texture>& source,
              const glm::vec4& scaleBiasTex, const glm::vec4& scaleBiasRT, int mipLevelTex,
              bool bilinear);
inline void BlitQuad(AnyCommandBuffer cmd, const RTHandle& source, const glm::vec4& scaleBiasTex,
                     const glm::vec4& scaleBiasRT, int mipLevelTex, bool bilinear)
{
    BlitQuad(cmd, source.rt(), scaleBiasTex, scaleBiasRT, mipLevelTex, bilinear);
}
/// Draws a colour, sampled bilinearly, and a depth, sampled at its nearest texel, over the whole of
/// the bound target.
/// @param sourceDepth  ignored unless blitDepth is true
/// @throws ContractError unless that is a depth texture; when executed, as BlitQuad does
/// @source Unity: Blitter.BlitColorAndDepth (core 14)
void BlitColorAndDepth(AnyCommandBuffer cmd, const std::shared_ptr<const Texture>& sourceColor,
                       const std::shared_ptr<const RenderTexture>& sourceDepth,
                       const glm::vec4& scaleBias, float mipLevel, bool blitDepth);
inline void BlitColorAndDepth(AnyCommandBuffer cmd, const RTHandle& sourceColor,
                              const RTHandle& sourceDepth, const glm::vec4& scaleBias,
                              float mipLevel, bool blitDepth)
{
    BlitColorAndDepth(cmd, sourceColor.rt(), sourceDepth.rt(), scaleBias, mipLevel, blitDepth);
}
/// Binds `destination` first, and draws with scale 1 and offset 0.
void BlitTexture(CommandBuffer& cmd, RenderTargetIdentifier source,
                 RenderTargetIdentifier destination, std::shared_ptr<const Material> material,
                 int passIndex);

} // namespace Blitter

} // namespace limn
