#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/Camera.h>

#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn::test
{
namespace
{

/// What draws see of the matrices that a command buffer sets. Their device has depth reversed.
class CameraMatrices : public testing::Test
{
protected:
    CameraMatrices() { m_Cmd.SetRenderTarget(m_Target); }

    void Draw() { m_Cmd.DrawProcedural(glm::mat4(1.0f), m_Material, 0, 3); }
    std::vector<SeenDraw> Execute()
    {
        ScriptableRenderContext context(m_Report);
        context.ExecuteCommandBuffer(m_Cmd);
        m_Frame = context.TakeCommands();
        return DrawsOf(m_Frame);
    }
    void ExpectMatrix(const SeenDraw& draw, const char* name, const glm::dmat4& wanted)
    {
        const std::vector<float> seen = ReadUniform<float>(m_Frame, draw, name, 16);
        for (int i = 0; i < 16; ++i)
        {
            EXPECT_NEAR(seen[static_cast<std::size_t>(i)], wanted[i / 4][i % 4], 1e-5)
                << name << ", element " << i;
        }
    }

    RenderReport m_Report;
    CommandBuffer m_Cmd;
    FrameCommands m_Frame;
    const RTHandle m_Target{Target("Target", 8, 4)};
    const std::shared_ptr<const Material> m_Material = std::make_shared<Material>(
        ShaderWithProgram("",
                          "float4x4 unity_MatrixV; float4x4 glstate_matrix_projection; float4x4 "
                          "unity_MatrixVP; float4 _ProjectionParams;",
                          "unity_MatrixV[0] + glstate_matrix_projection[0] + unity_MatrixVP[0] + "
                          "_ProjectionParams"));
    const glm::dmat4 m_View = glm::translate(glm::dmat4(1.0), {1.0, -2.0, -5.0});
    const glm::dmat4 m_OpenGl = glm::perspectiveRH_NO(glm::radians(60.0), 2.0, 0.5, 20.0);
    /// glm's own: near 0, far 1, and with the planes exchanged near 1, far 0.
    const glm::dmat4 m_Standard = glm::perspectiveRH_ZO(glm::radians(60.0), 2.0, 0.5, 20.0);
    const glm::dmat4 m_Reversed = glm::perspectiveRH_ZO(glm::radians(60.0), 2.0, 20.0, 0.5);
    /// What turns y over, as for all that is drawn into a texture.
    const glm::dmat4 m_Flip = glm::scale(glm::dmat4(1.0), {1.0, -1.0, 1.0});
};

TEST_F(CameraMatrices, AreSetTogether)
{
    m_Cmd.SetViewProjectionMatrices(m_View, m_OpenGl);
    Draw();
    const auto draws = Execute();
    ExpectMatrix(draws[0], "unity_MatrixV", m_View);
    ExpectMatrix(draws[0], "glstate_matrix_projection", m_Flip * m_Reversed);
    ExpectMatrix(draws[0], "unity_MatrixVP", m_Flip * m_Reversed * m_View);
}

/// Back and forth between a texture and a back buffer, with what was set before.
TEST_F(CameraMatrices, AreTurnedOverForTheTargetThatIsBound)
{
    RenderTextureDescriptor descriptor(8, 4, GraphicsFormat::R8G8B8A8_UNorm);
    descriptor.isTopRowFirst = true;
    const RTHandle screen(std::make_shared<const RenderTexture>("Screen", descriptor));
    m_Cmd.SetViewProjectionMatrices(m_View, m_OpenGl);
    m_Cmd.SetGlobalVector("_ProjectionParams", {-1.0f, 2.0f, 3.0f, 4.0f});
    Draw();
    m_Cmd.SetRenderTarget(screen);
    Draw();
    m_Cmd.SetViewMatrix(glm::dmat4(1.0));
    Draw();
    m_Cmd.SetRenderTarget(m_Target);
    Draw();
    const auto draws = Execute();
    const glm::dmat4 views[] = {m_View, m_View, glm::dmat4(1.0), glm::dmat4(1.0)};
    for (std::size_t i = 0; i < 4; ++i)
    {
        const bool isScreen = i == 1 || i == 2;
        const glm::dmat4 projection = isScreen ? m_Reversed : m_Flip * m_Reversed;
        ExpectMatrix(draws[i], "glstate_matrix_projection", projection);
        ExpectMatrix(draws[i], "unity_MatrixVP", projection * views[i]);
        EXPECT_EQ(ReadUniform<float>(m_Frame, draws[i], "_ProjectionParams", 4),
                  (std::vector<float>{isScreen ? 1.0f : -1.0f, 2.0f, 3.0f, 4.0f}));
        EXPECT_EQ(draws[i].state.frontFaceFlipped, !isScreen);
    }
}

TEST_F(CameraMatrices, FollowTheDevicesDepth)
{
    for (const bool isReversed : {true, false})
    {
        const glm::dmat4 wanted = isReversed ? m_Reversed : m_Standard;
        const glm::dmat4 turned = m_Flip * wanted;
        for (int i = 0; i < 16; ++i)
        {
            EXPECT_NEAR(GpuProjection(m_OpenGl, isReversed)[i / 4][i % 4], wanted[i / 4][i % 4],
                        1e-6)
                << i;
            EXPECT_NEAR(GpuProjection(m_OpenGl, isReversed, true)[i / 4][i % 4],
                        turned[i / 4][i % 4], 1e-6)
                << i;
        }
    }
}

TEST_F(CameraMatrices, AreSetOneByOne)
{
    const glm::dmat4 other = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -3.0});
    const glm::dmat4 wide = glm::perspectiveRH_NO(glm::radians(90.0), 2.0, 0.5, 20.0);
    const glm::dmat4 wideReversed = glm::perspectiveRH_ZO(glm::radians(90.0), 2.0, 20.0, 0.5);
    m_Cmd.SetViewProjectionMatrices(m_View, m_OpenGl);
    m_Cmd.SetViewMatrix(other);
    Draw();
    m_Cmd.SetProjectionMatrix(wide);
    Draw();
    const auto draws = Execute();
    ExpectMatrix(draws[0], "unity_MatrixVP", m_Flip * m_Reversed * other);
    ExpectMatrix(draws[0], "glstate_matrix_projection", m_Flip * m_Reversed);
    ExpectMatrix(draws[1], "unity_MatrixVP", m_Flip * wideReversed * other);
    ExpectMatrix(draws[1], "unity_MatrixV", other);
}

TEST_F(CameraMatrices, MustBeFinite)
{
    glm::dmat4 broken(1.0);
    broken[2][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(ThrownMessage<ContractError>([&] { m_Cmd.SetViewMatrix(broken); }),
                testing::HasSubstr("unity_MatrixV"));
    EXPECT_THAT(ThrownMessage<ContractError>([&] { m_Cmd.SetProjectionMatrix(broken); }),
                testing::HasSubstr("glstate_matrix_projection"));
}

} // namespace
} // namespace limn::test
