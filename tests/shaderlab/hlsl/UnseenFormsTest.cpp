#include "Mentions.h"
#include "hlsl/DialectTestSupport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Forms of HLSL that shaders of public projects failed on, a case for each cause, in words of our
// own. The values are UnseenFormsGpuTest's.

namespace limn::test
{

namespace
{

using testing::Contains;
using testing::ElementsAre;

struct Form
{
    const char* cause;
    const char* hlsl; ///< behind k_Vertex
};

constexpr Form k_Forms[] = {
    {"a function declared without the const that it is defined with", R"(
        float4 frag(v2f i);
        float Weight(const float a, in const float b);
        float Weight(float a, const in float b) { return a * b; }
        float4 frag(const v2f i) : SV_Target { return Weight(i.uv.x, 2) * i.uv.xyxy; })"},
    {"halves by integers", R"(
        float4 frag(v2f i) : SV_Target
        {
            uint k = (uint)(i.uv.x * 8); int n = 3; half h = 0.5h;
            return k * 1.0h + n * (1.0h / 255.0H) + k * h + float2(0.5h, .25h).xyxy;
        })"},
    {"a macro whose body begins behind the backslash",
     "#define FIELDS\\\n"
     "    float4 _A;\\\n"
     "    float4 _B;\n"
     "FIELDS\n"
     "#define SUM\\\n"
     "(_A + _B)\n"
     "float4 frag(v2f i) : SV_Target { return SUM; "
     "}\n"},
    {"a member pasted behind a dot", R"(
        #define GET(name) i. ## name
        #define RED(v) v ## .r
        float4 frag(v2f i) : SV_Target { float4 c = GET(uv).xyxy; return c + RED(c); })"},
    {"an author's overload of tex2D", R"(
        struct Wrap { float4 v; };
        float4 tex2D(Wrap w, float2 uv) { return w.v * uv.x; }
        float4 lerp(Wrap a, Wrap b, float t) { return lerp(a.v, b.v, t); }
        sampler2D _Map;
        float4 frag(v2f i) : SV_Target
        {
            Wrap w; w.v = tex2D(_Map, (tex2D(_Map, i.uv) * tex2D(_Map, i.uv * 2)).rg);
            return tex2D(w, i.uv) + lerp(w, w, 0.5) + lerp(w.v, 1, i.uv.x);
        })"},
    {"const before static", R"(
        const static int k_Count = 4;
        const static uint k_Two = 2;
        const static float k_Weights[k_Two] = {0.25, 0.75};
        float _Ages[k_Count];
        float4 frag(v2f i) : SV_Target { return _Ages[3] + k_Weights[1]; })"},
    {"a sampler of its own in a function of Direct3D 9", R"(
        SamplerState _Map;
        SamplerState _Sky : register(s3);
        SamplerState sampler_Other; Texture2D _Other;
        float4 Other(SamplerState _Map, float2 uv) { return _Other.Sample(sampler_Other, uv); }
        float4 frag(v2f i) : SV_Target
        {
            return tex2D(_Map, i.uv) + texCUBE(_Sky, i.uv.xyx) + Other(sampler_Other, i.uv);
        })"},
    {"a switch with labels of floats", R"(
        float _Mode;
        float4 frag(v2f i) : SV_Target
        {
            switch (_Mode) { case 0.0: return 1; case 1.0f: return 2; case 2.0h: return 4; default: return 3; }
            return 0;
        })"},
    {"characters", R"(
        static const uint k_Name[4] = {'A', 'b', '0', ' '};
        float4 frag(v2f i) : SV_Target { return k_Name[(uint)i.uv.x] + 'z'; })"},
    {"matrices of min16float", R"(
        float4 frag(v2f i) : SV_Target
        {
            min16float3x3 m = (min16float3x3)1; min16int2x2 n = min16int2x2(1, 2, 3, 4);
            return float4(mul(m, i.uv.xyx), n[1][0]);
        })"},
    {"an offset by a loop's index", R"(
        Texture2D _Map; SamplerState sampler_Map;
        static const int2 k_Offsets[2] = {int2(0, 1), int2(1, 0)};
        float4 frag(v2f i) : SV_Target
        {
            float4 sum = 0;
            [unroll] for (int k = 0; k < 2; k++) { sum += _Map.Sample(sampler_Map, i.uv, k_Offsets[k]); }
            return sum;
        })"},
};

PassProgram ProgramOfMode(const std::string& lightMode)
{
    const std::string tags =
        lightMode.empty() ? "" : "Tags { \"LightMode\" = \"" + lightMode + "\" } ";
    return ParsePass("HLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n" + k_Vertex +
                     "float4 frag(v2f i) : SV_Target { return VALUE; }\nENDHLSL " + tags)
        .program.value();
}

/// Whether passes of the LightMode find the macro defined.
bool Defines(const std::string& lightMode, const std::string& macro)
{
    PassProgram program = ProgramOfMode(lightMode);
    program.chunks.front().text.insert(0, "\n#if " + macro + "\n#define VALUE 1\n#endif\n");
    ShaderCompiler compiler;
    try
    {
        compiler.Compile(program);
        return true;
    }
    catch (const AssetError&)
    {
        return false;
    }
}

} // namespace

TEST(UnseenForms, CompileWhereUnitysCompilersTakeThem)
{
    for (const Form& item : k_Forms)
    {
        SCOPED_TRACE(item.cause);
        EXPECT_NO_THROW(CompileValid(k_Vertex + item.hlsl));
    }
}

TEST(UnseenForms, CompileInCgWhereUnitysCompilersTakeThem)
{
    for (const Form& item : k_Forms)
    {
        SCOPED_TRACE(item.cause);
        EXPECT_NO_THROW(CompileFragment(item.hlsl));
    }
}

TEST(UnseenForms, AreLeftAloneWhereTheyMeanSomethingElse)
{
    // A body that goes on elsewhere, an apostrophe that quotes nothing, a local constant.
    EXPECT_NO_THROW(CompileValid(k_Vertex + "#define ONE 1 \\\n + 0\n"
                                            "// the author's comment, isn't it\n"
                                            "float4 frag(v2f i) : SV_Target { const float k = "
                                            "ONE; for (const int n = 0; n < 0;) {} return k; }\n"));
    EXPECT_NO_THROW(CompileValid(k_Vertex + R"(
        #define NAME(a, b) a ## b
        float4 frag(v2f i) : SV_Target { float NAME(x, 1) = 2.0; return x1; })"));
    EXPECT_THROW(CompileHlsl(k_Vertex +
                             "struct Wrap { float v; }; float pow(Wrap a, Wrap b) { return 1; }\n"
                             "float4 frag(v2f i) : SV_Target { Wrap w; return pow(w, 1.0); }\n"),
                 AssetError);
}

TEST(UnseenForms, TakeOutputsThatTheFragmentFunctionGetsAsZeros)
{
    const auto pass = CompileHlsl(k_Vertex + R"(
        struct Targets { half4 color : SV_Target0; float d : SV_Depth; };
        Targets frag(v2f i, Targets o) { o.color = i.uv.xyxy; return o; })");
    EXPECT_EQ(ValidationMessages(pass->fragmentSpirv), "");
    EXPECT_THAT(Messages(pass->diagnostics),
                ElementsAre(Mentions("'SV_TARGET'", "vertex function", "not write"),
                            Mentions("'SV_DEPTH'", "vertex function", "not write")));
}

// The semantic of a struct in a stage's struct counts on through its members.
TEST(UnseenForms, GiveMembersTheSemanticOfTheirStruct)
{
    const auto pass = CompileValid(R"(
        struct Given { float4 place; float3 side; };
        struct Inner { float4 tint; float2 at[2]; float4 own : COLOR3; float2x2 turn; };
        struct V { float4 p : SV_POSITION; Inner data : TEXCOORD2; };
        V vert(Given g : TEXCOORD1)
        {
            V o; o.p = g.place; o.data = (Inner)0; o.data.tint = g.side.xyzz; return o;
        }
        float4 frag(V i) : SV_Target
        {
            return i.data.tint * i.data.at[1].xyxy + i.data.own + i.data.turn[1].xyxy;
        })");
    std::vector<std::string> inputs;
    for (const VertexInput& input : pass->layout.vertexInputs)
    {
        inputs.push_back(input.semantic);
    }
    EXPECT_THAT(inputs, ElementsAre("TEXCOORD1", "TEXCOORD2"));
    // Two of another struct that comes next to it have numbers that are taken.
    EXPECT_THAT(CompileMessages(Program(R"(
        struct Inner { float4 a; float4 b; };
        struct V { float4 p : SV_POSITION; Inner data : TEXCOORD0; float4 c : TEXCOORD1; };
        V vert(float4 p : POSITION) { return (V)0; }
        float4 frag(V i) : SV_Target { return i.c; })")),
                Contains(Mentions("'TEXCOORD1'", "two values")));
}

TEST(UnseenForms, TellWhatKindOfPassTheLightModeIs)
{
    const std::pair<std::string, std::string> modes[] = {{"ForwardBase", "FORWARDBASE"},
                                                         {"ForwardAdd", "FORWARDADD"},
                                                         {"Deferred", "DEFERRED"},
                                                         {"PrepassBase", "PREPASSBASE"},
                                                         {"PrepassFinal", "PREPASSFINAL"},
                                                         {"ShadowCaster", "SHADOWCASTER"},
                                                         {"Meta", "META"},
                                                         {"MotionVectors", "MOTIONVECTORS"}};
    for (const auto& [mode, name] : modes)
    {
        EXPECT_TRUE(Defines(mode, "UNITY_PASS_" + name)) << mode;
        EXPECT_FALSE(Defines("UniversalForward", "UNITY_PASS_" + name)) << name;
        EXPECT_FALSE(Defines("", "UNITY_PASS_" + name)) << name;
    }
    EXPECT_FALSE(Defines("Meta", "UNITY_PASS_SHADOWCASTER"));
}

TEST(UnseenForms, LetAnAuthorSayWhatKindOfPassTheirsIs)
{
    PassProgram program = ProgramOfMode("ForwardBase");
    program.chunks.front().text.insert(0, "\n#define UNITY_PASS_FORWARDBASE\n#define VALUE 1\n");
    ShaderCompiler compiler;
    EXPECT_EQ(Messages(compiler.Compile(program)->diagnostics), std::vector<std::string>{});
}

TEST(UnseenForms, SetTwoCacheEntriesApartByTheKindOfPass)
{
    const TemporaryFolder folder;
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path();
    for (const std::string mode : {"Meta", "ShadowCaster"})
    {
        PassProgram program = ProgramOfMode(mode);
        program.chunks.front().text.insert(
            0, "\n#ifdef UNITY_PASS_META\nfloat _OfMeta;\n#define VALUE _OfMeta\n#else\n"
               "float _OfOthers;\n#define VALUE _OfOthers\n#endif\n");
        ShaderCompiler compiler(options);
        const auto pass = compiler.Compile(program);
        EXPECT_NO_THROW(Member(*pass, mode == "Meta" ? "_OfMeta" : "_OfOthers")) << mode;
    }
}

} // namespace limn::test
