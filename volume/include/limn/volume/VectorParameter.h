#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limn/volume/ValueParameter.h>

namespace limn
{

/// Two numbers, each blended linearly. Unity: Vector2Parameter (URP 14).
class Vector2Parameter : public detail::LerpParameter<glm::vec2>
{
public:
    using LerpParameter::LerpParameter;
    std::string_view typeName() const override { return "Vector2"; }
};

/// Switches as soon as t > 0. Unity: NoInterpVector2Parameter (URP 14).
class NoInterpVector2Parameter : public detail::ValueParameter<glm::vec2>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "NoInterpVector2"; }
};

/// Three numbers, each blended linearly. Unity: Vector3Parameter (URP 14).
class Vector3Parameter : public detail::LerpParameter<glm::vec3>
{
public:
    using LerpParameter::LerpParameter;
    std::string_view typeName() const override { return "Vector3"; }
};

/// Switches as soon as t > 0. Unity: NoInterpVector3Parameter (URP 14).
class NoInterpVector3Parameter : public detail::ValueParameter<glm::vec3>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "NoInterpVector3"; }
};

/// Four numbers, each blended linearly. Unity: Vector4Parameter (URP 14).
class Vector4Parameter : public detail::LerpParameter<glm::vec4>
{
public:
    using LerpParameter::LerpParameter;
    std::string_view typeName() const override { return "Vector4"; }
};

/// Switches as soon as t > 0. Unity: NoInterpVector4Parameter (URP 14).
class NoInterpVector4Parameter : public detail::ValueParameter<glm::vec4>
{
public:
    using ValueParameter::ValueParameter;
    std::string_view typeName() const override { return "NoInterpVector4"; }
};

} // namespace limn
