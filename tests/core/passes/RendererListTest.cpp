#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

/// Cubes that differ in queue, layer and rendering layer, drawn by lists.
class RendererLists : public testing::Test
{
protected:
    RendererLists()
    {
        m_Camera.orthographic = true;
        m_Near->SetRenderQueue(2000);
        m_Far->SetRenderQueue(3000);
        Add(5.0f, m_Near);
        GameObject& behind = Add(9.0f, m_Far);
        behind.layer = 3;
        behind.renderer->renderingLayerMask = RenderingLayerMask(4);
    }

    GameObject& Add(float z, const std::shared_ptr<const Material>& material)
    {
        return test::AddCube(m_Scene, "cube", {0, 0, z}, {material});
    }
    /// _Tint of each draw of what was recorded.
    std::vector<float> Draw()
    {
        ScriptableRenderContext context(m_Report);
        context.ExecuteCommandBuffer(m_Cmd);
        const FrameCommands frame = context.TakeCommands();
        std::vector<float> tints;
        for (const test::SeenDraw& draw : test::DrawsOf(frame))
        {
            tints.push_back(test::ReadUniform<float>(frame, draw, "_Tint", 1)[0]);
        }
        return tints;
    }
    std::vector<float> Draw(const RendererListDesc& desc)
    {
        m_Cmd.Clear();
        m_Cmd.DrawRendererList(ScriptableRenderContext(m_Report).CreateRendererList(desc));
        return Draw();
    }
    RendererListDesc Desc() const { return {m_Forward, m_Culled, m_Camera}; }
    static std::shared_ptr<Material> Tinted(float tint)
    {
        static const auto shader =
            test::ShaderWithProgram("_Tint (\"\", Float) = 1", "float _Tint;", "_Tint");
        const auto material = std::make_shared<Material>(shader);
        material->SetFloat("_Tint", tint);
        return material;
    }

    const ShaderTagId m_Forward{"UniversalForward"};
    const std::shared_ptr<Material> m_Near = Tinted(2);
    const std::shared_ptr<Material> m_Far = Tinted(3);
    RenderReport m_Report;
    Camera m_Camera;
    Scene m_Scene;
    CommandBuffer m_Cmd;
    CullingResults m_Culled;
    void SetUp() override { m_Culled = Cull(m_Scene, m_Camera, 1.0f); }
};

TEST_F(RendererLists, AreDrawnAtTheirPlaceAmongOtherCommands)
{
    DrawingSettings drawing;
    drawing.shaderTagIds = {m_Forward};
    ScriptableRenderContext context(m_Report);
    const RendererList list =
        context.CreateRendererList(RendererListParams(m_Culled, drawing, FilteringSettings()));
    m_Cmd.DrawMesh(test::Cube(), glm::mat4(1.0f), Tinted(1));
    CoreUtils::DrawRendererList(context, m_Cmd, list);
    m_Cmd.DrawMesh(test::Cube(), glm::mat4(1.0f), Tinted(4));
    m_Cmd.DrawRendererList(list);
    EXPECT_THAT(Draw(), ElementsAre(1, 2, 3, 4, 2, 3));
    ASSERT_EQ(m_Report.draws.size(), 2u);
    EXPECT_EQ(m_Report.draws[1].counts[0], 2);
}

TEST_F(RendererLists, TakeAllThatHasAPassUnlessTheyAreTold)
{
    EXPECT_THAT(Draw(Desc()), ElementsAre(2, 3));
    EXPECT_THAT(Draw(RendererListDesc(ShaderTagId("Mask"), m_Culled, m_Camera)), ElementsAre());
    RendererListDesc desc = Desc();
    desc.renderQueueRange = RenderQueueRange::transparent;
    EXPECT_THAT(Draw(desc), ElementsAre(3));
    desc = Desc();
    desc.layerMask = LayerMask(1);
    EXPECT_THAT(Draw(desc), ElementsAre(2));
    desc = Desc();
    desc.renderingLayerMask = RenderingLayerMask(4);
    EXPECT_THAT(Draw(desc), ElementsAre(3));
    desc = Desc();
    desc.sortingCriteria = SortingCriteria::BackToFront;
    EXPECT_THAT(Draw(desc), ElementsAre(3, 2));
    desc.overrideMaterial = Tinted(8);
    EXPECT_THAT(Draw(desc), ElementsAre(8)) << "instances of one draw";
}

TEST_F(RendererLists, ReplaceStateWhereTheyHaveABlock)
{
    RendererListDesc desc = Desc();
    RenderStateBlock block(RenderStateMask::Depth);
    block.depthState = {false, CompareFunction::Greater};
    desc.stateBlock = block;
    m_Cmd.DrawRendererList(ScriptableRenderContext(m_Report).CreateRendererList(desc));
    ScriptableRenderContext context(m_Report);
    context.ExecuteCommandBuffer(m_Cmd);
    const FrameCommands frame = context.TakeCommands();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].state.zTest, CompareFunction::Greater);
    EXPECT_FALSE(draws[1].state.zWrite);
}

TEST_F(RendererLists, AreRefusedWhereTheyAreEmpty)
{
    EXPECT_FALSE(RendererList().isValid());
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Cmd.DrawRendererList({}); }),
                test::Mentions("DrawRendererList", "empty", "CreateRendererList"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { RendererListDesc(std::span<const ShaderTagId>(), m_Culled, m_Camera); }),
                test::Mentions("RendererListDesc", "0 pass names", "1 to 16"));
}

TEST_F(RendererLists, LeaveOutPassesThatAMaterialHasSwitchedOff)
{
    m_Near->SetShaderPassEnabled("universalforward", false);
    EXPECT_THAT(Draw(Desc()), ElementsAre(3));
    EXPECT_EQ(m_Report.draws.back().counts[static_cast<int>(FilterVerdict::NoMatchingPass)], 1);
    RendererListDesc desc = Desc();
    desc.overrideMaterial = Tinted(8);
    EXPECT_THAT(Draw(desc), ElementsAre(8));
    EXPECT_EQ(m_Report.draws.back().counts[0], 1) << "an override does not bring it back";
    m_Cmd.Clear();
    m_Cmd.DrawMesh(test::Cube(), glm::mat4(1.0f), m_Near);
    EXPECT_THAT(Draw(), ElementsAre(2)) << "a draw of its own does not look at it";
    m_Near->SetShaderPassEnabled("UniversalForward", true);
    EXPECT_THAT(Draw(Desc()), ElementsAre(2, 3));
}

TEST_F(RendererLists, GoOverWithThePropertiesOfAMaterial)
{
    m_Near->SetShaderPassEnabled("UniversalForward", false);
    EXPECT_FALSE(m_Near->GetShaderPassEnabled("UNIVERSALFORWARD"));
    EXPECT_TRUE(m_Near->GetShaderPassEnabled("ShadowCaster"));
    m_Far->CopyPropertiesFromMaterial(*m_Near);
    EXPECT_FALSE(m_Far->GetShaderPassEnabled("UniversalForward"));
    EXPECT_THAT(Draw(Desc()), ElementsAre());
}

} // namespace
} // namespace limn
