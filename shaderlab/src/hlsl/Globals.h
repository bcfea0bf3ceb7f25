#pragma once

#include "hlsl/Declarations.h"
#include "hlsl/Tree.h"

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace limn
{

/// What is declared at file scope, by name. Views and pointers into the declarations.
class HlslGlobals
{
public:
    explicit HlslGlobals(const HlslDeclarations& declarations);

    const HlslDeclarations& declarations() const { return m_Declarations; }
    /// A uniform, object or static variable; null where there is none.
    const HlslVariable* FindVariable(std::string_view name) const;
    bool isUniform(const HlslVariable* variable) const;
    /// All functions of the name, bodies or not.
    std::span<const HlslFunction* const> FindFunctions(std::string_view name) const;
    /// Methods of any struct.
    std::span<const HlslFunction* const> FindMethods(std::string_view name) const;
    /// Those that a Call or Method may mean: functions, or else methods of any struct; methods.
    std::vector<const HlslFunction*> FindCalled(const HlslNode& node, std::string_view name) const;

    /// What an overload is called that differs from another one in half for float only, which
    /// glslang takes for a second definition; null of others.
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

/// Which of the overloads a call with these types means, as the language chooses: the fewest and
/// least conversions. Null where none takes as many, or where a type that would decide is unknown.
const HlslFunction* ChooseOverload(const HlslDeclarations& declarations,
                                   std::span<const HlslFunction* const> overloads,
                                   std::span<const HlslType> arguments);

/// Whether none of them takes arguments of these types, all of which are known.
bool TakesNone(const HlslDeclarations& declarations, std::span<const HlslFunction* const> overloads,
               std::span<const HlslType> arguments);

} // namespace limn
