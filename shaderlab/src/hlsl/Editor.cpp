#include "hlsl/Editor.h"

namespace limn
{

HlslEditor::HlslEditor(const std::string& text) : m_Text(text), m_Tokens(TokenizeHlsl(text))
{
    m_Spelling.reserve(m_Tokens.size());
    for (const HlslToken& token : m_Tokens)
    {
        m_Spelling.emplace_back(token.text);
    }
}

std::string_view HlslEditor::Text(std::size_t index) const
{
    return index < m_Tokens.size() ? m_Tokens[index].text : std::string_view();
}

bool HlslEditor::isWord(std::size_t index) const
{
    return index < m_Tokens.size() && m_Tokens[index].isWord;
}

std::string_view HlslEditor::Span(std::size_t first, std::size_t end) const
{
    if (first >= end)
    {
        return {};
    }
    const std::string_view last = m_Tokens[end - 1].text;
    const std::size_t begin = m_Tokens[first].Begin(m_Text);
    return std::string_view(m_Text).substr(begin,
                                           m_Tokens[end - 1].Begin(m_Text) + last.size() - begin);
}

int HlslEditor::Step(std::size_t index) const
{
    const std::string_view text = Text(index);
    return text == "(" || text == "{" || text == "["   ? 1
           : text == ")" || text == "}" || text == "]" ? -1
                                                       : 0;
}

std::size_t HlslEditor::AfterBracket(std::size_t index) const
{
    int depth = 0;
    for (; index < size(); ++index)
    {
        depth += Step(index);
        if (depth <= 0)
        {
            return index + 1;
        }
    }
    return index;
}

std::size_t HlslEditor::FindOutside(std::size_t index, std::string_view mark) const
{
    while (index < size() && Text(index) != mark && Step(index) >= 0)
    {
        index = Step(index) > 0 ? AfterBracket(index) : index + 1;
    }
    return index;
}

HlslPlace HlslEditor::Place(std::size_t index) const
{
    return PlaceOf(m_Text, m_Tokens[index].Begin(m_Text));
}

void HlslEditor::Erase(std::size_t first, std::size_t end)
{
    for (; first < end; ++first)
    {
        m_Spelling[first].clear();
    }
}

std::string HlslEditor::Assemble() const
{
    std::string result;
    result.reserve(m_Text.size());
    std::size_t position = 0;
    for (std::size_t i = 0; i < m_Tokens.size(); ++i)
    {
        const std::size_t begin = m_Tokens[i].Begin(m_Text);
        result.append(m_Text, position, begin - position).append(m_Spelling[i]);
        position = begin + m_Tokens[i].text.size();
    }
    return result.append(m_Text, position);
}

} // namespace limn
