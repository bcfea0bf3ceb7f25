#pragma once

#include <limn/core/Shader.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <memory>
#include <string_view>

namespace limn
{

/// Registers every feature that comes with limn, and their volume components.
void RegisterFeatures(FeatureRegistry& features, VolumeComponentRegistry& components);

/// Registers the volume components only.
void RegisterVolumeComponents(VolumeComponentRegistry& registry);

/// Returns every shader that comes with limn (core's and those of the features) or with a loaded
/// plug-in.
const ShaderDatabase& ShippedShaders();

/// Returns one of ShippedShaders(), never null.
/// @throws ContractError for any other name, with the nearest one
std::shared_ptr<const Shader> FindShippedShader(std::string_view name,
                                                const std::shared_ptr<ShaderCompiler>& compiler);

} // namespace limn
