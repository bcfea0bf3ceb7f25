#pragma once

#include <limn/editor_stub/SceneFile.h>
#include <limn/features/Technique.h>

namespace limn::study
{

/// The rendering layer that the outlined objects of a study are in, and no others.
inline constexpr int k_OutlinedLayer = 31;

/// @throws ContractError for an unknown name
const Technique& RequireTechnique(const AssetContext& assets, const std::string& name);

/// Makes a white outline of that width the scene's only feature, with the name "Outline", and
/// removes the scene's volumes.
/// @param width  in pixels, as a person would type it; "nan" is refused, as it would be there
/// @throws AssetError if the feature or its component refuses the width
void UseTechnique(SceneAsset& asset, const Technique& technique, const std::string& width,
                  AssetContext& assets);
void UseTechnique(SceneAsset& asset, const Technique& technique, double width,
                  AssetContext& assets);

} // namespace limn::study
