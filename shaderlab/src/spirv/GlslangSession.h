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

} // namespace limn
