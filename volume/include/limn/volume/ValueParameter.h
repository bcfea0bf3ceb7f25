#pragma once

#include <limn/volume/VolumeParameter.h>

namespace limn::detail
{

/// What the parameters of one type of value share: how it is read and written. Blends as the base
/// does: any t > 0 switches.
template <typename T>
class ValueParameter : public VolumeParameterT<T>
{
public:
    ValueParameter(VolumeComponent* owner, std::string_view name, T value, ParameterInfo info = {})
        : ValueParameter(owner, name, std::move(value), false, std::move(info))
    {
    }
    ValueParameter(VolumeComponent* owner, std::string_view name, T value, bool overrideState,
                   ParameterInfo info = {})
        : VolumeParameterT<T>(owner, name, std::move(value), overrideState, std::move(info))
    {
    }

    std::string ValueText() const override;
    std::string UnityText() const override;

protected:
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context) override;
};

/// from (1 - t) + to t, per component; t is not clamped. Floats are blended in double: t = 1 gives
/// exactly `to`, and no t between 0 and 1 anything beyond the two. Sealed, as Unity's are.
template <typename T>
class LerpParameter : public ValueParameter<T>
{
public:
    using ValueParameter<T>::ValueParameter;
    using ValueParameter<T>::Interp;

    void Interp(const T& from, const T& to, float t) final;
};

/// @throws ContractError about the parameter `name` unless min <= max
void CheckLimits(const std::string& name, double min, double max);

} // namespace limn::detail
