#pragma once

#include "hlsl/Types.h"
#include "tokens/IntegerExpression.h"
#include "tokens/Tokens.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace limn
{

/// The declaration of a global, a struct member or a parameter: `[modifiers] type name[dimensions]
/// : SEMANTIC`.
struct HlslVariable
{
    std::vector<std::string_view> modifiers;
    std::string_view type; ///< without template arguments
    std::string_view templateArgument;
    std::string_view name;
    std::vector<std::string_view> dimensions; ///< text between each [ ]
    std::string_view semantic;
    std::size_t valueToken = 0; ///< the first behind `=`, or 0
    std::size_t valueEnd = 0;   ///< one behind its last
    std::size_t token = 0;      ///< index of the name
    std::size_t endToken = 0;   ///< for a uniform: index of the token that ends its declaration
    /// The first token of the declaration, which may have several names.
    std::size_t firstToken = 0;
    std::size_t declaratorEnd = 0; ///< one behind what belongs to this name alone
    std::size_t semicolon = 0;     ///< the one that ends the declaration; 0 = there is none
    bool isInBuffer = false;       ///< a member of a cbuffer; endToken is the buffer's end
    std::string_view buffer;       ///< its name

    bool Has(std::string_view word) const { return std::ranges::count(modifiers, word) > 0; }
    bool isOutput() const { return Has("out") || Has("inout"); } ///< of a function
};

struct HlslFunction
{
    std::string_view returnType;
    std::string_view returnArgument; ///< the template argument of the type
    std::string_view name;
    std::string_view semantic; ///< the semantic of the return value
    std::vector<HlslVariable> parameters;
    std::vector<std::string_view> attributes; ///< each with its brackets
    std::size_t token = 0;                    ///< index of the name
    std::size_t begin = 0;                    ///< first token, attributes included
    std::size_t end = 0;                      ///< one behind the last token
    std::size_t body = 0;                     ///< its `{`
    bool hasBody = false;
};

struct HlslStruct
{
    std::string_view name;
    std::vector<HlslVariable> members;
    std::vector<HlslFunction> methods;
};

inline constexpr std::string_view k_MissingSemicolon = "a ';' is missing before it";

/// The declarations of preprocessed HLSL at file scope. All views point into the source.
struct HlslDeclarations
{
    std::vector<HlslStruct> structs;
    std::vector<HlslFunction> functions;
    std::vector<HlslVariable> uniforms; ///< loose ones and members of cbuffers, no textures
    std::vector<HlslVariable> objects;  ///< textures, samplers, buffers
    std::vector<HlslVariable> aliases;  ///< `typedef type name;`
    /// The text that is no declaration, or none that limn can read.
    std::vector<HlslProblem> problems;
    std::vector<std::size_t> emptyMembers; ///< tokens: each `;` that ends no member of a struct
    std::vector<HlslVariable> statics;     ///< global variables that are no uniforms
    IntegerNames constants;                ///< `static const` scalars

    /// Returns the type behind a typedef; returns other names unchanged.
    ///
    /// @param argument  receives the template argument of the type; may be null
    std::string_view ResolveAlias(std::string_view type,
                                  std::string_view* argument = nullptr) const;
    const HlslStruct* FindStruct(std::string_view name) const;
    const HlslFunction* FindDefinition(std::string_view name) const;
};

HlslDeclarations ReadDeclarations(const HlslTokens& tokens);

/// Returns the type of a declared variable: a member, parameter or global.
HlslType TypeOf(const HlslDeclarations& declarations, const HlslVariable& variable);
/// Returns the type that a word and the template argument behind it name.
HlslType TypeOf(const HlslDeclarations& declarations, std::string_view type,
                std::string_view argument);

/// Returns a type with its template argument, as HLSL writes it.
std::string TypeText(std::string_view type, std::string_view argument);
/// Returns the declaration of a variable of the same type.
std::string DeclarationOf(std::string_view name, const HlslVariable& variable);

} // namespace limn
