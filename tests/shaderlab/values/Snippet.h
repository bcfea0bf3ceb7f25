#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

// HLSL that is made by chance, as a tree: it is printed for the device, and worked out on the CPU.

namespace limn::test::snippets
{

/// The kinds of numbers, the wider one behind: two kinds that meet become the wider one.
enum class Scalar : std::uint8_t
{
    Bool,
    Min16Int,
    Int,
    Uint,
    Half,
    Min16Float,
    Float,
};

inline bool isFloating(Scalar scalar)
{
    return scalar >= Scalar::Half;
}

struct Record;

struct Type
{
    Scalar scalar = Scalar::Float;
    int columns = 1;          ///< 0: nothing, as of a function
    int rows = 0;             ///< of a matrix, else 0
    std::vector<int> sizes{}; ///< of an array
    std::shared_ptr<const Record> record{};

    bool isNumber() const { return sizes.empty() && !record && columns > 0; }
    bool isScalar() const { return isNumber() && rows == 0 && columns == 1; }
    bool isVector() const { return isNumber() && rows == 0 && columns > 1; }
    bool isMatrix() const { return isNumber() && rows > 0; }
    Type Of(Scalar other) const;
    Type As(int newColumns, int newRows = 0) const;
    Type Element() const; ///< of an array, of a matrix (its row), of a vector
    /// The kinds of the numbers that it holds, in order.
    std::vector<Scalar> Parts() const;
    std::string Spelling() const; ///< without the sizes of an array

    bool operator==(const Type&) const = default;
};

/// A member, a parameter or a variable.
struct Variable
{
    Type type;
    std::string name;
    std::string mode; ///< of a parameter: "", "in", "out" or "inout"; "const" is not written to
};

struct Record
{
    std::string name;
    std::vector<Variable> members;
};

enum class Kind : std::uint8_t
{
    Number,
    Name,
    Member,
    Swizzle,
    Index,
    Prefix,
    Postfix,
    Binary,
    Ternary,
    Cast,
    Construct,
    List,
    Intrinsic,
    Call,
    Assign,
    // Statements.
    Declare, ///< `text` is the name, `type` the type
    Sentence,
    Block,
    If,
    For, ///< declaration, condition, step, block
    While,
    Do, ///< block, condition
    Switch,
    Case, ///< a block, with its number; without a name the default
    Break,
    Continue,
    Return,
};

struct Function;

struct Node
{
    Kind kind = Kind::Block;
    Type type;
    std::string text; ///< operator or name
    std::vector<Node> children;
    double number = 0.0;
    std::shared_ptr<const Function> function;
};

struct Function
{
    std::string name;
    Type type;
    std::vector<Variable> parameters;
    Node body;
};

struct Snippet
{
    std::string name;
    std::vector<std::shared_ptr<const Record>> records;
    std::vector<Node> globals; ///< Declares
    std::vector<std::shared_ptr<const Function>> functions;
    Node body;
    std::vector<Variable> results;
};

/// What a thread is given: the snippet's a and n.
struct Input
{
    std::vector<double> floats;   ///< 4
    std::vector<double> integers; ///< 4
};

using Numbers = std::vector<double>;

/// Thrown where a value is not exact in all precisions that it may have, or not defined.
struct Unfit
{
};

/// The numbers of all results.
Numbers Interpret(const Snippet& snippet, const Input& input);

/// The type of an operator's, and of a function's of the language.
Type BinaryType(const std::string& op, const Type& left, const Type& right);
Type IntrinsicType(const std::string& name, const std::vector<Node>& arguments);
Type Promote(const Type& left, const Type& right);

/// What the snippet declares, and a function of its name that takes `uint thread, uint first`:
/// where in _Out its results begin.
std::string Print(const Snippet& snippet);
std::string Print(const Node& node, int level = 0);

/// The same on every machine and with every compiler.
///
/// @param isLavapipe  whether to leave out what lavapipe gets wrong, or what SwiftShader does
Snippet Generate(std::uint64_t seed, const std::vector<Input>& inputs, bool isLavapipe);

/// An even random generator (SplitMix64).
class Random
{
public:
    explicit Random(std::uint64_t seed) : m_State(seed) {}
    int Below(int count)
    {
        std::uint64_t z = m_State += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30u)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27u)) * 0x94d049bb133111ebu;
        return static_cast<int>((z ^ (z >> 31u)) % static_cast<std::uint64_t>(count));
    }
    bool OneIn(int count) { return Below(count) == 0; }

private:
    std::uint64_t m_State;
};

} // namespace limn::test::snippets
