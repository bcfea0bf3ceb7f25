#include "values/Snippet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numeric>

// What a snippet's values are, worked out in double. Every one must be exact in the fewest bits
// that its type may have, so that nothing is ever rounded and there is nothing to tolerate.

namespace limn::test::snippets
{

namespace
{

double RequireExact(double x, int bits, int smallest, int largest)
{
    int exponent = 0;
    const double scaled = std::ldexp(std::frexp(x, &exponent), bits);
    if (x != 0.0 && (!std::isfinite(x) || scaled != std::floor(scaled) || exponent < smallest ||
                     exponent > largest))
    {
        throw Unfit();
    }
    return x + 0.0;
}

std::uint32_t Bits(double x)
{
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(x));
}

/// Cuts a whole number to what an integer holds, and requires of other numbers that they are held.
double Fit(Scalar scalar, double x)
{
    switch (scalar)
    {
    case Scalar::Bool:
        return x != 0.0 ? 1.0 : 0.0;
    case Scalar::Int:
        return static_cast<std::int32_t>(Bits(x));
    case Scalar::Uint:
        return Bits(x);
    case Scalar::Min16Int:
        return RequireExact(x, 15, 1, 15);
    case Scalar::Half:
    case Scalar::Min16Float:
        return RequireExact(x, 11, -10, 15);
    default:
        return RequireExact(x, 22, -16, 22);
    }
}

double Convert(Scalar from, Scalar to, double x)
{
    if (isFloating(from) && !isFloating(to) && to != Scalar::Bool)
    {
        x = std::trunc(x);
        if (std::abs(x) > 0x1p30 || (to == Scalar::Uint && x < 0.0))
        {
            throw Unfit();
        }
    }
    return Fit(to, x);
}

Numbers Convert(const Type& from, const Type& to, const Numbers& numbers)
{
    const std::vector<Scalar> given = from.Parts();
    const std::vector<Scalar> wanted = to.Parts();
    Numbers result;
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        std::size_t k = from.isScalar() ? 0 : i;
        if (from.isMatrix() && to.isMatrix()) // it may be cut
        {
            const auto columns = static_cast<std::size_t>(to.columns);
            k = i / columns * static_cast<std::size_t>(from.columns) + i % columns;
        }
        result.push_back(Convert(given.at(k), wanted[i], numbers.at(k)));
    }
    return result;
}

double RequirePower(double x)
{
    int exponent = 0;
    if (std::abs(std::frexp(x, &exponent)) != 0.5) // of two, so that its reciprocal is exact
    {
        throw Unfit();
    }
    return x;
}

double Calculate(const std::string& op, Scalar scalar, double x, double y)
{
    const bool isFloat = isFloating(scalar);
    const auto shift = static_cast<std::uint32_t>(Bits(y) & 31u);
    if (op == "/" || op == "%")
    {
        if (y == 0.0)
        {
            throw Unfit();
        }
        const double quotient = isFloat ? Fit(scalar, x / RequirePower(y)) : std::trunc(x / y);
        return op == "/" ? quotient : Fit(scalar, x - Fit(scalar, std::trunc(quotient) * y));
    }
    static const std::map<std::string, std::function<double(double, double)>> s_Operators = {
        {"+", std::plus<>()},
        {"-", std::minus<>()},
        {"==", std::equal_to<>()},
        {"!=", std::not_equal_to<>()},
        {"<", std::less<>()},
        {"<=", std::less_equal<>()},
        {">", std::greater<>()},
        {">=", std::greater_equal<>()},
        {"&&",
         [](double a, double b)
         {
             return a != 0.0 && b != 0.0;
         }},
        {"||",
         [](double a, double b)
         {
             return a != 0.0 || b != 0.0;
         }},
        {"&",
         [](double a, double b)
         {
             return Bits(a) & Bits(b);
         }},
        {"|",
         [](double a, double b)
         {
             return Bits(a) | Bits(b);
         }},
        {"^",
         [](double a, double b)
         {
             return Bits(a) ^ Bits(b);
         }},
    };
    if (op == "*")
    {
        return Fit(scalar, isFloat || scalar == Scalar::Min16Int ? x * y : Bits(x) * Bits(y));
    }
    if (op == "<<" || op == ">>")
    {
        const double shifted = op == "<<" ? x * std::ldexp(1.0, static_cast<int>(shift))
                                          : std::floor(std::ldexp(x, -static_cast<int>(shift)));
        return Fit(scalar, shifted);
    }
    return s_Operators.at(op)(x, y);
}

