#include "parser/Parser.h"

namespace limn
{

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
