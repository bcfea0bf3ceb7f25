#pragma once

#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <gtest/gtest.h>

namespace limn::test
{

/// A program with entry functions of these names, whose SPIR-V is expected to be valid.
inline std::shared_ptr<const ShaderProgram>
CompileEntries(const std::string& text, const char* vertex, const char* fragment,
               const std::vector<std::string>& keywords = {},
               ProgramLanguage language = ProgramLanguage::Cg)
{
    PassProgram program = Program(text, language);
    program.vertex.name = vertex;
    program.fragment.name = fragment;
    ShaderCompiler compiler;
    auto pass = compiler.Compile(program, keywords);
    EXPECT_EQ(ValidationMessages(pass->vertexSpirv), "");
    EXPECT_EQ(ValidationMessages(pass->fragmentSpirv), "");
    return pass;
}

/// A program of the built-in pipeline, whose SPIR-V is expected to be valid.
inline std::shared_ptr<const ShaderProgram> CompileCg(const std::string& text,
                                                      const std::vector<std::string>& keywords = {})
{
    return CompileEntries(text, "vert", "frag", keywords);
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
