#include "lowering/Lowering.h"

#include "tokens/IntegerExpression.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace limn
{

namespace
{

// glslang computes some operations in its own way while it compiles; those that it leaves to the
// device are corrected in its SPIR-V (see spirv/Arithmetic.h).

/// Returns whether the compiler may know the value: it names nothing that changes and calls no
/// function of the author.
bool MayBeConstant(const HlslNode& node, const TokenEdits& code)
{
    switch (node.kind)
    {
    case HlslNodeKind::Name:
        return node.variable
                   ? node.variable->Has("const")
                   : node.local && node.local->parent->kind == HlslNodeKind::Declaration &&
                         code.Span(node.local->parent->first, node.local->token).find("const") !=
                             std::string_view::npos;
    case HlslNodeKind::Unknown:
    case HlslNodeKind::Method:
    case HlslNodeKind::Assign:
    case HlslNodeKind::Postfix:
        return false;
    default:
        break;
    }
    bool isConstant = !node.function;
    for (const HlslNode* child = node.child; child && isConstant; child = child->next)
    {
        isConstant = MayBeConstant(*child, code);
    }
    return isConstant;
}

std::optional<double> NumberOf(std::string_view literal)
{
    double value = 0.0;
    const char* const end = literal.data() + literal.size();
    const auto [rest, error] = std::from_chars(literal.data(), end, value);
    const bool isWhole = error == std::errc() && end - rest <= 1; // 1.5f
    return isWhole ? std::optional(value) : std::nullopt;
}

/// The value of a number that is written with operators only; nothing of others.
///
/// @param names  how many variables may stand for one another
std::optional<double> ValueOf(const HlslNode& node, const TokenEdits& code, int names = 4)
{
    const std::string_view text = code.Text(node.token);
    const auto first = [&]
    {
        return ValueOf(*node.child, code, names);
    };
    switch (node.kind)
    {
    case HlslNodeKind::Literal:
        return NumberOf(text);
    case HlslNodeKind::Paren:
        return first();
    case HlslNodeKind::Name:
        return names > 0 && node.local && node.local->child
                   ? ValueOf(*node.local->child, code, names - 1)
                   : std::nullopt;
    case HlslNodeKind::Prefix:
        if (const auto value = first(); value && text == "-")
        {
            return -*value;
        }
        return std::nullopt;
    case HlslNodeKind::Binary:
    {
        const auto left = first();
        const auto right = ValueOf(*node.last, code, names);
        const bool isKnown = left && right && node.type.isFloating();
        return !isKnown      ? std::nullopt
               : text == "+" ? std::optional(*left + *right)
               : text == "-" ? std::optional(*left - *right)
               : text == "*" ? std::optional(*left * *right)
               : text == "/" ? std::optional(*left / *right)
                             : std::nullopt;
    }
    default:
        return std::nullopt;
    }
}

bool HoldsValue(const HlslType& integer, double value)
{
    const bool isSigned = integer.scalar == HlslScalar::Int;
    const double whole = std::trunc(value);
    return whole >= (isSigned ? -0x1p31 : 0.0) && whole < (isSigned ? 0x1p31 : 0x1p32);
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

/// A variable, or a part of one, to which a list gives a value.
struct Slot
{
    HlslType type; ///< of an array's elements
    std::span<const std::string_view> dimensions;
};

constexpr std::int64_t k_MostElements = 4096;

/// Stands for a value that stays where it is in what a ListDealer writes.
constexpr char k_Whole = '\1';

/// Deals the values of a list out to what it initialises, number by number: to HLSL the brackets in
/// a list say nothing.
class ListDealer
{
public:
    ListDealer(const HlslDeclarations& declarations, TokenEdits& code, const HlslNode& list)
        : m_Declarations(declarations), m_Code(code)
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
            if (item->type.isNumber() && HasEffects(*item, m_Code))
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
            text += (i == 0 ? "{" : ", ") + DealSlot({slot.type, slot.dimensions.subspan(1)});
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
            m_IsDoubled = m_IsDoubled || HasEffects(item, m_Code);
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
    std::vector<const HlslNode*> m_Whole;           ///< of them
    std::map<const HlslNode*, std::string> m_Names; ///< of variables that values are in
    bool m_IsDoubled = false; ///< whether a value that must be worked out once is written twice
    std::size_t m_Next = 0;
    int m_Taken = 0; ///< of its numbers
    int m_Depth = 0; ///< of structs in structs
    bool m_Fits = true;
};

} // namespace

/// Keeps a value from being computed with while the program is compiled.
void HlslLowering::Hide(const HlslNode& node)
{
    const std::string type = node.type.Spelling();
    Need(type + " limn_runtime(" + type + " v) { return v; } ");
    Wrap(node, "limn_runtime(", ")");
}

/// Returns whether glslang gets the operation wrong if all its operands are constant.
bool HlslLowering::FoldsWrong(const HlslNode& node) const
{
    const std::string_view name = Text(node.token);
    const std::size_t count = node.CountChildren();
    const auto isNumber = [&](const HlslNode& operand)
    {
        return !std::isnan(ValueOf(operand, m_Code).value_or(NAN));
    };
    if (name == "round")
    {
        return count == 1 && node.type.isFloating();
    }
    if (count != 2 || !node.child->type.isNumber() || !node.last->type.isNumber())
    {
        return false;
    }
    const HlslType type = Promote(node.child->type, node.last->type);
    if (name == "fmod" || name == "%")
    {
        const double divisor = ValueOf(*node.last, m_Code).value_or(type.isVector() ? 0.0 : 1.0);
        return node.type.isFloating() || (type.scalar == HlslScalar::Uint && divisor == 0.0);
    }
    const bool isOfNumbers = isNumber(*node.child) && isNumber(*node.last);
    if (name == "min" || name == "max" || name == "step")
    {
        return node.type.isFloating() && !isOfNumbers;
    }
    if (name == "dot")
    {
        return !node.type.isFloating();
    }
    const bool isOrder = name == "<" || name == "<=" || name == ">" || name == ">=";
    return isOrder && (type.isVector() || (type.isFloating() && !isOfNumbers));
}

/// `dot` of integers as a sum.
void HlslLowering::SpellDot(const HlslNode& node)
{
    const std::string x = "(" + m_Code.Spelled(node.child->first, node.child->end) + ")";
    const std::string y = "(" + m_Code.Spelled(node.last->first, node.last->end) + ")";
    const auto part = [](const HlslNode& operand, int index)
    {
        return operand.type.isScalar() ? "" : std::string(".") + "xyzw"[index];
    };
    std::string sum;
    const int count = Promote(node.child->type, node.last->type).columns;
    for (int i = 0; i < count; ++i)
    {
        sum += (i > 0 ? " + " : "") + x + part(*node.child, i) + " * " + y + part(*node.last, i);
    }
    m_Code.Erase(node.first, node.end);
    m_Code.Spelling(node.first) = "(" + sum + ")";
}

/// Returns whether a static variable gets the right value only if a function computes it: elements
/// of matrices, and comparisons of vectors.
bool HlslLowering::NeedsFunction(const HlslNode& value) const
{
    const auto isOne = [&](const HlslNode& part)
    {
        const std::string_view text = Text(part.token);
        const bool isOfMatrices = part.kind == HlslNodeKind::Binary &&
                                  part.child->type.isMatrix() &&
                                  (text == "%" || (text == "*" && part.last->type.isMatrix()));
        const bool isOrder = part.kind == HlslNodeKind::Binary && part.type.isVector() &&
                             part.type.scalar == HlslScalar::Bool && text != "&&" && text != "||";
        return isOfMatrices || isOrder ||
               (part.kind == HlslNodeKind::Call && part.type.isMatrix() && isComponentwise(text));
    };
    return FindNode(value, isOne) != nullptr;
}

/// Keeps glslang from computing operations that it gets wrong while it compiles: remainders,
/// `round`, comparisons of vectors, and tests of NaN.
void HlslLowering::LowerFolding(HlslNode& node)
{
    if ((node.type.isMatrix() && m_IsInitial) || !FoldsWrong(node) || !MayBeConstant(node, m_Code))
    {
        return;
    }
    if (!m_IsInitial)
    {
        Hide(*node.child);
        return;
    }
    const std::string_view name = Text(node.token);
    if (name == "dot")
    {
        SpellDot(node);
        return;
    }
    const bool isRemainder = name == "fmod" || name == "%";
    if (!node.type.isFloating() || (!isRemainder && name != "round"))
    {
        return;
    }
    const std::string x = "(1.0 * (" + m_Code.Spelled(node.child->first, node.child->end) + "))";
    const std::string y = "(" + m_Code.Spelled(node.last->first, node.last->end) + ")";
    m_Code.Erase(node.first, node.end);
    // If two whole numbers are equally near, the upper one is taken if it is even.
    m_Code.Spelling(node.first) = isRemainder
                                      ? "(" + x + " - " + y + " * trunc(" + x + " / " + y + "))"
                                      : "(floor(" + x + " + 0.5) - (1.0 - ceil(frac(" + x +
                                            " + 0.5))) * 2.0 * frac(floor(" + x + " + 0.5) * 0.5))";
}

/// A constant that becomes an integer which cannot hold it: cast, declared with it or assigned.
void HlslLowering::LowerConstantCast(const HlslNode& node)
{
    const bool isInteger =
        node.type.scalar == HlslScalar::Int || node.type.scalar == HlslScalar::Uint;
    if (m_IsInitial || !isInteger || node.type.isMatrix() || node.type.dimensions > 0)
    {
        return;
    }
    for (const HlslNode* part = node.child; part; part = part->next)
    {
        const bool isVaried = !part->type.isFloating() || part->type.isMatrix();
        if (isVaried || !MayBeConstant(*part, m_Code))
        {
            continue;
        }
        const auto value = ValueOf(*part, m_Code);
        if (!value || !HoldsValue(node.type, *value))
        {
            Hide(*part);
        }
    }
}

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
        ListDealer(declarations, m_Code, value).Deal(value, slot, statement);
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
