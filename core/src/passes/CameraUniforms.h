#pragma once

#include <limn/core/RenderingData.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// Sets what the ShaderLibrary expects of a camera: matrices, position, sizes, depth parameters.
/// @source Unity: ScriptableRenderer.SetPerCameraShaderVariables (URP 14)
void SetCameraUniforms(CommandBuffer& cmd, const CameraData& cameraData);

/// What RelativeSpaces.hlsl is relative to, as a part of the above.
void SetOriginUniforms(CommandBuffer& cmd, const CameraData& cameraData);

/// _Time and its relatives, rounded to float last. @param seconds  since the beginning
void SetTimeUniforms(CommandBuffer& cmd, double seconds);

/// The main light, linear.
void SetLightUniforms(CommandBuffer& cmd, const Scene& scene);

/// Sets ambient light and what is mirrored, linear.
void SetAmbientUniforms(CommandBuffer& cmd, const RenderSettings& settings);

/// Sets the fog's curve and colour, linear, and enables its keyword. Does nothing without fog.
void SetFogUniforms(CommandBuffer& cmd, const RenderSettings& settings);

} // namespace limn
