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

/// A material of the scene file, read once something names it.
struct SceneMaterial
{
    const YamlNode* node;
    bool isRead = false;
    std::shared_ptr<const Material> material; ///< null where its description is wrong
};

/// What the readers of a scene file's parts share.
struct SceneLoader
{
    AssetDiagnostics& diagnostics;
    References& references;
    SceneAsset& asset;
    InactiveObjects inactive = InactiveObjects::Load;
    std::map<std::string, SceneMaterial, std::less<>> materials = {};
    /// The material of objects without one; made when needed.
    std::shared_ptr<const Material> defaultMaterial = nullptr;
    /// By the id of the mesh that they were baked for: objects of one mesh go on sharing one.
    std::map<std::uint64_t, std::shared_ptr<const Mesh>> outlineMeshes = {};

    LayerKind layers() const { return {asset.layers, "layer"}; }
    LayerKind renderingLayers() const { return {asset.renderingLayers, "rendering layer"}; }
    void AddNotes(const std::vector<Diagnostic>& notes); ///< those that are not there yet
};

void ReadCamera(const YamlNode& node, SceneLoader& loader);
void ReadLight(const YamlNode& node, SceneLoader& loader);
void ReadLights(const YamlNode& node, SceneLoader& loader);
void ReadRenderer(const YamlNode& node, SceneLoader& loader); ///< needs layers and materials
void ReadVolumes(const YamlNode& node, SceneLoader& loader);
/// Finds the materials; each is read by whoever names it first.
void ReadMaterials(const YamlNode& node, SceneLoader& loader);
/// Reads the materials that nothing has named, for their errors; their pictures are not decoded.
void CheckUnusedMaterials(SceneLoader& loader);
/// Finds one of the scene's materials by name, read or not; null, with an error, if there is none.
SceneMaterial* FindMaterial(const YamlNode& node, const std::string& subject, SceneLoader& loader);
/// One of the scene's materials by name; null, with an error, if there is none or it is wrong.
std::shared_ptr<const Material> ReadMaterialName(const YamlNode& node, const std::string& subject,
                                                 SceneLoader& loader);
/// Needs the layers and the materials.
void ReadObjects(const YamlNode& node, SceneLoader& loader);

/// A built-in mesh by name, or one from a glTF file; null, with an error, if there is none.
std::shared_ptr<const Mesh> ReadMesh(const YamlNode& node, const std::string& subject,
                                     SceneLoader& loader);
/// Looks for the errors of a mesh that nobody draws: a file that is there is not read.
void CheckMesh(const YamlNode& node, const std::string& subject, SceneLoader& loader);

/// An item of a sequence, and what messages call it: "objects[2]".
struct SceneItem
{
    const YamlNode& node;
    std::string place;
};
/// The items of a sequence; an error if the node is something else, Null apart.
std::vector<SceneItem> ReadItems(const YamlNode& node, const std::string& subject,
                                 AssetDiagnostics& diagnostics);

/// `position`, `rotation` (Euler degrees) and `scale` (three numbers or one).
void ReadTransform(SceneMapReader& map, Transform& transform, AssetDiagnostics& diagnostics);

/// A material as scenes and material files write it, {shader: ..., _BaseColor: ...}. Null, with an
/// error, if the shader cannot be used: which properties there are is then unknown.
std::shared_ptr<const Material> ReadMaterial(const std::string& name, const YamlNode& node,
                                             References& references, AssetDiagnostics& diagnostics);

/// The material of a .material.yaml file; relative paths in it start at its folder.
/// @throws AssetError with every problem of the file
std::shared_ptr<const Material> ReadMaterialFile(const std::filesystem::path& path,
                                                 AssetContext& assets);

/// Sets a material's texture property to what a file says: the name of a default texture; for a 2D
/// property a .png file; for a 3D one or an array {slices: [.png files]}; for a cube or an array of
/// cubes {faces: [.png files]}, six a cube in the order +X -X +Y -Y +Z -Z, each as one sees it from
/// the centre. What is wrong is an error at its place, and the property stays as it was.
void ReadTextureProperty(const ShaderProperty& property, const YamlNode& node,
                         const std::string& subject, Material& material, References& references,
                         AssetDiagnostics& diagnostics);

} // namespace limn
