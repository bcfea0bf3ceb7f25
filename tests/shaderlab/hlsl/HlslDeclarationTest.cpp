#include "Mentions.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::Mentions;
using testing::ElementsAre;

const std::string k_PlainVertex = "float4 vert(float4 p : POSITION) : SV_POSITION { return p; }\n";

std::shared_ptr<const ShaderProgram> CompileDeclarations(const std::string& hlsl)
{
    auto pass = test::CompileHlsl(k_PlainVertex + hlsl);
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    EXPECT_EQ(test::Messages(pass->diagnostics), std::vector<std::string>{});
    return pass;
}

} // namespace

TEST(HlslDeclaration, MayBeRepeatedWhereItIsEqual)
{
    const auto pass = CompileDeclarations(R"(
        uniform float4 _Map_TexelSize;
        float4 _Map_TexelSize;
        Texture2D _Map; SamplerState sampler_Map;
        float _Steps[3];
        SamplerState sampler_Map;
        Texture2D _Map;
        float _Steps[3];
        float4 frag() : SV_Target
        {
            return _Map.Sample(sampler_Map, _Map_TexelSize.xy) * _Steps[1];
        })");
    ASSERT_EQ(pass->layout.buffers.size(), 1U);
    EXPECT_EQ(pass->layout.buffers[0].members.size(), 2U);
    EXPECT_EQ(pass->layout.textures.size(), 1U);
    EXPECT_EQ(pass->layout.samplers.size(), 1U);
}

TEST(HlslDeclaration, MayBeRepeatedInAList)
{
    const std::string body = "\nfloat4 frag() : SV_Target { return _A + _B.x + _C; }";
    for (const std::string text :
         {"float4 _A, _C;\nfloat2 _B;\nfloat4 _A, _C;", "float4 _A;\nfloat2 _B;\nfloat4 _A, _C;",
          "float4 _C;\nfloat2 _B;\nfloat4 _A, _C;",
          "float4 _A;\nfloat2 _B, _B;\nfloat4 _A, _C, _A;",
          "float4 _A, _C;\nfloat2 _B;\nfloat4 _A;"})
    {
        const auto pass = CompileDeclarations(text + body);
        ASSERT_EQ(pass->layout.buffers.size(), 1U) << text;
        EXPECT_EQ(pass->layout.buffers[0].members.size(), 3U) << text;
    }
    for (const std::string text : {"float4 _A, _B;\ncbuffer C { float4 _C; float4 _B, _A; };",
                                   "cbuffer C { float4 _B, _C; float4 _A; };\nfloat4 _A, _B;"})
    {
        const auto pass =
            CompileDeclarations(text + "\nfloat4 frag() : SV_Target { return _A + _B + _C; }");
        ASSERT_EQ(pass->layout.buffers.size(), 1U) << text;
        EXPECT_EQ(pass->layout.buffers[0].name, "C") << text;
        EXPECT_EQ(pass->layout.buffers[0].members.size(), 3U) << text;
    }
}

TEST(HlslDeclaration, OfAnAuthorMayRepeatOneOfLimns)
{
    for (const std::string core : {"Common.hlsl", "SpaceTransforms.hlsl"})
    {
        const auto pass = CompileDeclarations(
            "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n"
            "float4 _Time, _SinTime, _CosTime;\nfloat4x4 unity_MatrixVP, unity_MatrixV;\n"
            "float3 _WorldSpaceCameraPos;\n#include "
            "\"Packages/com.unity.render-pipelines.core/ShaderLibrary/" +
            core +
            "\"\nfloat4 frag() : SV_Target { return mul(unity_MatrixVP, _Time) + _SinTime; }");
        EXPECT_EQ(pass->layout.buffers.size(), 1U) << core;
    }
}

TEST(HlslDeclaration, RepeatedInABufferStaysInTheBuffer)
{
    for (const std::string text :
         {"float4 _A;\ncbuffer UnityPerMaterial { float4 _B; float4 _A; };",
          "cbuffer UnityPerMaterial { float4 _B; float4 _A; };\nfloat4 _A;"})
    {
        const auto pass =
            CompileDeclarations(text + "\nfloat4 frag() : SV_Target { return _A + _B; }");
        ASSERT_EQ(pass->layout.buffers.size(), 1U) << text;
        EXPECT_EQ(pass->layout.buffers[0].name, "UnityPerMaterial");
        EXPECT_EQ(pass->layout.buffers[0].members.at(1).name, "_A");
        EXPECT_EQ(pass->layout.buffers[0].members.at(1).offset, 16U);
    }
}

TEST(HlslDeclaration, OfAUniformWithATakenNameIsAnError)
{
    const auto messages = [](const std::string& declarations)
    {
        return test::CompileMessages(test::Program(k_PlainVertex + declarations +
                                                   "\nfloat4 frag() : SV_Target { return 1; }"));
    };
    const auto redefined = [](const std::string& place)
    {
        return ElementsAre(Mentions(place + ": error: '_A'", "redefinition"));
    };
    EXPECT_THAT(messages("float4 _A;\nfloat3 _A;"), redefined("t.shader:3:8"));
    EXPECT_THAT(messages("Texture2D _A;\nfloat3 _A;"), redefined("t.shader:3:8"));
    EXPECT_THAT(messages("struct _A { float a; };\nfloat3 _A;"), redefined("t.shader:3:8"));
    EXPECT_THAT(messages("static float4 _A = 1;\nfloat4 _A;"), redefined("t.shader:3:8"));
    EXPECT_THAT(messages("float4 _A, _B;\nfloat _A[2], _C;"), redefined("t.shader:3:7"));
    EXPECT_THAT(messages("cbuffer C { float4 _A; };\nfloat3 _A;"), redefined("t.shader:3:8"));
    EXPECT_THAT(messages("float4 _A[2];\nfloat4 _A, _B;"), redefined("t.shader:3:8"));
}

