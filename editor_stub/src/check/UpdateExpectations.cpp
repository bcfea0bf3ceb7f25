#include "check/Expectations.h"

#include "check/Differences.h"
#include "console/Texts.h"

#include <limn/base/TerminalText.h>
#include <limn/volume/YamlSplicer.h>
#include <set>

namespace limn
{

namespace
{

constexpr std::size_t k_Width = 100; ///< columns of a written line

/// Text that YAML reads back as this text, in brackets as well.
std::string Quoted(const std::string& text)
{
    const auto isPlain = [](char c)
    {
        return isLetter(c) || isDigit(c) || c == ' ' || c == '-' || c == '.' || c == '/' ||
               c == '(' || c == ')' || static_cast<unsigned char>(c) >= 0x80;
    };
    if (!text.empty() && (isLetter(text.front()) || isDigit(text.front())) && text.back() != ' ' &&
        std::ranges::all_of(text, isPlain) && !IsIn(text, {"null", "Null", "NULL"}))
    {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text)
    {
        constexpr const char* k_Digits = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F)
        {
            quoted += std::string("\\x") + k_Digits[byte / 16] + k_Digits[byte % 16];
            continue;
        }
        quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return quoted + '"';
}

/// "[a, b]", in lines of `width` columns.
std::string FlowList(const std::vector<std::string>& items, std::size_t column, std::size_t indent)
{
    std::string text = "[";
    ++column;
    for (std::size_t i = 0; i < items.size(); ++i)
    {
        const std::string item = Quoted(items[i]) + (i + 1 < items.size() ? "," : "");
        if (i > 0 && column + 1 + item.size() > k_Width)
        {
            text += "\n" + std::string(indent, ' ');
            column = indent;
        }
        else if (i > 0)
        {
            text += " ";
            ++column;
        }
        text += item;
        column += item.size();
    }
    return text + "]";
}

std::string BlockList(const std::vector<std::string>& items, std::size_t indent)
{
    return "- " + Joined(items, "\n" + std::string(indent, ' ') + "- ", Quoted);
}

/// A part of the file's text.
struct Extent
{
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Finds where the values of a YAML text begin and end.
class ExtentFinder
{
public:
    explicit ExtentFinder(const std::string& text) : m_Text(text) {}

    /// Returns where a value stands, or nothing if its place is not that of its first character.
    std::optional<Extent> Find(const YamlNode& node) const
    {
        const std::string_view rest = TextFrom(m_Text, node);
        if (rest.empty())
        {
            return std::nullopt;
        }
        const std::size_t begin = m_Text.size() - rest.size();
        const char first = rest.front();
        if (node.isScalar())
        {
            return Extent{begin,
                          first == '"' || first == '\'' ? EndOfQuote(begin) : EndOfPlain(begin)};
        }
        return first == '[' || first == '{'        ? Extent{begin, EndOfFlow(begin)}
               : node.isSequence() && first != '-' ? std::optional<Extent>()
                                                   : Extent{begin, EndOfBlock(begin)};
    }

    std::size_t ColumnOf(std::size_t offset) const
    {
        const std::string_view before = std::string_view(m_Text).substr(0, offset);
        return offset - (before.rfind('\n') + 1); // of -1 as well
    }

private:
    std::size_t EndOfQuote(std::size_t begin) const
    {
        const std::string_view rest = std::string_view(m_Text).substr(begin);
        return begin + std::min(EndOfQuotes(rest), rest.size());
    }

    /// Returns the end of a word in brackets or behind a key, on one line.
    std::size_t EndOfPlain(std::size_t begin) const
    {
        std::size_t end = begin;
        while (end < m_Text.size() && m_Text[end] != '\n' && m_Text[end] != ',' &&
               m_Text[end] != ']' && m_Text[end] != '}' &&
               !(m_Text[end] == '#' && isBlank(m_Text[end - 1])))
        {
            ++end;
        }
        while (end > begin && isBlank(m_Text[end - 1]))
        {
            --end;
        }
        return end;
    }

    std::size_t EndOfFlow(std::size_t begin) const
    {
        int depth = 0;
        for (std::size_t i = begin; i < m_Text.size();)
        {
            const char c = m_Text[i];
            const char before = i == 0 ? ' ' : m_Text[i - 1];
            const bool isStart = isBlank(before) || IsIn({&before, 1}, {"[", "{", ",", ":"});
            if ((c == '"' || c == '\'') && isStart)
            {
                i = EndOfQuote(i);
                continue;
            }
            if (c == '#' && isBlank(before))
            {
                i = std::min(m_Text.find('\n', i), m_Text.size());
                continue;
            }
            depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
            ++i;
            if (depth == 0)
            {
                return i;
            }
        }
        return m_Text.size();
    }

