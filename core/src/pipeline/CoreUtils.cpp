#include <limn/core/CoreUtils.h>

namespace limn
{

namespace
{

const ShaderPropertyId _BlitTexture{"_BlitTexture"};
const ShaderPropertyId _BlitScaleBias{"_BlitScaleBias"};
constexpr int k_TriangleVertices = 3;

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
    if (clearFlag != ClearFlag::None)
    {
        cmd.ClearRenderTarget(clearFlag, clearColor);
    }
}

void SetRenderTarget(CommandBuffer& cmd, std::span<const RTHandle> colors, const RTHandle& depth,
                     ClearFlag clearFlag, const Color& clearColor)
{
    cmd.SetRenderTarget(colors, depth);
    if (clearFlag != ClearFlag::None)
    {
        cmd.ClearRenderTarget(clearFlag, clearColor);
    }
}

void SetKeyword(CommandBuffer& cmd, std::string_view keyword, bool state)
{
    cmd.SetKeyword(GlobalKeyword(keyword), state);
}

void SetKeyword(Material& material, const std::string& keyword, bool state)
{
    state ? material.EnableKeyword(keyword) : material.DisableKeyword(keyword);
}

std::shared_ptr<Material> CreateEngineMaterial(std::shared_ptr<const Shader> shader)
{
    if (!shader)
    {
        throw ContractError("CreateEngineMaterial: no shader is assigned");
    }
    return std::make_shared<Material>(std::move(shader));
}

void DrawFullScreen(CommandBuffer& cmd, std::shared_ptr<const Material> material,
                    const MaterialPropertyBlock& properties, int shaderPassId)
{
    cmd.DrawProcedural(glm::mat4(1.0f), std::move(material), shaderPassId, k_TriangleVertices,
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
        throw ContractError("BlitCameraTexture: '" +
                            (source.rt() ? source.rt()->name() : "one identifier") +
                            "' is both source and destination");
    }
    CoreUtils::SetRenderTarget(cmd, destination);
    BlitTexture(cmd, source, glm::vec4(1.0f, 1.0f, 0.0f, 0.0f), std::move(material), passIndex);
}

void BlitTexture(CommandBuffer& cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex)
{
    if (!source)
    {
        throw ContractError("BlitTexture: the source is an empty handle");
    }
    static thread_local MaterialPropertyBlock properties; // for its memory, as in Unity
    if (source.rt())
    {
        properties.SetTexture(_BlitTexture, source.rt());
    }
    else
    {
        cmd.SetGlobalTexture(_BlitTexture, source.nameID());
    }
    properties.SetVector(_BlitScaleBias, scaleBias);
    cmd.DrawProcedural(glm::mat4(1.0f), std::move(material), passIndex, k_TriangleVertices,
                       properties);
    properties.Clear();
}

} // namespace Blitter

} // namespace limn
