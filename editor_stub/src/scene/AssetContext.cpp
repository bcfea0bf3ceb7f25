#include <limn/editor_stub/AssetContext.h>

#include "assets/Importer.h"
#include "assets/References.h"
#include "plugins/LoadPlugin.h"
#include "scene/Loader.h"
#include "scene/ProfileContext.h"
#include "shaders/ShaderFolders.h"
#include "unity/TextureImporter.h"
#include "unity/UnityProject.h"

#include <algorithm>
#include <limn/core/Image.h>
#include <limn/editor_stub/GltfMesh.h>
#include <limn/features/Features.h>
#include <limn/shaderlab/ResolveShader.h>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn
{

namespace
{

/// The value of `key`, made by `load` when it is asked for first; nothing is kept if that throws.
template <typename Map, typename Key, typename Load>
typename Map::mapped_type& Cached(Map& map, const Key& key, Load&& load)
{
    const auto found = map.find(key);
    return found != map.end() ? found->second
                              : map.emplace(typename Map::key_type(key), load()).first->second;
}

/// Returns whether a shader has all its passes without other shaders.
bool isSelfContained(const ShaderLabDocument& document)
{
    try
    {
        const ResolvedShader resolved = ResolveShader(document, nullptr);
        const std::vector<ShaderLabPass>& passes = resolved.subShader.passes;
        const auto isThere = [&](std::string_view lightMode)
        {
            return std::ranges::any_of(passes, [&](const ShaderLabPass& pass)
                                       { return pass.lightMode() == lightMode; });
        };
        return resolved.errors.empty() &&
               (document.fallback.empty() || std::ranges::all_of(k_FallbackLightModes, isThere));
    }
    catch (const AssetError&)
    {
        return document.fallback.empty();
    }
}

/// Returns whether a pass of the shader stands in this file.
bool isFrom(const Shader& shader, const std::filesystem::path& file)
{
    const std::vector<ShaderLabPass>& passes = shader.subShader().passes;
    return std::ranges::any_of(passes, [&](const ShaderLabPass& pass)
                               { return pass.program && pass.program->file == file; });
}

} // namespace

AssetContext::AssetContext(ShaderCompilerOptions options, PluginLoading pluginLoading,
                           std::function<std::vector<std::string>()> missingFeatures)
    : m_MissingFeatures(std::move(missingFeatures)), m_PluginLoading(pluginLoading)
{
    for (const std::filesystem::path& folder : options.includeFolders)
    {
        m_Roots.Add(folder);
    }
    Importer::Options import;
    import.process = options.process;
    import.cacheFolder = options.cacheFolder;
    import.cacheLimit = 4 * options.cacheLimit;
    m_Importer = std::make_shared<const Importer>(std::move(import));
    m_CompilerOptions = std::move(options);
    RegisterFeatures(m_Features, m_VolumeComponents);
    if (!m_MissingFeatures)
    {
        MakeCompiler(); // wrong options are the caller's fault at once
    }
}

AssetContext::~AssetContext()
{
    if (m_ShaderSource) // which a renderer may keep
    {
        m_ShaderSource->SetOthers(nullptr);
        m_ShaderSource->SetResources(nullptr);
    }
}

void AssetContext::MakeCompiler() const
{
    if (m_Compiler)
    {
        return;
    }
    ShaderCompilerOptions options = m_CompilerOptions;
    if (m_MissingFeatures)
    {
        options.missingFeatures = m_MissingFeatures();
    }
    m_Compiler = std::make_shared<ShaderCompiler>(std::move(options));
    m_ShaderSource = std::make_shared<ShaderSource>(&ShippedShaders, m_Compiler);
}

void AssetContext::AddRootsAround(const std::filesystem::path& file)
{
    m_Roots.Add(file.parent_path());
    const std::filesystem::path project = UnityProjectAround(file);
    if (!project.empty())
    {
        m_Roots.Add(project);
    }
}

AssetContext::RootsFor::RootsFor(AssetContext& assets, const std::filesystem::path& file)
    : m_Assets(assets), m_Before(assets.m_Roots)
{
    if (!m_Before.Contains(file))
    {
        m_Assets.AddRootsAround(file);
    }
}

AssetContext::RootsFor::~RootsFor()
{
    std::swap(m_Assets.m_Roots, m_Before);
}

void AssetContext::LoadPlugin(const std::filesystem::path& path)
{
    Reach(path);
    m_PluginFiles.insert(path.lexically_normal());
    std::error_code ignored; // LoadPlugin says what is wrong
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ignored);
    if (m_Plugins.count(canonical) == 0)
    {
        limn::LoadPlugin(path, m_Features, m_VolumeComponents, m_PluginLoading);
        m_Plugins.insert(canonical);
        if (m_ShaderSource)
        {
            m_ShaderSource->Clear(); // where a name may stand for none
        }
    }
}

