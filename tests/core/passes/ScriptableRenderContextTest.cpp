#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

const ShaderPropertyId k_Value("_Value");

/// How recorded buffers become the frame's plain data.
class Contexts : public testing::Test
{
protected:
    void Triangle(const MaterialPropertyBlock& properties = {})
    {
        m_Cmd.DrawProcedural(glm::mat4(1.0f), m_Material, 0, 3, properties);
    }
    FrameCommands Execute()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        return m_Context.TakeCommands();
    }
    static float ValueOf(const FrameCommands& frame, std::size_t draw)
    {
        return test::ReadUniform<float>(frame, test::DrawsOf(frame).at(draw), "_Value", 1)[0];
    }

    RenderReport m_Report;
    ScriptableRenderContext m_Context{m_Report};
    CommandBuffer m_Cmd;
    const std::shared_ptr<Material> m_Material =
        std::make_shared<Material>(test::ShaderWithProgram("", "float _Value;", "_Value"), "Paint");
};

TEST_F(Contexts, AppendNothingUntilABufferIsExecuted)
{
    Triangle();
    EXPECT_TRUE(m_Context.TakeCommands().commands.empty());
    EXPECT_EQ(test::DrawsOf(Execute()).size(), 1u);
}

TEST_F(Contexts, AppendABufferAsOftenAsItIsExecuted)
{
    Triangle();
    m_Context.ExecuteCommandBuffer(m_Cmd);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    m_Cmd.Clear();
    EXPECT_EQ(test::DrawsOf(m_Context.TakeCommands()).size(), 2u);
}

TEST_F(Contexts, MakeANamedBufferASampleUnlessItsOwnOnesCrossItsEnds)
{
    const auto samples = [this]
    {
        std::vector<std::string> names;
        for (const FrameCommand& command : Execute().commands)
        {
            if (const auto* begin = std::get_if<BeginSampleCommand>(&command))
            {
                names.push_back(begin->name.name());
            }
            else if (std::holds_alternative<EndSampleCommand>(command))
            {
                names.emplace_back("end");
            }
        }
        m_Context.Begin(m_Report, glm::dvec3(0.0));
        return names;
    };
    const auto named = CommandBufferPool::Get("Blur");
    EXPECT_EQ(named->name, "Blur");
    m_Cmd.name = "Blur";
    EXPECT_THAT(samples(), ElementsAre()) << "nothing is in it";
    m_Cmd.BeginSample("Chain");
    EXPECT_THAT(samples(), ElementsAre("Chain"));
    m_Cmd.EndSample();
    EXPECT_THAT(samples(), ElementsAre("Blur", "Chain", "end", "end"));
    m_Cmd.Clear();
    m_Cmd.EndSample();
    m_Cmd.BeginSample("Next");
    EXPECT_THAT(samples(), ElementsAre("end", "Next"));
}

TEST_F(Contexts, BindTheSameAgainInAFrameThatDrawsTheSame)
{
    Triangle();
    m_Material->SetFloat(k_Value, 1.0f);
    const FrameCommands first = Execute();
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    m_Material->SetFloat(k_Value, 2.0f);
    const FrameCommands second = Execute();
    EXPECT_EQ(first.setups.at(0).bindings, second.setups.at(0).bindings);
    EXPECT_EQ(ValueOf(first, 0), 1.0f);
    EXPECT_EQ(ValueOf(second, 0), 2.0f);
}

