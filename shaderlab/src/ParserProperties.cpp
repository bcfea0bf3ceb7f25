#include "Parser.h"

#include "Text.h"

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

} // namespace

void Parser::ParseProperties()
{
    const SourceLocation opening = m_Token.location;
    if (!Expect("Properties", "{"))
    {
        SkipUnknown();
        return;
    }
    while (!Accept("}"))
    {
        if (m_Token.kind == TokenKind::End)
        {
            Error("Properties: '{' of line " + std::to_string(opening.line) +
                  " is never closed; add '}'");
            return;
        }
        ParseProperty();
    }
}

void Parser::ParseProperty()
{
    ShaderProperty property;
    while (isPunctuation("["))
    {
        bool closed = false;
        const SourceLocation location = m_Token.location;
        const std::string_view text = Trim(m_Lexer.ReadBracket(closed));
        Advance();
        property.attributes.push_back({location, std::string(text)});
        if (!closed)
        {
            Report(Severity::Error, location, "attribute: ']' is missing on this line");
        }
    }
    if (m_Token.kind != TokenKind::Identifier)
    {
        Error("Properties: the name of a property is missing before " + Found());
        SkipProperty();
        return;
    }
    property.location = m_Token.location;
    property.name = std::string(Advance().text);
    if (!Expect(property.name, "("))
    {
        SkipProperty();
        return;
    }
    const auto displayName = ParseString(property.name);
    if (!displayName || !Expect(property.name, ",") || !ParsePropertyType(property) ||
        !Expect(property.name, ")"))
    {
        SkipProperty();
        return;
    }
    property.displayName = *displayName;
    if (Accept("="))
    {
        ParsePropertyDefault(property);
    }
    m_Result.document.properties.push_back(std::move(property));
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
            return property.type != ShaderPropertyType::Range || ParseRangeLimits(property);
        }
    }
    std::vector<std::string_view> known;
    for (const PropertyTypeName& candidate : k_PropertyTypes)
    {
        known.push_back(candidate.name);
    }
    Error(property.name + ": unknown property type " + UnknownName(m_Token.text, known));
    return false;
}

bool Parser::ParseRangeLimits(ShaderProperty& property)
{
    if (!Expect(property.name, "("))
    {
        return false;
    }
    const auto minimum = ParseNumber(property.name);
    if (!minimum || !Expect(property.name, ","))
    {
        return false;
    }
    const auto maximum = ParseNumber(property.name);
    if (!maximum || !Expect(property.name, ")"))
    {
        return false;
    }
    property.rangeMin = static_cast<float>(*minimum);
    property.rangeMax = static_cast<float>(*maximum);
    return true;
}

void Parser::ParsePropertyDefault(ShaderProperty& property)
{
    switch (property.type)
    {
    case ShaderPropertyType::Color:
    case ShaderPropertyType::Vector:
        ParseVectorDefault(property);
        return;
    case ShaderPropertyType::Texture:
        ParseTextureDefault(property);
        return;
    default:
        ParseNumberDefault(property);
    }
}

void Parser::ParseNumberDefault(ShaderProperty& property)
{
    const auto number = ParseNumber(property.name);
    if (!number)
    {
        SkipProperty();
        return;
    }
    property.defaultValue[0] = static_cast<float>(*number);
}

void Parser::ParseVectorDefault(ShaderProperty& property)
{
    std::size_t count = 0;
    bool good = Expect(property.name, "(");
    while (good && count < 4)
    {
        const auto number = ParseNumber(property.name);
        good = number.has_value();
        if (good)
        {
            property.defaultValue[count++] = static_cast<float>(*number);
        }
        if (!good || !Accept(","))
        {
            break;
        }
    }
    if (!good || !Expect(property.name, ")"))
    {
        SkipProperty();
        return;
    }
    if (count < 4 && property.type == ShaderPropertyType::Color)
    {
        property.defaultValue[3] = 1.0f;
    }
}

void Parser::ParseTextureDefault(ShaderProperty& property)
{
    const auto name = ParseString(property.name);
    if (!name)
    {
        SkipProperty();
        return;
    }
    property.defaultTexture = *name;
    // The braces held texture generation modes of Unity 4; nothing in them has an effect today.
    if (isPunctuation("{"))
    {
        SkipBraces();
    }
}

void Parser::SkipProperty()
{
    // Properties start on a line of their own; what is left of the broken one stands on its line.
    const int line = m_Token.location.line;
    while (m_Token.kind != TokenKind::End && m_Token.location.line == line && !isPunctuation("}"))
    {
        if (isPunctuation("{"))
        {
            SkipBraces();
        }
        else
        {
            Advance();
        }
    }
}

} // namespace limn
