#include "blending/Components.h"

namespace limn
{

std::unique_ptr<VolumeComponent> CloneComponent(const VolumeComponent& component,
                                                const VolumeComponentRegistry& registry)
{
    std::unique_ptr<VolumeComponent> copy = registry.Create(typeid(component));
    copy->active = component.active;
    copy->displayName = component.displayName;
    CopyParameters(component, *copy);
    return copy;
}

void OverrideState(const VolumeComponent& component, VolumeComponent& state, float interpFactor)
{
    RunPluginCode(typeid(component), component.displayName, "Override",
                  [&] { component.Override(state, interpFactor); });
}

void CopyParameters(const VolumeComponent& from, VolumeComponent& to)
{
    const std::span<const VolumeParameter* const> parameters = from.parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i)
    {
        to.parameters()[i]->SetValue(*parameters[i]);
        to.parameters()[i]->SetOverrideState(parameters[i]->overrideState());
    }
}

} // namespace limn
