#include "parser/Parser.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::size_t k_MaxShown = 100;     ///< diagnostics of a severity
constexpr std::size_t k_MaxErrors = 10000;  ///< no more of the file is read then
constexpr std::size_t k_MaxItems = 1 << 20; ///< that a document is made of
constexpr std::size_t k_MaxRepeatedBytes = 256 << 20;
constexpr std::size_t k_MaxFound = 40; ///< bytes of the file that a message quotes

/// Text of the file that a message can show: short, and without what a terminal cannot.
std::string Shown(std::string_view text)
{
    static constexpr char k_Digits[] = "0123456789ABCDEF";
    std::string shown;
    for (const char c : text.substr(0, k_MaxFound))
    {
        const auto byte = static_cast<unsigned char>(c);
        shown += byte >= 0x20 && byte < 0x7F
                     ? std::string{c}
                     : std::string{'\\', 'x', k_Digits[byte / 16], k_Digits[byte % 16]};
    }
    return shown + (text.size() > k_MaxFound ? "..." : "");
}

} // namespace

std::string Parser::Found() const
{
    const std::string quote = m_Token.kind == TokenKind::String ? "\"" : "'";
    return m_Token.kind == TokenKind::End ? "the end of the file"
                                          : quote + Shown(m_Token.text) + quote;
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
    for (const auto& [severity, noun] :
         {std::pair(Severity::Error, "errors"), std::pair(Severity::Warning, "warnings"),
          std::pair(Severity::Note, "notes")})
    {
        const std::size_t count = m_Reported[static_cast<std::size_t>(severity)];
        if (count > k_MaxShown)
        {
            const bool isOpen = severity == Severity::Error && count >= k_MaxErrors;
            diagnostics.push_back({severity,
                                   m_Result.document.file,
                                   {},
                                   "file: " + std::string(isOpen ? "at least " : "") +
                                       std::to_string(count - k_MaxShown) + " more " + noun +
                                       " are not shown"});
        }
    }
}

} // namespace limn
