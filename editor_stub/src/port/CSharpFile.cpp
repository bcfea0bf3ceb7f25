#include "port/CSharpFile.h"

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

bool IsClassKeyword(const CSharpToken& token)
{
    return token.Is("class") || token.Is("struct") || token.Is("interface") || token.Is("enum") ||
           (token.Is("record") && (&token)[1].isName());
}

/// What stands before a member.
struct Modifiers
{
    std::vector<CSharpAttribute> attributes;
    std::set<std::string_view> words;

    bool Has(std::string_view word) const { return words.contains(word); }
};

class Parser
{
public:
    explicit Parser(CSharpFile& file) : m_File(file), m_At(file.tokens.tokens.data()) {}

    void ParseFile() { ParseSpace(m_File.tokens.tokens.data() + m_File.tokens.tokens.size() - 1); }

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
    const CSharpToken* Closing() const { return m_At + m_At->match; }
    /// To the word, past brackets.
    void SkipTo(std::initializer_list<std::string_view> words)
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

    /// What may stand outside of classes.
    void ParseSpace(const CSharpToken* end)
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
                const Modifiers modifiers = ParseModifiers();
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
                m_File.classes.push_back(ParseClass(modifiers));
            }
        }
    }

    Modifiers ParseModifiers()
    {
        Modifiers modifiers;
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

    void ParseAttributes(std::vector<CSharpAttribute>& attributes)
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

    void ParseMembers(CSharpClass& result, const CSharpToken* close)
    {
        while (m_At < close)
        {
            if (m_At->Is(";"))
            {
                ++m_At;
                continue;
            }
            const Modifiers modifiers = ParseModifiers();
            if (IsClassKeyword(*m_At))
            {
                result.classes.push_back(ParseClass(modifiers));
            }
            else if (m_At->Is("delegate"))
            {
                SkipTo({";"});
            }
            else if (m_At->Is("~"))
            {
                SkipTo({"{", ";"});
                SkipBody();
            }
            else
            {
                ParseMember(result, modifiers);
            }
        }
    }

    void SkipBody() { m_At = m_At->match > 0 ? Closing() + 1 : m_At + 1; }

    void ParseMember(CSharpClass& owner, const Modifiers& modifiers)
    {
        const CSharpToken& first = *m_At;
        if (first.text == owner.name && m_At[1].Is("("))
        {
            ParseMethod(owner, modifiers, "");
            return;
        }
        while (m_At->Is("ref") || (m_At->Is("implicit") || m_At->Is("explicit")))
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
            m_At = Closing() + 1;
            SkipTo({"{", ";"});
            SkipBody();
            return;
        }
        while (m_At->isName() && m_At[1].Is(".")) // IDisposable.Dispose
        {
            m_At += 2;
        }
        if (m_At->isName() && (m_At[1].Is("(") || m_At[1].Is("<")))
        {
            ParseMethod(owner, modifiers, type);
        }
        else if (m_At->isName() && (m_At[1].Is("{") || m_At[1].Is("=>") || m_At[1].Is("[")))
        {
            ParseProperty(owner, modifiers, type);
        }
        else
        {
            ParseFields(owner, modifiers, type);
        }
    }

    void ParseFields(CSharpClass& owner, const Modifiers& modifiers, const std::string& type)
    {
        for (;;)
        {
            CSharpField field;
            field.attributes = modifiers.attributes;
            field.isPublic = modifiers.Has("public");
            field.isConst = modifiers.Has("const");
            field.isStatic = field.isConst || modifiers.Has("static");
            field.isReadonly = modifiers.Has("readonly");
            field.type = type;
            field.location = m_At->location;
            field.name = ExpectName("the name of a field");
            if (m_At->Is("="))
            {
                const CSharpToken* begin = ++m_At;
                SkipPastGenerics();
                field.value = {begin, m_At};
            }
            owner.fields.push_back(std::move(field));
            if (!m_At->Is(","))
            {
                break;
            }
            ++m_At;
        }
        Expect(";", "behind a field");
    }

    /// To the ; or , behind a value; the , of Dictionary<A, B> is none.
    void SkipPastGenerics()
    {
        for (;;)
        {
            SkipTo({";", ",", "<"});
            if (!m_At->Is("<"))
            {
                return;
            }
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
        method.isProtected = modifiers.Has("protected");
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
        const CSharpToken* close = Closing();
        ++m_At;
        while (m_At < close)
        {
            ParseParameter(method, close);
        }
        m_At = close + 1;
        if (m_At->Is(":") && m_At[1].isName() && m_At[2].Is("("))
        {
            m_At += 2;
            method.base = {m_At + 1, Closing()};
            m_At = Closing() + 1;
        }
        SkipTo({"{", ";", "=>"}); // where T : ...
        ParseBody(method);
        owner.methods.push_back(std::move(method));
    }

    void ParseParameter(CSharpMethod& method, const CSharpToken* close)
    {
        while (m_At->Is("["))
        {
            m_At = Closing() + 1;
        }
        while (m_At->Is("ref") || m_At->Is("out") || m_At->Is("in") || m_At->Is("params") ||
               m_At->Is("this") || m_At->Is("readonly") || m_At->Is("scoped"))
        {
            ++m_At;
        }
        CSharpParameter parameter;
        parameter.type = ReadCSharpType(m_At);
        if (parameter.type.empty())
        {
            Fail(*m_At, "a parameter of '" + method.name + "' is expected here");
        }
        parameter.name = ExpectName("the name of a parameter");
        while (m_At < close && !m_At->Is(","))
        {
            m_At = m_At->match > 0 ? Closing() + 1 : m_At + 1;
        }
        m_At += m_At < close ? 1 : 0;
        method.parameters.push_back(std::move(parameter));
    }

    /// At { or => or ;
    void ParseBody(CSharpMethod& method)
    {
        if (m_At->Is("{"))
        {
            method.body = {m_At + 1, Closing()};
            m_At = Closing() + 1;
            return;
        }
        if (m_At->Is("=>"))
        {
            method.isExpression = true;
            const CSharpToken* begin = ++m_At;
            SkipTo({";"});
            method.body = {begin, m_At};
        }
        Expect(";", "behind a method");
    }

    void ParseProperty(CSharpClass& owner, const Modifiers& modifiers, const std::string& type)
    {
        CSharpMethod property = BeginMethod(modifiers, type);
        property.isProperty = true;
        if (m_At->Is("[")) // this[int i]
        {
            m_At = Closing() + 1;
        }
        SkipTo({"{", "=>"});
        ParseBody(property);
        if (m_At->Is("=")) // { get; set; } = 3;
        {
            SkipTo({";"});
            ++m_At;
        }
        owner.methods.push_back(std::move(property));
    }

    CSharpFile& m_File;
    const CSharpToken* m_At;
};

} // namespace

void ParseCSharp(CSharpFile& file)
{
    file.tokens = TokenizeCSharp(file.text, file.path);
    Parser(file).ParseFile();
}

} // namespace limn
