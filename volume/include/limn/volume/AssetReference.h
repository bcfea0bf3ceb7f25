#pragma once

#include <cstdint>
#include <memory>
#include <string>

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

} // namespace limn
