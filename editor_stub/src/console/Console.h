#pragma once

#include <limn/base/Terminal.h>

#include <limn/base/Diagnostic.h>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The options of every verb: --color, -q and -v.
struct ConsoleOptions
{
    ColorMode color = ColorMode::Auto; ///< the colours of stderr
    bool isQuiet = false;              ///< errors only
    bool isVerbose = false;
};

/// Returns "error", "warning" or "note".
const char* SeverityName(Severity severity);

/// Prints for a verb: results to `out`, everything else to `err`. The members write no control
/// codes of terminals but their own colours.
class Console
{
public:
    /// @param out, err  must outlive this; progress is shown only if `err` is std::cerr on a
    ///     terminal
    Console(std::ostream& out, std::ostream& err);

    void Configure(const ConsoleOptions& options);
    bool isVerbose() const { return m_Options.isVerbose; }

    void Result(std::string_view line); ///< one line, to which an end of line is added
    /// Prints several lines, of which the last one has its end. Names in them must have gone
    /// through OneLine.
    void Results(std::string_view lines);
    std::ostream& out() { return m_Out; } ///< for text without words of files, and for bytes

    void Print(const Diagnostic& diagnostic);
    void Print(const std::vector<Diagnostic>& diagnostics);
    /// Prints each with its line of the file and a caret, if the file can be read.
    void PrintWithSource(const std::vector<Diagnostic>& diagnostics);
    bool isOnTerminal() const;               ///< true if people read what goes to `err`
    void Note(std::string_view sentence);    ///< "note: sentence"
    void Warning(std::string_view sentence); ///< "warning: sentence"
    void Error(std::string_view text);       ///< "error: text", which may have several lines
    void Bug(std::string_view what);         ///< an error in limn itself
    void Verbose(std::string_view sentence); ///< a line that is shown only with -v
    void Line(std::string_view text);        ///< one or several lines, as they are

    /// Shows a line that the next one replaces, only on a terminal.
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
