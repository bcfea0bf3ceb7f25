#include "port/csharp/CSharpParser.h"

#include <algorithm>
#include <set>

namespace limn
{

namespace
{

bool IsModifier(std::string_view word)
{
    static const std::set<std::string_view> modifiers = {
        "public",   "private", "protected", "internal", "static",  "readonly", "const",
        "sealed",   "partial", "abstract",  "override", "virtual", "new",      "unsafe",
        "volatile", "async",   "extern",    "event",    "required"};
    return modifiers.contains(word);
}

constexpr int k_MaxNesting = 100; ///< of brackets, of types in types, of arrays of arrays

/// The depth of a word in brackets and types.
class Nesting
{
public:
    /// The deepest of the kinds behind the word.
    int Take(const CSharpToken& token)
    {
        m_Brackets += token.match > 0 ? 1 : token.match < 0 ? -1 : 0;
        if (token.Is("<") && m_IsBehindName)
        {
            ++m_Types;
        }
        else if (token.Is(">"))
        {
            m_Types = std::max(m_Types - 1, 0);
        }
        else if (!token.isName() &&
                 std::string_view(",.?[]()*::").find(token.text) == std::string_view::npos)
        {
            m_Types = 0;
        }
        m_Arrays = token.Is("[") ? m_Arrays + 1 : token.Is("]") ? m_Arrays : 0;
        m_IsBehindName = token.isName();
        return std::max({m_Brackets, m_Types, m_Arrays});
    }

private:
    int m_Brackets = 0;
    int m_Types = 0;
    int m_Arrays = 0;
    bool m_IsBehindName = false;
};

/// Requires that brackets and types are not nested too deeply, because the reader calls itself for
/// each level.
void RequireShallow(const CSharpFile& file, const std::vector<CSharpToken>& tokens)
{
    Nesting nesting;
    for (const CSharpToken& token : tokens)
    {
        if (nesting.Take(token) > k_MaxNesting)
        {
            throw AssetError(file.path, token.location,
                             "brackets or types are nested more than " +
                                 std::to_string(k_MaxNesting) + " deep here; limn reads no deeper");
        }
        RequireShallow(file, token.hole);
    }
}

template <typename Member>
void IndexNames(const std::vector<Member>& members, CSharpNames& names)
{
    for (std::size_t i = 0; i < members.size(); ++i)
    {
        names.emplace(members[i].name, i);
    }
}

void IndexMembers(std::vector<CSharpClass>& classes)
{
    for (CSharpClass& one : classes)
    {
        IndexNames(one.fields, one.fieldNames);
        IndexNames(one.methods, one.methodNames);
        IndexNames(one.classes, one.classNames);
        IndexNames(one.enumerators, one.enumeratorNames);
        IndexMembers(one.classes);
    }
}

/// The bytes of the character that begins the text; 0 where it is none of UTF-8.
std::size_t CharacterLength(std::string_view text)
{
    const auto byte = [&](std::size_t i)
    {
        return static_cast<unsigned char>(text[i]);
    };
    const std::size_t length = byte(0) < 0x80                      ? 1
                               : byte(0) >= 0xc2 && byte(0) < 0xe0 ? 2
                               : byte(0) >= 0xe0 && byte(0) < 0xf0 ? 3
                               : byte(0) >= 0xf0 && byte(0) < 0xf5 ? 4
                                                                   : 0;
    bool isGood = length > 0 && length <= text.size();
    for (std::size_t i = 1; isGood && i < length; ++i)
    {
        isGood = byte(i) >= 0x80 && byte(i) < 0xc0;
    }
    return isGood ? length : 0;
}

/// A question mark for each byte of another encoding: compilers refuse it in texts.
void MakeUtf8(std::string& text)
{
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t length = CharacterLength(std::string_view(text).substr(at));
        const bool isMark =
            at == 0 && (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"));
        if (length == 0 && isMark)
        {
            return; // UTF-16, which the tokenizer refuses
        }
        if (length == 0)
        {
            text[at] = '?';
        }
        at += std::max<std::size_t>(length, 1);
    }
}

} // namespace

bool IsClassKeyword(const CSharpToken& token)
{
    return token.Is("class") || token.Is("struct") || token.Is("interface") || token.Is("enum") ||
           (token.Is("record") && (&token)[1].isName());
}

void CSharpParser::Fail(const CSharpToken& token, const std::string& message) const
{
    const std::string found =
        token.kind == CSharpTokenKind::End ? "the end of the file" : std::string(token.text);
    throw AssetError(m_File.path, token.location, message + ", not '" + found + "'");
}

void CSharpParser::Expect(std::string_view word, const char* where)
{
    if (!m_At->Is(word))
    {
        Fail(*m_At, "'" + std::string(word) + "' is expected " + where);
    }
    ++m_At;
}

std::string CSharpParser::ExpectName(const char* what)
{
    if (!m_At->isName())
    {
        Fail(*m_At, std::string(what) + " is expected here");
    }
    return std::string((m_At++)->text);
}

void CSharpParser::SkipTo(std::initializer_list<std::string_view> words)
{
    while (std::ranges::none_of(words, [this](auto word) { return m_At->Is(word); }))
    {
        if (m_At->kind == CSharpTokenKind::End)
        {
            Fail(*m_At, "'" + std::string(*words.begin()) + "' is expected here");
        }
        m_At = m_At->match > 0 ? Closing() + 1 : m_At + 1;
    }
}

void CSharpParser::ParseSpace(const CSharpToken* end)
{
    while (m_At < end)
    {
        if (m_At->Is(";"))
        {
            ++m_At;
        }
        else if (m_At->Is("using") || m_At->Is("global") || m_At->Is("extern"))
        {
            SkipTo({";"});
        }
        else if (m_At->Is("namespace"))
        {
            SkipTo({"{", ";"});
            if (m_At->Is("{"))
            {
                const CSharpToken* close = Closing();
                ++m_At;
                ParseSpace(close);
                m_At = close + 1;
            }
        }
        else
        {
            const CSharpModifiers modifiers = ParseModifiers();
            if (m_At >= end) // attributes of the file
            {
                return;
            }
            if (m_At->Is("delegate"))
            {
                SkipTo({";"});
                continue;
            }
            if (!IsClassKeyword(*m_At))
            {
                Fail(*m_At, "a class is expected here: 'class Name : ScriptableRendererFeature "
                            "{ ... }'");
            }
            AddClass(m_File.classes, ParseClass(modifiers));
        }
    }
}

CSharpModifiers CSharpParser::ParseModifiers()
{
    CSharpModifiers modifiers;
    for (;;)
    {
        if (m_At->Is("["))
        {
            ParseAttributes(modifiers.attributes);
        }
        else if (m_At->isName() && IsModifier(m_At->text))
        {
            modifiers.words.insert((m_At++)->text);
        }
        else
        {
            return modifiers;
        }
    }
}

void CSharpParser::ParseAttributes(std::vector<CSharpAttribute>& attributes)
{
    const CSharpToken* close = Closing();
    ++m_At;
    while (m_At < close)
    {
        if (m_At->isName() && m_At[1].Is(":")) // [field: SerializeField]
        {
            m_At += 2;
        }
        CSharpAttribute attribute;
        attribute.name = ReadCSharpType(m_At);
        if (attribute.name.empty())
        {
            Fail(*m_At, "an attribute is expected here");
        }
        attribute.name = attribute.name.substr(attribute.name.rfind('.') + 1);
        if (attribute.name.size() > 9 && attribute.name.ends_with("Attribute"))
        {
            attribute.name.resize(attribute.name.size() - 9);
        }
        if (m_At->Is("("))
        {
            attribute.arguments = {m_At + 1, Closing()};
            m_At = Closing() + 1;
        }
        attributes.push_back(std::move(attribute));
        if (m_At < close)
        {
            Expect(",", "between attributes");
        }
    }
    m_At = close + 1;
}

CSharpClass CSharpParser::ParseClass(const CSharpModifiers& modifiers)
{
    CSharpClass result;
    const CSharpToken* begin = m_At;
    result.keyword = (m_At++)->text;
    if (m_At->Is("class") || m_At->Is("struct")) // record class
    {
        ++m_At;
    }
    result.isStatic = modifiers.Has("static");
    result.isPartial = modifiers.Has("partial");
    result.location = m_At->location;
    result.name = ExpectName("the name of a class");
    result.isGeneric = m_At->Is("<");
    if (result.isGeneric)
    {
        SkipGenerics();
    }
    if (m_At->Is("(")) // a record's
    {
        m_At = Closing() + 1;
    }
    while (m_At->Is(":") || m_At->Is(","))
    {
        ++m_At;
        const std::string base = ReadCSharpType(m_At);
        if (base.empty())
        {
            Fail(*m_At, "a base class is expected here");
        }
        result.bases.push_back(base);
    }
    SkipTo({"{", ";"}); // where T : ...
    if (m_At->Is(";"))
    {
        result.words = {begin, m_At++};
        return result;
    }
    const CSharpToken* close = Closing();
    result.words = {begin, close + 1};
    ++m_At;
    result.keyword == "enum" ? ParseEnumerators(result, close) : ParseMembers(result, close);
    m_At = close + 1;
    return result;
}

void CSharpParser::AddClass(std::vector<CSharpClass>& classes, CSharpClass one)
{
    const auto isOther = [&](const CSharpClass& other)
    {
        return other.isPartial && other.name == one.name;
    };
    const auto first = one.isPartial ? std::ranges::find_if(classes, isOther) : classes.end();
    if (first == classes.end())
    {
        classes.push_back(std::move(one));
        return;
    }
    const auto append = [](auto& to, auto& from)
    {
        to.insert(to.end(), std::make_move_iterator(from.begin()),
                  std::make_move_iterator(from.end()));
    };
    append(first->bases, one.bases);
    append(first->fields, one.fields);
    append(first->methods, one.methods);
    append(first->classes, one.classes);
}

void CSharpParser::SkipGenerics()
{
    int depth = 0;
    do
    {
        depth += m_At->Is("<") ? 1 : m_At->Is(">") ? -1 : 0;
        if (m_At->kind == CSharpTokenKind::End)
        {
            Fail(*m_At, "'>' is expected here");
        }
        ++m_At;
    } while (depth > 0);
}

void CSharpParser::ParseEnumerators(CSharpClass& result, const CSharpToken* close)
{
    while (m_At < close)
    {
        ParseModifiers();
        CSharpEnumerator enumerator;
        enumerator.name = ExpectName("a member of the enum");
        const CSharpToken* begin = m_At;
        while (m_At < close && !m_At->Is(","))
        {
            m_At = m_At->match > 0 ? Closing() + 1 : m_At + 1;
        }
        if (begin < m_At)
        {
            if (!begin->Is("="))
            {
                Fail(*begin, "'=' or ',' is expected behind a member of the enum");
            }
            enumerator.value = {begin + 1, m_At};
        }
        result.enumerators.push_back(std::move(enumerator));
        m_At += m_At < close ? 1 : 0;
    }
}

void ParseCSharp(CSharpFile& file, const CSharpTarget& target)
{
    MakeUtf8(file.text);
    file.tokens = TokenizeCSharp(file.text, file.path, target);
    RequireShallow(file, file.tokens.tokens);
    for (const CSharpRange& range : file.tokens.leftOut)
    {
        std::fill(file.text.begin() + static_cast<std::ptrdiff_t>(range.begin),
                  file.text.begin() + static_cast<std::ptrdiff_t>(range.end), ' ');
    }
    CSharpParser(file).ParseFile();
    IndexMembers(file.classes);
}

} // namespace limn