/// An operator's value; the operands become what they have in common before.
Numbers Calculate(const std::string& op, const Type& left, const Numbers& x, const Type& right,
                  const Numbers& y)
{
    const Type type = BinaryType(op, left, right);
    const bool isLogical = op == "&&" || op == "||";
    const bool isOrder = type.scalar == Scalar::Bool && !isLogical;
    const Type common = isOrder ? Promote(left, right) : type;
    const Numbers a = Convert(left, common, x);
    const Numbers b = Convert(right, common, y);
    Numbers result;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        result.push_back(Fit(type.scalar, Calculate(op, common.scalar, a[i], b[i])));
    }
    return result;
}

double ReverseBits(double x)
{
    std::uint32_t result = 0;
    for (int i = 0; i < 32; ++i)
    {
        result |= ((Bits(x) >> i) & 1u) << (31 - i);
    }
    return result;
}

/// A function that works on each component.
double Component(const std::string& name, Scalar scalar, const Numbers& v)
{
    static const std::map<std::string, double (*)(double)> s_Simple = {
        {"abs",
         [](double x)
         {
             return std::abs(x);
         }},
        {"floor",
         [](double x)
         {
             return std::floor(x);
         }},
        {"ceil",
         [](double x)
         {
             return std::ceil(x);
         }},
        {"trunc",
         [](double x)
         {
             return std::trunc(x);
         }},
        {"round",
         [](double x)
         {
             return std::nearbyint(x);
         }},
        {"frac",
         [](double x)
         {
             return x - std::floor(x);
         }},
        {"sign",
         [](double x) -> double
         {
             return (x > 0.0) - (x < 0.0);
         }},
        {"saturate",
         [](double x)
         {
             return std::clamp(x, 0.0, 1.0);
         }},
        {"countbits",
         [](double x) -> double
         {
             return std::popcount(Bits(x));
         }},
        {"reversebits", ReverseBits},
    };
    if (const auto found = s_Simple.find(name); found != s_Simple.end())
    {
        return Fit(scalar, found->second(v[0]));
    }
    const auto calculate = [&](const char* op, double x, double y)
    {
        return Fit(scalar, Calculate(op, scalar, x, y));
    };
    if (name == "lerp") // drivers have two formulas
    {
        calculate("+", calculate("*", v[0], calculate("-", 1.0, v[2])), calculate("*", v[1], v[2]));
        return calculate("+", v[0], calculate("*", v[2], calculate("-", v[1], v[0])));
    }
    if (name == "clamp" && v[1] > v[2])
    {
        throw Unfit();
    }
    return name == "min"    ? std::min(v[0], v[1])
           : name == "max"  ? std::max(v[0], v[1])
           : name == "step" ? Fit(scalar, v[1] >= v[0])
           : name == "fmod" ? calculate("%", v[0], v[1])
           : name == "mad"  ? calculate("+", calculate("*", v[0], v[1]), v[2])
                            : std::clamp(v[0], v[1], v[2]);
}

/// The sum of products, which is exact in whichever order they are added.
double Dot(Scalar scalar, const Numbers& x, const Numbers& y)
{
    double sum = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        const double product = Calculate("*", scalar, x[i], y[i]);
        sum = Fit(scalar, sum + product);
        all = Fit(scalar, all + std::abs(product));
    }
    return sum;
}

Numbers Multiply(const Type& left, const Numbers& x, const Type& right, const Numbers& y,
                 Scalar scalar)
{
    const int rows = left.isMatrix() ? left.rows : 1;
    const int inner = left.columns;
    const int columns = right.isMatrix() ? right.columns : 1;
    Numbers result;
    for (int row = 0; row < rows; ++row)
    {
        for (int column = 0; column < columns; ++column)
        {
            Numbers a;
            Numbers b;
            for (int k = 0; k < inner; ++k)
            {
                a.push_back(x.at(static_cast<std::size_t>(row * inner + k)));
                b.push_back(y.at(static_cast<std::size_t>(k * columns + column)));
            }
            result.push_back(Dot(scalar, a, b));
        }
    }
    return result;
}

/// Where the letters of a swizzle are.
Numbers Letters(const Type& type, const std::string& text)
{
    Numbers offsets;
    if (!type.isMatrix())
    {
        for (const char letter : text)
        {
            const std::size_t place = std::string("xyzwrgba").find(letter);
            offsets.push_back(static_cast<double>(place % 4));
        }
        return offsets;
    }
    const bool isFromZero = text[1] == 'm';
    for (std::size_t i = isFromZero ? 2 : 1; i < text.size(); i += isFromZero ? 4 : 3)
    {
        const int base = isFromZero ? '0' : '1';
        offsets.push_back((text[i] - base) * type.columns + text[i + 1] - base);
    }
    return offsets;
}