void AssetContext::LoadPluginsOf(const AssetContext& other)
{
    for (const std::filesystem::path& path : other.m_PluginFiles)
    {
        LoadPlugin(path);
    }
}

bool AssetContext::ReloadPlugin(const std::filesystem::path& path)
{
    const bool isPlugin = m_PluginFiles.count(path.lexically_normal()) > 0;
    if (isPlugin)
    {
        limn::ReloadPlugin(path);
    }
    return isPlugin;
}

std::shared_ptr<const Shader> AssetContext::LoadShader(const std::filesystem::path& path)
{
    Reach(path);
    const std::shared_ptr<const Shader>& shader = Cached(
        m_Shaders, path.lexically_normal(), [&] { return ReadShader(path.lexically_normal()); });
    shaderSource()->Add(shader);
    return shader;
}

const ShaderDatabase& AssetContext::DatabaseAround(const std::filesystem::path& shaderFile)
{
    const std::filesystem::path folder = FolderOfShaders(shaderFile);
    return Cached(m_Databases, folder, [&] { return FindShaders({folder}); });
}

std::shared_ptr<const Shader> AssetContext::ReadShader(const std::filesystem::path& path)
{
    ShaderLabDocument document = LoadShaderLab(path);
    // Searching a folder takes its time: only for a shader that cannot do without.
    if (isSelfContained(document))
    {
        return std::make_shared<const Shader>(std::move(document), compiler());
    }
    auto shader =
        std::make_shared<const Shader>(std::move(document), compiler(), &DatabaseAround(path));
    for (const ShaderLabPass& pass : shader->subShader().passes)
    {
        Reach(pass.program ? std::filesystem::path(pass.program->file) : path);
    }
    return shader;
}

std::shared_ptr<const Mesh> AssetContext::Primitive(PrimitiveType type)
{
    return Cached(m_Primitives, type, [&] { return CreatePrimitive(type); });
}

std::shared_ptr<const Mesh> AssetContext::LoadMesh(const std::filesystem::path& path)
{
    Reach(path);
    const std::filesystem::path normal = path.lexically_normal();
    const auto load = [&]
    {
        return LoadGltfMesh(normal, m_Roots,
                            [&](const std::filesystem::path& buffer)
                            {
                                Reach(buffer);
                                m_MeshesOfBuffers[buffer].insert(normal);
                            });
    };
    return Cached(m_Meshes, normal, load);
}

std::filesystem::path AssetContext::ReachPicture(const std::filesystem::path& path)
{
    Reach(path);
    const std::filesystem::path metaFile = MetaFileOf(path);
    Reach(metaFile);
    if (m_Roots.Contains(path) && !m_Roots.Contains(metaFile))
    {
        throw AssetError(metaFile.generic_string(), {}, k_OutsideRoots);
    }
    return path.lexically_normal();
}

std::shared_ptr<const Texture2D> AssetContext::LoadTexture(const std::filesystem::path& path)
{
    const std::filesystem::path normal = ReachPicture(path);
    return Cached(m_Textures, normal, [&] { return ReadTexture(normal, ImportTexture); });
}

std::shared_ptr<const Cubemap> AssetContext::LoadCubemap(const std::filesystem::path& path)
{
    const std::filesystem::path normal = ReachPicture(path);
    return Cached(m_Cubemaps, normal, [&] { return ReadTexture(normal, ImportCubemap); });
}

