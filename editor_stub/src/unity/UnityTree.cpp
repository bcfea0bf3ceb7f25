#include "unity/UnityTree.h"

#include <charconv>

namespace limn
{

namespace
{

constexpr int k_DeepestLevel = 64;

void AppendUtf8(std::string& text, std::uint32_t code)
{
    if (code < 0x80)
    {
        text += static_cast<char>(code);
        return;
    }
    if (code < 0x800)
    {
        text += static_cast<char>(0xC0 | (code >> 6));
    }
    else
    {
        if (code < 0x10000)
        {
            text += static_cast<char>(0xE0 | (code >> 12));
        }
        else
        {
            text += static_cast<char>(0xF0 | (code >> 18));
            text += static_cast<char>(0x80 | ((code >> 12) & 0x3F));
        }
        text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    }
    text += static_cast<char>(0x80 | (code & 0x3F));
}

/// The letter behind a backslash in double quotes; \x, \u and \U come with digits.
char Unescaped(char letter)
{
    switch (letter)
    {
    case 'n':
        return '\n';
    case 't':
        return '\t';
    case 'r':
        return '\r';
    case '0':
        return '\0';
    case 'a':
        return '\a';
    case 'b':
        return '\b';
    case 'v':
        return '\v';
    case 'f':
        return '\f';
    case 'e':
        return '\x1B';
    default:
        return letter;
    }
}

std::string_view Trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos)
    {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

} // namespace

/// Reads a text from its beginning to its end, line by line.
class UnityTreeReader
{
public:
    UnityTreeReader(UnityTree& tree, std::string_view text, const std::string& file, int firstLine)
        : m_Tree(tree), m_Rest(text), m_File(file), m_Line(firstLine)
    {
    }

    void Read()
    {
        m_Tree.m_Nodes.push_back({{}, {}, k_None, k_None, m_Line, Kind::Map});
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
    using Kind = UnityTree::Kind;
    static constexpr std::uint32_t k_None = UnityTree::k_None;

    [[noreturn]] void Fail(const std::string& message) const
    {
        throw AssetError(m_File, {m_Line, m_Indent + 1}, message);
    }

    /// Goes to the next line that holds something. @param skipped  lines that are done with
    void NextLine(int skipped)
    {
        m_Line += skipped;
        for (;; ++m_Line)
        {
            if (m_Rest.empty())
            {
                m_HasLine = false;
                return;
            }
            const std::size_t end = m_Rest.find('\n');
            m_Text = m_Rest.substr(0, end);
            m_Rest.remove_prefix(end == std::string_view::npos ? m_Rest.size() : end + 1);
            const std::size_t first = m_Text.find_first_not_of(' ');
            if (first == std::string_view::npos)
            {
                continue;
            }
            m_Text = m_Text.substr(first);
            const std::size_t last = m_Text.find_last_not_of(" \t\r");
            if (last == std::string_view::npos || m_Text.front() == '#' || m_Text.front() == '%')
            {
                continue;
            }
            m_Text = m_Text.substr(0, last + 1);
            m_Indent = static_cast<int>(first);
            m_HasLine = true;
            return;
        }
    }

    std::uint32_t Add(std::uint32_t parent, std::uint32_t& last, std::string_view key)
    {
        const auto index = static_cast<std::uint32_t>(m_Tree.m_Nodes.size());
        m_Tree.m_Nodes.push_back({key, {}, k_None, k_None, m_Line, Kind::Scalar});
        (last == k_None ? m_Tree.m_Nodes[parent].firstChild : m_Tree.m_Nodes[last].next) = index;
        last = index;
        return index;
    }

    void ExpectLevel(int level) const
    {
        if (level > k_DeepestLevel)
        {
            Fail("lists and maps are nested deeper than " + std::to_string(k_DeepestLevel) +
                 " levels");
        }
    }

    bool isItem() const
    {
        return m_Text.front() == '-' && (m_Text.size() == 1 || m_Text[1] == ' ');
    }

    /// Reads `key: value` lines of one indentation.
    void ReadMap(std::uint32_t node, int indent, int level)
    {
        ExpectLevel(level);
        m_Tree.m_Nodes[node].kind = Kind::Map;
        std::uint32_t last = k_None;
        while (m_HasLine && m_Indent == indent && !isItem())
        {
            const std::string_view key = TakeKey();
            ReadValue(Add(node, last, key), indent, level, true);
        }
        if (m_HasLine && m_Indent > indent)
        {
            Fail("this line is indented more than the lines before it");
        }
    }

    /// Reads lines that begin with '-'.
    void ReadList(std::uint32_t node, int indent, int level)
    {
        ExpectLevel(level);
        m_Tree.m_Nodes[node].kind = Kind::List;
        std::uint32_t last = k_None;
        while (m_HasLine && m_Indent == indent && isItem())
        {
            const std::uint32_t item = Add(node, last, {});
            const std::size_t first = m_Text.find_first_not_of(' ', 1);
            if (first == std::string_view::npos)
            {
                m_Text = {};
                ReadValue(item, indent, level, false);
                continue;
            }
            m_Text = m_Text.substr(first);
            m_Indent += static_cast<int>(first);
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
    }

    /// Returns where the colon stands behind a key; npos if the line has none.
    std::size_t FindColon() const
    {
        if (m_Text.front() == '"' || m_Text.front() == '\'')
        {
            const std::size_t end = EndOfQuotes(m_Text);
            return end != std::string_view::npos && end < m_Text.size() && m_Text[end] == ':'
                       ? end
                       : std::string_view::npos;
        }
        if (m_Text.front() == '{' || m_Text.front() == '[')
        {
            return std::string_view::npos;
        }
        for (std::size_t at = m_Text.find(':'); at != std::string_view::npos;
             at = m_Text.find(':', at + 1))
        {
            if (at + 1 == m_Text.size() || m_Text[at + 1] == ' ')
            {
                return at;
            }
        }
        return std::string_view::npos;
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
        std::string_view key = m_Text.substr(0, colon);
        m_Text = Trimmed(m_Text.substr(colon + 1));
        if (key.front() == '"' || key.front() == '\'')
        {
            std::string text;
            AppendQuoted(key.substr(1, key.size() - 2), key.front(), text);
            return Keep(std::move(text));
        }
        return Trimmed(key);
    }

    /// Reads what stands behind a key or a '-': the rest of the line, or the lines below.
    void ReadValue(std::uint32_t node, int indent, int level, bool isEntry)
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
            return;
        }
        const char first = m_Text.front();
        if (first == '{' || first == '[')
        {
            ReadFlow(node, level);
            NextLine(1);
        }
        else if (first == '"' || first == '\'')
        {
            ReadQuoted(node);
        }
        else if (first == '|' || first == '>')
        {
            ReadBlock(node, indent);
        }
        else
        {
            ReadPlain(node, indent);
        }
    }

