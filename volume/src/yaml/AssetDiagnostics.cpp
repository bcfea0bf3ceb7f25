#include <limn/volume/AssetDiagnostics.h>

#include <algorithm>
#include <utility>

namespace limn
{

void AssetDiagnostics::Error(SourceLocation location, std::string message)
{
    m_Diagnostics.push_back({Severity::Error, m_File, location, std::move(message)});
}

void AssetDiagnostics::Note(SourceLocation location, std::string message)
{
    m_Diagnostics.push_back({Severity::Note, m_File, location, std::move(message)});
}

void AssetDiagnostics::Add(const AssetError& error)
{
    m_Diagnostics.insert(m_Diagnostics.end(), error.diagnostics().begin(),
                         error.diagnostics().end());
}

void AssetDiagnostics::ThrowIfErrors() const
{
    if (hasErrors())
    {
        throw AssetError(Sorted(Severity::Error));
    }
}

void AssetDiagnostics::ThrowWithoutPlaces() const
{
    AssetDiagnostics without(m_File);
    for (const Diagnostic& diagnostic : m_Diagnostics)
    {
        without.Error({}, diagnostic.message);
    }
    without.ThrowIfErrors();
}

std::size_t AssetDiagnostics::errorCount() const
{
    return static_cast<std::size_t>(
        std::ranges::count(m_Diagnostics, Severity::Error, &Diagnostic::severity));
}

std::vector<Diagnostic> AssetDiagnostics::Sorted(Severity severity) const
{
    std::vector<Diagnostic> sorted;
    std::copy_if(m_Diagnostics.begin(), m_Diagnostics.end(), std::back_inserter(sorted),
                 [severity](const Diagnostic& d) { return d.severity == severity; });
    std::ranges::stable_sort(sorted, {},
                             [](const Diagnostic& d)
                             { return std::pair(d.location.line, d.location.column); });
    return sorted;
}

} // namespace limn