/// Numbers of a variable, which are read and written.
struct Place
{
    Numbers* numbers = nullptr;
    std::vector<std::size_t> at;

    Numbers Read() const
    {
        Numbers result;
        for (const std::size_t index : at)
        {
            result.push_back(numbers->at(index));
        }
        return result;
    }
    void Write(const Numbers& values) const
    {
        for (std::size_t i = 0; i < at.size(); ++i)
        {
            numbers->at(at[i]) = values.at(i);
        }
    }
};

enum class Flow : std::uint8_t
{
    Next,
    Break,
    Continue,
    Return,
};

using Frame = std::map<std::string, Numbers>;

class Interpreter
{
public:
    Numbers Run(const Snippet& snippet, const Input& input)
    {
        for (const Node& global : snippet.globals)
        {
            m_Globals[global.text] = ConvertedTo(global.type, global.children[0]);
        }
        m_Frame["a"] = input.floats;
        m_Frame["n"] = input.integers;
        for (const Node& statement : snippet.body.children)
        {
            Execute(statement);
        }
        Numbers results;
        for (const Variable& result : snippet.results)
        {
            const Numbers& numbers = *Find(result.name);
            results.insert(results.end(), numbers.begin(), numbers.end());
        }
        return results;
    }

private:
    Numbers* Find(const std::string& name)
    {
        const auto found = m_Frame.find(name);
        return found != m_Frame.end() ? &found->second : &m_Globals.at(name);
    }

    Numbers ConvertedTo(const Type& type, const Node& node)
    {
        const Numbers given = Evaluate(node);
        return node.type == type ? given : Convert(node.type, type, given);
    }

    bool isTrue(const Node& node) { return Evaluate(node)[0] != 0.0; }

    /// What a member, an index or a swizzle picks of the numbers before it.
    std::vector<std::size_t> Picked(const Node& node)
    {
        const Type& type = node.children[0].type;
        std::size_t begin = 0;
        std::vector<std::size_t> picked(node.type.Parts().size());
        if (node.kind == Kind::Swizzle)
        {
            const Numbers letters = Letters(type, node.text);
            picked.assign(letters.begin(), letters.end());
            return picked;
        }
        if (node.kind == Kind::Index)
        {
            const double index = Evaluate(node.children[1])[0];
            if (index < 0.0 || (index + 1.0) * static_cast<double>(picked.size()) >
                                   static_cast<double>(type.Parts().size()))
            {
                throw Unfit();
            }
            begin = static_cast<std::size_t>(index) * picked.size();
        }
        for (std::size_t i = 0; node.kind == Kind::Member; ++i)
        {
            const Variable& member = type.record->members.at(i);
            if (member.name == node.text)
            {
                break;
            }
            begin += member.type.Parts().size();
        }
        std::iota(picked.begin(), picked.end(), begin);
        return picked;
    }

    Place Locate(const Node& node)
    {
        Place place;
        if (node.kind == Kind::Name)
        {
            place.numbers = Find(node.text);
            place.at.resize(place.numbers->size());
            std::iota(place.at.begin(), place.at.end(), std::size_t{0});
            return place;
        }
        const Place whole = Locate(node.children.at(0));
        place.numbers = whole.numbers;
        for (const std::size_t index : Picked(node))
        {
            place.at.push_back(whole.at.at(index));
        }
        return place;
    }

    Numbers Evaluate(const Node& node)
    {
        if (++m_Steps > 50000)
        {
            throw Unfit();
        }
        switch (node.kind)
        {
        case Kind::Number:
            return {Fit(node.type.scalar, node.number)};
        case Kind::Name:
            return *Find(node.text);
        case Kind::Member:
        case Kind::Swizzle:
        case Kind::Index:
        {
            Numbers whole = Evaluate(node.children[0]);
            return Place{&whole, Picked(node)}.Read();
        }
        case Kind::Cast:
            return Convert(node.children[0].type, node.type, Evaluate(node.children[0]));
        case Kind::Construct:
        case Kind::List:
            return Convert(node);
        case Kind::Intrinsic:
            return CallIntrinsic(node);
        case Kind::Call:
            return Call(node);
        case Kind::Ternary:
            return Choose(node);
        default:
            return Operate(node);
        }
    }

