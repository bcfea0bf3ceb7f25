#pragma once

#include "hlsl/Declarations.h"
#include "hlsl/Tree.h"

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace limn
{

/// The declarations at file scope, by name. Views and pointers lead into the declarations.
class HlslGlobals
{
public:
    explicit HlslGlobals(const HlslDeclarations& declarations);

    const HlslDeclarations& declarations() const { return m_Declarations; }
    /// Returns a uniform, object or static variable, or null if there is none.
    const HlslVariable* FindVariable(std::string_view name) const;
    bool isUniform(const HlslVariable* variable) const;
    /// Returns all functions of the name, with a body or without.
    std::span<const HlslFunction* const> FindFunctions(std::string_view name) const;
    /// Returns the methods of that name of any struct.
    std::span<const HlslFunction* const> FindMethods(std::string_view name) const;
    /// Returns the functions that a node may mean: for a Call the functions, or otherwise the
    /// methods of any struct; for a Method the methods of the object's struct, or of any struct if
    /// the struct is unknown.
    std::vector<const HlslFunction*> FindCalled(const HlslNode& node, std::string_view name) const;

    /// Returns the new name of an overload that differs from another one only by half in place of
    /// float, which glslang takes for a second definition. Returns null for other functions.
    const std::string* FindSpelling(const HlslFunction& function) const;

private:
    void TellHalfApart(std::span<const HlslFunction* const> overloads);

    using Functions = std::unordered_map<std::string_view, std::vector<const HlslFunction*>>;

    const HlslDeclarations& m_Declarations;
    std::unordered_map<std::string_view, const HlslVariable*> m_Variables;
    Functions m_Functions;
    Functions m_Methods;
    std::unordered_map<const HlslFunction*, std::string> m_Spellings;
};

/// Returns the overload that the language chooses for a call with these types: the one with the
/// fewest and least conversions. Returns null if none takes so many arguments, or if a type that
/// would decide is unknown.
const HlslFunction* ChooseOverload(const HlslDeclarations& declarations,
                                   std::span<const HlslFunction* const> overloads,
                                   std::span<const HlslType> arguments);

/// Returns whether all of these types are known and no overload takes arguments of them.
bool TakesNone(const HlslDeclarations& declarations, std::span<const HlslFunction* const> overloads,
               std::span<const HlslType> arguments);

/// The functions that an entry function, or the value of a global variable, can reach. A call
/// reaches all overloads of its name.
class ReachableFunctions
{
public:
    /// @param tokens   must outlive this
    /// @param globals  the globals of the same text; must outlive this
    ReachableFunctions(const HlslTokens& tokens, const HlslGlobals& globals,
                       std::string_view entry);

    const std::set<const HlslFunction*>& functions() const { return m_Functions; }
    /// Returns for each token whether it belongs to a function out of reach.
    const std::vector<bool>& isLeftOut() const { return m_IsLeftOut; }
    /// Returns whether the word occurs in one of the functions.
    bool Names(std::string_view word) const;

private:
    void Mark(const HlslFunction& function, bool isLeftOut);

    const HlslTokens& m_Tokens;
    std::set<const HlslFunction*> m_Functions;
    std::vector<bool> m_IsLeftOut;
};

} // namespace limn
