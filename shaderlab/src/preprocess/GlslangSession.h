#pragma once

#include <limn/base/Diagnostic.h>
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

/// Sets the languages of a shader: from HLSL to SPIR-V 1.3 for Vulkan 1.1 (for 1.4 and above
/// glslang 12 emits invalid buffer blocks).
void SetEnvironment(glslang::TShader& shader, ShaderStage stage);

/// Returns the definitions of `half` that come before a program and are no lines of it. As on
/// Unity's desktop targets it is float. These are macros, because the compiler's own half marks
/// values as low precision and lets a driver compute them with fewer bits. With 16 bits that is
/// intended, and matrices stay float.
const char* HalfPreamble(bool halfIs16Bit);

/// Returns the messages of a glslang log as diagnostics: one per line of source, without glslang's
/// summaries and with types spelt as in HLSL. A message without a place gets `fallbackFile`.
std::vector<Diagnostic> ReadGlslangLog(std::string_view log, const std::string& fallbackFile);

} // namespace limn
