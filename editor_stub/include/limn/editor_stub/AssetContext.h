#pragma once

#include <filesystem>
#include <limn/base/FileRoots.h>
#include <limn/core/Material.h>
#include <limn/core/Mesh.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/Shader.h>
#include <limn/core/ShaderSource.h>
#include <limn/core/Texture.h>
#include <limn/editor_stub/LayerNames.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/shaderlab/ShaderDatabase.h>
#include <limn/volume/VolumeProfileLoader.h>
#include <map>
#include <memory>
#include <set>
#include <string_view>

namespace limn
{

class Importer;

/// What plug-ins are loaded from: their files, where debuggers and profilers find them, or copies,
/// so that the files may be built anew meanwhile.
enum class PluginLoading
{
    File,
    Copy
};

/// Loads what scenes refer to, each thing once: two materials of one shader share it, and objects
/// of one mesh can be drawn as instances. Everything stays loaded as long as the context.
class AssetContext
{
public:
    /// @param options  its includeFolders are roots of references as well; its process imports
    ///     models and pictures, so that a library that crashes on one costs that one only (without
    ///     a process it costs the program), and its cacheFolder keeps what they become, up to four
    ///     times its cacheLimit
    explicit AssetContext(ShaderCompilerOptions options = {},
                          PluginLoading pluginLoading = PluginLoading::File);
    AssetContext(const AssetContext&) = delete;
    AssetContext& operator=(const AssetContext&) = delete;

    /// Adds the features, volume components and shaders of a shared module, once; see
    /// <limn/features/Plugin.h>. Before scenes and profiles that name them are loaded.
    /// @throws AssetError if it is no plug-in for this limn, or a name of it is taken
    void LoadPlugin(const std::filesystem::path& path);
    /// Loads the plug-ins that another context has, as LoadPlugin does.
    void LoadPluginsOf(const AssetContext& other);
    /// Reads a plug-in's file again, for contexts that load it from now on; this one keeps what it
    /// has, and the older code stays loaded for it.
    /// @return whether the file is a plug-in of this context; nothing is done if not
    /// @throws AssetError if it cannot be used; contexts then go on with what they had
    bool ReloadPlugin(const std::filesystem::path& path);

    /// A shader that comes with limn or a plug-in; null for any other name.
    std::shared_ptr<const Shader> FindShader(std::string_view name)
    {
        return m_ShaderSource->Find(name);
    }
    /// Where Shader::Find of features looks: shaders that come with limn or a plug-in, and those
    /// that were loaded from files.
    const std::shared_ptr<ShaderSource>& shaderSource() const { return m_ShaderSource; }
    /// A .shader file. What its UsePass and Fallback name is looked for in the files of its folder
    /// and below, or of the Unity project's Assets folder that it lies in, and among limn's own.
    /// @throws AssetError as Shader::Load
    std::shared_ptr<const Shader> LoadShader(const std::filesystem::path& path);

    std::shared_ptr<const Mesh> Primitive(PrimitiveType type);
    /// @throws AssetError as LoadGltfMesh
    std::shared_ptr<const Mesh> LoadMesh(const std::filesystem::path& path);
    /// A picture (PNG, TIFF, JPEG, TGA, BMP, PSD, OpenEXR, Radiance HDR), upright on a mesh, its
    /// colours sRGB and with mip maps unless Unity's .meta file beside it says otherwise; that
    /// one's size, channels, filter, wrap modes and anisotropy.
    /// @throws AssetError if the file is none of these, for wrong values of the .meta file, and for
    ///         one that a link has outside of the roots in which the texture lies
    std::shared_ptr<const Texture2D> LoadTexture(const std::filesystem::path& path);
    /// A .material.yaml file: what a scene writes for one of its materials.
    /// @throws AssetError with every problem of the file
    std::shared_ptr<const Material> LoadMaterial(const std::filesystem::path& path);
    /// A profile with the textures and materials it refers to.
    /// @param layers  of the scene; a profile loaded with other names is loaded anew
    /// @throws AssetError as LoadVolumeProfile
    const VolumeProfileLoadResult& LoadProfile(const std::filesystem::path& path,
                                               const LayerNames& layers = {});