TEST_F(Contexts, SayInEachFrameThatNobodySetsAPropertyOfAState)
{
    const auto glass = std::make_shared<Material>(
        test::ShaderOf("Shader \"Test/Glass\" { SubShader { Pass { Cull [_Missing] HLSLPROGRAM\n"
                       "#pragma vertex vert\n#pragma fragment frag\n"
                       "float4 vert() : SV_POSITION { return 0; }\n"
                       "float4 frag() : SV_Target { return 1; }\nENDHLSL } } }"));
    m_Cmd.DrawProcedural(glm::mat4(1.0f), glass, 0, 3);
    m_Cmd.DrawProcedural(glm::mat4(1.0f), glass, 0, 3);
    for (int frame = 0; frame < 2; ++frame)
    {
        m_Report = RenderReport();
        m_Context.Begin(m_Report, glm::dvec3(0.0));
        const FrameCommands commands = Execute();
        EXPECT_EQ(commands.setups.at(0).state.cull, CullMode::Off);
        EXPECT_THAT(m_Report.notes, ElementsAre(test::Mentions("'Test/Glass'", "Cull [_Missing]",
                                                               "0", "Unity", "sets")));
    }
}

TEST_F(Contexts, ForgetWhatWasGlobalAndBoundWhenAFrameBegins)
{
    const auto texture = std::make_shared<const Texture2D>("Image", 1, 1, GraphicsFormat::R8_UNorm,
                                                           std::vector<std::byte>(1));
    const auto painted = std::make_shared<Material>(test::ShaderWithProgram(
        "", "Texture2D _Map; SamplerState sampler_Map;", "_Map.Sample(sampler_Map, 0.5)"));
    painted->SetTexture(ShaderPropertyId("_Map"), texture);
    m_Cmd.SetGlobalFloat(k_Value, 3.0f);
    m_Cmd.DrawProcedural(glm::mat4(1.0f), painted, 0, 3);
    Triangle();
    m_Context.ExecuteCommandBuffer(m_Cmd); // and the frame is given up
    EXPECT_TRUE(m_Context.Reads(*texture));
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    EXPECT_FALSE(m_Context.Reads(*texture));
    m_Cmd.Clear();
    Triangle();
    EXPECT_EQ(ValueOf(Execute(), 0), 0.0f);
    EXPECT_FALSE(m_Context.Reads(*texture));
}

TEST_F(Contexts, RecordAtAnEarlierPlaceWithTheGlobalsOfThen)
{
    const auto other = std::make_shared<Material>(
        test::ShaderWithProgram("", "float _Value; float _Unset;", "_Value + _Unset"), "Late");
    const auto set = [&](const char* name, float value)
    {
        m_Cmd.SetGlobalFloat(ShaderPropertyId(name), value);
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Cmd.Clear();
    };
    const auto draw = [&](const std::shared_ptr<const Material>& material)
    {
        m_Cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Cmd.Clear();
    };
    set("_Value", 1.0f);
    draw(m_Material);
    const ScriptableRenderContext::Place place = m_Context.MarkPlace();
    set("_Value", 2.0f);
    set("_Unset", 8.0f);
    set("_Value", 3.0f);
    draw(m_Material);
    m_Context.RecordAt(place,
                       [&]
                       {
                           draw(other);
                           set("_Value", 5.0f);
                       });
    draw(m_Material);
    const FrameCommands frame = m_Context.TakeCommands();
    ASSERT_EQ(test::DrawsOf(frame).size(), 4u);
    EXPECT_EQ(test::DrawsOf(frame)[1].program, other->Compile(0));
    EXPECT_EQ(ValueOf(frame, 0), 1.0f);
    EXPECT_EQ(ValueOf(frame, 1), 1.0f);
    EXPECT_EQ(test::ReadUniform<float>(frame, test::DrawsOf(frame)[1], "_Unset", 1)[0], 0.0f);
    EXPECT_EQ(ValueOf(frame, 2), 3.0f);
    EXPECT_EQ(ValueOf(frame, 3), 3.0f);
}

TEST_F(Contexts, KnowWhichTexturesDrawsRead)
{
    const auto read = test::Target("Read");
    const auto unread = test::Target("Unread");
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "Texture2D _Map;", "_Map.Load(int3(0, 0, 0))"));
    material->SetTexture(ShaderPropertyId("_Map"), read);
    material->SetTexture(ShaderPropertyId("_Other"), unread);
    EXPECT_FALSE(m_Context.Reads(*read));
    m_Cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    EXPECT_TRUE(m_Context.Reads(*read));
    EXPECT_FALSE(m_Context.Reads(*unread));
}

