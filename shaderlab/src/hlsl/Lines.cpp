#include "hlsl/Lines.h"

#include "text/Text.h"

#include <algorithm>

namespace limn
{

bool HlslLines::Next(std::string& line, int& number)
{
    line.clear();
    number = m_Line;
    bool any = false;
    for (; m_Position < m_Text.size(); ++m_Position)
    {
        any = true;
        const std::string_view rest = m_Text.substr(m_Position);
        if (rest[0] != '\n')
        {
            Take(rest, line);
            continue;
        }
        ++m_Line;
        m_InString = false;
        const std::size_t size = line.find_last_not_of(" \t\r\f\v");
        if (m_InComment || size == line.npos || line[size] != '\\')
        {
            ++m_Position;
            return true;
        }
        line.resize(size);
        line += ' ';
    }
    return any;
}

void HlslLines::Take(std::string_view rest, std::string& line)
{
    if (m_InComment)
    {
        m_InComment = rest.substr(0, 2) != "*/";
        m_Position += m_InComment ? 0 : 1;
    }
    else if (!m_InString && rest.substr(0, 2) == "/*")
    {
        m_InComment = true;
        ++m_Position;
        line += ' ';
    }
    else if (!m_InString && rest.substr(0, 2) == "//")
    {
        m_Position += std::min(rest.find('\n'), rest.size()) - 1;
    }
    else
    {
        m_InString = m_InString != (rest[0] == '"');
        line += rest[0];
    }
}

} // namespace limn
