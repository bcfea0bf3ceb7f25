#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include <glm/gtc/matrix_transform.hpp>
#include <limn/core/FrameCompiler.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

/// Compiles HLSL with the functions `vert`, `geom` and `frag`.
PassPtr CompileGeometryPass(const std::string& hlsl)
{
    ShaderCompiler compiler;
    PassProgram program;
    program.file = "test.shader";
    program.chunks = {{hlsl, 1}};
    program.vertex.name = "vert";
    program.geometry.name = "geom";
    program.fragment.name = "frag";
    return compiler.Compile(program);
}

class Geometry : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        if (Environment().device() != nullptr)
        {
            LIMN_NEEDS_GEOMETRY();
        }
    }
};

/// Each triangle becomes a column of the target as wide as a texel, coloured by its second vertex.
const char* const k_ColumnShader = R"(
    struct v2g { float3 p : TEXCOORD0; };
    struct g2f { float4 pos : SV_POSITION; nointerpolation float4 color : COLOR; };
    v2g vert(float3 p : POSITION) { v2g o; o.p = p; return o; }
    void Corner(float x, float y, float4 color, inout TriangleStream<g2f> stream)
    {
        g2f o; o.pos = float4(x, y, 0.5, 1); o.color = color; stream.Append(o);
    }
    [maxvertexcount(4)]
    void geom(triangle v2g v[3], uint id : SV_PrimitiveID, inout TriangleStream<g2f> stream)
    {
        float left = id * 0.5 - 1.0;
        float4 color = float4(v[1].p, 1);
        Corner(left, -1, color, stream); Corner(left, 1, color, stream);
        Corner(left + 0.5, -1, color, stream); Corner(left + 0.5, 1, color, stream);
    }
    float4 frag(g2f i) : SV_Target { return i.color; })";

/// Four triangles too far away to be seen; the second vertex of each is a colour.
MeshPtr ColorMesh()
{
    MeshData data;
    for (const glm::vec3 color :
         {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(1, 1, 0)})
    {
        const auto first = static_cast<std::uint32_t>(data.vertices.size());
        data.vertices.insert(data.vertices.end(), {{9, 9, 9}, color, {8, 9, 9}});
        data.triangles.insert(data.triangles.end(), {first, first + 1, first + 2});
    }
    return std::make_shared<Mesh>("colors", std::move(data));
}

} // namespace

TEST_F(Geometry, MakesOtherTrianglesOfTriangles)
{
    const TargetPtr target = MakeTarget(4, 2);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(
        MakeDraw(frame, CompileGeometryPass(k_ColumnShader), ColorMesh()));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    const Rgba8 expected[] = {
        {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};
    for (int i = 0; i < 8; ++i)
    {
        EXPECT_EQ(Texel8(image, i % 4, i / 4), expected[i % 4]) << "texel " << i;
    }
}

// A vertex's values may come in several arrays: the colours here have one of their own.
TEST_F(Geometry, TakesTheValuesOfAVertexInSeveralArrays)
{
    std::string text = k_ColumnShader;
    const auto replace = [&](const std::string& from, const std::string& to)
    {
        ASSERT_NE(text.find(from), text.npos) << from;
        text.replace(text.find(from), from.size(), to);
    };
    replace("struct v2g { float3 p : TEXCOORD0; };",
            "struct v2g { float3 p : TEXCOORD0; float3 back : TEXCOORD1; };");
    replace("o.p = p;", "o.p = 9; o.back = 1 - p;");
    replace("triangle v2g v[3]",
            "triangle float3 v[3] : TEXCOORD0, triangle float3 w[3] : TEXCOORD1");
    replace("float4(v[1].p, 1)", "float4(v[1] - 8 - w[1], 1)");
    const TargetPtr target = MakeTarget(4, 2);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeDraw(frame, CompileGeometryPass(text), ColorMesh()));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    const Rgba8 expected[] = {
        {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};
    for (int i = 0; i < 8; ++i)
    {
        EXPECT_EQ(Texel8(image, i % 4, i / 4), expected[i % 4]) << "texel " << i;
    }
}

TEST_F(Geometry, MakesLinesOfTriangles)
{
    const PassPtr pass = CompileGeometryPass(R"(
        struct v2f { float4 pos : SV_POSITION; };
        v2f vert(float3 p : POSITION) { v2f o; o.pos = float4(p, 1); return o; }
        [maxvertexcount(2)]
        void geom(triangle v2f v[3], uint id : SV_PrimitiveID, inout LineStream<v2f> lines)
        {
            if (id == 0) { lines.Append(v[0]); lines.Append(v[2]); }
        }
        float4 frag() : SV_Target { return 1; })");
    // A line along the middle of the second of four rows.
    MeshData data;
    data.vertices = {{-1.5f, 0.25f, 0.5f}, {0, -3, 0.5f}, {1.5f, 0.25f, 0.5f}};
    data.triangles = {0, 1, 2};
    const TargetPtr target = MakeTarget(4, 4);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(
        MakeDraw(frame, pass, std::make_shared<Mesh>("edge", std::move(data))));
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int i = 0; i < 16; ++i)
    {
        EXPECT_EQ(Texel8(image, i % 4, i / 4)[0], i / 4 == 1 ? 255 : 0) << "texel " << i;
    }
}

