#pragma once

#include <limn/core/ShaderId.h>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

class Shader;

/// A keyword of one shader. Unity: UnityEngine.Rendering.LocalKeyword (2022.3).
class LocalKeyword
{
public:
    /// @throws ContractError naming the shader's keywords, if it does not have this one (Unity
    ///     logs, and the keyword has no effect)
    LocalKeyword(const Shader& shader, std::string_view name);

    const std::string& name() const { return m_Name; }

    bool operator==(const LocalKeyword&) const = default;

private:
    const Shader* m_Shader; ///< only tells keywords of different shaders apart
    std::string m_Name;
};

/// A keyword that a command buffer switches for all materials at once. A keyword set that a shader
/// declares with `_local` ignores it. Unity: UnityEngine.Rendering.GlobalKeyword (2022.3).
class GlobalKeyword
{
public:
    explicit GlobalKeyword(std::string_view name) : m_Id(std::string(k_Prefix).append(name)) {}
    static GlobalKeyword Create(std::string_view name) { return GlobalKeyword(name); }

    std::string_view name() const { return std::string_view(m_Id.name()).substr(k_Prefix.size()); }
    /// Returns the name under which a frame's globals keep 1 while it is on: no shader has a
    /// property of this name.
    ShaderPropertyId id() const { return m_Id; }

    /// Returns the keyword that is kept under this name; nothing for a property's name.
    static std::optional<GlobalKeyword> OfId(ShaderPropertyId id)
    {
        const std::string_view name = id.name();
        return name.starts_with(k_Prefix) ? std::optional(Create(name.substr(k_Prefix.size())))
                                          : std::nullopt;
    }

    bool operator==(const GlobalKeyword&) const = default;

private:
    static constexpr std::string_view k_Prefix = "keyword ";

    ShaderPropertyId m_Id;
};

} // namespace limn
