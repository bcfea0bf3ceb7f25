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

using InstanceIds = GpuTest;

constexpr int k_RowWidth = 4;

/// Over column 0 of the target.
MeshPtr ColumnQuad()
{
    return MakeQuad(-1, -1, -1 + 2.0f / k_RowWidth, 1);
}

/// What moves the quad to a column, and a rendering layer to know it by.
PerDrawData ColumnData(int column)
{
    PerDrawData data{};
    data.objectToWorld[0] = data.objectToWorld[5] = data.objectToWorld[10] =
        data.objectToWorld[15] = 1.0f;
    data.objectToWorld[12] = 2.0f / k_RowWidth * static_cast<float>(column);
    data.renderingLayer[0] = 10u + static_cast<std::uint32_t>(column);
    return data;
}

const std::string k_IdOfColumn = R"(
    #include "limn/PerDraw.hlsl"
    struct v2f { float4 pos : SV_POSITION; nointerpolation float2 value : TEXCOORD0; };
    v2f vert(float3 p : POSITION, uint id : SV_InstanceID)
    {
        v2f o;
        o.pos = mul(unity_ObjectToWorld, float4(p, 1));
        o.value = float2(id, asuint(unity_RenderingLayer));
        return o;
    }
    float4 frag(v2f i) : SV_Target { return float4(i.value, 0, 1); })";

} // namespace

TEST_F(InstanceIds, CountFromZeroInEachDraw)
{
    const PassPtr pass = CompilePass(k_IdOfColumn);
    const TargetPtr target = MakeTarget(k_RowWidth, 1, GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    for (int i = 0; i < k_RowWidth; ++i)
    {
        frame.perDraw.push_back(ColumnData(i));
    }
    DrawBindings bindings;
    bindings.perDrawBinding = pass->layout.storageBuffers.at(0).binding;
    DrawCommand draw = MakeDraw(frame, pass, ColumnQuad(), PlainState(), bindings);
    draw.firstInstance = 3;
    frame.passes[0].commands.emplace_back(draw);
    draw.firstInstance = 0;
    draw.instanceCount = 3;
    frame.passes[0].commands.emplace_back(draw);
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int i = 0; i < k_RowWidth; ++i)
    {
        EXPECT_EQ(TexelFloat(image, i, 0)[0], static_cast<float>(i % 3)) << "column " << i;
        EXPECT_EQ(TexelFloat(image, i, 0)[1], static_cast<float>(10 + i)) << "column " << i;
    }
}

TEST_F(InstanceIds, NeedNoPerDrawData)
{
    const PassPtr pass = CompilePass(R"(
        float4 vert(float3 p : POSITION, int id : SV_InstanceID) : SV_POSITION
        {
            return float4(p.x + id * 0.5, p.y, p.z, 1);
        }
        float4 frag() : SV_Target { return 1; })");
    const TargetPtr target = MakeTarget(k_RowWidth, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    DrawCommand draw = MakeDraw(frame, pass, ColumnQuad());
    draw.firstInstance = 1;
    draw.instanceCount = 2;
    frame.passes[0].commands.emplace_back(draw);
    SharedDevice().Execute(frame);
    const Image image = ReadRows(*target);
    for (int i = 0; i < k_RowWidth; ++i)
    {
        EXPECT_EQ(Texel8(image, i, 0)[0], i < 2 ? 255 : 0) << "column " << i;
    }
}

TEST_F(InstanceIds, AreZeroForEachMeshOfACommandBuffer)
{
    const std::string geometry = R"(
        #include "UnityCG.cginc"
        struct v2f { float4 pos : SV_POSITION; nointerpolation float id : TEXCOORD0; };
        v2f V(float3 p : POSITION, uint id : SV_InstanceID)
        { v2f o; o.pos = float4(p, 1); o.id = id; return o; }
        [maxvertexcount(3)]
        void G(triangle v2f v[3], inout TriangleStream<v2f> stream)
        {
            for (int i = 0; i < 3; ++i)
            {
                v2f o = v[i]; o.pos = mul(unity_ObjectToWorld, o.pos); stream.Append(o);
            }
        }
        float4 F(v2f i) : SV_Target { return float4(1, i.id, 0, 1); })";
    const std::string plain = R"(
        #include "UnityCG.cginc"
        struct v2f { float4 pos : SV_POSITION; nointerpolation float id : TEXCOORD0; };
        v2f V(float3 p : POSITION, uint id : SV_InstanceID)
        { v2f o; o.pos = mul(unity_ObjectToWorld, float4(p, 1)); o.id = id; return o; }
        float4 F(v2f i) : SV_Target { return float4(1, i.id, 0, 1); })";
    for (const auto& [program, pragma] :
         {std::pair(plain, ""), std::pair(geometry, "#pragma geometry G\n")})
    {
        if (pragma[0] != '\0' && Lacks("geometry"))
        {
            GTEST_SKIP() << "the device reports no geometryShader";
        }
        const auto material = std::make_shared<Material>(Shader::FromText(
            "Shader \"T\" { SubShader { Pass { ZTest Always Cull Off\nHLSLPROGRAM\n"
            "#pragma vertex V\n#pragma fragment F\n" +
                std::string(pragma) + program + "\nENDHLSL } } }",
            "t.shader", std::make_shared<ShaderCompiler>()));
        const TargetPtr target = MakeTarget(k_RowWidth, 1);
        CommandBuffer cmd;
        cmd.SetRenderTarget(RTHandle(target));
        cmd.ClearRenderTarget(ClearFlag::Color, Color::black);
        for (const float x : {0.0f, 0.5f, 1.5f})
        {
            cmd.DrawMesh(ColumnQuad(), glm::translate(glm::mat4(1.0f), {x, 0, 0}), material);
        }
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        SharedDevice().Execute(CompileFrame(context.TakeCommands(), {}, std::array{target}));
        const Image image = ReadRows(*target);
        for (int i = 0; i < k_RowWidth; ++i)
        {
            EXPECT_EQ(Texel8(image, i, 0)[0], i == 2 ? 0 : 255) << pragma << "column " << i;
            EXPECT_EQ(Texel8(image, i, 0)[1], 0) << pragma << "column " << i;
        }
    }
}

} // namespace limn::test
