#pragma once

#include <string>
#include <string_view>

namespace limn
{

class Shader;

/// A keyword of one shader. Unity: UnityEngine.Rendering.LocalKeyword (2022.3).
class LocalKeyword
{
public:
    /// @throws ContractError naming the shader's keywords, if it has no such one (Unity logs, and
    ///         the keyword does nothing)
    LocalKeyword(const Shader& shader, std::string_view name);

    const std::string& name() const { return m_Name; }

    bool operator==(const LocalKeyword&) const = default;

private:
    const Shader* m_Shader; ///< tells keywords apart, no more
    std::string m_Name;
};

} // namespace limn
