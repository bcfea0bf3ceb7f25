#include <limn/features/FeatureRegistry.h>

#include <algorithm>

namespace limn
{

void FeatureRegistry::Add(Entry entry)
{
    if (entry.name.empty())
    {
        throw ContractError("a feature needs a name to be registered");
    }
    if (std::ranges::any_of(m_Entries, [&](const auto& e) { return e->name == entry.name; }))
    {
        throw ContractError("a feature '" + entry.name + "' is registered already");
    }
    m_Entries.push_back(std::make_unique<const Entry>(std::move(entry)));
}

std::unique_ptr<ScriptableRendererFeature> FeatureRegistry::Create(std::string_view name) const
{
    const auto found =
        std::ranges::find_if(m_Entries, [name](const auto& entry) { return entry->name == name; });
    if (found == m_Entries.end())
    {
        return nullptr;
    }
    return RunPluginCode(*(*found)->type, name, "its constructor", (*found)->create);
}

std::vector<std::string_view> FeatureRegistry::names() const
{
    std::vector<std::string_view> names;
    for (const auto& entry : m_Entries)
    {
        names.push_back(entry->name);
    }
    return names;
}

} // namespace limn
