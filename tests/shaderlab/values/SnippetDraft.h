#pragma once

#include "values/Snippet.h"

#include <optional>
#include <utility>

// A snippet while it is made by chance. Each draw of a random number is a statement of its own:
// compilers may evaluate the arguments of a function in any order, and all are to make the same
// snippets.

namespace limn::test::snippets
{

struct Draft
{
    Random random;
    const std::vector<Input>& inputs;
    bool isLavapipe;
    std::string suffix; ///< of all names outside functions
    Snippet snippet{};
    std::vector<Variable> scope{};
    std::vector<Variable> loops{}; ///< their counters
    std::shared_ptr<const Function> counter{};
    std::optional<Type> returns{}; ///< what the function does that is made
    int names = 0;
    int depth = 0;
    int nested = 0;
    bool counts = false;     ///< whether the statement may still call the counting function
    bool isConstant = false; ///< whether only what is constant may stand
};

Node MakeNode(Kind kind, const Type& type, std::string text, std::vector<Node> children = {});
Node MakeName(const Variable& variable);
Node MakeNumber(Scalar scalar, double number);
Node MakeInteger(int number);
Node MakeBinary(const std::string& op, Node left, Node right);
Node MakeCast(const Type& type, Node node);
Node MakeSentence(Node expression);
Node MakeAssign(const std::string& op, Node target, Node value);
bool isSameShape(const Type& a, const Type& b);

template <typename T = std::string>
const T& OneOf(Draft& draft, const std::vector<T>& items)
{
    return items[static_cast<std::size_t>(draft.random.Below(static_cast<int>(items.size())))];
}
std::string NewName(Draft& draft, const char* letter);
Scalar AnyScalar(Draft& draft);
Type AnyNumber(Draft& draft);
Type AnyType(Draft& draft);

/// A call of the function that counts, which is the only thing in a statement that may change
/// something; else a number.
Node Counted(Draft& draft);
/// A part of a variable that has the shape; nothing where chance finds none.
std::optional<Node> PlaceOf(Draft& draft, const Type& shape, bool isWritten,
                            bool hasScalar = false);

/// An expression of the shape; often of the kind.
Node Expression(Draft& draft, const Type& like);
/// An expression of the shape and of the kind.
Node Exact(Draft& draft, const Type& type);
Node Truth(Draft& draft, const Type& like);
Node Call(Draft& draft, const std::shared_ptr<const Function>& function);

Node Initial(Draft& draft, const Type& type);
Node Return(Draft& draft);
/// Adds a statement unless chance got stuck.
void AddStatement(Draft& draft, Node& block);

} // namespace limn::test::snippets
