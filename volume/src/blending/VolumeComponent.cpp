#include <limn/volume/VolumeComponent.h>

#include "blending/Components.h"

#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

/// The key of profile files that switches a component on and off.
constexpr std::string_view k_ActiveKey = "active";

void SetOverrideStates(std::span<VolumeParameter* const> parameters, bool state)
{
    for (VolumeParameter* parameter : parameters)
    {
        parameter->SetOverrideState(state);
        SetOverrideStates(parameter->parameters(), state);
    }
}

} // namespace

VolumeParameter* FindParameter(std::span<VolumeParameter* const> parameters, std::string_view name)
{
    const auto isNamed = [name](const VolumeParameter* parameter)
    {
        return parameter->name() == name || PlainSpelling(parameter->name()) == name;
    };
    const auto found = std::ranges::find_if(parameters, isNamed);
    return found == parameters.end() ? nullptr : *found;
}

void VolumeComponent::Override(VolumeComponent& state, float interpFactor) const
{
    if (typeid(*this) != typeid(state) || m_Parameters.size() != state.m_Parameters.size())
    {
        throw ContractError("a volume component of type " + TypeName(typeid(*this)) +
                            " cannot override one of type " + TypeName(typeid(state)));
    }
    for (std::size_t i = 0; i < m_Parameters.size(); ++i)
    {
        const VolumeParameter& to = *m_Parameters[i];
        VolumeParameter& result = *state.m_Parameters[i];
        if (to.overrideState())
        {
            result.SetOverrideState(true);
            result.Interp(result, to, interpFactor);
        }
    }
}

void VolumeComponent::SetAllOverridesTo(bool state)
{
    SetOverrideStates(m_Parameters, state);
}

void VolumeComponent::Register(VolumeParameter& parameter)
{
    const std::string plain = PlainSpelling(parameter.name());
    if (plain.empty() || plain == k_ActiveKey)
    {
        throw ContractError("a volume parameter cannot be called '" + parameter.name() +
                            "'; profiles could not tell it from the component's own keys");
    }
    if (FindParameter(parameter.name()) || FindParameter(plain))
    {
        throw ContractError("two parameters of one volume component are called '" +
                            parameter.name() + "'");
    }
    m_Parameters.push_back(&parameter);
}

} // namespace limn
