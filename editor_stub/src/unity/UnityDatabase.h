#pragma once

#include "unity/UnityObjects.h"
#include "unity/UnityProject.h"
#include "unity/UnityReader.h"

#include <limn/editor_stub/AssetContext.h>

namespace limn
{

/// The shader of Unity's default material, and what stands in for shaders that limn has not.
inline constexpr const char* k_Lit = "Universal Render Pipeline/Lit";

/// Assets that come with Unity itself or its packages and so have no file in a project.
enum class UnityPackageAsset
{
    None,
    Mesh,     ///< a PrimitiveType
    Material, ///< of a shader's defaults
    Shader,
    Other ///< such as fonts, cookies and data of the pipeline, which limn does without
};

struct UnityKnownAsset
{
    UnityPackageAsset kind = UnityPackageAsset::None;
    std::string_view name; ///< of a mesh "cube", of a material and of a shader the shader's name
};

/// Returns what Unity has under a guid of its own. `kind` is None for a guid that is a project's.
UnityKnownAsset FindKnownAsset(const UnityReference& reference);

/// The files of a Unity project by guid, and its text assets, each read once.
class UnityDatabase
{
public:
    /// @param root  of the project; the files that are read are reached by `assets`
    UnityDatabase(const std::filesystem::path& root, AssetContext& assets, UnityNotes& notes);

    const std::filesystem::path& root() const { return m_Project.root(); }
    const UnityProject& project() const { return m_Project; }

    /// The file of a guid, where it is there and may be read; null otherwise.
    const std::filesystem::path* Find(const std::string& guid);
    /// A text asset. Null, with a note, where there is none, it is broken or it is saved as binary.
    std::shared_ptr<const UnityFile> Load(const std::string& guid);
    std::shared_ptr<const UnityFile> LoadFile(const std::filesystem::path& path);

private:
    AssetContext& m_Assets;
    UnityNotes& m_Notes;
    UnityProject m_Project;
    std::map<std::filesystem::path, std::shared_ptr<const UnityFile>> m_Files;
};

/// The first object of a class in a file, of any scope; null if it has none.
const UnityHeader* FindClass(const UnityFile& file, UnityClass classID);

} // namespace limn
