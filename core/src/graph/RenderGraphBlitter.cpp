#include <limn/core/RenderGraphCommandBuffer.h>

namespace limn
{

using detail::NativeOf;

void CoreUtils::DrawFullScreen(BaseCommandBuffer& cmd, std::shared_ptr<const Material> material,
                               const MaterialPropertyBlock& properties, int shaderPassId)
{
    DrawFullScreen(NativeOf(cmd), std::move(material), properties, shaderPassId);
}

void Blitter::BlitTexture(BaseCommandBuffer& cmd, const RTHandle& source,
                          const glm::vec4& scaleBias, std::shared_ptr<const Material> material,
                          int passIndex)
{
    BlitTexture(NativeOf(cmd), source, scaleBias, std::move(material), passIndex);
}

void Blitter::BlitTexture(BaseCommandBuffer& cmd, RenderTargetIdentifier source,
                          const glm::vec4& scaleBias, std::shared_ptr<const Material> material,
                          int passIndex)
{
    BlitTexture(NativeOf(cmd), std::move(source), scaleBias, std::move(material), passIndex);
}

void Blitter::BlitTexture(BaseCommandBuffer& cmd, const glm::vec4& scaleBias,
                          std::shared_ptr<const Material> material, int passIndex)
{
    BlitTexture(NativeOf(cmd), scaleBias, std::move(material), passIndex);
}

void Blitter::BlitTexture(BaseCommandBuffer& cmd, const RTHandle& source,
                          const glm::vec4& scaleBias, float mipLevel, bool bilinear)
{
    BlitTexture(NativeOf(cmd), source, scaleBias, mipLevel, bilinear);
}

void Blitter::BlitQuad(BaseCommandBuffer& cmd, const std::shared_ptr<const Texture>& source,
                       const glm::vec4& scaleBiasTex, const glm::vec4& scaleBiasRT, int mipLevelTex,
                       bool bilinear)
{
    BlitQuad(NativeOf(cmd), source, scaleBiasTex, scaleBiasRT, mipLevelTex, bilinear);
}

void Blitter::BlitColorAndDepth(BaseCommandBuffer& cmd,
                                const std::shared_ptr<const Texture>& sourceColor,
                                const std::shared_ptr<const RenderTexture>& sourceDepth,
                                const glm::vec4& scaleBias, float mipLevel, bool blitDepth)
{
    BlitColorAndDepth(NativeOf(cmd), sourceColor, sourceDepth, scaleBias, mipLevel, blitDepth);
}

} // namespace limn
