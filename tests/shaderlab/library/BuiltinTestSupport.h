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

/// Keywords of SpeedTree 8: none, and such sets that each keyword is in one.
inline const std::vector<std::string> k_Tree8Variants[] = {
    {},
    {"EFFECT_BUMP", "EFFECT_EXTRA_TEX", "EFFECT_HUE_VARIATION", "EFFECT_SUBSURFACE",
     "_WINDQUALITY_BEST", "LOD_FADE_PERCENTAGE"},
    {"_WINDQUALITY_PALM", "EFFECT_SUBSURFACE", "EFFECT_BACKSIDE_NORMALS"},
    {"_WINDQUALITY_FAST", "EFFECT_BACKSIDE_NORMALS", "EFFECT_BUMP"},
    {"_WINDQUALITY_NONE", "EFFECT_HUE_VARIATION"},
    {"EFFECT_BILLBOARD", "_WINDQUALITY_FASTEST", "EFFECT_BACKSIDE_NORMALS"},
};

} // namespace limn::test
