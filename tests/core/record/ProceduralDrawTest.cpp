#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/DrawError.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

/// What DrawProcedural with a topology and a number of instances comes to.
class ProceduralDraws : public testing::Test
{
protected:
    void Draw(MeshTopology topology, int vertexCount, int instanceCount = 1)
    {
        glm::mat4 matrix(1.0f);
        matrix[3].x = 7.0f;
        m_Cmd.DrawProcedural(matrix, m_Material, 0, topology, vertexCount, instanceCount);
    }
    std::vector<test::SeenDraw> Execute()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Frame = m_Context.TakeCommands();
        return test::DrawsOf(m_Frame);
    }

    RenderReport m_Report;
    ScriptableRenderContext m_Context{m_Report};
    CommandBuffer m_Cmd;
    FrameCommands m_Frame;
    std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithProgram(""));
};

TEST_F(ProceduralDraws, HaveTheirTopologyAndInstances)
{
    Draw(MeshTopology::LineStrip, 5, 3);
    Draw(MeshTopology::Lines, 4);
    Draw(MeshTopology::Triangles, 6, 2);
    const auto draws = Execute();
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_EQ(draws[0].state.topology, MeshTopology::LineStrip);
    EXPECT_EQ(draws[0].vertexCount, 5u);
    EXPECT_EQ(draws[0].instanceCount, 3u);
    EXPECT_EQ(draws[1].state.topology, MeshTopology::Lines);
    EXPECT_EQ(draws[1].instanceCount, 1u);
    EXPECT_EQ(draws[2].state.topology, MeshTopology::Triangles);
    EXPECT_EQ(draws[2].instanceCount, 2u);
    for (const test::SeenDraw& draw : draws)
    {
        for (std::uint32_t i = 0; i < draw.instanceCount; ++i)
        {
            EXPECT_EQ(m_Frame.PerDraw(draw, i).objectToWorld[12], 7.0f) << "of the whole draw";
        }
    }
}

TEST_F(ProceduralDraws, OfNoInstancesAreNone)
{
    Draw(MeshTopology::Triangles, 3, 0);
    EXPECT_TRUE(Execute().empty());
}

TEST_F(ProceduralDraws, OfLinesCoverNothing)
{
    m_Material = std::make_shared<Material>(test::ShaderOf(
        "Shader \"Test/Cover\" { SubShader { Pass { Tags { \"LimnFullScreen\" = \"True\" }\n" +
        test::Program() + "} } }"));
    Draw(MeshTopology::Triangles, 3);
    Draw(MeshTopology::Lines, 2);
    const auto draws = Execute();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_NE(draws[0].fullScreen, nullptr);
    EXPECT_EQ(draws[1].fullScreen, nullptr);
}

TEST_F(ProceduralDraws, OfQuadsAreTrianglesOfTheirCorners)
{
    Draw(MeshTopology::Quads, 9, 2); // the ninth vertex makes no quad
    Draw(MeshTopology::Quads, 8);
    Draw(MeshTopology::Quads, 3);
    Draw(MeshTopology::Points, 3);
    const auto draws = Execute();
    ASSERT_EQ(draws.size(), 3u);
    ASSERT_TRUE(draws[0].mesh);
    EXPECT_THAT(draws[0].mesh->data().triangles,
                testing::ElementsAre(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7));
    EXPECT_EQ(draws[0].state.topology, MeshTopology::Triangles);
    EXPECT_EQ(draws[0].instanceCount, 2u);
    EXPECT_EQ(draws[1].mesh, draws[0].mesh) << "the same indices";
    EXPECT_EQ(draws[1].instanceCount, 1u);
    EXPECT_EQ(draws[0].fullScreen, nullptr);
    EXPECT_EQ(draws[2].mesh, nullptr);
    EXPECT_EQ(draws[2].state.topology, MeshTopology::Points);
    EXPECT_EQ(draws[2].vertexCount, 3u);
}

TEST_F(ProceduralDraws, OfQuadsFaceTheSameWayAsTheTrianglesWould)
{
    Draw(MeshTopology::Quads, 4);
    Draw(MeshTopology::Triangles, 3);
    const auto draws = Execute();
    EXPECT_EQ(draws.at(0).state.frontFaceFlipped, draws.at(1).state.frontFaceFlipped);
}