    void ReadPlain(std::uint32_t node, int indent)
    {
        const std::string_view text = m_Text;
        NextLine(1);
        if (!m_HasLine || m_Indent <= indent)
        {
            m_Tree.m_Nodes[node].text = text;
            return;
        }
        std::string whole(text); // a long one goes on in lines that are indented deeper
        while (m_HasLine && m_Indent > indent)
        {
            if (HasKey())
            {
                Fail("this line is indented more than the lines before it");
            }
            (whole += ' ') += m_Text;
            NextLine(1);
        }
        m_Tree.m_Nodes[node].text = Keep(std::move(whole));
    }

    /// Reads the lines of `|` and `>`, which Unity writes for scripts and shaders in assets.
    void ReadBlock(std::uint32_t node, int indent)
    {
        const char between = m_Text.front() == '|' ? '\n' : ' ';
        std::string whole;
        for (NextLine(1); m_HasLine && m_Indent > indent; NextLine(1))
        {
            whole += m_Text;
            whole += between;
        }
        m_Tree.m_Nodes[node].text = Keep(std::move(whole));
    }

    /// Returns the place behind the closing quote; npos where the text does not hold it.
    static std::size_t EndOfQuotes(std::string_view text)
    {
        const char quote = text.front();
        for (std::size_t at = 1; at < text.size(); ++at)
        {
            if (quote == '"' && text[at] == '\\')
            {
                ++at;
            }
            else if (text[at] == quote)
            {
                if (quote == '"' || at + 1 == text.size() || text[at + 1] != quote)
                {
                    return at + 1;
                }
                ++at;
            }
        }
        return std::string_view::npos;
    }

    /// Takes more lines until the quotes or brackets that the line begins with end.
    /// @param end  returns where they do
    template <typename End>
    std::string_view TakeLines(const End& end, const char* what)
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
            const std::size_t lineEnd = m_Rest.find('\n');
            if (m_Rest.empty())
            {
                m_Line = first;
                Fail(std::string(what) + " do not end");
            }
            const std::string_view line = Trimmed(m_Rest.substr(0, lineEnd));
            m_Rest.remove_prefix(lineEnd == std::string_view::npos ? m_Rest.size() : lineEnd + 1);
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

    void ReadQuoted(std::uint32_t node)
    {
        const std::string_view text = TakeLines(EndOfQuotes, "the quotes");
        const std::string_view inner = text.substr(1, text.size() - 2);
        if (inner.find_first_of("\\'") == std::string_view::npos)
        {
            m_Tree.m_Nodes[node].text = inner;
        }
        else
        {
            std::string whole;
            AppendQuoted(inner, text.front(), whole);
            m_Tree.m_Nodes[node].text = Keep(std::move(whole));
        }
        NextLine(1);
    }

