#include "assets/FileKind.h"

#include <algorithm>
#include <limn/features/Features.h>
#include <limn/volume/YamlNode.h>

namespace limn
{

namespace
{

struct NamedKind
{
    const char* ending;
    FileKind kind;
    const char* noun;
};

constexpr NamedKind k_NamedKinds[] = {{".scene.yaml", FileKind::Scene, "scene"},
                                      {".profile.yaml", FileKind::Profile, "volume profile"},
                                      {".material.yaml", FileKind::Material, "material"},
                                      {".shader", FileKind::Shader, "shader"},
                                      {".asset", FileKind::UnityAsset, "Unity asset"},
                                      {".unity", FileKind::UnityScene, "Unity scene"},
                                      {".prefab", FileKind::UnityPrefab, "Unity prefab"},
                                      {".mat", FileKind::UnityMaterial, "Unity material"},
                                      {".gltf", FileKind::Mesh, "mesh"},
                                      {".glb", FileKind::Mesh, "mesh"},
                                      {".png", FileKind::Picture, "picture"},
                                      {".cs", FileKind::CSharp, "C# file"}};

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

/// Returns the name of a kind of file, and the use of such a file.
std::string UseOf(FileKind kind, const std::string& file)
{
    switch (kind)
    {
    case FileKind::Scene:
        return "a scene; 'limn render " + file + " -o out.png' draws it";
    case FileKind::Profile:
        return "a volume profile; 'limn render SCENE -o out.png --profile " + file +
               "' draws with it, 'limn inspect " + file + "' shows it";
    case FileKind::Material:
        return "a material; a scene's 'materials' name it";
    case FileKind::Shader:
        return "a shader; 'limn shader " + file + "' describes it";
    case FileKind::UnityAsset:
        return "an Unity asset; 'limn inspect " + file + "' shows it";
    case FileKind::UnityScene:
        return "a Unity scene; 'limn render " + file + " -o out.png' draws it, 'limn inspect " +
               file + "' shows its profiles and features, whose own files 'limn set' changes";
    case FileKind::UnityPrefab:
        return "a Unity prefab, which is drawn where a .unity scene holds it";
    case FileKind::UnityMaterial:
        return "a Unity material, which limn uses in a Unity scene; 'limn inspect " + file +
               "' shows it";
    case FileKind::Mesh:
        return "a mesh; a scene's objects name it: 'mesh: " + file + "'";
    case FileKind::Picture:
        return "a picture; a scene's or material's texture properties name it";
    case FileKind::CSharp:
        return "a C# file; 'limn port " + file + " -o FOLDER' makes C++ of it";
    case FileKind::Unknown:
        break;
    }
    throw ContractError("UseOf: unknown kind of file");
}

/// "no scene or volume profile; a *.scene.yaml or *.profile.yaml file is expected"
std::string NoneOf(std::initializer_list<FileKind> kinds)
{
    std::string nouns;
    std::string endings;
    for (const FileKind kind : kinds)
    {
        const NamedKind& named =
            *std::ranges::find_if(k_NamedKinds, [kind](const auto& k) { return k.kind == kind; });
        nouns += (nouns.empty() ? "" : " or ") + std::string(named.noun);
        endings += (endings.empty() ? "*" : " or *") + std::string(named.ending);
    }
    return "no " + nouns + "; a " + endings + " file is expected";
}

} // namespace

FileKind FileKindOf(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file / "Assets", ignored))
    {
        return FileKind::UnityScene; // the project's first
    }
    const std::string name = file.filename().string();
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
    return kind == FileKind::Unknown ? "" : UseOf(kind, file.generic_string());
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
                             (isKnown ? UseOf(kind, file.generic_string()) : NoneOf(kinds)));
    }
}

} // namespace limn
