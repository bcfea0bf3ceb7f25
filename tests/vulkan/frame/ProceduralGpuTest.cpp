#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <limn/core/FrameCompiler.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn::test
{

namespace
{

/// Draws vertices that a shader makes up from SV_VertexID and SV_InstanceID.
class ProceduralGpu : public GpuTest
{
protected:
    /// @param place  of a vertex in texels of an 8x8 target from the top left, from `v` and `i`
    static std::shared_ptr<const Material> Placing(const std::string& place)
    {
        static const auto compiler = std::make_shared<ShaderCompiler>();
        return std::make_shared<const Material>(Shader::FromText(
            "Shader \"Test/Procedural\" { SubShader { Pass { Cull Off ZTest Always ZWrite Off\n"
            "Blend One One\nHLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n"
            "float4 vert(uint v : SV_VertexID, uint i : SV_InstanceID) : SV_POSITION\n"
            "{ float2 p = " +
                place +
                ";\nreturn float4(p.x / 4 - 1, 1 - p.y / 4, 0.5, 1); }\n"
                "float4 frag() : SV_Target { return float4(0.2, 0, 0, 0); }\nENDHLSL } } }",
            "procedural.shader", compiler));
    }
    /// How often each texel was drawn, row by row.
    std::vector<std::string> Draw(const std::string& place, MeshTopology topology, int vertices,
                                  int instances)
    {
        const RTHandle target(MakeTarget(8, 8));
        CommandBuffer cmd;
        cmd.SetRenderTarget(target);
        cmd.ClearRenderTarget(ClearFlag::Color, Color::clear);
        // Something else before it: its instances do not begin at 0.
        cmd.DrawProcedural(glm::mat4(1.0f), Placing("float2(-9, -9)"), 0, MeshTopology::Triangles,
                           3, 5);
        cmd.DrawProcedural(glm::mat4(1.0f), Placing(place), 0, topology, vertices, instances);
        RenderReport report;
        ScriptableRenderContext context(report);
        context.ExecuteCommandBuffer(cmd);
        const auto texture = target.rt();
        SharedDevice().Execute(CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                                            std::span(&texture, 1)));
        ExpectNoValidationMessages();
        const Image image = ReadRows(*texture);
        std::vector<std::string> rows;
        for (int y = 0; y < 8; ++y)
        {
            std::string row;
            for (int x = 0; x < 8; ++x)
            {
                const int times = Texel8(image, x, y)[0] / 51; // 51 = 0.2
                row += times == 0 ? "." : std::to_string(times);
            }
            rows.push_back(row);
        }
        return rows;
    }
};

} // namespace

TEST_F(ProceduralGpu, DrawsEachInstance)
{
    // Instance i: the triangle that covers 2 x 2 texels and lies 2 i + 1 to the right and down.
    EXPECT_EQ(Draw("float2(v == 1 ? 4.2 : 0.2, v == 2 ? 4.2 : 0.2) + 1 + 2 * i",
                   MeshTopology::Triangles, 3, 2),
              (std::vector<std::string>{
                  "........",
                  ".1111...",
                  ".111....",
                  ".111111.",
                  ".1.111..",
                  "...11...",
                  "...1....",
                  "........",
              }));
}

// Lines through texel centres along rows and columns; where one ends is left to the device.
TEST_F(ProceduralGpu, DrawsLinesAndLineStrips)
{
    const auto lines =
        Draw("float2(v % 2 == 0 ? -1 : 9, v / 2 * 3 + 1.5)", MeshTopology::Lines, 4, 1);
    for (int y = 0; y < 8; ++y)
    {
        EXPECT_EQ(lines[static_cast<std::size_t>(y)], y == 1 || y == 4 ? "11111111" : "........");
    }
    const auto strip =
        Draw("float2(v == 0 ? -1 : 2.5, v == 2 ? 9 : 1.5)", MeshTopology::LineStrip, 3, 1);
    EXPECT_EQ(strip[0], "........");
    EXPECT_EQ(strip[1].substr(0, 2), "11");
    EXPECT_EQ(strip[1].substr(3), ".....");
    for (std::size_t y = 2; y < 8; ++y)
    {
        EXPECT_EQ(strip[y], "..1.....") << y;
    }
}

// Two quads of 2 x 2 texels, their corners going round.
TEST_F(ProceduralGpu, DrawsQuads)
{
    EXPECT_EQ(Draw("1 + v / 4 * 3 + float2(v % 4 / 2 * 2, (v + 1) / 2 % 2 * 2) + i",
                   MeshTopology::Quads, 8, 2),
              (std::vector<std::string>{
                  "........",
                  ".11.....",
                  ".121....",
                  "..11....",
                  "....11..",
                  "....121.",
                  ".....11.",
                  "........",
              }));
}

