#include "spirv/ScalarLayout.h"
#include "Mentions.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <gtest/gtest.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

namespace limn::test
{

namespace
{

/// An element of a structured buffer: what is declared before it, its type, and a float4 of `e`.
struct Element
{
    const char* declarations;
    const char* type;
    const char* value;
    std::uint32_t stride;
    bool isScalar; ///< lies closer than devices without scalarBlockLayout read
};

constexpr Element k_Elements[] = {
    {"", "float", "e", 4, false},
    {"", "float2", "e.xyxy", 8, false},
    {"", "float3", "e.xyzz", 12, true},
    {"", "float4", "e", 16, false},
    {"struct E { float3 a; float3 b; float c; };", "E", "float4(e.a + e.b, e.c)", 28, true},
    {"struct E { float4 a; float4 b; float2 c; };", "E", "e.a + e.b + e.c.xyxy", 40, true},
    {"struct E { float4 a; float3 b; float3 c; float d; };", "E", "e.a + float4(e.b + e.c, e.d)",
     44, true},
    {"struct E { float3 a; float b; };", "E", "float4(e.a, e.b)", 16, false},
    {"struct E { float a; float3 b; };", "E", "float4(e.b, e.a)", 16, false},
    {"struct E { float2 a; float b; };", "E", "float4(e.a, e.b, 1)", 12, true},
    {"struct E { float a; float2 b; };", "E", "float4(e.b, e.a, 1)", 12, true},
    {"struct E { float a[3]; uint b; };", "E", "e.a[2] + e.b", 16, false},
    {"struct E { float3 a[2]; float2 b; };", "E", "float4(e.a[1], e.b.x)", 32, true},
    {"struct E { float4x4 a; float3 b; float c; };", "E", "mul(e.a, float4(e.b, e.c))", 80, false},
    {"struct I { float3 a; float b; }; struct E { I x; I y; float4 z; };", "E",
     "float4(e.x.a, e.y.b) + e.z", 48, false},
    {"struct I { float3 a; float b; }; struct E { float4 z; float w; I x; };", "E",
     "float4(e.x.a, e.w) + e.z", 36, true},
};

std::string Hlsl(const Element& element)
{
    return std::string(element.declarations) + "\nStructuredBuffer<" + element.type +
           "> _Elements;\nfloat4 vert(float4 p : POSITION) : SV_POSITION { return p; }\n"
           "float4 frag(float4 p : SV_POSITION) : SV_Target\n{\n    " +
           element.type + " e = _Elements[(uint)p.x];\n    return " + element.value + ";\n}\n";
}

bool isValidWithoutScalarLayout(const std::vector<std::uint32_t>& spirv)
{
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    tools.SetMessageConsumer([](auto&&...) {});
    return tools.Validate(spirv.data(), spirv.size(), spvtools::ValidatorOptions());
}

} // namespace

TEST(ScalarLayout, IsAskedForWhereTheValidatorAsksForIt)
{
    for (const Element& element : k_Elements)
    {
        SCOPED_TRACE(Hlsl(element));
        const auto pass = CompileHlsl(Hlsl(element));
        ASSERT_EQ(pass->layout.storageBuffers.size(), 1u);
        EXPECT_EQ(pass->layout.storageBuffers[0].stride, element.stride);
        EXPECT_EQ(ValidationMessages(pass->fragmentSpirv), "");
        EXPECT_EQ(isValidWithoutScalarLayout(pass->fragmentSpirv), !element.isScalar);
        EXPECT_EQ(ScalarBuffers(pass->fragmentSpirv), element.isScalar ? "_Elements" : "");
    }
}

TEST(ScalarLayout, IsRefusedInASentenceWhereTheDeviceLacksIt)
{
    const TemporaryFolder folder;
    ShaderCompilerOptions lacking;
    lacking.cacheFolder = folder.path(); // what is in it may come from another device's compiler
    lacking.missingFeatures = {"scalarblocklayout"};
    ShaderCompilerOptions full;
    full.cacheFolder = folder.path();
    for (const Element& element : k_Elements)
    {
        SCOPED_TRACE(element.declarations);
        const PassProgram program = Program(Hlsl(element));
        EXPECT_NO_THROW(ShaderCompiler(full).Compile(program));
        ShaderCompiler compiler(lacking);
        if (!element.isScalar)
        {
            EXPECT_NO_THROW(compiler.Compile(program));
            continue;
        }
        try
        {
            compiler.Compile(program);
            ADD_FAILURE() << "it was compiled";
        }
        catch (const UnsupportedProgramError& error)
        {
            EXPECT_THAT(ToString(error.diagnostics().at(0)),
                        Mentions("t.shader:1:1: error: program", "scalarBlockLayout", "_Elements",
                                 "16 bytes"));
        }
    }
}

// What each draw reads of its own lies so that any device can read it.
TEST(ScalarLayout, IsNothingThatLimnsOwnBuffersNeed)
{
    ShaderCompilerOptions lacking;
    lacking.missingFeatures = {"scalarblocklayout"};
    EXPECT_NO_THROW(ShaderCompiler(lacking).Compile(Program(R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        float4 vert(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }
        float4 frag() : SV_Target { return unity_ObjectToWorld[0]; })")));
}

} // namespace limn::test
