#pragma once

#include "assets/Importer.h"
#include "models/ModelFile.h"

namespace limn
{

/// A model as it goes from one process to another and into a file: a Model whose meshes are not
/// made yet.
struct ModelContent
{
    struct NamedMesh
    {
        std::string name;
        MeshData data;
    };
    std::vector<ModelNode> nodes;
    std::vector<NamedMesh> meshes;
    std::vector<ModelMaterial> materials;
};

/// Reads .fbx, .obj and whatever else assimp reads, in this process. assimp may crash on a broken
/// file.
/// @param name  of the root
/// @param bytes  of the file, which an FBX is read from; other kinds are read from the path
/// @throws AssetError  with one sentence, if it cannot be read
ModelContent ReadByAssimp(const std::filesystem::path& path, std::string_view bytes,
                          const std::string& name, const ModelImport& import);

} // namespace limn
