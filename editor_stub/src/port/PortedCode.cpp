#include "port/PortedCode.h"

#include <algorithm>

namespace limn
{

namespace
{

std::vector<std::string_view> LinesOf(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty())
    {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        while (!lines.back().empty() && (lines.back().back() == '\r' ||
                                         lines.back().back() == ' ' || lines.back().back() == '\t'))
        {
            lines.back().remove_suffix(1);
        }
    }
    while (!lines.empty() && lines.front().empty())
    {
        lines.erase(lines.begin());
    }
    while (!lines.empty() && lines.back().empty())
    {
        lines.pop_back();
    }
    return lines;
}

/// Spaces instead of tabs; no byte that a compiler warns of in a comment.
std::string Harmless(std::string_view line)
{
    std::string text;
    for (const char c : line)
    {
        const auto byte = static_cast<unsigned char>(c);
        text += c == '\t' ? "    " : byte < 0x20 || byte == 0x7f ? "?" : std::string(1, c);
    }
    for (const std::string_view mark :
         {"\xE2\x80\xAA", "\xE2\x80\xAB", "\xE2\x80\xAC", "\xE2\x80\xAD", "\xE2\x80\xAE",
          "\xE2\x81\xA6", "\xE2\x81\xA7", "\xE2\x81\xA8", "\xE2\x81\xA9"})
    {
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark))
        {
            text.replace(at, mark.size(), "?"); // turns the direction of what follows
        }
    }
    const bool isContinued = text.ends_with("\\") || text.ends_with("?\?/");
    return isContinued ? text + " //" : text;
}

} // namespace

void PortedCode::Line(std::string_view line)
{
    if (!line.empty())
    {
        text.append(m_Indent * 4, ' ').append(line);
    }
    text += '\n';
}

void PortedCode::Open(std::string_view line)
{
    if (!line.empty())
    {
        Line(line);
    }
    Line("{");
    ++m_Indent;
}

void PortedCode::Close(std::string_view end)
{
    --m_Indent;
    Line(end);
}

void PortedCode::Comment(std::string_view csharp)
{
    std::vector<std::string> lines;
    for (const std::string_view line : LinesOf(csharp))
    {
        lines.push_back(Harmless(line));
    }
    std::size_t shared = std::string::npos;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        const std::size_t indent = lines[i].find_first_not_of(' ');
        const bool isFirst = i == 0 && indent == 0; // cut out of its line
        shared = indent == std::string::npos || isFirst ? shared : std::min(shared, indent);
    }
    for (const std::string& line : lines)
    {
        const std::size_t cut = std::min({shared, line.find_first_not_of(' '), line.size()});
        Line(line.empty() ? "//" : "// " + line.substr(cut));
    }
}

void PortedCode::Todo(const std::string& why, const std::string& place, std::string_view csharp)
{
    Line("// TODO " + place + ": " + why);
    Comment(csharp);
}

std::string_view BodyText(const CSharpFile& file, const CSharpMethod& method)
{
    if (method.isExpression)
    {
        return TextOf(file, method.body);
    }
    if (method.body.data() == nullptr) // abstract
    {
        return {};
    }
    const std::size_t begin = method.body.data()[-1].offset + 1;
    const std::size_t end = method.body.data()[method.body.size()].offset;
    return std::string_view(file.text).substr(begin, end - begin);
}

std::vector<PortedAssignment> AssignmentsOf(CSharpWords body)
{
    std::vector<PortedAssignment> assignments;
    std::size_t begin = 0;
    std::size_t equals = 0;
    for (std::size_t i = 0; i < body.size();)
    {
        if (body[i].Is("=") && equals == 0)
        {
            equals = i;
        }
        const bool isBlock = body[i].Is("{") && equals == 0;
        if (body[i].Is(";") || isBlock)
        {
            if (equals > begin)
            {
                assignments.push_back({body.subspan(begin, equals - begin),
                                       body.subspan(equals + 1, i - equals - 1)});
            }
            equals = 0;
        }
        const bool ends = body[i].Is(";") || isBlock;
        i += body[i].match > 0 ? static_cast<std::size_t>(body[i].match) + 1 : 1;
        begin = ends ? i : begin;
    }
    return assignments;
}

} // namespace limn
