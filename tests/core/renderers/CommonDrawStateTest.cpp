#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

using testing::Each;
using testing::ElementsAre;
using testing::Field;
using Rects = std::vector<std::optional<ViewportRect>>;

/// What scissor, inverted culling and depth bias make of the draws behind them.
class CommonDrawStates : public testing::Test
{
protected:
    CommonDrawStates() { m_Drawing.shaderTagIds = {ShaderTagId("UniversalForward")}; }

    void Triangle() { m_Cmd.DrawProcedural(glm::mat4(1.0f), m_Material, 0, 3); }
    void Cube(float x) { m_Cmd.DrawMesh(test::Cube(), At(x), m_Material); }
    static glm::mat4 At(float x)
    {
        glm::mat4 matrix(1.0f);
        matrix[3].x = x;
        return matrix;
    }
    /// Executes what was recorded, in a buffer of its own.
    void Execute()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Cmd.Clear();
    }
    void DrawScene()
    {
        m_Context.DrawRenderers(Cull(m_Scene, m_Camera, 1.0f), m_Drawing, FilteringSettings());
    }
    std::vector<test::SeenDraw> Draws()
    {
        Execute();
        return test::DrawsOf(m_Context.TakeCommands());
    }
    static Rects ScissorsOf(const std::vector<test::SeenDraw>& draws)
    {
        Rects rects;
        for (const test::SeenDraw& draw : draws)
        {
            rects.push_back(draw.scissor);
        }
        return rects;
    }
    static std::vector<bool> FlipsOf(const std::vector<test::SeenDraw>& draws)
    {
        std::vector<bool> flips;
        for (const test::SeenDraw& draw : draws)
        {
            flips.push_back(draw.state.frontFaceFlipped);
        }
        return flips;
    }

    RenderReport m_Report;
    ScriptableRenderContext m_Context{m_Report};
    CommandBuffer m_Cmd;
    Scene m_Scene;
    Camera m_Camera;
    DrawingSettings m_Drawing;
    const RTHandle m_Target{test::Target("Target")};
    const std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithProgram("", "", "1", "Offset 1, 2"));
};

constexpr ViewportRect k_Part{1, 2, 3, 1};

TEST_F(CommonDrawStates, AScissorHoldsForAllDrawsUntilItIsDisabled)
{
    test::AddCube(m_Scene, "cube", {0, 0, 5}, {m_Material});
    Triangle();
    m_Cmd.EnableScissorRect(k_Part);
    Triangle();
    Execute();
    DrawScene();
    m_Cmd.SetRenderTarget(m_Target);
    Cube(1);
    m_Cmd.DisableScissorRect();
    Triangle();
    EXPECT_EQ(ScissorsOf(Draws()), (Rects{std::nullopt, k_Part, k_Part, k_Part, std::nullopt}));
}

TEST_F(CommonDrawStates, DrawsOfOneScissorBecomeInstances)
{
    Cube(1);
    Cube(2);
    m_Cmd.EnableScissorRect(k_Part);
    Cube(3);
    Cube(4);
    m_Cmd.EnableScissorRect({0, 0, 3, 1});
    Cube(5);
    EXPECT_THAT(Draws(), ElementsAre(Field(&DrawCommand::instanceCount, 2u),
                                     Field(&DrawCommand::instanceCount, 2u),
                                     Field(&DrawCommand::instanceCount, 1u)));
}

TEST_F(CommonDrawStates, AnObjectsFrontFaceIsInverted)
{
    for (const bool isMirrored : {false, true})
    {
        Scene scene;
        test::AddCube(scene, "cube", {0, 0, 5}, {m_Material}).transform.localScale.x =
            isMirrored ? -1.0f : 1.0f;
        for (const bool isInverted : {false, true})
        {
            m_Cmd.SetInvertCulling(isInverted);
            Execute();
            m_Context.DrawRenderers(Cull(scene, m_Camera, 1.0f), m_Drawing, FilteringSettings());
            // The projection into a texture mirrors once more.
            EXPECT_EQ(FlipsOf(Draws()), std::vector<bool>{isMirrored == isInverted});
            m_Context.Begin(m_Report, glm::dvec3(0.0));
        }
    }
}

