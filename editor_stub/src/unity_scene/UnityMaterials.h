#pragma once

#include "models/ModelFile.h"
#include "unity/UnityDatabase.h"
#include "unity_scene/MaterialStandIn.h"

namespace limn
{

/// The shader of a Unity material.
struct UnityShader
{
    std::shared_ptr<const Shader> shader;     ///< null: the material is magenta
    std::optional<MaterialStandIn> standIn{}; ///< where it stands in for another shader
};

/// The meshes, materials, textures and prefabs of a project's scene, each loaded once. What is
/// missing is drawn as Unity draws it, magenta or not at all, and becomes a note.
class UnityMaterials
{
public:
    UnityMaterials(UnityDatabase& database, AssetContext& assets, UnityNotes& notes)
        : m_Database(database), m_Assets(assets), m_Notes(notes)
    {
    }

    /// The prefab of a guid, which may be a model's; null where the project has none.
    std::shared_ptr<const UnityFile> LoadPrefab(const std::string& guid);
    /// Null, with a note at `user`, where there is none.
    /// @param mesh  not null
    std::shared_ptr<const Mesh> LoadMesh(const UnityTarget& mesh, const UnityReader& user);
    /// Never null. @param path  of the reference in `user`
    std::shared_ptr<const Material> Load(const UnityReference& material, const UnityReader& user,
                                         const std::string& path);

private:
    const Model* LoadModelOf(const std::string& guid);
    std::shared_ptr<const Mesh> LoadMesh(const UnityReference& mesh, const UnityReader& user);
    std::shared_ptr<const Mesh> LoadTextMesh(const std::filesystem::path& path, std::int64_t fileID,
                                             const UnityReader& user);
    std::shared_ptr<const Mesh> ReadMesh(const std::function<UnityNode()>& fields,
                                         const std::string& file);
    std::shared_ptr<const Material> Read(const UnityReference& material, const UnityReader& user,
                                         const std::string& path);
    std::shared_ptr<const Material> ReadFile(const std::filesystem::path& path);
    UnityShader FindShader(const UnityNode& fields, const std::string& material);
    UnityShader ReadGraph(const std::filesystem::path& path, const UnityNode& saved,
                          const std::string& material);
    std::shared_ptr<const Shader> FindByName(std::string_view name, const std::string& material);
    void SetValues(const UnityNode& fields, const std::string& file, const UnityShader& shader,
                   Material& material);
    void SetTextures(const UnityNode& list, const std::string& file, const UnityShader& shader,
                     Material& material);
    std::shared_ptr<const Material> Magenta();

    UnityDatabase& m_Database;
    AssetContext& m_Assets;
    UnityNotes& m_Notes;
    std::map<std::string, std::shared_ptr<const UnityFile>> m_Prefabs; ///< of models, by guid
    std::map<std::string, std::optional<Model>> m_Models;
    std::map<std::pair<std::string, std::int64_t>, std::shared_ptr<const Mesh>>
        m_TextMeshes; ///< by file and id
    std::map<std::pair<std::string, std::int64_t>, std::shared_ptr<const Material>> m_Materials;
    std::shared_ptr<const Material> m_Magenta;
};

} // namespace limn
