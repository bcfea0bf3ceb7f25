#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limn/volume/ValueParameters.h>

namespace limn::detail
{

// Parameters of numbers with limits. SetValue(value) and files keep to the limits; the constructor,
// Override and Interp do not. `Base` is the parameter without limits.

/// A parameter with one limit.
/// @tparam isLower  the limit is the least value, else the greatest
template <typename Base, bool isLower>
class LimitedParameter : public Base
{
public:
    using T = typename Base::ValueType;
    using Base::SetValue;

    LimitedParameter(VolumeComponent* owner, std::string_view name, T value, T limit,
                     ParameterInfo info = {})
        : LimitedParameter(owner, name, value, limit, false, std::move(info))
    {
    }
    LimitedParameter(VolumeComponent* owner, std::string_view name, T value, T limit,
                     bool overrideState, ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)), m_Limit(limit)
    {
    }

    /// Sets the value, limited from one side; NaN becomes the limit, as with Unity's Mathf.Max and
    /// Mathf.Min.
    void SetValue(const T& value) override
    {
        const bool isWithin = isLower ? value > m_Limit : value < m_Limit;
        this->m_Value = isWithin ? value : m_Limit;
    }
    std::optional<ValueRange> range() const override
    {
        const auto limit = static_cast<double>(m_Limit);
        return isLower ? ValueRange{.min = limit} : ValueRange{.max = limit};
    }

private:
    T m_Limit;
};

/// Clamps a value to the limits; NaN stays NaN, as with Unity's Mathf.Clamp.
template <typename T>
T Limited(const T& value, T min, T max)
{
    return value < min ? min : value > max ? max : value;
}
/// Limits a pair as Unity does: x only from below and y only from above. It does not limit x by y.
inline glm::vec2 Limited(const glm::vec2& value, float min, float max)
{
    return {value.x > min ? value.x : min, value.y < max ? value.y : max};
}

/// A parameter between two limits.
/// @tparam Limit  the type of the limits, which is that of the value or of its numbers
template <typename Base, typename Limit = typename Base::ValueType>
class ClampedParameter : public Base
{
public:
    using T = typename Base::ValueType;
    using Base::SetValue;

    /// @throws ContractError unless min <= max
    ClampedParameter(VolumeComponent* owner, std::string_view name, const T& value, Limit min,
                     Limit max, ParameterInfo info = {})
        : ClampedParameter(owner, name, value, min, max, false, std::move(info))
    {
    }
    ClampedParameter(VolumeComponent* owner, std::string_view name, const T& value, Limit min,
                     Limit max, bool overrideState, ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)), m_Min(min), m_Max(max)
    {
        CheckLimits(this->name(), static_cast<double>(min), static_cast<double>(max));
    }

    void SetValue(const T& value) override { this->m_Value = Limited(value, m_Min, m_Max); }
    std::optional<ValueRange> range() const override
    {
        return ValueRange{static_cast<double>(m_Min), static_cast<double>(m_Max)};
    }

private:
    Limit m_Min;
    Limit m_Max;
};

} // namespace limn::detail

