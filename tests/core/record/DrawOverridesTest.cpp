#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

/// What DrawRenderers makes of overrides other than the material.
class DrawOverrides : public testing::Test
{
protected:
    DrawOverrides() { m_Drawing.shaderTagIds = {ShaderTagId("UniversalForward")}; }

    std::vector<test::SeenDraw> Draw(const RenderStateBlock& stateBlock = RenderStateBlock())
    {
        Camera camera;
        camera.orthographic = true;
        ScriptableRenderContext context(m_Report);
        context.ExecuteCommandBuffer(m_Before);
        context.DrawRenderers(Cull(m_Scene, camera, 1.0f), m_Drawing, FilteringSettings(),
                              stateBlock);
        m_Frame = context.TakeCommands();
        return test::DrawsOf(m_Frame);
    }

    std::vector<float> Tint(const test::SeenDraw& draw) const
    {
        return test::ReadUniform<float>(m_Frame, draw, "_Tint", 1);
    }

    static std::shared_ptr<Material> Tinted(float value, const std::string& state = "")
    {
        auto material = std::make_shared<Material>(
            test::ShaderWithProgram("_Tint (\"\", Float) = 1", "float _Tint;", "_Tint", state));
        material->SetFloat(ShaderPropertyId("_Tint"), value);
        return material;
    }

    Scene m_Scene;
    CommandBuffer m_Before;
    DrawingSettings m_Drawing;
    RenderReport m_Report;
    FrameCommands m_Frame;
};

TEST_F(DrawOverrides, AnOverrideShaderReadsEachObjectsOwnProperties)
{
    test::AddCube(m_Scene, "a", {0, 0, 5}, {Tinted(3.0f)});
    test::AddCube(m_Scene, "b", {1, 0, 5}, {Tinted(4.0f)});
    m_Drawing.overrideShader =
        test::ShaderWithProgram("_Tint (\"\", Float) = 9", "float _Tint;", "_Tint", "Cull Off");
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].state.cull, CullMode::Off);
    EXPECT_THAT(Tint(draws[0]), ElementsAre(3.0f));
    EXPECT_THAT(Tint(draws[1]), ElementsAre(4.0f));
}

TEST_F(DrawOverrides, AnOverrideShadersOwnDefaultsFillInWhatTheMaterialLacks)
{
    test::AddCube(m_Scene, "a", {0, 0, 5},
                  {std::make_shared<Material>(test::ShaderWithProgram(""))});
    m_Drawing.overrideShader =
        test::ShaderWithProgram("_Tint (\"\", Float) = 9", "float _Tint;", "_Tint");
    EXPECT_THAT(Tint(Draw().at(0)), ElementsAre(9.0f));
}

TEST_F(DrawOverrides, AnOverrideMaterialWinsOverAnOverrideShader)
{
    test::AddCube(m_Scene, "a", {0, 0, 5}, {Tinted(3.0f)});
    m_Drawing.overrideMaterial = Tinted(5.0f, "Cull Front");
    m_Drawing.overrideShader = test::ShaderWithProgram("");
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].state.cull, CullMode::Front);
}

TEST_F(DrawOverrides, AnOverrideShaderPassThatDoesNotExistIsRefused)
{
    test::AddCube(m_Scene, "a", {0, 0, 5}, {Tinted(3.0f)});
    m_Drawing.overrideShader = test::ShaderWithProgram("");
    m_Drawing.overrideShaderPassIndex = 2;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Draw(); }),
                test::Mentions("'Test/Program'", "no pass 2", "has 1"));
}

TEST_F(DrawOverrides, AStateBlockReplacesItsGroupsInEveryDraw)
{
    test::AddCube(m_Scene, "a", {0, 0, 5}, {Tinted(3.0f, "Cull Front ZWrite Off")});
    RenderStateBlock block(RenderStateMask::Depth);
    block.depthState = {true, CompareFunction::Equal};
    const PipelineState state = Draw(block).at(0).state;
    EXPECT_TRUE(state.zWrite);
    EXPECT_EQ(state.zTest, CompareFunction::Equal);
    EXPECT_EQ(state.cull, CullMode::Front);
}

TEST_F(DrawOverrides, TheFallbackMaterialDrawsWhatDoesNotCompile)
{
    const auto broken = std::make_shared<Material>(
        test::ShaderWithProgram("", "float4 Oops() { return nothing; }", "Oops()"));
    test::AddCube(m_Scene, "a", {0, 0, 5}, {broken});
    EXPECT_THROW(Draw(), AssetError);
    m_Drawing.fallbackMaterial = Tinted(7.0f);
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_THAT(Tint(draws[0]), ElementsAre(7.0f));
}

TEST_F(DrawOverrides, AStencilOnATargetWithoutOneIsRefused)
{
    test::AddCube(m_Scene, "a", {0, 0, 5}, {Tinted(3.0f, "Stencil { Ref 1 Pass Replace }")});
    const auto depth = std::make_shared<const RenderTexture>(
        "OnlyDepth", RenderTextureDescriptor(8, 4, GraphicsFormat::None, 16));
    m_Before.SetRenderTarget(RTHandle(test::Target("Color")), RTHandle(depth));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Draw(); }),
                test::Mentions("pass 0", "'Test/Program'", "stencil", "'OnlyDepth'", "D32_SFloat",
                               "depthBufferBits 24 or 32"));
}

TEST_F(DrawOverrides, AStencilWithoutAnyDepthTargetPasses)
{
    test::AddCube(m_Scene, "a", {0, 0, 5}, {Tinted(3.0f, "Stencil { Ref 1 Pass Replace }")});
    m_Before.SetRenderTarget(RTHandle(test::Target("Color")));
    EXPECT_EQ(Draw().size(), 1u);
}

TEST_F(DrawOverrides, MaterialsBeyondTheLastSubMeshDrawItAgainInTheirOrder)
{
    const auto later = Tinted(2.0f, "Cull Off");
    const auto outline = Tinted(1.0f, "Cull Front");
    test::AddCube(m_Scene, "a", {0, 0, 5}, {outline, later});
    m_Drawing.sortingSettings.criteria = SortingCriteria::CommonTransparent;
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].state.cull, CullMode::Front); // though its shader was made last
    EXPECT_EQ(draws[1].state.cull, CullMode::Off);
    EXPECT_EQ(draws[1].subMesh, 0);
}

} // namespace
} // namespace limn
