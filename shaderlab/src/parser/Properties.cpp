#include "parser/Parser.h"

#include <limn/base/Text.h>

#include <map>

namespace limn
{

namespace
{

constexpr std::string_view k_TextureModes[] = {
    "TexGen",      "SphereMap",  "EyeLinear", "ObjectLinear",
    "CubeReflect", "CubeNormal", "Matrix",    "LightmapMode",
};

std::string_view NameOfTextureMode(std::string_view word)
{
    for (const std::string_view name : k_TextureModes)
    {
        word = EqualsIgnoringCase(name, word) ? name : word;
    }
    return word;
}

} // namespace

void Parser::ParseProperties()
{
    const SourceLocation opening = m_Token.location;
    if (!Expect("Properties", '{'))
    {
        SkipUnknown();
        return;
    }
    while (!Accept('}'))
    {
        if (m_Token.kind == TokenKind::End)
        {
            ReportNotClosed("Properties", opening);
            break;
        }
        // Properties may be called like commands, but then a parenthesis follows.
        if (m_Token.kind == TokenKind::Identifier && isAnyCommand() && !m_Lexer.isNext('('))
        {
            ReportStillOpen("Properties", opening);
            break;
        }
        ParseProperty();
    }
    ReportDuplicateProperties();
}

void Parser::ParseProperty()
{
    ShaderProperty property;
    const int line = m_Token.location.line;
    if (!ParseAttributes(property) || !ParsePropertyHead(property))
    {
        SkipProperty(line);
        return;
    }
    if (Accept('='))
    {
        ParsePropertyDefault(property);
    }
    if (Count())
    {
        m_Result.document.properties.push_back(std::move(property));
    }
}

bool Parser::ParseAttributes(ShaderProperty& property)
{
    while (isPunctuation('['))
    {
        bool closed = false;
        const SourceLocation location = m_Token.location;
        const std::string_view text = Trim(m_Lexer.ReadBracket(closed));
        Advance();
        if (!closed)
        {
            Report(Severity::Error, location, "attribute: ']' is missing on this line");
        }
        if (Count())
        {
            property.attributes.push_back({location, std::string(text)});
        }
    }
    return !m_IsStopped;
}

/// `name("display name", type)`
bool Parser::ParsePropertyHead(ShaderProperty& property)
{
    if (m_Token.kind != TokenKind::Identifier)
    {
        Error("Properties: the name of a property is missing before " + Found());
        return false;
    }
    property.location = m_Token.location;
    property.name = std::string(Advance().text);
    const std::string subject = property.name.substr(0, 80);
    if (!Expect(subject, '('))
    {
        return false;
    }
    auto displayName = ParseString(subject);
    if (!displayName || !Expect(subject, ',') || !ParsePropertyType(property) ||
        !Expect(subject, ')'))
    {
        return false;
    }
    property.displayName = std::move(*displayName);
    return true;
}

bool Parser::ParsePropertyType(ShaderProperty& property)
{
    for (const PropertyTypeName& candidate : k_PropertyTypes)
    {
        if (isWord(candidate.name))
        {
            Advance();
            property.type = candidate.type;
            property.dimension = candidate.dimension;
            property.textureType =
                property.type == ShaderPropertyType::Texture ? candidate.name : "";
            return property.type != ShaderPropertyType::Range || ParseRangeLimits(property);
        }
    }
    Error(property.name.substr(0, 80) + ": unknown property type " +
          UnknownName(m_Token.text, NamesIn(k_PropertyTypes)));
    return false;
}

bool Parser::ParseRangeLimits(ShaderProperty& property)
{
    const auto minimum =
        Expect(property.name, '(') ? ParseNumber(property.name) : std::optional<float>();
    const auto maximum =
        minimum && Expect(property.name, ',') ? ParseNumber(property.name) : std::optional<float>();
    if (!maximum || !Expect(property.name, ')'))
    {
        return false;
    }
    property.rangeMin = *minimum;
    property.rangeMax = *maximum;
    return true;
}

void Parser::ParsePropertyDefault(ShaderProperty& property)
{
    const int line = m_Token.location.line;
    const bool isVector =
        property.type == ShaderPropertyType::Color || property.type == ShaderPropertyType::Vector;
    const bool isGood = isVector ? ParseVectorDefault(property)
                        : property.type == ShaderPropertyType::Texture
                            ? ParseTextureDefault(property)
                            : ParseNumberDefault(property);
    if (!isGood)
    {
        SkipProperty(line);
    }
}

bool Parser::ParseNumberDefault(ShaderProperty& property)
{
    if (isPunctuation('(')) // Unity takes it
    {
        Report(Severity::Warning, m_Token.location,
               property.name + ": a list has more numbers than the property; write one number");
        const bool isGood = ParseVectorDefault(property);
        property.defaultValue = {property.defaultValue[0]};
        return isGood;
    }
    const auto number = ParseNumber(property.name);
    property.defaultValue[0] = number.value_or(0.0f);
    return number.has_value();
}

bool Parser::ParseVectorDefault(ShaderProperty& property)
{
    if (!Expect(property.name, '('))
    {
        return false;
    }
    std::size_t count = 0;
    do
    {
        const auto number = ParseNumber(property.name);
        if (!number)
        {
            return false;
        }
        property.defaultValue[count++] = *number;
    } while (Accept(',') && count < 4);
    if (count < 3 && isPunctuation(')'))
    {
        Error(property.name + ": " + std::to_string(count) + " numbers are too few; write 3 or 4");
    }
    if (!Expect(property.name, ')'))
    {
        return false;
    }
    if (count < 4 && property.type == ShaderPropertyType::Color)
    {
        property.defaultValue[3] = 1.0f;
    }
    return true;
}

bool Parser::ParseTextureDefault(ShaderProperty& property)
{
    auto name = ParseString(property.name);
    if (!name)
    {
        return false;
    }
    property.defaultTexture = std::move(*name);
    if (isPunctuation('{'))
    {
        ParseTextureMode(property);
    }
    return true;
}

/// The braces held texture generation modes of Unity 4; nothing in them has an effect today.
void Parser::ParseTextureMode(ShaderProperty& property)
{
    Advance();
    std::string text;
    while (!isPunctuation('}') && m_Token.kind != TokenKind::End)
    {
        text += text.empty() ? "" : " ";
        if (isPunctuation('['))
        {
            text += "[" + ParseReference(property.name).value_or("") + "]";
        }
        else if (m_Token.kind == TokenKind::Identifier && !isAnyCommand())
        {
            text += NameOfTextureMode(Advance().text);
        }
        else
        {
            break;
        }
    }
    if (Expect(property.name, '}'))
    {
        property.textureMode = std::move(text);
    }
}

/// Properties start on a line of their own; what is left of a broken one stands on its line.
void Parser::SkipProperty(int line)
{
    while (m_Token.kind != TokenKind::End && m_Token.location.line == line && !isPunctuation('}'))
    {
        SkipTokenOrBraces();
    }
}

/// Duplicates are kept, since inspectors show them all; a material has the first of each name.
void Parser::ReportDuplicateProperties()
{
    std::map<std::string_view, std::vector<const ShaderProperty*>> byName;
    for (const ShaderProperty& property : m_Result.document.properties)
    {
        byName[property.name].push_back(&property);
    }
    for (const auto& [name, properties] : byName)
    {
        if (properties.size() > 1)
        {
            Report(Severity::Warning, properties[1]->location,
                   std::string(name.substr(0, 80)) + ": a property of this name stands in line " +
                       std::to_string(properties[0]->location.line) +
                       " already; materials have the first one");
        }
    }
}

} // namespace limn
