#pragma once

#include "port/ClassIndex.h"
#include "port/PortingTable.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// A place in one of several files.
struct CSharpPlace
{
    const CSharpFile* file = nullptr;
    SourceLocation location;
};

/// A member that C# uses and does not define itself.
struct UsedMember
{
    std::string key;                  ///< the key in PortingTable, or the words of the file
    const PortEntry* entry = nullptr; ///< null if it is unknown
    std::string problem;              ///< why it is unknown; "" if it is known
    std::vector<CSharpPlace> places;  ///< in the order of the files
};

/// Walks through words of C# and notes what they use. It follows types by name.
class UseScanner
{
public:
    /// @param files, table  must outlive this
    UseScanner(const CSharpFiles& files, const PortingTable& table);

    void SetFile(const CSharpFile& file) { m_File = &file; }
    /// Enters a class, which may be nested in another. The words that follow are in it.
    void Enter(const CSharpClass& one) { m_Classes.push_back(&one); }
    void Leave() { m_Classes.pop_back(); }
    /// Forgets local variables.
    void BeginMethod() { m_Locals.clear(); }
    void Declare(const std::string& name, const std::string& type) { m_Locals[name] = type; }

    void UseType(std::string_view type, const SourceLocation& location);
    void UseAttribute(const std::string& name, const SourceLocation& location);
    void UseOverride(const CSharpClass& one, const CSharpMethod& method);
    void ScanWords(CSharpWords words);

    /// Returns the uses so far and forgets them. They are sorted by name, with unknown ones behind
    /// the others.
    std::vector<UsedMember> TakeUses();

private:
    using Word = const CSharpToken*;

    Word ScanName(Word word, Word begin, Word end);
    Word ScanNew(Word word, Word end);
    Word ScanHead(Word word, Word end);
    Word ScanDeclaration(Word word, Word begin, Word end);
    bool ScanLambda(Word word, Word end);
    bool isInitializerMember(Word word, Word begin) const;
    std::string TypeOfHead(Word word);
    std::string FollowChain(std::string type, Word& at, Word end);
    std::string MemberOf(const std::string& type, Word member, const std::string& generics);
    std::string TypeOfValue(Word at, Word end);

    std::vector<std::string> BasesOf(const CSharpClass& one, int depth = 0) const;
    const CSharpMethod* FindExtension(std::string_view name) const;
    const CSharpClass* FindClass(std::string_view type) const;
    const PortEntry* FindInherited(std::string_view type, std::string_view member,
                                   std::string& owner) const;
    bool isOwnMember(const CSharpClass& one, const std::string& name, std::string& type,
                     int depth = 0) const;
    void Use(const std::string& key, const PortEntry* entry, const SourceLocation& location,
             const std::string& problem = "");

    const PortingTable& m_Table;
    ClassIndex m_Own;
    /// Extension methods of static classes.
    std::map<std::string, const CSharpMethod*, std::less<>> m_Extensions;
    const CSharpFile* m_File = nullptr;
    std::vector<const CSharpClass*> m_Classes; ///< the innermost last
    std::map<std::string, std::string> m_Locals;
    std::map<Word, std::string> m_Initializers; ///< by their {
    std::vector<Word> m_OpenBrackets;
    std::set<Word> m_Done; ///< words already seen as part of something
    std::string m_PassData;
    std::string m_PassContext;
    bool m_IsSilent = false; ///< true while it only looks for a type
    std::map<std::string, UsedMember> m_Uses;
};

/// Returns every type, member and attribute that the files use and do not define, once each, by
/// name. Types of variables are followed as far as declarations and the table give them. Whatever
/// cannot be told is in the result as unknown.
std::vector<UsedMember> UsedMembersOf(const CSharpFiles& files, const PortingTable& table);

} // namespace limn