    /// The numbers of a list or of a constructor, one behind the other.
    Numbers Convert(const Node& list)
    {
        const std::vector<Scalar> wanted = list.type.Parts();
        Numbers result;
        for (const Node& item : list.children)
        {
            const Numbers numbers = Evaluate(item);
            const std::vector<Scalar> given = item.type.Parts();
            for (std::size_t i = 0; i < numbers.size(); ++i)
            {
                const Scalar scalar = wanted.at(result.size());
                result.push_back(snippets::Convert(given.at(i), scalar, numbers[i]));
            }
        }
        return result;
    }
    static Numbers Convert(const Type& from, const Type& to, const Numbers& numbers)
    {
        return snippets::Convert(from, to, numbers);
    }

    /// HLSL works out both values, as it does of && and ||: none of them is an order to branch.
    Numbers Choose(const Node& node)
    {
        const Node& condition = node.children[0];
        const Numbers chosen =
            Convert(condition.type, node.type.Of(Scalar::Bool), Evaluate(condition));
        const Numbers first = ConvertedTo(node.type, node.children[1]);
        Numbers result = ConvertedTo(node.type, node.children[2]);
        for (std::size_t i = 0; i < result.size(); ++i)
        {
            result[i] = chosen[i] != 0.0 ? first[i] : result[i];
        }
        return result;
    }

    Numbers Step(const Node& node)
    {
        const Place place = Locate(node.children[0]);
        const Numbers before = place.Read();
        const Numbers after =
            Convert(BinaryType("+", node.type, Type{Scalar::Bool}), node.type,
                    Calculate(node.text.substr(1), node.type, before, Type{Scalar::Bool}, {1.0}));
        place.Write(after);
        return node.kind == Kind::Prefix ? after : before;
    }

    Numbers Operate(const Node& node)
    {
        const Node& first = node.children[0];
        if (node.text == "++" || node.text == "--")
        {
            return Step(node);
        }
        if (node.kind == Kind::Prefix)
        {
            Numbers result = ConvertedTo(node.type, first);
            for (double& x : result)
            {
                x = Fit(node.type.scalar, node.text == "-"   ? -x
                                          : node.text == "!" ? 1.0 - x
                                                             : -1.0 - x);
            }
            return result;
        }
        if (node.kind == Kind::Assign)
        {
            return Assign(node);
        }
        const Numbers x = Evaluate(first);
        return Calculate(node.text, first.type, x, node.children[1].type,
                         Evaluate(node.children[1]));
    }

    Numbers Assign(const Node& node)
    {
        const Node& target = node.children[0];
        const Node& source = node.children[1];
        if (node.text == "=")
        {
            const Numbers given = ConvertedTo(target.type, source);
            Locate(target).Write(given);
            return given;
        }
        const std::string op = node.text.substr(0, node.text.size() - 1);
        const Numbers given = Evaluate(source);
        const Place place = Locate(target);
        const Numbers result =
            Convert(BinaryType(op, target.type, source.type), target.type,
                    Calculate(op, target.type, place.Read(), source.type, given));
        place.Write(result);
        return result;
    }

    Numbers CallIntrinsic(const Node& node)
    {
        std::vector<Numbers> given;
        Type all = node.children[0].type;
        for (const Node& argument : node.children)
        {
            given.push_back(Evaluate(argument));
            all = Promote(all, argument.type);
        }
        const Type& first = node.children[0].type;
        if (node.text == "any" || node.text == "all")
        {
            const auto count = std::count(given[0].begin(), given[0].end(), 0.0);
            const auto size = static_cast<std::ptrdiff_t>(given[0].size());
            return {(node.text == "any" ? count < size : count == 0) ? 1.0 : 0.0};
        }
        if (node.text == "transpose")
        {
            Numbers result(given[0].size());
            for (std::size_t i = 0; i < result.size(); ++i)
            {
                const auto columns = static_cast<std::size_t>(first.columns);
                result[i % columns * static_cast<std::size_t>(first.rows) + i / columns] =
                    given[0][i];
            }
            return result;
        }
        if (node.text == "mul")
        {
            const Type& last = node.children[1].type;
            const Scalar scalar = node.type.scalar;
            return Multiply(first, Convert(first, first.Of(scalar), given[0]), last,
                            Convert(last, last.Of(scalar), given[1]), scalar);
        }
        const Type common = node.text == "sign" ? first : all.Of(node.type.scalar);
        for (std::size_t i = 0; i < given.size(); ++i)
        {
            given[i] = Convert(node.children[i].type, common, given[i]);
        }
        return node.text == "dot" ? Numbers{Dot(common.scalar, given[0], given[1])}
                                  : Components(node, given);
    }

