#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include <glslang/Public/ShaderLang.h>

namespace limn
{

inline constexpr EShMessages k_GlslangMessages =
    static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules |
                             EShMsgHlslOffsets | EShMsgHlslDX9Compatible | EShMsgCascadingErrors);

/// Starts glslang on the first call of the process, so that a program that only loads from the
/// cache never pays for it.
void StartGlslang();

EShLanguage GlslangStage(ShaderStage stage);

/// HLSL in, SPIR-V 1.3 for Vulkan 1.1 out (at 1.4 and above glslang 12 emits invalid buffer
/// blocks).
void SetEnvironment(glslang::TShader& shader, ShaderStage stage);

/// Definitions that come before a program, no lines of it: what `half` is. As on Unity's desktop
/// targets it is float. Macros rather than the compiler's own half, which marks values as low
/// precision and lets a driver compute them with fewer bits; with 16 bits that is what is wanted,
/// and matrices stay float.
const char* HalfPreamble(bool halfIs16Bit);

} // namespace limn
