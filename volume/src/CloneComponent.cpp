#include "CloneComponent.h"

namespace limn
{

std::unique_ptr<VolumeComponent> CloneComponent(const VolumeComponent& component,
                                                const VolumeComponentRegistry& registry)
{
    std::unique_ptr<VolumeComponent> copy = registry.Create(typeid(component));
    copy->active = component.active;
    copy->displayName = component.displayName;
    const std::span<const VolumeParameter* const> parameters = component.parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i)
    {
        copy->parameters()[i]->SetValue(*parameters[i]);
        copy->parameters()[i]->SetOverrideState(parameters[i]->overrideState());
    }
    return copy;
}

} // namespace limn