namespace limn
{

/// A number, blended linearly. Unity: FloatParameter (URP 14).
using FloatParameter = detail::NamedParameter<detail::LerpParameter<float>, "Float">;

/// A number; blending switches as soon as t > 0. Unity: NoInterpFloatParameter (URP 14).
using NoInterpFloatParameter =
    detail::NamedParameter<detail::ValueParameter<float>, "NoInterpFloat">;

/// A number not below a limit. Unity: MinFloatParameter (URP 14).
using MinFloatParameter =
    detail::NamedParameter<detail::LimitedParameter<FloatParameter, true>, "MinFloat">;

/// A number not above a limit. Unity: MaxFloatParameter (URP 14).
using MaxFloatParameter =
    detail::NamedParameter<detail::LimitedParameter<FloatParameter, false>, "MaxFloat">;

/// A number between two limits. Unity: ClampedFloatParameter (URP 14).
using ClampedFloatParameter =
    detail::NamedParameter<detail::ClampedParameter<FloatParameter>, "ClampedFloat">;

/// A number not below a limit, switching as soon as t > 0.
/// Unity: NoInterpMinFloatParameter (URP 14).
using NoInterpMinFloatParameter =
    detail::NamedParameter<detail::LimitedParameter<NoInterpFloatParameter, true>,
                           "NoInterpMinFloat">;

/// A number not above a limit, switching as soon as t > 0.
/// Unity: NoInterpMaxFloatParameter (URP 14).
using NoInterpMaxFloatParameter =
    detail::NamedParameter<detail::LimitedParameter<NoInterpFloatParameter, false>,
                           "NoInterpMaxFloat">;

/// A number between two limits, switching as soon as t > 0.
/// Unity: NoInterpClampedFloatParameter (URP 14).
using NoInterpClampedFloatParameter =
    detail::NamedParameter<detail::ClampedParameter<NoInterpFloatParameter>,
                           "NoInterpClampedFloat">;

/// A whole number. A blend is rounded toward zero, unless it misses a whole number by no more than
/// the rounding error of t (0 to 10 at 0.7f is 7). It is clamped to the range of int.
/// Unity: IntParameter (URP 14).
using IntParameter = detail::NamedParameter<detail::LerpParameter<int>, "Int">;

/// A whole number; blending switches as soon as t > 0. Unity: NoInterpIntParameter (URP 14).
using NoInterpIntParameter = detail::NamedParameter<detail::ValueParameter<int>, "NoInterpInt">;

/// A whole number from 0 up to 32 bits, such as the bits of rendering layers; blending switches as
/// soon as t > 0. Unity has no such class; a user derives one from VolumeParameter<uint>.
using UIntParameter = detail::NamedParameter<detail::ValueParameter<std::uint32_t>, "UInt">;

/// A whole number not below a limit. Unity: MinIntParameter (URP 14).
using MinIntParameter =
    detail::NamedParameter<detail::LimitedParameter<IntParameter, true>, "MinInt">;

/// A whole number not above a limit. Unity: MaxIntParameter (URP 14).
using MaxIntParameter =
    detail::NamedParameter<detail::LimitedParameter<IntParameter, false>, "MaxInt">;

/// A whole number between two limits. Unity: ClampedIntParameter (URP 14).
using ClampedIntParameter =
    detail::NamedParameter<detail::ClampedParameter<IntParameter>, "ClampedInt">;

/// A whole number not below a limit, switching as soon as t > 0.
/// Unity: NoInterpMinIntParameter (URP 14).
using NoInterpMinIntParameter =
    detail::NamedParameter<detail::LimitedParameter<NoInterpIntParameter, true>, "NoInterpMinInt">;

/// A whole number not above a limit, switching as soon as t > 0.
/// Unity: NoInterpMaxIntParameter (URP 14).
using NoInterpMaxIntParameter =
    detail::NamedParameter<detail::LimitedParameter<NoInterpIntParameter, false>, "NoInterpMaxInt">;

/// A whole number between two limits, switching as soon as t > 0.
/// Unity: NoInterpClampedIntParameter (URP 14).
using NoInterpClampedIntParameter =
    detail::NamedParameter<detail::ClampedParameter<NoInterpIntParameter>, "NoInterpClampedInt">;

/// Two numbers, from x to y, blended linearly. SetValue(value) and files keep x at or above the
/// first limit and y at or below the second, and nothing else. Unity: FloatRangeParameter (URP 14).
using FloatRangeParameter =
    detail::NamedParameter<detail::ClampedParameter<detail::LerpParameter<glm::vec2>, float>,
                           "FloatRange">;

/// A FloatRangeParameter that switches as soon as t > 0. Unity: NoInterpFloatRangeParameter (URP
/// 14).
using NoInterpFloatRangeParameter =
    detail::NamedParameter<detail::ClampedParameter<detail::ValueParameter<glm::vec2>, float>,
                           "NoInterpFloatRange">;

} // namespace limn
