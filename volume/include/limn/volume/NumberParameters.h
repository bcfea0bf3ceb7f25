#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limn/volume/ValueParameters.h>

namespace limn::detail
{

// Parameters of numbers with limits. SetValue(value) and files keep to the limits; the constructor,
// Override and Interp do not. `Base` is the parameter without limits.

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

    /// Sets the value, limited from below; NaN becomes the limit, as with Unity's Mathf.Max.
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

    /// Sets the value, limited from above; NaN becomes the limit, as with Unity's Mathf.Min.
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

    /// Sets the value, clamped to the limits; NaN stays NaN, as with Unity's Mathf.Clamp.
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

namespace limn
{

/// A number, blended linearly. Unity: FloatParameter (URP 14).
class FloatParameter : public detail::LerpParameter<float>
{
public:
    using LerpParameter::LerpParameter;
    std::string_view typeName() const override { return "Float"; }
};

/// A number; blending switches as soon as t > 0. Unity: NoInterpFloatParameter (URP 14).
class NoInterpFloatParameter : public detail::ValueParameter<float>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "NoInterpFloat"; }
};

/// A number not below a limit. Unity: MinFloatParameter (URP 14).
class MinFloatParameter : public detail::MinParameter<FloatParameter>
{
public:
    using MinParameter::MinParameter;
    std::string_view typeName() const override { return "MinFloat"; }
};

/// A number not above a limit. Unity: MaxFloatParameter (URP 14).
class MaxFloatParameter : public detail::MaxParameter<FloatParameter>
{
public:
    using MaxParameter::MaxParameter;
    std::string_view typeName() const override { return "MaxFloat"; }
};

/// A number between two limits. Unity: ClampedFloatParameter (URP 14).
class ClampedFloatParameter : public detail::ClampedParameter<FloatParameter>
{
public:
    using ClampedParameter::ClampedParameter;
    std::string_view typeName() const override { return "ClampedFloat"; }
};

/// A number not below a limit, switching as soon as t > 0.
/// Unity: NoInterpMinFloatParameter (URP 14).
class NoInterpMinFloatParameter : public detail::MinParameter<NoInterpFloatParameter>
{
public:
    using MinParameter::MinParameter;
    std::string_view typeName() const override { return "NoInterpMinFloat"; }
};

/// A number not above a limit, switching as soon as t > 0.
/// Unity: NoInterpMaxFloatParameter (URP 14).
class NoInterpMaxFloatParameter : public detail::MaxParameter<NoInterpFloatParameter>
{
public:
    using MaxParameter::MaxParameter;
    std::string_view typeName() const override { return "NoInterpMaxFloat"; }
};

/// A number between two limits, switching as soon as t > 0.
/// Unity: NoInterpClampedFloatParameter (URP 14).
class NoInterpClampedFloatParameter : public detail::ClampedParameter<NoInterpFloatParameter>
{
public:
    using ClampedParameter::ClampedParameter;
    std::string_view typeName() const override { return "NoInterpClampedFloat"; }
};

/// A whole number. A blend is rounded toward zero, unless it misses a whole number by no more than
/// the rounding error of t (0 to 10 at 0.7f is 7). It is clamped to the range of int.
/// Unity: IntParameter (URP 14).
class IntParameter : public detail::LerpParameter<int>
{
public:
    using LerpParameter::LerpParameter;
    std::string_view typeName() const override { return "Int"; }
};

/// A whole number; blending switches as soon as t > 0. Unity: NoInterpIntParameter (URP 14).
class NoInterpIntParameter : public detail::ValueParameter<int>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "NoInterpInt"; }
};

/// A whole number from 0 up to 32 bits, such as the bits of rendering layers; blending switches as
/// soon as t > 0. Unity has no such class; a user derives one from VolumeParameter<uint>.
class UIntParameter : public detail::ValueParameter<std::uint32_t>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "UInt"; }
};

/// A whole number not below a limit. Unity: MinIntParameter (URP 14).
class MinIntParameter : public detail::MinParameter<IntParameter>
{
public:
    using MinParameter::MinParameter;
    std::string_view typeName() const override { return "MinInt"; }
};

/// A whole number not above a limit. Unity: MaxIntParameter (URP 14).
class MaxIntParameter : public detail::MaxParameter<IntParameter>
{
public:
    using MaxParameter::MaxParameter;
    std::string_view typeName() const override { return "MaxInt"; }
};

/// A whole number between two limits. Unity: ClampedIntParameter (URP 14).
class ClampedIntParameter : public detail::ClampedParameter<IntParameter>
{
public:
    using ClampedParameter::ClampedParameter;
    std::string_view typeName() const override { return "ClampedInt"; }
};

/// A whole number not below a limit, switching as soon as t > 0.
/// Unity: NoInterpMinIntParameter (URP 14).
class NoInterpMinIntParameter : public detail::MinParameter<NoInterpIntParameter>
{
public:
    using MinParameter::MinParameter;
    std::string_view typeName() const override { return "NoInterpMinInt"; }
};

/// A whole number not above a limit, switching as soon as t > 0.
/// Unity: NoInterpMaxIntParameter (URP 14).
class NoInterpMaxIntParameter : public detail::MaxParameter<NoInterpIntParameter>
{
public:
    using MaxParameter::MaxParameter;
    std::string_view typeName() const override { return "NoInterpMaxInt"; }
};

/// A whole number between two limits, switching as soon as t > 0.
/// Unity: NoInterpClampedIntParameter (URP 14).
class NoInterpClampedIntParameter : public detail::ClampedParameter<NoInterpIntParameter>
{
public:
    using ClampedParameter::ClampedParameter;
    std::string_view typeName() const override { return "NoInterpClampedInt"; }
};

namespace detail
{

/// Limits a pair as Unity does: x only from below and y only from above. It does not limit x by y.
template <typename Base>
class RangeLimited : public Base
{
public:
    using Base::SetValue;

    /// @throws ContractError unless min <= max
    RangeLimited(VolumeComponent* owner, std::string_view name, const glm::vec2& value, float min,
                 float max, ParameterInfo info = {})
        : RangeLimited(owner, name, value, min, max, false, std::move(info))
    {
    }
    RangeLimited(VolumeComponent* owner, std::string_view name, const glm::vec2& value, float min,
                 float max, bool overrideState, ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)), m_Min(min), m_Max(max)
    {
        CheckLimits(this->name(), static_cast<double>(min), static_cast<double>(max));
    }

    void SetValue(const glm::vec2& value) override
    {
        this->m_Value = {value.x > m_Min ? value.x : m_Min, value.y < m_Max ? value.y : m_Max};
    }
    std::optional<ValueRange> range() const override
    {
        return ValueRange{static_cast<double>(m_Min), static_cast<double>(m_Max)};
    }

private:
    float m_Min;
    float m_Max;
};

} // namespace detail

/// Two numbers, from x to y, blended linearly. SetValue(value) and files keep x at or above the
/// first limit and y at or below the second, and nothing else. Unity: FloatRangeParameter (URP 14).
class FloatRangeParameter : public detail::RangeLimited<detail::LerpParameter<glm::vec2>>
{
public:
    using RangeLimited::RangeLimited;
    std::string_view typeName() const override { return "FloatRange"; }
};

/// A FloatRangeParameter that switches as soon as t > 0. Unity: NoInterpFloatRangeParameter (URP
/// 14).
class NoInterpFloatRangeParameter : public detail::RangeLimited<detail::ValueParameter<glm::vec2>>
{
public:
    using RangeLimited::RangeLimited;
    std::string_view typeName() const override { return "NoInterpFloatRange"; }
};

} // namespace limn
