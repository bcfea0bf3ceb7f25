#include "preprocess/GlslangSession.h"

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

const char* HalfPreamble(bool halfIs16Bit)
{
    static const auto write = [](const std::string& type)
    {
        std::string text;
        for (const std::string size : {"", "1", "2", "3", "4"})
        {
            text += "#define half" + size + " " + type + size + "\n";
        }
        for (const std::string rows : {"1", "2", "3", "4"})
        {
            for (const std::string columns : {"1", "2", "3", "4"})
            {
                const std::string size = rows + "x" + columns;
                text += "#define half" + size + " float" + size + "\n";
            }
        }
        return text;
    };
    static const std::string s_Float = write("float");
    static const std::string s_Half = write("min16float");
    return (halfIs16Bit ? s_Half : s_Float).c_str();
}

} // namespace limn
