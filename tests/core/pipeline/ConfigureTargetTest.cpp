#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "pipeline/RendererHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using TexturePtr = std::shared_ptr<const Texture>;

/// Makes temporary textures when the camera is set up.
class NamedTargetPass final : public test::LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void OnCameraSetup(CommandBuffer& cmd, RenderingData&) override
    {
        cmd.SetGlobalTexture("_Both", m_Both);
        cmd.SetGlobalTexture("_Color", m_ColorOnly);
    }

private:
    static constexpr GraphicsFormat k_Format = GraphicsFormat::R8G8B8A8_SRGB;
    const test::RenderTexturePtr m_Both =
        std::make_shared<const RenderTexture>("both", RenderTextureDescriptor(8, 4, k_Format, 24));
    const test::RenderTexturePtr m_ColorOnly =
        std::make_shared<const RenderTexture>("color", RenderTextureDescriptor(8, 4, k_Format));
};

/// What ConfigureTarget of identifiers and of several colours makes a pass draw into.
class ConfiguredTargets : public testing::Test
{
protected:
    CompiledFrame Render(std::vector<ScriptableRenderPass*> passes)
    {
        m_Harness.AddFeature("f", m_Log, std::move(passes));
        return m_Harness.Render();
    }
    CompiledFrame Render() { return Render({&m_Pass}); }
    static std::vector<TexturePtr> ColorsOf(const CompiledRenderPass& pass)
    {
        std::vector<TexturePtr> colors;
        for (const ColorAttachment& color : pass.colors)
        {
            colors.push_back(color.texture);
        }
        return colors;
    }
    static std::vector<Color> ClearsOf(const CompiledRenderPass& pass)
    {
        std::vector<Color> colors;
        for (const ColorAttachment& color : pass.colors)
        {
            EXPECT_EQ(color.load, LoadOp::Clear);
            colors.push_back(color.clearColor);
        }
        return colors;
    }

    test::Log m_Log;
    test::RendererHarness m_Harness;
    const RTHandle& m_Color = m_Harness.renderer.color;
    const RTHandle& m_Depth = m_Harness.renderer.depth;
    NamedTargetPass m_Pass{"pass", RenderPassEvent::AfterRenderingOpaques, m_Log};
    test::LoggingPass m_Other{"other", RenderPassEvent::AfterRenderingOpaques + 1, m_Log};
    const RTHandle m_Mask{test::Target("Mask")};
    const RTHandle m_Normals{test::Target("Normals")};
};

TEST_F(ConfiguredTargets, ByNameAreTexturesWithTheDepthThatTheyHave)
{
    m_Pass.ConfigureTarget("_Both");
    m_Pass.ConfigureClear(ClearFlag::All, Color::red);
    const CompiledFrame frame = Render();
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(ClearsOf(frame.passes[0]), ElementsAre(Color::red));
    EXPECT_EQ(frame.passes[0].colors[0].texture->graphicsFormat(), GraphicsFormat::R8G8B8A8_SRGB);
    ASSERT_TRUE(frame.passes[0].depth);
    EXPECT_TRUE(HasStencil(frame.passes[0].depth->texture->graphicsFormat()));
    EXPECT_EQ(frame.passes[0].depth->load, LoadOp::Clear);

    m_Pass.ConfigureTarget("_Color");
    const CompiledFrame colorOnly = m_Harness.Render();
    ASSERT_EQ(colorOnly.passes.size(), 1u);
    EXPECT_FALSE(colorOnly.passes[0].depth);

    m_Pass.ConfigureTarget("_Color", "_Both");
    const CompiledFrame both = m_Harness.Render();
    ASSERT_EQ(both.passes.size(), 1u);
    EXPECT_TRUE(both.passes[0].depth);
}

