#include <limn/volume/VolumeManager.h>

#include "blending/Components.h"
#include "blending/VolumeBlending.h"

#include <algorithm>
#include <limn/core/CurrentCamera.h>

namespace limn
{

VolumeStackPointer VolumeManager::stack()
{
    const RenderingData* camera = CurrentCamera::renderingData();
    return camera != nullptr ? camera->volumeStack : VolumeStackPointer();
}

VolumeStack VolumeManager::CreateStack() const
{
    VolumeStack stack(m_Registry, m_DefaultsChanges);
    ResetToDefaults(stack);
    return stack;
}

void VolumeManager::SetGlobalDefaultProfile(std::shared_ptr<const VolumeProfile> profile)
{
    m_GlobalDefaults = std::move(profile);
    ++*m_DefaultsChanges;
}

void VolumeManager::SetQualityDefaultProfile(std::shared_ptr<const VolumeProfile> profile)
{
    m_QualityDefaults = std::move(profile);
    ++*m_DefaultsChanges;
}

void VolumeManager::SetCustomDefaultProfiles(
    std::vector<std::shared_ptr<const VolumeProfile>> profiles)
{
    std::erase(profiles, nullptr);
    m_CustomDefaults = std::move(profiles);
    ++*m_DefaultsChanges;
}

template <typename Visitor>
void VolumeManager::ForEachDefaultProfile(Visitor&& visit) const
{
    if (m_GlobalDefaults)
    {
        visit(*m_GlobalDefaults);
    }
    if (m_QualityDefaults)
    {
        visit(*m_QualityDefaults);
    }
    for (const std::shared_ptr<const VolumeProfile>& profile : m_CustomDefaults)
    {
        visit(*profile);
    }
}

void VolumeManager::OnVolumeProfileChanged(const VolumeProfile& changed)
{
    ForEachDefaultProfile([&](const VolumeProfile& profile)
                          { *m_DefaultsChanges += &profile == &changed ? 1 : 0; });
}

void VolumeManager::ResetToDefaults(VolumeStack& stack) const
{
    stack.Reset();
    const auto apply = [&stack](const VolumeProfile& profile)
    {
        for (const std::unique_ptr<VolumeComponent>& owned : profile.components())
        {
            const VolumeComponent& component = *owned;
            VolumeComponent* state = stack.Find(typeid(component));
            if (component.active && state)
            {
                OverrideState(component, *state, 1.0f);
                state->SetAllOverridesTo(false); // a default is not a volume's doing
            }
        }
    };
    ForEachDefaultProfile(apply);
    stack.m_DefaultsSeen = *m_DefaultsChanges;
}

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
    LayerMask::FromIndex(volume->layer); // refuses a bad layer
    m_Registrations.push_back({volume->m_Address, volume, volume->layer});
    return true;
}

void VolumeManager::Unregister(const Volume* volume)
{
    FollowMoves();
    const auto found = FindRegistration(volume);
    if (found != m_Registrations.end())
    {
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
    Sort();
    if (std::ranges::find(m_Masks, layerMask) == m_Masks.end())
    {
        m_Masks.push_back(layerMask);
    }
    m_InMask.clear();
    for (const Registration& registration : m_Registrations)
    {
        if (layerMask.Intersects(LayerMask::FromIndex(registration.layer)))
        {
            m_InMask.push_back(registration.volume);
        }
    }
    return m_InMask;
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
        return profile && std::ranges::any_of(profile->components(), isActive);
    };
    return std::ranges::find(m_Masks, layerMask) != m_Masks.end() &&
           std::ranges::any_of(m_Registrations, counts);
}

void VolumeManager::FollowMoves()
{
    for (Registration& registration : m_Registrations)
    {
        registration.volume = static_cast<const Volume*>(*registration.address);
    }
    std::erase_if(m_Registrations,
                  [](const Registration& known) { return known.volume == nullptr; });
}

void VolumeManager::Sort()
{
    FollowMoves();
    auto unseen = m_Registrations.begin();
    for (std::size_t remaining = m_Registrations.size(); remaining > 0; --remaining)
    {
        const int layer = unseen->volume->layer;
        if (unseen->layer == layer)
        {
            ++unseen;
            continue;
        }
        LayerMask::FromIndex(layer); // refuses a bad layer while nothing is changed yet
        unseen->layer = layer;
        std::rotate(unseen, unseen + 1, m_Registrations.end());
    }
    // Stable, and quick on a list that is nearly sorted; allocates nothing, unlike
    // std::stable_sort.
    const auto begin = m_Registrations.begin();
    for (auto moved = begin; moved != m_Registrations.end(); ++moved)
    {
        auto to = moved;
        while (to != begin && (to - 1)->volume->priority > moved->volume->priority)
        {
            --to;
        }
        std::rotate(to, moved, moved + 1);
    }
}

} // namespace limn