TEST(HlslDeclaration, OfAMethodCannotBeCalledOnAResult)
{
    EXPECT_THAT(test::CompileMessages(test::Program(
                    k_PlainVertex + "struct S { float a; float Get() { return a; } };\n"
                                    "S Make() { S s; s.a = 1; return s; }\n"
                                    "float4 frag() : SV_Target { return Make().Get(); }")),
                ElementsAre(Mentions("t.shader:4:43: error: 'Get'", "a method", "in a variable")));
    CompileDeclarations("struct S { float a; float Get() { return a; } };\n"
                        "S Make() { S s; s.a = 1; return s; }\n"
                        "float4 frag() : SV_Target { S s = Make(); return s.Get(); }");
}

TEST(HlslDeclaration, OfATextureOrBufferMayStandInACbuffer)
{
    const auto pass = CompileDeclarations(R"(
        cbuffer UnityPerMaterial
        {
            float4 _A;
            StructuredBuffer<float4> _Points;
            Texture2D<float4> _Map : register(t3);
            SamplerState sampler_Map;
            float4 _B;
        }
        float4 frag() : SV_Target
        {
            return _Points[2] * _B + _Map.Sample(sampler_Map, _A.xy);
        })");
    ASSERT_EQ(pass->layout.buffers.size(), 1U);
    EXPECT_EQ(pass->layout.buffers[0].members.at(1).name, "_B");
    EXPECT_EQ(pass->layout.buffers[0].members.at(1).offset, 16U);
    EXPECT_EQ(pass->layout.storageBuffers.at(0).name, "_Points");
    EXPECT_EQ(pass->layout.storageBuffers.at(0).stride, 16U);
    EXPECT_EQ(pass->layout.textures.at(0).name, "_Map");
    EXPECT_EQ(pass->layout.samplers.at(0).name, "sampler_Map");
}

TEST(HlslDeclaration, ByAnUnknownMacroIsAnErrorAtItsLine)
{
    const std::string frag = "\nfloat4 frag() : SV_Target { return hash(1); }";
    const std::string hash = "\nuint hash(uint x) { return x; }";
    const auto message = [](const std::string& place, const std::string& name)
    {
        return Mentions("t.shader:" + place + ": error: '" + name + "'", "unknown macro");
    };
    EXPECT_THAT(test::CompileMessages(
                    test::Program(k_PlainVertex + hash + "\n UNKNOWN(_A);\nOTHER(_B, (1))" + frag)),
                ElementsAre(message("4:2", "UNKNOWN"), message("5:1", "OTHER")));
    EXPECT_THAT(test::CompileMessages(test::Program(
                    k_PlainVertex + hash + "\ncbuffer C { float4 _A; PROP(float4, _B) };" + frag)),
                ElementsAre(message("4:24", "PROP")));
}

TEST(HlslDeclaration, OfATemplateIsAnError)
{
    EXPECT_THAT(
        test::CompileMessages(test::Program(
            k_PlainVertex + "float4 _Tint;\n"
                            "template<typename T> void Set(inout T x) { x = 2; }\n"
                            " template <class T> struct Pair { T a; T b; };\n"
                            "float4 frag() : SV_Target { Set(_Tint); return _Tint; }")),
        ElementsAre(Mentions("t.shader:3:1: error: 'template'", "no templates", "each type"),
                    Mentions("t.shader:4:2: error: 'template'", "no templates", "each type")));
}

TEST(HlslDeclaration, OfAnInterfaceIsAnError)
{
    EXPECT_THAT(
        test::CompileMessages(test::Program(k_PlainVertex +
                                            "interface I { float F(float x); };\n"
                                            "class A : I { float F(float x) { return x; } };\n"
                                            "float4 frag() : SV_Target { A a; return a.F(1); }")),
        ElementsAre(Mentions("t.shader:2:1: error: 'interface'", "no interfaces", "methods")));
}

TEST(HlslDeclaration, OfAMatrixOfBoolIsAnErrorWhereItIsUsed)
{
    const std::string fill = "float Fill(int n) { return ((bool2x2)n)[0].x ? 1 : 0; }\n";
    EXPECT_THAT(
        test::CompileMessages(
            test::Program(k_PlainVertex + fill + "float4 frag() : SV_Target { return Fill(1); }")),
        ElementsAre(Mentions("t.shader:2:30: error: 'bool2x2'", "matrices of bool", "'float2x2'")));
    CompileDeclarations(fill + "float4 frag() : SV_Target { return 1; }");
}

TEST(HlslDeclaration, OfAMatrixOfOneRowOrColumnIsAnErrorWhereItIsUsed)
{
    EXPECT_THAT(test::CompileMessages(test::Program(
                    k_PlainVertex + "float4x1 _Unused; matrix<int, 1, 3> _M;\n"
                                    "float4 frag() : SV_Target { return _M[0].xyzz; }")),
                ElementsAre(Mentions("t.shader:2:1: error: 'float4x1'", "one row", "'float4'"),
                            Mentions("t.shader:2:19: error: 'matrix'", "one row", "'int3'")));
}

TEST(HlslDeclaration, OfClipSpaceFunctionsNeedsNoIncludeInCg)
{
    const auto pass = test::CompileHlsl(
        "float4 vert(float4 p : POSITION) : SV_POSITION { return UnityObjectToClipPos(p); }\n"
        "fixed4 frag() : SV_Target { return 1; }",
        ProgramLanguage::Cg);
    EXPECT_EQ(test::ValidationMessages(pass->vertexSpirv), "");
}

} // namespace limn
