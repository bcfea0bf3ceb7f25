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
};

constexpr NamedKind k_NamedKinds[] = {{".scene.yaml", FileKind::Scene},
                                      {".profile.yaml", FileKind::Profile},
                                      {".material.yaml", FileKind::Material},
                                      {".shader", FileKind::Shader},
                                      {".asset", FileKind::UnityAsset},
                                      {".unity", FileKind::UnityScene},
                                      {".prefab", FileKind::UnityScene},
                                      {".mat", FileKind::UnityMaterial},
                                      {".gltf", FileKind::Mesh},
                                      {".glb", FileKind::Mesh},
                                      {".png", FileKind::Picture}};

FileKind KindOfContent(const std::filesystem::path& file)
{
    try
    {
        const std::vector<YamlNode> documents = LoadYamlFile(file);
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

/// What a kind is called, and what can be done with such a file.
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
        return "an asset of Unity's; 'limn inspect " + file + "' shows it";
    case FileKind::UnityScene:
        return "a scene or prefab of Unity's, which limn does not draw; write a *.scene.yaml";
    case FileKind::UnityMaterial:
        return "a material of Unity's, which limn does not read; write a *.material.yaml";
    case FileKind::Mesh:
        return "a mesh; a scene's objects name it: 'mesh: " + file + "'";
    case FileKind::Picture:
        return "a picture; a scene's or material's texture properties name it";
    case FileKind::Unknown:
        break;
    }
    throw ContractError("UseOf: unknown kind of file");
}

} // namespace

FileKind FileKindOf(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    for (const NamedKind& named : k_NamedKinds)
    {
        if (name.ends_with(named.ending))
        {
            return named.kind;
        }
    }
    return name.ends_with(".yaml") || name.ends_with(".yml") ? KindOfContent(file)
                                                             : FileKind::Unknown;
}

void RequireKind(const std::filesystem::path& file, std::initializer_list<FileKind> kinds,
                 const std::string& verb)
{
    const auto isWanted = [&kinds](FileKind kind)
    {
        return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    };
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
    {
        return;
    }
    const FileKind kind = FileKindOf(file);
    const bool mayBeWanted = kind == FileKind::Unknown || isWanted(kind) ||
                             (kind == FileKind::UnityAsset && isWanted(FileKind::Profile));
    if (!mayBeWanted)
    {
        throw AssetError(file.generic_string(), {},
                         "'" + verb + "' cannot take it: this is " +
                             UseOf(kind, file.generic_string()));
    }
}

} // namespace limn
