#include "hlsl/Checks.h"

#include "hlsl/Repeats.h"

#include <algorithm>

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

} // namespace

void RequireSound(const HlslSource& source)
{
    std::vector<Diagnostic> diagnostics;
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
