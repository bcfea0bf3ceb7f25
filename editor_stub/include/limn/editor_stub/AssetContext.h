#pragma once

#include <filesystem>
#include <limn/core/Mesh.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/Shader.h>
#include <limn/core/Texture.h>
#include <limn/volume/VolumeProfileLoader.h>
#include <map>
#include <memory>
#include <set>
#include <string_view>

namespace limn
{

/// Loads what scenes refer to, each thing once: two materials of one shader share it, and objects
/// of one mesh can be drawn as instances. Everything stays loaded as long as the context.
class AssetContext
{
public:
    explicit AssetContext(ShaderCompilerOptions options = {});
    AssetContext(const AssetContext&) = delete;
    AssetContext& operator=(const AssetContext&) = delete;

    /// A shader that comes with limn; null for any other name.
    std::shared_ptr<const Shader> FindShader(std::string_view name);
    /// @throws AssetError as Shader::Load
    std::shared_ptr<const Shader> LoadShader(const std::filesystem::path& path);

    std::shared_ptr<const Mesh> Primitive(PrimitiveType type);
    /// @throws AssetError as LoadGltfMesh
    std::shared_ptr<const Mesh> LoadMesh(const std::filesystem::path& path);
    /// A PNG file, its colours sRGB.
    /// @throws AssetError as ReadPng
    std::shared_ptr<const Texture> LoadTexture(const std::filesystem::path& path);
    /// @throws AssetError as LoadVolumeProfile
    const VolumeProfileLoadResult& LoadProfile(const std::filesystem::path& path);

    /// Adds a file to reachedFiles() that a caller reads itself.
    void Reach(const std::filesystem::path& path) { m_Reached.insert(path.lexically_normal()); }
    /// Every file asked for so far, found or not, and those that shaders include; normal paths.
    std::set<std::filesystem::path> reachedFiles() const;

    /// Reads a loaded profile again, into the object that everybody shares; null, and nothing read,
    /// if it is not loaded.
    /// @throws AssetError as LoadVolumeProfile; the profile then stays as it was
    const VolumeProfileLoadResult* ReloadProfile(const std::filesystem::path& path);
    /// Drops what was loaded from a file, so that it is read again when it is next asked for; for
    /// an include, all shaders that are files. Who owns the old asset keeps it.
    void Forget(const std::filesystem::path& path);

    const std::shared_ptr<ShaderCompiler>& compiler() const { return m_Compiler; }
    /// All volume components that come with limn.
    const VolumeComponentRegistry& volumeComponents() const { return m_VolumeComponents; }

private:
    std::shared_ptr<ShaderCompiler> m_Compiler;
    VolumeComponentRegistry m_VolumeComponents;
    std::map<std::string, std::shared_ptr<const Shader>, std::less<>> m_ShippedShaders;
    std::map<PrimitiveType, std::shared_ptr<const Mesh>> m_Primitives;
    // Files go by their normal path.
    std::map<std::filesystem::path, std::shared_ptr<const Shader>> m_Shaders;
    std::map<std::filesystem::path, std::shared_ptr<const Mesh>> m_Meshes;
    std::map<std::filesystem::path, std::shared_ptr<const Texture>> m_Textures;
    std::map<std::filesystem::path, VolumeProfileLoadResult> m_Profiles;
    std::set<std::filesystem::path> m_Reached;
};

} // namespace limn
