#pragma once

#include <filesystem>
#include <functional>
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

/// The files that plug-ins are loaded from: their own files, where debuggers and profilers find
/// them, or copies, so that the files may be built anew meanwhile.
enum class PluginLoading
{
    File,
    Copy
};

/// Loads what scenes refer to, each thing once: two materials of one shader share it, and objects
/// of one mesh can be drawn as instances. Everything stays loaded as long as the context lives.
class AssetContext
{
public:
    /// @param options  the compiler's options. Its includeFolders are roots of references as well.
    ///     Its process imports models and pictures, so that a library that crashes on one costs
    ///     that one only; without a process it costs the program. Its cacheFolder keeps what they
    ///     become, up to four times its cacheLimit
    /// @param missingFeatures  returns the missingFeatures of `options`. It is called once, when a
    ///     shader is asked for first, so that a device can be made while other files are read; who
    ///     asks for a shader gets what it throws. Null = `options` has them
    explicit AssetContext(ShaderCompilerOptions options = {},
                          PluginLoading pluginLoading = PluginLoading::File,
                          std::function<std::vector<std::string>()> missingFeatures = nullptr);
    ~AssetContext();
    AssetContext(const AssetContext&) = delete;
    AssetContext& operator=(const AssetContext&) = delete;

    /// Adds the features, volume components and shaders of a shared module, once; see
    /// <limn/features/Plugin.h>. Must be called before scenes and profiles that name them are
    /// loaded.
    /// @throws AssetError if it is no plug-in for this limn, or if one of its names is taken
    void LoadPlugin(const std::filesystem::path& path);
    /// Loads the plug-ins that another context has, as LoadPlugin does.
    void LoadPluginsOf(const AssetContext& other);
    /// Reads a plug-in's file again, for contexts that load it from now on. This context keeps what
    /// it has, and the older code stays loaded for it.
    /// @return true if the file is a plug-in of this context; else nothing is done
    /// @throws AssetError if the file cannot be used; contexts then go on with what they had
    bool ReloadPlugin(const std::filesystem::path& path);

    /// Returns the shader of this name that comes with limn or a plug-in, or null if there is none.
    std::shared_ptr<const Shader> FindShader(std::string_view name)
    {
        return shaderSource()->Find(name);
    }
    /// Returns the source in which Shader::Find of features looks: shaders that come with limn or a
    /// plug-in, and those that were loaded from files.
    const std::shared_ptr<ShaderSource>& shaderSource() const
    {
        MakeCompiler();
        return m_ShaderSource;
    }
    /// Loads a .shader file. The shaders that its UsePass and Fallback name are looked for in the
    /// files of its folder and below, or of the Assets folder of the Unity project it lies in, and
    /// among limn's own.
    /// @throws AssetError as Shader::Load
    std::shared_ptr<const Shader> LoadShader(const std::filesystem::path& path);

    std::shared_ptr<const Mesh> Primitive(PrimitiveType type);
    /// @throws AssetError as LoadGltfMesh
    std::shared_ptr<const Mesh> LoadMesh(const std::filesystem::path& path);
    /// Loads a picture (PNG, TIFF, JPEG, TGA, BMP, PSD, OpenEXR, Radiance HDR), upright on a mesh.
    /// Its colours are sRGB, and it has mip maps, unless Unity's .meta file beside it says
    /// otherwise. That file also gives its size, channels, filter, wrap modes and anisotropy.
    /// @throws AssetError if the file is none of these, if the .meta file has wrong values, or if a
    ///     link leads to a .meta file outside of the roots in which the texture lies
    std::shared_ptr<const Texture2D> LoadTexture(const std::filesystem::path& path);
    /// Loads a picture that its .meta file makes a cube: of six faces in a cross or a strip, or of
    /// longitude and latitude.
    /// @return null if the .meta file makes it none
    /// @throws AssetError as LoadTexture
    std::shared_ptr<const Cubemap> LoadCubemap(const std::filesystem::path& path);
    /// Loads a .material.yaml file, which holds what a scene writes for one of its materials.
    /// @throws AssetError with every problem of the file
    std::shared_ptr<const Material> LoadMaterial(const std::filesystem::path& path);
    /// Loads a profile with the textures and materials that it refers to.
    /// @param layers  the names of the scene's layers; a profile that was loaded with other names
    ///     is loaded anew
    /// @throws AssetError as LoadVolumeProfile
    const VolumeProfileLoadResult& LoadProfile(const std::filesystem::path& path,
                                               const LayerNames& layers = {});

    /// Returns the folders that references of files may lead into. References that lead elsewhere,
    /// even by a link, are refused; paths that a program or a person gives are not checked.
    const FileRoots& roots() const { return m_Roots; }
    /// Makes roots of the folder of a file that a person named and of the Unity project it is in.
    /// The file is the one that all others are loaded for.
    void AddRootsAround(const std::filesystem::path& file);

