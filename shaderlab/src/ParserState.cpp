#include "Parser.h"

#include "Text.h"

#include <array>
#include <cmath>

namespace limn
{

namespace
{

constexpr EnumName<CullMode> k_CullModes[] = {
    {"Back", CullMode::Back},
    {"Front", CullMode::Front},
    {"Off", CullMode::Off},
    {"False", CullMode::Off},
};

// `Off` means no depth test at all, which is not the same as `Always`: it writes no depth either.
constexpr EnumName<CompareFunction> k_DepthTests[] = {
    {"Never", CompareFunction::Never},         {"Less", CompareFunction::Less},
    {"Equal", CompareFunction::Equal},         {"LEqual", CompareFunction::LessEqual},
    {"Greater", CompareFunction::Greater},     {"NotEqual", CompareFunction::NotEqual},
    {"GEqual", CompareFunction::GreaterEqual}, {"Always", CompareFunction::Always},
    {"NEqual", CompareFunction::NotEqual},     {"Disabled", CompareFunction::Disabled},
    {"Off", CompareFunction::Disabled},        {"False", CompareFunction::Disabled},
    {"On", CompareFunction::LessEqual},        {"True", CompareFunction::LessEqual},
};
constexpr std::size_t k_CompareNames = 9; ///< of k_DepthTests: those that Stencil knows too

constexpr EnumName<bool> k_Bools[] = {
    {"On", true},
    {"Off", false},
    {"True", true},
    {"False", false},
};

constexpr EnumName<BlendMode> k_BlendModes[] = {
    {"One", BlendMode::One},
    {"Zero", BlendMode::Zero},
    {"SrcColor", BlendMode::SrcColor},
    {"SrcAlpha", BlendMode::SrcAlpha},
    {"SrcAlphaSaturate", BlendMode::SrcAlphaSaturate},
    {"DstColor", BlendMode::DstColor},
    {"DstAlpha", BlendMode::DstAlpha},
    {"OneMinusSrcColor", BlendMode::OneMinusSrcColor},
    {"OneMinusSrcAlpha", BlendMode::OneMinusSrcAlpha},
    {"OneMinusDstColor", BlendMode::OneMinusDstColor},
    {"OneMinusDstAlpha", BlendMode::OneMinusDstAlpha},
};

constexpr EnumName<BlendOp> k_BlendOps[] = {
    {"Add", BlendOp::Add}, {"Sub", BlendOp::Subtract}, {"RevSub", BlendOp::ReverseSubtract},
    {"Min", BlendOp::Min}, {"Max", BlendOp::Max},
};

constexpr std::string_view k_UnsupportedBlendOps[] = {
    "LogicalClear",      "LogicalSet",
    "LogicalCopy",       "LogicalCopyInverted",
    "LogicalNoop",       "LogicalInvert",
    "LogicalAnd",        "LogicalNand",
    "LogicalOr",         "LogicalNor",
    "LogicalXor",        "LogicalEquiv",
    "LogicalAndReverse", "LogicalAndInverted",
    "LogicalOrReverse",  "LogicalOrInverted",
    "Multiply",          "Screen",
    "Overlay",           "Darken",
    "Lighten",           "ColorDodge",
    "ColorBurn",         "HardLight",
    "SoftLight",         "Difference",
    "Exclusion",         "HSLHue",
    "HSLSaturation",     "HSLColor",
    "HSLLuminosity",
};

std::optional<int> ColorMaskOf(std::string_view letters)
{
    int mask = 0;
    for (const char letter : letters)
    {
        switch (ToLower(letter))
        {
        case 'r':
            mask |= ColorWriteMask::Red;
            break;
        case 'g':
            mask |= ColorWriteMask::Green;
            break;
        case 'b':
            mask |= ColorWriteMask::Blue;
            break;
        case 'a':
            mask |= ColorWriteMask::Alpha;
            break;
        default:
            return std::nullopt;
        }
    }
    return mask;
}

} // namespace

std::span<const EnumName<CompareFunction>> CompareFunctionNames()
{
    return std::span(k_DepthTests).first(k_CompareNames);
}

void Parser::AppendStateCommands(CommandTable& table)
{
    const CommandTable state = {
        {"Cull", &Parser::ParseCull},
        {"ZTest", &Parser::ParseZTest},
        {"ZWrite", &Parser::ParseZWrite},
        {"ZClip", &Parser::ParseZClip},
        {"Offset", &Parser::ParseOffset},
        {"Blend", &Parser::ParseBlend},
        {"BlendOp", &Parser::ParseBlendOp},
        {"ColorMask", &Parser::ParseColorMask},
        {"AlphaToMask", &Parser::ParseAlphaToMask},
        {"Conservative", &Parser::ParseConservative},
        {"Stencil", &Parser::ParseStencil},
    };
    table.insert(table.end(), state.begin(), state.end());
}

void Parser::ParseCull()
{
    ParseEnum<CullMode>("Cull", k_CullModes, m_State->cull);
}

void Parser::ParseZTest()
{
    ParseEnum<CompareFunction>("ZTest", k_DepthTests, m_State->zTest);
}

bool Parser::ParseBool(std::string_view subject, StateValue<bool>& target)
{
    return ParseEnum<bool>(subject, k_Bools, target);
}

void Parser::ParseZWrite()
{
    ParseBool("ZWrite", m_State->zWrite);
}

void Parser::ParseZClip()
{
    ParseBool("ZClip", m_State->zClip);
}

void Parser::ParseAlphaToMask()
{
    ParseBool("AlphaToMask", m_State->alphaToMask);
}

void Parser::ParseConservative()
{
    ParseBool("Conservative", m_State->conservative);
}

void Parser::ParseOffset()
{
    const auto parse = [this](StateValue<float>& target)
    {
        if (isPunctuation("["))
        {
            const auto property = ParseReference("Offset");
            target = property ? StateValue<float>::FromProperty(*property) : target;
            return property.has_value();
        }
        const auto number = ParseNumber("Offset");
        target = number ? StateValue<float>(static_cast<float>(*number)) : target;
        return number.has_value();
    };
    if (parse(m_State->offsetFactor) && Expect("Offset", ","))
    {
        parse(m_State->offsetUnits);
    }
}

std::optional<std::size_t> Parser::ParseTargetIndex(std::string_view subject)
{
    if (m_Token.kind != TokenKind::Number)
    {
        return std::nullopt;
    }
    const double number = m_Token.number;
    const double count = static_cast<double>(m_State->targets.size());
    if (number < 0.0 || number >= count || number != std::floor(number))
    {
        Error(std::string(subject) + ": target " + std::string(m_Token.text) +
              " does not exist; a target is 0...7");
        Advance();
        return std::nullopt;
    }
    Advance();
    return static_cast<std::size_t>(number);
}

std::span<PassBlendState> Parser::TargetsOf(std::optional<std::size_t> index)
{
    if (!index)
    {
        return m_State->targets;
    }
    m_State->separateBlend = true;
    return std::span(m_State->targets).subspan(*index, 1);
}

bool Parser::ParseBlendFactor(StateValue<BlendMode>& target)
{
    return ParseEnum<BlendMode>("Blend", k_BlendModes, target);
}

void Parser::ParseBlend()
{
    const auto index = ParseTargetIndex("Blend");
    PassBlendState blend;
    if (isWord("Off") || isWord("False"))
    {
        Advance();
    }
    else
    {
        blend.enabled = true;
        if (!ParseBlendFactor(blend.srcColor) || !ParseBlendFactor(blend.dstColor))
        {
            return;
        }
        blend.srcAlpha = blend.srcColor;
        blend.dstAlpha = blend.dstColor;
        if (Accept(",") && (!ParseBlendFactor(blend.srcAlpha) || !ParseBlendFactor(blend.dstAlpha)))
        {
            return;
        }
    }
    for (PassBlendState& target : TargetsOf(index))
    {
        target.enabled = blend.enabled;
        target.srcColor = blend.srcColor;
        target.dstColor = blend.dstColor;
        target.srcAlpha = blend.srcAlpha;
        target.dstAlpha = blend.dstAlpha;
    }
}

bool Parser::ParseBlendOperation(StateValue<BlendOp>& target)
{
    for (const std::string_view name : k_UnsupportedBlendOps)
    {
        if (isWord(name))
        {
            Error("BlendOp: '" + std::string(name) +
                  "' is not supported; use Add, Sub, RevSub, Min or Max");
            Advance();
            return false;
        }
    }
    return ParseEnum<BlendOp>("BlendOp", k_BlendOps, target);
}

void Parser::ParseBlendOp()
{
    const auto index = ParseTargetIndex("BlendOp");
    StateValue<BlendOp> color;
    if (!ParseBlendOperation(color))
    {
        return;
    }
    StateValue<BlendOp> alpha = color;
    if (Accept(",") && !ParseBlendOperation(alpha))
    {
        return;
    }
    for (PassBlendState& target : TargetsOf(index))
    {
        target.colorOp = color;
        target.alphaOp = alpha;
    }
}

void Parser::ParseColorMask()
{
    StateValue<int> mask = 0;
    if (isPunctuation("["))
    {
        const auto property = ParseReference("ColorMask");
        if (!property)
        {
            return;
        }
        mask = StateValue<int>::FromProperty(*property);
    }
    else
    {
        const bool none = isWord("Off") || isWord("False") ||
                          (m_Token.kind == TokenKind::Number && m_Token.text == "0");
        const auto letters = none ? 0 : ColorMaskOf(m_Token.text);
        if (!letters || (!none && m_Token.kind != TokenKind::Identifier))
        {
            Error("ColorMask: " + Found() + " is no mask; write letters of RGBA, 0 or [_Property]");
            if (!isPunctuation("}") && !isAnyCommand())
            {
                Advance();
            }
            return;
        }
        mask = *letters;
        Advance();
    }
    for (PassBlendState& target : TargetsOf(ParseTargetIndex("ColorMask")))
    {
        target.writeMask = mask;
    }
}

} // namespace limn
