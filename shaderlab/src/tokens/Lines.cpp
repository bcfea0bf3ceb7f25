#include "tokens/Lines.h"

#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

bool HlslLines::Next(std::string& line, int& number)
{
    line.clear();
    number = m_Line;
    const bool any = m_Position < m_Text.size();
    while (m_Position < m_Text.size())
    {
        if (m_Text[m_Position] == '\n')
        {
            ++m_Position;
            ++m_Line;
            m_InString = false;
            if (!GoesOn(line))
            {
                m_InLineComment = false;
                return true;
            }
        }
        else if (m_InComment || m_InLineComment)
        {
            SkipComment();
        }
        else
        {
            TakeCode(line);
        }
    }
    return any;
}

bool HlslLines::GoesOn(std::string& line) const
{
    if (m_InComment)
    {
        return Trim(line).starts_with("#");
    }
    const std::string_view written = m_Text.substr(0, m_Position - 1);
    const std::size_t last = written.find_last_not_of(" \t\r\f\v");
    if (last == written.npos || written[last] != '\\')
    {
        return false;
    }
    if (!m_InLineComment)
    {
        line.resize(line.rfind('\\'));
        line += ' ';
    }
    return true;
}

void HlslLines::SkipComment()
{
    const std::string_view rest = m_Text.substr(m_Position);
    const std::size_t lineSize = std::min(rest.find('\n'), rest.size());
    const std::size_t end = m_InComment ? rest.substr(0, lineSize).find("*/") : rest.npos;
    m_InComment = m_InComment && end == rest.npos;
    m_Position += end == rest.npos ? lineSize : end + 2;
}

void HlslLines::TakeCode(std::string& line)
{
    const std::string_view rest = m_Text.substr(m_Position);
    const std::size_t size = std::min(rest.find_first_of("\"/\n"), rest.size());
    line += rest.substr(0, size);
    m_Position += size;
    const std::string_view mark = rest.substr(size, 2);
    if (mark.empty() || mark[0] == '\n')
    {
        return;
    }
    m_InComment = !m_InString && mark == "/*";
    m_InLineComment = !m_InString && mark == "//";
    if (m_InComment || m_InLineComment)
    {
        line += ' ';
        m_Position += mark.size();
        return;
    }
    m_InString = m_InString != (mark[0] == '"');
    line += mark[0];
    ++m_Position;
}

std::string SwapMarks(std::string name)
{
    constexpr std::string_view k_Marks = "\"\n\r";
    constexpr std::string_view k_Others = "\x01\x02\x03";
    for (char& c : name)
    {
        const std::size_t mark = k_Marks.find(c);
        const std::size_t other = k_Others.find(c);
        c = mark != k_Marks.npos ? k_Others[mark] : other != k_Others.npos ? k_Marks[other] : c;
    }
    return name;
}

} // namespace limn
