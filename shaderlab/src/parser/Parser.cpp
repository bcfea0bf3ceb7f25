#include "parser/Parser.h"

#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::size_t k_MaxFileSize = 64 << 20;
constexpr std::size_t k_MaxReference = 128; ///< bytes of a property's name in a command

} // namespace

Parser::Parser(std::string_view text, std::string file) : m_Lexer(text)
{
    m_Result.document.file = std::move(file);
    if (text.size() > k_MaxFileSize)
    {
        Report(Severity::Error, {},
               "file: it has " + std::to_string(text.size()) + " bytes; a shader may have " +
                   std::to_string(k_MaxFileSize));
        Stop();
        return;
    }
    Advance();
}

ShaderLabParseResult Parser::Parse()
{
    if (!m_IsStopped)
    {
        ParseFile();
    }
    ReadPragmas();
    FinishDiagnostics();
    return std::move(m_Result);
}

Token Parser::Advance()
{
    const Token previous = m_Token;
    m_Token = m_Lexer.Next();
    while (m_Token.kind == TokenKind::Identifier && m_Token.text.front() == '#' &&
           (isWord("#warning") || isWord("#error") || isWord("#line")))
    {
        TakeDirective();
    }
    if (m_Token.kind == TokenKind::End && m_Lexer.openComment().line > 0 && !m_IsStopped)
    {
        Report(Severity::Error, m_Lexer.openComment(),
               "comment: '/*' is never closed; close it with '*/'");
        m_Lexer.ForgetOpenComment();
    }
    if (m_Token.unterminated)
    {
        Error("string: '\"' is never closed; close it where the text ends");
    }
    return previous;
}

/// Unity's lexer knows three preprocessor lines outside programs, none of which says anything about
/// the shader.
void Parser::TakeDirective()
{
    const SourceLocation location = m_Token.location;
    const std::string name(m_Token.text);
    const bool isError = isWord("#error");
    const bool isLine = isWord("#line");
    const std::string_view text = Trim(m_Lexer.ReadLine());
    if (isLine)
    {
        Report(Severity::Note, location,
               "#line: it is ignored; messages give the lines of this file");
    }
    else
    {
        Report(isError ? Severity::Error : Severity::Warning, location,
               name + ": " + std::string(text.substr(0, 200)));
    }
    if (!m_IsStopped)
    {
        m_Token = m_Lexer.Next();
    }
}

bool Parser::isWord(std::string_view word) const
{
    return m_Token.kind == TokenKind::Identifier && EqualsIgnoringCase(m_Token.text, word);
}

bool Parser::isPunctuation(char mark) const
{
    return m_Token.kind == TokenKind::Punctuation && m_Token.text.size() == 1 &&
           m_Token.text[0] == mark;
}

bool Parser::Accept(char mark)
{
    const bool accepted = isPunctuation(mark);
    if (accepted)
    {
        Advance();
    }
    return accepted;
}

bool Parser::Expect(std::string_view subject, char mark)
{
    if (Accept(mark))
    {
        return true;
    }
    Error(std::string(subject) + ": '" + mark + "' is missing before " + Found());
    return false;
}

const Parser::Command* Parser::FindCommand(const CommandTable& table) const
{
    const auto found = std::ranges::find_if(
        table, [&](std::string_view name) { return isWord(name); }, &Command::name);
    return found == table.end() ? nullptr : &*found;
}

bool Parser::isAnyCommand() const
{
    return std::ranges::any_of(m_Tables,
                               [&](const CommandTable* table) { return FindCommand(*table); });
}

bool Parser::isOuterCommand() const
{
    return std::any_of(m_Tables.begin(), m_Tables.end() - 1,
                       [&](const CommandTable* table) { return FindCommand(*table); });
}

void Parser::SkipUnknown()
{
    while (m_Token.kind != TokenKind::End && !isPunctuation('}') && !isAnyCommand())
    {
        SkipTokenOrBraces();
    }
}

