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
using testing::HasSubstr;
using testing::Not;

const std::string k_Stages = R"(
struct v2g { float4 pos : POSITION; float3 n : NORMAL; };
struct g2f { float4 pos : SV_POSITION; float3 uv : TEXCOORD0; };
v2g vert(float4 p : POSITION, float3 n : NORMAL) { v2g o; o.pos = p; o.n = n; return o; }
float4 frag(g2f i) : SV_Target { return float4(i.uv, 1); }
)";

PassProgram GeometryProgram(const std::string& hlsl)
{
    PassProgram program = test::Program(hlsl);
    program.geometry = {"geom", {1, 5}};
    return program;
}

/// Compiles, validates all three stages and asks for no warning.
std::shared_ptr<const ShaderProgram> CompileGeometry(const std::string& hlsl)
{
    ShaderCompiler compiler;
    auto pass = compiler.Compile(GeometryProgram(hlsl));
    EXPECT_EQ(test::ValidationMessages(pass->vertexSpirv), "");
    EXPECT_EQ(test::ValidationMessages(pass->geometrySpirv), "");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    EXPECT_EQ(test::Messages(pass->diagnostics), std::vector<std::string>{});
    return pass;
}

std::string Disassembly(const std::string& hlsl)
{
    return test::Disassemble(CompileGeometry(hlsl)->geometrySpirv);
}

} // namespace

TEST(GeometryStage, TakesPositionOfAnOutputForTheScreenPosition)
{
    const std::string text = Disassembly(R"(
struct v2g { float4 pos : POSITION; };
struct g2f { float4 pos : POSITION; float3 uv : TEXCOORD0; };
v2g vert(float4 p : POSITION) { v2g o; o.pos = p; return o; }
float4 frag(float3 uv : TEXCOORD0) : SV_Target { return float4(uv, 1); }
[maxvertexcount(1)]
void geom(point v2g input[1], inout PointStream<g2f> stream)
{
    g2f o;
    o.pos = input[0].pos;
    o.uv = 0;
    stream.Append(o);
})");
    EXPECT_THAT(text, HasSubstr("BuiltIn Position"));
}

TEST(GeometryStage, CompilesBetweenTheTwoOthers)
{
    const std::string text = Disassembly(k_Stages + R"(
[maxvertexcount(4)]
void geom(triangle v2g input[3], inout TriangleStream<g2f> stream)
{
    for (int i = 0; i < 3; ++i)
    {
        g2f o;
        o.pos = input[i].pos;
        o.uv = input[i].n;
        stream.Append(o);
    }
    stream.RestartStrip();
})");
    EXPECT_THAT(text, HasSubstr("OpEntryPoint Geometry %main \"main\""));
    EXPECT_THAT(text, HasSubstr("OpExecutionMode %main Triangles\n"));
    EXPECT_THAT(text, HasSubstr("OpExecutionMode %main OutputTriangleStrip\n"));
    EXPECT_THAT(text, HasSubstr("OpExecutionMode %main OutputVertices 4\n"));
    EXPECT_THAT(text, HasSubstr("OpEmitVertex"));
    EXPECT_THAT(text, HasSubstr("OpEndPrimitive"));
}

TEST(GeometryStage, TakesEveryPrimitiveAndStream)
{
    struct Case
    {
        const char* parameter;
        GeometryInput input;
        const char* stream;
        const char* mode;
    };
    for (const Case& item :
         {Case{"point v2g i[1]", GeometryInput::Point, "PointStream", "OutputPoints"},
          Case{"line v2g i[2]", GeometryInput::Line, "LineStream", "OutputLineStrip"},
          Case{"lineadj v2g i[4]", GeometryInput::LineAdjacency, "LineStream", "OutputLineStrip"},
          Case{"triangle v2g i[3]", GeometryInput::Triangle, "PointStream", "OutputPoints"},
          Case{"triangleadj v2g i[6]", GeometryInput::TriangleAdjacency, "TriangleStream",
               "OutputTriangleStrip"}})
    {
        const auto pass = CompileGeometry(k_Stages + "[maxvertexcount(1)] void geom(" +
                                          item.parameter + ", inout " + item.stream +
                                          "<g2f> s) { g2f o; o.pos = i[0].pos; o.uv = i[0].n; "
                                          "s.Append(o); }");
        EXPECT_EQ(pass->layout.geometryInput, item.input) << item.parameter;
        EXPECT_THAT(test::Disassemble(pass->geometrySpirv), HasSubstr(item.mode)) << item.parameter;
    }
}

