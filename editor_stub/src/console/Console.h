#pragma once

#include <limn/base/Terminal.h>

#include <limn/base/Diagnostic.h>
#include <ostream>
#include <sstream>
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

/// Prints for a verb: results to `out`, everything else to `err`. The members write no control
/// codes of terminals but their own colours.
class Console
{
public:
    /// @param out, err  must outlive this; progress is shown only if `err` is std::cerr on a
    ///     terminal
    Console(std::ostream& out, std::ostream& err);

    void Configure(const ConsoleOptions& options);
    /// Collects the results that follow, if they go to a terminal, until ShowCollected.
    void CollectResults();
    /// Writes the collected results, in the person's pager if they are longer than the terminal is
    /// high.
    void ShowCollected();
    bool isVerbose() const { return m_Options.isVerbose; }

    /// Prints one line, to which an end of line is added. It stays whole, as paths must.
    void Result(std::string_view line);
    /// Prints several lines for people, of which the last one has its end. On a terminal they are
    /// made to fit. Names in them must have gone through OneLine.
    void Results(std::string_view lines);
    void Data(std::string_view lines); ///< lines for programs, such as JSON, which stay whole
    /// Returns the stream for text without words of files, and for bytes.
    std::ostream& out() { return m_IsCollecting ? m_Collected : m_Out; }
    /// Returns true if people read the results at once.
    bool isOutTerminal() const { return isTerminal(m_Out); }
    /// Returns the columns of the results' terminal.
    std::size_t outWidth() const { return TerminalWidth(m_Out); }

    /// @param source  a text that is printed behind it as it is
    void Print(const Diagnostic& diagnostic, const std::string& source = "");
    void Print(const std::vector<Diagnostic>& diagnostics);
    /// Prints each with its line of the file and a caret, if the file can be read.
    void PrintWithSource(const std::vector<Diagnostic>& diagnostics);
    /// Returns true if people read what goes to `err`.
    bool isOnTerminal() const { return isTerminal(m_Err); }
    void Note(std::string_view sentence);    ///< "note: sentence"
    void Warning(std::string_view sentence); ///< "warning: sentence"
    void Error(std::string_view text);       ///< "error: text", which may have several lines
    void Bug(std::string_view what);         ///< an error in limn itself
    void Verbose(std::string_view sentence); ///< a line that is shown only with -v
    void Line(std::string_view text);        ///< one or several lines, as they are

    /// Shows a line that the next one replaces, only on a terminal.
    void Progress(std::string_view text);

private:
    void Say(Severity severity, std::string_view text);
    void Write(std::string_view text);
    std::string Fitted(std::string_view text) const;
    bool isShown(Severity severity) const;
    std::string Colored(Severity severity, std::string_view text) const;
    void ClearProgress();

    std::ostream& m_Out;
    std::ostringstream m_Collected;
    bool m_IsCollecting = false;
    std::ostream& m_Err;
    ConsoleOptions m_Options;
    bool m_UsesColor = false;
    bool m_ShowsProgress = false;
    bool m_HasProgress = false;
};

} // namespace limn
