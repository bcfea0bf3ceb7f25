#pragma once

#include <functional>
#include <limn/core/Shader.h>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace limn
{

class ResourceFolders;

/// The shaders that Shader::Find finds while code of a feature runs: those of a database, each made
/// once, and others that were added. Any thread may use it.
class ShaderSource
{
public:
    /// @param shaders   returns the database, which may grow
    /// @param compiler  compiles the shaders
    ShaderSource(const ShaderDatabase& (*shaders)(), std::shared_ptr<ShaderCompiler> compiler)
        : m_Shaders(shaders), m_Compiler(std::move(compiler))
    {
    }

    /// Returns the shader of this name, or null if there is none.
    /// @throws AssetError as the constructor of Shader
    std::shared_ptr<const Shader> Find(std::string_view name);
    /// Adds a shader from elsewhere, which is found if the database has none of its name.
    void Add(const std::shared_ptr<const Shader>& shader);
    /// Sets who looks for a shader that is neither in the database nor added: in a project. One
    /// thread at a time calls it. It returns null if there is none.
    using Others = std::function<std::shared_ptr<const Shader>(std::string_view name)>;
    void SetOthers(Others others);
    /// Sets where Resources::Load looks; null = nowhere. One thread at a time uses them.
    void SetResources(std::shared_ptr<ResourceFolders> folders);
    /// Makes all shaders anew when they are next needed, and forgets those that were added.
    void Clear();
    /// Returns a text such as "'Toom'; did you mean 'Toon'?".
    std::string UnknownShader(std::string_view name) const;

private:
    friend class Resources;

    std::shared_ptr<const Shader> FindKnown(std::string_view name);
    using Shaders = std::map<std::string, std::shared_ptr<const Shader>, std::less<>>;

    const ShaderDatabase& (*m_Shaders)();
    std::shared_ptr<ShaderCompiler> m_Compiler;
    mutable std::mutex m_Mutex; ///< guards those two
    Shaders m_Made;             ///< null: the database has none
    Shaders m_Added;
    std::mutex m_OthersMutex; ///< guards the next ones
    Others m_Others;
    std::shared_ptr<ResourceFolders> m_Resources;
};

/// Makes Shader::Find of this thread look in a source as long as the scope lives.
class ShaderSourceScope
{
public:
    /// @param source  null = nowhere
    explicit ShaderSourceScope(std::shared_ptr<ShaderSource> source);
    ~ShaderSourceScope();
    ShaderSourceScope(const ShaderSourceScope&) = delete;
    ShaderSourceScope& operator=(const ShaderSourceScope&) = delete;

private:
    std::shared_ptr<ShaderSource> m_Before;
};

} // namespace limn