    /// Folders that what files refer to may lie in. References that lead elsewhere, be it by a
    /// link, are refused; paths that a program or a person gives are not asked about.
    const FileRoots& roots() const { return m_Roots; }
    /// Makes a root of the folder of a file that a person named, and of the Unity project it is in:
    /// of the one file that all others are for.
    void AddRootsAround(const std::filesystem::path& file);

    /// The roots while one file is loaded: where it lies in none of them, it was named by a person
    /// or a program, and then has those around it for itself, and no other file has.
    class RootsFor
    {
    public:
        RootsFor(AssetContext& assets, const std::filesystem::path& file);
        ~RootsFor();
        RootsFor(const RootsFor&) = delete;
        RootsFor& operator=(const RootsFor&) = delete;

    private:
        AssetContext& m_Assets;
        FileRoots m_Before;
    };

    /// Adds a file to reachedFiles() that a caller reads itself.
    void Reach(const std::filesystem::path& path) { m_Reached.insert(path.lexically_normal()); }
    /// Every file asked for so far, found or not, the buffers of meshes and what shaders include;
    /// normal paths.
    std::set<std::filesystem::path> reachedFiles() const;

    /// Reads a loaded profile again, into the object that everybody shares; null, and nothing read,
    /// if it is not loaded, or a link took its place that leads out of the roots.
    /// @throws AssetError as LoadVolumeProfile; the profile then stays as it was
    const VolumeProfileLoadResult* ReloadProfile(const std::filesystem::path& path);
    /// Drops what was loaded from a file, so that it is read again when it is next asked for; for
    /// an include, all shaders; for a .gltf file's buffer, its meshes. Who owns the old asset keeps
    /// it.
    void Forget(const std::filesystem::path& path);

    const std::shared_ptr<ShaderCompiler>& compiler() const { return m_Compiler; }
    const Importer& importer() const { return *m_Importer; }
    /// All features that come with limn, to which a program adds its own before it loads scenes.
    FeatureRegistry& features() { return m_Features; }
    const FeatureRegistry& features() const { return m_Features; }
    /// All volume components that come with limn, to which a program adds its own before it loads
    /// profiles.
    VolumeComponentRegistry& volumeComponents() { return m_VolumeComponents; }
    const VolumeComponentRegistry& volumeComponents() const { return m_VolumeComponents; }

private:
    struct Profile
    {
        VolumeProfileLoadResult result;
        LayerNames layers;          ///< that its names of layers stand for
        bool hasReferences = false; ///< it holds other assets
        bool isInside = false;      ///< it lay in the roots when it was loaded
    };

    std::shared_ptr<const Shader> ReadShader(const std::filesystem::path& path);
    const ShaderDatabase& DatabaseAround(const std::filesystem::path& shaderFile);
    Profile ReadProfile(const std::filesystem::path& path, const LayerNames& layers);
    std::shared_ptr<const Texture2D> ReadTexture(const std::filesystem::path& path);

    FileRoots m_Roots;
    std::shared_ptr<ShaderCompiler> m_Compiler;
    std::shared_ptr<const Importer> m_Importer;
    FeatureRegistry m_Features;
    VolumeComponentRegistry m_VolumeComponents;
    std::shared_ptr<ShaderSource> m_ShaderSource; ///< of shipped ones and those that were loaded
    std::map<PrimitiveType, std::shared_ptr<const Mesh>> m_Primitives;
    // Files go by their normal path.
    std::map<std::filesystem::path, std::shared_ptr<const Shader>> m_Shaders;
    std::map<std::filesystem::path, ShaderDatabase> m_Databases; ///< by folder
    std::map<std::filesystem::path, std::shared_ptr<const Mesh>> m_Meshes;
    std::map<std::filesystem::path, std::set<std::filesystem::path>> m_MeshesOfBuffers;
    std::map<std::filesystem::path, std::shared_ptr<const Texture2D>> m_Textures;
    std::map<std::filesystem::path, std::uintmax_t> m_TexelBytes; ///< by their headers
    std::map<std::filesystem::path, std::shared_ptr<const Material>> m_Materials;
    std::map<std::filesystem::path, Profile> m_Profiles;
    std::set<std::filesystem::path> m_Reached;
    PluginLoading m_PluginLoading;
    std::set<std::filesystem::path> m_PluginFiles; ///< that were asked for, loaded or not
    std::set<std::filesystem::path> m_Plugins;     ///< canonical
};

} // namespace limn
