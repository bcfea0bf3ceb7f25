#pragma once

#include <limn/core/CoreUtils.h>

namespace limn
{

class BaseCommandBuffer;

namespace CoreUtils
{

void DrawFullScreen(BaseCommandBuffer& cmd, std::shared_ptr<const Material> material,
                    const MaterialPropertyBlock& properties = {}, int shaderPassId = 0);

} // namespace CoreUtils

// Blitter's calls for RasterCommandBuffer and UnsafeCommandBuffer: what they draw, CommandBuffer's
// say. The graph pass declares the source as it does for any other draw.
// Unity: UnityEngine.Rendering.Blitter (core 17).
namespace Blitter
{

void BlitTexture(BaseCommandBuffer& cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
/// The source is global as _BlitTexture from then on, which the report notes unless the pass does
/// AllowGlobalStateModification.
void BlitTexture(BaseCommandBuffer& cmd, RenderTargetIdentifier source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
void BlitTexture(BaseCommandBuffer& cmd, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
void BlitTexture(BaseCommandBuffer& cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 float mipLevel, bool bilinear);
inline void BlitTexture2D(BaseCommandBuffer& cmd, const RTHandle& source,
                          const glm::vec4& scaleBias, float mipLevel, bool bilinear)
{
    BlitTexture(cmd, source, scaleBias, mipLevel, bilinear);
}

void BlitQuad(BaseCommandBuffer& cmd, const std::shared_ptr<const Texture>& source,
              const glm::vec4& scaleBiasTex, const glm::vec4& scaleBiasRT, int mipLevelTex,
              bool bilinear);
inline void BlitQuad(BaseCommandBuffer& cmd, const RTHandle& source, const glm::vec4& scaleBiasTex,
                     const glm::vec4& scaleBiasRT, int mipLevelTex, bool bilinear)
{
    BlitQuad(cmd, source.rt(), scaleBiasTex, scaleBiasRT, mipLevelTex, bilinear);
}

void BlitColorAndDepth(BaseCommandBuffer& cmd, const std::shared_ptr<const Texture>& sourceColor,
                       const std::shared_ptr<const RenderTexture>& sourceDepth,
                       const glm::vec4& scaleBias, float mipLevel, bool blitDepth);
inline void BlitColorAndDepth(BaseCommandBuffer& cmd, const RTHandle& sourceColor,
                              const RTHandle& sourceDepth, const glm::vec4& scaleBias,
                              float mipLevel, bool blitDepth)
{
    BlitColorAndDepth(cmd, sourceColor.rt(), sourceDepth.rt(), scaleBias, mipLevel, blitDepth);
}

} // namespace Blitter

} // namespace limn
