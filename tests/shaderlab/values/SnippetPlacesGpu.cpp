#include "values/SnippetDraft.h"

#include <algorithm>

// Nodes, types and places by chance.

namespace limn::test::snippets
{

namespace
{

/// Distinct parts of a vector or of a matrix.
Node Swizzle(Draft& draft, Node node, const Type& wanted)
{
    const Type type = node.type;
    std::vector<std::string> letters;
    const bool isFromZero = draft.random.OneIn(2);
    const std::string set = draft.random.OneIn(4) ? "rgba" : "xyzw";
    const int count = type.columns * std::max(type.rows, 1);
    for (int i = 0; i < count; ++i)
    {
        const int base = isFromZero ? 0 : 1;
        letters.push_back(type.isMatrix() ? (isFromZero ? "_m" : "_") +
                                                std::to_string(i / type.columns + base) +
                                                std::to_string(i % type.columns + base)
                                          : std::string(1, set[static_cast<std::size_t>(i)]));
    }
    std::string text;
    const int wantedCount = std::min(wanted.columns, count);
    for (int i = 0; i < wantedCount; ++i)
    {
        const int index = draft.random.Below(static_cast<int>(letters.size()));
        text += letters[static_cast<std::size_t>(index)];
        letters.erase(letters.begin() + index);
    }
    return MakeNode(Kind::Swizzle, type.As(wantedCount), text, {std::move(node)});
}

Node Index(Draft& draft, Node node)
{
    const Type type = node.type;
    const int count = !type.sizes.empty() ? type.sizes[0]
                      : type.rows > 0     ? type.rows
                                          : type.columns;
    Node index = MakeInteger(draft.random.Below(count));
    // SwiftShader loses some of what is written to a matrix in a struct in an array whose index
    // is not constant.
    const bool isLost = !draft.isLavapipe && type.record;
    const int form = isLost ? 6 : draft.random.Below(6);
    if (form == 0 && !draft.isConstant && draft.depth > 0)
    {
        Node any = MakeCast(Type().Of(Scalar::Uint), Exact(draft, Type().Of(Scalar::Int)));
        index = MakeBinary("%", std::move(any), MakeNumber(Scalar::Uint, count));
    }
    else if (form == 1 && draft.counts && !draft.isConstant)
    {
        index = MakeBinary("%", Counted(draft), MakeInteger(count));
    }
    else if (form == 2 && !draft.loops.empty())
    {
        index = MakeBinary("%", MakeName(draft.loops.back()), MakeInteger(count));
    }
    const Type element = type.Element();
    return MakeNode(Kind::Index, element, "", {std::move(node), std::move(index)});
}

/// A number in the variable, or a part of it, by chance; as far as it can be gone down to the
/// shape, that.
Node Descend(Draft& draft, Node node, const Type& wanted)
{
    while (!isSameShape(node.type, wanted) && !node.type.isScalar())
    {
        if (node.type.record && node.type.sizes.empty())
        {
            const Variable& picked = OneOf(draft, node.type.record->members);
            node = MakeNode(Kind::Member, picked.type, picked.name, {std::move(node)});
            continue;
        }
        const bool isSwizzle = node.type.isNumber() && !wanted.isMatrix() && !draft.random.OneIn(4);
        if (node.type.isNumber() && isSwizzle)
        {
            return Swizzle(draft, std::move(node), wanted);
        }
        node = Index(draft, std::move(node));
    }
    return node;
}

} // namespace

Node MakeNode(Kind kind, const Type& type, std::string text, std::vector<Node> children)
{
    return {kind, type, std::move(text), std::move(children), 0.0, nullptr};
}

Node MakeName(const Variable& variable)
{
    return MakeNode(Kind::Name, variable.type, variable.name);
}

Node MakeNumber(Scalar scalar, double number)
{
    Node node = MakeNode(Kind::Number, Type().Of(scalar), "");
    node.number = number;
    return node;
}

Node MakeInteger(int number)
{
    return MakeNumber(Scalar::Int, number);
}

Node MakeBinary(const std::string& op, Node left, Node right)
{
    const Type type = BinaryType(op, left.type, right.type);
    return MakeNode(Kind::Binary, type, op, {std::move(left), std::move(right)});
}

Node MakeCast(const Type& type, Node node)
{
    return node.type == type ? node : MakeNode(Kind::Cast, type, "", {std::move(node)});
}

Node MakeSentence(Node expression)
{
    return MakeNode(Kind::Sentence, expression.type, "", {std::move(expression)});
}

Node MakeAssign(const std::string& op, Node target, Node value)
{
    const Type type = target.type;
    return MakeNode(Kind::Assign, type, op, {std::move(target), std::move(value)});
}

bool isSameShape(const Type& a, const Type& b)
{
    return a.isNumber() && b.isNumber() && a.rows == b.rows && a.columns == b.columns;
}

std::string NewName(Draft& draft, const char* letter)
{
    return letter + std::to_string(draft.names++);
}

Scalar AnyScalar(Draft& draft)
{
    constexpr Scalar k_Weighed[] = {
        Scalar::Float, Scalar::Float, Scalar::Float, Scalar::Float,      Scalar::Int,
        Scalar::Int,   Scalar::Int,   Scalar::Uint,  Scalar::Uint,       Scalar::Bool,
        Scalar::Bool,  Scalar::Half,  Scalar::Half,  Scalar::Min16Float, Scalar::Min16Int};
    return k_Weighed[draft.random.Below(15)];
}

Type AnyNumber(Draft& draft)
{
    Type type = Type().Of(AnyScalar(draft));
    const int shape = draft.random.Below(10);
    type.columns = shape < 3 ? 1 : 2 + draft.random.Below(3);
    if (shape >= 8)
    {
        type.rows = 2 + draft.random.Below(3);
        type.scalar = isFloating(type.scalar) ? type.scalar : Scalar::Float;
    }
    return type;
}

Type AnyType(Draft& draft)
{
    Type type = AnyNumber(draft);
    const int shape = draft.random.Below(10);
    if (shape >= 8 && !draft.snippet.records.empty())
    {
        type = Type();
        type.record = OneOf(draft, draft.snippet.records);
    }
    if (shape == 6 || shape == 8)
    {
        type.sizes.push_back(2 + draft.random.Below(3));
        if (draft.random.OneIn(4))
        {
            type.sizes.push_back(2);
        }
        if (type.Parts().size() > 16)
        {
            type.sizes = {2};
        }
    }
    return type;
}

Node Counted(Draft& draft)
{
    if (!draft.counts)
    {
        return MakeInteger(1);
    }
    draft.counts = false;
    Node node = MakeNode(Kind::Call, draft.counter->type, draft.counter->name);
    node.function = draft.counter;
    return node;
}

std::optional<Node> PlaceOf(Draft& draft, const Type& shape, bool isWritten, bool hasScalar)
{
    const bool counts = draft.counts;
    for (int i = 0; i < 8 && !draft.scope.empty(); ++i)
    {
        const Variable& variable = OneOf(draft, draft.scope);
        if (isWritten && variable.mode == "const")
        {
            continue;
        }
        draft.counts = counts;
        Node node = Descend(draft, MakeName(variable), shape);
        if (isSameShape(node.type, shape) && (!hasScalar || node.type.scalar == shape.scalar))
        {
            return node;
        }
    }
    draft.counts = counts;
    return std::nullopt;
}

} // namespace limn::test::snippets
