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

} // namespace limn
