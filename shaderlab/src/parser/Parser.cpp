#include "parser/Parser.h"

#include <limn/base/ReadFile.h>
#include <limn/base/TerminalText.h>
#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::size_t k_MaxFileSize = 64 << 20;
constexpr std::size_t k_MaxReference = 128; ///< bytes of a property's name in a command

constexpr std::size_t k_MaxShown = 100;     ///< diagnostics of a severity
constexpr std::size_t k_MaxErrors = 10000;  ///< no more of the file is read then
constexpr std::size_t k_MaxItems = 1 << 20; ///< that a document is made of
constexpr std::size_t k_MaxRepeatedBytes = 256 << 20;
constexpr std::size_t k_MaxFound = 40; ///< bytes of the file that a message quotes

/// Unity takes single zero bytes for blanks; a file that has many of them is none of text.
bool isBinary(const std::string& text)
{
    return std::ranges::count(text, '\0') > std::ssize(text) / 16;
}

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
    else if (const std::string_view place = PlaceOfCommand(); !place.empty())
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
    const std::size_t size = Beginning(text, isWordCharacter).size();
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

ShaderLabDocument ShaderLabParseResult::TakeDocument()
{
    if (hasErrors())
    {
        throw AssetError(std::move(diagnostics));
    }
    return std::move(document);
}

ShaderLabParseResult ParseShaderLab(std::string_view text, std::string file)
{
    return Parser(text, std::move(file)).Parse();
}

ShaderLabParseResult LoadShaderLabWithDiagnostics(const std::filesystem::path& path)
{
    const std::string file = path.string();
    const std::string text = ReadFile(path);
    if (text.empty())
    {
        throw AssetError(file, {}, "file: it is empty; a shader starts with Shader \"name\"");
    }
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    {
        throw AssetError(file, {}, "file: it is in UTF-16; save it in UTF-8");
    }
    if (isBinary(text))
    {
        throw AssetError(file, {}, "file: it is binary; a shader is a text file in UTF-8");
    }
    return ParseShaderLab(text, file);
}

ShaderLabDocument LoadShaderLab(const std::filesystem::path& path)
{
    return LoadShaderLabWithDiagnostics(path).TakeDocument();
}

std::string Parser::Found() const
{
    const std::string quote = m_Token.kind == TokenKind::String ? "\"" : "'";
    return m_Token.kind == TokenKind::End
               ? "the end of the file"
               : quote + OneLine(Shortened(m_Token.text, k_MaxFound)) + quote;
}

void Parser::Report(Severity severity, SourceLocation location, std::string message)
{
    std::size_t& count = m_Reported[static_cast<std::size_t>(severity)];
    if (++count <= k_MaxShown)
    {
        m_Result.diagnostics.push_back(
            {severity, m_Result.document.file, location, std::move(message)});
    }
    if (severity == Severity::Error && count == k_MaxErrors)
    {
        Stop();
    }
}

void Parser::Error(std::string message)
{
    // A file that breaks off is one mistake, however many scopes were open.
    if (m_Token.kind == TokenKind::End && m_ReportedEnd)
    {
        return;
    }
    // Only the first error at a place is reported, because it knows most about the author's
    // intention.
    const std::vector<Diagnostic>& said = m_Result.diagnostics;
    if (!said.empty() && said.back().severity == Severity::Error &&
        said.back().location == m_Token.location)
    {
        return;
    }
    m_ReportedEnd = m_Token.kind == TokenKind::End;
    m_FailedLine = m_Token.location.line;
    Report(Severity::Error, m_Token.location, std::move(message));
}

void Parser::ReportNotClosed(std::string_view scope, SourceLocation opening)
{
    Error(std::string(scope) + ": '{' of line " + std::to_string(opening.line) +
          " is never closed; add '}'");
}

void Parser::ReportStillOpen(std::string_view scope, SourceLocation opening)
{
    Error(std::string(scope) + ": '}' is missing before " + Found() + "; the '{' of line " +
          std::to_string(opening.line) + " is still open");
}

/// Reads no more of the file; the scopes that are open end without a word.
void Parser::Stop()
{
    m_IsStopped = true;
    m_ReportedEnd = true;
    m_Lexer.SkipToEnd();
    m_Token.kind = TokenKind::End;
    m_Token.text = {};
}

/// Returns whether the document may have this many more parts. If not, the rest of the file is not
/// read.
bool Parser::Count(std::size_t items)
{
    m_Items += items;
    if (m_Items > k_MaxItems && !m_IsStopped)
    {
        Report(Severity::Error, m_Token.location,
               "file: it declares more than limn can hold (" + std::to_string(k_MaxItems) +
                   " properties, attributes, tags and commands; a pass counts as 16)");
        Stop();
    }
    return m_Items <= k_MaxItems;
}