TEST_F(Geometry, FindsThePerDrawDataOfItsDraw)
{
    const PassPtr pass = CompileGeometryPass(R"(
        #include "UnityCG.cginc"
        struct v2f { float4 pos : SV_POSITION; };
        v2f vert(float3 p : POSITION) { v2f o; o.pos = float4(p, 1); return o; }
        [maxvertexcount(3)]
        void geom(triangle v2f v[3], inout TriangleStream<v2f> stream)
        {
            for (int i = 0; i < 3; ++i)
            {
                v2f o; o.pos = mul(unity_ObjectToWorld, v[i].pos); stream.Append(o);
            }
        }
        float4 frag() : SV_Target { return unity_ObjectToWorld._m03 + 2; })");
    const TargetPtr target = MakeTarget(4, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    DrawBindings bindings;
    bindings.perDrawBinding = pass->layout.storageBuffers.at(0).binding;
    // Draw i moves its quad, a texel wide, to column i.
    for (std::uint32_t i = 0; i < 4; ++i)
    {
        PerDrawData data{};
        for (const int diagonal : {0, 5, 10, 15})
        {
            data.objectToWorld[diagonal] = 1.0f;
        }
        data.objectToWorld[12] = static_cast<float>(i) * 0.5f;
        frame.perDraw.push_back(data);
        DrawCommand draw =
            MakeDraw(frame, pass, MakeQuad(-1, -1, -0.5f, 1), PlainState(), bindings);
        draw.firstInstance = i;
        frame.passes[0].commands.emplace_back(draw);
    }
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(TexelFloat(image, i, 0)[0], 2.0f + 0.5f * static_cast<float>(i)) << i;
    }
}

TEST_F(Geometry, MovesEachMeshOfACommandBufferByItsOwnMatrix)
{
    const auto material = std::make_shared<Material>(
        Shader::FromText("Shader \"T\" { SubShader { Pass { ZTest Always Cull Off\nHLSLPROGRAM\n"
                         "#pragma vertex V\n#pragma geometry G\n#pragma fragment F\n"
                         "#include \"UnityCG.cginc\"\n"
                         "struct v2f { float4 pos : SV_POSITION; };\n"
                         "v2f V(float3 p : POSITION) { v2f o; o.pos = float4(p, 1); return o; }\n"
                         "[maxvertexcount(3)]\n"
                         "void G(triangle v2f v[3], inout TriangleStream<v2f> stream)\n"
                         "{ for (int i = 0; i < 3; ++i) { v2f o;\n"
                         "  o.pos = mul(unity_ObjectToWorld, v[i].pos); stream.Append(o); } }\n"
                         "float4 F() : SV_Target { return 1; }\nENDHLSL } } }",
                         "t.shader", std::make_shared<ShaderCompiler>()));
    const TargetPtr target = MakeTarget(4, 1);
    CommandBuffer cmd;
    cmd.SetRenderTarget(RTHandle(target));
    cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
    // One quad, a texel wide, in each column but the third.
    const MeshPtr quad = MakeQuad(-1, -1, -0.5f, 1);
    for (const float x : {0.0f, 0.5f, 1.5f})
    {
        cmd.DrawMesh(quad, glm::translate(glm::mat4(1.0f), {x, 0, 0}), material);
    }
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);
    SharedDevice().Execute(CompileFrame(context.TakeCommands(), {}, std::array{target}));
    const Image image = ReadRows(*target);
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(Texel8(image, i, 0)[0], i == 2 ? 0 : 255) << "column " << i;
    }
}

/// Covers the target in what the middle of `_MainTex` holds, sampled by the geometry function.
DrawCommand SamplingDraw(FrameTables& frame, const std::shared_ptr<const Texture>& texture)
{
    static const PassPtr pass = CompileGeometryPass(R"(
        Texture2D _MainTex;
        SamplerState sampler_MainTex;
        struct v2f { float4 pos : SV_POSITION; float4 color : COLOR; };
        v2f vert(float3 p : POSITION) { v2f o; o.pos = float4(p, 1); o.color = 0; return o; }
        [maxvertexcount(3)]
        void geom(triangle v2f v[3], inout TriangleStream<v2f> stream)
        {
            for (int i = 0; i < 3; ++i)
            {
                v2f o = v[i];
                o.color = _MainTex.SampleLevel(sampler_MainTex, 0.5, 0);
                stream.Append(o);
            }
        }
        float4 frag(v2f i) : SV_Target { return i.color; })");
    DrawBindings bindings;
    bindings.textures = {{pass->layout.textures.at(0).binding, texture, std::nullopt}};
    bindings.samplers = {{pass->layout.samplers.at(0).binding, {}}};
    return MakeDraw(frame, pass, MakeQuad(), PlainState(), bindings);
}

// That it waits for the texels is what synchronization validation checks.

TEST_F(Geometry, SamplesATextureThatTheSameFrameUploads)
{
    const auto texture = std::make_shared<Texture2D>("grey", 1, 1, GraphicsFormat::R8_UNorm,
                                                     std::vector<std::byte>(1, std::byte{51}));
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(SamplingDraw(frame, texture));
    SharedDevice().Execute(frame);
    EXPECT_EQ((Rgba8{51, 0, 0, 255}), Texel8(ReadRows(*target), 0, 0));
}

TEST_F(Geometry, SamplesATextureThatTheSameFrameDraws)
{
    const TargetPtr source = MakeTarget(1, 1);
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame =
        FrameOf({ClearPass(source, {0, 0, 1, 1}), ClearPass(target), ClearPass(source)}, target);
    frame.passes[1].barriers.push_back(
        {source, TextureUsage::ColorAttachment, TextureUsage::ShaderRead});
    frame.passes[1].commands.emplace_back(SamplingDraw(frame, source));
    frame.passes[2].barriers[0].before = TextureUsage::ShaderRead; // waits for the read in turn
    SharedDevice().Execute(frame);
    EXPECT_EQ((Rgba8{0, 0, 255, 255}), Texel8(ReadRows(*target), 0, 0));
}

} // namespace limn::test
