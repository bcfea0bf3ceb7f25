#include <limn/features/FeatureRegistry.h>

#include <algorithm>
#include <limn/base/Case.h>

namespace limn
{

void FeatureRegistry::Add(Entry entry, std::vector<Technique> techniques)
{
    if (entry.name.empty())
    {
        throw ContractError("a feature needs a name to be registered");
    }
    if (std::ranges::any_of(m_Entries, [&](const auto& e) { return e->name == entry.name; }))
    {
        throw ContractError("a feature '" + entry.name + "' is registered already");
    }
    std::vector<Technique> all = m_Techniques;
    for (Technique& technique : techniques)
    {
        if (technique.name.empty() || FindTechnique(all, technique.name))
        {
            throw ContractError("a technique '" + technique.name + "' has no name or a taken one");
        }
        technique.feature = entry.name;
        const auto behind = std::ranges::upper_bound(all, technique.place, {}, &Technique::place);
        all.insert(behind, std::move(technique));
    }
    m_Entries.push_back(std::make_unique<const Entry>(std::move(entry)));
    m_Techniques = std::move(all);
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

const Technique* FindTechnique(std::span<const Technique> techniques, std::string_view name)
{
    const auto found = std::ranges::find_if(techniques, [name](const Technique& technique)
                                            { return EqualsIgnoringCase(technique.name, name); });
    return found == techniques.end() ? nullptr : &*found;
}

} // namespace limn
