#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace limn::test
{

inline constexpr std::int64_t k_LeastInt = -2147483648ll;
inline constexpr std::int64_t k_LargestInt = 2147483647ll;
inline constexpr std::int64_t k_LargestUint = 4294967295ll;

/// A number that HLSL gets: of a float what it is, exactly.
struct Operand
{
    char type = 'f';        ///< f: float, i: int, u: uint
    std::uint32_t bits = 0; ///< as it lies in memory
    double value = 0.0;
    std::string literal; ///< in HLSL
};

Operand FloatOperand(double value);
Operand IntOperand(std::int64_t value);
Operand UintOperand(std::int64_t value);

/// What comes of it: a value that it must be near, or a reason why the language does not say.
struct Outcome
{
    Outcome(double wanted) : value(wanted) {}
    /// @param why  lives as long as the program
    static Outcome Open(const char* why);
    /// What HLSL says and limn leaves to the driver, because Vulkan does and a mend would cost
    /// every use of the function: SwiftShader may give something else.
    static Outcome ByDriver(double wanted, const char* why);
    /// A remainder: smaller than what was divided by, with the sign of what was divided, and off by
    /// no more than a slack, or that much less than a whole divisor.
    static Outcome Rest(double wanted, double divided, double divisor, double slack);

    double value = 0.0;
    const char* open = nullptr;
    const char* byDriver = nullptr;
    double divided = 0.0;
    double divisor = 0.0; ///< 0 = no remainder
    double slack = 0.0;
};

using Operands = std::vector<Operand>; ///< of one call: X, Y, Z
using ArithmeticOracle = std::function<Outcome(const Operands&)>;

/// An expression of HLSL with what must come of it, by the Direct3D 11.3 functional specification
/// and the reference of HLSL; computed in double precision.
struct ArithmeticRow
{
    std::string hlsl;  ///< of X, Y and Z
    char result = 'f'; ///< f, i, u
    std::vector<Operands> calls;
    ArithmeticOracle oracle;
    double tolerance = 0.0; ///< relative, 0 = exactly
    double absolute = 0.0;
    /// Whether vectors of numbers give vectors of results.
    bool isComponentwise = true;
};

const std::vector<ArithmeticRow>& ArithmeticRows();

// Parts of the table, each in a file of its own.
void AddFloatRows(std::vector<ArithmeticRow>& rows);
void AddIntegerRows(std::vector<ArithmeticRow>& rows);
void AddConversionRows(std::vector<ArithmeticRow>& rows);

/// Every combination of one of each list.
std::vector<Operands> Combinations(const std::vector<std::vector<Operand>>& lists);
std::vector<Operand> Floats(const std::vector<double>& values);
std::vector<Operand> Ints(const std::vector<std::int64_t>& values);
std::vector<Operand> Uints(const std::vector<std::int64_t>& values);

} // namespace limn::test
