#include "arithmetic/ArithmeticTable.h"

#include <bit>
#include <cmath>
#include <limits>

namespace limn::test
{

namespace
{

std::string FloatLiteral(float value)
{
    if (std::isnan(value))
    {
        return "(0.0 / 0.0)";
    }
    if (std::isinf(value))
    {
        return value > 0 ? "(1.0 / 0.0)" : "(-1.0 / 0.0)";
    }
    char text[40];
    std::snprintf(text, sizeof(text), "%.17e", static_cast<double>(value));
    return "(" + std::string(text) + ")";
}

template <typename T, typename F>
std::vector<Operand> Convert(const std::vector<T>& values, F&& convert)
{
    std::vector<Operand> operands;
    for (const T value : values)
    {
        operands.push_back(convert(value));
    }
    return operands;
}

} // namespace

Operand FloatOperand(double value)
{
    const auto narrow = static_cast<float>(value);
    return {'f', std::bit_cast<std::uint32_t>(narrow), static_cast<double>(narrow),
            FloatLiteral(narrow)};
}

Operand IntOperand(std::int64_t value)
{
    const bool isLeast = value == std::numeric_limits<std::int32_t>::min();
    return {'i', static_cast<std::uint32_t>(value), static_cast<double>(value),
            isLeast ? "(-2147483647 - 1)" : "(" + std::to_string(value) + ")"};
}

Operand UintOperand(std::int64_t value)
{
    return {'u', static_cast<std::uint32_t>(value), static_cast<double>(value),
            std::to_string(value) + "u"};
}

Outcome Outcome::Open(const char* why)
{
    Outcome outcome(0.0);
    outcome.open = why;
    return outcome;
}

Outcome Outcome::ByDriver(double wanted, const char* why)
{
    Outcome outcome(wanted);
    outcome.byDriver = why;
    return outcome;
}

Outcome Outcome::Rest(double wanted, double divided, double divisor, double slack)
{
    Outcome outcome(wanted);
    outcome.divided = divided;
    outcome.divisor = std::abs(divisor);
    outcome.slack = slack;
    return outcome;
}

std::vector<Operands> Combinations(const std::vector<std::vector<Operand>>& lists)
{
    std::vector<Operands> all(1);
    for (const std::vector<Operand>& list : lists)
    {
        std::vector<Operands> longer;
        for (const Operands& begun : all)
        {
            for (const Operand& operand : list)
            {
                longer.push_back(begun);
                longer.back().push_back(operand);
            }
        }
        all = std::move(longer);
    }
    return all;
}

std::vector<Operand> Floats(const std::vector<double>& values)
{
    return Convert(values, FloatOperand);
}
std::vector<Operand> Ints(const std::vector<std::int64_t>& values)
{
    return Convert(values, IntOperand);
}
std::vector<Operand> Uints(const std::vector<std::int64_t>& values)
{
    return Convert(values, UintOperand);
}

const std::vector<ArithmeticRow>& ArithmeticRows()
{
    static const std::vector<ArithmeticRow> s_Rows = []
    {
        std::vector<ArithmeticRow> rows;
        AddFloatRows(rows);
        AddIntegerRows(rows);
        AddConversionRows(rows);
        return rows;
    }();
    return s_Rows;
}

} // namespace limn::test
