#include <limn/core/Resources.h>

#include "material/SourceOfThread.h"

#include <limn/core/Debug.h>

namespace limn
{

namespace
{

template <typename Asset>
std::shared_ptr<Asset> OrWarn(std::shared_ptr<Asset> asset, std::string_view path, const char* kind)
{
    if (!asset)
    {
        Debug::LogWarning("Resources.Load('" + std::string(path) +
                          "'): no folder Resources of the "
                          "project that is drawn has a " +
                          kind + " of this name");
    }
    return asset;
}

} // namespace

std::shared_ptr<const Shader> Resources::LoadShader(std::string_view path)
{
    return OrWarn(Find(path, &ResourceFolders::FindShader), path, "shader");
}

std::shared_ptr<const Texture> Resources::LoadTexture(std::string_view path)
{
    return OrWarn(Find(path, &ResourceFolders::FindTexture), path, "texture");
}

std::shared_ptr<ComputeShader> Resources::LoadComputeShader(std::string_view path)
{
    return OrWarn(Find(path, &ResourceFolders::FindComputeShader), path, "compute shader");
}

template <typename Asset>
std::shared_ptr<Asset>
Resources::Find(std::string_view path,
                std::shared_ptr<Asset> (ResourceFolders::*find)(std::string_view))
{
    const std::shared_ptr<ShaderSource>& source = ShaderSourceOfThread();
    if (!source)
    {
        return nullptr;
    }
    const std::lock_guard lock(source->m_OthersMutex);
    return source->m_Resources ? (*source->m_Resources.*find)(path) : nullptr;
}

} // namespace limn
