#pragma once

#include <limn/core/CommandBuffer.h>
#include <limn/core/RenderingData.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// Finds the lights besides the main one that reach into the camera's view, as many as shaders have
/// room for. It costs nothing for a scene without such lights.
/// @param lights  set to the lights that are found
/// @param notes   receives a sentence about lights beyond that number
void FindAdditionalLights(const Scene& scene, const CameraData& camera,
                          std::vector<const Light*>& lights, std::vector<std::string>& notes);

/// Sets the lights of renderingData.lightData, and _ADDITIONAL_LIGHTS if objects get any of them.
/// @source Unity: ForwardLights.SetupAdditionalLightConstants and
///     UniversalRenderPipeline.InitializeLightConstants_Common (URP 14)
void SetAdditionalLightUniforms(ScriptableRenderContext& context, CommandBuffer& cmd,
                                const RenderingData& renderingData);

/// Removes the lights from here on, as at the beginning of a frame.
void ForgetAdditionalLights(CommandBuffer& cmd);

} // namespace limn
