#include "console/Console.h"

#include "console/FitLines.h"

#include <algorithm>
#include <array>
#include <limn/base/ReadFile.h>
#include <limn/base/TerminalText.h>
#include <map>

namespace limn
{

namespace
{

constexpr std::string_view k_ClearLine = "\r\033[K";

/// Returns the rows that a text takes on a terminal, which breaks lines that are too long.
std::size_t RowsOf(std::string_view text, std::size_t width)
{
    std::size_t rows = 0;
    while (!text.empty())
    {
        const std::string_view line = text.substr(0, text.find('\n'));
        rows += std::max<std::size_t>((ColumnsOf(line) + width - 1) / width, 1);
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return rows;
}

const char* ColorCode(Severity severity)
{
    constexpr std::array k_Codes{"\033[31m", "\033[33m", "\033[36m"};
    return k_Codes.at(static_cast<std::size_t>(severity));
}

} // namespace

Console::Console(std::ostream& out, std::ostream& err) : m_Out(out), m_Err(err)
{
    Configure({});
}

void Console::Configure(const ConsoleOptions& options)
{
    m_Options = options;
    m_UsesColor = usesColor(options.color, m_Err);
    m_ShowsProgress = isTerminal(m_Err) && !isDumbTerminal() && !options.isQuiet;
}

void Console::CollectResults()
{
    m_IsCollecting = isOutTerminal();
}

void Console::ShowCollected()
{
    if (!m_IsCollecting)
    {
        return;
    }
    m_IsCollecting = false;
    const std::string text = m_Collected.str();
    const std::size_t height = TerminalHeight(m_Out);
    const std::string pager =
        RowsOf(text, outWidth()) < height || isDumbTerminal() ? "" : PagerCommand();
    ClearProgress();
    if (pager.empty() || !ShowInPager(pager, text))
    {
        m_Out << text;
    }
}

std::string Console::Colored(Severity severity, std::string_view text) const
{
    const std::string plain(text);
    return m_UsesColor ? ColorCode(severity) + plain + "\033[0m" : plain;
}

bool Console::isShown(Severity severity) const
{
    return severity == Severity::Error || !m_Options.isQuiet;
}

void Console::Result(std::string_view line)
{
    out() << OneLine(line) << '\n';
}

void Console::Results(std::string_view lines)
{
    const std::string text = SeveralLines(lines);
    out() << (isOutTerminal() ? FitLines(text, outWidth()) : text);
}

void Console::Data(std::string_view lines)
{
    out() << SeveralLines(lines);
}

void Console::Print(const Diagnostic& diagnostic, const std::string& source)
{
    if (!isShown(diagnostic.severity))
    {
        return;
    }
    std::string text = ToString(diagnostic);
    const std::string word(SeverityName(diagnostic.severity));
    const std::size_t at = text.find(": " + word + ": ");
    if (at != std::string::npos)
    {
        text.replace(at + 2, word.size(), Colored(diagnostic.severity, word));
    }
    Write(Fitted(text) + source); // a caret stands below its character only in a whole line
}

void Console::Print(const std::vector<Diagnostic>& diagnostics)
{
    for (const Diagnostic& diagnostic : diagnostics)
    {
        Print(diagnostic);
    }
}

void Console::PrintWithSource(const std::vector<Diagnostic>& diagnostics)
{
    std::map<std::string, std::string> texts;
    for (const Diagnostic& diagnostic : diagnostics)
    {
        const auto [entry, isNew] = texts.try_emplace(diagnostic.file);
        if (isNew)
        {
            entry->second = TryReadFile(diagnostic.file).bytes;
        }
        Print(diagnostic,
              ToStringWithSource(diagnostic, entry->second).substr(ToString(diagnostic).size()));
    }
}

void Console::Note(std::string_view sentence)
{
    Say(Severity::Note, Sentence(sentence));
}

void Console::Warning(std::string_view sentence)
{
    Say(Severity::Warning, Sentence(sentence));
}

void Console::Error(std::string_view text)
{
    Say(Severity::Error, SeveralLines(text));
}

void Console::Bug(std::string_view what)
{
    Error("this is a bug in limn: " + std::string(what) +
          "; please report it with the command line and the files");
}

void Console::Verbose(std::string_view sentence)
{
    if (m_Options.isVerbose)
    {
        Line(sentence);
    }
}

void Console::Line(std::string_view text)
{
    Write(Fitted(SeveralLines(text)));
}

void Console::Say(Severity severity, std::string_view text)
{
    if (isShown(severity))
    {
        Write(Fitted(Colored(severity, SeverityName(severity)) + ": " + std::string(text)));
    }
}

void Console::Write(std::string_view text)
{
    ClearProgress();
    m_Err << text << '\n';
}

std::string Console::Fitted(std::string_view text) const
{
    return isOnTerminal() ? FitLines(text, TerminalWidth(m_Err)) : std::string(text);
}

void Console::Progress(std::string_view text)
{
    if (m_ShowsProgress)
    {
        // In a second line it could not be replaced.
        m_Err << k_ClearLine << CutLine(OneLine(text), TerminalWidth(m_Err) - 1) << std::flush;
        m_HasProgress = !text.empty();
    }
}

void Console::ClearProgress()
{
    if (m_HasProgress)
    {
        m_Err << k_ClearLine;
        m_HasProgress = false;
    }
}

} // namespace limn
