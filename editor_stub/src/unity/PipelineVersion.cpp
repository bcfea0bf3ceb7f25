#include "unity/PipelineVersion.h"

#include "console/Json.h"
#include "settings/Keys.h"
#include "unity/UnityProject.h"

#include <charconv>
#include <limn/base/ReadFile.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

namespace
{

constexpr const char* k_Package = "com.unity.render-pipelines.universal";

/// Null unless `json` is an object with such a member.
Json Member(const Json& json, const char* name)
{
    return json.is_object() && json.contains(name) ? json[name] : Json();
}

} // namespace

std::optional<int> ProjectPipelineVersion(const std::filesystem::path& file, AssetContext& assets)
{
    const std::filesystem::path root = UnityProjectAround(file);
    if (root.empty())
    {
        return std::nullopt;
    }
    const std::filesystem::path manifest = root / "Packages" / "manifest.json";
    assets.Reach(manifest);
    const Json json = Json::parse(TryReadFile(manifest).bytes, nullptr, false);
    const Json package = Member(Member(json, "dependencies"), k_Package);
    if (!package.is_string())
    {
        return std::nullopt;
    }
    // "14.0.11"; a folder or a repository in place of a version tells nothing.
    const std::string text = package.get<std::string>();
    int version = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), version);
    const bool isVersion = error == std::errc{} && rest != text.data() + text.size() &&
                           *rest == '.' && version >= scene_keys::k_PipelineVersions.min &&
                           version <= scene_keys::k_PipelineVersions.max;
    return isVersion ? std::optional(version) : std::nullopt;
}

std::optional<int> PipelineVersionOf(const YamlNode& pipelineFields)
{
    const YamlNode* node = pipelineFields.Find("k_AssetVersion");
    AssetDiagnostics ignored("");
    const std::optional<int> version = node ? ReadInt(*node, "", ignored) : std::nullopt;
    if (!version)
    {
        return std::nullopt;
    }
    return *version < 9 ? 11 : *version == 9 ? 12 : *version == 10 ? 13 : *version == 11 ? 14 : 17;
}

} // namespace limn
