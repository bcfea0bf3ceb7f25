#pragma once

#include <limn/core/QualitySettings.h>
#include <limn/shaderlab/ShaderCompiler.h>

namespace limn
{

/// Compiles a pass or kernel for a set of keywords and for the colour space of the process.
inline std::shared_ptr<const ShaderProgram> CompileVariant(ShaderCompiler& compiler,
                                                           const PassProgram& program,
                                                           std::vector<std::string> variant)
{
    if (QualitySettings::activeColorSpace() == ColorSpace::Gamma)
    {
        variant.emplace_back("UNITY_COLORSPACE_GAMMA");
    }
    return compiler.Compile(program, variant);
}

} // namespace limn
