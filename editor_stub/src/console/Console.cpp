#include "console/Console.h"

#include <array>
#include <iterator>
#include <limn/base/ReadFile.h>
#include <limn/base/TerminalText.h>
#include <map>

namespace limn
{

namespace
{

constexpr std::string_view k_ClearLine = "\r\033[K";

const char* ColorCode(Severity severity)
{
    constexpr std::array k_Codes{"\033[31m", "\033[33m", "\033[36m"};
    return k_Codes.at(static_cast<std::size_t>(severity));
}

} // namespace

const char* SeverityName(Severity severity)
{
    constexpr std::array k_Names{"error", "warning", "note"};
    return k_Names.at(static_cast<std::size_t>(severity));
}

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
    m_Out << OneLine(line) << '\n';
}

void Console::Results(std::string_view lines)
{
    m_Out << SeveralLines(lines);
}

void Console::Print(const Diagnostic& diagnostic)
{
    Print(diagnostic, ToString(diagnostic));
}

void Console::Print(const Diagnostic& diagnostic, std::string text)
{
    if (!isShown(diagnostic.severity))
    {
        return;
    }
    const std::string word = std::string(": ") + SeverityName(diagnostic.severity) + ": ";
    const std::size_t at = text.find(word);
    if (at != std::string::npos)
    {
        text.replace(at + 2, word.size() - 4,
                     Colored(diagnostic.severity, SeverityName(diagnostic.severity)));
    }
    Write(text);
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
        Print(diagnostic, ToStringWithSource(diagnostic, entry->second));
    }
}

bool Console::isOnTerminal() const
{
    return isTerminal(m_Err);
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
    Write(SeveralLines(text));
}

void Console::Say(Severity severity, std::string_view text)
{
    if (isShown(severity))
    {
        Write(Colored(severity, SeverityName(severity)) + ": " + std::string(text));
    }
}

void Console::Write(std::string_view text)
{
    ClearProgress();
    m_Err << text << '\n';
}

void Console::Progress(std::string_view text)
{
    if (m_ShowsProgress)
    {
        m_Err << k_ClearLine << OneLine(text) << std::flush;
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
