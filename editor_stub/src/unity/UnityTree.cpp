#include "unity/UnityTree.h"

#include "console/Texts.h"

#include <algorithm>
#include <limn/volume/YamlNode.h>

namespace limn
{

namespace
{

constexpr int k_DeepestLevel = 64;
constexpr std::string_view k_Quotes = "\"'";
constexpr std::string_view k_Brackets = "{[";

bool BeginsWithOneOf(std::string_view text, std::string_view letters)
{
    return !text.empty() && letters.find(text.front()) != std::string_view::npos;
}

void SkipBlanks(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

void AppendUtf8(std::string& text, std::uint32_t code)
{
    constexpr std::uint32_t k_FirstBytes[] = {0, 0xC0, 0xE0, 0xF0};
    const int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    text += static_cast<char>(k_FirstBytes[more] | (code >> (6 * more)));
    for (int i = more - 1; i >= 0; --i)
    {
        text += static_cast<char>(0x80 | ((code >> (6 * i)) & 0x3F));
    }
}

/// The letter behind a backslash in double quotes; \x, \u and \U come with digits.
char Unescaped(char letter)
{
    constexpr std::string_view k_Letters = "ntr0abvfe";
    constexpr std::string_view k_Meant("\n\t\r\0\a\b\v\f\x1B", k_Letters.size());
    const std::size_t at = k_Letters.find(letter);
    return at == std::string_view::npos ? letter : k_Meant[at];
}

std::string WithoutEscapes(std::string_view inner)
{
    std::string text;
    for (std::size_t i = 0; i < inner.size(); ++i)
    {
        if (inner[i] != '\\' || i + 1 == inner.size())
        {
            text += inner[i];
            continue;
        }
        const char letter = inner[++i];
        const std::size_t digits = letter == 'x' ? 2 : letter == 'u' ? 4 : letter == 'U' ? 8 : 0;
        std::uint32_t code = 0;
        const std::string_view number = inner.substr(i + 1, digits);
        const auto [end, error] =
            std::from_chars(number.data(), number.data() + number.size(), code, 16);
        if (error != std::errc{} || end != number.data() + digits)
        {
            text += Unescaped(letter);
            continue;
        }
        i += digits;
        const bool isHigh = code >= 0xD800 && code < 0xDC00; // half of a UTF-16 pair
        std::uint32_t low = 0;
        if (isHigh && inner.substr(i + 1, 2) == "\\u" && inner.size() >= i + 7)
        {
            std::from_chars(inner.data() + i + 3, inner.data() + i + 7, low, 16);
            code = 0x10000 + ((code - 0xD800) << 10) + ((low - 0xDC00) & 0x3FF);
            i += 6;
        }
        AppendUtf8(text, code);
    }
    return text;
}

/// Returns the place of a colon that stands before a blank or the end; npos if there is none.
std::size_t FindColonIn(std::string_view text)
{
    std::size_t at = text.find(':');
    while (at < text.size() && at + 1 < text.size() && text[at + 1] != ' ' && text[at + 1] != '\n')
    {
        at = text.find(':', at + 1);
    }
    return at;
}

/// Returns the place behind the bracket that closes the first one; npos where
/// the text does not hold it.
std::size_t EndOfBrackets(std::string_view text)
{
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at)
    {
        const char letter = text[at];
        if ((letter == '"' || letter == '\'') &&
            (at == 0 || text[at - 1] == ' ' || text[at - 1] == '[' || text[at - 1] == '{'))
        {
            const std::size_t length = EndOfQuotes(text.substr(at));
            if (length == std::string_view::npos)
            {
                return length;
            }
            at += length - 1;
            continue;
        }
        depth += letter == '{' || letter == '[' ? 1 : 0;
        depth -= letter == '}' || letter == ']' ? 1 : 0;
        if (depth == 0)
        {
            return at + 1;
        }
    }
    return std::string_view::npos;
}

} // namespace

/// Reads a text from its beginning to its end, line by line.
class UnityTreeReader
{
public:
    UnityTreeReader(std::vector<UnityValue>& values, std::deque<std::string>& texts,
                    std::string_view text, const std::string& file, int firstLine)
        : m_Values(values), m_Texts(texts), m_Rest(text), m_File(file), m_Line(firstLine)
    {
    }

    void Read()
    {
        Add({});
        m_Values.front().kind = Kind::Map;
        NextLine(0);
        if (m_HasLine)
        {
            ReadMap(0, m_Indent, 0);
        }
        if (m_HasLine)
        {
            Fail("this line is indented less than the lines before it");
        }
    }

private:
    using Kind = UnityValue::Kind;

    [[noreturn]] void Fail(const std::string& message) const
    {
        throw AssetError(m_File, {m_Line, m_Indent + 1}, message);
    }

    /// Takes a line off the text, without its end.
    std::string_view TakeLine()
    {
        const std::string_view line = m_Rest.substr(0, m_Rest.find('\n'));
        m_Rest.remove_prefix(std::min(line.size() + 1, m_Rest.size()));
        return line;
    }

