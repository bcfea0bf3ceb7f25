#include "hlsl/Editor.h"

namespace limn
{

HlslEditor::HlslEditor(const std::string& text)
    : m_Owned(std::make_unique<const HlslTokens>(text)), m_Tokens(*m_Owned), m_Edit(m_Tokens.size())
{
}

HlslEditor::HlslEditor(const HlslTokens& tokens) : m_Tokens(tokens), m_Edit(tokens.size()) {}

std::string& HlslEditor::Spelling(std::size_t index)
{
    if (m_Edit[index] == 0)
    {
        m_Spelling.emplace_back(Text(index));
        m_Edit[index] = static_cast<std::uint32_t>(m_Spelling.size());
    }
    return m_Spelling[m_Edit[index] - 1];
}

std::string HlslEditor::Spelled(std::size_t first, std::size_t end) const
{
    std::string result;
    for (; first < end; ++first)
    {
        const std::uint32_t edit = m_Edit[first];
        result.append(edit == 0 ? Text(first) : m_Spelling[edit - 1]).append(" ");
    }
    return result;
}

void HlslEditor::Wrap(std::size_t first, std::size_t end, std::string_view before,
                      std::string_view after)
{
    Spelling(first).insert(0, before);
    Spelling(end - 1).append(after);
}

void HlslEditor::Erase(std::size_t first, std::size_t end)
{
    for (; first < end; ++first)
    {
        Spelling(first).clear();
    }
}

std::string HlslEditor::Assemble() const
{
    return Assemble(std::vector<bool>(size(), false));
}

std::string HlslEditor::Assemble(const std::vector<bool>& isLeftOut) const
{
    const std::string_view source = m_Tokens.source();
    std::string result;
    result.reserve(source.size());
    std::size_t position = 0;
    auto inserted = m_Inserted.begin();
    for (std::size_t i = 0; i < size(); ++i)
    {
        const std::string_view text = Text(i);
        const auto begin = static_cast<std::size_t>(text.data() - source.data());
        result.append(source.substr(position, begin - position));
        position = begin + text.size();
        result.append(i == 0 ? m_Prepended : std::string());
        if (!isLeftOut[i])
        {
            result.append(m_Edit[i] == 0 ? text : m_Spelling[m_Edit[i] - 1]);
        }
        if (inserted != m_Inserted.end() && inserted->first == i)
        {
            result.append((inserted++)->second);
        }
    }
    return result.append(source.substr(position));
}

} // namespace limn
