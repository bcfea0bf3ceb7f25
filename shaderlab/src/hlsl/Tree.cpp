#include "hlsl/Tree.h"

#include <limn/base/Text.h>

namespace limn
{

HlslNode* HlslNode::Child(std::size_t index) const
{
    HlslNode* node = child;
    for (; node && index > 0; --index)
    {
        node = node->next;
    }
    return node;
}

void HlslNode::Add(HlslNode* added)
{
    added->parent = this;
    (last ? last->next : child) = added;
    last = added;
}

std::size_t HlslNode::CountChildren() const
{
    std::size_t count = 0;
    for (const HlslNode* node = child; node; node = node->next)
    {
        ++count;
    }
    return count;
}

HlslType TypeOf(const HlslDeclarations& declarations, std::string_view type,
                std::string_view argument)
{
    type = declarations.ResolveAlias(type, &argument);
    if (type == "void")
    {
        HlslType result;
        result.kind = HlslType::Kind::Void;
        return result;
    }
    if ((type == "vector" || type == "matrix") && !argument.empty())
    {
        const auto scalar = NumberType(Trim(argument.substr(0, argument.find(','))));
        const auto size = [&](std::size_t comma)
        {
            const std::string_view text =
                comma == argument.npos ? "" : Trim(argument.substr(comma + 1));
            return text.empty() || !isDigit(text[0]) ? 0 : text[0] - '0';
        };
        const int first = size(argument.find(','));
        const int second = size(argument.rfind(','));
        const bool isKnown = scalar && first > 0 && second > 0;
        return !isKnown           ? HlslType()
               : type == "vector" ? scalar->As(first)
                                  : scalar->As(second, first);
    }
    if (const auto number = NumberType(type))
    {
        return *number;
    }
    HlslType result;
    const HlslStruct* structure = declarations.FindStruct(type);
    if (structure || isObjectType(type))
    {
        result.kind = structure ? HlslType::Kind::Struct : HlslType::Kind::Object;
        result.name = type;
        result.element = argument;
    }
    return result;
}

HlslType TypeOf(const HlslDeclarations& declarations, const HlslVariable& variable)
{
    HlslType type = TypeOf(declarations, variable.type, variable.templateArgument);
    type.dimensions = static_cast<std::uint8_t>(variable.dimensions.size());
    return type;
}

} // namespace limn
