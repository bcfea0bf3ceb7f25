#include <gmock/gmock.h>

#include "pipeline/PipelineTest.h"

namespace limn
{
namespace
{

/// A cube before a camera, frame after frame.
class SteadyFrames : public test::PipelineTest<>
{
protected:
    SteadyFrames() : PipelineTest(8, 4)
    {
        m_Cube = &test::AddCube(
            m_Scene, "cube", {0.0f, 0.0f, 5.0f},
            {std::make_shared<Material>(test::ShaderWithProgram("", "float4 _Time;", "_Time.y"))});
    }

    /// What frames have settled to.
    std::uint64_t SteadyStructure()
    {
        Render();
        Render();
        return Render().frame->structure;
    }

    GameObject* m_Cube = nullptr;
};

} // namespace

TEST_F(SteadyFrames, AreOfOneStructureAlsoWhileTimePassesAndObjectsMove)
{
    const std::uint64_t structure = SteadyStructure();
    m_Request.time = 3.0;
    m_Cube->transform.localPosition.x = 0.25f;
    const RenderResult moved = Render();
    EXPECT_EQ(moved.frame->structure, structure);
    const auto& draw =
        *std::ranges::find_if(moved.frame->passes.at(0).commands, [](const PassCommand& command)
                              { return std::holds_alternative<DrawCommand>(command); });
    const PerDrawData perDraw = moved.frame->PerDraw(std::get<DrawCommand>(draw));
    EXPECT_EQ(perDraw.objectToWorld[12], 0.25f);
}

TEST_F(SteadyFrames, AreOfOneStructureWhateverLightsAndVeilsThem)
{
    const std::uint64_t structure = SteadyStructure();
    m_Scene.ambientMode = AmbientMode::Trilight;
    m_Scene.reflectionIntensity = 0.5f;
    m_Scene.fog = true; // of which the cube's shader has no variants
    EXPECT_EQ(Render().frame->structure, structure);
}

TEST_F(SteadyFrames, AreOfAnotherStructureWhereFogComesToAShaderThatKnowsIt)
{
    m_Cube->renderer->sharedMaterials[0] =
        std::make_shared<Material>(test::ShaderWithProgram("", "#pragma multi_compile_fog"));
    const std::uint64_t clear = SteadyStructure();
    m_Scene.fog = true;
    const std::uint64_t veiled = SteadyStructure();
    EXPECT_NE(veiled, clear);
    m_Scene.fogDensity = 0.5f;
    m_Scene.fogColor = Color::red;
    EXPECT_EQ(Render().frame->structure, veiled);
    m_Scene.fogMode = FogMode::Linear;
    EXPECT_NE(Render().frame->structure, veiled);
}

TEST_F(SteadyFrames, AreOfAnotherStructureWhereAnObjectCame)
{
    const std::uint64_t structure = SteadyStructure();
    test::AddCube(m_Scene, "another", {1.0f, 0.0f, 5.0f}, {m_Cube->renderer->sharedMaterials[0]});
    EXPECT_NE(Render().frame->structure, structure);
}

TEST_F(SteadyFrames, AreWorkedOutAnewForAnotherDevice)
{
    const std::uint64_t structure = SteadyStructure();
    RecordingDevice other;
    m_Pipeline.SetDevice(other);
    EXPECT_NE(Render().frame->structure, structure);
    EXPECT_EQ(other.frames().size(), 1u);
}

TEST_F(SteadyFrames, LeaveAResultAsItIsForThoseWhoKeepIt)
{
    SteadyStructure();
    const RenderResult kept = Render();
    const std::vector<std::byte> before = kept.frame->uniformData;
    m_Request.time = 7.0;
    const RenderResult next = Render();
    EXPECT_EQ(kept.frame->uniformData, before);
    EXPECT_NE(next.frame->uniformData, before) << "the time is another";
}

TEST_F(SteadyFrames, SayInAResultThatIsUsedAgainWhatIsSoOfTheLastOnly)
{
    RenderResult result;
    m_Pipeline.RenderSingleCamera(m_Renderer, m_Request, result);
    const std::size_t passes = result.report.passes.size();
    const std::size_t draws = result.report.draws.size();
    ASSERT_GT(passes, 0u);
    ASSERT_GT(draws, 0u);
    result.report.notes.emplace_back("of another frame");
    m_Pipeline.RenderSingleCamera(m_Renderer, m_Request, result);
    EXPECT_EQ(result.report.passes.size(), passes);
    EXPECT_EQ(result.report.draws.size(), draws);
    EXPECT_THAT(result.report.notes, testing::IsEmpty());
    EXPECT_EQ(m_Device.frames().back().passes.size(), result.frame->passes.size());
}

} // namespace limn