TEST_F(ProceduralGpu, DrawsPointsOfOneTexel)
{
    EXPECT_EQ(Draw("float2(v, v) + 0.5 + float2(2 * i, 0)", MeshTopology::Points, 4, 2),
              (std::vector<std::string>{
                  "1.1.....",
                  ".1.1....",
                  "..1.1...",
                  "...1.1..",
                  "........",
                  "........",
                  "........",
                  "........",
              }));
}

// A shader that says how large its points are keeps that; with triangles in between, whose pipeline
// is another one.
TEST_F(ProceduralGpu, DrawsPointsAsLargeAsTheyShouldBe)
{
    const std::string size = "#pragma vertex vert\n#pragma fragment frag\n"
                             "struct Point { float4 at : SV_POSITION; float size : PSIZE; };\n"
                             "Point vert(uint v : SV_VertexID) { Point p; p.size = 2;\n"
                             "p.at = float4(v * 0.5 - 0.5, 0, 0.5, 1); return p; }\n"
                             "float4 frag() : SV_Target { return 1; }\n";
    const auto material = std::make_shared<const Material>(
        Shader::FromText("Shader \"Test/Size\" { SubShader { Pass { Cull Off ZTest Always ZWrite "
                         "Off\nHLSLPROGRAM\n" +
                             size + "ENDHLSL } } }",
                         "size.shader", std::make_shared<ShaderCompiler>()));
    const RTHandle target(MakeTarget(8, 8));
    CommandBuffer cmd;
    cmd.SetRenderTarget(target);
    cmd.ClearRenderTarget(ClearFlag::Color, Color::clear);
    cmd.DrawProcedural(glm::mat4(1.0f), material, 0, MeshTopology::Points, 2);
    cmd.DrawProcedural(glm::mat4(1.0f), Placing("float2(-9, -9)"), 0, MeshTopology::Triangles, 3);
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);
    const auto texture = target.rt();
    SharedDevice().Execute(CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                                        std::span(&texture, 1)));
    ExpectNoValidationMessages();
    const Image image = ReadRows(*texture);
    for (int y = 0; y < 8; ++y)
    {
        for (int x = 0; x < 8; ++x)
        {
            const bool isDrawn = (y == 3 || y == 4) && (x == 1 || x == 2 || x == 3 || x == 4);
            EXPECT_EQ(Texel8(image, x, y)[0], isDrawn ? 255 : 0) << x << ", " << y;
        }
    }
}

// A geometry function gets points where points are drawn.
TEST_F(ProceduralGpu, GivesPointsToAGeometryFunction)
{
    LIMN_NEEDS_GEOMETRY();
    const auto material = std::make_shared<const Material>(Shader::FromText(
        R"(Shader "Test/Grass" { SubShader { Pass { Cull Off ZTest Always ZWrite Off
        HLSLPROGRAM
        #pragma vertex vert
        #pragma geometry geom
        #pragma fragment frag
        struct v2f { float4 pos : SV_POSITION; };
        v2f vert(uint v : SV_VertexID) { v2f o; o.pos = float4(v - 0.5, 0, 0.5, 1); return o; }
        [maxvertexcount(4)]
        void geom(point v2f i[1], inout TriangleStream<v2f> s)
        {
            for (uint k = 0; k < 4; ++k)
            {
                v2f o = i[0];
                o.pos.xy += (float2(k % 2, k / 2) - 0.5) * 0.5; // 2 x 2 texels
                s.Append(o);
            }
        }
        float4 frag() : SV_Target { return 1; }
        ENDHLSL } } })",
        "grass.shader", std::make_shared<ShaderCompiler>()));
    const RTHandle target(MakeTarget(8, 8));
    CommandBuffer cmd;
    cmd.SetRenderTarget(target);
    cmd.ClearRenderTarget(ClearFlag::Color, Color::clear);
    cmd.DrawProcedural(glm::mat4(1.0f), material, 0, MeshTopology::Points, 2);
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);
    const auto texture = target.rt();
    SharedDevice().Execute(CompileFrame(context.TakeCommands(), SharedDevice().textureStates(),
                                        std::span(&texture, 1)));
    ExpectNoValidationMessages();
    const Image image = ReadRows(*texture);
    int count = 0;
    for (int i = 0; i < 64; ++i)
    {
        count += Texel8(image, i % 8, i / 8)[0] == 255 ? 1 : 0;
    }
    EXPECT_EQ(count, 8);
    EXPECT_EQ(Texel8(image, 1, 3)[0], 255);
    EXPECT_EQ(Texel8(image, 6, 4)[0], 255);
}

} // namespace limn::test
