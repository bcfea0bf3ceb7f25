#include "parser/Parser.h"

#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

struct PropertyTypeName
{
    std::string_view name;
    ShaderPropertyType type;
    TextureDimension dimension = TextureDimension::Tex2D;
};

constexpr PropertyTypeName k_PropertyTypes[] = {
    {"Float", ShaderPropertyType::Float},
    {"Range", ShaderPropertyType::Range},
    {"Int", ShaderPropertyType::Int},
    {"Integer", ShaderPropertyType::Integer},
    {"Color", ShaderPropertyType::Color},
    {"Vector", ShaderPropertyType::Vector},
    {"2D", ShaderPropertyType::Texture, TextureDimension::Tex2D},
    {"2DArray", ShaderPropertyType::Texture, TextureDimension::Tex2DArray},
    {"3D", ShaderPropertyType::Texture, TextureDimension::Tex3D},
    {"Cube", ShaderPropertyType::Texture, TextureDimension::Cube},
    {"CubeArray", ShaderPropertyType::Texture, TextureDimension::CubeArray},
    {"Rect", ShaderPropertyType::Texture, TextureDimension::Tex2D},
    {"Any", ShaderPropertyType::Texture, TextureDimension::Tex2D},
};

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
    const bool isVector =
        property.type == ShaderPropertyType::Color || property.type == ShaderPropertyType::Vector;
    isVector                                       ? ParseVectorDefault(property)
    : property.type == ShaderPropertyType::Texture ? ParseTextureDefault(property)
                                                   : ParseNumberDefault(property);
}

void Parser::ParseNumberDefault(ShaderProperty& property)
{
    const int line = m_Token.location.line;
    const auto number = ParseNumber(property.name);
    if (!number)
    {
        SkipProperty(line);
        return;
    }
    property.defaultValue[0] = *number;
}

void Parser::ParseVectorDefault(ShaderProperty& property)
{
    const int line = m_Token.location.line;
    std::size_t count = 0;
    bool good = Expect(property.name, '(');
    while (good && count < 4)
    {
        const auto number = ParseNumber(property.name);
        good = number.has_value();
        if (good)
        {
            property.defaultValue[count++] = *number;
        }
        if (!good || !Accept(','))
        {
            break;
        }
    }
    if (good && count < 3 && isPunctuation(')'))
    {
        Error(property.name + ": " + std::to_string(count) + " numbers are too few; write 3 or 4");
    }
    if (!good || !Expect(property.name, ')'))
    {
        SkipProperty(line);
        return;
    }
    if (count < 4 && property.type == ShaderPropertyType::Color)
    {
        property.defaultValue[3] = 1.0f;
    }
}

void Parser::ParseTextureDefault(ShaderProperty& property)
{
    const int line = m_Token.location.line;
    auto name = ParseString(property.name);
    if (!name)
    {
        SkipProperty(line);
        return;
    }
    property.defaultTexture = std::move(*name);
    if (isPunctuation('{'))
    {
        ParseTextureMode(property);
    }
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
    std::vector<const ShaderProperty*> sorted;
    for (const ShaderProperty& property : m_Result.document.properties)
    {
        sorted.push_back(&property);
    }
    std::ranges::stable_sort(sorted, {},
                             [](const ShaderProperty* property) -> const std::string&
                             { return property->name; });
    const ShaderProperty* reported = nullptr;
    for (std::size_t i = 1; i < sorted.size(); ++i)
    {
        const bool isReported = reported != nullptr && reported->name == sorted[i]->name;
        if (sorted[i]->name == sorted[i - 1]->name && !isReported)
        {
            reported = sorted[i];
            Report(Severity::Warning, sorted[i]->location,
                   sorted[i]->name.substr(0, 80) + ": a property of this name stands in line " +
                       std::to_string(sorted[i - 1]->location.line) +
                       " already; materials have the first one");
        }
    }
}

} // namespace limn
