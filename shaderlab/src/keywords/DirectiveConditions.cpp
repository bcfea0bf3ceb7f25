#include "keywords/DirectiveConditions.h"

#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

std::string_view FirstWord(std::string_view text)
{
    return Beginning(Trim(text), isNameCharacter);
}

} // namespace

DirectiveConditions::DirectiveConditions()
    : m_Macros(std::begin(k_PredefinedMacros), std::end(k_PredefinedMacros))
{
}

void DirectiveConditions::Apply(std::string_view directive, std::string_view rest)
{
    if (directive == "if")
    {
        Open(isActive() && EvaluateInteger(rest, m_Macros) != 0);
    }
    else if (directive == "ifdef" || directive == "ifndef")
    {
        const bool isDefined = m_Macros.find(FirstWord(rest)) != m_Macros.end();
        Open(isDefined == (directive == "ifdef"));
    }
    else if ((directive == "elif" || directive == "else") && !m_Levels.empty())
    {
        Level& level = m_Levels.back();
        level.active = level.outerActive && !level.taken &&
                       (directive == "else" || EvaluateInteger(rest, m_Macros) != 0);
        level.taken = level.taken || level.active;
    }
    else if (directive == "endif" && !m_Levels.empty())
    {
        m_Levels.pop_back();
    }
    else if (directive == "define" && isActive())
    {
        const std::string_view name = FirstWord(rest);
        const std::string_view value = Trim(rest).substr(name.size());
        // A macro with arguments counts as defined; its value is of no use here.
        m_Macros[std::string(name)] = value.starts_with('(') ? "" : std::string(Trim(value));
    }
    else if (directive == "undef" && isActive())
    {
        m_Macros.erase(std::string(FirstWord(rest)));
    }
}

void DirectiveConditions::Open(bool condition)
{
    const bool active = isActive() && condition;
    m_Levels.push_back({isActive(), active, active});
}

std::string_view PassMacro(std::string_view lightMode)
{
    static constexpr std::pair<std::string_view, std::string_view> k_Macros[] = {
        {"ForwardBase", "UNITY_PASS_FORWARDBASE"},
        {"ForwardAdd", "UNITY_PASS_FORWARDADD"},
        {"Deferred", "UNITY_PASS_DEFERRED"},
        {"PrepassBase", "UNITY_PASS_PREPASSBASE"},
        {"PrepassFinal", "UNITY_PASS_PREPASSFINAL"},
        {"ShadowCaster", "UNITY_PASS_SHADOWCASTER"},
        {"Meta", "UNITY_PASS_META"},
        {"MotionVectors", "UNITY_PASS_MOTIONVECTORS"}};
    const auto* const found = std::ranges::find_if(
        k_Macros, [&](const auto& item) { return EqualsIgnoringCase(item.first, lightMode); });
    return found == std::end(k_Macros) ? std::string_view() : found->second;
}

} // namespace limn
