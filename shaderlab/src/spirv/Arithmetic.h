#pragma once

#include "spirv/SpirvInstructions.h"

namespace limn
{

/// Makes numbers behave as Direct3D says, in SPIR-V as glslang 12 writes it of HLSL, before that is
/// optimised; what uses none of this stays as it is.
///
/// - `fmod(x, y)` and `%` of floats have the sign of x, and are smaller than y; `%` of ints has the
///   sign of what is divided. glslang's go by the divisor.
/// - `round` goes to the even neighbour where two are as near.
/// - `min`, `max`, `clamp` and `saturate` take the operand that is a number where the other is NaN.
/// - `step` of NaN is 0.
/// - Shifts count by the lowest five bits of their right side.
/// - A uint divided by 0 gives 0xffffffff, as does the rest of it. The least int divided by -1 is
///   itself, and no program ends by it.
/// - A float that an int or uint cannot hold becomes the nearest one that it can, NaN becomes 0.
void UseDirect3DArithmetic(SpirvWords& spirv);

} // namespace limn
