#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/ScriptableRenderPass.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

using testing::ElementsAre;

/// What command buffers with identifiers come to in a frame of one camera.
class IdentifiedTextures : public testing::Test
{
protected:
    IdentifiedTextures() { BeginCamera(); }

    void BeginCamera() { m_Context.BeginCamera({m_Color, m_Depth, &m_Pool, m_CopyMaterial}); }

    FrameCommands Execute()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Cmd.Clear();
        return m_Context.TakeCommands();
    }
    std::string ErrorOfExecution()
    {
        const std::string message =
            test::ThrownMessage<ContractError>([&] { m_Context.ExecuteCommandBuffer(m_Cmd); });
        m_Cmd.Clear();
        return message;
    }
    /// The texture that a draw now finds as _MainTex; a default one where nothing is global.
    std::shared_ptr<const Texture> SeenAsMainTex()
    {
        m_Cmd.DrawProcedural(glm::mat4(1.0f), m_Sampling, 0, 3);
        const auto draws = test::DrawsOf(Execute());
        return draws.back().bindings->textures.at(0).texture;
    }
    static const SetRenderTargetCommand& TargetAt(const FrameCommands& frame, std::size_t index)
    {
        return std::get<SetRenderTargetCommand>(frame.commands.at(index));
    }

    RenderReport m_Report;
    RenderTexturePool m_Pool;
    ScriptableRenderContext m_Context{m_Report};
    CommandBuffer m_Cmd;
    const RTHandle m_Color{test::Target("CameraColor", 40, 20)};
    const RTHandle m_Depth{test::DepthTarget("CameraDepth", 40, 20)};
    const RTHandle m_Other{test::Target("Other", 40, 20)};
    const std::shared_ptr<const Material> m_CopyMaterial = CoreUtils::CreateEngineMaterial(
        FindBuiltinShader("Hidden/Universal/CoreBlit", test::Compiler()));
    const std::shared_ptr<const Material> m_Sampling = std::make_shared<Material>(
        test::ShaderWithProgram("", "Texture2D _MainTex; SamplerState sampler_MainTex;",
                                "_MainTex.Sample(sampler_MainTex, 0.5)"),
        "Sampling");
};

} // namespace

TEST_F(IdentifiedTextures, AreGlobalUnderTheirNameFromGetTemporaryRTToItsRelease)
{
    m_Cmd.GetTemporaryRT("_MainTex", 16, 8, 0, FilterMode::Bilinear, RenderTextureFormat::R8);
    const auto seen = std::dynamic_pointer_cast<const RenderTexture>(SeenAsMainTex());
    ASSERT_NE(seen, nullptr);
    EXPECT_EQ(seen->descriptor(), RenderTextureDescriptor(16, 8, GraphicsFormat::R8_UNorm));
    EXPECT_EQ(seen->sampler().filterMode, FilterMode::Bilinear);
    EXPECT_EQ(seen->sampler().wrapModeU, TextureWrapMode::Clamp);
    m_Cmd.ReleaseTemporaryRT("_MainTex");
    EXPECT_NE(SeenAsMainTex(), seen);
    m_Cmd.GetTemporaryRT("_Next", {16, 8, GraphicsFormat::R8_UNorm}, FilterMode::Bilinear);
    m_Cmd.SetRenderTarget("_Next");
    EXPECT_EQ(TargetAt(Execute(), 0).colors[0], seen) << "the next one gets what was given back";
    EXPECT_THAT(m_Report.notes, ElementsAre(testing::HasSubstr("texture '_MainTex' is gray")));
}

TEST_F(IdentifiedTextures, LeaveAGlobalOfAnotherTextureWhenReleased)
{
    m_Cmd.GetTemporaryRT("_MainTex", 16, 8);
    m_Cmd.SetGlobalTexture("_MainTex", m_Other);
    m_Cmd.ReleaseTemporaryRT("_MainTex");
    EXPECT_EQ(SeenAsMainTex(), m_Other.rt());
}