TEST_F(Contexts, AreEmptyOnceTheCommandsAreTaken)
{
    Triangle();
    Execute();
    const FrameCommands second = m_Context.TakeCommands();
    EXPECT_TRUE(second.commands.empty());
    EXPECT_TRUE(second.uniformData.empty());
    EXPECT_TRUE(second.perDraw.empty());
}

TEST_F(Contexts, CanBeUsedAgainOnceTheCommandsAreTaken)
{
    m_Material->SetFloat(k_Value, 1.0f);
    Triangle();
    Execute();
    const FrameCommands second = Execute();
    EXPECT_EQ(ValueOf(second, 0), 1.0f);
    EXPECT_EQ(test::DrawsOf(second)[0].firstInstance, 0u);
}

TEST_F(Contexts, GiveEachDrawTheGlobalsOfItsMoment)
{
    m_Cmd.SetGlobalFloat(k_Value, 1.0f);
    Triangle();
    m_Cmd.SetGlobalFloat(k_Value, 2.0f);
    Triangle();
    const FrameCommands frame = Execute();
    EXPECT_EQ(ValueOf(frame, 0), 1.0f);
    EXPECT_EQ(ValueOf(frame, 1), 2.0f);
}

TEST_F(Contexts, GiveEachDrawItsOwnProperties)
{
    for (const float value : {1.0f, 2.0f})
    {
        MaterialPropertyBlock properties;
        properties.SetFloat(k_Value, value);
        Triangle(properties);
    }
    const FrameCommands frame = Execute();
    EXPECT_EQ(ValueOf(frame, 0), 1.0f);
    EXPECT_EQ(ValueOf(frame, 1), 2.0f);
}

TEST_F(Contexts, LookAtTheMaterialWhenTheBufferIsExecuted)
{
    Triangle();
    m_Material->SetFloat(k_Value, 1.0f);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    m_Material->SetFloat(k_Value, 2.0f);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    const FrameCommands frame = m_Context.TakeCommands();
    EXPECT_EQ(ValueOf(frame, 0), 1.0f);
    EXPECT_EQ(ValueOf(frame, 1), 2.0f);
}

TEST_F(Contexts, MergeEqualMeshDrawsOfOneBuffer)
{
    for (const float x : {1.0f, 2.0f})
    {
        Transform transform;
        transform.localPosition.x = x;
        m_Cmd.DrawMesh(test::Cube(), transform.localToWorldMatrix(), m_Material);
    }
    const FrameCommands frame = Execute();
    ASSERT_EQ(test::DrawsOf(frame).size(), 1u);
    EXPECT_EQ(test::DrawsOf(frame)[0].instanceCount, 2u);
    EXPECT_EQ(frame.perDraw.at(1).objectToWorld[12], 2.0f);
}

TEST_F(Contexts, KeepDrawsApartThatACommandSeparates)
{
    m_Cmd.DrawMesh(test::Cube(), glm::mat4(1.0f), m_Material);
    m_Cmd.ClearRenderTarget(ClearFlag::Depth, Color::clear);
    m_Cmd.DrawMesh(test::Cube(), glm::mat4(1.0f), m_Material);
    EXPECT_EQ(test::DrawsOf(Execute()).size(), 2u);
}

TEST_F(Contexts, ReportAShaderThatDoesNotCompile)
{
    const auto broken =
        std::make_shared<Material>(test::ShaderWithProgram("", "", "undeclared"), "Broken");
    m_Cmd.DrawProcedural(glm::mat4(1.0f), broken, 0, 3);
    const std::string message =
        test::ThrownMessage<AssetError>([&] { m_Context.ExecuteCommandBuffer(m_Cmd); });
    EXPECT_NE(message.find("test.shader:"), std::string::npos) << message;
    EXPECT_NE(message.find("undeclared"), std::string::npos) << message;
}

} // namespace
} // namespace limn