    /// Adds the roots around a file while that file is loaded, if it lies in no root. Such a file
    /// was named by a person or a program; no other file may use the roots around it.
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

    /// Adds a file that the caller reads itself to reachedFiles().
    void Reach(const std::filesystem::path& path) { m_Reached.insert(path.lexically_normal()); }
    /// Returns the normal paths of all files asked for so far, found or not, with the buffers of
    /// meshes and the files that shaders include.
    std::set<std::filesystem::path> reachedFiles() const;

    /// Reads a loaded profile again, into the object that everybody shares. Returns null, and reads
    /// nothing, if the profile is not loaded, or if a link that leads out of the roots took its
    /// place.
    /// @throws AssetError as LoadVolumeProfile; the profile then stays as it was
    const VolumeProfileLoadResult* ReloadProfile(const std::filesystem::path& path);
    /// Drops what was loaded from a file, so that it is read again when it is next asked for. For
    /// an include it drops all shaders, for a buffer of a .gltf file its meshes. Owners of the old
    /// asset keep it.
    void Forget(const std::filesystem::path& path);

    const std::shared_ptr<ShaderCompiler>& compiler() const
    {
        MakeCompiler();
        return m_Compiler;
    }
    const Importer& importer() const { return *m_Importer; }
    /// Returns all features that come with limn. A program adds its own to them before it loads
    /// scenes.
    FeatureRegistry& features() { return m_Features; }
    const FeatureRegistry& features() const { return m_Features; }
    /// Returns all volume components that come with limn. A program adds its own to them before it
    /// loads profiles.
    VolumeComponentRegistry& volumeComponents() { return m_VolumeComponents; }
    const VolumeComponentRegistry& volumeComponents() const { return m_VolumeComponents; }

private:
    struct Profile
    {
        VolumeProfileLoadResult result;
        LayerNames layers;          ///< the layer names that it was loaded with
        bool hasReferences = false; ///< true if it refers to other assets
        bool isInside = false;      ///< true if it lay in the roots when it was loaded
    };

    /// Makes what shaders need, the first time.
    void MakeCompiler() const;
    std::shared_ptr<const Shader> ReadShader(const std::filesystem::path& path);
    const ShaderDatabase& DatabaseAround(const std::filesystem::path& shaderFile);
    Profile ReadProfile(const std::filesystem::path& path, const LayerNames& layers);
    /// Makes a picture and its .meta file files that the scene needs.
    /// @return the path as the maps below have it
    std::filesystem::path ReachPicture(const std::filesystem::path& path);
    template <typename Imported>
    std::shared_ptr<const Imported> ReadTexture(
        const std::filesystem::path& path,
        std::shared_ptr<const Imported> (*import)(const std::filesystem::path&, const Importer&));

    FileRoots m_Roots;
    ShaderCompilerOptions m_CompilerOptions;
    std::function<std::vector<std::string>()> m_MissingFeatures;
    mutable std::shared_ptr<ShaderCompiler> m_Compiler; ///< null until the first shader
    std::shared_ptr<const Importer> m_Importer;
    FeatureRegistry m_Features;
    VolumeComponentRegistry m_VolumeComponents;
    /// Finds shipped shaders and those that were loaded; null until the first shader.
    mutable std::shared_ptr<ShaderSource> m_ShaderSource;
    std::map<PrimitiveType, std::shared_ptr<const Mesh>> m_Primitives;
    // The keys of these maps are normal paths.
    std::map<std::filesystem::path, std::shared_ptr<const Shader>> m_Shaders;
    std::map<std::filesystem::path, ShaderDatabase> m_Databases; ///< by folder
    std::map<std::filesystem::path, std::shared_ptr<const Mesh>> m_Meshes;
    std::map<std::filesystem::path, std::set<std::filesystem::path>> m_MeshesOfBuffers;
    std::map<std::filesystem::path, std::shared_ptr<const Texture2D>> m_Textures;
    std::map<std::filesystem::path, std::shared_ptr<const Cubemap>> m_Cubemaps;
    /// The bytes of textures, by the headers of their files.
    std::map<std::filesystem::path, std::uintmax_t> m_TexelBytes;
    std::map<std::filesystem::path, std::shared_ptr<const Material>> m_Materials;
    std::map<std::filesystem::path, Profile> m_Profiles;
    std::set<std::filesystem::path> m_Reached;
    PluginLoading m_PluginLoading;
    std::set<std::filesystem::path> m_PluginFiles; ///< the files that were asked for, loaded or not
    std::set<std::filesystem::path> m_Plugins;     ///< canonical
};

} // namespace limn
