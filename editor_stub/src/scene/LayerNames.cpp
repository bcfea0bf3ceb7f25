#include <limn/editor_stub/LayerNames.h>

namespace limn
{

std::optional<int> LayerNames::Find(std::string_view name) const
{
    for (std::size_t i = 0; i < m_Names.size(); ++i)
    {
        if (!name.empty() && m_Names[i] == name)
        {
            return static_cast<int>(i);
        }
    }
    return std::nullopt;
}

std::vector<std::string_view> LayerNames::names() const
{
    std::vector<std::string_view> names;
    for (const std::string& name : m_Names)
    {
        if (!name.empty())
        {
            names.push_back(name);
        }
    }
    return names;
}

} // namespace limn
