#pragma once

#include <cstdint>
#include <limn/volume/YamlNode.h>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// One object of a Unity text asset: what stands behind a line `--- !u!114 &11400000`.
struct UnityObject
{
    std::int64_t fileID = 0;
    int classID = 0;      ///< 114 is a MonoBehaviour
    std::string typeName; ///< "MonoBehaviour", "TagManager"
    std::string name;     ///< m_Name; "" without one
    SourceLocation location;
    YamlNode fields; ///< a Map

    bool isMonoBehaviour() const { return classID == 114; }
};

/// A Unity asset saved as text ("Force Text"), for example a VolumeProfile or a
/// UniversalRendererData. Unity: the serialised form of 2022.3 and later.
struct UnityAsset
{
    std::string file;
    std::vector<UnityObject> objects; ///< in the order of the file

    /// Null if no object has that id.
    const UnityObject* Find(std::int64_t fileID) const;

    /// The first MonoBehaviour that has a field of that name, "m_RendererFeatures"; null if none.
    const UnityObject* FindWithField(std::string_view field) const;
};

/// Whether the documents are a Unity asset, by their `!u!` tags; the file's name plays no role.
bool IsUnityAsset(std::span<const YamlNode> documents);

/// @throws AssetError with every document that is no Unity object
UnityAsset ReadUnityAsset(std::span<const YamlNode> documents, std::string file);

/// @throws AssetError as LoadYamlFile and ReadUnityAsset do, and for a file that is no Unity asset
UnityAsset LoadUnityAsset(const std::filesystem::path& path);

/// The id in `{fileID: 11400000}`; nothing if the node is not such a reference. 0 means "none". A
/// reference with a guid points into another file.
std::optional<std::int64_t> ReadFileID(const YamlNode& reference);

} // namespace limn
