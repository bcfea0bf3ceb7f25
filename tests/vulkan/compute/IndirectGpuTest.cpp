#include "compute/ComputeRun.h"

#include <array>
#include <limn/core/Material.h>
#include <limn/core/Mesh.h>

namespace limn::test
{

namespace
{

using Counts = std::vector<std::uint32_t>;
constexpr auto k_Arguments = GraphicsBuffer::Target::IndirectArguments;

/// Draws and dispatches whose counts are in a buffer. Instance i of a draw fills column i, or where
/// the test says, of an 8x4 target, each draw adding 0.2.
class IndirectGpu : public GpuTest
{
protected:
    /// @param options  pragmas
    static std::shared_ptr<const Material> MakeMaterial(const std::string& options,
                                                        const std::string& code)
    {
        return std::make_shared<const Material>(Shader::FromText(
            "Shader \"Test/Indirect\" { SubShader { Pass { Cull Off ZTest Always ZWrite Off\n"
            "Blend One One\nHLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n" +
                options + "#include \"UnityCG.cginc\"\n" + code + "\nENDHLSL } } }",
            "indirect.shader", ComputeCompiler()));
    }
    /// Two triangles from SV_VertexID, a texel wide and 4 high, which the draw's matrix moves.
    static std::shared_ptr<const Material> Columns()
    {
        return MakeMaterial(
            "", "float4 vert(uint v : SV_VertexID, uint i : SV_InstanceID) : SV_POSITION\n"
                "{ float2 c = float2(v == 1 || v == 4 || v == 5, v == 2 || v == 3 || v == 5);\n"
                "float2 p = mul(unity_ObjectToWorld, float4(c.x + i, 4 * c.y, 0, 1)).xy;\n"
                "return float4(p.x / 4 - 1, 1 - p.y / 2, 0.5, 1); }\n"
                "float4 frag() : SV_Target { return float4(0.2, 0, 0, 0); }");
    }
    std::vector<std::string> Draw(const std::function<void(CommandBuffer&)>& record)
    {
        auto rows = CountDrawn(8, 4, record);
        ExpectNoValidationMessages();
        return rows;
    }
    static std::vector<std::string> All(const std::string& row) { return {row, row, row, row}; }
};

/// Columns at x = 0 and, as sub-mesh 1, at x = 2, each 1 wide.
std::shared_ptr<const Mesh> TwoColumns()
{
    MeshData data;
    data.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 4, 0}, {1, 4, 0},
                     {2, 0, 0}, {3, 0, 0}, {2, 4, 0}, {3, 4, 0}};
    data.triangles = {0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7};
    data.subMeshes = {{0, 6}, {6, 6}};
    return std::make_shared<const Mesh>("two columns", std::move(data));
}

const glm::mat4 k_OneRight{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 1}};

} // namespace

TEST_F(IndirectGpu, DrawsWhatTheBufferSays)
{
    const auto buffer = MakeBuffer(Counts{6, 3, 0, 0, 6, 5, 0, 0, 6, 0, 0, 0}, k_Arguments);
    const auto draw = [&](int offset)
    {
        return Draw(
            [&](CommandBuffer& cmd) {
                cmd.DrawProceduralIndirect(k_OneRight, Columns(), 0, MeshTopology::Triangles,
                                           buffer, offset);
            });
    };
    EXPECT_EQ(draw(0), All(".111...."));
    EXPECT_EQ(draw(16), All(".11111.."));
    EXPECT_EQ(draw(32), All("........"));
    buffer->SetData(Counts{6, 7});
    EXPECT_EQ(draw(0), All(".1111111"));
}

TEST_F(IndirectGpu, DrawsWhatAKernelWroteBefore)
{
    const auto buffer = std::make_shared<GraphicsBuffer>(k_Arguments, 4, 4);
    const auto fill = MakeKernel("1, 1, 1", "RWStructuredBuffer<uint> _Out; uint _Count;",
                                 "_Out[0] = 6; _Out[1] = _Count; _Out[2] = 0; _Out[3] = 0;");
    fill->SetBuffer(0, "_Out", buffer);
    const auto rows = Draw(
        [&](CommandBuffer& cmd)
        {
            for (const int count : {4, 2})
            {
                cmd.SetComputeIntParam(fill, "_Count", count);
                cmd.DispatchCompute(fill, 0, 1, 1, 1);
                cmd.DrawProceduralIndirect(glm::mat4(1.0f), Columns(), 0, MeshTopology::Triangles,
                                           buffer);
            }
        });
    EXPECT_EQ(rows, All("2211....")); // the second kernel waited for the first draw
}

