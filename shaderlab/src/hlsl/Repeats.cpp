#include "hlsl/Repeats.h"

#include "hlsl/Types.h"

#include <algorithm>
#include <unordered_map>

namespace limn
{

namespace
{

/// half is float.
bool isSameType(std::string_view a, std::string_view b)
{
    const auto first = NumberType(a);
    const auto second = NumberType(b);
    return a == b || (first && second && first->Spelling() == second->Spelling());
}

bool isSameDeclaration(const HlslVariable& a, const HlslVariable& b)
{
    return isSameType(a.type, b.type) && a.templateArgument == b.templateArgument &&
           a.dimensions == b.dimensions;
}

/// Whether one declaration may go because the other says the same.
bool isRemovable(const HlslVariable& variable)
{
    return !variable.isInBuffer && variable.lastToken > 0;
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
        if (isSame && isRemovable(variable))
        {
            repeats.superfluous.push_back(&variable);
        }
        else if (isSame && isRemovable(*other))
        {
            // A member of a buffer stays: the others count on the buffer's layout.
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

} // namespace limn
