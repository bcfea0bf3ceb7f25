#pragma once

#include <limn/core/CommandBuffer.h>
#include <limn/core/RenderingData.h>

namespace limn
{

/// Sets the lights that reach into the camera's view, and _ADDITIONAL_LIGHTS if there are any; a
/// scene without costs nothing. Every light counts for every object, as in URP's Forward+.
/// @param notes  for a sentence about lights that are too many
/// @source Unity: ForwardLights.SetupAdditionalLightConstants and
///     UniversalRenderPipeline.InitializeLightConstants_Common (URP 14)
void SetAdditionalLightUniforms(CommandBuffer& cmd, const RenderingData& renderingData,
                                std::vector<std::string>& notes);

/// There are none from here on, as at the beginning of a frame.
void ForgetAdditionalLights(CommandBuffer& cmd);

} // namespace limn
