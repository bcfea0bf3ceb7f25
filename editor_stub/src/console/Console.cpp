#include "console/Console.h"

#include <iostream>
#include <limn/shaderlab/ReadFile.h>
#include <map>
#include <unistd.h>

namespace limn
{

namespace
{

constexpr std::string_view k_ClearLine = "\r\033[K";

const char* Name(Severity severity)
{
    switch (severity)
    {
    case Severity::Error:
        return "error";
    case Severity::Warning:
        return "warning";
    case Severity::Note:
        break;
    }
    return "note";
}

const char* ColorCode(Severity severity)
{
    switch (severity)
    {
    case Severity::Error:
        return "\033[31m";
    case Severity::Warning:
        return "\033[33m";
    case Severity::Note:
        break;
    }
    return "\033[36m";
}

} // namespace

Console::Console(std::ostream& out, std::ostream& err)
    : m_Out(out), m_Err(err), m_IsTerminal(&err == &std::cerr && isatty(STDERR_FILENO) == 1)
{
}

std::string Console::Colored(Severity severity, std::string_view text) const
{
    const std::string plain(text);
    return m_IsTerminal ? ColorCode(severity) + plain + "\033[0m" : plain;
}

void Console::Print(const Diagnostic& diagnostic)
{
    Print(diagnostic, ToString(diagnostic));
}

void Console::Print(const Diagnostic& diagnostic, std::string text)
{
    const std::string word = std::string(": ") + Name(diagnostic.severity) + ": ";
    const std::size_t at = text.find(word);
    if (at != std::string::npos)
    {
        text.replace(at + 2, word.size() - 4,
                     Colored(diagnostic.severity, Name(diagnostic.severity)));
    }
    Line(text);
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

void Console::Note(std::string_view sentence)
{
    Line(Colored(Severity::Note, "note") + ": " + std::string(sentence));
}

void Console::Error(std::string_view sentence)
{
    Line(Colored(Severity::Error, "error") + ": " + std::string(sentence));
}

void Console::Line(std::string_view text)
{
    ClearProgress();
    m_Err << text << '\n';
}

void Console::Progress(std::string_view text)
{
    if (m_IsTerminal)
    {
        m_Err << k_ClearLine << text << std::flush;
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
