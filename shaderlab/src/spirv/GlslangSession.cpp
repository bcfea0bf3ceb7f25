#include "spirv/GlslangSession.h"

#include <mutex>

namespace limn
{

void StartGlslang()
{
    static std::once_flag started;
    std::call_once(started, [] { glslang::InitializeProcess(); });
}

EShLanguage GlslangStage(ShaderStage stage)
{
    return stage == ShaderStage::Vertex     ? EShLangVertex
           : stage == ShaderStage::Geometry ? EShLangGeometry
           : stage == ShaderStage::Compute  ? EShLangCompute
                                            : EShLangFragment;
}

void SetEnvironment(glslang::TShader& shader, ShaderStage stage)
{
    shader.setEnvInput(glslang::EShSourceHlsl, GlslangStage(stage), glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
}

} // namespace limn