    /// Goes to the next line that holds something. @param skipped  lines that are done with
    void NextLine(int skipped)
    {
        m_Line += skipped;
        for (m_HasLine = false; !m_HasLine && !m_Rest.empty(); m_Line += m_HasLine ? 0 : 1)
        {
            const std::string_view line = TakeLine();
            // A tab does not indent.
            const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
            m_Text = line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
            m_Indent = static_cast<int>(first);
            m_HasLine = !m_Text.empty() && !BeginsWithOneOf(m_Text, "#%");
        }
    }

    std::size_t Add(std::string_view key)
    {
        m_Values.push_back({key, {}, 1, m_Line, Kind::Scalar});
        return m_Values.size() - 1;
    }
    /// Begins a map or a list.
    void Begin(std::size_t node, Kind kind, int level)
    {
        if (level > k_DeepestLevel)
        {
            Fail("lists and maps are nested deeper than " + std::to_string(k_DeepestLevel) +
                 " levels");
        }
        m_Values[node].kind = kind;
    }
    void End(std::size_t node)
    {
        m_Values[node].size = static_cast<std::uint32_t>(m_Values.size() - node);
    }

    bool isItem() const { return m_Text == "-" || m_Text.starts_with("- "); }

    /// Reads `key: value` lines of one indentation.
    void ReadMap(std::size_t node, int indent, int level)
    {
        Begin(node, Kind::Map, level);
        while (m_HasLine && m_Indent == indent && !isItem())
        {
            ReadValue(Add(TakeKey()), indent, level, true);
        }
        if (m_HasLine && m_Indent > indent)
        {
            Fail("this line is indented more than the lines before it");
        }
        End(node);
    }

    /// Reads lines that begin with '-'.
    void ReadList(std::size_t node, int indent, int level)
    {
        Begin(node, Kind::List, level);
        while (m_HasLine && m_Indent == indent && isItem())
        {
            const std::size_t item = Add({});
            const std::string_view value = Trim(m_Text.substr(1));
            m_Indent += static_cast<int>(value.data() - m_Text.data());
            m_Text = value;
            if (isItem())
            {
                ReadList(item, m_Indent, level + 1);
            }
            else if (HasKey())
            {
                ReadMap(item, m_Indent, level + 1);
            }
            else
            {
                ReadValue(item, indent, level, false);
            }
        }
        End(node);
    }

    /// Returns where the colon stands behind a key; npos if the line has none.
    std::size_t FindColon() const
    {
        if (BeginsWithOneOf(m_Text, k_Quotes))
        {
            const std::size_t end = EndOfQuotes(m_Text);
            return end < m_Text.size() && m_Text[end] == ':' ? end : std::string_view::npos;
        }
        return BeginsWithOneOf(m_Text, k_Brackets) ? std::string_view::npos : FindColonIn(m_Text);
    }
    bool HasKey() const { return FindColon() != std::string_view::npos; }

    /// Takes the key off the line; what is left is its value.
    std::string_view TakeKey()
    {
        const std::size_t colon = FindColon();
        if (colon == std::string_view::npos)
        {
            Fail("'key: value' is expected here, as Unity writes it");
        }
        const std::string_view key = m_Text.substr(0, colon);
        m_Text = Trim(m_Text.substr(colon + 1));
        return BeginsWithOneOf(key, k_Quotes) ? Unquoted(key) : Trim(key);
    }

    /// Reads what stands behind a key or a '-': the rest of the line, or the lines below.
    void ReadValue(std::size_t node, int indent, int level, bool isEntry)
    {
        if (m_Text.empty())
        {
            NextLine(1);
            if (m_HasLine && m_Indent >= indent && isItem() && (isEntry || m_Indent > indent))
            {
                ReadList(node, m_Indent, level + 1);
            }
            else if (m_HasLine && m_Indent > indent)
            {
                ReadMap(node, m_Indent, level + 1);
            }
        }
        else if (BeginsWithOneOf(m_Text, k_Brackets))
        {
            std::string_view text = TakeLines(EndOfBrackets, "the brackets");
            ReadBrackets(text, node, level + 1);
            NextLine(1);
        }
        else if (BeginsWithOneOf(m_Text, k_Quotes))
        {
            m_Values[node].text = Unquoted(TakeLines(EndOfQuotes, "the quotes"));
            NextLine(1);
        }
        else if (BeginsWithOneOf(m_Text, "|>"))
        {
            ReadBlock(node, indent);
        }
        else
        {
            ReadPlain(node, indent);
        }
    }

    void ReadPlain(std::size_t node, int indent)
    {
        const std::string_view text = m_Text;
        NextLine(1);
        if (!m_HasLine || m_Indent <= indent)
        {
            m_Values[node].text = text;
            return;
        }
        std::string whole(text); // a long one goes on in lines that are indented deeper
        for (; m_HasLine && m_Indent > indent; NextLine(1))
        {
            if (HasKey())
            {
                Fail("this line is indented more than the lines before it");
            }
            (whole += ' ') += m_Text;
        }
        m_Values[node].text = Keep(std::move(whole));
    }

