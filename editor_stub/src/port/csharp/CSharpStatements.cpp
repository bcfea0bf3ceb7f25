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

namespace
{

const CSharpToken* End(const CSharpToken* at, const CSharpToken* end, int depth)
{
    if (at >= end || depth > k_MostStatements)
    {
        return end;
    }
    if (at->Is("{"))
    {
        return std::min(at->Behind(), end);
    }
    if (at->Is("try"))
    {
        const CSharpToken* behind = End(at + 1, end, depth + 1);
        while (behind < end && (behind->Is("catch") || behind->Is("finally")))
        {
            behind = End(FindOutsideOfBrackets(behind, end, {"{", ";"}), end, depth + 1);
        }
        return behind;
    }
    if (at->Is("do"))
    {
        const CSharpToken* condition = End(at + 1, end, depth + 1);
        return std::min(FindOutsideOfBrackets(condition, end, {";"}) + 1, end);
    }
    const bool hasHead = IsIn(at->text, {"if", "for", "foreach", "while", "switch", "lock"}) ||
                         (at->Is("using") && at[1].Is("("));
    if (!hasHead || !at[1].Is("("))
    {
        return std::min(FindOutsideOfBrackets(at, end, {";"}) + 1, end);
    }
    const CSharpToken* behind = End(at[1].Behind(), end, depth + 1);
    const bool hasElse = at->Is("if") && behind < end && behind->Is("else");
    return hasElse ? End(behind + 1, end, depth + 1) : behind;
}

} // namespace

const CSharpToken* EndOfStatement(const CSharpToken* at, const CSharpToken* end)
{
    return End(at, end, 0);
}

} // namespace limn
