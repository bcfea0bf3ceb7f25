#pragma once

#include "assets/References.h"
#include "settings/MapReader.h"
#include "settings/ReadValues.h"

#include <limn/core/Material.h>
#include <limn/editor_stub/SceneFile.h>
#include <map>

namespace limn
{

/// The shader of materials that name none.
inline constexpr const char* k_DefaultShader = "Limn/Half Lambert";

/// A material of the scene file. It is read when something names it.
struct SceneMaterial
{
    const YamlNode* node;
    bool isRead = false;
    std::shared_ptr<const Material> material; ///< null if its description is wrong
};

/// The state that the readers of a scene file's parts share.
struct SceneLoader
{
    AssetDiagnostics& diagnostics;
    References& references;
    SceneAsset& asset;
    InactiveObjects inactive = InactiveObjects::Load;
    std::map<std::string, SceneMaterial, std::less<>> materials = {};
    /// The material of objects without one. It is made when needed.
    std::shared_ptr<const Material> defaultMaterial = nullptr;
    /// The baked meshes, by the id of the mesh that each was baked for: objects of one mesh go on
    /// sharing one.
    std::map<std::uint64_t, std::shared_ptr<const Mesh>> outlineMeshes = {};

    LayerKind layers() const { return {asset.layers, "layer"}; }
    LayerKind renderingLayers() const { return {asset.renderingLayers, "rendering layer"}; }
    void AddNotes(const std::vector<Diagnostic>& notes); ///< adds those that are not there yet
};

void ReadCamera(const YamlNode& node, SceneLoader& loader);
void ReadLight(const YamlNode& node, SceneLoader& loader);
void ReadLights(const YamlNode& node, SceneLoader& loader);
void ReadRenderer(const YamlNode& node, SceneLoader& loader); ///< needs layers and materials
void ReadVolumes(const YamlNode& node, SceneLoader& loader);
/// Finds the materials. Each is read when it is first named.
void ReadMaterials(const YamlNode& node, SceneLoader& loader);
/// Reads the materials that nothing has named, to find their errors. Their pictures are not
/// decoded.
void CheckUnusedMaterials(SceneLoader& loader);
/// Returns one of the scene's materials by name, read or not. Returns null and adds an error if
/// there is none.
SceneMaterial* FindMaterial(const YamlNode& node, const std::string& subject, SceneLoader& loader);
/// Returns one of the scene's materials by name. Returns null and adds an error if there is none or
/// it is wrong.
std::shared_ptr<const Material> ReadMaterialName(const YamlNode& node, const std::string& subject,
                                                 SceneLoader& loader);
/// Reads the objects. Layers and materials must have been read before.
void ReadObjects(const YamlNode& node, SceneLoader& loader);

/// Returns a built-in mesh by name, or one from a glTF file. Returns null and adds an error if
/// there is none.
std::shared_ptr<const Mesh> ReadMesh(const YamlNode& node, const std::string& subject,
                                     SceneLoader& loader);

/// An item of a sequence, and its name in messages: "objects[2]".
struct SceneItem
{
    const YamlNode& node;
    std::string place;
};
/// Returns the items of a sequence. Adds an error if the node is something else; Null is allowed.
std::vector<SceneItem> ReadItems(const YamlNode& node, const std::string& subject,
                                 AssetDiagnostics& diagnostics);

/// Returns the items of the sequence behind a key, as above; none if the key is absent.
std::vector<SceneItem> ReadItems(SceneMapReader& map, std::string_view key,
                                 AssetDiagnostics& diagnostics);

/// Reads a LayerMask or a RenderingLayerMask. It stays as it is if the key is absent or wrong.
template <typename Mask>
void ReadLayerMask(SceneMapReader& map, std::string_view key, const LayerKind& kind,
                   AssetDiagnostics& diagnostics, Mask& mask)
{
    if (const YamlNode* node = map.Find(key))
    {
        mask =
            Mask(ReadLayerBits(*node, map.SubjectOf(key), kind, diagnostics).value_or(mask.bits));
    }
}

/// Reads `position`, `rotation` (Euler degrees) and `scale` (three numbers or one).
void ReadTransform(SceneMapReader& map, Transform& transform, AssetDiagnostics& diagnostics);

/// Returns the material of a .material.yaml file. Relative paths in the file start at its folder.
/// @throws AssetError with every problem of the file
std::shared_ptr<const Material> ReadMaterialFile(const std::filesystem::path& path,
                                                 AssetContext& assets);

/// Loads a scene from a *.scene.yaml file, as LoadScene does.
/// @throws AssetError  as LoadScene does
SceneAsset LoadSceneFile(const std::filesystem::path& path, AssetContext& assets,
                         InactiveObjects inactive = InactiveObjects::Load);

} // namespace limn
