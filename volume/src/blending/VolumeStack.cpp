#include <limn/volume/VolumeStack.h>

#include <algorithm>

namespace limn
{

VolumeStack::VolumeStack(const VolumeComponentRegistry& registry,
                         std::shared_ptr<const std::uint64_t> defaults)
    : m_Defaults(std::move(defaults)), m_DefaultsSeen(*m_Defaults)
{
    for (const auto& entry : registry.entries())
    {
        m_Slots.push_back({entry->type, entry->create(), entry->defaults.get()});
    }
    std::ranges::sort(m_Slots, {}, &Slot::type);
}

const VolumeStack& VolumeStack::Defaults()
{
    static const VolumeStack defaults(VolumeComponentRegistry(),
                                      std::make_shared<const std::uint64_t>(0));
    return defaults;
}

VolumeComponent* VolumeStack::Find(std::type_index type) const
{
    const auto slot = std::ranges::lower_bound(m_Slots, type, {}, &Slot::type);
    return slot != m_Slots.end() && slot->type == type ? slot->state.get() : nullptr;
}

void VolumeStack::Reset()
{
    for (Slot& slot : m_Slots)
    {
        const std::span<VolumeParameter* const> parameters = slot.state->parameters();
        const std::span<const VolumeParameter* const> defaults = slot.defaults->parameters();
        for (std::size_t i = 0; i < parameters.size(); ++i)
        {
            parameters[i]->SetOverrideState(false);
            parameters[i]->SetValue(*defaults[i]);
        }
    }
}

} // namespace limn
