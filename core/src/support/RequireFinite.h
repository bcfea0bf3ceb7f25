#pragma once

#include <limn/core/MaterialPropertyBlock.h>
#include <string_view>

namespace limn
{

/// Whether all numbers of the value are finite; textures have none.
bool isFinite(const ShaderPropertyValue& value);
/// Whether it is an array without elements, which Unity refuses.
bool isEmptyArray(const ShaderPropertyValue& value);

/// Where values enter: a shader makes nothing of NaN and infinity but more of them, without a word.
/// @param owner  what the message begins with: "material 'Paint': "
/// @throws ContractError if a number of the value is not finite, or an array has no elements
void RequireFinite(const ShaderPropertyValue& value, ShaderPropertyId id,
                   std::string_view owner = {});

/// What a property is set to by a handle; null by an empty one.
/// @param owner  as above
/// @throws ContractError if it wraps an identifier
std::shared_ptr<const Texture> TextureOf(const RTHandle& handle, ShaderPropertyId id,
                                         std::string_view owner = {});

} // namespace limn