    /// Returns the end of the last line, comments apart, of a list with dashes or of a map of one
    /// key a line.
    std::size_t EndOfBlock(std::size_t begin) const
    {
        const std::size_t column = ColumnOf(begin);
        const bool isList = m_Text[begin] == '-';
        std::size_t end = LineEnd(begin);
        for (std::size_t line = end; line < m_Text.size();)
        {
            const std::size_t start = line + 1;
            const std::size_t word = m_Text.find_first_not_of(" \r", start);
            if (word == std::string::npos)
            {
                break;
            }
            const bool isEmpty = m_Text[word] == '\n' || m_Text[word] == '#';
            const std::size_t indent = word - start;
            if (!isEmpty &&
                (indent < column || (isList && indent == column && m_Text[word] != '-')))
            {
                break;
            }
            line = LineEnd(start);
            end = isEmpty ? end : line;
        }
        while (end > begin && isBlank(m_Text[end - 1]))
        {
            --end;
        }
        return end;
    }

    std::size_t LineEnd(std::size_t at) const
    {
        return std::min(m_Text.find('\n', at), m_Text.size());
    }

    const std::string& m_Text;
};

/// A key with its list, as a line or more.
std::string ListText(const std::string& indent, const std::string& key,
                     const std::vector<std::string>& items)
{
    const std::string start = indent + key + ": ";
    return start + FlowList(items, start.size(), indent.size() + 2) + "\n";
}

std::string FeaturesText(const SceneFacts& facts)
{
    std::string text = facts.features().empty() ? "" : "features:\n";
    for (const std::string& feature : facts.features())
    {
        const DrawnFacts drawn = facts.Drawn(feature, std::nullopt);
        text += "  " + Quoted(feature) + ":\n" +
                ListText("    ", "drawn", facts.objects().Fix({}, drawn.drawn));
    }
    return text;
}

std::string ValuesText(const std::vector<VolumeParameterTrace>& values)
{
    std::string text = values.empty() ? "" : "values:\n  - at: camera\n";
    for (const VolumeParameterTrace& one : values)
    {
        text += "    " + one.component + "." + one.parameter + ": " + one.valueText() + "\n";
    }
    return text;
}

std::string DrawnTexturesText(const std::vector<ExplainedTexture>& textures)
{
    std::string text;
    std::set<std::string> known;
    for (const ExplainedTexture& texture : textures)
    {
        if (texture.isDrawn && known.insert(texture.name).second)
        {
            text += (text.empty() ? "textures:\n  " : "  ") + Quoted(texture.name) +
                    ": {size: " + texture.size + ", format: " + texture.format +
                    ", samples: " + std::to_string(texture.samples) + "}\n";
        }
    }
    return text;
}

} // namespace

std::string UpdateExpectations(const std::string& text, const std::string& file,
                               const std::vector<Expectation>& expectations)
{
    const ExtentFinder finder(text);
    AssetDiagnostics diagnostics(file);
    std::string result;
    std::size_t done = 0;
    for (const Expectation& one : expectations)
    {
        if (one.holds())
        {
            continue;
        }
        if (!one.isList && one.truth.empty())
        {
            diagnostics.Error(one.location, one.name + ": the frame has no texture of this name; "
                                                       "take the entry out");
            continue;
        }
        const std::optional<Extent> extent = finder.Find(one.value);
        if (!extent || extent->begin < done || one.value.location() < one.location)
        {
            diagnostics.Error(
                one.location,
                one.name +
                    ": limn cannot update it, because it is an alias (*); write the list out");
            continue;
        }
        const std::size_t column = finder.ColumnOf(extent->begin);
        const bool isBlock = text[extent->begin] == '-' && one.isList && !one.truth.empty();
        result += text.substr(done, extent->begin - done);
        result += isBlock      ? BlockList(one.truth, column)
                  : one.isList ? FlowList(one.truth, column, column + 1)
                               : one.truth.front();
        done = extent->end;
    }
    diagnostics.ThrowIfErrors();
    return result + text.substr(done);
}

std::string FullExpectations(SceneFacts& facts, const std::string& head)
{
    const Explanation& explanation = facts.explanation();
    const std::vector<std::string> leftOut =
        CompareLeftOut({}, explanation.frame.leftOut, ListKind::Exact).truth;
    return "# " + OneLine(head) + "\n" + FeaturesText(facts) +
           ValuesText(explanation.volumes.parameters) +
           ListText("", "order", facts.ExecutedPasses()) +
           DrawnTexturesText(explanation.frame.textures) + ListText("", "leftOut", leftOut);
}

} // namespace limn
