#include <limn/shaderlab/Diagnostic.h>

#include "Text.h"

#include <algorithm>
#include <cstddef>

namespace limn
{

namespace
{

std::string_view SeverityName(Severity severity)
{
    switch (severity)
    {
    case Severity::Error:
        return "error";
    case Severity::Warning:
        return "warning";
    case Severity::Note:
        return "note";
    }
    throw ContractError("Severity: unknown value");
}

std::string Join(const std::vector<Diagnostic>& diagnostics)
{
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics)
    {
        text += (text.empty() ? "" : "\n") + ToString(diagnostic);
    }
    return text;
}

/// Edit distance without case; two neighbours that changed places are one mistake.
std::size_t EditDistance(std::string_view a, std::string_view b)
{
    const auto isEqual = [](char x, char y)
    {
        return ToLower(x) == ToLower(y);
    };
    std::vector<std::vector<std::size_t>> cost(a.size() + 1,
                                               std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
    {
        for (std::size_t j = 0; j <= b.size(); ++j)
        {
            if (i == 0 || j == 0)
            {
                cost[i][j] = i + j;
                continue;
            }
            const std::size_t change = isEqual(a[i - 1], b[j - 1]) ? 0 : 1;
            cost[i][j] =
                std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + change});
            if (i > 1 && j > 1 && isEqual(a[i - 1], b[j - 2]) && isEqual(a[i - 2], b[j - 1]))
            {
                cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
            }
        }
    }
    return cost[a.size()][b.size()];
}

} // namespace

std::string ToString(const Diagnostic& diagnostic)
{
    std::string text = diagnostic.file;
    if (diagnostic.location.line > 0)
    {
        text += ":" + std::to_string(diagnostic.location.line);
        if (diagnostic.location.column > 0)
        {
            text += ":" + std::to_string(diagnostic.location.column);
        }
    }
    return text + ": " + std::string(SeverityName(diagnostic.severity)) + ": " + diagnostic.message;
}

AssetError::AssetError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(Join(diagnostics)), m_Diagnostics(std::move(diagnostics))
{
}

AssetError::AssetError(std::string file, SourceLocation location, std::string message)
    : AssetError({{Severity::Error, std::move(file), location, std::move(message)}})
{
}

std::string_view NearestName(std::string_view name, const std::vector<std::string_view>& known)
{
    std::string_view nearest;
    std::size_t best = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string_view candidate : known)
    {
        const std::size_t distance = EditDistance(name, candidate);
        if (distance < best)
        {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string UnknownName(std::string_view name, const std::vector<std::string_view>& known)
{
    std::string text = "'" + std::string(name) + "'";
    const std::string_view nearest = NearestName(name, known);
    if (!nearest.empty())
    {
        text += "; did you mean '" + std::string(nearest) + "'?";
    }
    text += " (known: ";
    for (std::size_t i = 0; i < known.size(); ++i)
    {
        text += (i == 0 ? "" : ", ") + std::string(known[i]);
    }
    return text + ")";
}

} // namespace limn
