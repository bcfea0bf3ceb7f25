#pragma once

#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <memory>
#include <string>

namespace limn::test
{

inline const std::string k_Vertex = R"(
    struct v2f { float4 pos : SV_POSITION; float2 uv : TEXCOORD0; };
    v2f vert(float4 p : POSITION, float2 uv : TEXCOORD0)
    {
        v2f o; o.pos = p; o.uv = uv; return o;
    }
)";

/// Compiles, validates and asks for no warning.
inline std::shared_ptr<const ShaderProgram>
CompileValid(const std::string& hlsl, ProgramLanguage language = ProgramLanguage::Hlsl)
{
    auto pass = CompileHlsl(hlsl, language);
    EXPECT_EQ(ValidationMessages(pass->vertexSpirv), "");
    EXPECT_EQ(ValidationMessages(pass->fragmentSpirv), "");
    EXPECT_EQ(Messages(pass->diagnostics), std::vector<std::string>{});
    return pass;
}

inline std::shared_ptr<const ShaderProgram> CompileFragment(const std::string& hlsl)
{
    return CompileValid(k_Vertex + hlsl, ProgramLanguage::Cg);
}

inline const UniformMember& Member(const ShaderProgram& pass, const std::string& name)
{
    for (const UniformBuffer& buffer : pass.layout.buffers)
    {
        for (const UniformMember& member : buffer.members)
        {
            if (member.name == name)
            {
                return member;
            }
        }
    }
    throw ContractError("no uniform '" + name + "'");
}

} // namespace limn::test
