#pragma once

#include <limn/base/Terminal.h>

#include <limn/base/Diagnostic.h>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// What every verb takes: --color, -q and -v.
struct ConsoleOptions
{
    ColorMode color = ColorMode::Auto; ///< of stderr
    bool isQuiet = false;              ///< errors only
    bool isVerbose = false;
};

/// Returns "error", "warning" or "note".
const char* SeverityName(Severity severity);

/// Where a verb prints: results to `out`, all else to `err`. The members write nothing that would
/// command a terminal but their own colours.
class Console
{
public:
    /// @param out, err  must outlive this; progress only where `err` is std::cerr on a terminal
    Console(std::ostream& out, std::ostream& err);

    void Configure(const ConsoleOptions& options);
    bool isVerbose() const { return m_Options.isVerbose; }

    void Result(std::string_view line);   ///< one line, which gets its end
    void Results(std::string_view lines); ///< several, the last with its end; OneLine each name
    std::ostream& out() { return m_Out; } ///< what no file has a word in, and bytes

    void Print(const Diagnostic& diagnostic);
    void Print(const std::vector<Diagnostic>& diagnostics);
    /// Each with the line of its file that it is about and a caret, where the file can be read.
    void PrintWithSource(const std::vector<Diagnostic>& diagnostics);
    bool isOnTerminal() const;               ///< where people read what goes to `err`
    void Note(std::string_view sentence);    ///< "note: sentence"
    void Warning(std::string_view sentence); ///< "warning: sentence"
    void Error(std::string_view text);       ///< "error: text", which may have several lines
    void Bug(std::string_view what);         ///< an error that is no one's but limn's
    void Verbose(std::string_view sentence); ///< with -v only
    void Line(std::string_view text);        ///< as it is, of one or several lines

    /// Shows a line that the next one replaces; nothing but on a terminal.
    void Progress(std::string_view text);

private:
    void Print(const Diagnostic& diagnostic, std::string text);
    void Say(Severity severity, std::string_view text);
    void Write(std::string_view text);
    bool isShown(Severity severity) const;
    std::string Colored(Severity severity, std::string_view text) const;
    void ClearProgress();

    std::ostream& m_Out;
    std::ostream& m_Err;
    ConsoleOptions m_Options;
    bool m_UsesColor = false;
    bool m_ShowsProgress = false;
    bool m_HasProgress = false;
};

} // namespace limn
