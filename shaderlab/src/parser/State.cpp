#include "parser/Parser.h"

#include <limn/base/Lists.h>
#include <limn/base/Text.h>
#include <limn/shaderlab/PrintShaderLab.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace limn
{

namespace
{

std::optional<int> ColorMaskOf(std::string_view letters)
{
    constexpr std::string_view k_Letters = "rgba";
    constexpr int k_Bits[] = {ColorWriteMask::Red, ColorWriteMask::Green, ColorWriteMask::Blue,
                              ColorWriteMask::Alpha};
    int mask = 0;
    for (const char letter : letters)
    {
        const std::size_t index = k_Letters.find(ToLower(letter));
        if (index == k_Letters.npos)
        {
            return std::nullopt;
        }
        mask |= k_Bits[index];
    }
    return mask;
}

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
constexpr std::string_view k_CombineSigns[] = {"*", "+", "-", "+-", "Lerp", "Dot3", "Dot3Rgba"};
constexpr std::size_t k_MaxNamed = 5; ///< commands that a note names

} // namespace

template <typename T>
bool Parser::ParseStateReference(std::string_view subject, StateValue<T>& target)
{
    const auto property = ParseReference(subject);
    target = property ? StateValue<T>::FromProperty(*property) : target;
    return property.has_value();
}

template <typename T>
bool Parser::ParseEnum(std::string_view subject,
                       std::type_identity_t<std::span<const EnumName<T>>> names,
                       StateValue<T>& target)
{
    if (isPunctuation('['))
    {
        return ParseStateReference(subject, target);
    }
    for (const EnumName<T>& name : names)
    {
        if (isWord(name.name))
        {
            target = name.value;
            Advance();
            return true;
        }
    }
    if (m_Token.kind != TokenKind::Identifier || isAnyCommand())
    {
        Error(std::string(subject) + ": value is missing before " + Found() +
              "; write a name or [_Property]");
        if (m_Token.kind == TokenKind::Number)
        {
            Advance();
        }
        return false;
    }
    Error(std::string(subject) + ": unknown value " + UnknownName(m_Token.text, NamesIn(names)));
    Advance();
    return false;
}

bool Parser::ParseFloat(std::string_view subject, StateValue<float>& target)
{
    if (isPunctuation('['))
    {
        return ParseStateReference(subject, target);
    }
    const auto number = ParseNumber(subject);
    target = number ? StateValue<float>(*number) : target;
    return number.has_value();
}

template <auto Field, const auto& Names>
void Parser::ParseState()
{
    ParseEnum(m_Word, Names, m_Scope.state.*Field);
}

void Parser::ParseOffset()
{
    RenderState& state = m_Scope.state;
    if (ParseFloat("Offset", state.offsetFactor) && Expect("Offset", ','))
    {
        ParseFloat("Offset", state.offsetUnits);
    }
}

/// Reads the number of a target, if one is there; returns that target, or else all of them.
std::span<PassBlendState> Parser::ParseTargets(std::string_view subject)
{
    const std::span<PassBlendState> all = m_Scope.state.targets;
    if (m_Token.kind != TokenKind::Number)
    {
        return all;
    }
    const float number = m_Token.number;
    const bool exists =
        number >= 0.0f && number < static_cast<float>(all.size()) && number == std::floor(number);
    if (!exists)
    {
        Error(std::string(subject) + ": target " + std::string(m_Token.text.substr(0, 40)) +
              " does not exist; a target is 0...7");
    }
    Advance();
    return exists ? all.subspan(static_cast<std::size_t>(number), 1) : all;
}

void Parser::ParseBlend()
{
    const auto targets = ParseTargets("Blend");
    const auto parse = [this](StateValue<BlendMode>& source, StateValue<BlendMode>& destination)
    {
        return ParseEnum("Blend", k_BlendModes, source) &&
               ParseEnum("Blend", k_BlendModes, destination);
    };
    PassBlendState blend;
    if (isWord("Off") || isWord("False"))
    {
        Advance();
    }
    else
    {
        blend.enabled = true;
        if (!parse(blend.sourceColorBlendMode, blend.destinationColorBlendMode))
        {
            return;
        }
        blend.sourceAlphaBlendMode = blend.sourceColorBlendMode;
        blend.destinationAlphaBlendMode = blend.destinationColorBlendMode;
        if (Accept(',') && !parse(blend.sourceAlphaBlendMode, blend.destinationAlphaBlendMode))
        {
            return;
        }
    }
    for (PassBlendState& target : targets)
    {
        target.enabled = blend.enabled;
        target.sourceColorBlendMode = blend.sourceColorBlendMode;
        target.destinationColorBlendMode = blend.destinationColorBlendMode;
        target.sourceAlphaBlendMode = blend.sourceAlphaBlendMode;
        target.destinationAlphaBlendMode = blend.destinationAlphaBlendMode;
    }
}

void Parser::ParseBlendOp()
{
    const auto targets = ParseTargets("BlendOp");
    StateValue<BlendOp> color;
    if (!ParseEnum("BlendOp", k_BlendOps, color))
    {
        return;
    }
    StateValue<BlendOp> alpha = color;
    if (Accept(',') && !ParseEnum("BlendOp", k_BlendOps, alpha))
    {
        return;
    }
    for (PassBlendState& target : targets)
    {
        target.colorBlendOperation = color;
        target.alphaBlendOperation = alpha;
    }
}

void Parser::ParseColorMask()
{
    StateValue<int> mask;
    const bool isReference = isPunctuation('[');
    if (isReference && !ParseStateReference("ColorMask", mask))
    {
        return;
    }
    if (!isReference)
    {
        const bool none = isWord("Off") || isWord("False") ||
                          (m_Token.kind == TokenKind::Number && m_Token.text == "0");
        const auto letters = none ? 0 : ColorMaskOf(m_Token.text);
        if (!letters || (!none && m_Token.kind != TokenKind::Identifier))
        {
            Error("ColorMask: " + Found() + " is no mask; write letters of RGBA, 0 or [_Property]");
            if (!isPunctuation('}') && !isAnyCommand())
            {
                Advance();
            }
            return;
        }
        Advance();
        mask = *letters;
    }
    for (PassBlendState& target : ParseTargets("ColorMask"))
    {
        target.writeMask = mask;
    }
}

const Parser::CommandTable& Parser::StencilCommands()
{
    using Face = StencilFaceState;
    static const CommandTable table = {
        {"Ref", &Parser::ParseStencilByte<&PassStencilState::reference>},
        {"ReadMask", &Parser::ParseStencilByte<&PassStencilState::readMask>},
        {"WriteMask", &Parser::ParseStencilByte<&PassStencilState::writeMask>},
        {"Comp", &Parser::ParseStencilFaces<&Face::compare, k_CompareFunctions>},
        {"CompFront", &Parser::ParseStencilFaces<&Face::compare, k_CompareFunctions>},
        {"CompBack", &Parser::ParseStencilFaces<&Face::compare, k_CompareFunctions>},
        {"Pass", &Parser::ParseStencilFaces<&Face::pass, k_StencilOps>},
        {"PassFront", &Parser::ParseStencilFaces<&Face::pass, k_StencilOps>},
        {"PassBack", &Parser::ParseStencilFaces<&Face::pass, k_StencilOps>},
        {"Fail", &Parser::ParseStencilFaces<&Face::fail, k_StencilOps>},
        {"FailFront", &Parser::ParseStencilFaces<&Face::fail, k_StencilOps>},
        {"FailBack", &Parser::ParseStencilFaces<&Face::fail, k_StencilOps>},
        {"ZFail", &Parser::ParseStencilFaces<&Face::zFail, k_StencilOps>},
        {"ZFailFront", &Parser::ParseStencilFaces<&Face::zFail, k_StencilOps>},
        {"ZFailBack", &Parser::ParseStencilFaces<&Face::zFail, k_StencilOps>},
    };
    return table;
}

void Parser::ParseStencil()
{
    // A block replaces what an outer scope set: fields it does not name have their defaults.
    m_Scope.state.stencil = PassStencilState{};
    m_Scope.state.stencil.enabled = true;
    ParseBlock("Stencil", StencilCommands());
}

template <StateValue<int> PassStencilState::*Field>
void Parser::ParseStencilByte()
{
    StateValue<int>& target = m_Scope.state.stencil.*Field;
    if (isPunctuation('['))
    {
        ParseStateReference(m_Word, target);
        return;
    }
    const Token token = m_Token;
    const auto number = ParseNumber(m_Word);
    if (!number)
    {
        return;
    }
    if (*number < 0.0f || *number > 255.0f)
    {
        Report(Severity::Warning, token.location,
               std::string(m_Word) + ": " + std::string(token.text) +
                   " does not fit into 8 bits, so only its lowest 8 count; write 0...255");
    }
    target = static_cast<int>(std::clamp(*number, -65536.0f, 65536.0f)) & 0xFF;
}

template <auto Field, const auto& Names>
void Parser::ParseStencilFaces()
{
    auto value = StencilFaceState{}.*Field;
    if (ParseEnum(m_Word, Names, value))
    {
        PassStencilState& stencil = m_Scope.state.stencil;
        stencil.front.*Field = m_Word.ends_with("Back") ? stencil.front.*Field : value;
        stencil.back.*Field = m_Word.ends_with("Front") ? stencil.back.*Field : value;
    }
}

/// Keeps m_Legacy as a command of the current scope.
void Parser::AddLegacy(SourceLocation location, bool isGood)
{
    if (isGood && Count())
    {
        m_Scope.legacyCommands.push_back({location, m_Legacy});
    }
}

template <bool (Parser::*Append)()>
void Parser::ParseLegacyCommand()
{
    m_Legacy = m_Word;
    AddLegacy(m_Command, (this->*Append)());
}

template <bool (Parser::*Append)()>
void Parser::ParseLegacyField()
{
    m_Legacy += " " + std::string(m_Word);
    (this->*Append)();
}

template <const auto& Names>
bool Parser::AppendName()
{
    StateValue<decltype(Names[0].value)> value;
    const bool isGood = ParseEnum(m_Word, Names, value);
    m_Legacy += isGood ? " " + NameOf(Names, value) : "";
    return isGood;
}

bool Parser::AppendAlphaTest()
{
    const bool isOff = isWord("Off") || isWord("False");
    if (!isOff && !isWord("On") && !isWord("True"))
    {
        return AppendName<k_CompareFunctions>() && AppendNumber();
    }
    Advance();
    m_Legacy += isOff ? " Off" : " On";
    return isOff || AppendNumber();
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

bool Parser::AppendRange()
{
    if (!AppendNumber() || !Expect("Range", ','))
    {
        return false;
    }
    m_Legacy += ",";
    return AppendNumber();
}

bool Parser::AppendCombine()
{
    if (!AppendCombination())
    {
        return false;
    }
    if (!Accept(','))
    {
        return true;
    }
    m_Legacy += ",";
    return AppendCombination();
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
        const auto* const sign =
            std::ranges::find_if(k_CombineSigns, [&](std::string_view each)
                                 { return EqualsIgnoringCase(each, m_Token.text); });
        if (sign == std::end(k_CombineSigns) || m_Token.kind == TokenKind::String)
        {
            break;
        }
        m_Legacy += " " + std::string(*sign);
        Advance();
        if ((*sign == "Lerp" && !AppendLerpFactor()) || !AppendCombineSource())
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
    if (!AppendName<k_CombineSources>())
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

const Parser::CommandTable& Parser::LegacyBlockCommands(std::string_view command)
{
    static const CommandTable material = {
        {"Diffuse", &Parser::ParseLegacyField<&Parser::AppendColor>},
        {"Ambient", &Parser::ParseLegacyField<&Parser::AppendColor>},
        {"Specular", &Parser::ParseLegacyField<&Parser::AppendColor>},
        {"Emission", &Parser::ParseLegacyField<&Parser::AppendColor>},
        {"Shininess", &Parser::ParseLegacyField<&Parser::AppendNumber>},
    };
    static const CommandTable fog = {
        {"Mode", &Parser::ParseLegacyField<&Parser::AppendName<k_FogModes>>},
        {"Color", &Parser::ParseLegacyField<&Parser::AppendColor>},
        {"Density", &Parser::ParseLegacyField<&Parser::AppendNumber>},
        {"Range", &Parser::ParseLegacyField<&Parser::AppendRange>},
    };
    static const CommandTable channels = {{"Bind", &Parser::ParseBind}};
    static const CommandTable texture = {
        {"Matrix", &Parser::ParseLegacyField<&Parser::AppendReference>},
        {"ConstantColor", &Parser::ParseLegacyField<&Parser::AppendColor>},
        {"Combine", &Parser::ParseLegacyField<&Parser::AppendCombine>},
    };
    return command == "Material"       ? material
           : command == "Fog"          ? fog
           : command == "BindChannels" ? channels
                                       : texture;
}

/// State, legacy state and include blocks may stand in every scope from Category to Pass.
Parser::CommandTable Parser::WithCommonCommands(CommandTable table)
{
    const CommandTable common = {
        {"Cull", &Parser::ParseState<&RenderState::cull, k_CullModes>},
        {"ZTest", &Parser::ParseState<&RenderState::zTest, k_DepthTests>},
        {"ZWrite", &Parser::ParseState<&RenderState::zWrite, k_Bools>},
        {"ZClip", &Parser::ParseState<&RenderState::zClip, k_Bools>},
        {"Offset", &Parser::ParseOffset},
        {"Blend", &Parser::ParseBlend},
        {"BlendOp", &Parser::ParseBlendOp},
        {"ColorMask", &Parser::ParseColorMask},
        {"AlphaToMask", &Parser::ParseState<&RenderState::alphaToMask, k_Bools>},
        {"Conservative", &Parser::ParseState<&RenderState::conservative, k_Bools>},
        {"Stencil", &Parser::ParseStencil},
        {"Lighting", &Parser::ParseLegacyCommand<&Parser::AppendName<k_Bools>>},
        {"SeparateSpecular", &Parser::ParseLegacyCommand<&Parser::AppendName<k_Bools>>},
        {"ColorMaterial", &Parser::ParseLegacyCommand<&Parser::AppendName<k_ColorMaterials>>},
        {"Color", &Parser::ParseLegacyCommand<&Parser::AppendColor>},
        {"Material", &Parser::ParseLegacyBlock},
        {"Fog", &Parser::ParseLegacyBlock},
        {"AlphaTest", &Parser::ParseLegacyCommand<&Parser::AppendAlphaTest>},
        {"BindChannels", &Parser::ParseLegacyBlock},
        {"HLSLINCLUDE", &Parser::ParseIncludeBlock, true},
        {"CGINCLUDE", &Parser::ParseIncludeBlock, true},
        {"GLSLINCLUDE", &Parser::ParseIncludeBlock, true},
    };
    table.insert(table.end(), common.begin(), common.end());
    return table;
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
        AddOnce(command.text.substr(0, command.text.find(' ')), names);
    }
    const std::size_t named = std::min(names.size(), k_MaxNamed);
    const std::string list =
        Joined(std::span(names).first(named), ", ") + (named < names.size() ? ", ..." : "");
    Report(Severity::Note, m_NotedLegacy,
           pass.program ? list + ": it is ignored, since the pass has a program"
                        : list + ": limn makes no program of fixed-function commands, so the pass "
                                 "draws nothing; write an HLSLPROGRAM");
}

} // namespace limn