    static void AppendQuoted(std::string_view inner, char quote, std::string& text)
    {
        for (std::size_t i = 0; i < inner.size(); ++i)
        {
            if (quote == '\'')
            {
                i += inner[i] == '\'' ? 1 : 0;
                text += i < inner.size() ? inner[i] : '\'';
                continue;
            }
            if (inner[i] != '\\' || i + 1 == inner.size())
            {
                text += inner[i];
                continue;
            }
            const char letter = inner[++i];
            const std::size_t digits = letter == 'x'   ? 2
                                       : letter == 'u' ? 4
                                       : letter == 'U' ? 8
                                                       : 0;
            std::uint32_t code = 0;
            const std::string_view number = inner.substr(i + 1, digits);
            const auto [end, error] =
                std::from_chars(number.data(), number.data() + number.size(), code, 16);
            if (digits == 0 || error != std::errc{} || end != number.data() + digits)
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
    }

    static std::size_t EndOfBrackets(std::string_view text)
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

    void ReadFlow(std::uint32_t node, int level)
    {
        std::string_view text = TakeLines(EndOfBrackets, "the brackets");
        ReadBrackets(text, node, level + 1);
    }

    static void SkipBlanks(std::string_view& text)
    {
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        text.remove_prefix(first == std::string_view::npos ? text.size() : first);
    }

    /// Reads `{...}` or `[...]` off the front of a text.
    void ReadBrackets(std::string_view& text, std::uint32_t node, int level)
    {
        ExpectLevel(level);
        const bool isMap = text.front() == '{';
        const char close = isMap ? '}' : ']';
        m_Tree.m_Nodes[node].kind = isMap ? Kind::Map : Kind::List;
        text.remove_prefix(1);
        std::uint32_t last = k_None;
        for (SkipBlanks(text); !text.empty() && text.front() != close; SkipBlanks(text))
        {
            std::string_view key;
            if (isMap)
            {
                key = TakeFlowScalar(text, ":");
                if (text.empty() || text.front() != ':')
                {
                    Fail("'key: value' is expected between the braces");
                }
                text.remove_prefix(1);
                SkipBlanks(text);
            }
            const std::uint32_t child = Add(node, last, key);
            if (!text.empty() && (text.front() == '{' || text.front() == '['))
            {
                ReadBrackets(text, child, level + 1);
            }
            else
            {
                m_Tree.m_Nodes[child].text = TakeFlowScalar(text, "");
            }
            SkipBlanks(text);
            if (!text.empty() && text.front() == ',')
            {
                text.remove_prefix(1);
            }
            else if (text.empty() || text.front() != close)
            {
                Fail("',' or '" + std::string(1, close) + "' is expected between the brackets");
            }
        }
        text.remove_prefix(text.empty() ? 0 : 1);
    }

    /// Takes a text that ends at a comma, a bracket or one of `ends` with a blank behind it.
    std::string_view TakeFlowScalar(std::string_view& text, std::string_view ends)
    {
        if (!text.empty() && (text.front() == '"' || text.front() == '\''))
        {
            const std::size_t length = EndOfQuotes(text);
            if (length == std::string_view::npos)
            {
                Fail("the quotes do not end");
            }
            std::string whole;
            AppendQuoted(text.substr(1, length - 2), text.front(), whole);
            text.remove_prefix(length);
            SkipBlanks(text);
            return Keep(std::move(whole));
        }
        std::size_t end = 0;
        while (end < text.size() && text[end] != ',' && text[end] != '}' && text[end] != ']')
        {
            if (ends.find(text[end]) != std::string_view::npos &&
                (end + 1 == text.size() || text[end + 1] == ' ' || text[end + 1] == '\n'))
            {
                break;
            }
            ++end;
        }
        const std::string_view found = Trimmed(text.substr(0, end));
        text.remove_prefix(end);
        return found;
    }

    std::string_view Keep(std::string text) { return m_Tree.m_Texts.emplace_back(std::move(text)); }

    UnityTree& m_Tree;
    std::string_view m_Rest;
    const std::string& m_File;
    std::string_view m_Text; ///< of the line, without its indentation
    int m_Line;
    int m_Indent = 0;
    bool m_HasLine = false;
};

UnityTree::UnityTree(std::string_view text, const std::string& file, int firstLine)
{
    m_Nodes.reserve(text.size() / 28 + 1);
    UnityTreeReader(*this, text, file, firstLine).Read();
}

std::string_view UnityNode::text() const
{
    return m_Tree != nullptr ? m_Tree->m_Nodes[m_Index].text : std::string_view();
}

std::string_view UnityNode::key() const
{
    return m_Tree != nullptr ? m_Tree->m_Nodes[m_Index].key : std::string_view();
}

int UnityNode::line() const
{
    return m_Tree != nullptr ? m_Tree->m_Nodes[m_Index].line : 0;
}

bool UnityNode::isList() const
{
    return m_Tree != nullptr && m_Tree->m_Nodes[m_Index].kind == UnityTree::Kind::List;
}

bool UnityNode::isMap() const
{
    return m_Tree != nullptr && m_Tree->m_Nodes[m_Index].kind == UnityTree::Kind::Map;
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

UnityNode::Iterator UnityNode::begin() const
{
    return {m_Tree, m_Tree != nullptr ? m_Tree->m_Nodes[m_Index].firstChild : UnityTree::k_None};
}

UnityNode::Iterator UnityNode::end() const
{
    return {m_Tree, UnityTree::k_None};
}

UnityNode::Iterator& UnityNode::Iterator::operator++()
{
    m_Index = m_Tree->m_Nodes[m_Index].next;
    return *this;
}

} // namespace limn
