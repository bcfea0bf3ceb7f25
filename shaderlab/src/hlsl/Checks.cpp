#include "hlsl/Checks.h"

#include "hlsl/Repeats.h"
#include "text/Text.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace limn
{

namespace
{

Diagnostic ErrorAt(const HlslSource& source, std::size_t token, const std::string& message)
{
    const std::string_view text = source.tokens[token].text;
    const HlslPlace place = PlaceOf(source.text, source.tokens[token].Begin(source.text));
    return {Severity::Error, place.file, place.location, "'" + std::string(text) + "': " + message};
}

/// `f().method(`, as token indices of the method's name.
std::vector<std::size_t> MethodsOfResults(const HlslSource& source)
{
    const auto isText = [&](std::size_t index, std::string_view text)
    {
        return source.tokens[index].text == text;
    };
    const std::vector<std::string_view>& methods = source.declarations.methods;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i + 3 < source.tokens.size() && !methods.empty(); ++i)
    {
        const std::string_view name = source.tokens[i + 2].text;
        if (isText(i, ")") && isText(i + 1, ".") && isText(i + 3, "(") &&
            std::find(methods.begin(), methods.end(), name) != methods.end())
        {
            found.push_back(i + 2);
        }
    }
    return found;
}

constexpr std::size_t k_DeepestBrackets = 500;
constexpr std::size_t k_DeepestOperators = 2000;

/// Adds up how deep the tree of an expression is: a chain of operators goes down by one with each,
/// and so does a chain of `else if`; brackets cost a compiler more.
class DepthCounter
{
public:
    /// The depth that the tree has at least.
    std::size_t Take(const HlslToken& token, std::string_view next)
    {
        constexpr std::string_view k_Statements[] = {"if", "else", "for", "while", "switch"};
        constexpr std::string_view k_NoOperators = ".,;:(){}[]\"";
        const std::string_view text = token.text;
        if (text == "(" || text == "[" || text == "{")
        {
            m_Levels.emplace_back();
        }
        else if ((text == ")" || text == "]" || text == "}") && m_Levels.size() > 1)
        {
            const std::size_t inner = m_Levels.back().Depth() + k_Bracket;
            m_Levels.pop_back();
            m_Levels.back().inner = std::max(m_Levels.back().inner, inner);
        }
        else if (token.isWord ? std::find(std::begin(k_Statements), std::end(k_Statements), text) !=
                                    std::end(k_Statements)
                              : !isDigit(text[0]) && k_NoOperators.find(text[0]) == text.npos)
        {
            ++m_Levels.back().operators;
        }
        const std::size_t depth = std::max(m_Levels.back().Depth(), m_Levels.size() * k_Bracket);
        const bool isEnd = text == ";" || text == "," || text == "}";
        if (isEnd && next != "else" && next != ";")
        {
            m_Levels.back().End();
        }
        return depth;
    }

    static constexpr std::size_t k_Bracket = k_DeepestOperators / k_DeepestBrackets;

private:
    struct Level
    {
        std::size_t operators = 0;
        std::size_t inner = 0;   ///< deepest of its brackets
        std::size_t deepest = 0; ///< of the expressions before this one

        std::size_t Depth() const { return std::max(operators + inner, deepest); }
        void End()
        {
            deepest = Depth();
            operators = 0;
            inner = 0;
        }
    };
    std::vector<Level> m_Levels{1};
};

} // namespace

void RequireShallow(const std::string& hlsl)
{
    const std::vector<HlslToken> tokens = TokenizeHlsl(hlsl);
    DepthCounter counter;
    for (std::size_t i = 0; i < tokens.size(); ++i)
    {
        const std::string_view next = i + 1 < tokens.size() ? tokens[i + 1].text : "";
        if (counter.Take(tokens[i], next) > k_DeepestOperators)
        {
            const HlslPlace place = PlaceOf(hlsl, tokens[i].Begin(hlsl));
            throw AssetError(place.file, place.location,
                             "HLSL: this is nested more than " + std::to_string(k_DeepestBrackets) +
                                 " brackets or " + std::to_string(k_DeepestOperators) +
                                 " operators deep; take it apart");
        }
    }
}

void RequireSound(const HlslSource& source)
{
    std::vector<Diagnostic> diagnostics;
    for (const std::size_t token : source.declarations.unknownMacros)
    {
        diagnostics.push_back(ErrorAt(source, token,
                                      "unknown macro; a declaration is expected here, so define it "
                                      "or include the file that does"));
    }
    if (!diagnostics.empty())
    {
        throw AssetError(std::move(diagnostics)); // the rest may be what the macro does not declare
    }
    for (const HlslVariable* variable : FindRepeats(source.declarations).redefinitions)
    {
        diagnostics.push_back(
            ErrorAt(source, variable->token, "redefinition; something else has this name already"));
    }
    for (const std::size_t token : MethodsOfResults(source))
    {
        diagnostics.push_back(ErrorAt(source, token,
                                      "a method of what a function returns cannot be called; keep "
                                      "the result in a variable first"));
    }
    if (!diagnostics.empty())
    {
        throw AssetError(std::move(diagnostics));
    }
}

} // namespace limn
