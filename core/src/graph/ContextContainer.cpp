#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/core/ContextContainer.h>
#include <limn/core/PluginCallSite.h>
#include <utility>

namespace limn
{

void ContextContainer::Dispose()
{
    for (Entry& entry : m_Entries)
    {
        if (std::exchange(entry.isThere, false))
        {
            entry.item->Reset();
        }
    }
}

ContextContainer::Entry* ContextContainer::Find(std::type_index type)
{
    const auto entry = std::ranges::find(m_Entries, type, &Entry::type);
    return entry == m_Entries.end() ? nullptr : &*entry;
}

bool ContextContainer::Contains(std::type_index type) const
{
    const auto entry = std::ranges::find(m_Entries, type, &Entry::type);
    return entry != m_Entries.end() && entry->isThere;
}

ContextItem& ContextContainer::Existing(std::type_index type)
{
    Entry* entry = Find(type);
    if (entry == nullptr || !entry->isThere)
    {
        throw ContractError(
            "ContextContainer: there is no " + TypeName(type) +
            " in this frame; call Contains to ask for it, or GetOrCreate to make it");
    }
    return *entry->item;
}

void ContextContainer::Begin(Entry& entry)
{
    if (entry.isThere)
    {
        throw ContractError("ContextContainer: Create: this frame has a " + TypeName(entry.type) +
                            " already; call Get or GetOrCreate");
    }
    entry.isThere = true;
}

} // namespace limn
