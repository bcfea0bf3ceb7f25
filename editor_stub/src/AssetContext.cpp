#include <limn/core/GltfMesh.h>
#include <limn/core/Image.h>
#include <limn/editor_stub/AssetContext.h>
#include <limn/features/Features.h>

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

std::shared_ptr<const Texture> ReadTexture(const std::filesystem::path& path)
{
    Image image = ReadPng(path);
    return std::make_shared<const Texture2D>(path.filename().string(), image.width, image.height,
                                             image.format, std::move(image.texels));
}

} // namespace

AssetContext::AssetContext(ShaderCompilerOptions options)
    : m_Compiler(std::make_shared<ShaderCompiler>(std::move(options)))
{
    RegisterVolumeComponents(m_VolumeComponents);
}

std::shared_ptr<const Shader> AssetContext::FindShader(std::string_view name)
{
    return Cached(m_ShippedShaders, name, [&] { return FindShippedShader(name, m_Compiler); });
}

std::shared_ptr<const Shader> AssetContext::LoadShader(const std::filesystem::path& path)
{
    Reach(path);
    return Cached(m_Shaders, path.lexically_normal(),
                  [&] { return Shader::Load(path.lexically_normal(), m_Compiler); });
}

std::shared_ptr<const Mesh> AssetContext::Primitive(PrimitiveType type)
{
    return Cached(m_Primitives, type, [&] { return CreatePrimitive(type); });
}

std::shared_ptr<const Mesh> AssetContext::LoadMesh(const std::filesystem::path& path)
{
    Reach(path);
    return Cached(m_Meshes, path.lexically_normal(),
                  [&] { return LoadGltfMesh(path.lexically_normal()); });
}

std::shared_ptr<const Texture> AssetContext::LoadTexture(const std::filesystem::path& path)
{
    Reach(path);
    return Cached(m_Textures, path.lexically_normal(),
                  [&] { return ReadTexture(path.lexically_normal()); });
}

const VolumeProfileLoadResult& AssetContext::LoadProfile(const std::filesystem::path& path)
{
    Reach(path);
    return Cached(m_Profiles, path.lexically_normal(),
                  [&] { return LoadVolumeProfile(path.lexically_normal(), m_VolumeComponents); });
}

std::set<std::filesystem::path> AssetContext::reachedFiles() const
{
    std::set<std::filesystem::path> files = m_Compiler->includeFiles();
    files.insert(m_Reached.begin(), m_Reached.end());
    return files;
}

const VolumeProfileLoadResult* AssetContext::ReloadProfile(const std::filesystem::path& path)
{
    const auto found = m_Profiles.find(path.lexically_normal());
    if (found == m_Profiles.end())
    {
        return nullptr;
    }
    VolumeProfileLoadResult fresh = LoadVolumeProfile(found->first, m_VolumeComponents);
    *found->second.profile = std::move(*fresh.profile);
    found->second.notes = std::move(fresh.notes);
    return &found->second;
}

void AssetContext::Forget(const std::filesystem::path& path)
{
    const std::filesystem::path normal = path.lexically_normal();
    m_Shaders.erase(normal);
    m_Meshes.erase(normal);
    m_Textures.erase(normal);
    m_Profiles.erase(normal);
    if (m_Compiler->includeFiles().count(normal) > 0)
    {
        m_Shaders.clear();
    }
}

} // namespace limn
