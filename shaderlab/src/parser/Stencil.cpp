#include "parser/Parser.h"

#include <algorithm>

namespace limn
{

const Parser::CommandTable& Parser::StencilCommands()
{
    using Face = StencilFaceState;
    static const CommandTable table = {
        {"Ref", &Parser::ParseStencilByte<&PassStencilState::reference>},
        {"ReadMask", &Parser::ParseStencilByte<&PassStencilState::readMask>},
        {"WriteMask", &Parser::ParseStencilByte<&PassStencilState::writeMask>},
        {"Comp", &Parser::ParseStencilCompare<&Face::compare, true, true>},
        {"CompFront", &Parser::ParseStencilCompare<&Face::compare, true, false>},
        {"CompBack", &Parser::ParseStencilCompare<&Face::compare, false, true>},
        {"Pass", &Parser::ParseStencilOperation<&Face::pass, true, true>},
        {"PassFront", &Parser::ParseStencilOperation<&Face::pass, true, false>},
        {"PassBack", &Parser::ParseStencilOperation<&Face::pass, false, true>},
        {"Fail", &Parser::ParseStencilOperation<&Face::fail, true, true>},
        {"FailFront", &Parser::ParseStencilOperation<&Face::fail, true, false>},
        {"FailBack", &Parser::ParseStencilOperation<&Face::fail, false, true>},
        {"ZFail", &Parser::ParseStencilOperation<&Face::zFail, true, true>},
        {"ZFailFront", &Parser::ParseStencilOperation<&Face::zFail, true, false>},
        {"ZFailBack", &Parser::ParseStencilOperation<&Face::zFail, false, true>},
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
        const auto property = ParseReference(m_Word);
        target = property ? StateValue<int>::FromProperty(*property) : target;
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

template <StateValue<CompareFunction> StencilFaceState::*Field, bool Front, bool Back>
void Parser::ParseStencilCompare()
{
    StateValue<CompareFunction> value;
    if (ParseEnum<CompareFunction>(m_Word, k_CompareFunctions, value))
    {
        PassStencilState& stencil = m_Scope.state.stencil;
        stencil.front.*Field = Front ? value : stencil.front.*Field;
        stencil.back.*Field = Back ? value : stencil.back.*Field;
    }
}

template <StateValue<StencilOp> StencilFaceState::*Field, bool Front, bool Back>
void Parser::ParseStencilOperation()
{
    StateValue<StencilOp> value;
    if (ParseEnum<StencilOp>(m_Word, k_StencilOps, value))
    {
        PassStencilState& stencil = m_Scope.state.stencil;
        stencil.front.*Field = Front ? value : stencil.front.*Field;
        stencil.back.*Field = Back ? value : stencil.back.*Field;
    }
}

} // namespace limn