/// Returns whether inner scopes may get this number of bytes from the scopes around them. These
/// copies are the only way in which a document can become much larger than its file.
bool Parser::CountRepeated(std::size_t bytes)
{
    m_RepeatedBytes += bytes;
    if (m_RepeatedBytes > k_MaxRepeatedBytes && !m_IsStopped)
    {
        Report(Severity::Error, m_Command,
               "file: its include blocks, tags and commands, copied into every pass that they hold "
               "for, have more than " +
                   std::to_string(k_MaxRepeatedBytes) + " bytes; move common code to a file");
        Stop();
    }
    return m_RepeatedBytes <= k_MaxRepeatedBytes;
}

void Parser::FinishDiagnostics()
{
    std::vector<Diagnostic>& diagnostics = m_Result.diagnostics;
    std::ranges::stable_sort(
        diagnostics, {},
        [](const Diagnostic& diagnostic)
        { return std::pair(diagnostic.location.line, diagnostic.location.column); });
    for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Note})
    {
        const std::size_t count = m_Reported[static_cast<std::size_t>(severity)];
        if (count > k_MaxShown)
        {
            const bool isOpen = severity == Severity::Error && count >= k_MaxErrors;
            diagnostics.push_back({severity,
                                   m_Result.document.file,
                                   {},
                                   "file: " + std::string(isOpen ? "at least " : "") +
                                       std::to_string(count - k_MaxShown) + " more " +
                                       SeverityName(severity) + "s are not shown"});
        }
    }
}

const Parser::CommandTable& Parser::ShaderCommands()
{
    static const CommandTable table = {
        {"Properties", &Parser::ParseProperties},
        {"SubShader", &Parser::ParseSubShader},
        {"Category", &Parser::ParseCategory},
        {"Fallback", &Parser::ParseFallback},
        {"CustomEditor", &Parser::ParseCustomEditor},
        {"CustomEditorForRenderPipeline", &Parser::ParsePipelineEditor},
        {"Dependency", &Parser::ParseDependency},
        {"HLSLINCLUDE", &Parser::ParseIncludeBlock, true},
        {"CGINCLUDE", &Parser::ParseIncludeBlock, true},
        {"GLSLINCLUDE", &Parser::ParseIncludeBlock, true},
    };
    return table;
}

const Parser::CommandTable& Parser::CategoryCommands()
{
    static const CommandTable table = WithCommonCommands({
        {"SubShader", &Parser::ParseSubShader},
        {"Category", &Parser::ParseCategory},
        {"Tags", &Parser::ParseTags},
        {"LOD", &Parser::ParseLod},
        {"Fallback", &Parser::ParseFallback},
        {"CustomEditor", &Parser::ParseCustomEditor},
        {"CustomEditorForRenderPipeline", &Parser::ParsePipelineEditor},
        {"Dependency", &Parser::ParseDependency},
    });
    return table;
}

const Parser::CommandTable& Parser::SubShaderCommands()
{
    static const CommandTable table = WithCommonCommands({
        {"Pass", &Parser::ParsePass},
        {"Tags", &Parser::ParseTags},
        {"LOD", &Parser::ParseLod},
        {"Name", &Parser::ParseName},
        {"UsePass", &Parser::ParseUsePass},
        {"GrabPass", &Parser::ParseGrabPass},
        {"PackageRequirements", &Parser::ParsePackageRequirements},
        {"HLSLPROGRAM", &Parser::ParseSurface, true},
        {"CGPROGRAM", &Parser::ParseSurface, true},
        {"GLSLPROGRAM", &Parser::ParseSurface, true},
    });
    return table;
}

const Parser::CommandTable& Parser::PassCommands()
{
    static const CommandTable table = WithCommonCommands({
        {"Name", &Parser::ParseName},
        {"Tags", &Parser::ParseTags},
        {"LOD", &Parser::ParseLod},
        {"PackageRequirements", &Parser::ParsePackageRequirements},
        {"HLSLPROGRAM", &Parser::ParseProgram, true},
        {"CGPROGRAM", &Parser::ParseProgram, true},
        {"GLSLPROGRAM", &Parser::ParseProgram, true},
        {"SetTexture", &Parser::ParseSetTexture},
    });
    return table;
}

/// Returns the place of the command that the token is, "" if there is no such command.
std::string_view Parser::PlaceOfCommand() const
{
    return FindCommand(PassCommands())        ? "a Pass"
           : FindCommand(SubShaderCommands()) ? "a SubShader"
           : FindCommand(StencilCommands())   ? "a Stencil block"
                                              : "";
}

} // namespace limn