TEST_F(CommonDrawStates, AMeshsAndAFullScreenTrianglesFrontFaceAreInverted)
{
    const auto both = [&]
    {
        Cube(1);
        Triangle();
    };
    both();
    m_Cmd.SetInvertCulling(true);
    both();
    m_Cmd.SetInvertCulling(false);
    both();
    EXPECT_EQ(FlipsOf(Draws()), (std::vector<bool>{true, true, false, false, true, true}));
}

TEST_F(CommonDrawStates, ADepthBiasIsAddedToThePassesOffset)
{
    m_Cmd.SetGlobalDepthBias(0.5f, -4.0f);
    Triangle();
    m_Cmd.SetGlobalDepthBias(0.0f, 0.0f);
    Triangle();
    const auto draws = Draws();
    EXPECT_EQ(draws.at(0).state.offsetFactor, 1.0f - 4.0f);
    EXPECT_EQ(draws.at(0).state.offsetUnits, 2.0f + 0.5f);
    EXPECT_EQ(draws.at(1).state.offsetFactor, 1.0f);
    EXPECT_EQ(draws.at(1).state.offsetUnits, 2.0f);
}

TEST_F(CommonDrawStates, ACameraBeginsWithoutAny)
{
    const auto set = [&]
    {
        m_Cmd.EnableScissorRect(k_Part);
        m_Cmd.SetInvertCulling(true);
        m_Cmd.SetGlobalDepthBias(1.0f, 1.0f);
        Execute();
    };
    set();
    m_Context.BeginCamera({});
    Cube(1);
    Execute();
    set();
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    Cube(1);
    const test::SeenDraw draw = Draws().at(0);
    EXPECT_FALSE(draw.scissor);
    EXPECT_TRUE(draw.state.frontFaceFlipped);
    EXPECT_EQ(draw.state.offsetUnits, 2.0f);
}

TEST_F(CommonDrawStates, WhatIsRecordedAtAnEarlierPlaceHasThoseOfThen)
{
    m_Cmd.EnableScissorRect(k_Part);
    Execute();
    const ScriptableRenderContext::Place place = m_Context.MarkPlace();
    m_Cmd.DisableScissorRect();
    Triangle();
    Execute();
    m_Context.RecordAt(place,
                       [&]
                       {
                           Triangle();
                           m_Cmd.EnableScissorRect({0, 0, 1, 1});
                           Execute();
                       });
    Triangle();
    EXPECT_EQ(ScissorsOf(Draws()), (Rects{k_Part, std::nullopt, std::nullopt}));
}

TEST_F(CommonDrawStates, APassThatCoversItsTargetDoesNotWhereItIsCutOffOrCulled)
{
    const auto covering = [](const std::string& cull)
    {
        return std::make_shared<Material>(
            test::ShaderOf("Shader \"Test/Cover\" { SubShader { Pass { Tags { \"LimnFullScreen\" = "
                           "\"True\" } Cull " +
                           cull + "\n" + test::Program() + "} } }"));
    };
    const auto culled = covering("Back");
    const auto plain = covering("Off");
    const auto draw = [&]
    {
        m_Cmd.DrawProcedural(glm::mat4(1.0f), culled, 0, 3);
        m_Cmd.DrawProcedural(glm::mat4(1.0f), plain, 0, 3);
    };
    draw();
    m_Cmd.SetInvertCulling(true);
    draw();
    m_Cmd.SetInvertCulling(false);
    m_Cmd.EnableScissorRect(k_Part);
    draw();
    std::vector<bool> covers;
    for (const test::SeenDraw& seen : Draws())
    {
        covers.push_back(seen.fullScreen != nullptr);
    }
    EXPECT_EQ(covers, (std::vector<bool>{true, true, false, true, false, false}));
}

