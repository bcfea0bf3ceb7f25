#pragma once

#include "unity/UnityDatabase.h"

#include <limn/core/Texture.h>

namespace limn
{

/// The textures of a project's scene: pictures, and textures that .asset files hold as text.
class UnityTextures
{
public:
    UnityTextures(UnityDatabase& database, AssetContext& assets, UnityNotes& notes)
        : m_Database(database), m_Assets(assets), m_Notes(notes)
    {
    }

    /// Loads a texture. Returns null and adds a note if it is broken, or else sets `problem`.
    /// @param guid       what the reference names: "the texture's guid"
    /// @param otherwise  what a picture of another dimension is: "no cube"
    std::shared_ptr<const Texture> Load(const UnityReference& texture, TextureDimension dimension,
                                        std::string_view guid, const char* otherwise,
                                        std::string& problem);

private:
    std::shared_ptr<const Texture> LoadText(const UnityReference& texture,
                                            const std::filesystem::path& path,
                                            TextureDimension dimension, std::string& problem);
    std::shared_ptr<const Texture> LoadPicture(const std::filesystem::path& path,
                                               TextureDimension dimension, const char* otherwise,
                                               std::string& problem);
    /// Reads the texture of this id, or else the first of the file; null if it holds none, and null
    /// with a note if it is broken.
    std::shared_ptr<const Texture> ReadText(const std::filesystem::path& path, std::int64_t fileID);

    UnityDatabase& m_Database;
    AssetContext& m_Assets;
    UnityNotes& m_Notes;
    std::map<UnityReference, std::shared_ptr<const Texture>> m_OfText;
};

} // namespace limn
