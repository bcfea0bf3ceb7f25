#include "parser/Parser.h"

#include <limn/base/Text.h>

#include <cmath>

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

} // namespace

bool Parser::ParseFloat(std::string_view subject, StateValue<float>& target)
{
    if (isPunctuation('['))
    {
        const auto property = ParseReference(subject);
        target = property ? StateValue<float>::FromProperty(*property) : target;
        return property.has_value();
    }
    const auto number = ParseNumber(subject);
    target = number ? StateValue<float>(*number) : target;
    return number.has_value();
}

void Parser::ParseOffset()
{
    RenderState& state = m_Scope.state;
    if (ParseFloat("Offset", state.offsetFactor) && Expect("Offset", ','))
    {
        ParseFloat("Offset", state.offsetUnits);
    }
}

std::optional<std::size_t> Parser::ParseTargetIndex(std::string_view subject)
{
    if (m_Token.kind != TokenKind::Number)
    {
        return std::nullopt;
    }
    const float number = m_Token.number;
    const float count = static_cast<float>(m_Scope.state.targets.size());
    if (number < 0.0f || number >= count || number != std::floor(number))
    {
        Error(std::string(subject) + ": target " + std::string(m_Token.text.substr(0, 40)) +
              " does not exist; a target is 0...7");
        Advance();
        return std::nullopt;
    }
    Advance();
    return static_cast<std::size_t>(number);
}

std::span<PassBlendState> Parser::TargetsOf(std::optional<std::size_t> index)
{
    const std::span<PassBlendState> all = m_Scope.state.targets;
    return index ? all.subspan(*index, 1) : all;
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
        if (!ParseBlendFactor(blend.sourceColorBlendMode) ||
            !ParseBlendFactor(blend.destinationColorBlendMode))
        {
            return;
        }
        blend.sourceAlphaBlendMode = blend.sourceColorBlendMode;
        blend.destinationAlphaBlendMode = blend.destinationColorBlendMode;
        if (Accept(',') && (!ParseBlendFactor(blend.sourceAlphaBlendMode) ||
                            !ParseBlendFactor(blend.destinationAlphaBlendMode)))
        {
            return;
        }
    }
    for (PassBlendState& target : TargetsOf(index))
    {
        target.enabled = blend.enabled;
        target.sourceColorBlendMode = blend.sourceColorBlendMode;
        target.destinationColorBlendMode = blend.destinationColorBlendMode;
        target.sourceAlphaBlendMode = blend.sourceAlphaBlendMode;
        target.destinationAlphaBlendMode = blend.destinationAlphaBlendMode;
    }
}

bool Parser::ParseBlendOperation(StateValue<BlendOp>& target)
{
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
    if (Accept(',') && !ParseBlendOperation(alpha))
    {
        return;
    }
    for (PassBlendState& target : TargetsOf(index))
    {
        target.colorBlendOperation = color;
        target.alphaBlendOperation = alpha;
    }
}

std::optional<StateValue<int>> Parser::ParseMask()
{
    if (isPunctuation('['))
    {
        const auto property = ParseReference("ColorMask");
        return property ? std::optional(StateValue<int>::FromProperty(*property)) : std::nullopt;
    }
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
        return std::nullopt;
    }
    Advance();
    return StateValue<int>(*letters);
}

void Parser::ParseColorMask()
{
    const auto mask = ParseMask();
    if (!mask)
    {
        return;
    }
    for (PassBlendState& target : TargetsOf(ParseTargetIndex("ColorMask")))
    {
        target.writeMask = *mask;
    }
}

} // namespace limn
