#include "values/Snippet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// Snippets by chance. Each draw of a random number is a statement of its own: compilers may
// evaluate the arguments of a function in any order, and all are to make the same snippets.

namespace limn::test::snippets
{

namespace
{

/// What is computed with mostly: exact, and few bits.
constexpr double k_Numbers[] = {0, 1, 2, 3, 0.5, 0.25, 4, 1.5, -1, -2, -0.5, 5, 8, 0.75, -3, 7};

Node MakeNode(Kind kind, const Type& type, std::string text, std::vector<Node> children = {})
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

const Node& RootOf(const Node& place)
{
    return place.children.empty() || place.kind == Kind::Call ? place : RootOf(place.children[0]);
}

class Generator
{
public:
    Generator(std::uint64_t seed, const std::vector<Input>& inputs, bool isLavapipe)
        : m_Random(seed),
          m_Inputs(inputs),
          m_IsLavapipe(isLavapipe),
          m_Suffix("_" + std::to_string(seed))
    {
        m_Snippet.name = "Snippet" + m_Suffix;
    }

    Snippet Make()
    {
        AddRecords();
        AddCounter();
        AddConstants();
        const int functions = m_Random.Below(3);
        for (int i = 0; i < functions; ++i)
        {
            const std::vector<Variable> outer = m_Scope;
            try
            {
                AddFunction();
            }
            catch (const Unfit&)
            {
            }
            m_Returns.reset();
            m_Scope = outer;
        }
        m_Scope.push_back({Type().As(4), "a", "const"});
        m_Scope.push_back({Type().As(4).Of(Scalar::Int), "n", "const"});
        const int statements = 4 + m_Random.Below(4);
        m_Counts = true;
        for (int i = 0; i < statements; ++i)
        {
            AddFitting();
        }
        return m_Snippet;
    }

private:
    const std::string& OneOf(const std::vector<std::string>& words)
    {
        return words[static_cast<std::size_t>(m_Random.Below(static_cast<int>(words.size())))];
    }

    std::string NewName(const char* letter) { return letter + std::to_string(m_Names++); }

    Scalar AnyScalar()
    {
        constexpr Scalar k_Weighed[] = {
            Scalar::Float, Scalar::Float, Scalar::Float, Scalar::Float,      Scalar::Int,
            Scalar::Int,   Scalar::Int,   Scalar::Uint,  Scalar::Uint,       Scalar::Bool,
            Scalar::Bool,  Scalar::Half,  Scalar::Half,  Scalar::Min16Float, Scalar::Min16Int};
        return k_Weighed[m_Random.Below(15)];
    }

    Type AnyNumber()
    {
        Type type = Type().Of(AnyScalar());
        const int shape = m_Random.Below(10);
        type.columns = shape < 3 ? 1 : 2 + m_Random.Below(3);
        if (shape >= 8)
        {
            type.rows = 2 + m_Random.Below(3);
            type.scalar = isFloating(type.scalar) ? type.scalar : Scalar::Float;
        }
        return type;
    }

