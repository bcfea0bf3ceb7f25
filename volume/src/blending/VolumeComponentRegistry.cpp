#include <limn/volume/VolumeComponentRegistry.h>

#include "blending/Components.h"

#include <algorithm>
#include <limn/base/Lists.h>

namespace limn
{

namespace
{

std::unique_ptr<VolumeComponent> CreateFrom(const VolumeComponentRegistry::Entry* entry,
                                            const std::string& name,
                                            const VolumeComponentRegistry& registry)
{
    if (!entry)
    {
        throw ContractError("unknown volume component " + UnknownName(name, registry.names()));
    }
    return entry->create();
}

} // namespace

void VolumeComponentRegistry::Add(Entry entry)
{
    if (entry.name.empty())
    {
        throw ContractError("a volume component needs a name to be registered");
    }
    if (Find(entry.name))
    {
        throw ContractError("a volume component '" + entry.name + "' is registered already");
    }
    if (const Entry* same = Find(entry.type))
    {
        throw ContractError("the type of volume component '" + entry.name +
                            "' is registered already, as '" + same->name + "'");
    }
    entry.defaults = entry.create();
    m_Entries.push_back(std::make_unique<const Entry>(std::move(entry)));
}

std::unique_ptr<VolumeComponent> VolumeComponentRegistry::Create(std::string_view name) const
{
    return CreateFrom(Find(name), std::string(name), *this);
}

std::unique_ptr<VolumeComponent> VolumeComponentRegistry::Create(std::type_index type) const
{
    return CreateFrom(Find(type), TypeName(type), *this);
}

const VolumeComponentRegistry::Entry* VolumeComponentRegistry::Find(std::string_view name) const
{
    const auto found = std::find_if(m_Entries.begin(), m_Entries.end(),
                                    [name](const auto& entry) { return entry->name == name; });
    return found == m_Entries.end() ? nullptr : found->get();
}

const VolumeComponentRegistry::Entry* VolumeComponentRegistry::Find(std::type_index type) const
{
    const auto found = std::find_if(m_Entries.begin(), m_Entries.end(),
                                    [type](const auto& entry) { return entry->type == type; });
    return found == m_Entries.end() ? nullptr : found->get();
}

std::vector<std::string_view> VolumeComponentRegistry::names() const
{
    return NamesOf(m_Entries, [](const auto& entry) { return std::string_view(entry->name); });
}

} // namespace limn
