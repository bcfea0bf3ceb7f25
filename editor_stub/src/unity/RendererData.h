#pragma once

#include "unity/UnityObjects.h"
#include "unity/UnityProject.h"

#include <limn/editor_stub/UnityRendererData.h>

namespace limn
{

/// Loads the material behind a reference. Returns null and gives `note` the reason, "its guid is
/// not in the project", if there is none to draw with.
using UnityMaterialLoader = std::function<std::shared_ptr<const Material>(
    const UnityReference& material, const std::function<void(const std::string& reason)>& note)>;

/// Loads a renderer's asset as LoadUnityRendererData of UnityRendererData.h does, with a project
/// that is known already, and its materials.
UnityRendererDataLoadResult LoadUnityRendererData(const std::filesystem::path& path,
                                                  AssetContext& assets, const UnityProject& project,
                                                  const UnityMaterialLoader& loadMaterial);

} // namespace limn
