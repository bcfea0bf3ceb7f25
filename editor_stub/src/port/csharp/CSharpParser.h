#pragma once

#include "port/csharp/CSharpFile.h"

#include <initializer_list>
#include <set>

namespace limn
{

/// The words and attributes before a member.
struct CSharpModifiers
{
    std::vector<CSharpAttribute> attributes;
    std::set<std::string_view> words;

    bool Has(std::string_view word) const { return words.contains(word); }
};

/// Returns whether a class, struct, interface, enum or record begins there.
bool IsClassKeyword(const CSharpToken& token);

/// Reads a file's words from the first to the last. CSharpFile.cpp reads classes and what is
/// outside of them, CSharpMembers.cpp reads what is in classes.
class CSharpParser
{
public:
    explicit CSharpParser(CSharpFile& file) : m_File(file), m_At(file.tokens.tokens.data()) {}

    /// @throws AssetError with line and column if it is no C#
    void ParseFile() { ParseSpace(m_File.tokens.tokens.data() + m_File.tokens.tokens.size() - 1); }

private:
    [[noreturn]] void Fail(const CSharpToken& token, const std::string& message) const;
    void Expect(std::string_view word, const char* where);
    std::string ExpectName(const char* what);

    const CSharpToken* Closing() const { return m_At + m_At->match; }
    /// Skips to one of the words, past brackets.
    void SkipTo(std::initializer_list<std::string_view> words);

    /// Reads what may be outside of classes.
    void ParseSpace(const CSharpToken* end);
    CSharpModifiers ParseModifiers();
    void ParseAttributes(std::vector<CSharpAttribute>& attributes);
    CSharpClass ParseClass(const CSharpModifiers& modifiers);
    /// Adds a class. The parts of a partial class become one.
    static void AddClass(std::vector<CSharpClass>& classes, CSharpClass one);
    void SkipGenerics();
    void ParseEnumerators(CSharpClass& result, const CSharpToken* close);

    void ParseMembers(CSharpClass& result, const CSharpToken* close);
    void SkipBody() { m_At = m_At->match > 0 ? Closing() + 1 : m_At + 1; }
    void ParseMember(CSharpClass& owner, const CSharpModifiers& modifiers);
    void ParseFields(CSharpClass& owner, const CSharpModifiers& modifiers, const std::string& type);
    /// Skips to the ; or , behind a value. The , of Dictionary<A, B> does not count.
    void SkipPastGenerics();
    CSharpMethod BeginMethod(const CSharpModifiers& modifiers, const std::string& type);
    void ParseMethod(CSharpClass& owner, const CSharpModifiers& modifiers, const std::string& type);
    void ParseParameter(CSharpMethod& method, const CSharpToken* close);
    /// Reads a method's body, from { or => or ; on.
    void ParseBody(CSharpMethod& method);
    void ParseProperty(CSharpClass& owner, const CSharpModifiers& modifiers,
                       const std::string& type);

    CSharpFile& m_File;
    const CSharpToken* m_At;
};

} // namespace limn