/// Refuses the picture that is too much, a PNG before it decodes it: small files may hold
/// gigabytes.
template <typename Imported>
std::shared_ptr<const Imported> AssetContext::ReadTexture(
    const std::filesystem::path& path,
    std::shared_ptr<const Imported> (*import)(const std::filesystem::path&, const Importer&))
{
    constexpr std::uintmax_t k_Most = std::uintmax_t{4} << 30;
    const auto count = [&](std::uintmax_t own)
    {
        std::uintmax_t bytes = own;
        m_TexelBytes.erase(path);
        for (const auto& [unused, size] : m_TexelBytes)
        {
            bytes += size;
        }
        m_TexelBytes[path] = own;
        if (bytes > k_Most)
        {
            throw AssetError(path.generic_string(), {},
                             "its texels take " + std::to_string(own >> 20) +
                                 " MiB, and all pictures together take " +
                                 std::to_string(bytes >> 20) + " MiB; limn loads at most " +
                                 std::to_string(k_Most >> 20) + " MiB; use smaller ones");
        }
    };
    count(PngTexelBytes(path));
    std::shared_ptr<const Imported> texture = import(path, *m_Importer);
    count(texture ? texture->texels().size() : 0);
    return texture;
}

std::shared_ptr<const Material> AssetContext::LoadMaterial(const std::filesystem::path& path)
{
    Reach(path);
    return Cached(m_Materials, path.lexically_normal(),
                  [&] { return ReadMaterialFile(path.lexically_normal(), *this); });
}

AssetContext::Profile AssetContext::ReadProfile(const std::filesystem::path& path,
                                                const LayerNames& layers)
{
    const bool isInside = m_Roots.Contains(path);
    const RootsFor roots(*this, path);
    const SceneProfileContext context(*this, path, layers);
    VolumeProfileLoadResult result = LoadVolumeProfile(path, m_VolumeComponents, context);
    return {std::move(result), layers, context.hasLoaded(), isInside};
}

const VolumeProfileLoadResult& AssetContext::LoadProfile(const std::filesystem::path& path,
                                                         const LayerNames& layers)
{
    Reach(path);
    const std::filesystem::path normal = path.lexically_normal();
    const auto known = m_Profiles.find(normal);
    if (known != m_Profiles.end() && !(known->second.layers == layers))
    {
        m_Profiles.erase(known);
    }
    return Cached(m_Profiles, normal, [&] { return ReadProfile(normal, layers); }).result;
}

std::set<std::filesystem::path> AssetContext::reachedFiles() const
{
    std::set<std::filesystem::path> files;
    if (m_Compiler)
    {
        files = m_Compiler->includeFiles();
    }
    files.insert(m_Reached.begin(), m_Reached.end());
    return files;
}

const VolumeProfileLoadResult* AssetContext::ReloadProfile(const std::filesystem::path& path)
{
    const auto found = m_Profiles.find(path.lexically_normal());
    if (found == m_Profiles.end() || (found->second.isInside && !m_Roots.Contains(path)))
    {
        return nullptr;
    }
    Profile fresh = ReadProfile(found->first, found->second.layers);
    VolumeProfileLoadResult& result = found->second.result;
    *result.profile = std::move(*fresh.result.profile);
    result.notes = std::move(fresh.result.notes);
    found->second.hasReferences = fresh.hasReferences;
    return &result;
}

void AssetContext::Forget(const std::filesystem::path& path)
{
    const std::filesystem::path normal = path.lexically_normal();
    m_Shaders.erase(normal);
    std::erase_if(m_Shaders, [&](const auto& entry) { return isFrom(*entry.second, normal); });
    if (normal.extension() == ".shader")
    {
        m_Databases.clear();
    }
    m_Meshes.erase(normal);
    const bool isMeta = normal.extension() == ".meta";
    const std::filesystem::path picture = isMeta ? normal.parent_path() / normal.stem() : normal;
    m_Textures.erase(picture);
    m_Cubemaps.erase(picture);
    m_TexelBytes.erase(normal);
    m_Profiles.erase(normal);
    // Assets that refer to the file are quickly read again.
    m_Materials.clear();
    std::erase_if(m_Profiles, [](const auto& entry) { return entry.second.hasReferences; });
    for (const std::filesystem::path& mesh : m_MeshesOfBuffers[normal])
    {
        m_Meshes.erase(mesh);
    }
    if (m_Compiler && m_Compiler->includeFiles().count(normal) > 0)
    {
        m_Shaders.clear();
        m_ShaderSource->Clear();
    }
}

} // namespace limn
