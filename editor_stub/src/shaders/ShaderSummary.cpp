#include "shaders/ShaderSummary.h"

#include <algorithm>
#include <cmath>

namespace limn
{

namespace
{

/// " (98.4 %)"; nothing where there is nothing to compare with. Rounded down, so that 100.0 means
/// all.
std::string Rate(int part, int whole)
{
    if (whole == 0)
    {
        return {};
    }
    const int tenths = static_cast<int>(std::floor(1000.0 * part / whole));
    return " (" + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %)";
}

std::string Count(int number, const char* noun)
{
    return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

} // namespace

ShaderSummary Summarize(const std::vector<ShaderCheck>& checks)
{
    ShaderSummary summary;
    for (const ShaderCheck& check : checks)
    {
        ++summary.files;
        summary.parsed += check.isParsed ? 1 : 0;
        summary.errors += static_cast<int>(
            std::count_if(check.diagnostics.begin(), check.diagnostics.end(),
                          [](const Diagnostic& d) { return d.severity == Severity::Error; }));
        for (const CheckedSubShader& subShader : check.subShaders)
        {
            for (const CheckedPass& pass : subShader.passes)
            {
                ++summary.passes[static_cast<std::size_t>(pass.outcome)];
            }
        }
    }
    return summary;
}

std::string ToString(const ShaderSummary& summary)
{
    std::string text = Count(summary.files, "file") + ": " + std::to_string(summary.parsed) +
                       " parsed" + Rate(summary.parsed, summary.files);
    if (summary.errors > 0)
    {
        text += ", " + Count(summary.errors, "error");
    }
    const int tried = summary.passesTried();
    text += "; " + std::to_string(summary.passesOf(PassOutcome::Compiled)) + " of " +
            std::to_string(tried) + (tried == 1 ? " pass" : " passes") + " compiled" +
            Rate(summary.passesOf(PassOutcome::Compiled), tried);
    const std::pair<PassOutcome, const char*> others[] = {
        {PassOutcome::Failed, " failed"},
        {PassOutcome::Refused, " refused"},
        {PassOutcome::MissingInclude, " with a missing include"}};
    for (const auto& [outcome, words] : others)
    {
        if (summary.passesOf(outcome) > 0)
        {
            text += ", " + std::to_string(summary.passesOf(outcome)) + words;
        }
    }
    return text;
}

} // namespace limn
