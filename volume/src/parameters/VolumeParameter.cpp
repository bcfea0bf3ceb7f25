#include <limn/volume/VolumeComponent.h>
#include <limn/volume/VolumeParameter.h>

namespace limn
{

VolumeParameter::VolumeParameter(VolumeComponent* owner, std::string_view name, bool overrideState,
                                 ParameterInfo info)
    : m_Name(name), m_Info(std::move(info)), m_OverrideState(overrideState)
{
    if (owner)
    {
        owner->Register(*this);
    }
}

void VolumeParameter::RefuseOtherType(const VolumeParameter& other) const
{
    throw ContractError("'" + m_Name + "' is a " + std::string(typeName()) + " parameter, '" +
                        other.m_Name + "' a " + std::string(other.typeName()) +
                        " parameter; only parameters of one type blend");
}

} // namespace limn
