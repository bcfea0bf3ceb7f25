#pragma once

#include <limn/volume/VolumeParameter.h>

namespace limn
{

/// A number, blended linearly. Unity: FloatParameter (URP 14).
class FloatParameter : public VolumeParameterT<float>
{
public:
    using VolumeParameterT::Interp;

    FloatParameter(VolumeComponent* owner, std::string_view name, float value,
                   bool overrideState = false)
        : VolumeParameterT(owner, name, value, overrideState)
    {
    }

    void Interp(const float& from, const float& to, float t) final;
    bool ReadYaml(const YamlNode& node, std::string_view subject,
                  AssetDiagnostics& diagnostics) override;
    std::string ValueText() const override;
    std::string_view typeName() const override { return "Float"; }
};

/// A number between two limits, which only SetValue(value) and files hold to.
/// Unity: ClampedFloatParameter (URP 14).
class ClampedFloatParameter : public FloatParameter
{
public:
    using FloatParameter::SetValue;

    /// @throws ContractError unless min <= max
    ClampedFloatParameter(VolumeComponent* owner, std::string_view name, float value, float min,
                          float max, bool overrideState = false);

    void SetValue(const float& value) override;
    std::string_view typeName() const override { return "ClampedFloat"; }
    std::optional<ValueRange> range() const override { return ValueRange{m_Min, m_Max}; }

private:
    float m_Min;
    float m_Max;
};

} // namespace limn
