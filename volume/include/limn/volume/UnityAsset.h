#pragma once

#include <cstdint>
#include <limn/base/WordList.h>
#include <limn/volume/YamlNode.h>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Returns whether every MonoBehaviour of a Unity asset has this field. The other fields are those
/// of its class. (2022.3)
inline bool isUnityHeaderField(std::string_view name)
{
    static const WordList s_Fields(
        "m_ObjectHideFlags m_CorrespondingSourceObject m_PrefabInstance m_PrefabAsset "
        "m_GameObject m_Enabled m_EditorHideFlags m_Script m_Name m_EditorClassIdentifier");
    return s_Fields.Has(name);
}

/// The line `--- !u!114 &11400000` that an object of a Unity text asset begins with.
struct UnityHeader
{
    std::int64_t fileID = 0;
    int classID = 0; ///< 1 GameObject, 4 Transform, 114 MonoBehaviour
    /// Stands for an object of a prefab and holds little more than its identity.
    bool isStripped = false;
    int line = 0;              ///< the line of the file, from 1
    std::size_t bodyBegin = 0; ///< offset of the text below the header
    std::size_t bodyEnd = 0;
};

/// One object of a Unity text asset.
struct UnityObject
{
    std::int64_t fileID = 0;
    int classID = 0;
    std::string typeName; ///< "MonoBehaviour", "TagManager"
    std::string name;     ///< m_Name; "" without one
    SourceLocation location;
    YamlNode fields; ///< a Map
};

/// A Unity asset saved as text ("Force Text"): a VolumeProfile, a UniversalRendererData, a scene, a
/// prefab. It is made from the headers alone, since a scene may have ten thousands of objects; an
/// object's body is read when it is asked for. Unity: the serialised form of 2022.3 and later.
class UnityAsset
{
public:
    /// @param file  the name of the file in errors
    /// @throws AssetError with every document that does not begin as a Unity object does, and every
    ///     fileID that is there twice
    UnityAsset(std::string text, std::string file);

    const std::string& file() const { return m_File; }

    /// Returns the headers in the order of the file.
    std::span<const UnityHeader> headers() const { return m_Headers; }

    /// Returns the header of the object with that id, or null if there is none.
    const UnityHeader* FindHeader(std::int64_t fileID) const;

    /// Parses the object's body; each call parses it again.
    /// @param header  one of headers()
    /// @throws AssetError as ParseYaml does, and for a body that is not one map under one name
    UnityObject Read(const UnityHeader& header) const;

    /// Reads the object with that id; returns nullopt if there is none.
    std::optional<UnityObject> Find(std::int64_t fileID) const;

    /// Returns the first MonoBehaviour that has a field of that name (for example
    /// "m_RendererFeatures"), or nullopt if none has. Only bodies that contain the name are parsed.
    /// @throws AssetError as Read does
    std::optional<UnityObject> FindWithField(std::string_view field) const;

    /// Returns the text below the header. @param header  one of headers()
    std::string_view BodyOf(const UnityHeader& header) const;

private:
    std::string m_Text;
    std::string m_File;
    std::vector<UnityHeader> m_Headers;
    std::map<std::int64_t, std::size_t> m_ByFileID; ///< indices of m_Headers
};

/// Returns whether a text is a Unity asset, which has a line that begins with `--- !u!`. The name
/// of the file plays no role.
bool IsUnityAsset(std::string_view text);

/// @throws AssetError as ReadYamlText and UnityAsset do
UnityAsset LoadUnityAsset(const std::filesystem::path& path);

/// Returns the id in `{fileID: 11400000}`, or nullopt if the node is not such a reference. 0 means
/// "none". A reference with a guid points into another file.
std::optional<std::int64_t> ReadFileID(const YamlNode& reference);

/// Returns the guid in `{fileID: 11500000, guid: 185ced…, type: 3}`, or "" if the node has none.
std::string ReadGuid(const YamlNode& reference);

} // namespace limn
