#include "parser/Parser.h"

#include <limn/shaderlab/PrintShaderLab.h>

#include <algorithm>

namespace limn
{

namespace
{

constexpr EnumName<int> k_ColorMaterials[] = {{"AmbientAndDiffuse", 0}, {"Emission", 1}};
constexpr EnumName<int> k_FogModes[] = {
    {"Off", 0}, {"Global", 1}, {"Linear", 2}, {"Exp", 3}, {"Exp2", 4},
};
constexpr EnumName<int> k_CombineSources[] = {
    {"Previous", 0},
    {"Primary", 1},
    {"Texture", 2},
    {"Constant", 3},
};
constexpr std::size_t k_MaxNamed = 5; ///< commands that a note names

} // namespace

const Parser::CommandTable& Parser::LegacyBlockCommands(std::string_view command)
{
    static const CommandTable material = {
        {"Diffuse", &Parser::ParseLegacyColorField},
        {"Ambient", &Parser::ParseLegacyColorField},
        {"Specular", &Parser::ParseLegacyColorField},
        {"Emission", &Parser::ParseLegacyColorField},
        {"Shininess", &Parser::ParseLegacyNumberField},
    };
    static const CommandTable fog = {
        {"Mode", &Parser::ParseFogMode},
        {"Color", &Parser::ParseLegacyColorField},
        {"Density", &Parser::ParseLegacyNumberField},
        {"Range", &Parser::ParseFogRange},
    };
    static const CommandTable channels = {{"Bind", &Parser::ParseBind}};
    static const CommandTable texture = {
        {"Matrix", &Parser::ParseMatrix},
        {"ConstantColor", &Parser::ParseLegacyColorField},
        {"Combine", &Parser::ParseCombine},
    };
    return command == "Material"       ? material
           : command == "Fog"          ? fog
           : command == "BindChannels" ? channels
                                       : texture;
}

/// Keeps m_Legacy as a command of the current scope.
void Parser::AddLegacy(SourceLocation location, bool isGood)
{
    if (isGood && Count())
    {
        m_Scope.legacyCommands.push_back({location, m_Legacy});
    }
}

void Parser::ParseLegacySwitch()
{
    m_Legacy = m_Word;
    AddLegacy(m_Command, AppendName<bool>(k_Bools));
}

void Parser::ParseColorMaterial()
{
    m_Legacy = m_Word;
    AddLegacy(m_Command, AppendName<int>(k_ColorMaterials));
}

void Parser::ParseLegacyColor()
{
    m_Legacy = m_Word;
    AddLegacy(m_Command, AppendColor());
}

void Parser::ParseAlphaTest()
{
    m_Legacy = m_Word;
    const bool isOff = isWord("Off") || isWord("False");
    if (isOff || isWord("On") || isWord("True"))
    {
        Advance();
        m_Legacy += isOff ? " Off" : " On";
        AddLegacy(m_Command, isOff || AppendNumber());
    }
    else
    {
        AddLegacy(m_Command, AppendName<CompareFunction>(k_CompareFunctions) && AppendNumber());
    }
}

void Parser::ParseLegacyBlock()
{
    const SourceLocation location = m_Command;
    const std::string_view word = m_Word;
    m_Legacy = std::string(word) + " {";
    ParseBlock(word, LegacyBlockCommands(word));
    m_Legacy += " }";
    AddLegacy(location, true);
}

void Parser::ParseSetTexture()
{
    const SourceLocation location = m_Command;
    m_Legacy = m_Word;
    if (!isPunctuation('['))
    {
        Error("SetTexture: the texture is missing before " + Found() + "; write [_Property]");
        if (isPunctuation('{'))
        {
            SkipTokenOrBraces();
        }
        return;
    }
    const bool isGood = AppendReference();
    if (isPunctuation('{'))
    {
        m_Legacy += " {";
        ParseBlock("SetTexture", LegacyBlockCommands("SetTexture"));
        m_Legacy += " }";
    }
    AddLegacy(location, isGood);
}

void Parser::ParseBind()
{
    const auto source = ParseString("Bind");
    if (!source || !Expect("Bind", ','))
    {
        return;
    }
    if (m_Token.kind != TokenKind::Identifier)
    {
        Error("Bind: the vertex channel is missing before " + Found());
        return;
    }
    m_Legacy += " Bind \"" + *source + "\", " + std::string(Advance().text);
}

void Parser::ParseFogMode()
{
    m_Legacy += " Mode";
    AppendName<int>(k_FogModes);
}

void Parser::ParseFogRange()
{
    m_Legacy += " Range";
    if (AppendNumber() && Expect("Range", ','))
    {
        m_Legacy += ",";
        AppendNumber();
    }
}

void Parser::ParseLegacyNumberField()
{
    m_Legacy += " " + std::string(m_Word);
    AppendNumber();
}

void Parser::ParseLegacyColorField()
{
    m_Legacy += " " + std::string(m_Word);
    AppendColor();
}

void Parser::ParseMatrix()
{
    m_Legacy += " Matrix";
    AppendReference();
}

void Parser::ParseCombine()
{
    m_Legacy += " Combine";
    if (AppendCombination() && Accept(','))
    {
        m_Legacy += ",";
        AppendCombination();
    }
}

/// Sources and what is between them: `Texture * Primary + Constant Double`.
bool Parser::AppendCombination()
{
    if (!AppendCombineSource())
    {
        return false;
    }
    for (;;)
    {
        const bool isSign = isPunctuation('*') || isPunctuation('+') || isPunctuation('-') ||
                            (m_Token.kind == TokenKind::Punctuation && m_Token.text == "+-");
        const bool isLerp = isWord("Lerp");
        if (!isSign && !isLerp && !isWord("Dot3") && !isWord("Dot3Rgba"))
        {
            break;
        }
        const std::string name = isWord("Dot3") ? "Dot3" : isLerp ? "Lerp" : "Dot3Rgba";
        m_Legacy += " " + (isSign ? std::string(m_Token.text) : name);
        Advance();
        if ((isLerp && !AppendLerpFactor()) || !AppendCombineSource())
        {
            return false;
        }
    }
    if (isWord("Double") || isWord("Quad"))
    {
        m_Legacy += isWord("Quad") ? " Quad" : " Double";
        Advance();
    }
    return true;
}

bool Parser::AppendLerpFactor()
{
    if (!Expect("Lerp", '('))
    {
        return false;
    }
    m_Legacy += " (";
    const std::size_t begin = m_Legacy.size();
    const bool isGood = AppendCombineSource() && Expect("Lerp", ')');
    m_Legacy.erase(begin, 1); // the blank in front of the source
    m_Legacy += ")";
    return isGood;
}

bool Parser::AppendCombineSource()
{
    if (isWord("One"))
    {
        Advance();
        m_Legacy += " One -";
        if (!Expect("Combine", '-'))
        {
            return false;
        }
    }
    if (isPunctuation('['))
    {
        Error("Combine: '[' is no source; write Previous, Primary, Texture or Constant");
        bool isClosed = false;
        m_Lexer.ReadBracket(isClosed);
        Advance();
        return false;
    }
    if (!AppendName<int>(k_CombineSources))
    {
        return false;
    }
    if (isWord("Alpha"))
    {
        m_Legacy += " Alpha";
        Advance();
    }
    return true;
}

bool Parser::AppendNumber()
{
    StateValue<float> value;
    const bool isGood = ParseFloat(m_Word, value);
    m_Legacy += " " + StateText(value);
    return isGood;
}

bool Parser::AppendColor()
{
    if (isPunctuation('['))
    {
        return AppendReference();
    }
    if (!Expect(m_Word, '('))
    {
        return false;
    }
    const char* separator = " (";
    for (int count = 0; count < 4; ++count)
    {
        StateValue<float> value;
        if (!ParseFloat(m_Word, value))
        {
            return false;
        }
        m_Legacy += separator + StateText(value);
        separator = ", ";
        if (!Accept(','))
        {
            break;
        }
    }
    m_Legacy += ")";
    return Expect(m_Word, ')');
}

bool Parser::AppendReference()
{
    const auto property = ParseReference(m_Word);
    m_Legacy += " [" + property.value_or("") + "]";
    return property.has_value();
}

template <typename T>
bool Parser::AppendName(std::span<const EnumName<T>> names)
{
    StateValue<T> value;
    if (!ParseEnum<T>(m_Word, names, value))
    {
        return false;
    }
    const auto name = std::ranges::find(names, value.value, &EnumName<T>::value);
    m_Legacy +=
        " " + (value.property.empty() ? std::string(name->name) : "[" + value.property + "]");
    return true;
}

/// Adds a note, once for a list of commands, that nothing is drawn with them.
void Parser::NoteLegacyCommands(const ShaderLabPass& pass)
{
    if (pass.legacyCommands.empty() || pass.legacyCommands[0].location == m_NotedLegacy)
    {
        return;
    }
    m_NotedLegacy = pass.legacyCommands[0].location;
    std::vector<std::string> names;
    for (const LegacyCommand& command : pass.legacyCommands)
    {
        std::string name = command.text.substr(0, command.text.find(' '));
        if (std::find(names.begin(), names.end(), name) == names.end())
        {
            names.push_back(std::move(name));
        }
    }
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), k_MaxNamed); ++i)
    {
        list += (i == 0 ? "" : ", ") + names[i];
    }
    list += names.size() > k_MaxNamed ? ", ..." : "";
    Report(Severity::Note, m_NotedLegacy,
           pass.program ? list + ": it is ignored, since the pass has a program"
                        : list + ": limn makes no program of fixed-function commands, so the pass "
                                 "draws nothing; write an HLSLPROGRAM");
}

} // namespace limn
