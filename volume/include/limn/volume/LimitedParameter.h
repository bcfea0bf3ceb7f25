#pragma once

#include <limn/volume/ValueParameter.h>

namespace limn::detail
{

// Parameters of numbers with limits, which SetValue(value) and files hold to; the constructor,
// Override and Interp do not. `Base` is the parameter without them.

template <typename Base>
class MinParameter : public Base
{
public:
    using T = typename Base::ValueType;
    using Base::SetValue;

    MinParameter(VolumeComponent* owner, std::string_view name, T value, T min,
                 ParameterInfo info = {})
        : MinParameter(owner, name, value, min, false, std::move(info))
    {
    }
    MinParameter(VolumeComponent* owner, std::string_view name, T value, T min, bool overrideState,
                 ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)), m_Min(min)
    {
    }

    /// NaN becomes the limit, as with Unity's Mathf.Max.
    void SetValue(const T& value) override { this->m_Value = value > m_Min ? value : m_Min; }
    std::optional<ValueRange> range() const override
    {
        return ValueRange{.min = static_cast<double>(m_Min)};
    }

private:
    T m_Min;
};

template <typename Base>
class MaxParameter : public Base
{
public:
    using T = typename Base::ValueType;
    using Base::SetValue;

    MaxParameter(VolumeComponent* owner, std::string_view name, T value, T max,
                 ParameterInfo info = {})
        : MaxParameter(owner, name, value, max, false, std::move(info))
    {
    }
    MaxParameter(VolumeComponent* owner, std::string_view name, T value, T max, bool overrideState,
                 ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)), m_Max(max)
    {
    }

    /// NaN becomes the limit, as with Unity's Mathf.Min.
    void SetValue(const T& value) override { this->m_Value = value < m_Max ? value : m_Max; }
    std::optional<ValueRange> range() const override
    {
        return ValueRange{.max = static_cast<double>(m_Max)};
    }

private:
    T m_Max;
};

template <typename Base>
class ClampedParameter : public Base
{
public:
    using T = typename Base::ValueType;
    using Base::SetValue;

    /// @throws ContractError unless min <= max
    ClampedParameter(VolumeComponent* owner, std::string_view name, T value, T min, T max,
                     ParameterInfo info = {})
        : ClampedParameter(owner, name, value, min, max, false, std::move(info))
    {
    }
    ClampedParameter(VolumeComponent* owner, std::string_view name, T value, T min, T max,
                     bool overrideState, ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)), m_Min(min), m_Max(max)
    {
        CheckLimits(this->name(), static_cast<double>(min), static_cast<double>(max));
    }

    /// NaN stays NaN, as with Unity's Mathf.Clamp.
    void SetValue(const T& value) override
    {
        this->m_Value = value < m_Min ? m_Min : value > m_Max ? m_Max : value;
    }
    std::optional<ValueRange> range() const override
    {
        return ValueRange{static_cast<double>(m_Min), static_cast<double>(m_Max)};
    }

private:
    T m_Min;
    T m_Max;
};

} // namespace limn::detail