/// Passes over what a broken command has left on its line, so that it is reported once.
void Parser::SkipRestOfCommand()
{
    while (m_Token.kind != TokenKind::End && m_Token.location.line == m_FailedLine &&
           !isPunctuation('}') && !isAnyCommand())
    {
        SkipTokenOrBraces();
    }
    m_FailedLine = 0;
}

/// Skips one token, or from a { to behind its }. The token must not be a }.
void Parser::SkipTokenOrBraces()
{
    std::size_t depth = 0;
    do
    {
        depth += isPunctuation('{') ? 1 : 0;
        depth -= isPunctuation('}') ? 1 : 0;
        Advance();
    } while (depth > 0 && m_Token.kind != TokenKind::End);
}

void Parser::ParseBlock(std::string_view scope, const CommandTable& table)
{
    const SourceLocation opening = m_Token.location;
    if (!Expect(scope, '{'))
    {
        SkipUnknown();
        return;
    }
    m_Tables.push_back(&table);
    bool open = true;
    while (open && !Accept('}'))
    {
        if (m_Token.kind == TokenKind::End)
        {
            ReportNotClosed(scope, opening);
            open = false;
        }
        else if (const Command* command = FindCommand(table))
        {
            m_FailedLine = 0;
            ParseCommand(*command);
            SkipRestOfCommand();
        }
        else if (isOuterCommand())
        {
            ReportStillOpen(scope, opening);
            open = false;
        }
        else
        {
            ParseUnknown(scope, table);
        }
    }
    m_Tables.pop_back();
}

void Parser::ParseCommand(const Command& command)
{
    m_Command = m_Token.location;
    m_Word = command.name;
    if (!command.isRaw)
    {
        Advance();
    }
    (this->*command.parse)();
}

void Parser::ParseUnknown(std::string_view scope, const CommandTable& table)
{
    if (m_Token.kind != TokenKind::Identifier)
    {
        Error(std::string(scope) + ": unexpected " + Found() + "; a command is expected");
    }
    else if (const std::string_view place = PlaceOf(m_Token.text); !place.empty())
    {
        Error(std::string(scope) + ": " + Found() + " does not belong here; it is a command of " +
              std::string(place));
    }
    else
    {
        Error(std::string(scope) + ": unknown command " +
              UnknownName(m_Token.text, NamesIn(table)));
    }
    SkipTokenOrBraces();
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

std::optional<float> Parser::ParseNumber(std::string_view subject)
{
    if (m_Token.kind != TokenKind::Number)
    {
        Error(std::string(subject) + ": a number is missing before " + Found());
        return std::nullopt;
    }
    if (m_Token.unusual)
    {
        Report(Severity::Warning, m_Token.location,
               std::string(subject) + ": " + Found() +
                   " is no plain number; write digits, '.' and '-' only, within the limits of a "
                   "float");
    }
    return Advance().number;
}

std::optional<std::string> Parser::ParseReference(std::string_view subject)
{
    const SourceLocation start = m_Token.location;
    bool closed = false;
    const std::string_view text = Trim(m_Lexer.ReadBracket(closed));
    const auto end = std::ranges::find_if_not(text, isWordCharacter);
    const auto size = static_cast<std::size_t>(end - text.begin());
    Advance();
    if (!closed || size == 0 || size > k_MaxReference)
    {
        Report(Severity::Error, start,
               std::string(subject) + ": '[' needs the name of a property and ']', as in [_Name]");
        return std::nullopt;
    }
    if (size < text.size())
    {
        Report(Severity::Warning, start,
               std::string(subject) + ": what follows the name in '[" +
                   std::string(text.substr(0, 80)) + "]' is ignored");
    }
    return std::string(text.substr(0, size));
}

bool ShaderLabParseResult::hasErrors() const
{
    return std::ranges::count(diagnostics, Severity::Error, &Diagnostic::severity) > 0;
}

ShaderLabParseResult ParseShaderLab(std::string_view text, std::string file)
{
    return Parser(text, std::move(file)).Parse();
}

} // namespace limn
