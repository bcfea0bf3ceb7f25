#include "Parser.h"

namespace limn
{

void Parser::AppendLegacyCommands(CommandTable& table)
{
    const CommandTable legacy = {
        {"Lighting", &Parser::IgnoreWord},         {"SeparateSpecular", &Parser::IgnoreWord},
        {"ColorMaterial", &Parser::IgnoreWord},    {"Color", &Parser::IgnoreColor},
        {"Material", &Parser::IgnoreBlock},        {"Fog", &Parser::IgnoreBlock},
        {"AlphaTest", &Parser::IgnoreAlphaTest},   {"BindChannels", &Parser::IgnoreBlock},
        {"SetTexture", &Parser::IgnoreSetTexture},
    };
    table.insert(table.end(), legacy.begin(), legacy.end());
}

void Parser::IgnoreWord()
{
    if (isPunctuation("["))
    {
        ParseReference(m_Word);
    }
    else if (m_Token.kind == TokenKind::Identifier && !isAnyCommand())
    {
        Advance();
    }
    else
    {
        Error(std::string(m_Word) + ": value is missing before " + Found());
    }
}

void Parser::IgnoreBlock()
{
    if (!isPunctuation("{"))
    {
        Expect(m_Word, "{");
        return;
    }
    SkipBraces();
}

void Parser::IgnoreColor()
{
    if (isPunctuation("["))
    {
        ParseReference("Color");
        return;
    }
    if (!Expect("Color", "("))
    {
        return;
    }
    while (m_Token.kind == TokenKind::Number || isPunctuation(",") || isPunctuation("["))
    {
        if (isPunctuation("["))
        {
            ParseReference("Color");
        }
        else
        {
            Advance();
        }
    }
    Expect("Color", ")");
}

void Parser::IgnoreAlphaTest()
{
    IgnoreWord();
    if (isPunctuation("["))
    {
        ParseReference("AlphaTest");
    }
    else if (m_Token.kind == TokenKind::Number)
    {
        Advance();
    }
}

void Parser::IgnoreSetTexture()
{
    if (isPunctuation("["))
    {
        ParseReference("SetTexture");
    }
    if (isPunctuation("{"))
    {
        SkipBraces();
    }
}

} // namespace limn