TEST_F(ConfiguredTargets, MayBeTheCamerasByIdentifier)
{
    const RenderTargetIdentifier camera = BuiltinRenderTextureType::CameraTarget;
    const auto configure = [&](int way)
    {
        switch (way)
        {
        case 0:
            m_Pass.ConfigureTarget(camera);
            break;
        case 1:
            m_Pass.ConfigureTarget(camera, camera);
            break;
        case 2:
            m_Pass.ConfigureTarget(m_Color.nameID(), m_Depth.nameID());
            break;
        default:
            m_Pass.ConfigureTarget(RTHandles::Alloc(camera));
        }
    };
    m_Harness.camera.backgroundColor = Color::green;
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    Render({&m_Pass, &m_Other});
    for (int way = 0; way < 4; ++way)
    {
        configure(way);
        const CompiledFrame frame = m_Harness.Render();
        ASSERT_EQ(frame.passes.size(), 1u) << "the other pass goes on with the same, way " << way;
        EXPECT_THAT(ColorsOf(frame.passes[0]), ElementsAre(m_Color.rt()));
        EXPECT_EQ(frame.passes[0].depth->texture, m_Depth.rt());
        EXPECT_THAT(ClearsOf(frame.passes[0]), ElementsAre(Color::green)) << "the background";
        EXPECT_EQ(frame.passes[0].depth->load, LoadOp::Clear);
    }
}

TEST_F(ConfiguredTargets, OfSeveralColorsAreAllClearedToThePassesColor)
{
    const std::vector<RTHandle> colors{m_Mask, m_Normals};
    m_Pass.ConfigureTarget(colors, m_Depth);
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    EXPECT_EQ(m_Pass.colorAttachmentHandle(), m_Mask);
    EXPECT_THAT(m_Pass.colorAttachmentHandles(), ElementsAre(m_Mask, m_Normals));
    EXPECT_EQ(m_Pass.depthAttachmentHandle(), m_Depth);
    const CompiledFrame frame = Render();
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(ColorsOf(frame.passes[0]), ElementsAre(m_Mask.rt(), m_Normals.rt()));
    EXPECT_THAT(ClearsOf(frame.passes[0]), ElementsAre(Color::red, Color::red));
    EXPECT_EQ(frame.passes[0].depth->load, LoadOp::Clear) << "the camera's, used first";
    EXPECT_EQ(frame.passes[0].depth->clearDepth, 1.0f);
}

// URP 14: the camera's colour among several is cleared to the background on first use, the other
// ones to what the pass asks for, if it asks.
TEST_F(ConfiguredTargets, OfSeveralColorsClearTheCamerasApartOnFirstUse)
{
    m_Harness.camera.backgroundColor = Color::green;
    const std::vector<RTHandle> colors{m_Mask, m_Color};
    m_Pass.ConfigureTarget(colors, m_Depth);
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    const CompiledFrame frame = Render();
    ASSERT_EQ(frame.passes.size(), 3u);
    EXPECT_THAT(ColorsOf(frame.passes[0]), ElementsAre(m_Color.rt()));
    EXPECT_THAT(ClearsOf(frame.passes[0]), ElementsAre(Color::green));
    EXPECT_THAT(ColorsOf(frame.passes[1]), ElementsAre(m_Mask.rt()));
    EXPECT_THAT(ClearsOf(frame.passes[1]), ElementsAre(Color::red));
    EXPECT_THAT(ColorsOf(frame.passes[2]), ElementsAre(m_Mask.rt(), m_Color.rt()));
    EXPECT_EQ(frame.passes[2].colors[0].load, LoadOp::Load);
    EXPECT_EQ(frame.passes[2].colors[1].load, LoadOp::Load);
    EXPECT_EQ(frame.passes[2].depth->load, LoadOp::Clear);

    m_Pass.ConfigureClear(ClearFlag::None, Color::red);
    const CompiledFrame kept = m_Harness.Render();
    ASSERT_EQ(kept.passes.size(), 2u);
    EXPECT_THAT(ColorsOf(kept.passes[0]), ElementsAre(m_Color.rt()));
    EXPECT_THAT(ClearsOf(kept.passes[0]), ElementsAre(Color::green));
    EXPECT_EQ(kept.passes[1].colors[0].load, LoadOp::Load);
}

