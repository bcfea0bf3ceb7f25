#include "port/csharp/CSharpFile.h"

#include <algorithm>
#include <initializer_list>
#include <limn/base/TerminalText.h>
#include <limn/base/WordList.h>
#include <set>

namespace limn
{

namespace
{

/// Returns whether a class, struct, interface, enum or record begins there.
bool IsClassKeyword(const CSharpToken& token)
{
    return IsIn(token.text, {"class", "struct", "interface", "enum"}) ||
           (token.Is("record") && (&token)[1].isName());
}

/// The words and attributes before a member.
struct Modifiers
{
    std::vector<CSharpAttribute> attributes;
    std::set<std::string_view> words;

    bool Has(std::string_view word) const { return words.contains(word); }
};

/// { get; private set; }: a variable all the same.
bool IsAutomatic(const CSharpMethod& property)
{
    const auto isPlain = [](const CSharpToken& word)
    {
        return IsIn(word.text, {"get", "set", "init", ";", "private", "protected", "internal"});
    };
    return !property.isExpression && property.name != "this" && !property.body.empty() &&
           std::ranges::all_of(property.body, isPlain);
}

/// Reads a file's words from the first to the last.
class Parser
{
public:
    explicit Parser(CSharpFile& file) : m_File(file), m_At(file.tokens.tokens.data()) {}

    /// Reads what may be in a class, or outside of all classes.
    /// @param owner  the class; null outside of all
    /// @throws AssetError with line and column if it is no C#
    void ParseMembers(CSharpClass* owner, const CSharpToken* close)
    {
        while (m_At < close)
        {
            if (m_At->Is(";"))
            {
                ++m_At;
                continue;
            }
            if (!owner && IsIn(m_At->text, {"using", "global", "extern"}))
            {
                SkipTo({";"});
                continue;
            }
            if (!owner && m_At->Is("namespace"))
            {
                ParseNamespace();
                continue;
            }
            const Modifiers modifiers = ParseModifiers();
            if (!owner && m_At >= close) // attributes of the file
            {
                return;
            }
            if (IsClassKeyword(*m_At))
            {
                AddClass(owner ? owner->classes : m_File.classes, ParseClass(modifiers));
            }
            else if (m_At->Is("delegate"))
            {
                SkipTo({";"});
            }
            else if (!owner)
            {
                Fail(*m_At, "a class is expected here: 'class Name : ScriptableRendererFeature "
                            "{ ... }'");
            }
            else if (m_At->Is("~"))
            {
                SkipTo({"{", ";"});
                m_At = m_At->Behind();
            }
            else
            {
                ParseMember(*owner, modifiers);
            }
        }
    }

private:
    [[noreturn]] void Fail(const CSharpToken& token, const std::string& message) const
    {
        const std::string found =
            token.kind == CSharpTokenKind::End ? "the end of the file" : std::string(token.text);
        throw AssetError(m_File.path, token.location, message + ", not '" + found + "'");
    }

    void Expect(std::string_view word, const char* where)
    {
        if (!m_At->Is(word))
        {
            Fail(*m_At, "'" + std::string(word) + "' is expected " + where);
        }
        ++m_At;
    }

    std::string ExpectName(const char* what)
    {
        if (!m_At->isName())
        {
            Fail(*m_At, std::string(what) + " is expected here");
        }
        return std::string((m_At++)->text);
    }

    /// @param what  "a base class"
    std::string ExpectType(const std::string& what)
    {
        std::string type = ReadCSharpType(m_At);
        if (type.empty())
        {
            Fail(*m_At, what + " is expected here");
        }
        return type;
    }

    /// Skips to one of the words, past brackets.
    /// @return the words that it skips
    CSharpWords SkipTo(std::initializer_list<std::string_view> words)
    {
        const CSharpToken* begin = m_At;
        while (std::ranges::none_of(words, [this](auto word) { return m_At->Is(word); }))
        {
            if (m_At->kind == CSharpTokenKind::End)
            {
                Fail(*m_At, "'" + std::string(*words.begin()) + "' is expected here");
            }
            m_At = m_At->Behind();
        }
        return {begin, m_At};
    }

