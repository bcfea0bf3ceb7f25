#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>

namespace limn
{

/// What a file is for.
enum class FileKind
{
    Unknown,
    Scene,
    Profile,
    Material,
    Shader,
    UnityAsset, ///< profile or renderer: only its content tells
    UnityScene, ///< or prefab
    UnityMaterial,
    Mesh,
    Picture
};

/// Told by the name; the kind of another YAML file by the keys it begins with, if it can be read.
FileKind FileKindOf(const std::filesystem::path& file);

/// @param verb  "render", "inspect": who wants to read the file
/// @throws AssetError that says what the file is and which verb takes it, if it is known to be of
///     none of these kinds. Unity's assets pass for profiles.
void RequireKind(const std::filesystem::path& file, std::initializer_list<FileKind> kinds,
                 const std::string& verb);

} // namespace limn
