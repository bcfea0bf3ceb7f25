#include "hlsl/DuplicateDeclarations.h"

#include "hlsl/Types.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

namespace limn
{

namespace
{

/// Returns whether the first of two equal variables stays. A member of a buffer stays, and one of
/// limn's before an author's, because others depend on its layout; otherwise the first stays.
bool isStayingBefore(const HlslVariable& first, const HlslVariable& second)
{
    if (first.isInBuffer != second.isInBuffer)
    {
        return first.isInBuffer;
    }
    return first.buffer.starts_with("limn_") || !second.buffer.starts_with("limn_");
}

/// Returns the tokens of a buffer, from `cbuffer` to one behind its end.
/// @param close  its closing brace
std::pair<std::size_t, std::size_t> SpanOfBuffer(const TokenEdits& code, std::size_t close)
{
    std::size_t first = code.tokens().MatchingOpen(close);
    while (first > 0 && code.Text(first) != "cbuffer" && code.Text(first) != "tbuffer")
    {
        --first;
    }
    return {first, close + (code.Text(close + 1) == ";" ? 2 : 1)};
}

bool IsUsedBetween(const TokenEdits& code, const HlslVariable& first, const HlslVariable& second,
                   const std::vector<bool>& isLeftOut)
{
    for (std::size_t i = first.semicolon; i < second.firstToken; ++i)
    {
        if (!isLeftOut[i] && code.Text(i) == first.name)
        {
            return true;
        }
    }
    return false;
}

/// Takes names out of a declaration, with the commas that they leave, or all of it.
void RemoveFromList(TokenEdits& code, const std::vector<const HlslVariable*>& list,
                    const std::set<const HlslVariable*>& goes)
{
    const auto isGoing = [&](const HlslVariable* variable)
    {
        return goes.contains(variable);
    };
    if (std::ranges::all_of(list, isGoing))
    {
        code.Erase(list.front()->firstToken, list.front()->semicolon + 1);
        return;
    }
    bool isFirst = true; // of those that stay
    for (const HlslVariable* variable : list)
    {
        const bool hasComma = variable != list.front();
        if (hasComma && (isFirst || isGoing(variable)))
        {
            code.Erase(variable->token - 1, variable->token);
        }
        if (isGoing(variable))
        {
            code.Erase(variable->token, variable->declaratorEnd);
        }
        isFirst = isFirst && isGoing(variable);
    }
}

} // namespace

DuplicateDeclarations FindDuplicates(const HlslDeclarations& declarations)
{
    DuplicateDeclarations repeats;
    std::unordered_map<std::string_view, const HlslVariable*> known;
    const auto compare = [&](const HlslVariable& variable)
    {
        const auto [entry, isNew] = known.try_emplace(variable.name, &variable);
        const HlslVariable*& other = entry->second;
        if (isNew)
        {
            return;
        }
        const bool isSame = isSameType(other->type, variable.type) &&
                            other->templateArgument == variable.templateArgument &&
                            other->dimensions == variable.dimensions;
        const bool isStaying = isStayingBefore(*other, variable);
        if (isSame && isStaying && variable.semicolon > 0)
        {
            repeats.superfluous.push_back(&variable);
        }
        else if (isSame && !isStaying && other->semicolon > 0)
        {
            repeats.superfluous.push_back(other);
            repeats.early.emplace_back(other, &variable);
            other = &variable;
        }
        else if (!variable.isInBuffer)
        {
            repeats.redefinitions.push_back(&variable);
        }
    };
    std::ranges::for_each(declarations.objects, compare);
    std::ranges::for_each(declarations.uniforms, compare);
    for (const HlslVariable& uniform : declarations.uniforms)
    {
        const bool isOther =
            declarations.FindStruct(uniform.name) ||
            std::ranges::count(declarations.statics, uniform.name, &HlslVariable::name) > 0;
        if (isOther && !uniform.isInBuffer)
        {
            repeats.redefinitions.push_back(&uniform);
        }
    }
    return repeats;
}

DuplicateDeclarations RemoveDuplicates(TokenEdits& code, const HlslDeclarations& declarations)
{
    DuplicateDeclarations found = FindDuplicates(declarations);
    const std::vector<const HlslVariable*>& superfluous = found.superfluous;
    const std::set<const HlslVariable*> goes(superfluous.begin(), superfluous.end());
    std::map<std::size_t, std::size_t> left; // members, by the end of their buffer
    std::map<std::size_t, std::vector<const HlslVariable*>> lists; // by their semicolon
    for (const auto* list : {&declarations.uniforms, &declarations.objects})
    {
        for (const HlslVariable& variable : *list)
        {
            left[variable.endToken] += variable.isInBuffer ? 1 : 0;
            lists[variable.semicolon].push_back(&variable);
        }
    }
    for (const HlslVariable* variable : superfluous)
    {
        if (const auto list = lists.extract(variable->semicolon))
        {
            RemoveFromList(code, list.mapped(), goes);
        }
        if (variable->isInBuffer && --left[variable->endToken] == 0)
        {
            // glslang does not read `cbuffer name { }` with nothing in it.
            const auto [first, end] = SpanOfBuffer(code, variable->endToken);
            code.Erase(first, end);
        }
    }
    return found;
}

void MoveBuffersUp(TokenEdits& code, const DuplicateDeclarations& removed,
                   const std::vector<bool>& isLeftOut)
{
    std::map<std::size_t, std::size_t> places; // the new ones, by the buffer's end
    for (const auto& [first, second] : removed.early)
    {
        const std::size_t place =
            first->isInBuffer ? SpanOfBuffer(code, first->endToken).first : first->firstToken;
        if (place > 0 && !isLeftOut[second->token] &&
            IsUsedBetween(code, *first, *second, isLeftOut))
        {
            const auto known = places.try_emplace(second->endToken, place).first;
            known->second = std::min(known->second, place);
        }
    }
    for (const auto& [close, place] : places)
    {
        const auto [first, end] = SpanOfBuffer(code, close);
        code.Insert(place - 1, " " + code.Spelled(first, end));
        code.Erase(first, end);
    }
}

} // namespace limn
