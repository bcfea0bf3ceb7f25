#pragma once

#include "unity/UnityObjects.h"
#include "unity/UnityProject.h"
#include "unity/UnityReader.h"

#include <limn/editor_stub/AssetContext.h>

namespace limn
{

/// The shader of Unity's default material, which also replaces shaders that limn lacks.
inline constexpr const char* k_Lit = "Universal Render Pipeline/Lit";

/// Assets that come with Unity itself or its packages and so have no file in a project.
enum class UnityPackageAsset
{
    None,
    Mesh,     ///< a mesh with the name of a PrimitiveType
    Material, ///< a material with a shader's defaults
    Shader,
    Other ///< others, such as fonts, cookies and data of the pipeline, which limn does not need
};

struct UnityKnownAsset
{
    UnityPackageAsset kind = UnityPackageAsset::None;
    std::string_view name; ///< "cube" for a mesh; the shader's name for a material or a shader
};

/// Returns the asset that Unity has under a guid of its own. `kind` is None for a guid of a
/// project.
UnityKnownAsset FindKnownAsset(const UnityReference& reference);

/// The files of a Unity project by guid, and its text assets, which are each read once.
class UnityDatabase
{
public:
    /// @param file  a file of the project; files that are read are added to the reached files of
    ///     `assets`
    UnityDatabase(const std::filesystem::path& file, AssetContext& assets, UnityNotes& notes);

    const std::filesystem::path& root() const { return m_Project.root(); }
    const UnityProject& project() const { return m_Project; }

    /// Returns the file with a guid, or null if it does not exist or may not be read.
    const std::filesystem::path* Find(const std::string& guid);
    /// Returns why there is nothing behind a reference: "no file of the project has the texture's
    /// guid 12ab…".
    /// @param whose  what has the guid: "the texture's guid"
    /// An asset that is built into Unity and that limn lacks has a sentence of its own.
    std::string WhyNotFound(const UnityReference& reference,
                            std::string_view whose = "its guid") const;
    /// Loads a text asset. Returns null and adds a note if there is none, it is broken or it is
    /// saved as binary.
    std::shared_ptr<const UnityFile> LoadFile(const std::filesystem::path& path);
    /// Loads a text asset as LoadFile does, and returns its object of a class that has this id, or
    /// else the first of the class; nothing if it has none.
    /// @throws AssetError as UnityTree
    UnityNode FieldsOf(const std::filesystem::path& path, UnityClass classID,
                       std::int64_t fileID = 0);

private:
    AssetContext& m_Assets;
    UnityNotes& m_Notes;
    UnityProject m_Project;
    std::map<std::filesystem::path, std::shared_ptr<const UnityFile>> m_Files;
};

} // namespace limn
