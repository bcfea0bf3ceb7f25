#include "compute/ComputeRun.h"

#include <limn/core/Material.h>
#include <limn/core/Mesh.h>

namespace limn::test
{

namespace
{

constexpr int k_Width = 8;

/// Meshes that lie in one buffer on the device. Each fills a column of an 8x2 target, by a unit
/// square that its first vertex' x places.
class MeshesOfABlockGpu : public GpuTest
{
protected:
    static std::shared_ptr<const Material> MakeMaterial(const std::string& vertexFunction)
    {
        return std::make_shared<const Material>(Shader::FromText(
            "Shader \"Test/Column\" { SubShader { Pass { Cull Off ZTest Always ZWrite Off\n"
            "Blend One One\nHLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n"
            "#include \"UnityCG.cginc\"\nstruct V { float4 p : SV_POSITION; float4 c : COLOR; };\n"
            "V Place(float2 p, float4 c)\n{ V v; v.p = float4(p.x / 4 - 1, 1 - 2 * p.y, 0.5, 1);\n"
            "v.c = c; return v; }\n" +
                vertexFunction + "\nfloat4 frag(V v) : SV_Target { return v.c; }\nENDHLSL } } }",
            "column.shader", ComputeCompiler()));
    }
    /// 0.2 where a mesh has no colours, which are white then, else 0.2 times their red.
    static std::shared_ptr<const Material> Colored()
    {
        static const auto material = MakeMaterial(
            "V vert(float4 p : POSITION, float4 c : COLOR) { return Place(p.xy, c * 0.2); }");
        return material;
    }
    /// Vertices are told apart by their numbers alone.
    static std::shared_ptr<const Material> Numbered()
    {
        static const auto material = MakeMaterial(
            "V vert(float4 p : POSITION, uint i : SV_VertexID)\n"
            "{ return Place(float2(p.x + (i == 1 || i == 3), i == 2 || i == 3), 0.2); }");
        return material;
    }
    std::string Draw(const std::function<void(CommandBuffer&)>& record)
    {
        const auto rows = CountDrawn(k_Width, 1, record);
        ExpectNoValidationMessages();
        return rows.front();
    }
    static std::string DrawEach(MeshesOfABlockGpu& test,
                                const std::vector<std::shared_ptr<const Mesh>>& meshes,
                                const std::shared_ptr<const Material>& material)
    {
        return test.Draw(
            [&](CommandBuffer& cmd)
            {
                for (const auto& mesh : meshes)
                {
                    cmd.DrawMesh(mesh, glm::mat4(1.0f), material, 0, 0);
                }
            });
    }
};

/// @param red  of its vertices; 0 = it has no colours
std::shared_ptr<const Mesh> Column(int x, float red = 0.0f)
{
    const auto left = static_cast<float>(x);
    MeshData data;
    data.vertices = {{left, 0, 0}, {left + 1, 0, 0}, {left, 1, 0}, {left + 1, 1, 0}};
    data.triangles = {0, 1, 2, 2, 1, 3};
    if (red > 0.0f)
    {
        data.colors.assign(4, {red, 0, 0, 0});
    }
    return std::make_shared<const Mesh>("column " + std::to_string(x), std::move(data));
}

/// For shaders that know corners by the vertices' numbers.
std::shared_ptr<const Mesh> Corner(int x)
{
    MeshData data;
    data.vertices.assign(4, {static_cast<float>(x), 0, 0});
    data.triangles = {0, 1, 2, 2, 1, 3};
    return std::make_shared<const Mesh>("corner " + std::to_string(x), std::move(data));
}

/// Of more vertices than share a block; only its last four are drawn.
std::shared_ptr<const Mesh> LargeColumn(int x)
{
    const auto left = static_cast<float>(x);
    MeshData data;
    data.vertices.assign(20000, {left, 0, 0});
    data.vertices[19997] = {left + 1, 0, 0};
    data.vertices[19998] = {left, 1, 0};
    data.vertices[19999] = {left + 1, 1, 0};
    data.triangles = {19996, 19997, 19998, 19998, 19997, 19999};
    return std::make_shared<const Mesh>("large column", std::move(data));
}

} // namespace

TEST_F(MeshesOfABlockGpu, AreDrawnEachByItsOwnVertices)
{
    EXPECT_EQ(DrawEach(*this, {Column(5), Column(0), Column(2), Column(0)}, Colored()), "2.1..1..");
}

TEST_F(MeshesOfABlockGpu, MayHaveOtherAttributesThanTheirNeighbours)
{
    EXPECT_EQ(DrawEach(*this, {Column(1), Column(3, 2.0f), Column(4), LargeColumn(7), Column(6, 3)},
                       Colored()),
              ".1.21.31");
}

TEST_F(MeshesOfABlockGpu, CountTheirVerticesFromZero)
{
    EXPECT_EQ(DrawEach(*this, {Corner(6), Corner(1), Corner(3)}, Numbered()), ".1.1..1.");
}

TEST_F(MeshesOfABlockGpu, AreReadByShadersOfBothKinds)
{
    const auto drawn = Draw(
        [&](CommandBuffer& cmd)
        {
            const auto column = Column(4);
            const auto corner = Corner(2);
            cmd.DrawMesh(Column(0), glm::mat4(1.0f), Colored(), 0, 0);
            cmd.DrawMesh(corner, glm::mat4(1.0f), Numbered(), 0, 0);
            cmd.DrawMesh(column, glm::mat4(1.0f), Numbered(), 0, 0); // as wide as two
            cmd.DrawMesh(column, glm::mat4(1.0f), Colored(), 0, 0);
        });
    EXPECT_EQ(drawn, "1.1.21..");
}

TEST_F(MeshesOfABlockGpu, AreDrawnByTheCountsOfABufferToo)
{
    const auto mesh = Column(3);
    const auto counts =
        MakeBuffer(std::vector<std::uint32_t>{mesh->GetIndexCount(0), 1, mesh->GetIndexStart(0),
                                              mesh->GetBaseVertex(0), 0},
                   GraphicsBuffer::Target::IndirectArguments);
    const auto drawn = Draw(
        [&](CommandBuffer& cmd)
        {
            cmd.DrawMesh(Column(0), glm::mat4(1.0f), Colored(), 0, 0);
            cmd.DrawMesh(mesh, glm::mat4(1.0f), Colored(), 0, 0);
            cmd.DrawMeshInstancedIndirect(mesh, 0, Colored(), 0, counts);
            cmd.DrawMesh(mesh, glm::mat4(1.0f), Colored(), 0, 0);
        });
    EXPECT_EQ(drawn, "1..3....");
}

TEST_F(MeshesOfABlockGpu, LeaveTheirPlaceToOthersWhenTheyGo)
{
    const auto kept = Column(7);
    std::vector<std::shared_ptr<const Mesh>> meshes{Column(0), kept, Column(2)};
    EXPECT_EQ(DrawEach(*this, meshes, Colored()), "1.1....1");
    std::uint64_t bytes = 0;
    for (int i = 0; i < 40; ++i)
    {
        meshes = {Column(i % 6), kept, Column(6)};
        std::string expected = "......11";
        expected[static_cast<std::size_t>(i % 6)] = '1';
        ASSERT_EQ(DrawEach(*this, meshes, Colored()), expected) << i;
        if (i == 10)
        {
            bytes = SharedDevice().statistics().usedBytes;
        }
    }
    EXPECT_LE(SharedDevice().statistics().usedBytes, bytes);
    EXPECT_EQ(DrawEach(*this, {kept}, Colored()), ".......1");
}

TEST_F(MeshesOfABlockGpu, AreMoreThanOneHolds)
{
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (int i = 0; i < 1400; ++i) // 1 024 of them fill one
    {
        meshes.push_back(Column(i % 7));
    }
    meshes.push_back(Column(7));
    const std::vector<std::shared_ptr<const Mesh>> some{meshes[3], meshes[1000], meshes[1100],
                                                        meshes[1399], meshes[1400]};
    DrawEach(*this, meshes, Colored());
    // 3, 1000 % 7 = 6, 1100 % 7 = 1, 1399 % 7 = 6, 7
    EXPECT_EQ(DrawEach(*this, some, Colored()), ".1.1..21");
}

} // namespace limn::test
