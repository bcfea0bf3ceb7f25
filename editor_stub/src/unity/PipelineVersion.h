#pragma once

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/YamlNode.h>
#include <optional>

namespace limn
{

/// The major version of URP that the Unity project around a file asks for, by the project's
/// Packages/manifest.json; nothing if that names none of 7 to 17.
std::optional<int> ProjectPipelineVersion(const std::filesystem::path& file, AssetContext& assets);

/// The major version of URP by the k_AssetVersion of a UniversalRenderPipelineAsset, of those that
/// share one the last: Unity raises it where the asset's form changes. Nothing without the field.
std::optional<int> PipelineVersionOf(const YamlNode& pipelineFields);

} // namespace limn