    /// Reads the words to the next comma outside of brackets, and skips the comma.
    CSharpWords ReadItem(const CSharpToken* close)
    {
        const CSharpToken* begin = m_At;
        while (m_At < close && !m_At->Is(","))
        {
            m_At = m_At->Behind();
        }
        const CSharpWords words{begin, m_At};
        m_At += m_At < close ? 1 : 0;
        return words;
    }

    void ParseNamespace()
    {
        SkipTo({"{", ";"});
        if (m_At->Is("{"))
        {
            const CSharpToken* behind = m_At->Behind();
            ++m_At;
            ParseMembers(nullptr, behind - 1);
            m_At = behind;
        }
    }

    Modifiers ParseModifiers()
    {
        static const WordList known(
            "public private protected internal static readonly const sealed partial abstract "
            "override virtual new unsafe volatile async extern event required");
        Modifiers modifiers;
        for (;;)
        {
            if (m_At->Is("["))
            {
                ParseAttributes(modifiers.attributes);
            }
            else if (m_At->isName() && known.Has(m_At->text))
            {
                modifiers.words.insert((m_At++)->text);
            }
            else
            {
                return modifiers;
            }
        }
    }

    void ParseAttributes(std::vector<CSharpAttribute>& attributes)
    {
        const CSharpToken* behind = m_At->Behind();
        ++m_At;
        while (m_At + 1 < behind)
        {
            if (m_At->isName() && m_At[1].Is(":")) // [field: SerializeField]
            {
                m_At += 2;
            }
            CSharpAttribute attribute;
            attribute.name = ExpectType("an attribute");
            attribute.name = attribute.name.substr(attribute.name.rfind('.') + 1);
            if (attribute.name.size() > 9 && attribute.name.ends_with("Attribute"))
            {
                attribute.name.resize(attribute.name.size() - 9);
            }
            if (m_At->Is("("))
            {
                attribute.arguments = m_At->Inside();
                m_At = m_At->Behind();
            }
            attributes.push_back(std::move(attribute));
            if (m_At + 1 < behind)
            {
                Expect(",", "between attributes");
            }
        }
        m_At = behind;
    }

    CSharpClass ParseClass(const Modifiers& modifiers)
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
            m_At = m_At->Behind();
        }
        while (m_At->Is(":") || m_At->Is(","))
        {
            ++m_At;
            result.bases.push_back(ExpectType("a base class"));
        }
        SkipTo({"{", ";"}); // where T : ...
        const CSharpToken* behind = m_At->Behind();
        result.words = {begin, m_At->Is(";") ? m_At : behind};
        if (m_At->Is("{"))
        {
            ++m_At;
            result.keyword == "enum" ? ParseEnumerators(result, behind - 1)
                                     : ParseMembers(&result, behind - 1);
        }
        m_At = behind;
        return result;
    }

