#include <gtest/gtest.h>
#include <limits>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

/// What Shader::SetGlobalFloat and its like make draws find. Each test has names of its own: what
/// is set is there to the process's end.
class ShaderGlobalValues : public testing::Test
{
protected:
    static std::shared_ptr<Material> Reading(const std::string& declaration,
                                             const std::string& result)
    {
        return std::make_shared<Material>(test::ShaderWithProgram("", declaration, result));
    }

    test::OneDraw m_Draw;
};

TEST_F(ShaderGlobalValues, ReachShadersOfEveryKind)
{
    const auto material = Reading("float _GF; int _GI; float4 _GV; float4 _GC; float4x4 _GM; "
                                  "float _GFs[2]; float4 _GVs[2]; float4x4 _GMs[1];",
                                  "_GF + _GI + _GV + _GC + _GM[0] + _GFs[1] + _GVs[1] + "
                                  "_GMs[0][1]");
    glm::mat4 matrix(1.0f);
    matrix[3] = {5, 6, 7, 1};
    Shader::SetGlobalFloat("_GF", 0.5f);
    Shader::SetGlobalInt("_GI", 7);
    Shader::SetGlobalVector("_GV", {1, 2, 3, 4});
    Shader::SetGlobalColor("_GC", {0.5f, 0.25f, 0.125f, 1.0f});
    Shader::SetGlobalMatrix("_GM", matrix);
    Shader::SetGlobalFloatArray("_GFs", {8, 9});
    Shader::SetGlobalVectorArray("_GVs", {{1, 1, 1, 1}, {2, 2, 2, 2}});
    Shader::SetGlobalMatrixArray("_GMs", {matrix});
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_GF", 1), std::vector<float>{0.5f});
    EXPECT_EQ(m_Draw.Ints("_GI", 1), std::vector<std::int32_t>{7});
    EXPECT_EQ(m_Draw.Floats("_GV", 4), (std::vector<float>{1, 2, 3, 4}));
    EXPECT_EQ(m_Draw.Floats("_GC", 4), (std::vector<float>{0.5f, 0.25f, 0.125f, 1}));
    EXPECT_EQ(m_Draw.Floats("_GM", 4, 48), (std::vector<float>{5, 6, 7, 1}));
    EXPECT_EQ(m_Draw.Floats("_GFs", 1, 16), std::vector<float>{9});
    EXPECT_EQ(m_Draw.Floats("_GVs", 4, 16), (std::vector<float>{2, 2, 2, 2}));
    EXPECT_EQ(m_Draw.Floats("_GMs", 4, 48), (std::vector<float>{5, 6, 7, 1}));
}

TEST_F(ShaderGlobalValues, ComeBehindThoseOfDrawsMaterialsAndCommandBuffers)
{
    const auto material = Reading("float _Rank;", "_Rank");
    Shader::SetGlobalInteger("_Rank", 1);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_Rank", 1), std::vector<float>{1});
    m_Draw.before.SetGlobalFloat("_Rank", 2);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_Rank", 1), std::vector<float>{2});
    material->SetFloat("_Rank", 3);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_Rank", 1), std::vector<float>{3});
    m_Draw.block.SetFloat("_Rank", 4);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_Rank", 1), std::vector<float>{4});
}

TEST_F(ShaderGlobalValues, ReachWhatIsExecutedAfterThemInTheSameFrame)
{
    const auto material = Reading("float _Now; float _Set;", "_Now + _Set");
    Shader::SetGlobalFloat("_Now", 1);
    Shader::SetGlobalFloat("_Set", 1);
    RenderReport report;
    ScriptableRenderContext context(report);
    CommandBuffer cmd;
    cmd.SetGlobalFloat("_Set", 5);
    cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
    context.ExecuteCommandBuffer(cmd);
    cmd.Clear();
    Shader::SetGlobalFloat("_Now", 2);
    Shader::SetGlobalFloat("_Set", 2);
    cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
    context.ExecuteCommandBuffer(cmd);
    const FrameCommands frame = context.TakeCommands();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(test::ReadUniform<float>(frame, draws[0], "_Now", 1)[0], 1);
    EXPECT_EQ(test::ReadUniform<float>(frame, draws[1], "_Now", 1)[0], 2);
    EXPECT_EQ(test::ReadUniform<float>(frame, draws[1], "_Set", 1)[0], 5) << "a buffer set it";
    // The next frame has what was set last.
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.Floats("_Set", 1), std::vector<float>{2});
}

