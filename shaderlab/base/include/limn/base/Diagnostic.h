#pragma once

#include <compare>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A place in a text file. Lines and columns count from 1; 0 means "no particular place".
struct SourceLocation
{
    int line = 0;
    int column = 0; ///< in bytes

    auto operator<=>(const SourceLocation&) const = default;
};

enum class Severity
{
    Error,
    Warning,
    Note
};

/// Returns "error", "warning" or "note".
const char* SeverityName(Severity severity);

/// A message about a file that a person wrote.
struct Diagnostic
{
    Severity severity = Severity::Error;
    std::string file;
    SourceLocation location;
    std::string message; ///< "subject: what is wrong; what would be right", without the place

    bool operator==(const Diagnostic&) const = default;
};

/// Returns `file:line:col: error: message`, the form of compilers, in characters that are safe on a
/// terminal. A place of 0 is omitted.
std::string ToString(const Diagnostic& diagnostic);

/// Returns ToString(), and below it the line of `text` with a '^' under the column, as compilers
/// show it: three lines without a line break at the end, for people to read. Tabs stay tabs, and
/// each byte that cannot be printed becomes U+FFFD. A long line is cut to the part around the
/// column. Returns only ToString() if there is no such line. Takes time proportional to the line's
/// number.
///
/// @param text  the whole text of the file that the diagnostic names
std::string ToStringWithSource(const Diagnostic& diagnostic, std::string_view text);

/// The error that a file that a person wrote cannot be used. It holds all problems found in that
/// file, not only the first one; what() has all of them, one diagnostic per line.
class AssetError : public std::runtime_error
{
public:
    explicit AssetError(std::vector<Diagnostic> diagnostics);
    AssetError(std::string file, SourceLocation location, std::string message);

    const std::vector<Diagnostic>& diagnostics() const { return m_Diagnostics; }

private:
    std::vector<Diagnostic> m_Diagnostics;
};

/// The error that a file cannot be written because the machine lacks something, such as room on its
/// disk. No file that a person wrote is the cause.
class MachineError : public AssetError
{
public:
    using AssetError::AssetError;
};

/// The error that a caller broke a documented precondition. It is a mistake in the program, not in
/// its input.
class ContractError : public std::logic_error
{
public:
    using std::logic_error::logic_error;
};

/// Returns how many letters must be changed, added or removed to turn `a` into `b`, ignoring case.
/// Two swapped neighbours count as one. Takes time and memory proportional to a.size() * b.size().
std::size_t EditDistance(std::string_view a, std::string_view b);

/// Returns the known name that is closest to `name` by edit distance (ignoring case); if none is
/// near enough, the only one that begins with `name`; otherwise "". A name is near enough if its
/// distance is at most a third of the length, or 1. Names of more than 64 bytes are near to none.
std::string_view NearestName(std::string_view name, const std::vector<std::string_view>& known);

/// Returns "; did you mean 'outlineWidth'?" for a name that is not known, or "" if no name is near.
std::string DidYouMean(std::string_view name, const std::vector<std::string_view>& known);

/// Returns "'outlneWidth'; did you mean 'outlineWidth'?" for messages about unknown names, or
/// "'foo' (known: a, b, c)" if no name is near. Long names are Shortened.
std::string UnknownName(std::string_view name, const std::vector<std::string_view>& known);

} // namespace limn
