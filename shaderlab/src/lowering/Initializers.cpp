#include "lowering/Lowering.h"
#include "tokens/IntegerExpression.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace limn
{

namespace
{

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

/// A variable, or a part of one, to which a list gives a value.
struct Slot
{
    HlslType type; ///< of an array's elements
    std::span<const std::string_view> dimensions;

    Slot Element() const { return {type, dimensions.subspan(1)}; }
};

constexpr std::int64_t k_MostElements = 4096;

/// Stands for a value that stays where it is in what a ListDealer writes.
constexpr char k_Whole = '\1';

/// Deals the values of a list out to what it initialises, number by number: to HLSL the brackets in
/// a list say nothing.
class ListDealer
{
public:
    /// @param hasEffects  asks of a value whether it must be worked out once
    ListDealer(const HlslDeclarations& declarations, TokenEdits& code, const HlslNode& list,
               std::function<bool(const HlslNode&)> hasEffects)
        : m_Declarations(declarations), m_Code(code), m_HasEffects(std::move(hasEffects))
    {
        Flatten(list, m_Items);
    }

    /// Spells the list as glslang wants it, unless it does not fit.
    ///
    /// @param statement  the declaration that the list is the first value of; null where nothing
    ///                   may stand before it
    void Deal(const HlslNode& list, const Slot& slot, const HlslNode* statement)
    {
        std::string text = DealSlot(slot);
        if (!m_Fits || m_Next != m_Items.size())
        {
            return;
        }
        std::string variables;
        if (m_IsDoubled && statement)
        {
            variables = NameValues();
            m_Whole.clear();
            m_Next = 0;
            text = DealSlot(slot);
        }
        Spell(list, text);
        if (!variables.empty())
        {
            m_Code.Spelling(statement->first).insert(0, variables);
        }
    }

private:
    /// Declares a variable for each value that must be worked out once, and in its turn.
    std::string NameValues()
    {
        std::string text;
        for (const HlslNode* item : m_Items)
        {
            if (item->type.isNumber() && m_HasEffects(*item))
            {
                const std::string& name = m_Names[item] = "limn_v" + std::to_string(item->first);
                text += item->type.Spelling() + " " + name + " = " +
                        m_Code.Spelled(item->first, item->end) + "; ";
            }
        }
        return text;
    }

    std::string DealMembers(const HlslStruct& type)
    {
        constexpr int k_Deepest = 100; // of structs that hold themselves, which are mistakes
        m_Fits = m_Fits && !type.members.empty() && ++m_Depth <= k_Deepest;
        std::string text;
        for (std::size_t i = 0; m_Fits && i < type.members.size(); ++i)
        {
            const HlslVariable& member = type.members[i];
            text += (i == 0 ? "{" : ", ") +
                    DealSlot({TypeOf(m_Declarations, member).Innermost(), member.dimensions});
        }
        --m_Depth;
        return text + "}";
    }

    std::string DealSlot(const Slot& slot)
    {
        if (slot.dimensions.empty())
        {
            return DealOne(slot.type);
        }
        const std::string_view size = slot.dimensions.front();
        const std::int64_t known = std::clamp<std::int64_t>(
            EvaluateInteger(size, m_Declarations.constants), 0, k_MostElements);
        m_Fits = m_Fits && (known > 0 || size.empty()); // else its list tells
        std::string text;
        for (std::int64_t i = 0; m_Fits && (known > 0 ? i < known : m_Next < m_Items.size()); ++i)
        {
            text += (i == 0 ? "{" : ", ") + DealSlot(slot.Element());
        }
        return text + "}";
    }

    std::string DealOne(const HlslType& type)
    {
        const HlslStruct* const inner = m_Declarations.FindStruct(type.name);
        const HlslNode* const whole = m_Next < m_Items.size() ? m_Items[m_Next] : nullptr;
        if (inner && whole && whole->type.isNumber())
        {
            return DealMembers(*inner);
        }
        // It may be one of the struct or its first member: glslang knows, and needs the brackets.
        m_Fits = m_Fits && !(inner && whole && whole->type.kind == HlslType::Kind::Unknown);
        int left = type.kind == HlslType::Kind::Number ? type.components() : 1;
        std::string values;
        int count = 0;
        for (; left > 0 && m_Next < m_Items.size(); ++count)
        {
            // glslang makes no matrix of one vector.
            const bool isRow = type.isMatrix() && m_Items[m_Next]->type.isVector();
            values += (count > 0 ? ", " : "") + Take(left, isRow ? type.columns : left);
        }
        m_Fits = m_Fits && left == 0;
        return count == 1 ? values : type.Spelling() + "(" + values + ")";
    }

    /// The value at hand, or of a vector what is `left` to be filled.
    ///
    /// @param most  how many numbers to take
    std::string Take(int& left, int most)
    {
        const HlslNode& item = *m_Items[m_Next];
        const int all = item.type.isNumber() ? item.type.components() : 1;
        const int taken = std::min({left, all - m_Taken, item.type.isVector() ? most : all});
        const bool isPart = taken < all;
        m_Fits = m_Fits && (item.type.isNumber() || left == 1) && (!isPart || item.type.isVector());
        const auto named = m_Names.find(&item);
        const bool isNamed = named != m_Names.end();
        std::string text = isNamed ? named->second : std::string(1, k_Whole);
        if (isPart)
        {
            m_IsDoubled = m_IsDoubled || m_HasEffects(item);
            text = isNamed ? text + "." : "(" + m_Code.Spelled(item.first, item.end) + ").";
            text += std::string_view("xyzw").substr(static_cast<std::size_t>(m_Taken) % 4,
                                                    static_cast<std::size_t>(taken));
        }
        else if (!isNamed)
        {
            m_Whole.push_back(&item);
        }
        left -= taken;
        m_Taken += taken;
        m_Next += m_Taken == all ? 1 : 0;
        m_Taken = m_Taken == all ? 0 : m_Taken;
        return text;
    }

    /// Writes the text in the place of the list. Values that are taken whole stay in their place,
    /// so that messages about them name it.
    void Spell(const HlslNode& list, std::string_view text)
    {
        std::size_t token = list.first;
        for (const HlslNode* item : m_Whole)
        {
            m_Code.Erase(token, item->first);
            const std::size_t size = text.find(k_Whole);
            m_Code.Spelling(item->first).insert(0, text.substr(0, size));
            text.remove_prefix(size + 1);
            token = item->end;
        }
        m_Code.Erase(token, list.end);
        m_Code.Spelling(list.end - 1) = text;
    }

    const HlslDeclarations& m_Declarations;
    TokenEdits& m_Code;
    std::vector<const HlslNode*> m_Items;
    std::vector<const HlslNode*> m_Whole; ///< of them
    std::function<bool(const HlslNode&)> m_HasEffects;
    std::map<const HlslNode*, std::string> m_Names; ///< of variables that values are in
    bool m_IsDoubled = false; ///< whether a value that must be worked out once is written twice
    std::size_t m_Next = 0;
    int m_Taken = 0; ///< of its numbers
    int m_Depth = 0; ///< of structs in structs
    bool m_Fits = true;
};

} // namespace

void HlslLowering::LowerDeclarator(HlslNode& node)
{
    if (!node.child)
    {
        return;
    }
    // `float x = x`, where nothing else has that name, is undefined; glslang knows no such name.
    // Amplify's templates write it into code that is not reached.
    const HlslNode& value = *node.child;
    const bool isItself = value.kind == HlslNodeKind::Name && !value.local && !value.variable &&
                          Text(value.token) == Text(node.token);
    if (isItself && node.type.isNumber() && !node.type.isMatrix() && node.type.dimensions == 0)
    {
        m_Code.Spelling(value.token) = "0";
        return;
    }
    std::vector<std::string_view> dimensions;
    for (std::size_t i = node.token + 1; Text(i) == "["; i = m_Code.AfterBracket(i))
    {
        dimensions.push_back(m_Code.Span(i + 1, m_Code.AfterBracket(i) - 1));
    }
    const HlslNode* const declaration = node.parent;
    const bool isFirst = declaration && declaration->child == &node && declaration->parent &&
                         declaration->parent->kind == HlslNodeKind::Block && !m_IsInitial;
    LowerInitializer(*node.child, node.type, dimensions, isFirst ? declaration : nullptr);
}

void HlslLowering::LowerInitializer(HlslNode& value, const HlslType& type,
                                    std::span<const std::string_view> dimensions,
                                    const HlslNode* statement)
{
    const HlslDeclarations& declarations = m_Globals.declarations();
    const Slot slot{type.Innermost(), dimensions};
    const bool isKnown = type.dimensions == dimensions.size() &&
                         (slot.type.isNumber() || declarations.FindStruct(slot.type.name));
    if (value.kind == HlslNodeKind::List && value.child && isKnown)
    {
        ListDealer dealer(declarations, m_Code, value,
                          [this](const HlslNode& item) { return HasEffects(item); });
        dealer.Deal(value, slot, statement);
    }
}

/// `(float4[2])0` gives each element the value; to glslang it is one element of an array.
void HlslLowering::LowerArrayCast(HlslNode& node)
{
    const HlslType element = node.type.Innermost();
    const std::size_t open = m_Code.tokens().MatchingOpen(node.child->first - 2);
    const std::string_view size = m_Code.Span(open + 1, node.child->first - 2);
    const std::int64_t count = EvaluateInteger(size, m_Globals.declarations().constants);
    if (node.type.dimensions != 1 || !node.child->type.isScalar() || count < 1 ||
        count > k_MostElements || !element.isNumber())
    {
        return;
    }
    const std::string name = element.Spelling();
    const std::string array = "limn_" + name + "_" + std::to_string(count);
    const std::string value = node.child->type.Of(HlslScalar::Float).Spelling();
    Need("typedef " + name + " " + array + "[" + std::to_string(count) + "]; " + array +
         " limn_fill_" + array + "(" + value + " v) { " + array + " a; for (int i = 0; i < " +
         std::to_string(count) + "; ++i) { a[i] = (" + name + ")v; } return a; } ");
    m_Code.Erase(node.first, node.child->first);
    m_Code.Spelling(node.first) = " limn_fill_" + array + "(";
    Wrap(*node.child, "", ")");
}

} // namespace limn
