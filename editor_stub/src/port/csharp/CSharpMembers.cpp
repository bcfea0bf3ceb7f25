#include "port/csharp/CSharpParser.h"

#include <algorithm>

namespace limn
{

namespace
{

/// { get; private set; }: a variable all the same.
bool IsAutomatic(const CSharpMethod& property)
{
    const auto isPlain = [](const CSharpToken& word)
    {
        return word.Is("get") || word.Is("set") || word.Is("init") || word.Is(";") ||
               word.Is("private") || word.Is("protected") || word.Is("internal");
    };
    return !property.isExpression && property.name != "this" && !property.body.empty() &&
           std::ranges::all_of(property.body, isPlain);
}

} // namespace

void CSharpParser::ParseMembers(CSharpClass& result, const CSharpToken* close)
{
    while (m_At < close)
    {
        if (m_At->Is(";"))
        {
            ++m_At;
            continue;
        }
        const CSharpModifiers modifiers = ParseModifiers();
        if (IsClassKeyword(*m_At))
        {
            AddClass(result.classes, ParseClass(modifiers));
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

void CSharpParser::ParseMember(CSharpClass& owner, const CSharpModifiers& modifiers)
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

void CSharpParser::ParseFields(CSharpClass& owner, const CSharpModifiers& modifiers,
                               const std::string& type)
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

void CSharpParser::SkipPastGenerics()
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

CSharpMethod CSharpParser::BeginMethod(const CSharpModifiers& modifiers, const std::string& type)
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

void CSharpParser::ParseMethod(CSharpClass& owner, const CSharpModifiers& modifiers,
                               const std::string& type)
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

void CSharpParser::ParseParameter(CSharpMethod& method, const CSharpToken* close)
{
    while (m_At->Is("["))
    {
        m_At = Closing() + 1;
    }
    CSharpParameter parameter;
    while (m_At->Is("ref") || m_At->Is("out") || m_At->Is("in") || m_At->Is("params") ||
           m_At->Is("this") || m_At->Is("readonly") || m_At->Is("scoped"))
    {
        parameter.isReference = parameter.isReference || m_At->Is("ref") || m_At->Is("out");
        ++m_At;
    }
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

void CSharpParser::ParseBody(CSharpMethod& method)
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

void CSharpParser::ParseProperty(CSharpClass& owner, const CSharpModifiers& modifiers,
                                 const std::string& type)
{
    CSharpMethod property = BeginMethod(modifiers, type);
    property.isProperty = true;
    if (m_At->Is("[")) // this[int i]
    {
        m_At = Closing() + 1;
    }
    SkipTo({"{", "=>"});
    const bool isOfClass = owner.keyword != "interface" && !modifiers.Has("abstract") &&
                           !property.isOverride && !modifiers.Has("new");
    ParseBody(property);
    CSharpWords value;
    if (m_At->Is("=")) // { get; set; } = 3;
    {
        const CSharpToken* begin = ++m_At;
        SkipTo({";"});
        value = {begin, m_At++};
    }
    if (!isOfClass || !IsAutomatic(property))
    {
        owner.methods.push_back(std::move(property));
        return;
    }
    CSharpField field;
    field.attributes = modifiers.attributes;
    field.isPublic = modifiers.Has("public");
    field.isStatic = modifiers.Has("static");
    field.isProperty = true;
    field.type = type;
    field.name = property.name;
    field.location = property.location;
    field.value = value;
    owner.fields.push_back(std::move(field));
}

} // namespace limn