TEST(GeometryStage, MayAppendInFunctionsThatItCalls)
{
    const std::string text = Disassembly(k_Stages + R"(
g2f Make(float4 p) { g2f o; o.pos = p; o.uv = 0; return o; }
void Emit(inout LineStream<g2f> lines, v2g a, v2g b)
{
    lines.Append(Make(a.pos)); lines.Append(Make(b.pos + float4(b.n, (0))));
    lines.RestartStrip();
}
[maxvertexcount(6)]
void geom(triangle v2g v[3], inout LineStream<g2f> s)
{
    Emit(s, v[0], v[1]); Emit(s, v[1], v[2]); Emit(s, v[2], v[0]);
})");
    std::size_t count = 0;
    for (std::size_t at = text.find("OpEmitVertex"); at != text.npos;
         at = text.find("OpEmitVertex", at + 1))
    {
        ++count;
    }
    EXPECT_EQ(count, 6U);
}

TEST(GeometryStage, OneStructMayServeAllBorders)
{
    CompileGeometry(R"(
struct v2f { float4 vertex : SV_POSITION; nointerpolation uint id : TEXCOORD1; float2 uv : TEXCOORD0; };
v2f vert(float4 p : POSITION) { v2f o; o.vertex = p; o.id = 3; o.uv = p.xy; return o; }
[maxvertexcount(3)] void geom(triangle v2f a[3], inout TriangleStream<v2f> triStream)
{
    triStream.Append(a[0]); triStream.Append(a[1]); triStream.Append(a[2]);
}
float4 frag(v2f i) : SV_Target { return float4(i.uv, i.id, 1); })");
}

TEST(GeometryStage, HasItsSystemValuesAttributesAndResources)
{
    const auto pass = CompileGeometry(k_Stages + R"(
float4x4 _Turn;
#define COUNT (2 + 1)
[maxvertexcount(COUNT)]
[instance(2)]
void geom(triangle v2g v[3], inout TriangleStream<g2f> s, uint primitive : SV_PrimitiveID,
          uint instance : SV_GSInstanceID)
{
    for (int i = 0; i < COUNT; ++i)
    {
        g2f o; o.pos = mul(_Turn, v[i].pos); o.uv = float3(primitive, instance, 0); s.Append(o);
    }
})");
    const std::string text = test::Disassemble(pass->geometrySpirv);
    EXPECT_THAT(text, HasSubstr("BuiltIn PrimitiveId"));
    EXPECT_THAT(text, HasSubstr("BuiltIn InvocationId"));
    EXPECT_THAT(text, HasSubstr("OpExecutionMode %main Invocations 2"));
    EXPECT_THAT(text, HasSubstr("OpExecutionMode %main OutputVertices 3"));
    ASSERT_EQ(pass->layout.buffers.size(), 1U);
    EXPECT_EQ(pass->layout.buffers[0].stages, ShaderStage::Geometry);
    EXPECT_EQ(pass->layout.buffers[0].members.at(0).name, "_Turn");
}

TEST(GeometryStage, ChoosesTheLayerThatItDrawsInto)
{
    const std::string geometry = R"(
[maxvertexcount(1)] void geom(point v2g v[1], inout PointStream<Layered> s)
{
    Layered o; o.pos = v[0].pos; o.uv = v[0].n; o.layer = 2; s.Append(o);
})";
    const std::string layered =
        "struct Layered { float4 pos : SV_POSITION; float3 uv : TEXCOORD0; uint layer : ";
    EXPECT_THAT(Disassembly(k_Stages + layered + "SV_RenderTargetArrayIndex; };" + geometry),
                HasSubstr("BuiltIn Layer"));
    EXPECT_THAT(test::CompileMessages(
                    GeometryProgram(k_Stages + layered + "SV_GSInstanceID; };" + geometry)),
                ElementsAre(Mentions("geom: 'layer'", "'SV_GSInstanceID'", "not possible")));
}

TEST(GeometryStage, KnowsItsStage)
{
    EXPECT_THAT(Disassembly(k_Stages + R"(
#ifdef SHADER_STAGE_GEOMETRY
#define MODE 5
#else
#define MODE 4
#endif
[maxvertexcount(MODE)] void geom(point v2g v[1], inout PointStream<g2f> s)
{
    g2f o; o.pos = v[0].pos; o.uv = 0; s.Append(o);
})"),
                HasSubstr("OutputVertices 5"));
}

TEST(GeometryStage, AssignsToUniformsAndReadsThePerDrawData)
{
    const std::string text = Disassembly("#include \"UnityCG.cginc\"\n" + k_Stages + R"(
float _Size;
[maxvertexcount(1)] void geom(point v2g v[1], inout PointStream<g2f> s)
{
    _Size *= 2;
    g2f o; o.pos = UnityObjectToClipPos(v[0].pos * _Size); o.uv = 0; s.Append(o);
})");
    EXPECT_THAT(text, HasSubstr("\"limn_PerDraw\""));
    EXPECT_THAT(text, HasSubstr("\"limn_FirstInstance\""));
    EXPECT_THAT(text, Not(HasSubstr("InstanceIndex")));
}

