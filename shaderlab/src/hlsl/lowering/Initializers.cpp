#include "hlsl/lowering/Lowering.h"

#include <utility>
#include <vector>

namespace limn
{

namespace
{

/// How many of an array's numbers an item of its list is; 0 = not to be told.
int ComponentsOf(const HlslNode& item, int element)
{
    return item.kind == HlslNodeKind::List ? element
           : item.type.isNumber()          ? item.type.components()
                                           : 0;
}

} // namespace

void HlslLowering::LowerDeclarator(HlslNode& node)
{
    if (!node.child)
    {
        return;
    }
    const bool isArray = node.type.dimensions == 1 && Text(node.token + 1) == "[";
    const std::size_t behind = isArray ? m_Code.AfterBracket(node.token + 1) : 0;
    LowerInitializer(*node.child, node.type,
                     isArray ? m_Code.Span(node.token + 2, behind - 1) : std::string_view());
}

/// `float3x3 m = {v, w, 1, 2, 3}` means `float3x3(v, w, 1, 2, 3)`: glslang wants a number, or a
/// row, for each element.
void HlslLowering::LowerList(HlslNode& list, const HlslType& type)
{
    int sum = 0;
    bool hasVectors = false;
    for (const HlslNode* item = list.child; item; item = item->next)
    {
        const bool isKnown = item->type.isScalar() || item->type.isVector();
        sum += isKnown ? item->type.columns : type.components() + 1;
        hasVectors = hasVectors || item->type.isVector();
    }
    if (hasVectors && sum == type.components())
    {
        m_Code.Spelling(list.first) = type.Spelling() + "(";
        m_Code.Spelling(list.end - 1) = ")";
    }
}

/// The numbers that an array of vectors or matrices is initialised with stand in constructors:
/// `float2 a[] = {1, 2, uv4, float2(3, 4)}` means `{float2(1, 2), uv4.xy, uv4.zw, float2(3, 4)}`,
/// which glslang does not see by itself.
void HlslLowering::LowerInitializer(HlslNode& value, const HlslType& type,
                                    std::string_view dimension)
{
    if (value.kind == HlslNodeKind::List && type.isNumber() && type.components() > 1)
    {
        LowerList(value, type);
        return;
    }
    HlslType element = type;
    element.dimensions = 0;
    const int components = element.components();
    const bool isWhole = dimension == std::to_string(value.CountChildren());
    if (value.kind != HlslNodeKind::List || type.dimensions != 1 || !element.isNumber() || isWhole)
    {
        return;
    }
    std::vector<std::pair<HlslNode*, HlslNode*>> groups; // of items that make up an element
    std::vector<HlslNode*> several;                      // items that make up several
    int sum = 0;
    for (HlslNode* item = value.child; item; item = item->next)
    {
        const int own = ComponentsOf(*item, components);
        if (own > components && own % components == 0 && sum == 0 && item->type.isVector())
        {
            several.push_back(item);
            continue;
        }
        if (own == 0 || sum + own > components)
        {
            return; // the items do not tell
        }
        if (sum == 0)
        {
            groups.emplace_back(item, item);
        }
        groups.back().second = item;
        sum = (sum + own) % components;
        if (own == components)
        {
            groups.pop_back();
        }
    }
    if (sum != 0)
    {
        return;
    }
    for (const auto& [first, last] : groups)
    {
        m_Code.Wrap(first->first, last->end, element.Spelling() + "(", ")");
    }
    for (HlslNode* item : several)
    {
        SplitItem(*item, components);
    }
}

/// `v` becomes `(v).xy, (v).zw`.
void HlslLowering::SplitItem(HlslNode& item, int components)
{
    const std::string text = "(" + m_Code.Spelled(item.first, item.end) + ").";
    std::string pieces;
    for (int i = 0; i < item.type.columns; i += components)
    {
        const auto begin = static_cast<std::size_t>(i);
        pieces += (i > 0 ? ", " : "") + text;
        pieces += std::string_view("xyzw").substr(begin, static_cast<std::size_t>(components));
    }
    m_Code.Erase(item.first, item.end);
    m_Code.Spelling(item.first) = pieces;
}

} // namespace limn
