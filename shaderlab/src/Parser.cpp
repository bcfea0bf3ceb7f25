#include "Parser.h"

#include "Text.h"

#include <algorithm>

namespace limn
{

Parser::Parser(std::string_view text, std::string file) : m_Lexer(text)
{
    m_Result.document.file = std::move(file);
    Advance();
}

ShaderLabParseResult Parser::Parse()
{
    ParseFile();
    const auto isBefore = [](const Diagnostic& a, const Diagnostic& b)
    {
        return a.location.line != b.location.line ? a.location.line < b.location.line
                                                  : a.location.column < b.location.column;
    };
    std::stable_sort(m_Result.diagnostics.begin(), m_Result.diagnostics.end(), isBefore);
    return std::move(m_Result);
}

Token Parser::Advance()
{
    const Token previous = m_Token;
    m_Token = m_Lexer.Next();
    if (m_Token.unterminated)
    {
        Error("string: '\"' is never closed; close it where the text ends");
    }
    return previous;
}

bool Parser::isWord(std::string_view word) const
{
    return m_Token.kind == TokenKind::Identifier && EqualsIgnoringCase(m_Token.text, word);
}

bool Parser::isPunctuation(std::string_view mark) const
{
    return m_Token.kind == TokenKind::Punctuation && m_Token.text == mark;
}

bool Parser::Accept(std::string_view mark)
{
    const bool accepted = isPunctuation(mark);
    if (accepted)
    {
        Advance();
    }
    return accepted;
}

bool Parser::Expect(std::string_view subject, std::string_view mark)
{
    if (Accept(mark))
    {
        return true;
    }
    Error(std::string(subject) + ": '" + std::string(mark) + "' is missing before " + Found());
    return false;
}

std::string Parser::Found() const
{
    switch (m_Token.kind)
    {
    case TokenKind::End:
        return "the end of the file";
    case TokenKind::String:
        return "\"" + std::string(m_Token.text.substr(0, 40)) + "\"";
    default:
        return "'" + std::string(m_Token.text) + "'";
    }
}

void Parser::Report(Severity severity, SourceLocation location, std::string message)
{
    m_Result.diagnostics.push_back(
        {severity, m_Result.document.file, location, std::move(message)});
}

void Parser::Error(std::string message)
{
    // A file that breaks off is one mistake, however many scopes were open.
    if (m_Token.kind == TokenKind::End && m_ReportedEnd)
    {
        return;
    }
    m_ReportedEnd = m_Token.kind == TokenKind::End;
    Report(Severity::Error, m_Token.location, std::move(message));
}

const Parser::Command* Parser::FindCommand(const CommandTable& table) const
{
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Command& command) { return isWord(command.name); });
    return found == table.end() ? nullptr : &*found;
}

bool Parser::isAnyCommand() const
{
    return std::any_of(m_Tables.begin(), m_Tables.end(),
                       [&](const CommandTable* table) { return FindCommand(*table) != nullptr; });
}

bool Parser::isOuterCommand() const
{
    return std::any_of(m_Tables.begin(), m_Tables.end() - 1,
                       [&](const CommandTable* table) { return FindCommand(*table) != nullptr; });
}

void Parser::SkipUnknown()
{
    while (m_Token.kind != TokenKind::End && !isPunctuation("}") && !isAnyCommand())
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

void Parser::SkipBraces()
{
    int depth = 0;
    do
    {
        depth += isPunctuation("{") ? 1 : 0;
        depth -= isPunctuation("}") ? 1 : 0;
        Advance();
    } while (depth > 0 && m_Token.kind != TokenKind::End);
}

void Parser::ParseBlock(std::string_view scope, const CommandTable& table)
{
    const SourceLocation opening = m_Token.location;
    if (!Expect(scope, "{"))
    {
        SkipUnknown();
        return;
    }
    m_Tables.push_back(&table);
    bool open = true;
    while (open && !Accept("}"))
    {
        if (m_Token.kind == TokenKind::End)
        {
            Error(std::string(scope) + ": '{' of line " + std::to_string(opening.line) +
                  " is never closed; add '}'");
            open = false;
        }
        else if (const Command* command = FindCommand(table))
        {
            m_Command = m_Token.location;
            m_WordEnd = m_Lexer.mark();
            m_Word = Advance().text;
            (this->*command->parse)();
        }
        else if (isOuterCommand())
        {
            Error(std::string(scope) + ": '}' is missing before " + Found() + "; the '{' of line " +
                  std::to_string(opening.line) + " is still open");
            open = false;
        }
        else
        {
            ParseUnknown(scope, table);
        }
    }
    m_Tables.pop_back();
}

void Parser::ParseUnknown(std::string_view scope, const CommandTable& table)
{
    if (m_Token.kind != TokenKind::Identifier)
    {
        Error(std::string(scope) + ": unexpected " + Found() + "; a command is expected");
    }
    else
    {
        std::vector<std::string_view> known;
        for (const Command& command : table)
        {
            known.push_back(command.name);
        }
        Error(std::string(scope) + ": unknown command " + UnknownName(m_Token.text, known));
    }
    if (isPunctuation("{"))
    {
        SkipBraces();
    }
    else
    {
        Advance();
    }
    SkipUnknown();
}

std::optional<std::string> Parser::ParseString(std::string_view subject)
{
    if (m_Token.kind == TokenKind::String)
    {
        return std::string(Advance().text);
    }
    Error(std::string(subject) + ": a text in quotes is missing before " + Found());
    return std::nullopt;
}

std::optional<double> Parser::ParseNumber(std::string_view subject)
{
    if (m_Token.kind == TokenKind::Number)
    {
        return Advance().number;
    }
    Error(std::string(subject) + ": a number is missing before " + Found());
    return std::nullopt;
}

std::optional<std::string> Parser::ParseReference(std::string_view subject)
{
    const SourceLocation start = m_Token.location;
    bool closed = false;
    const std::string_view text = Trim(m_Lexer.ReadBracket(closed));
    std::size_t size = 0;
    while (size < text.size() && (isLetter(text[size]) || isDigit(text[size]) || text[size] == '#'))
    {
        ++size;
    }
    Advance();
    if (!closed || size == 0)
    {
        Report(Severity::Error, start,
               std::string(subject) + ": '[' needs the name of a property and ']', as in [_Name]");
        return std::nullopt;
    }
    if (size < text.size())
    {
        Report(Severity::Warning, start,
               std::string(subject) + ": what follows the name in '[" + std::string(text) +
                   "]' is ignored");
    }
    return std::string(text.substr(0, size));
}

bool ShaderLabParseResult::hasErrors() const
{
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& diagnostic)
                       { return diagnostic.severity == Severity::Error; });
}

ShaderLabParseResult ParseShaderLab(std::string_view text, std::string file)
{
    return Parser(text, std::move(file)).Parse();
}

} // namespace limn
