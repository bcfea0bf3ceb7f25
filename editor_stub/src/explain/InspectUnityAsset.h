#pragma once

#include "explain/InspectReport.h"

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/UnityAsset.h>

namespace limn
{

/// What a Unity asset is, by its content: "profile", "renderer", "pipeline" or "material".
/// @throws AssetError that names what is in the file, if it is none of these
std::string KindOfUnityAsset(const UnityAsset& asset);

/// A UniversalRenderPipelineAsset: what limn draws with, its renderers, and what limn leaves out.
InspectedGroup InspectPipeline(const UnityAsset& asset);

/// The values of a UniversalRendererData besides its features.
InspectedGroup InspectRenderer(const UnityAsset& asset);

/// A .mat file: its shader, queue, keywords and properties; which of them the shader has.
InspectedGroup InspectMaterial(const UnityAsset& asset, AssetContext& assets);

} // namespace limn
