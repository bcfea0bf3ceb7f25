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
    UnityScene, ///< or the folder of a project
    UnityPrefab,
    UnityMaterial,
    Mesh,
    Picture,
    CSharp
};

/// Told by the name; if that says nothing, by the content: a shader's first words, or the keys that
/// a YAML file begins with.
FileKind FileKindOf(const std::filesystem::path& file);

/// Returns the name of the file beside a missing one that may be meant: one of the same ending
/// whose name is nearly the same; "" if there is none.
std::string NearestFile(const std::filesystem::path& missing);

/// @param verb  "render", "inspect": who wants to read the file
/// @throws AssetError that says what the file is and which verb takes it, if it is known to be of
///     none of these kinds, or neither its name nor its content says of which. Unity's assets pass
///     for profiles, and every other *.yaml file: who reads it knows what is wrong in which line.
void RequireKind(const std::filesystem::path& file, std::initializer_list<FileKind> kinds,
                 const std::string& verb);

} // namespace limn
