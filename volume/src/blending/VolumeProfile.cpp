#include <limn/volume/VolumeProfile.h>

#include "blending/Components.h"

#include <algorithm>
#include <limn/volume/Volume.h>

namespace limn
{

VolumeComponent& VolumeProfile::Add(std::unique_ptr<VolumeComponent> component)
{
    if (!component)
    {
        throw ContractError("VolumeProfile::Add got no component");
    }
    const VolumeComponent& added = *component;
    if (Find(typeid(added)))
    {
        throw ContractError("the volume profile '" + name + "' has a component of type " +
                            TypeName(typeid(added)) + " already");
    }
    m_Components.push_back(std::move(component));
    return *m_Components.back();
}

VolumeProfile VolumeProfile::Clone(const VolumeComponentRegistry& registry) const
{
    VolumeProfile copy;
    copy.name = name;
    for (const std::unique_ptr<VolumeComponent>& component : m_Components)
    {
        copy.m_Components.push_back(CloneComponent(*component, registry));
    }
    return copy;
}

VolumeComponent* VolumeProfile::Find(const std::type_info& type) const
{
    const auto isOfType = [&type](const std::unique_ptr<VolumeComponent>& owned)
    {
        const VolumeComponent& component = *owned;
        return typeid(component) == type;
    };
    const auto found = std::ranges::find_if(m_Components, isOfType);
    return found == m_Components.end() ? nullptr : found->get();
}

void VolumeProfile::Remove(const std::type_info& type)
{
    std::erase_if(m_Components,
                  [found = Find(type)](const auto& owned) { return owned.get() == found; });
}

VolumeProfile& Volume::profile(const VolumeComponentRegistry& registry)
{
    if (!m_Profile)
    {
        m_Profile = std::make_shared<VolumeProfile>(sharedProfile ? sharedProfile->Clone(registry)
                                                                  : VolumeProfile());
    }
    return *m_Profile;
}

} // namespace limn
