#pragma once

#include "spirv/SpirvInstructions.h"

namespace limn
{

/// Turns values marked RelaxedPrecision (HLSL's min16float) into real 16-bit floats, in the SPIR-V
/// that glslang writes, before it is optimised.
///
/// Everything keeps its 32-bit type, so that buffers, inputs and outputs need no 16-bit storage;
/// but a value that goes into a relaxed variable, parameter or result is rounded to 16 bits, and an
/// operation on only relaxed values and constants uses 16-bit floats. An operation with a 32-bit
/// operand uses 32 bits, as HLSL promotes. Matrices, derivatives and texture functions stay in 32
/// bits until they are assigned.
void UseHalfPrecision(SpirvWords& spirv);

} // namespace limn
