#pragma once

#include "spirv/SpirvInstructions.h"

#include <set>

namespace limn
{

// Corrects glslang 12's translation of HLSL's buffers and writable textures, in its SPIR-V before
// it is optimised.

/// Packs the elements of structured buffers as Direct3D does: each member directly behind the one
/// before it, but at a multiple of its component's size. A program on the CPU writes them so;
/// glslang sometimes puts a float3 at a multiple of 16 bytes. Devices need scalarBlockLayout for
/// it.
void PackStructuredBuffers(SpirvWords& spirv);

/// Converts the values that atomic functions add or compare to the type of the memory, where one is
/// int and the other uint (`InterlockedAdd(count, 1)`). The language converts them, but glslang
/// does not.
void ConvertAtomicValues(SpirvWords& spirv);

/// Lets a writable texture have any format with its kind of components, as in Direct3D; glslang
/// declares one by the type in the shader. Textures with one integer keep their format, because
/// atomic functions require one. Devices need shaderStorageImageReadWithoutFormat and the like for
/// writing.
void LeaveImageFormatsOpen(SpirvWords& spirv);

/// Makes compared and other uses of a texture one texture, as in Direct3D. For glslang a compared
/// texture has another type and cannot be passed on as such.
/// @return  true if there were two types of one texture
bool MergeComparedTextures(SpirvWords& spirv);

/// Returns the variables of writable textures that are read.
/// @param spirv  must be optimised, so that no textures pass through variables and parameters any
///     more
std::set<Id> FindReadImages(const SpirvWords& spirv);

} // namespace limn
