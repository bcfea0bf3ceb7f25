#pragma once

#include <limn/volume/LimitedParameter.h>

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

} // namespace limn
