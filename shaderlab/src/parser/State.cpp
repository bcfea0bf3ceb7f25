#include "parser/Parser.h"

namespace limn
{

void Parser::ParseCull()
{
    ParseEnum<CullMode>("Cull", k_CullModes, m_Scope.state.cull);
}

void Parser::ParseZTest()
{
    ParseEnum<CompareFunction>("ZTest", k_DepthTests, m_Scope.state.zTest);
}

bool Parser::ParseBool(std::string_view subject, StateValue<bool>& target)
{
    return ParseEnum<bool>(subject, k_Bools, target);
}

void Parser::ParseZWrite()
{
    ParseBool("ZWrite", m_Scope.state.zWrite);
}

void Parser::ParseZClip()
{
    ParseBool("ZClip", m_Scope.state.zClip);
}

void Parser::ParseAlphaToMask()
{
    ParseBool("AlphaToMask", m_Scope.state.alphaToMask);
}

void Parser::ParseConservative()
{
    ParseBool("Conservative", m_Scope.state.conservative);
}

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

} // namespace limn
