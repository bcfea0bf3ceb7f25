#pragma once

#include "unity/ProjectShaders.h"
#include "unity/UnityObjects.h"
#include "unity/UnityProject.h"

#include <limn/editor_stub/UnityRendererData.h>

namespace limn
{

/// Loads the asset behind a reference. Returns null and gives `note` the reason, "its guid is not
/// in the project", if there is none to draw with.
template <typename Asset>
using UnityAssetLoader = std::function<std::shared_ptr<const Asset>(
    const UnityReference& asset, const std::function<void(const std::string& reason)>& note)>;

/// Loaders of what a scene shares with the features of its renderer.
struct UnityAssetLoaders
{
    UnityAssetLoader<Material> material;
    UnityAssetLoader<Texture> texture;
    GraphTranslator graph = nullptr; ///< for shader graphs of settings and of Shader::Find
};

/// Loads a renderer's asset as LoadUnityRendererData of UnityRendererData.h does, with a project
/// that is known already, its materials and textures. As in Unity, a value that does not fit its
/// setting leaves the default, and a feature that cannot be created is left out: the errors become
/// notes.
///
/// @throws AssetError if the file is no such asset
UnityRendererDataLoadResult LoadUnityRendererData(const std::filesystem::path& path,
                                                  AssetContext& assets, const UnityProject& project,
                                                  const UnityAssetLoaders& load);

} // namespace limn
