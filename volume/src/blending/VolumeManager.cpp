#include <limn/volume/VolumeManager.h>

#include "blending/Components.h"
#include "blending/VolumeBlending.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Stable, and quick on a list that is nearly sorted; allocates nothing, unlike std::stable_sort.
void SortByPriority(std::vector<const Volume*>& volumes)
{
    for (std::size_t i = 1; i < volumes.size(); ++i)
    {
        const Volume* moved = volumes[i];
        std::size_t to = i;
        for (; to > 0 && volumes[to - 1]->priority > moved->priority; --to)
        {
            volumes[to] = volumes[to - 1];
        }
        volumes[to] = moved;
    }
}

} // namespace

bool VolumeManager::Register(const Volume* volume)
{
    if (!volume)
    {
        throw ContractError("VolumeManager::Register got no volume");
    }
    FollowMoves();
    if (FindRegistration(volume) != m_Registrations.end())
    {
        return false;
    }
    if (!volume->m_Address)
    {
        volume->m_Address = std::make_shared<const detail::VolumePlace*>(volume);
    }
    const Registration registration{volume->m_Address, volume, volume->layer, volume->priority};
    AddToLists(registration);
    m_Registrations.push_back(registration);
    return true;
}

void VolumeManager::Unregister(const Volume* volume)
{
    FollowMoves();
    const auto found = FindRegistration(volume);
    if (found != m_Registrations.end())
    {
        RemoveFromLists(*found);
        m_Registrations.erase(found);
    }
}

std::vector<VolumeManager::Registration>::iterator
VolumeManager::FindRegistration(const Volume* volume)
{
    return std::ranges::find(m_Registrations, volume, &Registration::volume);
}

void VolumeManager::Update(VolumeStack& stack, const std::optional<glm::vec3>& trigger,
                           LayerMask layerMask)
{
    if (m_Registrations.empty() && !stack.requiresReset())
    {
        return; // the stack shows its defaults
    }
    stack.m_RequiresReset = !m_Registrations.empty();
    ResetToDefaults(stack);
    const auto apply =
        [&stack](const Volume&, const VolumeComponent& component, const VolumeInfluence& influence)
    {
        // A stack does not have a type that was registered after it was created.
        if (VolumeComponent* state = stack.Find(typeid(component)))
        {
            OverrideState(component, *state, influence.factor);
        }
    };
    ForEachContribution(GetVolumes(layerMask), trigger, apply);
}

std::span<const Volume* const> VolumeManager::GetVolumes(LayerMask layerMask)
{
    NoticeChanges();
    auto list = std::ranges::find(m_Lists, layerMask, &SortedList::mask);
    if (list == m_Lists.end())
    {
        list = m_Lists.insert(m_Lists.end(), {layerMask, {}, true});
        Fill(*list);
    }
    if (list->isDirty)
    {
        SortByPriority(list->volumes);
        list->isDirty = false;
    }
    return list->volumes;
}

bool VolumeManager::IsComponentActiveInMask(const std::type_info& type, LayerMask layerMask) const
{
    const auto isActive = [&type](const std::unique_ptr<VolumeComponent>& owned)
    {
        const VolumeComponent& component = *owned;
        return component.active && typeid(component) == type;
    };
    const auto counts = [&](const Registration& registration)
    {
        const auto* volume = static_cast<const Volume*>(*registration.address);
        const bool isIn = volume != nullptr && volume->enabled &&
                          layerMask.Intersects(LayerMask::FromIndex(registration.layer));
        const VolumeProfile* profile = isIn ? volume->profileRef() : nullptr;
        return profile &&
               std::any_of(profile->components().begin(), profile->components().end(), isActive);
    };
    return std::ranges::find(m_Lists, layerMask, &SortedList::mask) != m_Lists.end() &&
           std::ranges::any_of(m_Registrations, counts);
}

void VolumeManager::Fill(SortedList& list) const
{
    list.volumes.clear();
    list.isDirty = true;
    for (const Registration& registration : m_Registrations)
    {
        if (list.mask.Intersects(LayerMask::FromIndex(registration.layer)))
        {
            list.volumes.push_back(registration.volume);
        }
    }
}

void VolumeManager::FollowMoves()
{
    bool hasChanged = false;
    for (Registration& registration : m_Registrations)
    {
        const auto* now = static_cast<const Volume*>(*registration.address);
        hasChanged = hasChanged || registration.volume != now;
        registration.volume = now;
    }
    if (hasChanged)
    {
        std::erase_if(m_Registrations,
                      [](const Registration& known) { return known.volume == nullptr; });
        std::ranges::for_each(m_Lists, [this](SortedList& list) { Fill(list); });
    }
}

void VolumeManager::NoticeChanges()
{
    FollowMoves();
    for (std::size_t i = 0, remaining = m_Registrations.size(); remaining > 0; --remaining)
    {
        Registration& registration = m_Registrations[i];
        const Volume& volume = *registration.volume;
        if (registration.priority != volume.priority)
        {
            registration.priority = volume.priority;
            MarkDirty(registration.layer);
        }
        if (registration.layer == volume.layer)
        {
            ++i;
            continue;
        }
        const Registration moved{registration.address, &volume, volume.layer, volume.priority};
        LayerMask::FromIndex(moved.layer); // refuses a bad layer while nothing is changed yet
        RemoveFromLists(registration);
        AddToLists(moved);
        m_Registrations.erase(m_Registrations.begin() + static_cast<std::ptrdiff_t>(i));
        m_Registrations.push_back(moved);
    }
}

void VolumeManager::AddToLists(const Registration& registration)
{
    const LayerMask layer = LayerMask::FromIndex(registration.layer);
    for (SortedList& list : m_Lists)
    {
        if (list.mask.Intersects(layer))
        {
            list.volumes.push_back(registration.volume);
            list.isDirty = true;
        }
    }
}

void VolumeManager::RemoveFromLists(const Registration& registration)
{
    const LayerMask layer = LayerMask::FromIndex(registration.layer);
    for (SortedList& list : m_Lists)
    {
        if (list.mask.Intersects(layer))
        {
            std::erase(list.volumes, registration.volume);
        }
    }
}

void VolumeManager::MarkDirty(int layer)
{
    const LayerMask changed = LayerMask::FromIndex(layer);
    for (SortedList& list : m_Lists)
    {
        list.isDirty = list.isDirty || list.mask.Intersects(changed);
    }
}

} // namespace limn
