#pragma once

#include "hlsl/Resolver.h"
#include "hlsl/TokenEdits.h"
#include "hlsl/Tree.h"

#include <set>
#include <span>
#include <string>
#include <string_view>

namespace limn
{

/// Rewrites code that Unity's compilers accept and glslang does not, or understands differently. It
/// works on resolved trees, by the types of their expressions. Code without a known type stays.
class HlslLowering
{
public:
    /// @param code     receives the edits
    /// @param globals  must outlive this
    HlslLowering(TokenEdits& code, const HlslGlobals& globals) : m_Code(code), m_Globals(globals) {}

    /// Rewrites a function's body, or a global variable's value.
    ///
    /// @param isInitial  true in the value of a static variable, where glslang crashes on calls
    void Lower(HlslNode& node, bool isInitial);
    /// Gives a declared variable and all its uses a name of its own.
    ///
    /// @param nodes  the nodes that the resolver has seen, and others
    void Rename(const HlslResolver& resolver, const HlslNodes& nodes);
    /// Rewrites the value of a variable of the type, if it is a list.
    ///
    /// @param dimensions  the texts in the brackets of an array
    /// @param statement   the statement before which others may be inserted; null: none may
    void LowerInitializer(HlslNode& value, const HlslType& type,
                          std::span<const std::string_view> dimensions,
                          const HlslNode* statement = nullptr);

    /// Returns whether a static variable's resolved value is right only if a function computes it,
    /// not as an initial value.
    bool NeedsFunction(const HlslNode& value) const;

    /// Returns the declarations of the functions that the edits call; they belong before all code.
    const std::string& functions() const { return m_Functions; }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }
    void Wrap(const HlslNode& node, std::string_view before, std::string_view after);
    void Cast(const HlslNode& node, const HlslType& type)
    {
        Wrap(node, "(" + type.Spelling() + ")(", ")");
    }
    /// Adds a function that the edits call, once.
    void Need(const std::string& text);

    void LowerNode(HlslNode& node);
    bool isTarget(const HlslNode& node) const;
    bool IsHandedWrong(const HlslNode& argument, const HlslVariable& parameter) const;
    void LowerAssignment(const HlslNode& node);
    void LowerSwizzleAssignment(const HlslNode& node);
    void LowerSwizzleStep(const HlslNode& node);
    void LowerOutputs(HlslNode& node);
    void Hoist(const HlslNode& loop);
    // Calls.cpp
    void LowerCast(HlslNode& node);
    void LowerConstruct(HlslNode& node);
    void LowerSwizzle(HlslNode& node);
    std::string SwizzleFunction(const HlslNode& node);
    void LowerMatrixOperator(HlslNode& node);
    void LowerMatrixFunction(HlslNode& node);
    std::string MultiplyFunction(const HlslType& type, bool isAssignment);
    std::string CastFunction(const HlslType& type);
    void LowerCall(HlslNode& node);
    void LowerGather(const HlslNode& node);
    void LowerHidden(const HlslNode& node);
    void LowerTruth(HlslNode& node);
    void LowerParts(HlslNode& node);
    void LowerExponent(HlslNode& node);
    void LowerFloats(HlslNode& node);
    void LowerSingle(HlslNode& node);
    void LowerInteger(HlslNode& node);
    void LowerSign(const HlslNode& node);
    void LowerLit(HlslNode& node);
    void LowerArgument(HlslNode& argument, const HlslVariable& parameter);
    // Values.cpp
    void Hide(const HlslNode& node);
    bool FoldsWrong(const HlslNode& node) const;
    void SpellDot(const HlslNode& node);
    void LowerFolding(HlslNode& node);
    void LowerConstantCast(const HlslNode& node);
    void LowerDeclarator(HlslNode& node);
    void LowerArrayCast(HlslNode& node);

    TokenEdits& m_Code;
    const HlslGlobals& m_Globals;
    bool m_IsInitial = false; ///< true in the value of a static variable, where no call is possible
    std::set<std::string> m_Known;
    std::string m_Functions;
};

/// Returns the uniforms that resolved nodes write: by assigning to them, in whole or in part, or by
/// passing them to an output parameter of a function.
std::set<const HlslVariable*> FindWrittenUniforms(const HlslNodes& nodes, const HlslTokens& tokens,
                                                  const HlslGlobals& globals);

/// Returns whether computing the expression may change something, so that it must be computed once.
bool HasEffects(const HlslNode& node, const TokenEdits& code);

/// Returns the vector of the elements of a matrix that a word names: `float2(m._m00, m._m11)`.
std::string ReadElements(const HlslType& type, const std::string& matrix, std::string_view word);

} // namespace limn
