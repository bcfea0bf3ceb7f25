#include "blending/Components.h"

#include <algorithm>
#include <limn/core/CurrentCamera.h>
#include <limn/volume/VolumeManager.h>

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

} // namespace limn
