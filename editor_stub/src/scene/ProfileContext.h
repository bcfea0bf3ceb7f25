#pragma once

#include "unity/UnityProject.h"

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/ProfileContext.h>

namespace limn
{

/// The layers of a scene and the files around a profile. References are paths relative to the
/// profile's folder, or guids from the .meta files of the Unity project it is in.
class SceneProfileContext : public ProfileContext
{
public:
    /// @param profile  the profile's path; "" for values that are in no file
    /// @param assets, layers  must outlive this
    SceneProfileContext(AssetContext& assets, std::filesystem::path profile,
                        const LayerNames& layers)
        : m_Assets(assets), m_Profile(std::move(profile)), m_Layers(layers)
    {
    }

    /// Returns the scene's layer with this name, or the layer that has the name in every Unity
    /// project if the scene gives that layer no name.
    std::optional<int> FindLayer(std::string_view name) const override;
    std::vector<std::string_view> layerNames() const override { return m_Layers.names(); }

    bool loadsAssets() const override { return true; }
    LoadedAsset<Texture> LoadTexture(const AssetLocation& location) const override;
    LoadedAsset<Material> LoadMaterial(const AssetLocation& location) const override;

    /// Returns whether any reference was loaded so far.
    bool hasLoaded() const { return m_HasLoaded; }

private:
    std::filesystem::path FileOf(const AssetLocation& location) const;
    template <typename Asset, typename Loaded>
    LoadedAsset<Asset> LoadFile(
        const AssetLocation& location, std::string_view extension, const char* noun,
        std::shared_ptr<const Loaded> (AssetContext::*load)(const std::filesystem::path&)) const;

    AssetContext& m_Assets;
    std::filesystem::path m_Profile;
    const LayerNames& m_Layers;
    mutable std::optional<UnityProject> m_Project; ///< found when a guid first needs it
    mutable bool m_HasLoaded = false;
};

} // namespace limn
