#pragma once

#include <limn/base/Diagnostic.h>
#include <string>
#include <utility>
#include <vector>

namespace limn
{

/// Collects all errors and notes about one file while it is read, so that a person sees all
/// problems at once.
class AssetDiagnostics
{
public:
    explicit AssetDiagnostics(std::string file) : m_File(std::move(file)) {}

    void Error(SourceLocation location, std::string message);
    void Note(SourceLocation location, std::string message);
    void Add(const AssetError& error); ///< adds every message of the error

    /// @throws AssetError with every error, ordered by place, if there is one
    void ThrowIfErrors() const;
    /// Does the same for errors about a value that was typed, in which a place says nothing.
    void ThrowWithoutPlaces() const;

    /// Returns the notes, ordered by place.
    std::vector<Diagnostic> notes() const { return Sorted(Severity::Note); }
    const std::vector<Diagnostic>& diagnostics() const { return m_Diagnostics; }
    const std::string& file() const { return m_File; }
    bool hasErrors() const { return errorCount() > 0; }
    std::size_t errorCount() const;

private:
    std::vector<Diagnostic> Sorted(Severity severity) const;

    std::string m_File;
    std::vector<Diagnostic> m_Diagnostics; ///< in the order they were found
};

} // namespace limn
