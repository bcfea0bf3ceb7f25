#pragma once

#include "material/UniformPlace.h"
#include "resolve/DrawResolver.h"

#include <span>

namespace limn
{

/// Writes one value of a uniform buffer. A name that nothing has set is zero, except for `X_ST` and
/// `X_HDR` (1, 1, 0, 0) and `X_TexelSize` (1/width, 1/height, width, height of the texture bound to
/// X).
/// @param value    null = nothing has set it
/// @param texture  the texture X, if the value is not set; null = nothing has set that either
/// @param buffer   all bytes that UniformPlace::offset counts
/// @return false if the value's kind does not fit; then it is zero
bool WriteUniform(const UniformPlace& member, const ShaderPropertyValue* value,
                  const ShaderPropertyValue* texture, std::span<std::byte> buffer);

/// Writes the value that the sources have.
/// @throws DrawError naming material and property, if the value's kind does not fit
void WriteUniform(const UniformPlace& member, const PropertySources& sources,
                  std::span<std::byte> buffer);

/// Writes a buffer called k_DynamicKeywordBuffer: 1 for each keyword that the material has on, or
/// the globals have.
/// @param bytes  the bytes of the whole buffer
void WriteDynamicKeywords(const UniformBuffer& buffer, const PropertySources& sources,
                          std::span<std::byte> bytes);

} // namespace limn