TEST_F(ProceduralDraws, AreRefusedWhereNoDeviceDrawsThem)
{
    const auto message = [&](MeshTopology topology, int vertices, int instances)
    {
        return test::ThrownMessage<ContractError>([&] { Draw(topology, vertices, instances); });
    };
    const auto arguments =
        std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::IndirectArguments, 4, 4);
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] {
                        m_Cmd.DrawProceduralIndirect(glm::mat4(1.0f), m_Material, 0,
                                                     MeshTopology::Quads, arguments);
                    }),
                Mentions("DrawProceduralIndirect", "Quads", "without indices", "Triangles"));
    EXPECT_THAT(message(MeshTopology::Lines, -1, 1),
                Mentions("DrawProcedural", "vertex count -1", "negative"));
    EXPECT_THAT(message(MeshTopology::Lines, 2, -1),
                Mentions("DrawProcedural", "instance count -1", "negative"));
}

/// What a renderer's own property block does to its draws.
class RendererBlocks : public testing::Test
{
protected:
    RendererBlocks() { m_Drawing.shaderTagIds = {ShaderTagId("UniversalForward")}; }

    static MaterialPropertyBlock Block(float tint)
    {
        MaterialPropertyBlock block;
        block.SetFloat("_Tint", tint);
        return block;
    }
    GameObject& AddCube(float x) { return test::AddCube(m_Scene, "cube", {x, 0, 5}, {m_Material}); }
    /// _Tint and the number of instances of each draw.
    std::vector<std::pair<float, std::uint32_t>> Draw()
    {
        Camera camera;
        camera.orthographic = true;
        m_Context.Begin(m_Report, glm::dvec3(0.0));
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Context.DrawRenderers(Cull(m_Scene, camera, 1.0f), m_Drawing, FilteringSettings());
        const FrameCommands frame = m_Context.TakeCommands();
        std::vector<std::pair<float, std::uint32_t>> result;
        for (const test::SeenDraw& draw : test::DrawsOf(frame))
        {
            result.emplace_back(test::ReadUniform<float>(frame, draw, "_Tint", 1)[0],
                                draw.instanceCount);
        }
        return result;
    }

    RenderReport m_Report;
    ScriptableRenderContext m_Context;
    CommandBuffer m_Cmd;
    DrawingSettings m_Drawing;
    Scene m_Scene;
    const std::shared_ptr<Material> m_Material = std::make_shared<Material>(
        test::ShaderWithProgram("_Tint (\"\", Float) = 1", "float _Tint;", "_Tint"));
};

using testing::ElementsAre;
using testing::Pair;
using testing::UnorderedElementsAre;

TEST_F(RendererBlocks, WinOverTheMaterialForTheirRendererOnly)
{
    AddCube(-1);
    GameObject& other = AddCube(0);
    AddCube(1);
    EXPECT_THAT(Draw(), ElementsAre(Pair(1.0f, 3u))) << "in the scene's order";
    other.renderer->SetPropertyBlock(Block(8));
    EXPECT_THAT(Draw(), ElementsAre(Pair(1.0f, 1u), Pair(8.0f, 1u), Pair(1.0f, 1u)));
    other.renderer->SetPropertyBlock(Block(9));
    EXPECT_THAT(Draw(), ElementsAre(Pair(1.0f, 1u), Pair(9.0f, 1u), Pair(1.0f, 1u)));
    other.renderer->SetPropertyBlock({});
    EXPECT_THAT(Draw(), ElementsAre(Pair(1.0f, 3u)));
}

TEST_F(RendererBlocks, AreFollowedFromFrameToFrame)
{
    GameObject& cube = AddCube(0);
    for (int frame = 0; frame < 20; ++frame)
    {
        const auto tint = static_cast<float>(frame);
        cube.renderer->SetPropertyBlock(Block(-tint)); // nobody sees this one
        cube.renderer->SetPropertyBlock(Block(tint));
        EXPECT_THAT(Draw(), ElementsAre(Pair(tint, 1u)));
    }
}

TEST_F(RendererBlocks, AreCopies)
{
    GameObject& cube = AddCube(0);
    MaterialPropertyBlock block = Block(3);
    EXPECT_FALSE(cube.renderer->HasPropertyBlock());
    cube.renderer->SetPropertyBlock(block);
    EXPECT_TRUE(cube.renderer->HasPropertyBlock());
    block.SetFloat("_Tint", 4);
    EXPECT_THAT(Draw(), ElementsAre(Pair(3.0f, 1u)));
    cube.renderer->GetPropertyBlock(block);
    EXPECT_EQ(*block.Find("_Tint"), ShaderPropertyValue(3.0f));
    cube.renderer->SetPropertyBlock({});
    cube.renderer->GetPropertyBlock(block);
    EXPECT_TRUE(block.isEmpty());
}

