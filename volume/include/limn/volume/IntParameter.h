#pragma once

#include <cstdint>
#include <limn/volume/LimitedParameter.h>

namespace limn
{

/// A whole number; a blend is rounded toward zero, or to the whole number that it misses by no more
/// than t is rounded (0 to 10 at 0.7f is 7), and stops at the greatest and the least int.
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
/// soon as t > 0. Unity: a class of one's own that derives from VolumeParameter<uint>.
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

} // namespace limn
