#pragma once

#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <gtest/gtest.h>

namespace limn::test
{

/// A program of the built-in pipeline, whose SPIR-V is expected to be valid.
inline std::shared_ptr<const ShaderProgram> CompileCg(const std::string& text,
                                                      const std::vector<std::string>& keywords = {})
{
    ShaderCompiler compiler;
    const auto pass = compiler.Compile(Program(text, ProgramLanguage::Cg), keywords);
    EXPECT_EQ(ValidationMessages(pass->vertexSpirv), "");
    EXPECT_EQ(ValidationMessages(pass->fragmentSpirv), "");
    return pass;
}

inline std::vector<std::string> TextureNames(const ShaderProgram& pass)
{
    std::vector<std::string> names;
    for (const auto& texture : pass.layout.textures)
    {
        names.push_back(texture.name);
    }
    return names;
}

} // namespace limn::test