// What the camera is cleared to and what the pass asks for being the same, nothing is apart.
TEST_F(ConfiguredTargets, OfSeveralColorsAreClearedTogetherWhereAllAskForTheSame)
{
    m_Harness.camera.backgroundColor = Color::red;
    const std::vector<RTHandle> colors{m_Mask, m_Color};
    m_Pass.ConfigureTarget(colors, m_Depth);
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    const CompiledFrame frame = Render();
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(ClearsOf(frame.passes[0]), ElementsAre(Color::red, Color::red));
}

TEST_F(ConfiguredTargets, OfSeveralColorsMayBeIdentifiers)
{
    const std::vector<RenderTargetIdentifier> colors{"_Color",
                                                     BuiltinRenderTextureType::CameraTarget};
    m_Harness.camera.backgroundColor = Color::green;
    m_Pass.ConfigureClear(ClearFlag::Color, Color::red);
    m_Pass.ConfigureTarget(colors);
    const CompiledFrame clears = Render();
    ASSERT_EQ(clears.passes.size(), 2u);
    EXPECT_THAT(ColorsOf(clears.passes[0]), ElementsAre(m_Color.rt()));
    EXPECT_THAT(ClearsOf(clears.passes[0]), ElementsAre(Color::green));
    EXPECT_THAT(ClearsOf(clears.passes[1]), ElementsAre(Color::red)) << "the other texture";
    m_Pass.ConfigureTarget(colors, BuiltinRenderTextureType::CameraTarget);
    const CompiledFrame frame = m_Harness.Render();
    ASSERT_EQ(frame.passes.size(), 3u);
    EXPECT_EQ(frame.passes[2].colors.at(1).texture, m_Color.rt());
    EXPECT_EQ(frame.passes[2].depth->texture, m_Depth.rt());
    EXPECT_EQ(frame.passes[2].depth->load, LoadOp::Clear);
}

TEST_F(ConfiguredTargets, AreAtMostEightColorsWithEmptyOnesBehindThem)
{
    std::vector<RTHandle> colors(9);
    colors[0] = m_Mask;
    m_Pass.ConfigureTarget(colors);
    EXPECT_THAT(m_Pass.colorAttachmentHandles(), ElementsAre(m_Mask));
    colors[8] = m_Normals;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Pass.ConfigureTarget(colors); }),
                test::Mentions("ConfigureTarget", "9 colour targets", "at most 8"));
    colors.resize(3);
    colors[2] = m_Normals;
    m_Pass.ConfigureTarget(colors);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                HasSubstr("a colour target is an empty handle"));
    m_Pass.ResetTarget();
    EXPECT_THAT(m_Pass.colorAttachmentHandles(), IsEmpty());
    EXPECT_EQ(m_Pass.colorAttachmentHandle(), RTHandle());
}

// The pattern of URP 8 to 12: Setup(renderer.cameraColorTarget) in AddRenderPasses.
TEST_F(ConfiguredTargets, MayBeTheRenderersBeforeThereAreAny)
{
    m_Pass.ConfigureTarget(m_Harness.renderer.cameraColorTarget());
    const CompiledFrame frame = Render();
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(ColorsOf(frame.passes[0]), ElementsAre(m_Color.rt()));
    EXPECT_FALSE(frame.passes[0].depth) << "the colour of URP 12 and later has none";
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Harness.renderer.cameraDepthTarget(); }),
                HasSubstr("cameraDepthTargetHandle exists only while"));
}

TEST_F(ConfiguredTargets, CannotBeNoIdentifierNorANameOfNothing)
{
    EXPECT_EQ(test::ThrownMessage<ContractError>(
                  [&] { m_Pass.ConfigureTarget(RenderTargetIdentifier()); }),
              "RTHandles::Alloc: the identifier is none");
    m_Pass.ConfigureTarget("_Nowhere");
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                HasSubstr("SetRenderTarget: '_Nowhere' stands for no texture"));
}

} // namespace
} // namespace limn
