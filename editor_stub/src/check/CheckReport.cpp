#include "check/Expectations.h"

#include "console/Json.h"
#include "explain/TextLines.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::size_t k_ListedDifferences = 20; ///< of an expectation, unless -v asks for all

std::size_t FailedCount(const std::vector<Expectation>& expectations)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(expectations, [](const Expectation& one) { return !one.holds(); }));
}

/// Text within a tag's attribute or between tags. OneLine has taken out most that XML cannot have.
std::string Escaped(const std::string& text)
{
    const std::string escaped = Replaced(MarkupText(OneLine(text)), "'", "&apos;");
    return Replaced(Replaced(escaped, "\xEF\xBF\xBE", "\\uFFFE"), "\xEF\xBF\xBF", "\\uFFFF");
}

std::string PlaceOf(const Expectation& one, const std::string& file)
{
    return file + ":" + std::to_string(one.location.line) + ":" +
           std::to_string(one.location.column);
}

} // namespace

std::string CheckText(const std::vector<Expectation>& expectations, const std::string& file,
                      const std::string& failed, bool isLong)
{
    std::string text;
    for (const Expectation& one : expectations)
    {
        if (one.holds())
        {
            continue;
        }
        text += OneLine(PlaceOf(one, file) + ": " + one.name) + "\n";
        const std::size_t most = isLong ? one.diff.size() : k_ListedDifferences;
        for (std::size_t i = 0; i < std::min(most, one.diff.size()); ++i)
        {
            text += "  " + OneLine(one.diff[i]) + "\n";
        }
        text += one.diff.size() > most
                    ? "  … and " + std::to_string(one.diff.size() - most) + " more; -v lists them\n"
                    : "";
    }
    return text + CountText(expectations.size(), "expectation") + ", " +
           std::to_string(FailedCount(expectations)) + " " + failed + "\n";
}

std::string CheckJson(const std::vector<Expectation>& expectations, const std::string& file,
                      const std::string& scene)
{
    const auto toJson = [](const Expectation& one) -> Json
    {
        return {{"name", one.name},
                {"line", one.location.line},
                {"column", one.location.column},
                {"holds", one.holds()},
                {"diff", one.diff}};
    };
    return JsonText({{"scene", scene},
                     {"file", file},
                     {"expectations", JsonList(expectations, toJson)},
                     {"failed", FailedCount(expectations)}});
}

std::string JUnitXml(const std::vector<Expectation>& expectations, const std::string& file,
                     const std::string& scene)
{
    const std::string counts = " tests=\"" + std::to_string(expectations.size()) +
                               "\" failures=\"" + std::to_string(FailedCount(expectations)) + "\"";
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts +
                       ">\n  <testsuite name=\"" + Escaped(file) + "\"" + counts + ">\n";
    for (const Expectation& one : expectations)
    {
        text += "    <testcase classname=\"" + Escaped(scene) + "\" name=\"" + Escaped(one.name) +
                "\" file=\"" + Escaped(file) + "\" line=\"" + std::to_string(one.location.line) +
                "\"";
        if (one.holds())
        {
            text += "/>\n";
            continue;
        }
        text += ">\n      <failure message=\"" + Escaped(one.diff.front()) + "\">" +
                Escaped(PlaceOf(one, file)) + "\n";
        for (const std::string& line : one.diff)
        {
            text += Escaped(line) + "\n";
        }
        text += "</failure>\n    </testcase>\n";
    }
    return text + "  </testsuite>\n</testsuites>\n";
}

} // namespace limn
