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

/// A shader that comes with limn, of core's or of a feature's; null for any other name.
std::shared_ptr<const Shader> FindShippedShader(std::string_view name,
                                                const std::shared_ptr<ShaderCompiler>& compiler);
std::vector<std::string_view> ShippedShaderNames();

/// The name of the feature shader whose file is called "<stem>.shader"; "" if there is none.
std::string_view ShippedShaderOfFile(std::string_view stem);

} // namespace limn
