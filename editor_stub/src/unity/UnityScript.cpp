#include "unity/UnityScript.h"

namespace limn
{

namespace
{

/// Scripts of the URP package, whose .meta files are in no project. (URP 14)
constexpr std::pair<std::string_view, std::string_view> k_PackageScripts[] = {
    {"6b3d386ba5cd94485973aee1479b272e", "RenderObjects"},
    {"b00045f12942b46c698459096c89274e", "FullScreenPassRendererFeature"}};

} // namespace

std::string UnityScriptClass(const std::string& guid, const UnityProject& project)
{
    for (const auto& [packageGuid, type] : k_PackageScripts)
    {
        if (guid == packageGuid)
        {
            return std::string(type);
        }
    }
    const std::filesystem::path* path = project.Find(guid);
    return path ? path->stem().string() : std::string();
}

} // namespace limn