    static Numbers Components(const Node& node, const std::vector<Numbers>& given)
    {
        Numbers result;
        for (std::size_t i = 0; i < given[0].size(); ++i)
        {
            Numbers arguments;
            for (const Numbers& argument : given)
            {
                arguments.push_back(argument[i]);
            }
            result.push_back(Component(node.text, node.type.scalar, arguments));
        }
        return result;
    }

    Numbers Call(const Node& node)
    {
        const Function& function = *node.function;
        Frame frame;
        std::map<std::size_t, Place> outputs;
        for (std::size_t i = 0; i < function.parameters.size(); ++i)
        {
            const Variable& parameter = function.parameters[i];
            const Node& argument = node.children[i];
            const bool isOutput = parameter.mode == "out" || parameter.mode == "inout";
            if (isOutput)
            {
                outputs[i] = Locate(argument);
            }
            frame[parameter.name] = parameter.mode == "out" ? Numbers(parameter.type.Parts().size())
                                    : isOutput
                                        ? Convert(argument.type, parameter.type, outputs[i].Read())
                                        : ConvertedTo(parameter.type, argument);
        }
        std::swap(frame, m_Frame);
        m_Returned.clear();
        Execute(function.body);
        std::swap(frame, m_Frame);
        for (const auto& [i, place] : outputs)
        {
            const Variable& parameter = function.parameters[i];
            place.Write(Convert(parameter.type, node.children[i].type, frame[parameter.name]));
        }
        return m_Returned;
    }

    Flow ExecuteAll(const Node& node, std::size_t first = 0)
    {
        Flow flow = Flow::Next;
        for (std::size_t i = first; i < node.children.size() && flow == Flow::Next; ++i)
        {
            flow = Execute(node.children[i]);
        }
        return flow;
    }

    Flow Loop(const Node& node)
    {
        const bool isFor = node.kind == Kind::For;
        const Node& body = node.children[isFor ? 3 : node.kind == Kind::While ? 1 : 0];
        const Node& condition = node.children[node.kind == Kind::While ? 0 : 1];
        if (isFor)
        {
            Execute(node.children[0]);
        }
        bool goesOn = node.kind == Kind::Do || isTrue(condition);
        while (goesOn)
        {
            const Flow flow = Execute(body);
            if (flow == Flow::Return)
            {
                return flow;
            }
            if (isFor && flow != Flow::Break)
            {
                Evaluate(node.children[2]);
            }
            goesOn = flow != Flow::Break && isTrue(condition);
        }
        return Flow::Next;
    }

    Flow ExecuteSwitch(const Node& node)
    {
        const double value = Evaluate(node.children[0])[0];
        for (std::size_t i = 1; i < node.children.size(); ++i)
        {
            if (node.children[i].text == "default" || node.children[i].number == value)
            {
                return ExecuteAll(node.children[i]);
            }
        }
        return Flow::Next;
    }

    Flow Execute(const Node& node)
    {
        switch (node.kind)
        {
        case Kind::Declare:
            m_Frame[node.text] = ConvertedTo(node.type, node.children[0]);
            return Flow::Next;
        case Kind::Sentence:
            Evaluate(node.children[0]);
            return Flow::Next;
        case Kind::If:
            return isTrue(node.children[0])   ? Execute(node.children[1])
                   : node.children.size() > 2 ? Execute(node.children[2])
                                              : Flow::Next;
        case Kind::For:
        case Kind::While:
        case Kind::Do:
            return Loop(node);
        case Kind::Switch:
            return ExecuteSwitch(node);
        case Kind::Break:
            return Flow::Break;
        case Kind::Continue:
            return Flow::Continue;
        case Kind::Return:
            if (!node.children.empty())
            {
                m_Returned = ConvertedTo(node.type, node.children[0]);
            }
            return Flow::Return;
        default:
            return ExecuteAll(node);
        }
    }

    Frame m_Globals;
    Frame m_Frame;
    Numbers m_Returned;
    int m_Steps = 0;
};

} // namespace

Numbers Interpret(const Snippet& snippet, const Input& input)
{
    return Interpreter().Run(snippet, input);
}

} // namespace limn::test::snippets
