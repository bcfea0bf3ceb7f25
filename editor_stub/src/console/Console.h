#pragma once

#include <limn/shaderlab/Diagnostic.h>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Where a verb prints: results to `out`, all else through the members.
class Console
{
public:
    /// @param out, err  must outlive this; colour and progress only where `err` is std::cerr on a
    ///     terminal
    Console(std::ostream& out, std::ostream& err);

    std::ostream& out() { return m_Out; }

    void Print(const Diagnostic& diagnostic);
    void Print(const std::vector<Diagnostic>& diagnostics);
    /// Each with the line of its file that it is about and a caret, where the file can be read.
    void PrintWithSource(const std::vector<Diagnostic>& diagnostics);
    void Note(std::string_view sentence);  ///< "note: sentence"
    void Error(std::string_view sentence); ///< "error: sentence"
    void Line(std::string_view text);

    /// Shows a line that the next one replaces; nothing but on a terminal.
    void Progress(std::string_view text);

private:
    void Print(const Diagnostic& diagnostic, std::string text);
    std::string Colored(Severity severity, std::string_view text) const;
    void ClearProgress();

    std::ostream& m_Out;
    std::ostream& m_Err;
    bool m_IsTerminal;
    bool m_HasProgress = false;
};

} // namespace limn
