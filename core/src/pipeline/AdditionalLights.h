#pragma once

#include <limn/core/CommandBuffer.h>
#include <limn/core/RenderingData.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// The lights besides the main one that reach into the camera's view, as many as shaders have room
/// for; a scene without costs nothing.
/// @param lights  becomes them
/// @param notes   for a sentence about lights that are too many
void FindAdditionalLights(const Scene& scene, const CameraData& camera,
                          std::vector<const Light*>& lights, std::vector<std::string>& notes);

/// Sets those of renderingData.lightData, and _ADDITIONAL_LIGHTS if objects get any of them.
/// @source Unity: ForwardLights.SetupAdditionalLightConstants and
///     UniversalRenderPipeline.InitializeLightConstants_Common (URP 14)
void SetAdditionalLightUniforms(ScriptableRenderContext& context, CommandBuffer& cmd,
                                const RenderingData& renderingData);

/// There are none from here on, as at the beginning of a frame.
void ForgetAdditionalLights(CommandBuffer& cmd);

} // namespace limn
