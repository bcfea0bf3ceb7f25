#include "keywords/DirectiveConditions.h"

#include "tokens/IntegerExpression.h"
#include <limn/base/Text.h>

namespace limn
{

namespace
{

std::string_view FirstWord(std::string_view text)
{
    text = Trim(text);
    std::size_t size = 0;
    while (size < text.size() && (isLetter(text[size]) || isDigit(text[size])))
    {
        ++size;
    }
    return text.substr(0, size);
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
        Open(isActive() && Evaluate(rest));
    }
    else if (directive == "ifdef" || directive == "ifndef")
    {
        const bool isDefined = m_Macros.find(FirstWord(rest)) != m_Macros.end();
        Open(isDefined == (directive == "ifdef"));
    }
    else if (directive == "elif")
    {
        Branch(!m_Levels.empty() && m_Levels.back().outerActive && !m_Levels.back().taken &&
               Evaluate(rest));
    }
    else if (directive == "else")
    {
        Branch(true);
    }
    else if (directive == "endif" && !m_Levels.empty())
    {
        m_Levels.pop_back();
    }
    else if (directive == "define" && isActive())
    {
        Define(rest);
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

void DirectiveConditions::Branch(bool condition)
{
    if (!m_Levels.empty())
    {
        Level& level = m_Levels.back();
        level.active = level.outerActive && !level.taken && condition;
        level.taken = level.taken || level.active;
    }
}

void DirectiveConditions::Define(std::string_view rest)
{
    const std::string_view name = FirstWord(rest);
    const std::string_view value = Trim(rest).substr(name.size());
    // A macro with arguments counts as defined; its value is of no use here.
    m_Macros[std::string(name)] = !value.empty() && value[0] == '(' ? "" : std::string(Trim(value));
}

bool DirectiveConditions::Evaluate(std::string_view expression) const
{
    return EvaluateInteger(expression, m_Macros) != 0;
}

} // namespace limn
