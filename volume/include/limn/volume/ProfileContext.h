#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Where an asset is, as a file says it: by path, or by Unity's identifiers.
struct AssetLocation
{
    std::string path = {};   ///< as written, relative to the file it is in
    std::int64_t fileID = 0; ///< Unity's object within the asset file
    std::string guid = {};   ///< Unity's asset file, 32 hexadecimal digits
    int type = 0;            ///< Unity's: 2 made by the editor, 3 imported

    bool isNull() const { return path.empty() && fileID == 0; }
    bool operator==(const AssetLocation&) const = default;
};

/// A reference to an asset, or to none. Reading YAML sets `location` and leaves `asset` empty: who
/// loads assets fills it in; a program may set `asset` alone.
template <typename Asset>
struct AssetReference
{
    AssetLocation location = {};
    std::shared_ptr<const Asset> asset = {};

    bool operator==(const AssetReference&) const = default;
};

class Material;
class Texture;

/// What a reference gave: an asset, or none and why.
template <typename Asset>
struct LoadedAsset
{
    std::shared_ptr<const Asset> asset = {};
    std::string note = {}; ///< "" where there is nothing to say
};

/// What the values of a profile refer to beyond their file: layers and other assets. This class is
/// the context of a profile on its own: it has the layers of every Unity project and loads nothing,
/// so references keep their location alone. Who has a scene derives from it.
class ProfileContext
{
public:
    ProfileContext() = default;
    ProfileContext(const ProfileContext&) = delete;
    ProfileContext& operator=(const ProfileContext&) = delete;
    virtual ~ProfileContext() = default;

    /// The number of a layer, 0...31; nothing if there is no layer of that name.
    virtual std::optional<int> FindLayer(std::string_view name) const;
    /// By ascending number, for messages.
    virtual std::vector<std::string_view> layerNames() const;

    /// Whether references are loaded at all.
    virtual bool loadsAssets() const { return false; }
    /// A flat texture. @throws AssetError if it cannot be loaded
    virtual LoadedAsset<Texture> LoadTexture(const AssetLocation& location) const;
    /// @throws AssetError if it cannot be loaded
    virtual LoadedAsset<Material> LoadMaterial(const AssetLocation& location) const;
};

} // namespace limn
