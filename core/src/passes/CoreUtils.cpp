#include <limn/core/CoreUtils.h>

#include "record/Arguments.h"
#include "record/RecordedCommands.h"
#include <limn/core/QualitySettings.h>

namespace limn
{

namespace
{

constexpr int k_TriangleVertices = 3;
constexpr glm::vec4 k_WholeTexture(1.0f, 1.0f, 0.0f, 0.0f);

void Clear(CommandBuffer& cmd, ClearFlag flag, const Color& color)
{
    if (flag != ClearFlag::None)
    {
        cmd.ClearRenderTarget(flag, color);
    }
}

void ExpectSource(const RTHandle& source)
{
    if (!source)
    {
        throw ContractError("BlitTexture: the source is an empty handle");
    }
}

} // namespace

namespace CoreUtils
{

void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color, ClearFlag clearFlag,
                     const Color& clearColor)
{
    SetRenderTarget(cmd, color, RTHandle(), clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color, const RTHandle& depth,
                     ClearFlag clearFlag, const Color& clearColor)
{
    cmd.SetRenderTarget(color, depth);
    Clear(cmd, clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, std::span<const RTHandle> colors, const RTHandle& depth,
                     ClearFlag clearFlag, const Color& clearColor)
{
    cmd.SetRenderTarget(colors, depth);
    Clear(cmd, clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color, ClearFlag clearFlag,
                     const Color& clearColor)
{
    cmd.SetRenderTarget(std::move(color));
    Clear(cmd, clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color, RenderTargetIdentifier depth,
                     ClearFlag clearFlag, const Color& clearColor)
{
    cmd.SetRenderTarget(std::move(color), std::move(depth));
    Clear(cmd, clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color, RenderBufferLoadAction loadAction,
                     RenderBufferStoreAction storeAction, ClearFlag clearFlag,
                     const Color& clearColor)
{
    cmd.SetRenderTarget(color, loadAction, storeAction);
    Clear(cmd, clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, const RTHandle& color,
                     RenderBufferLoadAction colorLoadAction,
                     RenderBufferStoreAction colorStoreAction, const RTHandle& depth,
                     RenderBufferLoadAction depthLoadAction,
                     RenderBufferStoreAction depthStoreAction, ClearFlag clearFlag,
                     const Color& clearColor)
{
    cmd.SetRenderTarget(color, colorLoadAction, colorStoreAction, depth, depthLoadAction,
                        depthStoreAction);
    Clear(cmd, clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color,
                     RenderBufferLoadAction loadAction, RenderBufferStoreAction storeAction,
                     ClearFlag clearFlag, const Color& clearColor)
{
    cmd.SetRenderTarget(std::move(color), loadAction, storeAction);
    Clear(cmd, clearFlag, clearColor);
}

void SetRenderTarget(CommandBuffer& cmd, RenderTargetIdentifier color,
                     RenderBufferLoadAction colorLoadAction,
                     RenderBufferStoreAction colorStoreAction, RenderTargetIdentifier depth,
                     RenderBufferLoadAction depthLoadAction,
                     RenderBufferStoreAction depthStoreAction, ClearFlag clearFlag,
                     const Color& clearColor)
{
    cmd.SetRenderTarget(std::move(color), colorLoadAction, colorStoreAction, std::move(depth),
                        depthLoadAction, depthStoreAction);
    Clear(cmd, clearFlag, clearColor);
}

Color ConvertSRGBToActiveColorSpace(const Color& color)
{
    return QualitySettings::activeColorSpace() == ColorSpace::Linear ? color.linear() : color;
}

Color ConvertLinearToActiveColorSpace(const Color& color)
{
    return QualitySettings::activeColorSpace() == ColorSpace::Linear ? color : color.gamma();
}

void SetKeyword(CommandBuffer& cmd, std::string_view keyword, bool state)
{
    cmd.SetKeyword(GlobalKeyword(keyword), state);
}

void SetKeyword(Material& material, const std::string& keyword, bool state)
{
    state ? material.EnableKeyword(keyword) : material.DisableKeyword(keyword);
}

void SetKeyword(ComputeShader& cs, std::string_view keyword, bool state)
{
    cs.SetKeyword(keyword, state);
}

void DrawRendererList(ScriptableRenderContext&, CommandBuffer& cmd,
                      const RendererList& rendererList)
{
    cmd.DrawRendererList(rendererList);
}

std::shared_ptr<Material> CreateEngineMaterial(std::shared_ptr<const Shader> shader)
{
    if (!shader)
    {
        throw ContractError("CreateEngineMaterial: no shader is assigned");
    }
    return std::make_shared<Material>(std::move(shader));
}

std::shared_ptr<Material> CreateEngineMaterial(const std::string& shaderPath)
{
    std::shared_ptr<const Shader> shader = Shader::Find(shaderPath);
    if (!shader)
    {
        throw ContractError("CreateEngineMaterial: there is no shader '" + shaderPath + "'");
    }
    return CreateEngineMaterial(std::move(shader));
}

void DrawFullScreen(AnyCommandBuffer cmd, std::shared_ptr<const Material> material,
                    const MaterialPropertyBlock& properties, int shaderPassId)
{
    ExpectMaterial("DrawFullScreen", material);
    cmd->DrawProcedural(glm::mat4(1.0f), std::move(material), shaderPassId, k_TriangleVertices,
                        properties);
}

} // namespace CoreUtils

namespace Blitter
{

void BlitCameraTexture(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
                       std::shared_ptr<const Material> material, int passIndex)
{
    if (!source || !destination)
    {
        throw ContractError(std::string("BlitCameraTexture: the ") +
                            (source ? "destination" : "source") + " is an empty handle");
    }
    if (source == destination)
    {
        throw ContractError(
            "BlitCameraTexture: '" + (source.rt() ? source.rt()->name() : "one identifier") +
            "' is both source and destination; copy it first, and draw from the copy");
    }
    CoreUtils::SetRenderTarget(cmd, destination);
    BlitTexture(cmd, source, k_WholeTexture, std::move(material), passIndex);
}

void BlitCameraTexture(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
                       float mipLevel, bool bilinear)
{
    CoreUtils::SetRenderTarget(cmd, destination);
    BlitTexture(cmd, source, k_WholeTexture, mipLevel, bilinear);
}

void BlitCameraTexture(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
                       const ViewportRect& destViewport, float mipLevel, bool bilinear)
{
    CoreUtils::SetRenderTarget(cmd, destination);
    cmd.SetViewport(destViewport);
    BlitTexture(cmd, source, k_WholeTexture, mipLevel, bilinear);
}

void BlitTexture(AnyCommandBuffer cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex)
{
    ExpectSource(source);
    ExpectMaterial("BlitTexture", material);
    if (!source.rt())
    {
        BlitTexture(cmd, source.nameID(), scaleBias, std::move(material), passIndex);
        return;
    }
    static thread_local MaterialPropertyBlock properties; // for its memory, as in Unity
    properties.SetTexture(Blitter::BlitShaderIDs::_BlitTexture, source.rt());
    properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias, scaleBias);
    CoreUtils::DrawFullScreen(cmd, std::move(material), properties, passIndex);
    properties.Clear();
}

void BlitTexture(AnyCommandBuffer cmd, RenderTargetIdentifier source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex)
{
    ExpectMaterial("BlitTexture", material);
    cmd->SetGlobalTexture(Blitter::BlitShaderIDs::_BlitTexture, std::move(source));
    BlitTexture(cmd, scaleBias, std::move(material), passIndex);
}

void BlitTexture(AnyCommandBuffer cmd, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex)
{
    ExpectMaterial("BlitTexture", material);
    MaterialPropertyBlock properties;
    properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias, scaleBias);
    CoreUtils::DrawFullScreen(cmd, std::move(material), properties, passIndex);
}

void BlitTexture(AnyCommandBuffer cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 float mipLevel, bool bilinear)
{
    ExpectSource(source);
    cmd->DrawCopy({source, scaleBias, bilinear, mipLevel});
}

void BlitQuad(AnyCommandBuffer cmd, const std::shared_ptr<const Texture>& source,
              const glm::vec4& scaleBiasTex, const glm::vec4& scaleBiasRT, int mipLevelTex,
              bool bilinear)
{
    cmd->DrawCopy({source, scaleBiasTex, bilinear, static_cast<float>(mipLevelTex), scaleBiasRT});
}

void BlitColorAndDepth(AnyCommandBuffer cmd, const std::shared_ptr<const Texture>& sourceColor,
                       const std::shared_ptr<const RenderTexture>& sourceDepth,
                       const glm::vec4& scaleBias, float mipLevel, bool blitDepth)
{
    if (blitDepth && (!sourceDepth || !IsDepthFormat(sourceDepth->graphicsFormat())))
    {
        throw ContractError("BlitColorAndDepth: '" + (sourceDepth ? sourceDepth->name() : "null") +
                            "' is no depth texture");
    }
    cmd->DrawCopy(
        {sourceColor, scaleBias, true, mipLevel, std::nullopt, blitDepth ? sourceDepth : nullptr});
}

void BlitTexture(CommandBuffer& cmd, RenderTargetIdentifier source,
                 RenderTargetIdentifier destination, std::shared_ptr<const Material> material,
                 int passIndex)
{
    cmd.SetRenderTarget(std::move(destination));
    BlitTexture(cmd, std::move(source), k_WholeTexture, std::move(material), passIndex);
}

} // namespace Blitter

void CoreUtils::SetViewport(CommandBuffer& cmd, const RTHandle& target)
{
    if (!target.rt())
    {
        throw ContractError("SetViewport: the handle has no texture");
    }
    cmd.SetViewport({0, 0, target.rt()->width(), target.rt()->height()});
}

std::shared_ptr<const Mesh> CoreUtils::CreateCubeMesh(const glm::vec3& min, const glm::vec3& max)
{
    MeshData data;
    for (int i = 0; i < 8; ++i)
    {
        data.vertices.emplace_back(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y,
                                   i & 4 ? max.z : min.z);
    }
    data.triangles = {0, 2, 3, 0, 3, 1,  // -z
                      5, 7, 6, 5, 6, 4,  // +z
                      4, 6, 2, 4, 2, 0,  // -x
                      1, 3, 7, 1, 7, 5,  // +x
                      4, 0, 1, 4, 1, 5,  // -y
                      2, 6, 7, 2, 7, 3}; // +y
    return std::make_shared<const Mesh>("Cube", std::move(data));
}

const std::shared_ptr<const Mesh>& RenderingUtils::fullscreenMesh()
{
    static const auto mesh = []
    {
        MeshData data;
        data.vertices = {{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}};
        data.uv = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
        data.triangles = {0, 1, 2, 0, 2, 3};
        return std::make_shared<const Mesh>("Fullscreen Quad", std::move(data));
    }();
    return mesh;
}

} // namespace limn