TEST_F(IndirectGpu, DrawsInstancesOfASubMeshWhereTheShaderPlacesThem)
{
    const auto material = MakeMaterial(
        "#pragma multi_compile_instancing\n#pragma instancing_options procedural:Place\n",
        "#ifdef UNITY_PROCEDURAL_INSTANCING_ENABLED\nStructuredBuffer<float> _Offsets;\n#endif\n"
        "void Place()\n{\n#ifdef UNITY_PROCEDURAL_INSTANCING_ENABLED\n"
        "unity_ObjectToWorld._14_24_34_44 = float4(_Offsets[unity_InstanceID], 0, 0, 1);\n"
        "#endif\n}\n"
        "struct A { float4 p : POSITION; UNITY_VERTEX_INPUT_INSTANCE_ID };\n"
        "struct V { float4 p : SV_POSITION; UNITY_VERTEX_INPUT_INSTANCE_ID };\n"
        "V vert(A a)\n{ V v; UNITY_SETUP_INSTANCE_ID(a); UNITY_TRANSFER_INSTANCE_ID(a, v);\n"
        "float2 p = mul(unity_ObjectToWorld, float4(a.p.xyz, 1)).xy;\n"
        "v.p = float4(p.x / 4 - 1, 1 - p.y / 2, 0.5, 1); return v; }\n"
        "float4 frag(V v) : SV_Target { UNITY_SETUP_INSTANCE_ID(v);\n"
        "return float4(0.2 * (1 + UNITY_GET_INSTANCE_ID(v)), 0, 0, 0); }");
    const auto mesh = TwoColumns();
    MaterialPropertyBlock block;
    block.SetBuffer("_Offsets", MakeBuffer(std::vector<float>{-2, 1, 4, 5}));
    const auto buffer = MakeBuffer(
        Counts{mesh->GetIndexCount(1), 3, mesh->GetIndexStart(1), mesh->GetBaseVertex(1), 0},
        k_Arguments);
    EXPECT_EQ(Draw([&](CommandBuffer& cmd)
                   { cmd.DrawMeshInstancedIndirect(mesh, 1, material, 0, buffer, 0, block); }),
              All("1..2..3."));
    EXPECT_EQ(Draw([&](CommandBuffer& cmd)
                   { cmd.DrawMeshInstancedProcedural(mesh, 1, material, 0, 4, block); }),
              All("1..2..34"));
    // Drawn one by one it is another variant, in which nothing places the mesh.
    EXPECT_EQ(Draw([&](CommandBuffer& cmd) { cmd.DrawMesh(mesh, k_OneRight, material, 1, 0); }),
              All("...1...."));
}

TEST_F(IndirectGpu, RunsAsManyGroupsAsAKernelWrote)
{
    const auto counts = std::make_shared<GraphicsBuffer>(k_Arguments, 7, 4);
    const auto fill = MakeKernel("1, 1, 1", "RWStructuredBuffer<uint> _Out;",
                                 "_Out[0] = 99; _Out[1] = 3; _Out[2] = 2; _Out[3] = 4;\n"
                                 "_Out[4] = 0; _Out[5] = 1; _Out[6] = 1;");
    const auto work = MakeKernel("2, 1, 1", "RWStructuredBuffer<uint> _Sum;",
                                 "InterlockedAdd(_Sum[0], 1); InterlockedMax(_Sum[1], group.x);\n"
                                 "InterlockedMax(_Sum[2], group.y);\n"
                                 "InterlockedMax(_Sum[3], group.z);");
    const auto sum = MakeBuffer(Counts{0, 0, 0, 0});
    fill->SetBuffer(0, "_Out", counts);
    work->SetBuffer(0, "_Sum", sum);
    CommandBuffer cmd;
    cmd.DispatchCompute(fill, 0, 1, 1, 1);
    cmd.DispatchCompute(work, 0, counts, 4);
    cmd.DispatchCompute(work, 0, counts, 16); // none
    RunCommands(cmd);
    ExpectNoValidationMessages();
    EXPECT_EQ(DataOf<std::uint32_t>(*sum), (Counts{2 * 3 * 2 * 4, 2, 1, 3}));
}

} // namespace limn::test