TEST(GeometryStage, WarnsOfValuesThatTheStageBeforeDoesNotWrite)
{
    ShaderCompiler compiler;
    const auto pass = compiler.Compile(GeometryProgram(R"(
struct v2g { float4 pos : SV_POSITION; };
struct in2 { float4 pos : SV_POSITION; float3 c : COLOR; };
struct g2f { float4 pos : SV_POSITION; };
v2g vert(float4 p : POSITION) { v2g o; o.pos = p; return o; }
[maxvertexcount(1)] void geom(point in2 v[1], inout PointStream<g2f> s)
{ g2f o; o.pos = v[0].pos + v[0].c.x; s.Append(o); }
float4 frag(g2f i, float2 uv : TEXCOORD3) : SV_Target { return uv.x; })"));
    EXPECT_THAT(
        test::Messages(pass->diagnostics),
        ElementsAre(
            Mentions("1:5: warning: geom", "'COLOR'", "vertex function", "not write"),
            Mentions("1:1: warning: frag", "'TEXCOORD3'", "geometry function", "not write")));
}

TEST(GeometryStage, IsToldWhatItsSignatureLacks)
{
    EXPECT_THAT(test::CompileMessages(GeometryProgram(
                    k_Stages + "                   void geom(triangle v2g v[3], inout "
                               "TriangleStream<g2f> s) { }")),
                ElementsAre(Mentions("t.shader:6:25: error: geom", "[maxvertexcount(N)]",
                                     "'triangle v2g input[3]'", "TriangleStream<g2f>")));
    EXPECT_THAT(test::CompileMessages(GeometryProgram(
                    k_Stages + "[maxvertexcount(3)] void geom(triangle v2g v[3]) { }")),
                ElementsAre(Mentions("[maxvertexcount(N)]")));
    EXPECT_THAT(test::CompileMessages(GeometryProgram(
                    k_Stages + "[maxvertexcount(3)] void geom(triangle v2g v[2], inout "
                               "TriangleStream<g2f> s) { }")),
                ElementsAre(Mentions("geom: 'v'", "'triangle'", "array of 3")));
    EXPECT_THAT(
        test::CompileMessages(GeometryProgram(
            k_Stages + "[maxvertexcount(3)] void geom(point v2g v[1], inout PointStream<g2f> a, "
                       "inout PointStream<g2f> b) { }")),
        ElementsAre(Mentions("geom: 'b'", "more than one")));
    EXPECT_THAT(test::CompileMessages(GeometryProgram(
                    k_Stages + "[maxvertexcount(3)] void geom(point v2g v[1], line v2g w[2], "
                               "inout PointStream<g2f> a) { }")),
                ElementsAre(Mentions("geom: 'w'", "'line'", "'point'", "one primitive")));
    EXPECT_THAT(
        test::CompileMessages(GeometryProgram(k_Stages)),
        ElementsAre(Mentions("t.shader:1:5: error: #pragma geometry", "no function 'geom'")));
}

TEST(GeometryStage, LeavesVariablesOfItsWordsAlone)
{
    CompileGeometry(k_Stages + R"(
[maxvertexcount(1)] void geom(point v2g v[1], inout PointStream<g2f> s)
{
    float3 point = v[0].n; float line = point.x; float3 triangle = point * line;
    g2f o; o.pos = v[0].pos; o.uv = triangle; s.Append(o);
})");
}

TEST(GeometryStage, IsReadFromItsPragmaAndKeptInTheCache)
{
    const ShaderLabPass parsed = test::ParsePass(
        "HLSLPROGRAM\n#pragma vertex vert\n #pragma geometry geom\n#pragma fragment frag\nENDHLSL");
    EXPECT_EQ(parsed.program->geometry.name, "geom");
    EXPECT_EQ(parsed.program->geometry.location, (SourceLocation{3, 2}));

    const test::TemporaryFolder folder;
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path();
    const PassProgram program =
        GeometryProgram(k_Stages + "[maxvertexcount(1)] void geom(point v2g v[1], inout "
                                   "PointStream<g2f> s) { g2f o; o.pos = v[0].pos; o.uv = 1; "
                                   "s.Append(o); }");
    const auto first = ShaderCompiler(options).Compile(program);
    ShaderCompiler second(options);
    EXPECT_EQ(*second.Compile(program), *first);
    EXPECT_EQ(second.statistics().loadedFromCache, 1);
}

} // namespace limn