TEST_F(RendererBlocks, OfACopiedRendererAreItsOwn)
{
    GameObject& cube = AddCube(0);
    cube.renderer->SetPropertyBlock(Block(3));
    cube.renderer->SetPropertyBlock(Block(4), 0);
    GameObject& copy = AddCube(1);
    copy.renderer = cube.renderer;
    EXPECT_THAT(Draw(), ElementsAre(Pair(4.0f, 2u)));
    copy.renderer->SetPropertyBlock({}, 0);
    EXPECT_THAT(Draw(), UnorderedElementsAre(Pair(4.0f, 1u), Pair(3.0f, 1u)));
    copy.renderer->SetPropertyBlock({});
    EXPECT_FALSE(copy.renderer->HasPropertyBlock());
    EXPECT_TRUE(cube.renderer->HasPropertyBlock());
    EXPECT_THAT(Draw(), UnorderedElementsAre(Pair(4.0f, 1u), Pair(1.0f, 1u)));
}

TEST_F(RendererBlocks, WinOverAnOverrideMaterial)
{
    AddCube(0).renderer->SetPropertyBlock(Block(5));
    const auto over = std::make_shared<Material>(m_Material->shader());
    over->SetFloat("_Tint", 6);
    m_Drawing.overrideMaterial = over;
    EXPECT_THAT(Draw(), ElementsAre(Pair(5.0f, 1u)));
}

TEST_F(RendererBlocks, HoldForDrawRendererBehindItsOwnBlock)
{
    GameObject& cube = AddCube(0);
    cube.activeSelf = false;
    cube.renderer->SetPropertyBlock(Block(5));
    m_Cmd.DrawRenderer(cube, m_Material, 0, 0);
    m_Cmd.DrawRenderer(cube, m_Material, 0, 0, Block(7));
    EXPECT_THAT(Draw(), ElementsAre(Pair(5.0f, 1u), Pair(7.0f, 1u)));
}

TEST_F(RendererBlocks, OfOneMaterialTakeThePlaceOfTheRenderers)
{
    const auto second = std::make_shared<Material>(m_Material->shader());
    second->SetFloat("_Tint", 2);
    GameObject& cube = AddCube(0);
    cube.renderer->sharedMaterials = {m_Material, second};
    EXPECT_THAT(Draw(), ElementsAre(Pair(1.0f, 1u), Pair(2.0f, 1u)));
    cube.renderer->SetPropertyBlock(Block(7), 1);
    EXPECT_TRUE(cube.renderer->HasPropertyBlock());
    EXPECT_THAT(Draw(), ElementsAre(Pair(1.0f, 1u), Pair(7.0f, 1u)));
    cube.renderer->SetPropertyBlock(Block(5));
    EXPECT_THAT(Draw(), ElementsAre(Pair(5.0f, 1u), Pair(7.0f, 1u)));
    MaterialPropertyBlock block;
    block.SetFloat("_Other", 3);
    cube.renderer->SetPropertyBlock(block, 1); // and none of the renderer's _Tint
    EXPECT_THAT(Draw(), ElementsAre(Pair(5.0f, 1u), Pair(2.0f, 1u)));
    cube.renderer->SetPropertyBlock({}, 1);
    cube.renderer->GetPropertyBlock(block, 1);
    EXPECT_TRUE(block.isEmpty());
    EXPECT_THAT(Draw(), ElementsAre(Pair(5.0f, 1u), Pair(5.0f, 1u)));
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { cube.renderer->SetPropertyBlock(Block(1), 2); }),
        Mentions("SetPropertyBlock", "no material 2", "has 2"));
}

// Many kinds of draws: each object keeps its own values, whatever is sorted or batched.
TEST_F(RendererBlocks, StayWithTheirObjectsAmongMany)
{
    constexpr int k_Count = 60;
    for (int i = 0; i < k_Count; ++i)
    {
        GameObject& cube = AddCube(0);
        cube.renderer->SetPropertyBlock(Block(static_cast<float>(i % 7)));
        cube.transform.localPosition.x = static_cast<float>(i % 7) * 0.5f - 1.5f;
    }
    Camera camera;
    camera.orthographic = true;
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    m_Context.DrawRenderers(Cull(m_Scene, camera, 1.0f), m_Drawing, FilteringSettings());
    const FrameCommands frame = m_Context.TakeCommands();
    std::uint32_t count = 0;
    for (const test::SeenDraw& draw : test::DrawsOf(frame))
    {
        const float tint = test::ReadUniform<float>(frame, draw, "_Tint", 1)[0];
        for (std::uint32_t i = 0; i < draw.instanceCount; ++i)
        {
            EXPECT_EQ(frame.PerDraw(draw, i).objectToWorld[12], tint * 0.5f - 1.5f);
        }
        count += draw.instanceCount;
    }
    EXPECT_EQ(count, static_cast<std::uint32_t>(k_Count));
}

} // namespace
} // namespace limn
