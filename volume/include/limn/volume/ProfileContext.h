#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The place of an asset as a file gives it: a path or Unity's identifiers.
struct AssetLocation
{
    std::string path = {};   ///< as written, relative to the file that contains it
    std::int64_t fileID = 0; ///< Unity's object within the asset file
    std::string guid = {};   ///< Unity's asset file, 32 hexadecimal digits
    int type = 0;            ///< Unity's type: 2 is made by the editor, 3 is imported

    bool isNull() const { return path.empty() && fileID == 0; }
    bool operator==(const AssetLocation&) const = default;
};

/// A reference to an asset, or to none. Reading YAML sets `location` and leaves `asset` empty; the
/// loader of assets fills it in. A program may set only `asset`.
template <typename Asset>
struct AssetReference
{
    AssetLocation location = {};
    std::shared_ptr<const Asset> asset = {};

    bool operator==(const AssetReference&) const = default;
};

class Material;
class Texture;

/// The result of loading a reference: an asset, or none and the reason.
template <typename Asset>
struct LoadedAsset
{
    std::shared_ptr<const Asset> asset = {};
    std::string note = {}; ///< "" if there is nothing to report
};

/// Resolves what the values of a profile refer to outside their file: layers and other assets. This
/// class is the context of a profile without a scene: it has the layers of every Unity project and
/// loads nothing, so references keep only their location. Code that has a scene derives from it.
class ProfileContext
{
public:
    ProfileContext() = default;
    ProfileContext(const ProfileContext&) = delete;
    ProfileContext& operator=(const ProfileContext&) = delete;
    virtual ~ProfileContext() = default;

    /// Returns the number of a layer, 0...31, or nullopt if no layer has that name.
    virtual std::optional<int> FindLayer(std::string_view name) const;
    /// Returns the names of the layers by ascending number, for messages.
    virtual std::vector<std::string_view> layerNames() const;

    /// Returns whether references are loaded at all.
    virtual bool loadsAssets() const { return false; }
    /// Loads a flat texture.
    /// @throws AssetError if it cannot be loaded
    virtual LoadedAsset<Texture> LoadTexture(const AssetLocation& location) const;
    /// @throws AssetError if it cannot be loaded
    virtual LoadedAsset<Material> LoadMaterial(const AssetLocation& location) const;
};

} // namespace limn
