#pragma once

#include "spirv/SpirvInstructions.h"

#include <set>

namespace limn
{

// What glslang 12 makes of HLSL's buffers and writable textures, put right in its SPIR-V before
// that is optimised.

/// Elements of structured buffers as Direct3D packs them: each member right behind the one before
/// it, but at a multiple of its component's size. A program on the CPU writes them so; glslang puts
/// a float3 at a multiple of 16 bytes now and then. Devices need scalarBlockLayout for it.
void PackStructuredBuffers(SpirvWords& spirv);

/// Values that atomic functions add or compare are int where memory is uint, or the other way round
/// (`InterlockedAdd(count, 1)`): the language converts them, glslang leaves them.
void ConvertAtomicValues(SpirvWords& spirv);

/// A writable texture takes any format that has its kind of components, as in Direct3D, where
/// glslang names one after the type in the shader. Those of one integer keep it: atomic functions
/// ask for one. Devices need shaderStorageImageReadWithoutFormat and its like for writing.
void LeaveImageFormatsOpen(SpirvWords& spirv);

/// A texture is one, compared or not, as in Direct3D; to glslang it is of another type where it is
/// compared, and cannot be handed on as what it is then.
/// @return  whether there were two types of one texture
bool MergeComparedTextures(SpirvWords& spirv);

/// The variables of writable textures that are read.
/// @param spirv  optimised: nothing travels through variables and parameters any more
std::set<Id> FindReadImages(const SpirvWords& spirv);

} // namespace limn
