#include "unity/UnityDatabase.h"

#include "assets/Importer.h"

#include <algorithm>
#include <limn/base/ReadFile.h>

namespace limn
{

namespace
{

constexpr std::uintmax_t k_MaxAssetBytes = std::uintmax_t{1} << 30;
constexpr std::string_view k_DefaultResources = "0000000000000000e000000000000000";
constexpr std::string_view k_BuiltinExtra = "0000000000000000f000000000000000";

struct BuiltIn
{
    std::string_view guid;
    std::int64_t fileID; ///< 0 = of all
    UnityKnownAsset asset;
};

/// Guids of the packages are those of URP 7 to 17.
constexpr BuiltIn k_BuiltIns[] = {
    {k_DefaultResources, 10202, {UnityPackageAsset::Mesh, "cube"}},
    {k_DefaultResources, 10206, {UnityPackageAsset::Mesh, "cylinder"}},
    {k_DefaultResources, 10207, {UnityPackageAsset::Mesh, "sphere"}},
    {k_DefaultResources, 10208, {UnityPackageAsset::Mesh, "capsule"}},
    {k_DefaultResources, 10209, {UnityPackageAsset::Mesh, "plane"}},
    {k_DefaultResources, 10210, {UnityPackageAsset::Mesh, "quad"}},
    {k_DefaultResources, 0, {UnityPackageAsset::Other, "a resource of Unity's"}},
    {k_BuiltinExtra, 10303, {UnityPackageAsset::Material, k_Lit}},
    {k_BuiltinExtra, 10304, {UnityPackageAsset::Material, "Skybox/Procedural"}},
    {k_BuiltinExtra, 10754, {UnityPackageAsset::Material, "Sprites/Default"}},
    {k_BuiltinExtra, 10753, {UnityPackageAsset::Shader, "Sprites/Default"}},
    {k_BuiltinExtra, 46, {UnityPackageAsset::Shader, "Standard"}},
    {k_BuiltinExtra, 45, {UnityPackageAsset::Shader, "Standard (Specular setup)"}},
    {k_BuiltinExtra, 7, {UnityPackageAsset::Shader, "Legacy Shaders/Diffuse"}},
    {k_BuiltinExtra, 103, {UnityPackageAsset::Shader, "Skybox/Cubemap"}},
    {k_BuiltinExtra, 104, {UnityPackageAsset::Shader, "Skybox/6 Sided"}},
    {k_BuiltinExtra, 106, {UnityPackageAsset::Shader, "Skybox/Procedural"}},
    {k_BuiltinExtra, 108, {UnityPackageAsset::Shader, "Skybox/Panoramic"}},
    {k_BuiltinExtra, 10750, {UnityPackageAsset::Shader, "Unlit/Transparent"}},
    {k_BuiltinExtra, 10751, {UnityPackageAsset::Shader, "Unlit/Transparent Cutout"}},
    {k_BuiltinExtra, 10752, {UnityPackageAsset::Shader, "Unlit/Texture"}},
    {k_BuiltinExtra, 10755, {UnityPackageAsset::Shader, "Unlit/Color"}},
    {k_BuiltinExtra, 0, {UnityPackageAsset::Other, "a resource of Unity's"}},
    {"933532a4fcc9baf4fa0491de14d08ed7", 0, {UnityPackageAsset::Shader, k_Lit}},
    {"650dd9526735d5b46b79224bc6e94025",
     0,
     {UnityPackageAsset::Shader, "Universal Render Pipeline/Unlit"}},
    {"8d2bb70cbf9db8d4da26e15b26e74248",
     0,
     {UnityPackageAsset::Shader, "Universal Render Pipeline/Simple Lit"}},
    {"ee7e4c9a5f6364b688a332c67fc32cca",
     0,
     {UnityPackageAsset::Shader, "Universal Render Pipeline/Complex Lit"}},
    {"0ca6dca7396eb48e5849247ffd444914",
     0,
     {UnityPackageAsset::Shader, "Universal Render Pipeline/Baked Lit"}},
    {"b7839dad95683814aa64166edc107ae2",
     0,
     {UnityPackageAsset::Shader, "Universal Render Pipeline/Particles/Lit"}},
    {"8516d7a69675844a7a0b7095af7c46af",
     0,
     {UnityPackageAsset::Shader, "Universal Render Pipeline/Particles/Simple Lit"}},
    {"0406db5a14f94604a8c57ccfbc9f3b46",
     0,
     {UnityPackageAsset::Shader, "Universal Render Pipeline/Particles/Unlit"}},
    {"31321ba15b8f8eb4c954353edc038b1d", 0, {UnityPackageAsset::Material, k_Lit}},
    {"6a1143ee683302f4aa628c052723efc1",
     0,
     {UnityPackageAsset::Material, "Universal Render Pipeline/Simple Lit"}},
    {"e823cd5b5d27c0f4b8256e7c12ee3e6d",
     0,
     {UnityPackageAsset::Material, "Universal Render Pipeline/Particles/Unlit"}},
    // Sprite-Lit-Default and Sprite-Unlit-Default; without the 2D renderer neither is lit.
    {"a97c105638bdf8b4a8650670310a4cd3", 0, {UnityPackageAsset::Material, "Sprites/Default"}},
    {"9dfc825aed78fcd4ba02077103263b40", 0, {UnityPackageAsset::Material, "Sprites/Default"}},
};

} // namespace

UnityKnownAsset FindKnownAsset(const UnityReference& reference)
{
    const auto found =
        std::ranges::find_if(k_BuiltIns,
                             [&](const BuiltIn& known)
                             {
                                 return known.guid == reference.guid &&
                                        (known.fileID == 0 || known.fileID == reference.fileID);
                             });
    return found == std::end(k_BuiltIns) ? UnityKnownAsset() : found->asset;
}

const UnityHeader* FindClass(const UnityFile& file, UnityClass classID)
{
    const auto found = std::ranges::find_if(
        file.headers(), [classID](const UnityHeader& header)
        { return static_cast<UnityClass>(header.classID) == classID && !header.isStripped; });
    return found == file.headers().end() ? nullptr : &*found;
}

UnityDatabase::UnityDatabase(const std::filesystem::path& file, AssetContext& assets,
                             UnityNotes& notes)
    : m_Assets(assets), m_Notes(notes), m_Project(file, assets.importer().cacheFolder())
{
}

const std::filesystem::path* UnityDatabase::Find(const std::string& guid)
{
    const std::filesystem::path* path = m_Project.Find(guid);
    if (path == nullptr)
    {
        return nullptr;
    }
    m_Assets.Reach(path->string() + ".meta");
    m_Assets.Reach(*path);
    std::error_code ignored;
    return std::filesystem::is_regular_file(*path, ignored) && m_Assets.roots().Contains(*path)
               ? path
               : nullptr;
}

std::string UnityDatabase::WhyNotFound(const std::string& guid, std::string_view whose) const
{
    const std::filesystem::path* path = m_Project.Find(guid);
    if (path == nullptr)
    {
        return "no file of the project has " + std::string(whose) + " " + guid;
    }
    const std::string name = "'" + path->lexically_relative(root()).generic_string() + "'";
    std::error_code ignored;
    return std::filesystem::exists(*path, ignored)
               ? name + " is a link that leads out of the project, or no file"
               : name + " is not there, though its .meta file is";
}

std::shared_ptr<const UnityFile> UnityDatabase::LoadFile(const std::filesystem::path& path)
{
    m_Assets.Reach(path);
    const auto found = m_Files.find(path);
    if (found != m_Files.end())
    {
        return found->second;
    }
    std::shared_ptr<const UnityFile> file;
    const std::string name = path.generic_string();
    FileContent content = TryReadFile(path, k_MaxAssetBytes);
    if (!content.isRead())
    {
        m_Notes.Add(name, 0, content.problem);
    }
    else if (content.bytes.starts_with("version https://git-lfs"))
    {
        m_Notes.Add(name, 0,
                    "this is a pointer of Git LFS in place of the file; run 'git lfs pull'");
    }
    else if (content.bytes.empty())
    {
        m_Notes.Add(name, 0, "the file is empty; a text asset of Unity's is expected");
    }
    else if (!IsUnityAsset(content.bytes))
    {
        m_Notes.Add(name, 0,
                    "this asset is saved as binary, which limn does not read; set Asset "
                    "Serialization to Force Text in Unity");
    }
    else
    {
        try
        {
            file = std::make_shared<const UnityFile>(std::move(content.bytes), name);
        }
        catch (const AssetError& error)
        {
            m_Notes.Add(error.diagnostics());
        }
    }
    return m_Files[path] = file;
}

} // namespace limn
