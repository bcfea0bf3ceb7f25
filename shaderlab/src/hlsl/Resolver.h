#pragma once

#include "hlsl/Globals.h"

#include <string_view>
#include <unordered_map>
#include <vector>

namespace limn
{

/// Finds what the names in a tree stand for, and the types of its expressions.
///
/// A variable that a `for` declares lives to the end of the block around the loop, as in Unity's
/// compilers. A name means its newest variable.
class HlslResolver
{
public:
    /// @param tokens   must outlive this
    /// @param globals  the names outside of functions; must outlive this
    HlslResolver(const HlslTokens& tokens, const HlslGlobals& globals)
        : m_Tokens(tokens), m_Globals(globals)
    {
    }

    /// @param owner  the struct of a method; otherwise null
    void ResolveBody(HlslNode& body, const HlslFunction& function, const HlslStruct* owner);
    /// Resolves the value of a global variable, or a node in a body.
    void Resolve(HlslNode& node);

    /// Returns the declarators whose names glslang takes for something else, so that they and their
    /// uses need another name: variables of loops that are used behind their loop, and variables
    /// whose value uses another one of the same name. One may be there several times.
    const std::vector<HlslNode*>& renamed() const { return m_Renamed; }

    /// Returns the variables, functions and members that are not declared, in the words of glslang,
    /// which stops at the first one.
    const std::vector<HlslProblem>& unknown() const { return m_Unknown; }

private:
    struct Entry
    {
        HlslNode* local = nullptr;
        const HlslVariable* variable = nullptr;
        HlslType type;
        bool hasEnded = false; ///< true if the loop that declares it has ended
    };

    void Open() { m_Scopes.emplace_back(); }
    void Close();
    void Declare(std::string_view name, const Entry& entry);
    void ResolveType(HlslNode& node);
    void EndLoop(const HlslNode& loop);
    void DeclareLocal(HlslNode& declarator);
    void ResolveName(HlslNode& node);
    static const Entry& Meant(const std::vector<Entry>& entries, bool hasMembers);
    HlslType CallType(HlslNode& node);
    HlslType MemberType(const HlslNode& node);
    static HlslType PrefixType(std::string_view mark, const HlslType& operand);
    HlslType BinaryType(const HlslNode& node) const;
    HlslType ElementType(HlslType type) const;

    const HlslTokens& m_Tokens;
    const HlslGlobals& m_Globals;
    std::unordered_map<std::string_view, std::vector<Entry>> m_Names;
    std::vector<std::vector<std::string_view>> m_Scopes; ///< the names that each scope declares
    std::vector<HlslNode*> m_Renamed;
    std::vector<HlslProblem> m_Unknown;
};

} // namespace limn