TEST_F(IdentifiedTextures, GoBackToThePoolAtTheCamerasEnd)
{
    for (int frame = 0; frame < 3; ++frame)
    {
        BeginCamera();
        m_Cmd.GetTemporaryRT("_A", 16, 8);
        m_Cmd.GetTemporaryRT("_B", 16, 8);
        Execute();
        m_Context.EndCamera();
    }
    EXPECT_EQ(m_Pool.size(), 2u);
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    BeginCamera();
    m_Cmd.SetRenderTarget("_A");
    EXPECT_THAT(ErrorOfExecution(), testing::HasSubstr("'_A'"));
}

TEST_F(IdentifiedTextures, OfANegativeSizeArePartsOfTheCameras)
{
    const auto sizeOf = [&](int width, int height)
    {
        m_Cmd.GetTemporaryRT("_A", width, height);
        m_Cmd.SetRenderTarget("_A");
        const FrameCommands frame = Execute();
        const RenderTexture& texture = *TargetAt(frame, 0).colors[0];
        return std::pair(texture.width(), texture.height());
    };
    EXPECT_EQ(sizeOf(-1, -1), std::pair(40, 20));
    EXPECT_EQ(sizeOf(-2, -4), std::pair(20, 5));
    EXPECT_EQ(sizeOf(-2, 7), std::pair(20, 7));
    EXPECT_EQ(sizeOf(-64, -64), std::pair(1, 1));
}

// cameraTargetDescriptor as it is has a colour format and depth bits: one texture in Unity.
TEST_F(IdentifiedTextures, BringTheDepthOfTheirDescriptorAlong)
{
    m_Cmd.GetTemporaryRT("_Both", {8, 4, GraphicsFormat::R8_UNorm, 24});
    m_Cmd.SetRenderTarget("_Both");
    m_Cmd.GetTemporaryRT("_Depth", 8, 4, 24, FilterMode::Point, RenderTextureFormat::Depth);
    m_Cmd.SetRenderTarget("_Depth");
    m_Cmd.GetTemporaryRT("_Color", 8, 4);
    m_Cmd.SetRenderTarget("_Color", "_Depth");
    const FrameCommands frame = Execute();
    ASSERT_EQ(TargetAt(frame, 0).colors.size(), 1u);
    EXPECT_EQ(TargetAt(frame, 0).colors[0]->graphicsFormat(), GraphicsFormat::R8_UNorm);
    ASSERT_NE(TargetAt(frame, 0).depth, nullptr);
    EXPECT_EQ(TargetAt(frame, 0).depth->graphicsFormat(), GraphicsFormat::D32_SFloat_S8_UInt);
    EXPECT_TRUE(TargetAt(frame, 1).colors.empty());
    EXPECT_EQ(TargetAt(frame, 2).colors.size(), 1u);
    EXPECT_EQ(TargetAt(frame, 2).depth, TargetAt(frame, 1).depth);
}

TEST_F(IdentifiedTextures, OfTheCameraAreItsColorAndDepth)
{
    m_Cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
    m_Cmd.SetRenderTarget(m_Other, BuiltinRenderTextureType::CameraTarget);
    m_Cmd.SetRenderTarget(BuiltinRenderTextureType::CurrentActive);
    m_Cmd.SetGlobalTexture("_MainTex", BuiltinRenderTextureType::CameraTarget);
    m_Cmd.SetRenderTarget("_MainTex");
    const FrameCommands frame = Execute();
    EXPECT_THAT(TargetAt(frame, 0).colors, ElementsAre(m_Color.rt()));
    EXPECT_EQ(TargetAt(frame, 0).depth, m_Depth.rt());
    EXPECT_THAT(TargetAt(frame, 1).colors, ElementsAre(m_Other.rt()));
    EXPECT_EQ(TargetAt(frame, 1).depth, m_Depth.rt());
    EXPECT_EQ(TargetAt(frame, 2), TargetAt(frame, 1));
    EXPECT_THAT(TargetAt(frame, 3).colors, ElementsAre(m_Color.rt()));
    EXPECT_EQ(TargetAt(frame, 3).depth, nullptr) << "a texture's name says nothing of a depth";
}

