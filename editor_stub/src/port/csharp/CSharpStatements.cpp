#include "port/csharp/CSharpStatements.h"

#include "console/Texts.h"

#include <algorithm>

namespace limn
{

const CSharpToken* FindOutsideOfBrackets(const CSharpToken* at, const CSharpToken* end,
                                         std::initializer_list<std::string_view> words)
{
    while (at < end && !(at->kind == CSharpTokenKind::Punctuation && IsIn(at->text, words)))
    {
        at = at->Behind();
    }
    return std::min(at, end);
}

const CSharpToken* EndOfStatement(const CSharpToken* at, const CSharpToken* end)
{
    if (at >= end || at->Is("{"))
    {
        return at < end ? std::min(at->Behind(), end) : end;
    }
    const bool hasHead = IsIn(at->text, {"if", "for", "foreach", "while", "switch", "lock"}) ||
                         (at->Is("using") && at[1].Is("("));
    if (at->Is("else") || at->Is("do") || at->Is("try") || at->Is("finally"))
    {
        return EndOfStatement(at + 1, end);
    }
    if (!hasHead || !at[1].Is("("))
    {
        return std::min(FindOutsideOfBrackets(at, end, {";"}) + 1, end);
    }
    const CSharpToken* behind = EndOfStatement(at[1].Behind(), end);
    return at->Is("if") && behind < end && behind->Is("else") ? EndOfStatement(behind + 1, end)
                                                              : behind;
}

} // namespace limn
