#pragma once

#include "assets/Importer.h"
#include "models/MeshSkin.h"
#include "unity/UnityObjects.h"

#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limn/core/Color.h>

namespace limn
{

/// The source of a model's tangents. Unity: UnityEditor.ModelImporterTangents (2022.3).
enum class ModelTangents : std::uint8_t
{
    Import, ///< from the file, if it has them
    CalculateLegacy,
    None,
    CalculateMikk,
    CalculateLegacyWithSplitTangents
};

/// Selects where a model's materials are. Unity: UnityEditor.ModelImporterMaterialLocation, and
/// ModelImporterMaterialImportMode.None.
enum class ModelMaterialLocation
{
    External, ///< in .mat files of the project, which are found by their names
    InPrefab, ///< in the model itself
    None      ///< nowhere: everything has Unity's default material
};

/// Selects the names of materials that are External.
/// Unity: UnityEditor.ModelImporterMaterialName.
enum class ModelMaterialName
{
    BasedOnTextureName, ///< of the base texture, or else of the model's material
    BasedOnMaterialName,
    BasedOnModelNameAndMaterialName,               ///< "Model-Material"
    BasedOnTextureName_Or_ModelNameAndMaterialName ///< the second where there is no texture
};

/// Selects the folders that materials are looked for in which are External.
/// Unity: UnityEditor.ModelImporterMaterialSearch.
enum class ModelMaterialSearch
{
    Local,       ///< the folder Materials beside the model
    RecursiveUp, ///< also those beside the folders around it
    Everywhere   ///< also the rest of the project
};

/// The settings by which Unity imports a model, from its .meta file.
/// Unity: UnityEditor.ModelImporter (2022.3).
struct ModelImport
{
    float globalScale = 1.0f;
    bool useFileScale = true; ///< lengths are multiplied by the file's unit
    /// If true, the vertices of an FBX file whose axes are not Unity's are turned; otherwise the
    /// nodes at the top are.
    bool bakesAxisConversion = false;
    bool preserveHierarchy = false; ///< a single top node stays below the root
    bool calculatesNormals = false;
    float normalSmoothAngle = 60.0f; ///< degrees
    /// The source of tangents. Calculated ones follow the rule of MikkTSpace.
    ModelTangents tangents = ModelTangents::CalculateMikk;
    bool swapUVChannels = false; ///< swaps the first and the second
    /// The names of the model's objects by id, for files of the first generation.
    std::map<std::int64_t, std::string> names = {};
    /// The project's materials that replace the model's own, by the names of the replaced ones.
    std::map<std::string, UnityReference> materials = {};
    ModelMaterialLocation materialLocation = ModelMaterialLocation::InPrefab;
    ModelMaterialName materialName = ModelMaterialName::BasedOnTextureName;
    ModelMaterialSearch materialSearch = ModelMaterialSearch::RecursiveUp;
};

/// Reads the ModelImporter of a .meta file. Settings that it lacks get Unity's defaults.
/// @param meta  the file's root
ModelImport ReadModelImport(const UnityNode& meta);

/// A node of a model, in metres along Unity's axes.
struct ModelNode
{
    std::string name;
    std::size_t parent = 0; ///< index into Model::nodes; the root is its own parent
    glm::vec3 position{0.0f};
    glm::quat rotation{1, 0, 0, 0};
    glm::vec3 scale{1.0f};
    std::optional<std::size_t> mesh;    ///< index into Model::meshes
    std::vector<std::string> materials; ///< names of materials, one for each sub-mesh
};

struct ModelMaterial
{
    std::string name;
    Color color = Color::white; ///< sRGB
    std::string texture;        ///< the file's name of the base texture without its ending, or ""
};

/// A model file as Unity imports it.
struct Model
{
    std::vector<ModelNode> nodes; ///< the first is the root
    std::vector<std::shared_ptr<const Mesh>> meshes;
    std::vector<MeshSkin> skins; ///< of each mesh
    std::vector<ModelMaterial> materials;
    ModelImport import;

    /// Returns the mesh that Unity has under an id, or null if there is none. Where Unity has split
    /// a mesh, because it has more vertices than 16 bits count, the first part is all of it.
    std::shared_ptr<const Mesh> FindMesh(std::int64_t fileID) const;
    /// Returns whether an id is that of another part of a mesh than the first.
    bool isLaterPart(std::int64_t fileID) const;
    /// Returns the material that Unity has under an id, or null if there is none.
    const ModelMaterial* FindMaterial(std::int64_t fileID) const;
};

/// Loads .fbx, .obj and the other formats of assimp.
/// @throws AssetError  with one sentence, if the file cannot be read
Model LoadModel(const std::filesystem::path& path, const ModelImport& import,
                const Importer& importer = Importer());

/// Returns the prefab that Unity makes of a model, for which an instance of the model in a scene
/// stands.
/// @param guid  the model's guid
std::string PrefabTextOf(const Model& model, const std::string& guid);

/// Returns the id that Unity gives to an object of a model since 2019.3.
/// @param text  "Type:Mesh->Sphere0"
std::int64_t HashedFileID(std::string_view text);

} // namespace limn
