#pragma once

#include "tokens/IntegerExpression.h"

#include <string_view>
#include <utility>
#include <vector>

namespace limn
{

/// The macros that Unity's compiler defines for every program.
inline constexpr std::pair<std::string_view, std::string_view> k_PredefinedMacros[] = {
    {"SHADER_API_VULKAN", "1"},
    {"SHADER_API_DESKTOP", "1"},
    {"UNITY_COMPILER_HLSL", "1"},
    {"UNITY_VERSION", "202230"}};

/// The beginning of the macros that tell a program its kind of pass.
inline constexpr std::string_view k_PassMacroStart = "UNITY_PASS_";

/// Returns the macro that Unity's compiler defines for passes with a LightMode tag, or "" for tags
/// that render pipelines invent.
std::string_view PassMacro(std::string_view lightMode);

/// Evaluates `#define` and `#if` far enough to decide which pragmas count. Unity decides that by
/// the program's own macros and by those of the platform, before any keyword is set.
class DirectiveConditions
{
public:
    DirectiveConditions();

    bool isActive() const { return m_Levels.empty() || m_Levels.back().active; }

    /// Applies `#directive rest`; a directive that is neither a condition nor a definition has no
    /// effect.
    void Apply(std::string_view directive, std::string_view rest);

private:
    struct Level
    {
        bool outerActive;
        bool taken; ///< a branch of it was active already
        bool active;
    };

    void Open(bool condition);

    IntegerNames m_Macros; ///< the macros without arguments
    std::vector<Level> m_Levels;
};

} // namespace limn
