#pragma once

#include "hlsl/Globals.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace limn
{

/// What the names in a tree stand for, and the types of its expressions.
///
/// A variable that a `for` declares lives to the end of the block around the loop, as Unity's
/// compilers have it; the newest of a name is meant.
class HlslResolver
{
public:
    /// @param tokens   outlive this, as do
    /// @param globals  the names outside of functions
    HlslResolver(const HlslTokens& tokens, const HlslGlobals& globals);

    /// @param owner  of a method, else null
    void ResolveBody(HlslNode& body, const HlslFunction& function, const HlslStruct* owner);
    /// The value of a global variable, or what is in a body.
    void Resolve(HlslNode& node);

    /// Declarators whose names glslang takes for something else, so that they and what stands for
    /// them need another: of loops, used behind their loop; and of variables whose value names
    /// another one of the same name.
    const std::vector<HlslNode*>& renamed() const { return m_Renamed; }

    /// Names of variables, functions and members that nobody declares.
    /// In glslang's words, which stops at the first.
    const std::vector<HlslProblem>& unknown() const { return m_Unknown; }

private:
    struct Entry
    {
        HlslNode* local = nullptr;
        const HlslVariable* variable = nullptr;
        HlslType type;
        bool hasEnded = false; ///< the loop that declares it
    };

    void Open() { m_Scopes.emplace_back(); }
    void Close();
    void Declare(std::string_view name, const Entry& entry);
    void ResolveType(HlslNode& node);
    void EndLoop(const HlslNode& loop);
    void DeclareLocal(HlslNode& declarator);
    void ResolveName(HlslNode& node);
    void Rename(HlslNode& declarator);
    static const Entry& Meant(const std::vector<Entry>& entries, bool hasMembers);
    HlslType CallType(HlslNode& node);
    HlslType MemberType(const HlslNode& node);
    static HlslType PrefixType(std::string_view mark, const HlslType& operand);
    HlslType BinaryType(const HlslNode& node) const;
    HlslType ObjectMethodType(const HlslType& object, std::string_view method) const;
    HlslType ElementType(HlslType type) const;

    const HlslTokens& m_Tokens;
    const HlslGlobals& m_Globals;
    std::unordered_map<std::string_view, std::vector<Entry>> m_Names;
    std::vector<std::vector<std::string_view>> m_Scopes; ///< what each declares
    std::vector<HlslNode*> m_Renamed;
    std::vector<HlslProblem> m_Unknown;
};

} // namespace limn
