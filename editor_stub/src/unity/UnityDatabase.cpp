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

} // namespace

UnityKnownAsset FindKnownAsset(const UnityReference& reference)
{
    struct BuiltIn
    {
        std::string_view guid;
        UnityPackageAsset kind;
        std::string_view name;
        std::int64_t fileID = 0; ///< 0 = of all that follow
    };
    using enum UnityPackageAsset;
    // Guids of the packages are those of URP 7 to 17.
    static constexpr BuiltIn k_BuiltIns[] = {
        {k_DefaultResources, Mesh, "cube", 10202},
        {k_DefaultResources, Mesh, "cylinder", 10206},
        {k_DefaultResources, Mesh, "sphere", 10207},
        {k_DefaultResources, Mesh, "capsule", 10208},
        {k_DefaultResources, Mesh, "plane", 10209},
        {k_DefaultResources, Mesh, "quad", 10210},
        {k_DefaultResources, Other, "a resource of Unity's"},
        {k_BuiltinExtra, Material, "Universal Render Pipeline/Simple Lit", 10302},
        {k_BuiltinExtra, Material, k_Lit, 10303},
        {k_BuiltinExtra, Material, "Skybox/Procedural", 10304},
        {k_BuiltinExtra, Material, "Sprites/Default", 10754},
        {k_BuiltinExtra, Shader, "Sprites/Default", 10753},
        {k_BuiltinExtra, Shader, "Standard", 46},
        {k_BuiltinExtra, Shader, "Standard (Specular setup)", 45},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Diffuse Fast", 1},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Bumped Diffuse", 2},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Specular", 3},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Bumped Specular", 4},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Diffuse Detail", 5},
        {k_BuiltinExtra, Shader, "Legacy Shaders/VertexLit", 6},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Diffuse", 7},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Parallax Diffuse", 8},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Parallax Specular", 9},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Diffuse", 30},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Bumped Diffuse", 31},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Specular", 32},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Bumped Specular", 33},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/VertexLit", 34},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Parallax Diffuse", 35},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Parallax Specular", 36},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Cutout/VertexLit", 50},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Cutout/Diffuse", 51},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Cutout/Bumped Diffuse", 52},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Cutout/Specular", 53},
        {k_BuiltinExtra, Shader, "Legacy Shaders/Transparent/Cutout/Bumped Specular", 54},
        {k_BuiltinExtra, Shader, "Mobile/VertexLit", 10701},
        {k_BuiltinExtra, Shader, "Mobile/Diffuse", 10703},
        {k_BuiltinExtra, Shader, "Mobile/Bumped Diffuse", 10704},
        {k_BuiltinExtra, Shader, "Mobile/Bumped Specular", 10705},
        {k_BuiltinExtra, Shader, "Skybox/Cubemap", 103},
        {k_BuiltinExtra, Shader, "Skybox/6 Sided", 104},
        {k_BuiltinExtra, Shader, "Skybox/Procedural", 106},
        {k_BuiltinExtra, Shader, "Skybox/Panoramic", 108},
        {k_BuiltinExtra, Shader, "Unlit/Transparent", 10750},
        {k_BuiltinExtra, Shader, "Unlit/Transparent Cutout", 10751},
        {k_BuiltinExtra, Shader, "Unlit/Texture", 10752},
        {k_BuiltinExtra, Shader, "Unlit/Color", 10755},
        {k_BuiltinExtra, Other, "a resource of Unity's"},
        {"933532a4fcc9baf4fa0491de14d08ed7", Shader, k_Lit},
        {"650dd9526735d5b46b79224bc6e94025", Shader, "Universal Render Pipeline/Unlit"},
        {"8d2bb70cbf9db8d4da26e15b26e74248", Shader, "Universal Render Pipeline/Simple Lit"},
        {"ee7e4c9a5f6364b688a332c67fc32cca", Shader, "Universal Render Pipeline/Complex Lit"},
        {"0ca6dca7396eb48e5849247ffd444914", Shader, "Universal Render Pipeline/Baked Lit"},
        {"b7839dad95683814aa64166edc107ae2", Shader, "Universal Render Pipeline/Particles/Lit"},
        {"8516d7a69675844a7a0b7095af7c46af", Shader,
         "Universal Render Pipeline/Particles/Simple Lit"},
        {"0406db5a14f94604a8c57ccfbc9f3b46", Shader, "Universal Render Pipeline/Particles/Unlit"},
        // Shader graphs of the package.
        {"0e9d5a909a1f7e84882a534d0d11e49f", Shader, "Autodesk Interactive"},
        {"5c81372d981403744adbdda4433c9c11", Shader, "Autodesk Interactive Transparent"},
        {"80aa867ac363ac043847b06ad71604cd", Shader, "Autodesk Interactive Masked"},
        {"31321ba15b8f8eb4c954353edc038b1d", Material, k_Lit},
        {"6a1143ee683302f4aa628c052723efc1", Material, "Universal Render Pipeline/Simple Lit"},
        {"e823cd5b5d27c0f4b8256e7c12ee3e6d", Material, "Universal Render Pipeline/Particles/Unlit"},
        // Sprite-Lit-Default, its material and the one of Sprite-Unlit-Default; without the 2D
        // renderer none is lit.
        {"e260cfa7296ee7642b167f1eb5be5023", Shader, "Sprites/Default"},
        {"a97c105638bdf8b4a8650670310a4cd3", Material, "Sprites/Default"},
        {"9dfc825aed78fcd4ba02077103263b40", Material, "Sprites/Default"},
    };
    const auto* const found =
        std::ranges::find_if(k_BuiltIns,
                             [&](const BuiltIn& known)
                             {
                                 return known.guid == reference.guid &&
                                        (known.fileID == 0 || known.fileID == reference.fileID);
                             });
    return found == std::end(k_BuiltIns) ? UnityKnownAsset()
                                         : UnityKnownAsset{found->kind, found->name};
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

