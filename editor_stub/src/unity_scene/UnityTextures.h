#pragma once

#include "unity/UnityDatabase.h"

#include <limn/core/RenderTexture.h>
#include <set>

namespace limn
{

/// The textures of a project's scene: pictures, textures that .asset files hold as text, and those
/// that cameras draw into.
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

    /// Loads a texture of any dimension that a feature has as a setting. Returns null and gives
    /// `note` the reason if there is none; a broken file has its own notes, too.
    std::shared_ptr<const Texture>
    LoadForFeature(const UnityReference& texture,
                   const std::function<void(const std::string& reason)>& note);

    /// Lets Load make the render texture of a file. Others are refused, since nothing fills them.
    void AddTarget(const UnityReference& texture) { m_Drawn.insert(texture); }
    /// Returns the render texture that Load has made, or null if nothing has asked for it.
    std::shared_ptr<const RenderTexture> FindTarget(const UnityReference& texture) const;

private:
    std::shared_ptr<const Texture> LoadText(const UnityReference& texture,
                                            const std::filesystem::path& path,
                                            TextureDimension dimension, std::string& problem);
    std::shared_ptr<const Texture> LoadPicture(const std::filesystem::path& path,
                                               TextureDimension dimension, const char* otherwise,
                                               std::string& problem);
    /// Reads the texture of this id, or else the first of the file. Returns null if it holds none,
    /// and null with a note if it is broken.
    std::shared_ptr<const Texture> ReadText(const std::filesystem::path& path, std::int64_t fileID);

    UnityDatabase& m_Database;
    AssetContext& m_Assets;
    UnityNotes& m_Notes;
    std::map<UnityReference, std::shared_ptr<const Texture>> m_OfText;
    std::set<UnityReference> m_Drawn; ///< the render textures that cameras draw into
};

} // namespace limn
