#pragma once

#include <limn/core/MaterialPropertyBlock.h>
#include <limn/core/QualitySettings.h>
#include <string_view>

namespace limn
{

/// Returns the value as the kind that the caller expects, or else that kind's default. The pointer
/// may be null.
template <typename Kind>
Kind CopyOf(const ShaderPropertyValue* value)
{
    const auto* kind = std::get_if<Kind>(value);
    return kind != nullptr ? *kind : Kind{};
}

/// Returns a colour of the process's colour space as sRGB.
inline Color FromActiveColorSpace(const Color& color)
{
    return QualitySettings::activeColorSpace() == ColorSpace::Linear ? color.gamma() : color;
}

/// Returns whether all numbers of the value are finite; textures have none.
bool isFinite(const ShaderPropertyValue& value);
/// Returns whether the value is an array without elements, which Unity does not accept.
bool isEmptyArray(const ShaderPropertyValue& value);

/// Requires a value to be finite where it is set, since a shader silently spreads NaN and infinity.
/// @param owner  the beginning of the message: "material 'Paint': "
/// @throws ContractError if a number of the value is not finite, or an array has no elements
void RequireFinite(const ShaderPropertyValue& value, ShaderPropertyId id,
                   std::string_view owner = {});

/// Returns the texture to which a handle sets a property; null for an empty handle.
/// @param owner  as above
/// @throws ContractError if it wraps an identifier
std::shared_ptr<const Texture> TextureOf(const RTHandle& handle, ShaderPropertyId id,
                                         std::string_view owner = {});

} // namespace limn
