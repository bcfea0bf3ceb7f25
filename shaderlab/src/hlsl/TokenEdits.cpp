#include "hlsl/TokenEdits.h"

namespace limn
{

std::string& TokenEdits::Spelling(std::size_t index)
{
    if (m_Edit[index] == 0)
    {
        m_Spelling.emplace_back(Text(index));
        m_Edit[index] = static_cast<std::uint32_t>(m_Spelling.size());
    }
    return m_Spelling[m_Edit[index] - 1];
}

std::string_view TokenEdits::Now(std::size_t index) const
{
    return m_Edit[index] == 0 ? Text(index) : m_Spelling[m_Edit[index] - 1];
}

std::string TokenEdits::Spelled(std::size_t first, std::size_t end) const
{
    std::string result;
    for (; first < end; ++first)
    {
        result.append(Now(first)).append(" ");
    }
    return result;
}

void TokenEdits::Erase(std::size_t first, std::size_t end)
{
    for (; first < end; ++first)
    {
        Spelling(first).clear();
    }
}

std::string TokenEdits::Assemble() const
{
    const std::string_view source = m_Tokens.source();
    std::string result;
    result.reserve(source.size());
    std::size_t position = 0;
    for (std::size_t i = 0; i < size(); ++i)
    {
        const std::string_view text = Text(i);
        const std::size_t begin = m_Tokens.all()[i].Begin(source);
        result.append(source.substr(position, begin - position));
        position = begin + text.size();
        result.append(Now(i));
    }
    return result.append(source.substr(position));
}

std::string TokenEdits::AssembleByToken(const std::vector<bool>& isLeftOut) const
{
    constexpr std::size_t k_FewLines = 24; // shorter than a directive
    std::string result;
    result.reserve(m_Tokens.source().size());
    std::size_t line = 1; // 0 = not known
    auto inserted = m_Inserted.begin();
    for (std::size_t i = 0; i < size(); ++i)
    {
        if (const std::string_view pragma = PragmaBefore(i); !pragma.empty())
        {
            result.append("\n").append(pragma).append("\n");
            line = 0;
        }
        const std::string_view text = isLeftOut[i] ? std::string_view() : Now(i);
        const bool isFollowed = inserted != m_Inserted.end() && inserted->first == i;
        if (text.empty() && !isFollowed)
        {
            continue;
        }
        if (line == 0 || i + 1 - line > k_FewLines)
        {
            result += "\n#line " + std::to_string(i + 1) + " \"" + k_TokenFile + "\"\n";
        }
        else
        {
            result.append(i + 1 - line, '\n');
        }
        line = i + 1;
        result.append(text);
        if (isFollowed)
        {
            result.append(inserted->second);
            line = inserted->second.find('\n') == std::string::npos ? line : 0;
            ++inserted;
        }
    }
    return result.append("\n");
}

std::string_view TokenEdits::PragmaBefore(std::size_t index) const
{
    const std::string_view source = m_Tokens.source();
    const std::size_t begin =
        index == 0 ? 0 : m_Tokens.all()[index - 1].Begin(source) + Text(index - 1).size();
    const std::string_view between =
        source.substr(begin, m_Tokens.all()[index].Begin(source) - begin);
    const std::size_t pragma = between.rfind("#pragma");
    return pragma == between.npos ? std::string_view()
                                  : between.substr(pragma, between.find('\n', pragma) - pragma);
}

} // namespace limn
