#pragma once

#include <cstdint>
#include <vector>

namespace limn
{

/// Makes what is marked RelaxedPrecision (HLSL's min16float) real 16-bit floats, in SPIR-V as
/// glslang writes it, before it is optimised.
///
/// Everything keeps its 32-bit type, so that buffers, inputs and outputs need no 16-bit storage;
/// but a value that goes into a relaxed variable, parameter or result is rounded to 16 bits, and an
/// operation on relaxed values and constants alone is done on 16-bit floats. One that has a 32-bit
/// operand is done in 32 bits, as HLSL promotes. Matrices, derivatives and texture functions stay
/// in 32 bits until they are assigned.
std::vector<std::uint32_t> UseHalfPrecision(const std::vector<std::uint32_t>& spirv);

} // namespace limn
