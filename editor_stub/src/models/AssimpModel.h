#pragma once

#include "assets/Importer.h"
#include "models/ModelFile.h"

namespace limn
{

/// A Model whose meshes are not made yet, in the form that is passed between processes and written
/// to a file.
struct ModelContent
{
    struct NamedMesh
    {
        std::string name;
        MeshData data;
        MeshSkin skin;
    };
    std::vector<ModelNode> nodes;
    std::vector<NamedMesh> meshes;
    std::vector<ModelMaterial> materials;
};

/// Reads .fbx, .obj and the other formats of assimp, in this process. assimp may crash on a broken
/// file.
/// @param name  the root's name
/// @param bytes  the file's content, from which an FBX is read; other kinds are read from the path
/// @throws AssetError  with one sentence, if the file cannot be read
ModelContent ReadByAssimp(const std::filesystem::path& path, std::string_view bytes,
                          const std::string& name, const ModelImport& import);

/// Finds a function of assimp, the library that reads models.
/// @throws AssetError  that no model can be read, if the library is not there or lacks the function
const void* FindInAssimp(const std::filesystem::path& library, const char* function);

} // namespace limn