    /// Adds a class. The parts of a partial class become one.
    static void AddClass(std::vector<CSharpClass>& classes, CSharpClass one)
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
            std::ranges::move(from, std::back_inserter(to));
        };
        append(first->bases, one.bases);
        append(first->fields, one.fields);
        append(first->methods, one.methods);
        append(first->classes, one.classes);
    }

    void SkipGenerics()
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

    void ParseEnumerators(CSharpClass& result, const CSharpToken* close)
    {
        while (m_At < close)
        {
            ParseModifiers();
            CSharpEnumerator& enumerator = result.enumerators.emplace_back();
            enumerator.name = ExpectName("a member of the enum");
            const CSharpWords value = ReadItem(close);
            if (!value.empty() && !value.front().Is("="))
            {
                Fail(value.front(), "'=' or ',' is expected behind a member of the enum");
            }
            enumerator.value = value.subspan(value.empty() ? 0 : 1);
        }
    }

    void ParseMember(CSharpClass& owner, const Modifiers& modifiers)
    {
        const CSharpToken& first = *m_At;
        if (first.text == owner.name && m_At[1].Is("("))
        {
            ParseMethod(owner, modifiers, "");
            return;
        }
        while (IsIn(m_At->text, {"ref", "implicit", "explicit"}))
        {
            ++m_At;
        }
        const std::string type = m_At->Is("operator") ? "operator" : ReadCSharpType(m_At);
        if (type.empty())
        {
            Fail(first, "a member of '" + owner.name + "' is expected here");
        }
        if (m_At->Is("operator"))
        {
            SkipTo({"("});
            m_At = m_At->Behind();
            SkipTo({"{", ";"});
            m_At = m_At->Behind();
            return;
        }
        while (m_At->isName() && m_At[1].Is(".")) // IDisposable.Dispose
        {
            m_At += 2;
        }
        const std::string_view next = m_At->isName() ? m_At[1].text : "";
        if (next == "(" || next == "<")
        {
            ParseMethod(owner, modifiers, type);
        }
        else if (IsIn(next, {"{", "=>", "["}))
        {
            ParseProperty(owner, modifiers, type);
        }
        else
        {
            ParseFields(owner, modifiers, type);
        }
    }

    /// Begins a field, whose name stands here or is that of a property.
    static CSharpField BeginField(const Modifiers& modifiers, const std::string& type)
    {
        CSharpField field;
        field.attributes = modifiers.attributes;
        field.isPublic = modifiers.Has("public");
        field.isConst = modifiers.Has("const");
        field.isStatic = field.isConst || modifiers.Has("static");
        field.type = type;
        return field;
    }

    void ParseFields(CSharpClass& owner, const Modifiers& modifiers, const std::string& type)
    {
        for (;;)
        {
            CSharpField& field = owner.fields.emplace_back(BeginField(modifiers, type));
            field.isReadonly = modifiers.Has("readonly");
            field.location = m_At->location;
            field.name = ExpectName("the name of a field");
            if (m_At->Is("="))
            {
                const CSharpToken* begin = ++m_At;
                SkipPastGenerics();
                field.value = {begin, m_At};
            }
            if (!m_At->Is(","))
            {
                break;
            }
            ++m_At;
        }
        Expect(";", "behind a field");
    }

    /// Skips to the ; or , behind a value. The , of Dictionary<A, B> does not count.
    void SkipPastGenerics()
    {
        for (SkipTo({";", ",", "<"}); m_At->Is("<"); SkipTo({";", ",", "<"}))
        {
            const CSharpToken* behind = m_At - 1;
            const bool isGeneric = behind->isName() && !ReadCSharpType(behind).empty() &&
                                   behind > m_At && behind[-1].Is(">");
            m_At = isGeneric ? behind : m_At + 1;
        }
    }

    CSharpMethod BeginMethod(const Modifiers& modifiers, const std::string& type)
    {
        CSharpMethod method;
        method.isOverride = modifiers.Has("override");
        method.isStatic = modifiers.Has("static");
        method.type = type;
        method.location = m_At->location;
        method.name = ExpectName("the name of a method");
        return method;
    }

    void ParseMethod(CSharpClass& owner, const Modifiers& modifiers, const std::string& type)
    {
        CSharpMethod method = BeginMethod(modifiers, type);
        if (m_At->Is("<"))
        {
            SkipGenerics();
        }
        if (!m_At->Is("("))
        {
            Fail(*m_At, "'(' is expected behind the name of a method");
        }
        const CSharpToken* behind = m_At->Behind();
        ++m_At;
        while (m_At + 1 < behind)
        {
            ParseParameter(method, behind - 1);
        }
        m_At = behind;
        if (m_At->Is(":") && m_At[1].isName() && m_At[2].Is("("))
        {
            m_At += 2;
            method.base = m_At->Inside();
            m_At = m_At->Behind();
        }
        SkipTo({"{", ";", "=>"}); // where T : ...
        ParseBody(method);
        owner.methods.push_back(std::move(method));
    }

    void ParseParameter(CSharpMethod& method, const CSharpToken* close)
    {
        while (m_At->Is("["))
        {
            m_At = m_At->Behind();
        }
        CSharpParameter parameter;
        while (IsIn(m_At->text, {"ref", "out", "in", "params", "this", "readonly", "scoped"}))
        {
            parameter.isReference = parameter.isReference || m_At->Is("ref") || m_At->Is("out");
            ++m_At;
        }
        parameter.type = ExpectType("a parameter of '" + method.name + "'");
        parameter.name = ExpectName("the name of a parameter");
        const CSharpWords value = ReadItem(close);
        parameter.value = value.subspan(value.empty() ? 0 : 1);
        method.parameters.push_back(std::move(parameter));
    }

    /// Reads a method's body, from { or => or ; on.
    void ParseBody(CSharpMethod& method)
    {
        if (m_At->Is("{"))
        {
            method.body = m_At->Inside();
            m_At = m_At->Behind();
            return;
        }
        method.isExpression = m_At->Is("=>");
        if (method.isExpression)
        {
            ++m_At;
            method.body = SkipTo({";"});
        }
        Expect(";", "behind a method");
    }

    /// Adds a method for each of the get and set in a property's braces, or else the property.
    static void AddAccessors(CSharpClass& owner, CSharpMethod property)
    {
        std::vector<CSharpMethod> accessors;
        const CSharpWords words = property.body;
        const CSharpToken* end = words.data() + words.size();
        for (const CSharpToken* at = words.data(); end - at > 1; ++at)
        {
            if (IsIn(at->text, {"private", "protected", "internal"}))
            {
                continue;
            }
            const bool isArrow = at[1].Is("=>");
            const bool isSetter = IsIn(at->text, {"set", "init"});
            if (property.isExpression || !(isSetter || at->Is("get")) ||
                !(isArrow || at[1].Is("{")))
            {
                accessors.clear();
                break;
            }
            const CSharpToken* behind =
                isArrow
                    ? std::find_if(at, end, [](const CSharpToken& word) { return word.Is(";"); })
                    : at[1].Behind() - 1;
            CSharpMethod& accessor = accessors.emplace_back(property);
            accessor.isExpression = isArrow;
            accessor.body = {at + 2, behind};
            if (isSetter)
            {
                accessor.name = "Set" + property.name;
                accessor.isProperty = false;
                accessor.isSetter = true;
                accessor.type = "void";
                accessor.parameters.emplace_back();
                accessor.parameters.back().type = property.type;
                accessor.parameters.back().name = "value";
            }
            at = behind;
        }
        const bool isIndexer = property.name == "this";
        if (accessors.empty() || isIndexer)
        {
            property.isUnread = !property.isExpression;
            owner.methods.push_back(std::move(property));
            return;
        }
        std::ranges::move(accessors, std::back_inserter(owner.methods));
    }

    void ParseProperty(CSharpClass& owner, const Modifiers& modifiers, const std::string& type)
    {
        CSharpMethod property = BeginMethod(modifiers, type);
        property.isProperty = true;
        if (m_At->Is("[")) // this[int i]
        {
            m_At = m_At->Behind();
        }
        SkipTo({"{", "=>"});
        const bool isOfClass = owner.keyword != "interface" && !modifiers.Has("abstract") &&
                               !property.isOverride && !modifiers.Has("new");
        ParseBody(property);
        CSharpWords value;
        if (m_At->Is("=")) // { get; set; } = 3;
        {
            ++m_At;
            value = SkipTo({";"});
            ++m_At;
        }
        if (!isOfClass || !IsAutomatic(property))
        {
            AddAccessors(owner, std::move(property));
            return;
        }
        CSharpField field = BeginField(modifiers, type);
        field.isProperty = true;
        field.name = property.name;
        field.location = property.location;
        field.value = value;
        owner.fields.push_back(std::move(field));
    }

    CSharpFile& m_File;
    const CSharpToken* m_At;
};

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

void IndexMembers(const CSharpFile& file, const CSharpClass* outer,
                  std::vector<CSharpClass>& classes)
{
    for (CSharpClass& one : classes)
    {
        one.file = &file;
        one.outer = outer;
        IndexNames(one.fields, one.fieldNames);
        IndexNames(one.methods, one.methodNames);
        IndexNames(one.classes, one.classNames);
        IndexNames(one.enumerators, one.enumeratorNames);
        IndexMembers(file, &one, one.classes);
    }
}

/// A question mark for each byte of another encoding: compilers refuse it in texts.
void MakeUtf8(std::string& text)
{
    if (StartsWithAny(text, {"\xFF\xFE", "\xFE\xFF"}))
    {
        return; // UTF-16, which the tokenizer refuses
    }
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t length = DecodeCharacter(std::string_view(text).substr(at)).size;
        text[at] = length == 0 ? '?' : text[at];
        at += std::max<std::size_t>(length, 1);
    }
}

} // namespace

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
    Parser(file).ParseMembers(nullptr, &file.tokens.tokens.back());
    IndexMembers(file, nullptr, file.classes);
}

} // namespace limn
