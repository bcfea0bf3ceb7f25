#pragma once

#include "resolve/DrawResolver.h"

#include <limn/core/DrawError.h>

namespace limn
{

// These are the values of a draw or dispatch that are bound as they are: textures and buffers.

/// Returns the texture that a property is set to; null if it is not set.
/// @throws DrawError if it is set to something else
std::shared_ptr<const Texture> FindTexture(ShaderPropertyId id, const PropertySources& sources);
/// Returns the buffer that a property is set to; null if it is not set, or set to none.
/// @throws DrawError if it is set to something else
const BufferRange* FindBuffer(ShaderPropertyId id, const PropertySources& sources);

// All of these throw DrawError for values that do not fit.
BufferSlot UniformSlot(const UniformBuffer& declared, const BufferRange& range,
                       const PropertySources& sources);
BufferSlot StorageSlot(const StorageBufferBinding& declared, ShaderPropertyId id,
                       const PropertySources& sources);
BufferSlot ArgumentsSlot(const BufferRange& arguments, const PropertySources& sources);
StorageTextureSlot WritableSlot(const StorageTextureBinding& declared, ShaderPropertyId id,
                                const PropertySources& sources);

/// @param declared  the type that the shader uses for its components
/// @throws DrawError if they have another type, or the texture another dimension
void ExpectFits(UniformType declared, TextureDimension dimension, const Texture& texture,
                ShaderPropertyId id, const PropertySources& sources);

/// Throws for a value that is not set and has no default.
/// @param kind  "texture"
template <typename Result>
[[noreturn]] std::shared_ptr<const Result> FailUnset(ShaderPropertyId id, const char* kind,
                                                     const PropertySources& sources)
{
    throw DrawError(sources.Subject() + ": " + kind + " '" + id.name() +
                    "' is not set, and nothing is global under that name");
}

} // namespace limn