TEST_F(IdentifiedTextures, AreBlittedAsHandlesAre)
{
    m_Cmd.GetTemporaryRT("_Temp", 8, 4);
    m_Cmd.Blit(BuiltinRenderTextureType::CameraTarget, "_Temp", m_Sampling);
    m_Cmd.Blit("_Temp", m_Color, m_Sampling, 0);
    m_Cmd.SetGlobalTexture("_MainTex", m_Other);
    m_Cmd.Blit(BuiltinRenderTextureType::None, m_Color, m_Sampling);
    const FrameCommands frame = Execute();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 3u);
    const auto sourceOf = [&](std::size_t i)
    {
        return draws[i].bindings->textures.at(0).texture;
    };
    EXPECT_EQ(sourceOf(0), m_Color.rt());
    EXPECT_EQ(sourceOf(1), TargetAt(frame, 0).colors[0]);
    EXPECT_EQ(sourceOf(2), m_Other.rt());
    EXPECT_EQ(TargetAt(frame, 0).depth, nullptr);
    EXPECT_THAT(TargetAt(frame, 2).colors, ElementsAre(m_Color.rt()));
}

TEST_F(IdentifiedTextures, AreCopiedByTheirOwnFilterWithoutAMaterial)
{
    m_Cmd.GetTemporaryRT("_Near", 8, 4);
    m_Cmd.GetTemporaryRT("_Smooth", 8, 4, 0, FilterMode::Bilinear);
    m_Cmd.Blit("_Near", m_Color);
    m_Cmd.Blit("_Smooth", m_Color);
    const auto draws = test::DrawsOf(Execute());
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(m_CopyMaterial->FindPass("Nearest"), draws[0].shaderPass);
    EXPECT_EQ(m_CopyMaterial->FindPass("Bilinear"), draws[1].shaderPass);
}

TEST_F(IdentifiedTextures, AreCopiedWithoutChangingWhatIsBound)
{
    m_Cmd.SetRenderTarget(m_Color, m_Depth);
    m_Cmd.SetViewport({1, 2, 3, 4});
    m_Cmd.SetViewport({2, 2, 3, 4});
    m_Cmd.CopyTexture(m_Color, m_Other);
    const FrameCommands frame = Execute();
    ASSERT_EQ(frame.commands.size(), 7u);
    EXPECT_THAT(TargetAt(frame, 3).colors, ElementsAre(m_Other.rt()));
    EXPECT_EQ(TargetAt(frame, 5), TargetAt(frame, 0));
    EXPECT_EQ(std::get<SetViewportCommand>(frame.commands[6]).rect, (ViewportRect{2, 2, 3, 4}));
}

TEST_F(IdentifiedTextures, AreNotCopiedIntoOthersOfSizeOrFormat)
{
    m_Cmd.CopyTexture(m_Color, RTHandle(test::Target("Small", 8, 4)));
    EXPECT_THAT(ErrorOfExecution(),
                Mentions("CopyTexture", "'CameraColor' is 40x20", "'Small' is 8x4", "the same"));
    m_Cmd.CopyTexture(m_Depth, RTHandle(test::DepthTarget("Depth", 40, 20)));
    EXPECT_THAT(ErrorOfExecution(),
                Mentions("CopyTexture", "'CameraDepth'", "D32_SFloat_S8_UInt", "only colours"));
    m_Cmd.CopyTexture(m_Color, BuiltinRenderTextureType::CameraTarget);
    EXPECT_THAT(ErrorOfExecution(), Mentions("CopyTexture", "'CameraColor'", "both"));
}

TEST_F(IdentifiedTextures, ThatWereNeverMadeAreASentence)
{
    m_Cmd.Blit("_Lost", m_Color, m_Sampling);
    EXPECT_THAT(ErrorOfExecution(),
                Mentions("Blit:", "'_Lost'", "no texture", "GetTemporaryRT", "SetGlobalTexture"));
    m_Cmd.SetRenderTarget(BuiltinRenderTextureType::CurrentActive);
    EXPECT_THAT(ErrorOfExecution(), Mentions("SetRenderTarget", "CurrentActive", "no target"));
    m_Cmd.Blit(BuiltinRenderTextureType::None, m_Color);
    EXPECT_THAT(ErrorOfExecution(), Mentions("Blit:", "source is None", "no material"));
    m_Cmd.Blit(m_Color, BuiltinRenderTextureType::None);
    EXPECT_EQ(ErrorOfExecution(), "Blit: the destination is None");
    m_Cmd.Blit(m_Color, BuiltinRenderTextureType::CameraTarget);
    EXPECT_THAT(ErrorOfExecution(), Mentions("Blit:", "'CameraColor'", "both"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Cmd.Blit(RTHandle(), m_Color); }),
                Mentions("RenderTargetIdentifier", "empty"));
    m_Context.EndCamera();
    m_Cmd.GetTemporaryRT("_A", 8, 4);
    EXPECT_THAT(ErrorOfExecution(), Mentions("GetTemporaryRT", "no camera", "CameraTarget"));
}

