#pragma once

#include <limn/core/MaterialPropertyBlock.h>

namespace limn
{

// These return a property's value as the kind that the caller expects. Pointers may be null.

/// Returns the value, or null if there is none of this kind.
template <typename Kind>
const Kind* As(const ShaderPropertyValue* value)
{
    return value != nullptr ? std::get_if<Kind>(value) : nullptr;
}

template <typename Kind>
Kind CopyOf(const ShaderPropertyValue* value)
{
    const auto* kind = As<Kind>(value);
    return kind != nullptr ? *kind : Kind{};
}

template <typename Element>
std::vector<Element> ArrayIn(const ShaderPropertyValue* value)
{
    const auto* array = As<PropertyArray<Element>>(value);
    return array != nullptr ? std::vector<Element>(array->begin(), array->end())
                            : std::vector<Element>();
}

} // namespace limn
