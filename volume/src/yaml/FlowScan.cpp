#include "yaml/Text.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::string_view k_Space = " \t\r\n";

/// Walks over a text and tells brackets that are YAML's from those inside text and comments.
class FlowScanner
{
public:
    FlowScanner(std::string_view text, std::size_t maxBytes) : m_Text(text), m_MaxBytes(maxBytes) {}

    std::optional<std::size_t> Find()
    {
        while (m_At < m_Text.size())
        {
            if (m_Depth > 0 && m_At - m_Begin >= m_MaxBytes)
            {
                return m_Begin;
            }
            Step();
        }
        return std::nullopt;
    }

private:
    void Step()
    {
        const char c = m_Text[m_At];
        if (c == '\n')
        {
            m_CanBegin = true;
            ++m_At;
        }
        else if (k_Space.find(c) != std::string_view::npos)
        {
            ++m_At;
        }
        else if (c == '#' && (m_At == 0 || IsSpace(m_At - 1)))
        {
            m_At = std::min(m_Text.find('\n', m_At), m_Text.size());
        }
        else if (m_CanBegin && (c == '"' || c == '\''))
        {
            SkipQuoted();
        }
        else if (m_CanBegin && (c == '&' || c == '!'))
        {
            // A value still begins behind an anchor or a tag.
            m_At = std::min(m_Text.find_first_of(k_Space, m_At), m_Text.size());
        }
        else
        {
            StepOver(c);
        }
    }

    void StepOver(char c)
    {
        const bool isOpening = c == '[' || c == '{';
        const bool isClosing = c == ']' || c == '}';
        if (isOpening && (m_CanBegin || m_Depth > 0))
        {
            m_Begin = m_Depth == 0 ? m_At : m_Begin;
            ++m_Depth;
        }
        else if (isClosing && m_Depth > 0)
        {
            --m_Depth;
        }
        const bool isIndicator = c == ':' || c == '-' || c == '?';
        m_CanBegin = m_Depth > 0 ? isOpening || c == ',' || c == ':'
                                 : isIndicator && IsSpace(m_At + 1) && (c == ':' || m_CanBegin);
        ++m_At;
    }

    void SkipQuoted()
    {
        m_At += std::min(EndOfQuotes(m_Text.substr(m_At)), m_Text.size() - m_At);
        m_CanBegin = false;
    }

    bool IsSpace(std::size_t at) const
    {
        return at >= m_Text.size() || k_Space.find(m_Text[at]) != std::string_view::npos;
    }

    std::string_view m_Text;
    std::size_t m_MaxBytes;
    std::size_t m_At = 0;
    std::size_t m_Begin = 0; ///< of the outermost open bracket
    std::size_t m_Depth = 0;
    bool m_CanBegin = true; ///< whether a value may begin here
};

} // namespace

std::optional<std::size_t> FindLongFlow(std::string_view text, std::size_t maxBytes)
{
    return text.size() > maxBytes ? FlowScanner(text, maxBytes).Find() : std::nullopt;
}

} // namespace limn
