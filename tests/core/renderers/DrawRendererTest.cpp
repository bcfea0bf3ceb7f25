#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "record/RecordedCommands.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

/// What CommandBuffer::DrawRenderer comes to in a frame.
class DrawRendererCalls : public testing::Test
{
protected:
    FrameCommands Execute(const glm::dvec3& origin = glm::dvec3(0.0))
    {
        m_Context.Begin(m_Report, origin);
        m_Context.ExecuteCommandBuffer(m_Cmd);
        return m_Context.TakeCommands();
    }
    GameObject& AddCube() { return test::AddCube(m_Scene, "Cube", {1, 2, 3}, {m_Material}); }

    RenderReport m_Report;
    ScriptableRenderContext m_Context;
    CommandBuffer m_Cmd;
    Scene m_Scene;
    const std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithProgram("", "float _Value;", "_Value"), "Paint");
    const std::shared_ptr<const Material> m_TwoPasses = std::make_shared<Material>(
        test::ShaderOf("Shader \"Test/Two\" { SubShader { Pass { Cull Front " + test::Program() +
                       "} Pass { Cull Off " + test::Program() + "} } }"),
        "Two");
};

bool AreEqual(const PerDrawData& a, const PerDrawData& b)
{
    return std::ranges::equal(a.objectToWorld, b.objectToWorld) &&
           std::ranges::equal(a.worldToObject, b.worldToObject) &&
           std::ranges::equal(a.worldTransformParams, b.worldTransformParams) &&
           std::ranges::equal(a.renderingLayer, b.renderingLayer);
}

} // namespace

// The reference is what DrawRenderers tells shaders of the same object.
TEST_F(DrawRendererCalls, TellShadersOfAnObjectWhatOtherDrawsDo)
{
    for (const double distance : {0.0, 1e4, 1e7, 1e9})
    {
        Transform away;
        away.localPosition = glm::dvec3(distance, -distance, distance / 3.0);
        Scene scene;
        GameObject& cube = test::AddCube(scene, "Cube", {0.3f, 0.2f, 5.0f}, {m_Material});
        cube.transform.parent = &away;
        cube.transform.localScale = {-2.0f, 1.0f, 0.5f};
        cube.renderer->renderingLayerMask = RenderingLayerMask(0x105);
        Camera camera;
        camera.transform.parent = &away;

        m_Context.Begin(m_Report, camera.renderOrigin());
        DrawingSettings drawing;
        drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
        m_Context.DrawRenderers(Cull(scene, camera, 1.0f), drawing, FilteringSettings());
        m_Cmd.Clear();
        m_Cmd.DrawRenderer(cube, m_Material);
        m_Context.ExecuteCommandBuffer(m_Cmd);
        const FrameCommands frame = m_Context.TakeCommands();
        const auto draws = test::DrawsOf(frame);
        ASSERT_EQ(draws.size(), 2u) << distance;
        EXPECT_EQ(draws[1].mesh, draws[0].mesh);
        EXPECT_EQ(draws[1].state.frontFaceFlipped, draws[0].state.frontFaceFlipped);
        EXPECT_TRUE(AreEqual(frame.PerDraw(draws[0]), frame.PerDraw(draws[1]))) << distance;
    }
}

TEST_F(DrawRendererCalls, DrawWhateverCullingAndSwitchesSay)
{
    GameObject& cube = AddCube();
    cube.activeSelf = false;
    cube.renderer->enabled = false;
    cube.transform.localPosition.z = -100.0f; // behind every camera
    m_Cmd.DrawRenderer(cube, m_Material);
    EXPECT_EQ(test::DrawsOf(Execute()).size(), 1u);
}

TEST_F(DrawRendererCalls, DrawAllPassesUnlessOneIsNamed)
{
    const GameObject& cube = AddCube();
    m_Cmd.DrawRenderer(cube, m_TwoPasses);
    m_Cmd.DrawRenderer(cube, m_TwoPasses, 0, 0);
    const auto draws = test::DrawsOf(Execute());
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_EQ(draws[0].shaderPass, 0);
    EXPECT_EQ(draws[1].shaderPass, 1);
    EXPECT_EQ(draws[2].shaderPass, 0);
}

TEST_F(DrawRendererCalls, GiveEachDrawItsProperties)
{
    const GameObject& cube = AddCube();
    MaterialPropertyBlock block;
    for (const float value : {1.0f, 2.0f})
    {
        block.SetFloat(ShaderPropertyId("_Value"), value);
        m_Cmd.DrawRenderer(cube, m_Material, 0, -1, block);
    }
    const FrameCommands frame = Execute();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(test::ReadUniform<float>(frame, draws[0], "_Value", 1)[0], 1.0f);
    EXPECT_EQ(test::ReadUniform<float>(frame, draws[1], "_Value", 1)[0], 2.0f);
}

TEST_F(DrawRendererCalls, DrawNothingOfARendererWithoutAMesh)
{
    GameObject& cube = AddCube();
    cube.renderer->mesh = nullptr;
    m_Cmd.DrawRenderer(cube, m_Material);
    EXPECT_TRUE(m_Cmd.commands().empty());
}

TEST_F(DrawRendererCalls, RefuseWhatIsNotThere)
{
    const auto errorOf = [&](const GameObject& object, std::shared_ptr<const Material> material,
                             int subMesh, int pass)
    {
        const std::string message = test::ThrownMessage<ContractError>(
            [&] { m_Cmd.DrawRenderer(object, material, subMesh, pass); });
        EXPECT_TRUE(m_Cmd.commands().empty()) << "nothing is recorded by a call that throws";
        return message;
    };
    GameObject& cube = AddCube();
    EXPECT_THAT(errorOf(m_Scene.Add("Empty"), m_Material, 0, -1),
                Mentions("DrawRenderer", "'Empty'", "no renderer"));
    EXPECT_THAT(errorOf(cube, nullptr, 0, -1), Mentions("DrawRenderer", "material", "null"));
    EXPECT_THAT(errorOf(cube, m_TwoPasses, 0, 2),
                Mentions("'Two'", "'Test/Two'", "no pass 2", "has 2"));
    EXPECT_THAT(errorOf(cube, m_TwoPasses, 0, -2),
                Mentions("'Two'", "'Test/Two'", "no pass -2", "has 2"));
    EXPECT_THAT(errorOf(cube, m_Material, 1, -1),
                Mentions("'" + test::Cube()->name() + "'", "no sub-mesh 1", "has 1"));
    cube.transform.localPosition.x = HUGE_VALF;
    EXPECT_THAT(errorOf(cube, m_Material, 0, -1), Mentions("'Paint'", "matrix", "not finite"));
}

} // namespace limn