    Type AnyType()
    {
        Type type = AnyNumber();
        const int shape = m_Random.Below(10);
        if (shape >= 8 && !m_Snippet.records.empty())
        {
            const int index = m_Random.Below(static_cast<int>(m_Snippet.records.size()));
            type = Type();
            type.record = m_Snippet.records[static_cast<std::size_t>(index)];
        }
        if (shape == 6 || shape == 8)
        {
            type.sizes.push_back(2 + m_Random.Below(3));
            if (m_Random.OneIn(4))
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

    void AddRecords()
    {
        const int records = m_Random.Below(3);
        for (int i = 0; i < records; ++i)
        {
            Record record{"S" + std::to_string(i) + m_Suffix, {}};
            const int members = 1 + m_Random.Below(3);
            for (int k = 0; k < members; ++k)
            {
                record.members.push_back({AnyType(), "m" + std::to_string(k), ""});
            }
            m_Snippet.records.push_back(std::make_shared<const Record>(std::move(record)));
        }
    }

    /// A function that gives another number each time: it shows how often it was called.
    void AddCounter()
    {
        const Variable counter{Type().Of(Scalar::Int), "s_Count" + m_Suffix, ""};
        m_Snippet.globals.push_back(
            MakeNode(Kind::Declare, counter.type, counter.name, {MakeInteger(0)}));
        Node value = MakeNode(Kind::Postfix, counter.type, "++", {MakeName(counter)});
        Node result = MakeNode(Kind::Return, counter.type, "", {std::move(value)});
        m_Counter = std::make_shared<const Function>(Function{
            "Count" + m_Suffix, counter.type, {}, MakeNode(Kind::Block, {}, "", {result})});
        m_Snippet.functions.push_back(m_Counter);
        m_Snippet.results.push_back(counter);
    }

    void AddConstants()
    {
        const int constants = m_Random.Below(3);
        for (int i = 0; i < constants; ++i)
        {
            Variable constant{AnyType(), NewName("k") + m_Suffix, "const"};
            m_IsConstant = true;
            m_Depth = constant.type.isNumber() ? 2 : 0;
            Node node =
                MakeNode(Kind::Declare, constant.type, constant.name, {Initial(constant.type)});
            m_IsConstant = false;
            node.number = 1.0;
            m_Snippet.globals.push_back(std::move(node));
            if (isFit())
            {
                m_Scope.push_back(std::move(constant));
            }
            else
            {
                m_Snippet.globals.pop_back();
            }
        }
    }

    // Places.

    /// A number in the variable, or a part of it, by chance; as far as it can be gone down to the
    /// shape, that.
    Node Descend(Node node, const Type& wanted)
    {
        while (!isSameShape(node.type, wanted) && !node.type.isScalar())
        {
            if (node.type.record && node.type.sizes.empty())
            {
                const auto& members = node.type.record->members;
                const int member = m_Random.Below(static_cast<int>(members.size()));
                const Variable& picked = members[static_cast<std::size_t>(member)];
                node = MakeNode(Kind::Member, picked.type, picked.name, {std::move(node)});
                continue;
            }
            const bool isSwizzle = node.type.isNumber() && !wanted.isMatrix() && !m_Random.OneIn(4);
            if (node.type.isNumber() && isSwizzle)
            {
                return Swizzle(std::move(node), wanted);
            }
            node = Index(std::move(node));
        }
        return node;
    }

    /// Distinct parts of a vector or of a matrix.
    Node Swizzle(Node node, const Type& wanted)
    {
        const Type type = node.type;
        std::vector<std::string> letters;
        const bool isFromZero = m_Random.OneIn(2);
        const std::string set = m_Random.OneIn(4) ? "rgba" : "xyzw";
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
            const int index = m_Random.Below(static_cast<int>(letters.size()));
            text += letters[static_cast<std::size_t>(index)];
            letters.erase(letters.begin() + index);
        }
        return MakeNode(Kind::Swizzle, type.As(wantedCount), text, {std::move(node)});
    }

    Node Index(Node node)
    {
        const Type type = node.type;
        const int count = !type.sizes.empty() ? type.sizes[0]
                          : type.rows > 0     ? type.rows
                                              : type.columns;
        Node index = MakeInteger(m_Random.Below(count));
        // SwiftShader loses some of what is written to a matrix in a struct in an array whose index
        // is not constant.
        const bool isLost = !m_IsLavapipe && type.record;
        const int form = isLost ? 6 : m_Random.Below(6);
        if (form == 0 && !m_IsConstant && m_Depth > 0)
        {
            Node any = MakeCast(Type().Of(Scalar::Uint), OfScalar(Scalar::Int));
            index = MakeBinary("%", std::move(any), MakeNumber(Scalar::Uint, count));
        }
        else if (form == 1 && m_Counts && !m_IsConstant)
        {
            index = MakeBinary("%", Counted(), MakeInteger(count));
        }
        else if (form == 2 && !m_Loops.empty())
        {
            index = MakeBinary("%", MakeName(m_Loops.back()), MakeInteger(count));
        }
        const Type element = type.Element();
        return MakeNode(Kind::Index, element, "", {std::move(node), std::move(index)});
    }

    /// A call of the function that counts, which is the only thing in a statement that may change
    /// something; else a number.
    Node Counted()
    {
        if (!m_Counts)
        {
            return MakeInteger(1);
        }
        m_Counts = false;
        Node node = MakeNode(Kind::Call, m_Counter->type, m_Counter->name);
        node.function = m_Counter;
        return node;
    }

    /// A part of a variable that has the shape; nothing where chance finds none.
    std::optional<Node> PlaceOf(const Type& shape, bool isWritten, bool hasScalar = false)
    {
        const std::size_t size = m_Scope.size();
        const bool counts = m_Counts;
        for (int i = 0; i < 8 && size > 0; ++i)
        {
            const Variable& variable =
                m_Scope[static_cast<std::size_t>(m_Random.Below(static_cast<int>(size)))];
            if (isWritten && variable.mode == "const")
            {
                continue;
            }
            m_Counts = counts;
            Node node = Descend(MakeName(variable), shape);
            if (isSameShape(node.type, shape) && (!hasScalar || node.type.scalar == shape.scalar))
            {
                return node;
            }
        }
        m_Counts = counts;
        return std::nullopt;
    }

    // Expressions.

    Node Literal(Scalar scalar)
    {
        double number = k_Numbers[m_Random.Below(16)];
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
        node.text = scalar == Scalar::Float && m_Random.OneIn(3) ? "f" : "";
        return node;
    }

    Node Leaf(const Type& like)
    {
        const int form = m_Random.Below(8);
        if (form < 6)
        {
            if (auto place = PlaceOf(like, false))
            {
                return *place;
            }
        }
        if (like.isScalar())
        {
            return Literal(like.scalar);
        }
        if (form == 7)
        {
            return MakeCast(like, Literal(like.scalar));
        }
        std::vector<Node> parts;
        const int count = like.columns * std::max(like.rows, 1);
        for (int i = 0; i < count; ++i)
        {
            parts.push_back(Literal(like.scalar));
        }
        return MakeNode(Kind::Construct, like, "", std::move(parts));
    }

    /// Of the kind as well.
    Node Exact(const Type& type) { return MakeCast(type, Expression(type)); }
    Node OfScalar(Scalar scalar) { return Exact(Type().Of(scalar)); }

    /// An expression of the shape; often of the kind.
    Node Expression(const Type& like)
    {
        if (m_Depth <= 0)
        {
            return Leaf(like);
        }
        --m_Depth;
        Node node = like.isMatrix() ? Matrix(like) : Number(like);
        ++m_Depth;
        return node;
    }

    Node Arithmetic(const Type& like)
    {
        const std::string op = OneOf({"+", "-", "*", "+", "-", "*", "/", "%"});
        Node left = Expression(like);
        if (op == "/" || op == "%")
        {
            const int power = 1 + m_Random.Below(2); // of two, of which the quotient is exact
            const Scalar kind = like.scalar == Scalar::Min16Float ? Scalar::Half
                                : like.scalar < Scalar::Uint      ? Scalar::Int
                                                                  : like.scalar;
            return MakeBinary(op, std::move(left), MakeNumber(kind, power * 2));
        }
        const int form = m_Random.Below(8);
        Type other = form < 2 ? like.As(1) : like;
        other.columns += form == 2 && like.isVector() && like.columns < 4 ? 1 : 0; // is cut
        Node right = Expression(other);
        if (form == 3)
        {
            std::swap(left, right);
        }
        return MakeBinary(op, std::move(left), std::move(right));
    }

    Node Bitwise(const Type& like)
    {
        const Type type = like.Of(m_Random.OneIn(2) ? Scalar::Int : Scalar::Uint);
        const std::string op = OneOf({"&", "|", "^", "<<", ">>"});
        Node left = Exact(type);
        Node right = op.size() == 2 ? MakeInteger(m_Random.Below(5)) : Exact(type);
        if (op.size() == 2)
        {
            right = MakeCast(type.As(1), std::move(right));
        }
        return MakeBinary(op, std::move(left), std::move(right));
    }

    Node Truth(const Type& like)
    {
        const bool isJoined = m_Random.OneIn(3);
        const std::string op =
            isJoined ? OneOf({"&&", "||"}) : OneOf({"==", "!=", "<", "<=", ">", ">="});
        Node left = Expression(isJoined ? like.Of(Scalar::Bool) : like.Of(AnyScalar()));
        if (isJoined && like.isScalar() && m_Random.OneIn(3))
        {
            Node counted = MakeBinary(">", Counted(), MakeInteger(m_Random.Below(3)));
            return MakeBinary(op, std::move(left), std::move(counted));
        }
        Node right = Expression(isJoined ? like.Of(Scalar::Bool) : like.Of(left.type.scalar));
        return MakeBinary(op, std::move(left), std::move(right));
    }

    Node Ternary(const Type& like)
    {
        const bool isWhole = m_Random.OneIn(2);
        Node condition = Truth(isWhole || like.isMatrix() ? like.As(1) : like);
        Node first = Exact(like);
        Node second = m_Random.OneIn(4) ? Expression(like) : Exact(like);
        const Type type = Promote(first.type, second.type);
        return MakeNode(Kind::Ternary, type, "?",
                        {std::move(condition), std::move(first), std::move(second)});
    }

    Node Prefix(const Type& like)
    {
        const std::string op = like.scalar == Scalar::Bool ? "!"
                               : isFloating(like.scalar)   ? "-"
                                                           : OneOf({"-", "~"});
        Node operand = op == "-" && m_Random.OneIn(3) ? Expression(like) : Exact(like);
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
    Node Componentwise(const Type& like)
    {
        const bool isFloat = isFloating(like.scalar) || m_Random.OneIn(3);
        const bool isOfBits = like.scalar == Scalar::Uint && m_Random.OneIn(3);
        const std::string name =
            isOfBits  ? OneOf({"countbits", "reversebits"})
            : isFloat ? OneOf({"floor", "ceil", "trunc", "round", "frac", "saturate", "step",
                               "lerp", "abs", "min", "max", "clamp", "mad", "sign", "fmod"})
                      : OneOf({"abs", "min", "max", "clamp", "mad", "sign"});
        static const std::map<std::string, int> s_Counts = {{"step", 2}, {"lerp", 3},  {"min", 2},
                                                            {"max", 2},  {"clamp", 3}, {"mad", 3},
                                                            {"fmod", 2}};
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
            arguments.push_back(takesAny ? Expression(like) : Exact(like.Of(scalar)));
        }
        Node node = MakeIntrinsic(name, std::move(arguments));
        // SPIR-V has no matrices of integers.
        return like.isMatrix() && name == "sign" ? MakeCast(like, std::move(node)) : node;
    }

    /// A number of several, or a vector of a matrix.
    Node Reduced(const Type& like)
    {
        const Scalar scalar = isFloating(like.scalar) ? like.scalar : Scalar::Float;
        const int size = 2 + m_Random.Below(3);
        if (like.isVector())
        {
            const bool isLeft = m_Random.OneIn(2);
            Node matrix = Exact(isLeft ? like.Of(scalar).As(like.columns, size)
                                       : like.Of(scalar).As(size, like.columns));
            Node vector = Exact(like.Of(scalar).As(size));
            std::vector<Node> arguments;
            arguments.push_back(isLeft ? vector : matrix);
            arguments.push_back(isLeft ? matrix : vector);
            return MakeIntrinsic("mul", std::move(arguments));
        }
        const std::string name = like.scalar == Scalar::Bool ? OneOf({"any", "all"}) : "dot";
        std::vector<Node> arguments;
        arguments.push_back(name == "dot" ? Exact(like.As(size)) : Expression(like.As(size)));
        if (name == "dot")
        {
            arguments.push_back(Exact(like.As(size)));
        }
        return MakeIntrinsic(name, std::move(arguments));
    }

    Node Constructed(const Type& like)
    {
        std::vector<Node> parts;
        for (int left = like.columns; left > 0;)
        {
            const int size = std::min(left, 1 + m_Random.Below(3));
            parts.push_back(Expression(like.As(size)));
            left -= size;
        }
        if (parts.size() == 1)
        {
            return MakeCast(like, std::move(parts[0]));
        }
        return MakeNode(Kind::Construct, like, "", std::move(parts));
    }

    /// A call that changes nothing.
    Node Called(const Type& like)
    {
        for (const auto& function : m_Snippet.functions)
        {
            const bool isPure =
                std::all_of(function->parameters.begin(), function->parameters.end(),
                            [](const Variable& parameter)
                            { return parameter.mode != "out" && parameter.mode != "inout"; });
            if (isPure && function != m_Counter && isSameShape(function->type, like) &&
                !m_Random.OneIn(3))
            {
                return Call(function);
            }
        }
        return Leaf(like);
    }

    Node Number(const Type& like)
    {
        switch (m_Random.Below(14))
        {
        case 0:
        case 1:
            return Leaf(like);
        case 2:
            return Bitwise(like);
        case 3:
            return Truth(like);
        case 4:
            return Ternary(like);
        case 5:
            return Prefix(like);
        case 6:
        case 7:
            return Componentwise(like);
        case 8:
            return Reduced(like);
        case 9:
            return like.isVector() ? Constructed(like)
                                   : MakeCast(like, Expression(like.Of(AnyScalar())));
        case 10:
            return Called(like);
        default:
            return Arithmetic(like);
        }
    }

    Node Matrix(const Type& like)
    {
        const int size = 2 + m_Random.Below(3);
        switch (m_Random.Below(9))
        {
        case 0:
            return Arithmetic(like);
        case 1:
        {
            const std::string op = OneOf({"+", "-", "*"});
            Node left = Exact(like);
            Node right = Exact(m_Random.OneIn(2) ? like : like.As(1));
            return MakeBinary(op, std::move(left), std::move(right));
        }
        case 2:
        {
            Node left = Exact(like.As(size, like.rows));
            Node right = Exact(like.As(like.columns, size));
            std::vector<Node> arguments{std::move(left), std::move(right)};
            return MakeIntrinsic("mul", std::move(arguments));
        }
        case 3:
            return MakeIntrinsic("transpose", {Exact(like.As(like.rows, like.columns))});
        case 4:
            return Componentwise(like);
        case 5:
            return Called(like);
        case 6: // is cut
            return MakeCast(like, Exact(like.As(4, 4)));
        case 7:
            return Ternary(like.As(like.columns, like.rows));
        default:
            return Leaf(like);
        }
    }

    // Initial values.

    /// A list for what has this many numbers, of which brackets may stand around any.
    Node List(const Type& type)
    {
        Node list = MakeNode(Kind::List, type, "");
        m_Depth = std::min(m_Depth, 1);
        const bool isGrouped = !type.isNumber() && m_Random.OneIn(2);
        for (std::size_t i = 0; isGrouped && i < CountChildren(type); ++i)
        {
            const Type& member = type.sizes.empty() ? type.record->members[i].type : type.Element();
            const bool isList = !member.isNumber() || m_Random.OneIn(3);
            list.children.push_back(isList ? List(member) : Exact(member));
        }
        const std::vector<Scalar> parts = type.Parts();
        for (std::size_t i = 0; !isGrouped && i < parts.size();)
        {
            const auto left = static_cast<int>(parts.size() - i);
            const int size = std::min(left, 1 + m_Random.Below(4));
            list.children.push_back(Exact(Type().Of(parts[i]).As(size)));
            i += static_cast<std::size_t>(size);
        }
        return list;
    }
    static std::size_t CountChildren(const Type& type)
    {
        return type.sizes.empty() ? type.record->members.size()
                                  : static_cast<std::size_t>(type.sizes[0]);
    }

    Node Initial(const Type& type)
    {
        const int form = m_Random.Below(6);
        if (type.isNumber())
        {
            return form == 0 && !type.isScalar() ? List(type)
                   : form == 1 && type.isVector() && type.columns < 4
                       ? Expression(type.As(type.columns + 1))
                   : form == 2 && type.isVector() ? Exact(type.As(1))
                                                  : Expression(type);
        }
        const bool isCast = form == 0 && type.sizes.empty() && !m_IsConstant;
        if (isCast)
        {
            return MakeCast(type, MakeInteger(m_Random.Below(3)));
        }
        for (const Variable& variable : m_Scope)
        {
            if (variable.type == type && form < 3 && !m_IsConstant)
            {
                return MakeName(variable);
            }
        }
        return List(type);
    }

    // Functions.

    Node Call(const std::shared_ptr<const Function>& function)
    {
        Node call = MakeNode(Kind::Call, function->type, function->name);
        call.function = function;
        for (const Variable& parameter : function->parameters)
        {
            call.children.push_back(parameter.type.isNumber() ? Exact(parameter.type)
                                                              : Aggregate(parameter.type));
        }
        return call;
    }

    /// A variable of the type, or zeros.
    Node Aggregate(const Type& type)
    {
        for (const Variable& variable : m_Scope)
        {
            if (variable.type == type)
            {
                return MakeName(variable);
            }
        }
        throw Unfit();
    }

    /// A statement that calls a function which gives something back by its parameters.
    Node CallWithOutputs()
    {
        const int index = m_Random.Below(static_cast<int>(m_Snippet.functions.size()));
        const auto function = m_Snippet.functions[static_cast<std::size_t>(index)];
        Node call = Call(function);
        std::vector<std::string> roots;
        for (std::size_t i = 0; i < call.children.size(); ++i)
        {
            const Variable& parameter = function->parameters[i];
            if (parameter.mode != "out" && parameter.mode != "inout")
            {
                continue;
            }
            auto place = PlaceOf(parameter.type, true, !m_Random.OneIn(4));
            const std::string root = place ? RootOf(*place).text : "";
            if (root.empty() || std::find(roots.begin(), roots.end(), root) != roots.end())
            {
                throw Unfit();
            }
            roots.push_back(root);
            call.children[i] = *place;
        }
        return function->type.columns == 0 ? MakeSentence(call) : Declare(function->type, call);
    }

    void AddFunction()
    {
        m_Depth = 1;
        Function function;
        const bool isOverload = m_Snippet.functions.size() > 1 && m_Random.OneIn(2);
        function.name = isOverload ? m_Snippet.functions.back()->name : NewName("F") + m_Suffix;
        function.type = AnyNumber();
        if (m_Random.OneIn(6))
        {
            function.type.columns = 0;
            function.type.rows = 0;
        }
        const int parameters = 1 + m_Random.Below(3);
        Node body = MakeNode(Kind::Block, {}, "");
        for (int i = 0; i < parameters; ++i)
        {
            const std::string mode = OneOf({"", "", "in", "out", "inout"});
            const bool isInput = mode.size() < 3;
            function.parameters.push_back({isInput ? AnyType() : AnyNumber(), NewName("p"), mode});
        }
        for (const Variable& parameter : function.parameters)
        {
            if (parameter.mode == "out")
            {
                Node value = Exact(parameter.type);
                body.children.push_back(
                    MakeSentence(MakeAssign("=", MakeName(parameter), std::move(value))));
            }
            m_Scope.push_back({parameter.type, parameter.name, ""});
        }
        m_Returns = function.type;
        const int statements = 1 + m_Random.Below(3);
        for (int i = 0; i < statements; ++i)
        {
            AddStatement(body);
        }
        if (function.type.columns > 0)
        {
            body.children.push_back(Return());
        }
        function.body = std::move(body);
        const bool isNew =
            std::none_of(m_Snippet.functions.begin(), m_Snippet.functions.end(),
                         [&](const auto& other) { return isClose(*other, function); });
        if (isNew)
        {
            m_Snippet.functions.push_back(std::make_shared<const Function>(std::move(function)));
        }
    }

    /// Whether a call may mean either of them, as kinds of numbers that are one to the compiler.
    static bool isClose(const Function& a, const Function& b)
    {
        bool isClose = a.name == b.name && a.parameters.size() == b.parameters.size();
        for (std::size_t i = 0; isClose && i < a.parameters.size(); ++i)
        {
            const Type& x = a.parameters[i].type;
            const Type& y = b.parameters[i].type;
            isClose = x.record == y.record && x.rows == y.rows && x.columns == y.columns &&
                      x.sizes == y.sizes && isFloating(x.scalar) == isFloating(y.scalar);
        }
        return isClose;
    }

    Node Return()
    {
        Node value = Expression(*m_Returns);
        return MakeNode(Kind::Return, *m_Returns, "", {std::move(value)});
    }

    // Statements.

    Node Declare(const Type& type, Node value)
    {
        const std::string name = NewName("v");
        m_Scope.push_back({type, name, ""});
        return MakeNode(Kind::Declare, type, name, {std::move(value)});
    }

    Node Assign()
    {
        const Type shape = AnyNumber();
        auto place = PlaceOf(shape, true);
        if (!place)
        {
            const Type type = AnyType();
            Node value = Initial(type);
            return Declare(type, std::move(value));
        }
        const Type type = place->type;
        const std::string op = type.scalar == Scalar::Bool ? OneOf({"=", "=", "&=", "|=", "^="})
                               : isFloating(type.scalar)
                                   ? OneOf({"=", "=", "=", "+=", "-=", "*="})
                                   : OneOf({"=", "=", "+=", "-=", "*=", "&=", "|=", "^=", "<<="});
        const int form = m_Random.Below(8);
        const Scalar kind =
            op.size() > 1 && op.find_first_of("&|^<") == 0 ? type.scalar : Scalar::Float;
        Node value = op == "<<="                    ? MakeInteger(m_Random.Below(4))
                     : form == 0 && type.isVector() ? Expression(type.As(1))
                     : form == 1 && type.columns == 3 && type.isVector() ? Expression(type.As(4))
                                                                         : Expression(type);
        if (kind == type.scalar || m_Random.OneIn(2))
        {
            value = MakeCast(value.type.Of(type.scalar), value);
        }
        return MakeSentence(MakeAssign(op, std::move(*place), std::move(value)));
    }

    Node Step()
    {
        const int columns = 1 + m_Random.Below(3);
        const Type shape = Type().As(columns).Of(m_Random.OneIn(2) ? Scalar::Int : Scalar::Float);
        auto place = PlaceOf(shape, true);
        if (!place || place->type.scalar == Scalar::Bool)
        {
            throw Unfit();
        }
        const Kind kind = m_Random.OneIn(2) ? Kind::Prefix : Kind::Postfix;
        const Type type = place->type;
        Node step = MakeNode(kind, type, OneOf({"++", "--"}), {std::move(*place)});
        return m_Random.OneIn(2) ? MakeSentence(std::move(step)) : Declare(type, std::move(step));
    }

    Node Block(Node first = MakeNode(Kind::Block, {}, ""))
    {
        const std::vector<Variable> outer = m_Scope;
        const int statements = 1 + m_Random.Below(2);
        for (int i = 0; i < statements; ++i)
        {
            AddStatement(first);
        }
        m_Scope = outer;
        return first;
    }

    Node Condition() { return m_Random.OneIn(4) ? OfScalar(AnyScalar()) : Truth(Type()); }

    Node If()
    {
        Node condition = Condition();
        Node node = MakeNode(Kind::If, {}, "", {std::move(condition), Block()});
        if (m_Random.OneIn(2))
        {
            node.children.push_back(Block());
        }
        if (m_Returns && m_Random.OneIn(4))
        {
            m_Counts = false;
            Node& block = node.children[1];
            block.children.push_back(m_Returns->columns > 0 ? Return()
                                                            : MakeNode(Kind::Return, {}, ""));
        }
        return node;
    }

    /// Leaves the loop or goes on with it, sometimes.
    Node Jump(const Variable& counter)
    {
        const int limit = m_Random.Below(3);
        // lavapipe 22.3.6 runs loops wrongly that end by two conditions on one counter: what they
        // change has not changed behind them, or they run 65535 times.
        const bool isOther = m_Random.OneIn(2) || m_IsLavapipe;
        Node condition =
            isOther ? Truth(Type()) : MakeBinary("==", MakeName(counter), MakeInteger(limit));
        const Kind kind = m_Random.OneIn(2) ? Kind::Break : Kind::Continue;
        Node block = MakeNode(Kind::Block, {}, "", {MakeNode(kind, {}, "")});
        return MakeNode(Kind::If, {}, "", {std::move(condition), std::move(block)});
    }

    Node Loop()
    {
        const Variable counter{Type().Of(Scalar::Int), NewName("i"), "const"};
        const bool isFor = m_Random.OneIn(2);
        const bool isDo = m_Random.OneIn(2);
        const int limit = 1 + m_Random.Below(4);
        const std::vector<Variable> outer = m_Scope;
        m_Scope.push_back(counter);
        m_Loops.push_back(counter);
        Node start = MakeNode(Kind::Declare, counter.type, counter.name, {MakeInteger(0)});
        Node step = MakeNode(m_Random.OneIn(2) ? Kind::Prefix : Kind::Postfix, counter.type, "++",
                             {MakeName(counter)});
        Node condition = MakeBinary("<", MakeName(counter), MakeInteger(limit));
        Node body = MakeNode(Kind::Block, {}, "");
        if (!isFor)
        {
            body.children.push_back(MakeSentence(step));
        }
        if (m_Random.OneIn(2))
        {
            AddStatement(body);
        }
        if (m_Random.OneIn(2))
        {
            m_Counts = false;
            body.children.push_back(Jump(counter));
        }
        body = Block(std::move(body));
        m_Loops.pop_back();
        m_Scope = outer;
        if (isFor)
        {
            return MakeNode(Kind::For, {}, "", {start, condition, step, body});
        }
        Node loop = isDo ? MakeNode(Kind::Do, {}, "", {body, condition})
                         : MakeNode(Kind::While, {}, "", {condition, body});
        return MakeNode(Kind::Block, {}, "", {start, loop});
    }

    Node Switch()
    {
        Node value = MakeBinary("&", OfScalar(Scalar::Int), MakeInteger(3));
        Node node = MakeNode(Kind::Switch, {}, "", {std::move(value)});
        const int cases = 1 + m_Random.Below(3);
        for (int i = 0; i < cases; ++i)
        {
            Node block = Block();
            block.kind = Kind::Case;
            block.text = "case " + std::to_string(i);
            block.number = i;
            node.children.push_back(std::move(block));
        }
        Node block = Block();
        block.kind = Kind::Case;
        block.text = "default";
        node.children.push_back(std::move(block));
        return node;
    }

    Node Statement()
    {
        const int form = m_Random.Below(m_Nested < 2 ? 13 : 8);
        if (form < 3)
        {
            const Type type = AnyType();
            Node value = Initial(type);
            return Declare(type, std::move(value));
        }
        ++m_Nested;
        Node node = form < 6    ? Assign()
                    : form == 6 ? Step()
                    : form == 7 ? CallWithOutputs()
                    : form < 10 ? If()
                    : form < 12 ? Loop()
                                : Switch();
        --m_Nested;
        return node;
    }

    /// Adds a statement unless chance got stuck.
    void AddStatement(Node& block)
    {
        const std::vector<Variable> scope = m_Scope;
        const std::vector<Variable> loops = m_Loops;
        const int nested = m_Nested;
        m_Depth = m_Random.OneIn(4) ? 2 : 1;
        m_Counts = !m_Returns;
        try
        {
            block.children.push_back(Statement());
        }
        catch (const Unfit&)
        {
            m_Scope = scope;
            m_Loops = loops;
            m_Nested = nested;
        }
    }

    /// Adds a statement to the snippet for which all its values are fit, if a few tries find one.
    void AddFitting()
    {
        const std::vector<Variable> scope = m_Scope;
        const std::vector<Variable> results = m_Snippet.results;
        for (int i = 0; i < 10; ++i)
        {
            const std::size_t before = m_Snippet.body.children.size();
            AddStatement(m_Snippet.body);
            m_Snippet.results.insert(m_Snippet.results.end(),
                                     m_Scope.begin() + static_cast<std::ptrdiff_t>(scope.size()),
                                     m_Scope.end());
            if (m_Snippet.body.children.size() > before && isFit())
            {
                return;
            }
            m_Snippet.body.children.resize(before);
            m_Snippet.results = results;
            m_Scope = scope;
        }
    }

    bool isFit() const
    {
        try
        {
            for (const Input& input : m_Inputs)
            {
                Interpret(m_Snippet, input);
            }
            return true;
        }
        catch (const Unfit&)
        {
            return false;
        }
    }

    Random m_Random;
    const std::vector<Input>& m_Inputs;
    bool m_IsLavapipe;
    std::string m_Suffix;
    Snippet m_Snippet;
    std::vector<Variable> m_Scope;
    std::vector<Variable> m_Loops; ///< their counters
    std::shared_ptr<const Function> m_Counter;
    std::optional<Type> m_Returns; ///< what the function does that is made
    int m_Names = 0;
    int m_Depth = 0;
    int m_Nested = 0;
    bool m_Counts = false;     ///< whether the statement may still call the counting function
    bool m_IsConstant = false; ///< whether only what is constant may stand
};

} // namespace

Snippet Generate(std::uint64_t seed, const std::vector<Input>& inputs, bool isLavapipe)
{
    return Generator(seed, inputs, isLavapipe).Make();
}

} // namespace limn::test::snippets