TEST_F(IdentifiedTextures, ReleasedTwiceAreNotedOnce)
{
    m_Cmd.GetTemporaryRT("_A", 8, 4);
    for (int i = 0; i < 3; ++i)
    {
        m_Cmd.ReleaseTemporaryRT("_A");
    }
    Execute();
    EXPECT_THAT(m_Report.notes,
                ElementsAre(Mentions("ReleaseTemporaryRT", "'_A'", "no temporary texture")));
}

namespace
{

class IdlePass final : public ScriptableRenderPass
{
    void Execute(ScriptableRenderContext&, RenderingData&) override {}
};

} // namespace

TEST_F(IdentifiedTextures, AreBlittedByAPass)
{
    IdlePass pass;
    RenderTargetHandle temp;
    EXPECT_EQ(temp, RenderTargetHandle::CameraTarget);
    temp.Init("_Temp");
    EXPECT_NE(temp, RenderTargetHandle::CameraTarget);
    m_Cmd.GetTemporaryRT(temp.id, 8, 4);
    pass.Blit(m_Cmd, RenderTargetHandle::CameraTarget.Identifier(), temp.Identifier(), m_Sampling);
    pass.Blit(m_Cmd, temp.Identifier(), BuiltinRenderTextureType::CameraTarget);
    pass.ConfigureClear(ClearFlag::All, Color::red);
    pass.Blit(m_Cmd, m_Color, temp.Identifier(), m_Sampling);
    pass.Blit(m_Cmd, m_Other, m_Color);
    const FrameCommands frame = Execute();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 4u);
    EXPECT_EQ(draws[0].shader, m_Sampling->shader());
    EXPECT_EQ(draws[1].shader, m_CopyMaterial->shader());
    EXPECT_EQ(draws[3].bindings->textures.at(0).texture, m_Other.rt());
    const auto& clear = std::get<ClearCommand>(frame.commands.at(5));
    EXPECT_EQ(clear.flags, ClearFlag::Color);
    EXPECT_EQ(clear.color, Color::red);
}

TEST_F(IdentifiedTextures, HaveMipLevelsMadeOfWhatIsDrawnLast)
{
    RenderTextureDescriptor descriptor(16, 8, GraphicsFormat::R8_UNorm);
    descriptor.useMipMap = true;
    descriptor.autoGenerateMips = false;
    m_Cmd.GetTemporaryRT("_Mips", descriptor, FilterMode::Trilinear);
    m_Cmd.SetRenderTarget("_Mips");
    m_Cmd.SetRenderTarget(m_Other);
    m_Cmd.SetRenderTarget("_Mips");
    m_Cmd.SetRenderTarget(m_Other);
    m_Cmd.GenerateMips("_Mips");
    const FrameCommands frame = Execute();
    ASSERT_EQ(frame.commands.size(), 4u);
    EXPECT_FALSE(TargetAt(frame, 0).generatesMips);
    EXPECT_TRUE(TargetAt(frame, 2).generatesMips);
    EXPECT_FALSE(TargetAt(frame, 3).generatesMips);
    EXPECT_THAT(m_Report.notes, ElementsAre());
    m_Cmd.GenerateMips("_Mips");
    Execute();
    EXPECT_THAT(m_Report.notes,
                ElementsAre(Mentions("GenerateMips", "'_Mips'", "nothing has drawn")));
    const auto refusal = Mentions("GenerateMips", "'Other'", "no render texture", "useMipMap");
    m_Cmd.GenerateMips(m_Other);
    EXPECT_THAT(ErrorOfExecution(), refusal);
    m_Cmd.Clear();
    m_Cmd.GenerateMips(m_Other.rt());
    EXPECT_THAT(ErrorOfExecution(), refusal) << "a RenderTexture is one of Unity's arguments, too";
}

} // namespace limn
