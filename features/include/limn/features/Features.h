#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/Shader.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <memory>
#include <string_view>
#include <vector>

namespace limn
{

/// Registers the volume components of every feature that comes with limn.
void RegisterVolumeComponents(VolumeComponentRegistry& registry);

/// A new feature by its type's name, "ScreenSpaceOutlineRenderFeature", with default settings and
/// before Create; null for an unknown name.
std::unique_ptr<ScriptableRendererFeature> CreateFeature(std::string_view typeName);
std::vector<std::string_view> FeatureTypeNames();

/// Every shader that comes with limn, of core's and of the features'.
const ShaderDatabase& ShippedShaders();

/// One of ShippedShaders(); null for any other name.
inline std::shared_ptr<const Shader>
FindShippedShader(std::string_view name, const std::shared_ptr<ShaderCompiler>& compiler)
{
    return Shader::Find(name, ShippedShaders(), compiler);
}

} // namespace limn
