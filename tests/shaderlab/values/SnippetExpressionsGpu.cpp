#include "values/SnippetDraft.h"

#include <algorithm>
#include <cmath>

// Expressions by chance.

namespace limn::test::snippets
{

namespace
{

/// What is computed with mostly: exact, and few bits.
constexpr double k_Numbers[] = {0, 1, 2, 3, 0.5, 0.25, 4, 1.5, -1, -2, -0.5, 5, 8, 0.75, -3, 7};

Node Literal(Draft& draft, Scalar scalar)
{
    double number = k_Numbers[draft.random.Below(16)];
    if (scalar == Scalar::Bool || scalar == Scalar::Uint)
    {
        number = std::abs(number);
    }
    if (!isFloating(scalar))
    {
        number = scalar == Scalar::Bool ? number > 1.0 : std::trunc(number) + 0.0;
    }
    if (scalar == Scalar::Min16Int || scalar == Scalar::Min16Float)
    {
        const Scalar whole = scalar == Scalar::Min16Int ? Scalar::Int : Scalar::Float;
        return MakeCast(Type().Of(scalar), MakeNumber(whole, number));
    }
    Node node = MakeNumber(scalar, number);
    node.text = scalar == Scalar::Float && draft.random.OneIn(3) ? "f" : "";
    return node;
}

Node Leaf(Draft& draft, const Type& like)
{
    const int form = draft.random.Below(8);
    if (form < 6)
    {
        if (auto place = PlaceOf(draft, like, false))
        {
            return *place;
        }
    }
    if (like.isScalar())
    {
        return Literal(draft, like.scalar);
    }
    if (form == 7)
    {
        return MakeCast(like, Literal(draft, like.scalar));
    }
    std::vector<Node> parts;
    const int count = like.columns * std::max(like.rows, 1);
    for (int i = 0; i < count; ++i)
    {
        parts.push_back(Literal(draft, like.scalar));
    }
    return MakeNode(Kind::Construct, like, "", std::move(parts));
}

Node Arithmetic(Draft& draft, const Type& like)
{
    const std::string op = OneOf(draft, {"+", "-", "*", "+", "-", "*", "/", "%"});
    Node left = Expression(draft, like);
    if (op == "/" || op == "%")
    {
        const int power = 1 + draft.random.Below(2); // of two, of which the quotient is exact
        const Scalar kind = like.scalar == Scalar::Min16Float ? Scalar::Half
                            : like.scalar < Scalar::Uint      ? Scalar::Int
                                                              : like.scalar;
        return MakeBinary(op, std::move(left), MakeNumber(kind, power * 2));
    }
    const int form = draft.random.Below(8);
    Type other = form < 2 ? like.As(1) : like;
    other.columns += form == 2 && like.isVector() && like.columns < 4 ? 1 : 0; // is cut
    Node right = Expression(draft, other);
    if (form == 3)
    {
        std::swap(left, right);
    }
    return MakeBinary(op, std::move(left), std::move(right));
}

Node Bitwise(Draft& draft, const Type& like)
{
    const Type type = like.Of(draft.random.OneIn(2) ? Scalar::Int : Scalar::Uint);
    const std::string op = OneOf(draft, {"&", "|", "^", "<<", ">>"});
    Node left = Exact(draft, type);
    Node right = op.size() == 2 ? MakeInteger(draft.random.Below(5)) : Exact(draft, type);
    if (op.size() == 2)
    {
        right = MakeCast(type.As(1), std::move(right));
    }
    return MakeBinary(op, std::move(left), std::move(right));
}

Node Ternary(Draft& draft, const Type& like)
{
    const bool isWhole = draft.random.OneIn(2);
    Node condition = Truth(draft, isWhole || like.isMatrix() ? like.As(1) : like);
    Node first = Exact(draft, like);
    Node second = draft.random.OneIn(4) ? Expression(draft, like) : Exact(draft, like);
    const Type type = Promote(first.type, second.type);
    return MakeNode(Kind::Ternary, type, "?",
                    {std::move(condition), std::move(first), std::move(second)});
}

Node Prefix(Draft& draft, const Type& like)
{
    const std::string op = like.scalar == Scalar::Bool ? "!"
                           : isFloating(like.scalar)   ? "-"
                                                       : OneOf(draft, {"-", "~"});
    Node operand =
        op == "-" && draft.random.OneIn(3) ? Expression(draft, like) : Exact(draft, like);
    const Type type = operand.type.scalar == Scalar::Bool && op == "-"
                          ? operand.type.Of(Scalar::Int)
                          : operand.type;
    return MakeNode(Kind::Prefix, type, op, {std::move(operand)});
}

Node MakeIntrinsic(const std::string& name, std::vector<Node> arguments)
{
    const Type type = IntrinsicType(name, arguments);
    return MakeNode(Kind::Intrinsic, type, name, std::move(arguments));
}

/// A function of each component.
Node Componentwise(Draft& draft, const Type& like)
{
    const bool isFloat = isFloating(like.scalar) || draft.random.OneIn(3);
    const bool isOfBits = like.scalar == Scalar::Uint && draft.random.OneIn(3);
    const std::string name =
        isOfBits  ? OneOf(draft, {"countbits", "reversebits"})
        : isFloat ? OneOf(draft, {"floor", "ceil", "trunc", "round", "frac", "saturate", "step",
                                  "lerp", "abs", "min", "max", "clamp", "mad", "sign", "fmod"})
                  : OneOf(draft, {"abs", "min", "max", "clamp", "mad", "sign"});
    static const std::map<std::string, int> s_Counts = {
        {"step", 2}, {"lerp", 3}, {"min", 2}, {"max", 2}, {"clamp", 3}, {"mad", 3}, {"fmod", 2}};
    const auto found = s_Counts.find(name);
    const int count = found == s_Counts.end() ? 1 : found->second;
    static const std::string s_OfAny = " floor ceil trunc round frac saturate ";
    const bool takesAny = s_OfAny.find(" " + name + " ") != s_OfAny.npos;
    const Scalar scalar = like.scalar == Scalar::Bool ? Scalar::Int : like.scalar;
    std::vector<Node> arguments;
    for (int i = 0; i < count; ++i)
    {
        if (name == "fmod" && i == 1)
        {
            arguments.push_back(MakeCast(like.Of(Scalar::Float), MakeNumber(Scalar::Float, 2)));
            continue;
        }
        arguments.push_back(takesAny ? Expression(draft, like) : Exact(draft, like.Of(scalar)));
    }
    Node node = MakeIntrinsic(name, std::move(arguments));
    // SPIR-V has no matrices of integers.
    return like.isMatrix() && name == "sign" ? MakeCast(like, std::move(node)) : node;
}

/// A number of several, or a vector of a matrix.
Node Reduced(Draft& draft, const Type& like)
{
    const Scalar scalar = isFloating(like.scalar) ? like.scalar : Scalar::Float;
    const int size = 2 + draft.random.Below(3);
    if (like.isVector())
    {
        const bool isLeft = draft.random.OneIn(2);
        Node matrix = Exact(draft, isLeft ? like.Of(scalar).As(like.columns, size)
                                          : like.Of(scalar).As(size, like.columns));
        Node vector = Exact(draft, like.Of(scalar).As(size));
        std::vector<Node> arguments;
        arguments.push_back(isLeft ? vector : matrix);
        arguments.push_back(isLeft ? matrix : vector);
        return MakeIntrinsic("mul", std::move(arguments));
    }
    const std::string name = like.scalar == Scalar::Bool ? OneOf(draft, {"any", "all"}) : "dot";
    std::vector<Node> arguments;
    arguments.push_back(name == "dot" ? Exact(draft, like.As(size))
                                      : Expression(draft, like.As(size)));
    if (name == "dot")
    {
        arguments.push_back(Exact(draft, like.As(size)));
    }
    return MakeIntrinsic(name, std::move(arguments));
}

Node Constructed(Draft& draft, const Type& like)
{
    std::vector<Node> parts;
    for (int left = like.columns; left > 0;)
    {
        const int size = std::min(left, 1 + draft.random.Below(3));
        parts.push_back(Expression(draft, like.As(size)));
        left -= size;
    }
    if (parts.size() == 1)
    {
        return MakeCast(like, std::move(parts[0]));
    }
    return MakeNode(Kind::Construct, like, "", std::move(parts));
}

/// A call that changes nothing.
Node Called(Draft& draft, const Type& like)
{
    for (const auto& function : draft.snippet.functions)
    {
        const bool isPure =
            std::all_of(function->parameters.begin(), function->parameters.end(),
                        [](const Variable& parameter)
                        { return parameter.mode != "out" && parameter.mode != "inout"; });
        if (isPure && function != draft.counter && isSameShape(function->type, like) &&
            !draft.random.OneIn(3))
        {
            return Call(draft, function);
        }
    }
    return Leaf(draft, like);
}

Node Number(Draft& draft, const Type& like)
{
    switch (draft.random.Below(14))
    {
    case 0:
    case 1:
        return Leaf(draft, like);
    case 2:
        return Bitwise(draft, like);
    case 3:
        return Truth(draft, like);
    case 4:
        return Ternary(draft, like);
    case 5:
        return Prefix(draft, like);
    case 6:
    case 7:
        return Componentwise(draft, like);
    case 8:
        return Reduced(draft, like);
    case 9:
        return like.isVector() ? Constructed(draft, like)
                               : MakeCast(like, Expression(draft, like.Of(AnyScalar(draft))));
    case 10:
        return Called(draft, like);
    default:
        return Arithmetic(draft, like);
    }
}

Node Matrix(Draft& draft, const Type& like)
{
    const int size = 2 + draft.random.Below(3);
    switch (draft.random.Below(9))
    {
    case 0:
        return Arithmetic(draft, like);
    case 1:
    {
        const std::string op = OneOf(draft, {"+", "-", "*"});
        Node left = Exact(draft, like);
        Node right = Exact(draft, draft.random.OneIn(2) ? like : like.As(1));
        return MakeBinary(op, std::move(left), std::move(right));
    }
    case 2:
    {
        Node left = Exact(draft, like.As(size, like.rows));
        Node right = Exact(draft, like.As(like.columns, size));
        std::vector<Node> arguments{std::move(left), std::move(right)};
        return MakeIntrinsic("mul", std::move(arguments));
    }
    case 3:
        return MakeIntrinsic("transpose", {Exact(draft, like.As(like.rows, like.columns))});
    case 4:
        return Componentwise(draft, like);
    case 5:
        return Called(draft, like);
    case 6: // is cut
        return MakeCast(like, Exact(draft, like.As(4, 4)));
    case 7:
        return Ternary(draft, like.As(like.columns, like.rows));
    default:
        return Leaf(draft, like);
    }
}

/// A variable of the type; throws Unfit if there is none.
Node Aggregate(Draft& draft, const Type& type)
{
    for (const Variable& variable : draft.scope)
    {
        if (variable.type == type)
        {
            return MakeName(variable);
        }
    }
    throw Unfit();
}

} // namespace

Node Exact(Draft& draft, const Type& type)
{
    return MakeCast(type, Expression(draft, type));
}

Node Expression(Draft& draft, const Type& like)
{
    if (draft.depth <= 0)
    {
        return Leaf(draft, like);
    }
    --draft.depth;
    Node node = like.isMatrix() ? Matrix(draft, like) : Number(draft, like);
    ++draft.depth;
    return node;
}

Node Truth(Draft& draft, const Type& like)
{
    const bool isJoined = draft.random.OneIn(3);
    const std::string op =
        isJoined ? OneOf(draft, {"&&", "||"}) : OneOf(draft, {"==", "!=", "<", "<=", ">", ">="});
    Node left = Expression(draft, isJoined ? like.Of(Scalar::Bool) : like.Of(AnyScalar(draft)));
    if (isJoined && like.isScalar() && draft.random.OneIn(3))
    {
        Node counted = MakeBinary(">", Counted(draft), MakeInteger(draft.random.Below(3)));
        return MakeBinary(op, std::move(left), std::move(counted));
    }
    Node right = Expression(draft, isJoined ? like.Of(Scalar::Bool) : like.Of(left.type.scalar));
    return MakeBinary(op, std::move(left), std::move(right));
}

Node Call(Draft& draft, const std::shared_ptr<const Function>& function)
{
    Node call = MakeNode(Kind::Call, function->type, function->name);
    call.function = function;
    for (const Variable& parameter : function->parameters)
    {
        call.children.push_back(parameter.type.isNumber() ? Exact(draft, parameter.type)
                                                          : Aggregate(draft, parameter.type));
    }
    return call;
}

} // namespace limn::test::snippets
