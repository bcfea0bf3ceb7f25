#pragma once

#include "resolve/DrawResolver.h"

#include <limn/core/DrawError.h>

namespace limn
{

// What of a draw's or dispatch's values is bound as it is: textures and buffers.

/// The texture that a property is set to; null where it is not.
/// @throws DrawError if it is set to something else
std::shared_ptr<const Texture> FindTexture(ShaderPropertyId id, const PropertySources& sources);
/// The buffer that a property is set to; null where it is not, or to none.
/// @throws DrawError if it is set to something else
const BufferRange* FindBuffer(ShaderPropertyId id, const PropertySources& sources);

// All throw DrawError for what does not fit.
BufferSlot UniformSlot(const UniformBuffer& declared, const BufferRange& range,
                       const PropertySources& sources);
BufferSlot StorageSlot(const StorageBufferBinding& declared, ShaderPropertyId id,
                       const PropertySources& sources);
BufferSlot ArgumentsSlot(const BufferRange& arguments, const PropertySources& sources);
StorageTextureSlot WritableSlot(const StorageTextureBinding& declared, ShaderPropertyId id,
                                const PropertySources& sources);

/// @param declared  what the shader takes its components for
/// @throws DrawError if they are something else
void ExpectComponents(UniformType declared, const Texture& texture, ShaderPropertyId id,
                      const PropertySources& sources);

/// For what there is no default of.
/// @param kind  "texture"
template <typename Result>
[[noreturn]] std::shared_ptr<const Result> FailUnset(ShaderPropertyId id, const char* kind,
                                                     const PropertySources& sources)
{
    throw DrawError(sources.Subject() + ": " + kind + " '" + id.name() +
                    "' is not set, and nothing is global under that name");
}

} // namespace limn
