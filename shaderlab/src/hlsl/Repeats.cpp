#include "hlsl/Repeats.h"

#include "hlsl/Types.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace limn
{

namespace
{

bool isSameDeclaration(const HlslVariable& a, const HlslVariable& b)
{
    return isSameType(a.type, b.type) && a.templateArgument == b.templateArgument &&
           a.dimensions == b.dimensions;
}

/// Which of two equal ones stays: a member of a buffer, and of limn's before an author's, as the
/// others count on its layout; else the first.
bool isStayingBefore(const HlslVariable& first, const HlslVariable& second)
{
    if (first.isInBuffer != second.isInBuffer)
    {
        return first.isInBuffer;
    }
    return first.buffer.starts_with("limn_") || !second.buffer.starts_with("limn_");
}

/// `cbuffer name { }` with nothing in it, which glslang does not read.
void RemoveBuffer(HlslEditor& code, std::size_t close)
{
    std::size_t first = code.tokens().MatchingOpen(close);
    while (first > 0 && code.Text(first) != "cbuffer" && code.Text(first) != "tbuffer")
    {
        --first;
    }
    code.Erase(first, close + (code.Text(close + 1) == ";" ? 2 : 1));
}

} // namespace

HlslRepeats FindRepeats(const HlslDeclarations& declarations)
{
    HlslRepeats repeats;
    std::unordered_map<std::string_view, const HlslVariable*> known;
    const auto compare = [&](const HlslVariable& variable)
    {
        const auto [entry, isNew] = known.try_emplace(variable.name, &variable);
        const HlslVariable*& other = entry->second;
        if (isNew)
        {
            return;
        }
        const bool isSame = isSameDeclaration(*other, variable);
        const bool isStaying = isStayingBefore(*other, variable);
        if (isSame && isStaying && variable.lastToken > 0)
        {
            repeats.superfluous.push_back(&variable);
        }
        else if (isSame && !isStaying && other->lastToken > 0)
        {
            repeats.superfluous.push_back(other);
            other = &variable;
        }
        else if (!variable.isInBuffer)
        {
            repeats.redefinitions.push_back(&variable);
        }
    };
    for (const HlslVariable& object : declarations.objects)
    {
        compare(object);
    }
    for (const HlslVariable& uniform : declarations.uniforms)
    {
        compare(uniform);
    }
    for (const HlslVariable& uniform : declarations.uniforms)
    {
        const bool isOther =
            declarations.FindStruct(uniform.name) ||
            std::any_of(declarations.statics.begin(), declarations.statics.end(),
                        [&](const HlslVariable& item) { return item.name == uniform.name; });
        if (isOther && !uniform.isInBuffer)
        {
            repeats.redefinitions.push_back(&uniform);
        }
    }
    return repeats;
}

void RemoveRepeats(HlslEditor& code, const HlslDeclarations& declarations)
{
    std::map<std::size_t, std::size_t> left; // members, by the end of their buffer
    for (const auto* list : {&declarations.uniforms, &declarations.objects})
    {
        for (const HlslVariable& variable : *list)
        {
            left[variable.endToken] += variable.isInBuffer ? 1 : 0;
        }
    }
    for (const HlslVariable* variable : FindRepeats(declarations).superfluous)
    {
        code.Erase(variable->firstToken, variable->lastToken + 1);
        if (variable->isInBuffer && --left[variable->endToken] == 0)
        {
            RemoveBuffer(code, variable->endToken);
        }
    }
}

} // namespace limn
