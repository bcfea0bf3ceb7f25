#pragma once

#include "spirv/SpirvInstructions.h"

namespace limn
{

/// Makes numbers behave as Direct3D specifies, in the SPIR-V that glslang 12 writes for HLSL,
/// before it is optimised. Other code stays as it is.
///
/// - `fmod(x, y)` and `%` of floats have the sign of x, and are smaller than y; `%` of ints has the
///   sign of the dividend. glslang's have that of the divisor.
/// - `round` rounds to the even neighbour if two are equally near.
/// - `min`, `max`, `clamp` and `saturate` return the operand that is a number if the other is NaN.
/// - `step` of NaN is 0.
/// - Shifts use the lowest five bits of their right side.
/// - A uint divided by 0 gives 0xffffffff, and so does its remainder. The least int divided by -1
/// is
///   itself and does not end the program.
/// - A float that an int or uint cannot hold becomes the nearest value that it can hold; NaN
///   becomes 0.
void UseDirect3DArithmetic(SpirvWords& spirv);

} // namespace limn
