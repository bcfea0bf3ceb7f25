#pragma once

#include <glm/vec2.hpp>
#include <limn/volume/ValueParameter.h>

namespace limn
{

namespace detail
{

/// Limits a pair as Unity does: x only from below and y only from above, not x by y.
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

/// The same, switching as soon as t > 0. Unity: NoInterpFloatRangeParameter (URP 14).
class NoInterpFloatRangeParameter : public detail::RangeLimited<detail::ValueParameter<glm::vec2>>
{
public:
    using RangeLimited::RangeLimited;
    std::string_view typeName() const override { return "NoInterpFloatRange"; }
};

} // namespace limn