    /// Reads the lines of `|` and `>`, which Unity writes for scripts and shaders in assets.
    void ReadBlock(std::size_t node, int indent)
    {
        const char between = m_Text.front() == '|' ? '\n' : ' ';
        std::string whole;
        for (NextLine(1); m_HasLine && m_Indent > indent; NextLine(1))
        {
            (whole += m_Text) += between;
        }
        m_Values[node].text = Keep(std::move(whole));
    }

    /// Takes more lines until the quotes or brackets that the line begins with end.
    /// @param end  returns where they do
    template <typename EndOf>
    std::string_view TakeLines(const EndOf& end, const char* what)
    {
        std::size_t found = end(m_Text);
        if (found != std::string_view::npos)
        {
            return m_Text.substr(0, found);
        }
        const int first = m_Line;
        std::string whole(m_Text);
        while (found == std::string_view::npos)
        {
            if (m_Rest.empty())
            {
                m_Line = first;
                Fail(std::string(what) + " do not end");
            }
            const std::string_view line = Trim(TakeLine());
            ++m_Line;
            if (whole.ends_with('\\') && !whole.ends_with("\\\\"))
            {
                whole.pop_back(); // an escaped line break is none
            }
            else if (line.empty())
            {
                whole += '\n';
            }
            else if (!whole.ends_with('\n'))
            {
                whole += ' ';
            }
            whole += line;
            // Only a line with one of these can end it.
            if (line.find_first_of("\"'}]") != std::string_view::npos)
            {
                found = end(whole);
            }
        }
        m_Text = {};
        return Keep(std::move(whole)).substr(0, found);
    }

    /// Returns what a text in quotes stands for.
    std::string_view Unquoted(std::string_view quoted)
    {
        const bool isDouble = quoted.front() == '"';
        const std::string_view inner = quoted.substr(1, quoted.size() - 2);
        if (inner.find(isDouble ? '\\' : '\'') == std::string_view::npos)
        {
            return inner;
        }
        return Keep(isDouble ? WithoutEscapes(inner) : Replaced(std::string(inner), "''", "'"));
    }

    /// Reads `{...}` or `[...]` off the front of a text.
    void ReadBrackets(std::string_view& text, std::size_t node, int level)
    {
        const bool isMap = text.front() == '{';
        const char close = isMap ? '}' : ']';
        Begin(node, isMap ? Kind::Map : Kind::List, level);
        text.remove_prefix(1);
        for (SkipBlanks(text); !text.empty() && text.front() != close; SkipBlanks(text))
        {
            std::string_view key;
            if (isMap)
            {
                key = TakeFlowScalar(text, true);
                if (!text.starts_with(':'))
                {
                    Fail("'key: value' is expected between the braces");
                }
                text.remove_prefix(1);
                SkipBlanks(text);
            }
            const std::size_t child = Add(key);
            if (BeginsWithOneOf(text, k_Brackets))
            {
                ReadBrackets(text, child, level + 1);
            }
            else
            {
                m_Values[child].text = TakeFlowScalar(text, false);
            }
            SkipBlanks(text);
            if (text.starts_with(','))
            {
                text.remove_prefix(1);
            }
            else if (!text.starts_with(close))
            {
                Fail("',' or '" + std::string(1, close) + "' is expected between the brackets");
            }
        }
        text.remove_prefix(text.empty() ? 0 : 1);
        End(node);
    }

    /// Takes a text that ends at a comma, a bracket or, if it is a key, at its colon.
    std::string_view TakeFlowScalar(std::string_view& text, bool isKey)
    {
        if (BeginsWithOneOf(text, k_Quotes))
        {
            const std::size_t length = EndOfQuotes(text);
            if (length == std::string_view::npos)
            {
                Fail("the quotes do not end");
            }
            const std::string_view found = Unquoted(text.substr(0, length));
            text.remove_prefix(length);
            SkipBlanks(text);
            return found;
        }
        const std::size_t end = std::min({text.find_first_of(",}]"), text.size(),
                                          isKey ? FindColonIn(text) : std::string_view::npos});
        const std::string_view found = Trim(text.substr(0, end));
        text.remove_prefix(end);
        return found;
    }

    std::string_view Keep(std::string text) { return m_Texts.emplace_back(std::move(text)); }

    std::vector<UnityValue>& m_Values;
    std::deque<std::string>& m_Texts;
    std::string_view m_Rest;
    const std::string& m_File;
    std::string_view m_Text; ///< of the line, without its indentation
    int m_Line;
    int m_Indent = 0;
    bool m_HasLine = false;
};

UnityTree::UnityTree(std::string_view text, const std::string& file, int firstLine)
{
    m_Values.reserve(text.size() / 28 + 1);
    UnityTreeReader(m_Values, m_Texts, text, file, firstLine).Read();
}

UnityNode UnityNode::At(std::size_t index) const
{
    for (const UnityNode child : *this)
    {
        if (index-- == 0)
        {
            return child;
        }
    }
    return {};
}

UnityNode UnityNode::operator[](std::string_view key) const
{
    UnityNode found;
    if (isMap())
    {
        for (const UnityNode child : *this)
        {
            found = child.key() == key ? child : found;
        }
    }
    return found;
}

} // namespace limn
