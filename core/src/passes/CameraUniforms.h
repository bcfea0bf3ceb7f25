#pragma once

#include <limn/core/RenderingData.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// Sets what the ShaderLibrary expects of a camera: matrices, position, sizes, depth parameters.
/// @source Unity: ScriptableRenderer.SetPerCameraShaderVariables (URP 14)
void SetCameraUniforms(CommandBuffer& cmd, const CameraData& cameraData);

/// Sets the origin of RelativeSpaces.hlsl, as a part of SetCameraUniforms.
void SetOriginUniforms(CommandBuffer& cmd, const CameraData& cameraData);

/// Sets _Time and its relatives, rounded to float last. @param seconds  since the beginning
void SetTimeUniforms(CommandBuffer& cmd, double seconds, double sinceLastFrame);

/// Sets the main light, linear.
void SetLightUniforms(CommandBuffer& cmd, const Scene& scene);

/// Sets the ambient light and the reflections, linear.
void SetAmbientUniforms(CommandBuffer& cmd, const RenderSettings& settings);

/// Sets the fog's curve and colour, linear, and enables its keyword. Does nothing without fog.
void SetFogUniforms(CommandBuffer& cmd, const RenderSettings& settings);

} // namespace limn
