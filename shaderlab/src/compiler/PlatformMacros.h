#pragma once

namespace limn
{

// What options come to in HLSL: on as keywords are, and with them in the cache's key.

/// ShaderCompilerOptions::usesReversedZBuffer is off.
inline constexpr const char* k_StandardZMacro = "LIMN_STANDARD_Z";
/// ShaderCompilerOptions::halfIs16Bit is on.
inline constexpr const char* k_RealHalfMacro = "LIMN_REAL_HALF";

} // namespace limn
