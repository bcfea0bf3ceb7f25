#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include <string>
#include <vector>

namespace limn
{

/// Compiles rewritten HLSL to optimised SPIR-V 1.3 with the entry point "main". Unused inputs,
/// buffers and textures are not declared.
///
/// @param file      the file of messages that have no place of their own
/// @param halfIs16Bit  see ShaderCompilerOptions
/// @param warnings  receives those of the compiler
/// @throws AssetError with the compiler's errors, or if the result is not valid
std::vector<std::uint32_t> BuildSpirv(const std::string& hlsl, ShaderStage stage,
                                      const std::string& file, bool halfIs16Bit,
                                      std::vector<Diagnostic>& warnings);

} // namespace limn
