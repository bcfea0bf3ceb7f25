#pragma once

#include "models/ModelFile.h"
#include "shader_graph/GraphShader.h"
#include "unity/UnityDatabase.h"
#include "unity_scene/MaterialStandIn.h"
#include "unity_scene/UnityTextures.h"

namespace limn
{

/// The shader of a Unity material.
struct UnityShader
{
    std::shared_ptr<const Shader> shader;     ///< null if the material is magenta
    std::optional<MaterialStandIn> standIn{}; ///< set if it stands in for another shader
    /// The textures that a shader graph itself names.
    std::vector<GraphTexture> textures{};
};

/// The meshes, materials, textures and prefabs of a project's scene, each loaded once. Missing ones
/// are drawn as Unity draws them, magenta or not at all, and become notes.
class UnityMaterials
{
public:
    UnityMaterials(UnityDatabase& database, AssetContext& assets, UnityNotes& notes)
        : m_Database(database),
          m_Assets(assets),
          m_Notes(notes),
          m_Textures(database, assets, notes)
    {
    }

    /// Loads the prefab with a guid, which may be a model's. Returns null if the project has none.
    std::shared_ptr<const UnityFile> LoadPrefab(const std::string& guid);
    /// Loads a mesh. Returns null and adds a note at `user` if there is none.
    /// @param mesh  must not be null
    std::shared_ptr<const Mesh> LoadMesh(const UnityTarget& mesh, const UnityReader& user);
    /// Returns the bones of a mesh that LoadMesh returned, or null if limn knows none.
    const MeshSkin* FindSkin(const Mesh& mesh) const;
    /// Loads a material, of a file or of the scene itself. Never returns null: what is none is
    /// magenta, which a note at `user` says.
    /// @param path  the path of the reference in `user`
    std::shared_ptr<const Material> Load(const UnityTarget& material, const UnityReader& user,
                                         const std::string& path);
    /// Loads the material that a renderer feature draws with. Returns null and gives `note` the
    /// reason if there is none, or if limn draws magenta or another shader in its place: over the
    /// whole picture that would hide the scene.
    std::shared_ptr<const Material>
    LoadForFeature(const UnityReference& material,
                   const std::function<void(const std::string& reason)>& note);
    /// Loads the material of the sky. Returns null and adds a note at `user` if it does not exist.
    std::shared_ptr<const Material> LoadSkybox(const UnityReference& material,
                                               const UnityReader& user);
    /// Loads the cube that surfaces mirror in place of the sky. Returns null and adds a note at
    /// `user` if there is none that limn reads.
    std::shared_ptr<const Texture> LoadReflection(const UnityReference& cube,
                                                  const UnityReader& user);

    UnityTextures& textures() { return m_Textures; }

private:
    const Model* LoadModelOf(const std::string& guid);
    std::shared_ptr<const Mesh> LoadMesh(const UnityReference& mesh, const UnityReader& user);
    std::shared_ptr<const Mesh> LoadTextMesh(const std::filesystem::path& path, std::int64_t fileID,
                                             const UnityReader& user);
    std::shared_ptr<const Mesh> Unread(const std::filesystem::path& path, const UnityReader& user);
    SkinnableMesh ReadMesh(const std::function<UnityNode()>& fields, const std::string& file);
    std::shared_ptr<const Material> Load(const UnityReference& material, const UnityReader& user,
                                         const std::string& path);
    std::shared_ptr<const Material> Read(const UnityReference& material, const UnityReader& user,
                                         const std::string& path);
    std::shared_ptr<const Material> ReadFile(const std::filesystem::path& path,
                                             std::int64_t fileID);
    std::shared_ptr<const Material> Make(const UnityNode& fields, const std::string& file);
    UnityShader FindShader(const UnityNode& fields, const std::string& material);
    UnityShader LoadGraph(const std::filesystem::path& path, const UnityNode& saved,
                          const std::string& material);
    UnityShader ReadGraph(const std::filesystem::path& path);
    std::shared_ptr<const Shader> FindByName(std::string_view name, const std::string& material);
    void SetValues(const UnityNode& fields, const std::string& file, const UnityShader& shader,
                   Material& material);
    void SetTextures(const UnityNode& list, const std::string& file, const UnityShader& shader,
                     Material& material);
    /// Sets a texture of the project. Returns why it is not, or "".
    std::string SetTexture(const UnityReference& texture, const ShaderPropertyId& id,
                           Material& material);
    /// Returns the name of the graph that is a material file's shader and cannot be translated, or
    /// "" for any other shader.
    std::string StrangeGraphOf(const std::filesystem::path& material);
    std::shared_ptr<const Material> Magenta();

    UnityDatabase& m_Database;
    AssetContext& m_Assets;
    UnityNotes& m_Notes;
    UnityTextures m_Textures;
    /// The prefabs of models, by guid.
    std::map<std::string, std::shared_ptr<const UnityFile>> m_Prefabs;
    std::map<std::string, std::optional<Model>> m_Models;
    std::map<std::pair<std::string, std::int64_t>, SkinnableMesh> m_TextMeshes; ///< by file and id
    std::set<std::filesystem::path> m_UnreadMeshes; ///< those that a note is about
    std::map<UnityReference, std::shared_ptr<const Material>> m_Materials;
    std::map<std::filesystem::path, UnityShader> m_Graphs; ///< without a shader: not translated
    /// Those that stand in a scene or prefab itself, by file and id.
    std::map<std::pair<std::string, std::int64_t>, std::shared_ptr<const Material>> m_OwnMaterials;
    std::shared_ptr<const Material> m_Magenta;
};

} // namespace limn
