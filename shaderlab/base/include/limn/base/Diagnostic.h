#pragma once

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

    bool operator==(const SourceLocation&) const = default;
};

enum class Severity
{
    Error,
    Warning,
    Note
};

/// One thing to say about a file a person wrote.
struct Diagnostic
{
    Severity severity = Severity::Error;
    std::string file;
    SourceLocation location;
    std::string message; ///< "subject: what is wrong; what would be right", without the place

    bool operator==(const Diagnostic&) const = default;
};

/// `file:line:col: error: message`, the form compilers use, as the terminal may have it; a place of
/// 0 is left out.
std::string ToString(const Diagnostic& diagnostic);

/// ToString(), and below it the line of `text` that it is about with a '^' under the column, as
/// compilers show it: three lines without a line break at the end, for people to read. Tabs stay
/// tabs, bytes that cannot be printed become U+FFFD each; of a long line the part around the column
/// is shown. Only ToString() where there is no such line. Takes time proportional to the line's
/// number.
///
/// @param text  all of the file that the diagnostic names
std::string ToStringWithSource(const Diagnostic& diagnostic, std::string_view text);

/// A file a person wrote cannot be used. Holds everything found in that file, not only the first
/// problem; what() is all of it, one diagnostic a line.
class AssetError : public std::runtime_error
{
public:
    explicit AssetError(std::vector<Diagnostic> diagnostics);
    AssetError(std::string file, SourceLocation location, std::string message);

    const std::vector<Diagnostic>& diagnostics() const { return m_Diagnostics; }

private:
    std::vector<Diagnostic> m_Diagnostics;
};

/// A file cannot be written because the machine lacks something, such as room on its disk: no file
/// that a person wrote is at fault.
class MachineError : public AssetError
{
public:
    using AssetError::AssetError;
};

/// A caller broke a documented precondition: a mistake in the program, not in its input.
class ContractError : public std::logic_error
{
public:
    using std::logic_error::logic_error;
};

/// How many letters have to be changed, added or left out to make `b` of `a`, without case; two
/// neighbours that changed places are one mistake. Takes time and memory of a.size() * b.size().
std::size_t EditDistance(std::string_view a, std::string_view b);

/// Returns the known name closest to `name` by edit distance (case-insensitive), or else the only
/// one that begins with it, or "" if none is near enough to be what was meant (distance at most a
/// third of the length, at least 1). Names of more than 64 bytes are near to none.
std::string_view NearestName(std::string_view name, const std::vector<std::string_view>& known);

/// "'outlneWidth'; did you mean 'outlineWidth'?" for messages about unknown names; where nothing is
/// near, "'foo' (known: a, b, c)". Long names are Shortened.
std::string UnknownName(std::string_view name, const std::vector<std::string_view>& known);

} // namespace limn
