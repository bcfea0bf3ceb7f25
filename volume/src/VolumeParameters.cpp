#include <limn/volume/BoolParameter.h>
#include <limn/volume/ColorParameter.h>
#include <limn/volume/FloatParameter.h>
#include <limn/volume/IntParameter.h>
#include <limn/volume/VolumeComponent.h>

#include <algorithm>

namespace limn
{

namespace
{

/// Unity's Mathf.Lerp without its clamp, in the order of operations that C# has.
float LerpUnclamped(float from, float to, float t)
{
    return from + (to - from) * t;
}

template <typename T>
bool Store(const std::optional<T>& read, T& value)
{
    value = read.value_or(value);
    return read.has_value();
}

} // namespace

VolumeParameter::VolumeParameter(VolumeComponent* owner, std::string_view name, bool overrideState)
    : m_Name(name), m_OverrideState(overrideState)
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

bool BoolParameter::ReadYaml(const YamlNode& node, std::string_view subject,
                             AssetDiagnostics& diagnostics)
{
    return Store(ReadBool(node, subject, diagnostics), m_Value);
}

std::string BoolParameter::ValueText() const
{
    return value() ? "true" : "false";
}

void IntParameter::Interp(const int& from, const int& to, float t)
{
    // A float holds neither every int nor the difference of two, hence the detours.
    const auto difference = static_cast<float>(static_cast<std::int64_t>(to) - from);
    const float blended = static_cast<float>(from) + difference * t;
    constexpr auto least = static_cast<float>(std::numeric_limits<int>::min());
    if (blended >= -least)
    {
        m_Value = std::numeric_limits<int>::max();
        return;
    }
    m_Value = static_cast<int>(std::max(least, blended));
}

bool IntParameter::ReadYaml(const YamlNode& node, std::string_view subject,
                            AssetDiagnostics& diagnostics)
{
    const std::optional<ValueRange> limits = range();
    return Store(ReadInt(node, subject, diagnostics, limits.value_or(ValueRange{})), m_Value);
}

std::string IntParameter::ValueText() const
{
    return std::to_string(value());
}

void FloatParameter::Interp(const float& from, const float& to, float t)
{
    m_Value = LerpUnclamped(from, to, t);
}

bool FloatParameter::ReadYaml(const YamlNode& node, std::string_view subject,
                              AssetDiagnostics& diagnostics)
{
    const std::optional<ValueRange> limits = range();
    return Store(ReadFloat(node, subject, diagnostics, limits.value_or(ValueRange{})), m_Value);
}

std::string FloatParameter::ValueText() const
{
    return NumberText(static_cast<double>(value()));
}

ClampedFloatParameter::ClampedFloatParameter(VolumeComponent* owner, std::string_view name,
                                             float value, float min, float max, bool overrideState)
    : FloatParameter(owner, name, value, overrideState), m_Min(min), m_Max(max)
{
    if (!(min <= max))
    {
        throw ContractError("'" + this->name() + "' has the range " +
                            RangeText({static_cast<double>(min), static_cast<double>(max)}) +
                            "; the first limit must not be above the second");
    }
}

void ClampedFloatParameter::SetValue(const float& value)
{
    m_Value = std::clamp(value, m_Min, m_Max);
}

void ColorParameter::Interp(const Color& from, const Color& to, float t)
{
    m_Value = {LerpUnclamped(from.r, to.r, t), LerpUnclamped(from.g, to.g, t),
               LerpUnclamped(from.b, to.b, t), LerpUnclamped(from.a, to.a, t)};
}

bool ColorParameter::ReadYaml(const YamlNode& node, std::string_view subject,
                              AssetDiagnostics& diagnostics)
{
    return Store(ReadColor(node, subject, diagnostics), m_Value);
}

std::string ColorParameter::ValueText() const
{
    const auto text = [](float channel)
    {
        return NumberText(static_cast<double>(channel));
    };
    return "{r: " + text(value().r) + ", g: " + text(value().g) + ", b: " + text(value().b) +
           ", a: " + text(value().a) + "}";
}

} // namespace limn
