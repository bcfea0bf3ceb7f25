#include "values/SnippetArithmetic.h"

#include <algorithm>
#include <bit>
#include <cmath>

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
    return op == "+"    ? x + y
           : op == "-"  ? x - y
           : op == "==" ? x == y
           : op == "!=" ? x != y
           : op == "<"  ? x < y
           : op == "<=" ? x <= y
           : op == ">"  ? x > y
           : op == ">=" ? x >= y
           : op == "&&" ? x != 0.0 && y != 0.0
           : op == "||" ? x != 0.0 || y != 0.0
           : op == "&"  ? Bits(x) & Bits(y)
           : op == "|"  ? Bits(x) | Bits(y)
                        : Bits(x) ^ Bits(y);
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
    const auto calculate = [&](const char* op, double a, double b)
    {
        return Fit(scalar, Calculate(op, scalar, a, b));
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
    const double x = v[0];
    return Fit(scalar, name == "abs"           ? std::abs(x)
                       : name == "floor"       ? std::floor(x)
                       : name == "ceil"        ? std::ceil(x)
                       : name == "trunc"       ? std::trunc(x)
                       : name == "round"       ? std::nearbyint(x)
                       : name == "frac"        ? x - std::floor(x)
                       : name == "sign"        ? (x > 0.0) - (x < 0.0)
                       : name == "saturate"    ? std::clamp(x, 0.0, 1.0)
                       : name == "countbits"   ? std::popcount(Bits(x))
                       : name == "reversebits" ? ReverseBits(x)
                       : name == "min"         ? std::min(x, v[1])
                       : name == "max"         ? std::max(x, v[1])
                       : name == "step"        ? v[1] >= x
                       : name == "fmod"        ? calculate("%", x, v[1])
                       : name == "mad"         ? calculate("+", calculate("*", x, v[1]), v[2])
                                               : std::clamp(x, v[1], v[2]));
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

Numbers Components(const Node& node, const std::vector<Numbers>& given)
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

} // namespace

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

Numbers CallIntrinsic(const Node& node, std::vector<Numbers> given)
{
    Type all = node.children[0].type;
    for (const Node& argument : node.children)
    {
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
            result[i % columns * static_cast<std::size_t>(first.rows) + i / columns] = given[0][i];
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

} // namespace limn::test::snippets
