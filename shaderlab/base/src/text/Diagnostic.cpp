#include <limn/base/Diagnostic.h>

#include <limn/base/Text.h>

#include <algorithm>
#include <array>
#include <limn/base/Lists.h>
#include <limn/base/TerminalText.h>

namespace limn
{

namespace
{

constexpr std::size_t k_MaxName = 64;  ///< longer names are no typo, and comparing them takes long
constexpr std::size_t k_MaxLine = 160; ///< bytes of a line of the file to show

/// The first place from `position` on where a character of UTF-8 starts; in what is no UTF-8, near
/// it.
std::size_t CharacterStart(std::string_view text, std::size_t position)
{
    const std::size_t last = position + 3;
    while (position < last && position < text.size() && isInsideCharacter(text[position]))
    {
        ++position;
    }
    return std::min(position, text.size());
}

/// A piece of a line for people, and blanks as wide as what lies before `column` in it. Tabs stay,
/// so that it does not matter how wide they are; what cannot be printed is U+FFFD, byte for byte.
struct PrintedLine
{
    std::string text;
    std::string spacing;
};
PrintedLine PrintLine(std::string_view line, std::size_t column)
{
    PrintedLine printed;
    for (std::size_t i = 0; i < line.size();)
    {
        const std::size_t size = line[i] == '\t' ? 1 : PrintableSize(line.substr(i));
        printed.text += size > 0 ? line.substr(i, size) : std::string_view("\xEF\xBF\xBD");
        if (i < column)
        {
            printed.spacing += line[i] == '\t' ? '\t' : ' ';
        }
        i += std::max<std::size_t>(size, 1);
    }
    return printed;
}

/// Returns the only known name that begins with one of at least four letters; "" if several do.
std::string_view OnlyLonger(std::string_view name, const std::vector<std::string_view>& known)
{
    constexpr std::size_t k_Fewest = 4;
    const auto isLonger = [&](std::string_view candidate)
    {
        return name.size() >= k_Fewest && candidate.starts_with(name);
    };
    return std::ranges::count_if(known, isLonger) == 1 ? *std::ranges::find_if(known, isLonger)
                                                       : std::string_view();
}

} // namespace

const char* SeverityName(Severity severity)
{
    constexpr std::array k_Names{"error", "warning", "note"};
    return k_Names.at(static_cast<std::size_t>(severity));
}

std::size_t EditDistance(std::string_view a, std::string_view b)
{
    const auto isEqual = [](char x, char y)
    {
        return ToLower(x) == ToLower(y);
    };
    // Three rows of the table of distances between the first i and the first j letters.
    std::vector<std::size_t> beforeLast(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t i = 0; i <= a.size(); ++i)
    {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            if (i == 0)
            {
                row[j] = j;
                continue;
            }
            const std::size_t change = isEqual(a[i - 1], b[j - 1]) ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && isEqual(a[i - 1], b[j - 2]) && isEqual(a[i - 2], b[j - 1]))
            {
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
            }
        }
        beforeLast.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

std::string ToString(const Diagnostic& diagnostic)
{
    std::string text = OneLine(diagnostic.file);
    if (diagnostic.location.line > 0)
    {
        text += ":" + std::to_string(diagnostic.location.line);
        if (diagnostic.location.column > 0)
        {
            text += ":" + std::to_string(diagnostic.location.column);
        }
    }
    return text + ": " + SeverityName(diagnostic.severity) + ": " + Sentence(diagnostic.message);
}

std::string ToStringWithSource(const Diagnostic& diagnostic, std::string_view text)
{
    std::string shown = ToString(diagnostic);
    for (int line = 1; line < diagnostic.location.line; ++line)
    {
        const std::size_t end = text.find('\n');
        text = end == text.npos ? std::string_view{} : text.substr(end + 1);
    }
    const std::string_view whole = text.substr(0, text.find('\n'));
    const std::string_view line = whole.substr(0, whole.find_last_not_of(k_Blanks) + 1);
    if (diagnostic.location.line <= 0 || line.empty())
    {
        return shown;
    }
    // A byte order mark does not count as columns.
    const std::size_t mark = line.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const std::size_t column =
        static_cast<std::size_t>(std::max(diagnostic.location.column, 1)) - 1 + mark;
    const std::size_t begin = column > k_MaxLine / 2 && line.size() > k_MaxLine
                                  ? CharacterStart(line, column - k_MaxLine / 2)
                                  : mark;
    const std::size_t end = CharacterStart(line, begin + k_MaxLine);
    const PrintedLine printed = PrintLine(line.substr(begin, end - begin), column - begin);
    shown += "\n" + std::string(begin > mark ? "..." : "") + printed.text +
             (end < line.size() ? "..." : "");
    if (diagnostic.location.column > 0)
    {
        shown += "\n" + std::string(begin > mark ? 3 : 0, ' ') + printed.spacing + "^";
    }
    return shown;
}

AssetError::AssetError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(Joined(diagnostics, "\n", &ToString)),
      m_Diagnostics(std::move(diagnostics))
{
}

AssetError::AssetError(std::string file, SourceLocation location, std::string message)
    : AssetError({{Severity::Error, std::move(file), location, std::move(message)}})
{
}

std::string_view NearestName(std::string_view name, const std::vector<std::string_view>& known)
{
    std::string_view nearest;
    if (name.size() > k_MaxName)
    {
        return nearest;
    }
    std::size_t best = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string_view candidate : known)
    {
        const std::size_t longer = std::max(name.size(), candidate.size());
        if (longer - std::min(name.size(), candidate.size()) >= best)
        {
            continue; // so many letters are missing at least
        }
        const std::size_t distance = EditDistance(name, candidate);
        if (distance < best)
        {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest.empty() ? OnlyLonger(name, known) : nearest;
}

std::string DidYouMean(std::string_view name, const std::vector<std::string_view>& known)
{
    const std::string_view nearest = NearestName(name, known);
    return nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?";
}

std::string UnknownName(std::string_view name, const std::vector<std::string_view>& known)
{
    const std::string quoted = "'" + Shortened(name, k_MaxName) + "'";
    if (const std::string meant = DidYouMean(name, known); !meant.empty())
    {
        return quoted + meant;
    }
    return quoted + (known.empty() ? "" : " (known: " + Joined(known, ", ") + ")");
}

} // namespace limn
