#include <limn/volume/YamlSplicer.h>

#include "yaml/Text.h"

#include <algorithm>
#include <cmath>
#include <limn/base/Lists.h>
#include <limn/base/ParseWhole.h>
#include <optional>

namespace limn
{

namespace
{

std::optional<float> ParseFloat(std::string_view text)
{
    return ParseWhole<float>(text.substr(text.starts_with('+') ? 1 : 0));
}

/// Returns whether both scalars are the same text or the same number.
bool IsSame(const YamlNode& one, const YamlNode& other)
{
    const std::optional<float> number = ParseFloat(one.scalar());
    const bool isNumber = number && !one.isQuoted() && !other.isQuoted();
    return one.scalar() == other.scalar() || (isNumber && number == ParseFloat(other.scalar()));
}

/// The channel as two hexadecimal digits; nothing unless they give exactly this number back.
std::optional<std::string> HexOf(const YamlNode& channel, const char* digits)
{
    const float value = ParseFloat(channel.scalar()).value_or(-1.0f);
    const float scaled = std::round(value * 255.0f);
    if (!(scaled >= 0.0f && scaled <= 255.0f) || scaled / 255.0f != value)
    {
        return std::nullopt;
    }
    const auto byte = static_cast<std::size_t>(scaled);
    return std::string{digits[byte / 16], digits[byte % 16]};
}

/// "#RRGGBB" or "#RRGGBBAA", as the old text has it; nothing for what eight bits do not hold.
std::optional<std::string> HexColor(const std::string& old, const YamlNode& fresh)
{
    const bool isLower = old.find_first_of("abcdef") != std::string::npos;
    const char* digits = isLower ? "0123456789abcdef" : "0123456789ABCDEF";
    std::string hex = "#";
    for (const YamlEntry& entry : fresh.entries())
    {
        const std::optional<std::string> channel = HexOf(entry.value, digits);
        if (!channel)
        {
            return std::nullopt;
        }
        const bool isImplied = entry.key == "a" && old.size() == 7 && entry.value.scalar() == "1";
        hex += isImplied ? "" : *channel;
    }
    return hex;
}

/// Returns the offset of a part of a text.
std::size_t OffsetIn(std::string_view text, std::string_view part)
{
    return static_cast<std::size_t>(part.data() - text.data());
}

/// Returns whether all lists have the same lengths, so that the scalars can be replaced one by one.
/// Numbers may be a list here and a map there; a map may lack keys that stay implied.
bool HasSameShape(const YamlNode& old, const YamlNode& fresh)
{
    if (!old.isSequence() || !fresh.isSequence())
    {
        const bool isOtherCurve =
            (old.isSequence() && fresh.Find("keys")) || (old.Find("keys") && fresh.isSequence());
        return !isOtherCurve && !(old.isSequence() && fresh.isScalar());
    }
    bool isSame = old.items().size() == fresh.items().size();
    for (std::size_t i = 0; isSame && i < old.items().size(); ++i)
    {
        const YamlNode& one = old.items()[i];
        const YamlNode& other = fresh.items()[i];
        isSame = one.kind() == other.kind();
        for (const YamlEntry& entry : other.entries())
        {
            isSame = isSame && one.Find(entry.key);
        }
    }
    return isSame;
}

/// The node on one line.
std::string FlowText(const YamlNode& node)
{
    if (node.isScalar() || node.isNull())
    {
        return node.isQuoted() ? InQuotes(node.scalar(), '"') : node.scalar();
    }
    const auto entryText = [](const YamlEntry& entry)
    {
        return entry.key + ": " + FlowText(entry.value);
    };
    return node.isMap() ? "{" + Joined(node.entries(), ", ", entryText) + "}"
                        : "[" + Joined(node.items(), ", ", FlowText) + "]";
}

/// Returns how many scalars of one tree differ from those of the other. A scalar in place of
/// something else counts as one.
std::size_t CountDifferences(const YamlNode& one, const YamlNode& other)
{
    const std::size_t size = one.items().size() + one.entries().size();
    if (one.kind() != other.kind() || size != other.items().size() + other.entries().size())
    {
        return 1;
    }
    std::size_t count = one.scalar() != other.scalar() ? 1 : 0;
    for (std::size_t i = 0; i < one.items().size(); ++i)
    {
        count += CountDifferences(one.items()[i], other.items()[i]);
    }
    for (std::size_t i = 0; i < one.entries().size(); ++i)
    {
        count += CountDifferences(one.entries()[i].value, other.entries()[i].value);
    }
    return count;
}

} // namespace

std::string_view TextFrom(std::string_view text, const YamlNode& node)
{
    const SourceLocation location = node.location();
    std::size_t offset = 0;
    for (int line = 1; line < location.line; ++line)
    {
        offset = text.find('\n', offset) + 1;
    }
    const bool isBehindMark = location.line == 1 && text.substr(0, 3) == "\xEF\xBB\xBF";
    offset += static_cast<std::size_t>(location.column - 1) + (isBehindMark ? 3 : 0);
    return text.substr(std::min(offset, text.size()));
}

YamlSplicer::YamlSplicer(std::string_view text, std::string subject, AssetDiagnostics& diagnostics)
    : m_Text(text), m_Subject(std::move(subject)), m_Diagnostics(diagnostics)
{
}

void YamlSplicer::Refuse(const YamlNode& node, const std::string& problem)
{
    m_Diagnostics.Error(node.location(), m_Subject + ": " + problem);
}

void YamlSplicer::Replace(const YamlNode& old, const YamlNode& fresh, const std::string& freshText)
{
    if (old.isNull() && !fresh.isNull())
    {
        FillIn(old, freshText);
    }
    else if (!HasSameShape(old, fresh) && !FlowExtent(old).empty())
    {
        AddAt(FlowExtent(old), freshText);
    }
    else if (old.isMap() && fresh.isMap())
    {
        ReplaceMap(old, fresh);
    }
    else if (old.isSequence() && !fresh.isScalar() && !fresh.isNull())
    {
        ReplaceSequence(old, fresh);
    }
    else if (old.isScalar() && fresh.Find("m_Bits"))
    {
        ReplaceScalar(old, *fresh.Find("m_Bits"));
    }
    else if (old.isScalar() && fresh.isMap())
    {
        Add(old, HexColor(old.scalar(), fresh).value_or(freshText));
    }
    else if (old.isScalar() && fresh.isScalar())
    {
        ReplaceScalar(old, fresh);
    }
    else if (old.isScalar() && fresh.isSequence())
    {
        Add(old, freshText);
    }
    else
    {
        Refuse(old, "the file has " + old.Describe() + " here, which cannot become " + freshText +
                        "; change it by hand");
    }
}

void YamlSplicer::ReplaceMap(const YamlNode& old, const YamlNode& fresh)
{
    for (const YamlEntry& entry : fresh.entries())
    {
        const YamlNode* value = old.Find(entry.key);
        if (value)
        {
            Replace(*value, entry.value, FlowText(entry.value));
        }
        else if (entry.key != "a" || entry.value.scalar() != "1")
        {
            Refuse(old, "'" + entry.key + "' is missing here; add '" + entry.key + ": " +
                            entry.value.scalar() + "' by hand");
        }
    }
}

void YamlSplicer::ReplaceSequence(const YamlNode& old, const YamlNode& fresh)
{
    std::vector<YamlNode> items(fresh.items().begin(), fresh.items().end());
    for (const YamlEntry& entry : fresh.entries())
    {
        items.push_back(entry.value);
    }
    const std::span<const YamlNode> olds = old.items();
    const bool isAlphaImplied = olds.size() == 3 && items.size() == 4 && fresh.Find("a") &&
                                fresh.Find("a")->scalar() == "1";
    if (olds.size() != items.size() && !isAlphaImplied)
    {
        Refuse(old, "the file has a list of " + std::to_string(olds.size()) + " here, " +
                        std::to_string(items.size()) + " are needed; change it by hand");
        return;
    }
    for (std::size_t i = 0; i < olds.size(); ++i)
    {
        Replace(olds[i], items[i], FlowText(items[i]));
    }
}

void YamlSplicer::ReplaceScalar(const YamlNode& old, const YamlNode& fresh)
{
    if (!IsSame(old, fresh))
    {
        Add(old,
            fresh.isQuoted() && !old.isQuoted() ? InQuotes(fresh.scalar(), '"') : fresh.scalar());
    }
}

std::string_view YamlSplicer::Extent(const YamlNode& scalar) const
{
    const std::string_view text = WithoutMarks(TextFrom(m_Text, scalar));
    if (!scalar.isQuoted())
    {
        const std::size_t size = scalar.scalar().size();
        return text.substr(0, size) == scalar.scalar() ? text.substr(0, size) : std::string_view();
    }
    if (const std::size_t end = EndOfQuotes(text); end > 0 && end != text.npos)
    {
        const std::string_view extent = text.substr(0, end);
        return extent.find('\n') == text.npos ? extent : std::string_view();
    }
    return {};
}

void YamlSplicer::Add(const YamlNode& old, std::string fresh)
{
    const std::string_view extent = Extent(old);
    if (extent.empty())
    {
        Refuse(old, "the value is not on one line; change it by hand");
        return;
    }
    const char quote = extent.front();
    const bool isFlow = !fresh.empty() && (fresh.front() == '{' || fresh.front() == '[');
    if (old.isQuoted() && !isFlow)
    {
        fresh = InQuotes(fresh, quote);
    }
    AddAt(extent, std::move(fresh));
}

void YamlSplicer::AddAt(std::string_view extent, std::string fresh)
{
    const std::size_t begin = OffsetIn(m_Text, extent);
    m_Splices.push_back({begin, begin + extent.size(), std::move(fresh)});
}

std::string_view YamlSplicer::FlowExtent(const YamlNode& node) const
{
    const std::string_view text = TextFrom(m_Text, node);
    int depth = 0;
    char quote = 0;
    for (std::size_t i = 0; i < text.size() && text[i] != '\n'; ++i)
    {
        const char c = text[i];
        if (quote != 0)
        {
            i += quote == '"' && c == '\\' ? 1 : 0;
            quote = c == quote ? 0 : quote;
            continue;
        }
        quote = c == '"' || c == '\'' ? c : quote;
        depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        if (depth == 0)
        {
            return i > 0 ? text.substr(0, i + 1) : std::string_view();
        }
    }
    return {};
}

void YamlSplicer::FillIn(const YamlNode& null, const std::string& freshText)
{
    // A Null that belongs to a key is where the key is.
    const std::string_view rest = TextFrom(m_Text, null);
    const std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
    const std::size_t colon = line.find(':');
    const std::size_t value =
        std::min(colon == std::string_view::npos ? colon : line.find_first_not_of(" \t", colon + 1),
                 line.size());
    const std::string_view behind = line.substr(value);
    if (colon == std::string_view::npos || (!behind.empty() && behind.front() != '#' &&
                                            behind.front() != '}' && behind.front() != ','))
    {
        Refuse(null, "the file has nothing here, which cannot become " + freshText +
                         "; change it by hand");
        return;
    }
    AddAt(line.substr(colon + 1, 0), " " + freshText);
}

void YamlSplicer::Insert(const YamlNode& map, const std::string& key, const std::string& valueText)
{
    const std::string line = key + ": " + valueText;
    const std::string_view rest = TextFrom(m_Text, map);
    const auto indentation = [](int column)
    {
        return std::string(static_cast<std::size_t>(column - 1), ' ');
    };
    if (map.isNull())
    {
        AddLineBehind(OffsetIn(m_Text, rest), indentation(map.location().column + 2) + line);
        return;
    }
    if (rest.starts_with('{'))
    {
        const std::string_view flow = FlowExtent(map);
        const std::size_t end = flow.substr(0, flow.size() - 1).find_last_not_of(" \t");
        if (!flow.empty())
        {
            AddAt(flow.substr(end + 1, 0), (map.entries().empty() ? "" : ", ") + line);
            return;
        }
    }
    const std::span<const YamlEntry> entries = map.entries();
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
    {
        const std::string_view extent = OneLineExtent(entry->value);
        if (!extent.empty() && !rest.starts_with('{'))
        {
            AddLineBehind(OffsetIn(m_Text, extent), indentation(entry->keyLocation.column) + line);
            return;
        }
    }
    Refuse(map, "the file does not set it; add a line '" + line + "' by hand");
}

void YamlSplicer::Append(const YamlNode& root, const std::string& name, const std::string& key,
                         const std::string& valueText)
{
    if (TextFrom(m_Text, root).starts_with('{'))
    {
        Insert(root, name, "{" + key + ": " + valueText + "}");
        return;
    }
    const std::string end(EndOfLine());
    AddAt(m_Text.substr(m_Text.size()), (m_Text.ends_with('\n') ? "" : end) + name + ":" + end +
                                            "  " + key + ": " + valueText + end);
}

std::string_view YamlSplicer::OneLineExtent(const YamlNode& value) const
{
    if (value.isScalar())
    {
        return Extent(value);
    }
    const std::string_view rest = TextFrom(m_Text, value);
    const bool isFlow = rest.starts_with('{') || rest.starts_with('[');
    return isFlow ? FlowExtent(value) : std::string_view();
}

void YamlSplicer::AddLineBehind(std::size_t place, const std::string& line)
{
    const std::size_t newline = m_Text.find('\n', place);
    if (newline == std::string_view::npos)
    {
        AddAt(m_Text.substr(m_Text.size()), std::string(EndOfLine()) + line);
        return;
    }
    AddAt(m_Text.substr(newline + 1, 0), line + std::string(EndOfLine()));
}

std::string_view YamlSplicer::EndOfLine() const
{
    return m_Text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
}

void YamlSplicer::RequireNoOtherChange(std::span<const YamlNode> before,
                                       std::span<const YamlNode> after, SourceLocation place) const
{
    std::size_t differences = after.size() == before.size() ? 0 : count() + 1;
    for (std::size_t i = 0; i < before.size() && i < after.size(); ++i)
    {
        differences += CountDifferences(before[i], after[i]);
    }
    if (differences != count())
    {
        throw AssetError(m_Diagnostics.file(), place,
                         m_Subject + ": other values repeat this one by an alias (*), and would "
                                     "change as well; change it by hand");
    }
}

std::string YamlSplicer::Result() const
{
    std::vector<Splice> splices = m_Splices;
    std::ranges::sort(splices, {}, &Splice::begin);
    std::string result;
    std::size_t at = 0;
    for (const Splice& splice : splices)
    {
        result.append(m_Text.substr(at, splice.begin - at)).append(splice.text);
        at = splice.end;
    }
    return result.append(m_Text.substr(at));
}

} // namespace limn