TEST_F(ShaderGlobalValues, OfObjectsAreThere)
{
    Shader::SetGlobalFloat("_OfObjects", 6);
    Scene scene;
    test::AddCube(scene, "cube", {0, 0, 5}, {Reading("float _OfObjects;", "_OfObjects")});
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
    RenderReport report;
    ScriptableRenderContext context(report);
    context.DrawRenderers(Cull(scene, Camera(), 1.0f), drawing, FilteringSettings());
    const FrameCommands frame = context.TakeCommands();
    EXPECT_EQ(test::ReadUniform<float>(frame, test::DrawsOf(frame).at(0), "_OfObjects", 1)[0], 6);
}

TEST_F(ShaderGlobalValues, MayBeTexturesAndNoneAgain)
{
    const auto material = Reading("Texture2D _GlobalMap;", "_GlobalMap.Load(int3(0, 0, 0))");
    const RTHandle target(test::Target("Map"));
    Shader::SetGlobalTexture("_GlobalMap", target);
    m_Draw.Resolve(material);
    EXPECT_EQ(m_Draw.TextureNamed("_GlobalMap"), target.rt());
    Shader::SetGlobalTexture("_GlobalMap", nullptr);
    m_Draw.Resolve(material);
    EXPECT_NE(m_Draw.TextureNamed("_GlobalMap"), target.rt());
}

TEST_F(ShaderGlobalValues, AreRefusedWhereNoShaderCanUseThem)
{
    const auto message = [](auto&& call)
    {
        return test::ThrownMessage<ContractError>(call);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(message([&] { Shader::SetGlobalFloat("_Nan", nan); }),
                test::Mentions("global", "'_Nan'", "not finite"));
    EXPECT_THAT(message([] { Shader::SetGlobalFloatArray("_None", {}); }),
                test::Mentions("global", "'_None'", "without elements"));
    const RTHandle named = RTHandles::Alloc("_Named");
    EXPECT_THAT(message([&] { Shader::SetGlobalTexture("_Map", named); }),
                test::Mentions("global", "'_Map'", "identifier", "SetGlobalTexture"));
}

TEST_F(ShaderGlobalValues, AreThereToBeAskedFor)
{
    const ShaderPropertyId id{"AreThereToBeAskedFor"};
    EXPECT_EQ(Shader::GetGlobalFloat(id), 0.0f);
    EXPECT_EQ(Shader::GetGlobalTexture(id), nullptr);
    Shader::SetGlobalFloat(id, 1.5f);
    EXPECT_EQ(Shader::GetGlobalFloat(id), 1.5f);
    EXPECT_EQ(Shader::GetGlobalInteger(id), 1);
    Shader::SetGlobalColor(id, {0.5f, 2.0f, 0.0f, 1.0f});
    EXPECT_EQ(Shader::GetGlobalColor(id), Color(0.5f, 2.0f, 0.0f, 1.0f));
    EXPECT_EQ(Shader::GetGlobalVector(id), glm::vec4(0.5f, 2.0f, 0.0f, 1.0f));
    Shader::SetGlobalMatrix(id, glm::mat4(3.0f));
    EXPECT_EQ(Shader::GetGlobalMatrix(id), glm::mat4(3.0f));
    EXPECT_EQ(Shader::GetGlobalFloat(id), 0.0f) << "of another kind";
    Shader::SetGlobalFloatArray(id, {1.0f, 2.0f});
    EXPECT_EQ(Shader::GetGlobalFloatArray(id), (std::vector<float>{1.0f, 2.0f}));
    EXPECT_TRUE(Shader::GetGlobalVectorArray(id).empty());
}

} // namespace
} // namespace limn
