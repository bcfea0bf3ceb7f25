#include <limn/shaderlab/Diagnostic.h>

#include "text/Text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

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

constexpr std::size_t k_MaxName = 64;  ///< longer names are no typo, and comparing them takes long
constexpr std::size_t k_MaxLine = 160; ///< bytes of a line of the file to show

std::string_view TrimEnd(std::string_view text)
{
    while (!text.empty() && isBlank(text.back()))
    {
        text.remove_suffix(1);
    }
    return text;
}

bool isInsideCharacter(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

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

/// Bytes of the character of UTF-8 that a text begins with; 0 where that is none or one that a
/// terminal takes for a command.
std::size_t PrintableSize(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (first >= 0xF8 || isInsideCharacter(text[0]) || size > text.size())
    {
        return 0;
    }
    std::uint32_t code = size == 1 ? first : first & (0x7Fu >> size);
    for (const char c : text.substr(1, size - 1))
    {
        if (!isInsideCharacter(c))
        {
            return 0;
        }
        code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
    }
    constexpr std::uint32_t k_Lowest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool isCode =
        code >= k_Lowest[size] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
    const bool isControl = (code < 0x20 && code != '\t') || (code >= 0x7F && code < 0xA0);
    return isCode && !isControl ? size : 0;
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
        const std::size_t size = PrintableSize(line.substr(i));
        printed.text += size > 0 ? line.substr(i, size) : std::string_view("\xEF\xBF\xBD");
        if (i < column)
        {
            printed.spacing += line[i] == '\t' ? '\t' : ' ';
        }
        i += std::max<std::size_t>(size, 1);
    }
    return printed;
}

} // namespace

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

std::string ToStringWithSource(const Diagnostic& diagnostic, std::string_view text)
{
    std::string shown = ToString(diagnostic);
    for (int line = 1; line < diagnostic.location.line; ++line)
    {
        const std::size_t end = text.find('\n');
        text = end == text.npos ? std::string_view{} : text.substr(end + 1);
    }
    const std::string_view line = TrimEnd(text.substr(0, text.find('\n')));
    if (diagnostic.location.line <= 0 || line.empty())
    {
        return shown;
    }
    // A byte order mark does not count as columns.
    const std::size_t mark = line.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
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
    return nearest;
}

std::string UnknownName(std::string_view name, const std::vector<std::string_view>& known)
{
    std::string text =
        "'" + std::string(name.substr(0, k_MaxName)) + (name.size() > k_MaxName ? "..." : "") + "'";
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
