#include "assets/FileKind.h"

#include "console/Texts.h"

#include <algorithm>
#include <limn/base/Case.h>
#include <limn/features/Features.h>
#include <limn/volume/YamlNode.h>

namespace limn
{

namespace
{

struct NamedKind
{
    std::string_view ending;
    FileKind kind;
    std::string_view noun;
    /// The kind of such a file, and what can be done with it. FILE stands for its name.
    const char* use;
};

constexpr const char* k_UseOfMesh = "a mesh; a scene's objects name it: 'mesh: FILE'";

constexpr NamedKind k_NamedKinds[] = {
    {".scene.yaml", FileKind::Scene, "scene", "a scene; 'limn render FILE -o out.png' draws it"},
    {".profile.yaml", FileKind::Profile, "volume profile",
     "a volume profile; 'limn render SCENE -o out.png --profile FILE' draws with it, 'limn inspect "
     "FILE' shows it"},
    {".material.yaml", FileKind::Material, "material", "a material; a scene's 'materials' name it"},
    {".shader", FileKind::Shader, "shader", "a shader; 'limn shader FILE' describes it"},
    {".shadergraph", FileKind::Shader, "shader graph",
     "a shader graph; 'limn shader FILE' describes it, with '--print' as ShaderLab"},
    {".asset", FileKind::UnityAsset, "Unity asset", "an Unity asset; 'limn inspect FILE' shows it"},
    {".unity", FileKind::UnityScene, "Unity scene",
     "a Unity scene; 'limn render FILE -o out.png' draws it, 'limn inspect FILE' shows its "
     "profiles and features, whose own files 'limn set' changes"},
    {".prefab", FileKind::UnityPrefab, "Unity prefab",
     "a Unity prefab, which is drawn where a .unity scene holds it"},
    {".mat", FileKind::UnityMaterial, "Unity material",
     "a Unity material, which limn uses in a Unity scene; 'limn inspect FILE' shows it"},
    {".gltf", FileKind::Mesh, "mesh", k_UseOfMesh},
    {".glb", FileKind::Mesh, "mesh", k_UseOfMesh},
    {".png", FileKind::Picture, "picture",
     "a picture; a scene's or material's texture properties name it"},
    {".cs", FileKind::CSharp, "C# file", "a C# file; 'limn port FILE -o FOLDER' makes C++ of it"}};

/// @param kind  must not be Unknown
const NamedKind& NamedKindOf(FileKind kind)
{
    return *std::ranges::find(k_NamedKinds, kind, &NamedKind::kind);
}

bool isYaml(const std::filesystem::path& file)
{
    return file.extension() == ".yaml" || file.extension() == ".yml";
}

FileKind KindOfContent(const std::filesystem::path& file)
{
    try
    {
        const std::string text = ReadYamlText(file);
        if (!isYaml(file) && text.find("Shader \"") != std::string::npos)
        {
            return FileKind::Shader;
        }
        const std::vector<YamlNode> documents = ParseYaml(text, file.generic_string());
        VolumeComponentRegistry components;
        RegisterVolumeComponents(components);
        for (const YamlEntry& entry : documents.front().entries())
        {
            const FileKind kind = entry.key == "camera"        ? FileKind::Scene
                                  : entry.key == "shader"      ? FileKind::Material
                                  : components.Find(entry.key) ? FileKind::Profile
                                                               : FileKind::Unknown;
            if (kind != FileKind::Unknown)
            {
                return kind;
            }
        }
    }
    catch (const AssetError&)
    {
        // Whoever loads the file says what is wrong with it.
    }
    return FileKind::Unknown;
}

std::string UseOf(FileKind kind, const std::filesystem::path& file)
{
    return Replaced(NamedKindOf(kind).use, "FILE", file.generic_string());
}

/// "no scene or volume profile; a *.scene.yaml or *.profile.yaml file is expected"
std::string NoneOf(std::initializer_list<FileKind> kinds)
{
    return "no " + Joined(kinds, " or ", [](FileKind kind) { return NamedKindOf(kind).noun; }) +
           "; a *" +
           Joined(kinds, " or *", [](FileKind kind) { return NamedKindOf(kind).ending; }) +
           " file is expected";
}

} // namespace

FileKind FileKindOf(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file / "Assets", ignored))
    {
        return FileKind::UnityScene; // the project's first
    }
    const std::string name = ToLower(file.filename().string());
    for (const NamedKind& named : k_NamedKinds)
    {
        if (name.ends_with(named.ending))
        {
            return named.kind;
        }
    }
    return KindOfContent(file);
}

std::string UseOfFile(const std::filesystem::path& file)
{
    const FileKind kind = FileKindOf(file);
    return kind == FileKind::Unknown ? "" : UseOf(kind, file);
}

std::string NearestFile(const std::filesystem::path& missing)
{
    std::error_code unknown;
    if (std::filesystem::symlink_status(missing, unknown).type() !=
        std::filesystem::file_type::not_found)
    {
        return ""; // a link that leads nowhere, or a file that cannot be looked at
    }
    const std::string name = missing.filename().string();
    const std::string ending = name.substr(std::min(name.find('.'), name.size()));
    const std::string stem = name.substr(0, name.size() - ending.size());
    const bool isShort = stem.size() < 3; // and is near to every other short one
    std::vector<std::string> alike;       // the stems of names with the same ending
    std::vector<std::string> others;      // names whose last part is the same
    std::error_code error;
    const std::filesystem::path folder = missing.parent_path();
    for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error), end;
         !error && entry != end; entry.increment(error))
    {
        const std::filesystem::path file = entry->path().filename();
        const std::string other = file.string();
        if (!ending.empty() && !isShort && other.ends_with(ending))
        {
            alike.push_back(other.substr(0, other.size() - ending.size()));
        }
        else if (!ending.empty() && file.extension() == missing.extension() &&
                 (!isShort || other.starts_with(stem + '.')))
        {
            others.push_back(other);
        }
    }
    std::ranges::sort(alike);
    std::ranges::sort(others);
    const std::string_view near = NearestName(stem, {alike.begin(), alike.end()});
    return !near.empty() ? std::string(near) + ending
                         : std::string(NearestName(name, {others.begin(), others.end()}));
}

void RequireKind(const std::filesystem::path& file, std::initializer_list<FileKind> kinds,
                 const std::string& verb)
{
    const auto isWanted = [&kinds](FileKind kind)
    {
        return std::ranges::find(kinds, kind) != kinds.end();
    };
    std::error_code ignored;
    const std::string nearest = std::filesystem::exists(file, ignored) ? "" : NearestFile(file);
    if (!nearest.empty())
    {
        throw AssetError(file.generic_string(), {},
                         "there is no such file; did you mean '" +
                             (file.parent_path() / nearest).generic_string() + "'?");
    }
    if (!std::filesystem::is_regular_file(file, ignored) &&
        (isWanted(FileKind::Shader) || !std::filesystem::is_directory(file / "Assets", ignored)))
    {
        return; // who reads it says why it cannot
    }
    const FileKind kind = FileKindOf(file);
    const bool isKnown = kind != FileKind::Unknown;
    const bool mayBeWanted = (!isKnown && isYaml(file)) || isWanted(kind) ||
                             (kind == FileKind::UnityAsset && isWanted(FileKind::Profile));
    if (!mayBeWanted)
    {
        throw AssetError(file.generic_string(), {},
                         "'" + verb + "' cannot take it: this is " +
                             (isKnown ? UseOf(kind, file) : NoneOf(kinds)));
    }
}

} // namespace limn
