#include "material/SourceOfThread.h"

#include <limn/core/Debug.h>
#include <utility>

namespace limn
{

std::shared_ptr<ShaderSource>& ShaderSourceOfThread()
{
    static thread_local std::shared_ptr<ShaderSource> source;
    return source;
}

std::shared_ptr<const Shader> ShaderSource::Find(std::string_view name)
{
    if (auto known = FindKnown(name))
    {
        return known;
    }
    const std::lock_guard lock(m_OthersMutex);
    return m_Others ? m_Others(name) : nullptr;
}

std::shared_ptr<const Shader> ShaderSource::FindKnown(std::string_view name)
{
    const std::lock_guard lock(m_Mutex);
    auto made = m_Made.find(name);
    if (made == m_Made.end())
    {
        made = m_Made.emplace(name, Shader::Find(name, m_Shaders(), m_Compiler)).first;
    }
    if (made->second)
    {
        return made->second;
    }
    const auto added = m_Added.find(name);
    return added == m_Added.end() ? nullptr : added->second;
}

void ShaderSource::SetOthers(Others others)
{
    const std::lock_guard lock(m_OthersMutex);
    m_Others = std::move(others);
}

void ShaderSource::SetResources(std::shared_ptr<ResourceFolders> folders)
{
    const std::lock_guard lock(m_OthersMutex);
    m_Resources = std::move(folders);
}

void ShaderSource::Add(const std::shared_ptr<const Shader>& shader)
{
    const std::lock_guard lock(m_Mutex);
    m_Added[shader->name()] = shader;
}

void ShaderSource::Clear()
{
    const std::lock_guard lock(m_Mutex);
    m_Made.clear();
    m_Added.clear();
}

std::string ShaderSource::UnknownShader(std::string_view name) const
{
    return m_Shaders().UnknownShader(name);
}

ShaderSourceScope::ShaderSourceScope(std::shared_ptr<ShaderSource> source)
    : m_Before(std::exchange(ShaderSourceOfThread(), std::move(source)))
{
}

ShaderSourceScope::~ShaderSourceScope()
{
    ShaderSourceOfThread() = std::move(m_Before);
}

std::shared_ptr<const Shader> Shader::Find(std::string_view name)
{
    const std::shared_ptr<ShaderSource>& source = ShaderSourceOfThread();
    if (!source)
    {
        Debug::LogWarning("Shader.Find('" + std::string(name) +
                          "'): no shaders are known here; call it in a feature's Create or while a "
                          "camera is rendered");
        return nullptr;
    }
    std::shared_ptr<const Shader> shader = source->Find(name);
    if (!shader)
    {
        Debug::LogWarning("Shader.Find: there is no shader " + source->UnknownShader(name));
    }
    return shader;
}

} // namespace limn
