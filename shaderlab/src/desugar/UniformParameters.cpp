#include "desugar/Rewrites.h"

#include "hlsl/TokenEdits.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Takes the uniform ones out of `( … )` and gives those declarations of theirs that are not
/// `known` yet: several entry functions may have the same one.
std::string TakeParameters(TokenEdits& code, std::size_t open, std::set<std::string>& known)
{
    std::string declarations;
    const std::size_t close = code.AfterBracket(open) - 1;
    bool hasFirst = false;
    for (std::size_t begin = open + 1; begin < close;)
    {
        const std::size_t end = std::min(code.FindOutside(begin, ","), close);
        if (code.Text(begin) == "uniform")
        {
            const std::string declaration = code.Spelled(begin, end);
            declarations += known.insert(declaration).second ? declaration + "; " : "";
            code.Erase(begin, end);
        }
        const bool isTaken = code.Text(begin) == "uniform";
        if (begin > open + 1 && (isTaken || !hasFirst))
        {
            code.Spelling(begin - 1).clear(); // the comma before it
        }
        hasFirst = hasFirst || !isTaken;
        begin = end + 1;
    }
    return declarations;
}

} // namespace

void TakeUniformParameters(TokenEdits& code, const std::set<std::string_view>& entries)
{
    std::set<std::string> known;
    std::size_t declaration = 0;
    for (std::size_t i = 0; i < code.size();)
    {
        if (i > 0 && entries.count(code.Text(i)) > 0 && code.isWord(i - 1) &&
            code.Text(i + 1) == "(")
        {
            const std::string declarations = TakeParameters(code, i + 1, known);
            if (!declarations.empty())
            {
                code.Spelling(declaration).insert(0, declarations);
            }
        }
        const bool isBlock = code.Text(i) == "{";
        const bool isEnd = isBlock || code.Text(i) == ";";
        i = code.Step(i) > 0 ? code.AfterBracket(i) : i + 1;
        declaration = isEnd ? i : declaration;
    }
}

} // namespace limn
