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

/// Spells what Unity's compilers take and glslang does not, or takes for something else, another
/// way: in resolved trees, by the types of their expressions. What has no known type stays.
class HlslLowering
{
public:
    /// @param code     gets the edits
    /// @param globals  outlive this
    HlslLowering(TokenEdits& code, const HlslGlobals& globals);

    /// A function's body, or a global variable's value.
    ///
    /// @param isInitial  in the value of something static, where glslang crashes on calls
    void Lower(HlslNode& node, bool isInitial);
    /// Gives a declared variable and what stands for it a name of its own.
    ///
    /// @param nodes  those that the resolver has seen, and others
    void Rename(const HlslResolver& resolver, const HlslNodes& nodes);
    /// The value of a variable of the type, where it is a list.
    ///
    /// @param dimensions  what stands in the brackets of an array
    /// @param statement   what other statements may be put before; null: none may
    void LowerInitializer(HlslNode& value, const HlslType& type,
                          std::span<const std::string_view> dimensions,
                          const HlslNode* statement = nullptr);

    /// Whether a static variable's resolved value is only right where it is not initial.
    bool NeedsFunction(const HlslNode& value) const;

    /// Declarations of the functions that the edits call; they belong before all code.
    const std::string& functions() const { return m_Functions; }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }
    void Wrap(const HlslNode& node, std::string_view before, std::string_view after);
    /// Writes a function that is called by the edits, once.
    void Need(const std::string& text);

    void LowerNode(HlslNode& node);
    // Targets.cpp
    bool HasEffects(const HlslNode& node) const;
    bool isTarget(const HlslNode& node) const;
    bool IsHandedWrong(const HlslNode& argument, const HlslVariable& parameter) const;
    void LowerTruthAssignment(const HlslNode& node);
    void LowerIntegerAssignment(const HlslNode& node);
    void LowerSwizzleAssignment(const HlslNode& node);
    void LowerSwizzleStep(const HlslNode& node);
    void LowerOutputs(HlslNode& node);
    // Loops.cpp
    void Hoist(const HlslNode& loop);
    // Matrices.cpp
    void LowerCast(HlslNode& node);
    void LowerConstruct(HlslNode& node);
    void LowerSwizzle(HlslNode& node);
    std::string SwizzleFunction(const HlslNode& node);
    void LowerMatrixOperator(HlslNode& node);
    void LowerMatrixFunction(HlslNode& node);
    std::string MultiplyFunction(const HlslType& type, bool isAssignment);
    std::string CastFunction(const HlslType& type);
    // Calls.cpp
    void LowerCall(HlslNode& node);
    void LowerGather(const HlslNode& node);
    void LowerHidden(const HlslNode& node);
    void LowerTruth(HlslNode& node);
    void LowerParts(HlslNode& node);
    void LowerExponent(HlslNode& node);
    void LowerFloats(HlslNode& node);
    void LowerInteger(HlslNode& node);
    void LowerSign(const HlslNode& node);
    void LowerLit(HlslNode& node);
    void LowerArgument(HlslNode& argument, const HlslVariable& parameter);
    // Constants.cpp
    void Hide(const HlslNode& node);
    bool FoldsWrong(const HlslNode& node) const;
    void SpellDot(const HlslNode& node);
    void LowerFolding(HlslNode& node);
    void LowerConstantCast(const HlslNode& node);
    // Initializers.cpp
    void LowerDeclarator(HlslNode& node);
    void LowerArrayCast(HlslNode& node);

    TokenEdits& m_Code;
    const HlslGlobals& m_Globals;
    bool m_IsInitial = false; ///< in the value of something static, where no call may stand
    std::set<std::string> m_Known;
    std::string m_Functions;
};

/// Adds the uniform that a resolved node writes to: assigns to, in whole or in part, or hands to a
/// parameter that a function gives something back by.
void FindWrittenUniforms(const HlslNode& node, const HlslTokens& tokens, const HlslGlobals& globals,
                         std::set<const HlslVariable*>& written);

} // namespace limn
