#include "hlsl/lowering/Lowering.h"

#include <algorithm>
#include <charconv>
#include <span>
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

/// The values of a list and of the lists in it, in order.
void Flatten(const HlslNode& list, std::vector<const HlslNode*>& items)
{
    for (const HlslNode* item = list.child; item; item = item->next)
    {
        if (item->kind == HlslNodeKind::List)
        {
            Flatten(*item, items);
        }
        else
        {
            items.push_back(item);
        }
    }
}

/// Deals the values of a list out to the members of a struct, number by number.
class ListDealer
{
public:
    ListDealer(const HlslDeclarations& declarations, const HlslEditor& code, const HlslNode& list)
        : m_Declarations(declarations), m_Code(code)
    {
        Flatten(list, m_Items);
    }

    /// `{ … }` as glslang wants it; "" where the values do not fit.
    std::string Deal(const HlslStruct& type)
    {
        const std::string text = DealMembers(type);
        return m_Fits && m_Next == m_Items.size() ? text : "";
    }

private:
    std::string DealMembers(const HlslStruct& type)
    {
        std::string text;
        for (const HlslVariable& member : type.members)
        {
            text += (text.empty() ? "{" : ", ") +
                    DealArray(TypeOf(m_Declarations, member), member.dimensions);
        }
        return text + "}";
    }

    std::string DealArray(const HlslType& type, std::span<const std::string_view> dimensions)
    {
        if (dimensions.empty())
        {
            return DealOne(type);
        }
        int count = 0;
        const std::string_view size = dimensions.front();
        std::from_chars(size.data(), size.data() + size.size(), count);
        m_Fits = m_Fits && count > 0;
        std::string text;
        for (int i = 0; i < count && m_Fits; ++i)
        {
            text += (i == 0 ? "{" : ", ") + DealArray(type, dimensions.subspan(1));
        }
        return text + "}";
    }

    std::string DealOne(const HlslType& type)
    {
        const HlslStruct* const inner = m_Declarations.FindStruct(type.name);
        const HlslNode* const whole = m_Next < m_Items.size() ? m_Items[m_Next] : nullptr;
        if (inner && whole && whole->type.kind != HlslType::Kind::Struct)
        {
            return DealMembers(*inner);
        }
        int left = type.kind == HlslType::Kind::Number ? type.components() : 1;
        std::string values;
        int count = 0;
        for (; left > 0 && m_Next < m_Items.size(); ++count)
        {
            values += (count > 0 ? ", " : "") + Take(left);
        }
        m_Fits = m_Fits && left == 0;
        return count == 1 ? values : type.Spelling() + "(" + values + ")";
    }

    /// The value at hand, or of a vector what is `left` to be filled.
    std::string Take(int& left)
    {
        const HlslNode& item = *m_Items[m_Next];
        const int all = item.type.isNumber() ? item.type.components() : 1;
        const int taken = std::min(left, all - m_Taken);
        const bool isPart = taken < all;
        m_Fits = m_Fits && (item.type.isNumber() || left == 1) && (!isPart || item.type.isVector());
        std::string text = m_Code.Spelled(item.first, item.end);
        if (isPart)
        {
            text = "(" + text + ").";
            text += std::string_view("xyzw").substr(static_cast<std::size_t>(m_Taken) % 4,
                                                    static_cast<std::size_t>(taken));
        }
        left -= taken;
        m_Taken += taken;
        m_Next += m_Taken == all ? 1 : 0;
        m_Taken = m_Taken == all ? 0 : m_Taken;
        return text;
    }

    const HlslDeclarations& m_Declarations;
    const HlslEditor& m_Code;
    std::vector<const HlslNode*> m_Items;
    std::size_t m_Next = 0;
    int m_Taken = 0; ///< of its numbers
    bool m_Fits = true;
};

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
    if (value.kind == HlslNodeKind::List && type.kind == HlslType::Kind::Struct)
    {
        LowerStructList(value, type);
        return;
    }
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

/// To HLSL the brackets in a list say nothing: its numbers are the members' one after the other.
void HlslLowering::LowerStructList(HlslNode& list, const HlslType& type)
{
    const HlslStruct* const structure = m_Globals.declarations().FindStruct(type.name);
    bool isNested = false;
    for (const HlslNode* item = list.child; item; item = item->next)
    {
        isNested = isNested || item->kind == HlslNodeKind::List;
    }
    if (type.dimensions > 0 || !structure ||
        (!isNested && list.CountChildren() == structure->members.size()))
    {
        return;
    }
    ListDealer dealer(m_Globals.declarations(), m_Code, list);
    if (const std::string dealt = dealer.Deal(*structure); !dealt.empty())
    {
        m_Code.Erase(list.first, list.end);
        m_Code.Spelling(list.first) = dealt;
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