TEST_F(CommonDrawStates, AreRefusedWhereTheyMakeNoSense)
{
    const auto message = [&](auto&& call)
    {
        return test::ThrownMessage<ContractError>(call);
    };
    constexpr int k_Most = std::numeric_limits<int>::max();
    EXPECT_THAT(message(
                    [&] {
                        m_Cmd.EnableScissorRect({0, 0, -1, 4});
                    }),
                Mentions("EnableScissorRect", "-1x4", "0 or more"));
    EXPECT_THAT(message(
                    [&] {
                        m_Cmd.EnableScissorRect({1, 0, k_Most, 4});
                    }),
                Mentions("EnableScissorRect", "2147483647x4", "(1, 0)", "beyond", "2147483647"));
    EXPECT_THAT(
        message([&] { m_Cmd.SetGlobalDepthBias(std::numeric_limits<float>::infinity(), 0.0f); }),
        Mentions("SetGlobalDepthBias", "inf, 0;", "finite"));
    m_Cmd.EnableScissorRect({0, 0, 0, 0}); // nothing is drawn
    Triangle();
    EXPECT_EQ(ScissorsOf(Draws()), (Rects{ViewportRect{}}));
}

/// What DrawMeshInstanced comes to.
class MeshInstances : public CommonDrawStates
{
};

TEST_F(MeshInstances, AreOneDraw)
{
    const std::vector<glm::mat4> matrices{At(1), At(2), At(3)};
    m_Cmd.DrawMeshInstanced(test::Cube(), 0, m_Material, 0, matrices);
    Execute();
    const FrameCommands frame = m_Context.TakeCommands();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 1u);
    ASSERT_EQ(draws[0].instanceCount, 3u);
    for (std::uint32_t i = 0; i < 3; ++i)
    {
        EXPECT_EQ(frame.PerDraw(draws[0], i).objectToWorld[12], static_cast<float>(i + 1));
    }
}

TEST_F(MeshInstances, OfAllPassesAreDrawnPassByPass)
{
    const auto twoPasses = std::make_shared<Material>(
        test::ShaderOf("Shader \"Test/Two\" { SubShader { Pass { Cull Front " + test::Program() +
                       "} Pass { Cull Off " + test::Program() + "} } }"));
    const std::vector<glm::mat4> matrices{At(1), At(2)};
    m_Cmd.DrawMeshInstanced(test::Cube(), 0, twoPasses, -1, matrices);
    const auto draws = Draws();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].state.cull, CullMode::Front);
    EXPECT_EQ(draws[1].state.cull, CullMode::Off);
    EXPECT_THAT(draws, Each(Field(&DrawCommand::instanceCount, 2u)));
}

TEST_F(MeshInstances, AreAsManyAsInUnityAtMost)
{
    const std::vector<glm::mat4> most(1023, At(0));
    m_Cmd.DrawMeshInstanced(test::Cube(), 0, m_Material, 0, most);
    EXPECT_EQ(Draws().at(0).instanceCount, 1023u);
    const std::vector<glm::mat4> more(1024, At(0));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { m_Cmd.DrawMeshInstanced(test::Cube(), 0, m_Material, 0, more); }),
                Mentions("DrawMeshInstanced", "1024 matrices", "at most 1023"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { m_Cmd.DrawMeshInstanced(test::Cube(), 0, m_Material, 0, most, 1024); }),
                Mentions("DrawMeshInstanced", "count is 1024", "1023 matrices"));
    m_Cmd.Clear();
    m_Cmd.DrawMeshInstanced(test::Cube(), 0, m_Material, 0, more, 3);
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    EXPECT_EQ(Draws().at(0).instanceCount, 3u) << "the first three";
    m_Cmd.Clear();
    m_Cmd.DrawMeshInstanced(test::Cube(), 0, m_Material, 0, {});
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    EXPECT_TRUE(Draws().empty());
}

} // namespace
} // namespace limn
