#pragma once

#include <limn/core/Shader.h>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace limn
{

/// Where Shader::Find looks while code of a feature runs: shaders of a database, each made once,
/// and others that are known. Any thread.
class ShaderSource
{
public:
    /// @param shaders   gives the database, which may grow
    /// @param compiler  of the shaders
    ShaderSource(const ShaderDatabase& (*shaders)(), std::shared_ptr<ShaderCompiler> compiler)
        : m_Shaders(shaders), m_Compiler(std::move(compiler))
    {
    }

    /// Null where there is none.
    /// @throws AssetError as the constructor of Shader
    std::shared_ptr<const Shader> Find(std::string_view name);
    /// Makes one known that comes from elsewhere, for those who find no other of its name.
    void Add(const std::shared_ptr<const Shader>& shader);
    /// Makes all anew when they are next asked for, and knows nothing that was added.
    void Clear();
    /// "'Toom'; did you mean 'Toon'?"
    std::string UnknownShader(std::string_view name) const;

private:
    using Shaders = std::map<std::string, std::shared_ptr<const Shader>, std::less<>>;

    const ShaderDatabase& (*m_Shaders)();
    std::shared_ptr<ShaderCompiler> m_Compiler;
    mutable std::mutex m_Mutex; ///< guards those two
    Shaders m_Made;             ///< null: the database has none
    Shaders m_Added;
};

/// Shader::Find of this thread looks there as long as it lives.
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