std::string UnityDatabase::WhyNotFound(const UnityReference& reference,
                                       std::string_view whose) const
{
    if (FindKnownAsset(reference).kind == UnityPackageAsset::Other)
    {
        return "limn does not have this asset, which is built into Unity (fileID " +
               std::to_string(reference.fileID) + ")";
    }
    const std::filesystem::path* path = m_Project.Find(reference.guid);
    if (path == nullptr)
    {
        return "no file of the project has " + std::string(whose) + " " + reference.guid;
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
    const auto [known, isNew] = m_Files.try_emplace(path);
    if (!isNew)
    {
        return known->second;
    }
    const std::string name = path.generic_string();
    FileContent content = TryReadFile(path, k_MaxAssetBytes);
    const std::string problem =
        !content.isRead() ? content.problem
        : content.bytes.starts_with("version https://git-lfs")
            ? "this is a pointer of Git LFS in place of the file; run 'git lfs pull'"
        : content.bytes.empty() ? "the file is empty; a text asset of Unity's is expected"
        : !IsUnityAsset(content.bytes)
            ? "this asset is saved as binary, which limn does not read; set Asset Serialization to "
              "Force Text in Unity"
            : "";
    if (!problem.empty())
    {
        m_Notes.Add(name, 0, problem);
        return nullptr;
    }
    try
    {
        known->second = std::make_shared<const UnityFile>(std::move(content.bytes), name);
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
    }
    return known->second;
}

UnityNode UnityDatabase::FieldsOf(const std::filesystem::path& path, UnityClass classID,
                                  std::int64_t fileID)
{
    const std::shared_ptr<const UnityFile> file = LoadFile(path);
    const UnityHeader* found = nullptr;
    for (const UnityHeader& header : file ? file->headers() : std::span<const UnityHeader>())
    {
        const bool isOfClass = static_cast<UnityClass>(header.classID) == classID;
        if (isOfClass && !header.isStripped && (!found || header.fileID == fileID))
        {
            found = &header;
        }
    }
    return found ? file->Fields(*found) : UnityNode();
}

} // namespace limn
