#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>

namespace limn
{

/// The kinds of files that limn knows.
enum class FileKind
{
    Unknown,
    Scene,
    Profile,
    Material,
    Shader,
    UnityAsset, ///< a profile or a renderer; only the content tells
    UnityScene, ///< a scene, or the folder of a project
    UnityPrefab,
    UnityMaterial,
    Mesh,
    Picture,
    CSharp
};

/// Returns the kind of a file by its name, or else by its content: a shader's first words, or the
/// keys that a YAML file begins with.
FileKind FileKindOf(const std::filesystem::path& file);

/// Returns what a file is and what can be done with it: "a scene; 'limn render a.scene.yaml -o
/// out.png' draws it". Returns "" if its kind is not known.
std::string UseOfFile(const std::filesystem::path& file);

/// Returns the name of a file beside a missing one that may be meant, or "" if there is none. It
/// has the same ending and nearly the same name.
std::string NearestFile(const std::filesystem::path& missing);

/// @param verb  the verb that reads the file: "render", "inspect"
/// @throws AssetError with the file's kind and the verb that takes it, if the file is known to be
///     of none of these kinds, or if neither its name nor its content tells its kind. Unity's
///     assets pass for profiles. Any other *.yaml file passes as well: its reader knows which line
///     is wrong.
void RequireKind(const std::filesystem::path& file, std::initializer_list<FileKind> kinds,
                 const std::string& verb);

} // namespace limn
