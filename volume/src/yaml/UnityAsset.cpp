#include <limn/volume/UnityAsset.h>

#include <algorithm>
#include <charconv>
#include <limn/volume/AssetDiagnostics.h>

namespace limn
{

namespace
{

constexpr std::string_view k_TagPrefix = "tag:unity3d.com,2011:";

bool HasUnityTag(const YamlNode& document)
{
    return document.tag().compare(0, k_TagPrefix.size(), k_TagPrefix) == 0;
}

template <typename T>
std::optional<T> ParseWhole(std::string_view text)
{
    T value{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && rest == end ? std::optional(value) : std::nullopt;
}

/// Nothing for a document that is no Unity object.
std::optional<UnityObject> ReadObject(const YamlNode& document)
{
    if (!HasUnityTag(document) || document.entries().size() != 1)
    {
        return std::nullopt;
    }
    const auto classID =
        ParseWhole<int>(std::string_view(document.tag()).substr(k_TagPrefix.size()));
    const auto fileID = ParseWhole<std::int64_t>(document.anchor());
    const YamlEntry& body = document.entries().front();
    if (!classID || !fileID || !body.value.isMap())
    {
        return std::nullopt;
    }
    const YamlNode* name = body.value.Find("m_Name");
    return UnityObject{*fileID,          *classID,  body.key, name ? name->scalar() : std::string(),
                       body.keyLocation, body.value};
}

} // namespace

const UnityObject* UnityAsset::Find(std::int64_t fileID) const
{
    const auto found =
        std::find_if(objects.begin(), objects.end(),
                     [fileID](const UnityObject& object) { return object.fileID == fileID; });
    return found == objects.end() ? nullptr : &*found;
}

const UnityObject* UnityAsset::FindWithField(std::string_view field) const
{
    const auto found =
        std::find_if(objects.begin(), objects.end(),
                     [field](const UnityObject& object)
                     { return object.isMonoBehaviour() && object.fields.Find(field) != nullptr; });
    return found == objects.end() ? nullptr : &*found;
}

bool IsUnityAsset(std::span<const YamlNode> documents)
{
    return std::any_of(documents.begin(), documents.end(), HasUnityTag);
}

UnityAsset ReadUnityAsset(std::span<const YamlNode> documents, std::string file)
{
    AssetDiagnostics diagnostics(file);
    UnityAsset asset{std::move(file), {}};
    for (const YamlNode& document : documents)
    {
        std::optional<UnityObject> object = ReadObject(document);
        if (!object)
        {
            diagnostics.Error(document.location(),
                              "this document is no Unity object; one begins like '--- !u!114 "
                              "&11400000' and has one map, 'MonoBehaviour:'");
            continue;
        }
        if (const UnityObject* same = asset.Find(object->fileID))
        {
            diagnostics.Error(object->location,
                              "duplicate fileID " + std::to_string(object->fileID) +
                                  "; it is already at " + std::to_string(same->location.line) +
                                  ":" + std::to_string(same->location.column));
        }
        asset.objects.push_back(std::move(*object));
    }
    diagnostics.ThrowIfErrors();
    return asset;
}

UnityAsset LoadUnityAsset(const std::filesystem::path& path)
{
    return ReadUnityAsset(LoadYamlFile(path), path.generic_string());
}

std::optional<std::int64_t> ReadFileID(const YamlNode& reference)
{
    const YamlNode* id = reference.Find("fileID");
    return id ? ParseWhole<std::int64_t>(id->scalar()) : std::nullopt;
}

} // namespace limn
