#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/BuiltinShaders.h>

#include "Mentions.h"
#include "pipeline/PipelineTest.h"
#include "texture/PickyDevice.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using Needs = ScriptableRenderPassInput;

std::shared_ptr<Material> ReaderOf(const std::string& texture)
{
    return std::make_shared<Material>(test::ShaderWithProgram("", "Texture2D " + texture + ";",
                                                              texture + ".Load(int3(0, 0, 0))"));
}

/// Draws a triangle that reads these textures over the camera's picture.
class ReadingPass final : public ScriptableRenderPass
{
public:
    ReadingPass(const std::string& name, int event, ScriptableRenderPassInput asks,
                const std::vector<std::string>& textures)
    {
        profilingSampler = ProfilingSampler(name);
        renderPassEvent = static_cast<RenderPassEvent>(event);
        ConfigureInput(asks);
        for (const std::string& texture : textures)
        {
            m_Materials.push_back(ReaderOf(texture));
        }
    }

    void Execute(ScriptableRenderContext& context, RenderingData&) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        if (renderPassEvent < RenderPassEvent::BeforeRenderingPrePasses)
        {
            cmd->SetRenderTarget(m_Early);
        }
        for (const auto& material : m_Materials)
        {
            cmd->DrawProcedural(glm::mat4(1.0f), material, 0, 3);
        }
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    const RTHandle m_Early{test::Target("Early")};
    std::vector<std::shared_ptr<const Material>> m_Materials;
};

/// Enqueues its pass.
class ReadingFeature final : public ScriptableRendererFeature
{
public:
    template <typename... Arguments>
    explicit ReadingFeature(Arguments&&... arguments)
        : m_Pass(std::forward<Arguments>(arguments)...)
    {
    }
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    ReadingPass m_Pass;
};

/// An opaque cube that can be drawn in prepasses, seen by a camera of 64 x 32 pixels.
class CameraTextures : public test::PipelineTest<>
{
protected:
    CameraTextures() : PipelineTest(64, 32)
    {
        test::AddCube(m_Scene, "cube", {-1, 0, 10}, {m_Lit});
    }

    void AddPass(const std::string& name, int event, ScriptableRenderPassInput asks,
                 const std::vector<std::string>& textures = {})
    {
        m_Renderer.AddFeature(std::make_unique<ReadingFeature>(name, event, asks, textures));
    }
    void AddCube(const std::string& texture, int queue)
    {
        const auto material = ReaderOf(texture);
        material->SetRenderQueue(queue);
        test::AddCube(m_Scene, "reader", {1, 0, 10}, {material});
    }

    /// "event name" of all that ran, in order.
    static std::vector<std::string> Ran(const RenderResult& result)
    {
        std::vector<std::string> passes;
        for (const ExecutedPassReport& pass : result.report.passes)
        {
            passes.push_back(std::to_string(static_cast<int>(pass.renderPassEvent)) + " " +
                             pass.name.name());
        }
        return passes;
    }

    /// The pass that draws into a texture of this name; the test fails if there is none.
    static CompiledRenderPass PassInto(const RenderResult& result, const std::string& texture)
    {
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            for (const ColorAttachment& color : pass.colors)
            {
                if (color.texture->name() == texture)
                {
                    return pass;
                }
            }
            if (pass.depth && pass.depth->texture->name() == texture)
            {
                return pass;
            }
        }
        ADD_FAILURE() << "nothing draws into " << texture;
        return {};
    }

    const std::shared_ptr<Material> m_Lit =
        std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", test::Compiler()));
};

TEST_F(CameraTextures, AreNotMadeWhereTheyAreAskedForAndNotRead)
{
    AddPass("asks", 300, Needs::Depth | Needs::Normal | Needs::Color);
    m_Request.compile.leavesOut = false;
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result), ElementsAre("250 Draw Opaque Objects", "300 asks",
                                         "450 Draw Transparent Objects", "1001 Final Blit"));
    EXPECT_EQ(result.report.draws.size(), 2u);
    EXPECT_EQ(result.frame->instances.size(), 2u); // the cube and the blit
}

TEST_F(CameraTextures, HaveTheDepthCopiedBeforeTheEarliestPassThatAsks)
{
    AddPass("asks", 300, Needs::Depth);
    AddPass("reads", 550, Needs::None, {"_CameraDepthTexture"});
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result),
                ElementsAre("250 Draw Opaque Objects", "299 CopyDepth", "300 asks",
                            "450 Draw Transparent Objects", "550 reads", "1001 Final Blit"));
    const CompiledRenderPass copy = PassInto(result, "_CameraDepthTexture");
    EXPECT_EQ(copy.name, "CopyDepth");
    EXPECT_FALSE(copy.depth);
    const RenderTexture& texture = *copy.colors.at(0).texture;
    EXPECT_EQ(texture.descriptor(), RenderTextureDescriptor(64, 32, GraphicsFormat::R32_SFloat));
    EXPECT_EQ(texture.sampler().filterMode, FilterMode::Point);
    EXPECT_EQ(texture.sampler().wrapModeU, TextureWrapMode::Clamp);
    EXPECT_EQ(copy.colors.at(0).load, LoadOp::DontCare);
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(CameraTextures, HaveTheDepthCopiedBehindTransparentObjectsForLaterPasses)
{
    AddPass("reads", 600, Needs::Depth, {"_CameraDepthTexture"});
    EXPECT_THAT(Ran(Render()),
                ElementsAre("250 Draw Opaque Objects", "450 Draw Transparent Objects",
                            "500 CopyDepth", "600 reads", "1001 Final Blit"));
}

TEST_F(CameraTextures, HaveTheDepthOfAPrepassWhereOpaqueObjectsOrEarlierPassesAsk)
{
    AddPass("reads", 250, Needs::Depth, {"_CameraDepthTexture"});
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result), ElementsAre("150 DepthPrepass", "250 reads", "250 Draw Opaque Objects",
                                         "450 Draw Transparent Objects", "1001 Final Blit"));
    const CompiledRenderPass prepass = PassInto(result, "_CameraDepthTexture");
    EXPECT_THAT(prepass.colors, IsEmpty());
    ASSERT_TRUE(prepass.depth);
    EXPECT_TRUE(IsDepthFormat(prepass.depth->texture->graphicsFormat()));
    EXPECT_EQ(prepass.depth->texture->width(), 64);
    EXPECT_EQ(prepass.depth->load, LoadOp::Clear);
    EXPECT_EQ(prepass.depth->clearDepth, 1.0f);
    EXPECT_EQ(prepass.depth->store, StoreOp::Store);
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(CameraTextures, DrawTheOpaqueObjectsOfTheOpaqueLayersThatHaveAPassForIt)
{
    const auto transparent = std::make_shared<Material>(*m_Lit, m_Lit->shader());
    transparent->SetRenderQueue(3000);
    const auto noDepth = std::make_shared<Material>(test::ShaderWithProgram(""));
    test::AddCube(m_Scene, "glass", {0, 0, 9}, {transparent});
    test::AddCube(m_Scene, "no pass", {0, 0, 9}, {noDepth});
    test::AddCube(m_Scene, "other layer", {0, 0, 9}, {m_Lit}).layer = 5;
    m_Renderer.opaqueLayerMask = LayerMask{~(1u << 5)};
    AddPass("reads", 200, Needs::Depth, {"_CameraDepthTexture"});
    const RenderResult result = Render();
    const auto& draws = result.report.draws;
    const auto prepass = std::find_if(draws.begin(), draws.end(),
                                      [](const auto& draw) { return draw.pass == "DepthPrepass"; });
    ASSERT_NE(prepass, draws.end());
    EXPECT_EQ(prepass->counts[static_cast<std::size_t>(FilterVerdict::Drawn)], 1);
    EXPECT_EQ(prepass->drawing.sortingSettings.criteria, SortingCriteria::CommonOpaque);
}

TEST_F(CameraTextures, AreMadeForShadersThatReadThemWithoutAnybodyAsking)
{
    AddCube("_CameraDepthTexture", 3000);
    EXPECT_THAT(Ran(Render()), ElementsAre("250 Draw Opaque Objects", "449 CopyDepth",
                                           "450 Draw Transparent Objects", "1001 Final Blit"));
    AddCube("_CameraDepthTexture", 2000);
    const RenderResult both = Render();
    EXPECT_THAT(Ran(both), ElementsAre("150 DepthPrepass", "250 Draw Opaque Objects",
                                       "450 Draw Transparent Objects", "1001 Final Blit"));
    EXPECT_THAT(both.report.notes, IsEmpty());
}

TEST_F(CameraTextures, AreNotMadeInTheNextFrameThatDoesNotReadThem)
{
    AddCube("_CameraDepthTexture", 3000);
    Render();
    m_Scene.Find("reader")->activeSelf = false;
    EXPECT_THAT(Ran(Render()), ElementsAre("250 Draw Opaque Objects",
                                           "450 Draw Transparent Objects", "1001 Final Blit"));
}

TEST_F(CameraTextures, AreFarWithANoteInPassesBeforeTheyAreMade)
{
    AddPass("early", 0, Needs::Depth, {"_CameraDepthTexture"});
    AddPass("late", 600, Needs::None, {"_CameraDepthTexture"});
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result),
                ElementsAre("0 early", "150 DepthPrepass", "250 Draw Opaque Objects",
                            "450 Draw Transparent Objects", "600 late", "1001 Final Blit"));
    EXPECT_THAT(result.report.notes,
                ElementsAre(test::Mentions("'Test/Program'", "'early'", "'_CameraDepthTexture'",
                                           "far", "nothing", "event 150")));
    const CompiledRenderPass early = PassInto(result, "Early");
    for (const PassCommand& command : early.commands)
    {
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            EXPECT_EQ(result.frame->Setup(*draw).bindings->textures.at(0).texture,
                      DefaultTexture("black"));
        }
    }
}

// Unity: DepthNormalOnlyPass.GetGraphicsFormat.
TEST_F(CameraTextures, HaveTheNormalsInTheFirstFormatOfThreeThatTheDeviceDraws)
{
    using enum GraphicsFormat;
    AddPass("reads", 600, Needs::Normal, {"_CameraNormalsTexture"});
    for (const auto& [only, expected] : {std::pair(R8G8B8A8_SNorm, R8G8B8A8_SNorm),
                                         std::pair(R16G16B16A16_SFloat, R16G16B16A16_SFloat),
                                         std::pair(R8G8B8A8_UNorm, R32G32B32A32_SFloat)})
    {
        const test::PickyDevice device(only); // SystemInfo asks the one that was made last
        const CompiledRenderPass prepass = PassInto(Render(), "_CameraNormalsTexture");
        ASSERT_EQ(prepass.colors.size(), 1u);
        EXPECT_EQ(prepass.colors[0].texture->graphicsFormat(), expected);
    }
}

TEST_F(CameraTextures, HaveTheNormalsOfAPrepassWithTheDepth)
{
    AddPass("reads", 600, Needs::Depth | Needs::Normal,
            {"_CameraNormalsTexture", "_CameraDepthTexture"});
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result),
                ElementsAre("150 DepthNormalPrepass", "250 Draw Opaque Objects",
                            "450 Draw Transparent Objects", "600 reads", "1001 Final Blit"));
    const CompiledRenderPass prepass = PassInto(result, "_CameraNormalsTexture");
    ASSERT_EQ(prepass.colors.size(), 1u);
    const RenderTexture& texture = *prepass.colors[0].texture;
    EXPECT_EQ(texture.descriptor(),
              RenderTextureDescriptor(64, 32, GraphicsFormat::R8G8B8A8_SNorm));
    EXPECT_EQ(texture.sampler().filterMode, FilterMode::Point);
    EXPECT_EQ(texture.sampler().wrapModeV, TextureWrapMode::Clamp);
    EXPECT_EQ(prepass.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(prepass.colors[0].clearColor.r, 0.0f);
    ASSERT_TRUE(prepass.depth);
    EXPECT_EQ(prepass.depth->texture->name(), "_CameraDepthTexture");
    EXPECT_EQ(prepass.depth->store, StoreOp::Store);
}

TEST_F(CameraTextures, HaveWhatTheBuiltInPipelineHasOfDepthAndNormalsWhereAShaderReadsIt)
{
    AddPass("reads", 600, Needs::None, {"_CameraDepthNormalsTexture"});
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result), ElementsAre("150 DepthNormalPrepass", "150 EncodeDepthNormals",
                                         "250 Draw Opaque Objects", "450 Draw Transparent Objects",
                                         "600 reads", "1001 Final Blit"));
    const CompiledRenderPass encode = PassInto(result, "_CameraDepthNormalsTexture");
    const RenderTexture& texture = *encode.colors.at(0).texture;
    EXPECT_EQ(texture.descriptor(),
              RenderTextureDescriptor(64, 32, GraphicsFormat::R8G8B8A8_UNorm));
    EXPECT_EQ(texture.sampler().filterMode, FilterMode::Point);
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(CameraTextures, HaveThemForOpaqueObjectsToo)
{
    AddCube("_CameraDepthNormalsTexture", 2000);
    EXPECT_THAT(Ran(Render()), ElementsAre("150 DepthNormalPrepass", "150 EncodeDepthNormals",
                                           "250 Draw Opaque Objects",
                                           "450 Draw Transparent Objects", "1001 Final Blit"));
}

TEST_F(CameraTextures, DoNotKeepTheDepthOfNormalsThatNothingReads)
{
    AddPass("reads", 600, Needs::None, {"_CameraNormalsTexture"});
    const CompiledRenderPass prepass = PassInto(Render(), "_CameraNormalsTexture");
    ASSERT_TRUE(prepass.depth);
    EXPECT_EQ(prepass.depth->store, StoreOp::DontCare);
}

TEST_F(CameraTextures, TakeTheDepthFromTheNormalsPrepassWhereNormalsWereAskedFor)
{
    AddPass("reads", 600, Needs::Normal, {"_CameraDepthTexture"});
    EXPECT_THAT(Ran(Render()),
                ElementsAre("150 DepthNormalPrepass", "250 Draw Opaque Objects",
                            "450 Draw Transparent Objects", "600 reads", "1001 Final Blit"));
}

TEST_F(CameraTextures, HaveTheColorCopiedBeforeTransparentObjectsWhoeverAsks)
{
    AddPass("reads", 600, Needs::Color, {"_CameraOpaqueTexture"});
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result),
                ElementsAre("250 Draw Opaque Objects", "400 CopyColor",
                            "450 Draw Transparent Objects", "600 reads", "1001 Final Blit"));
    const CompiledRenderPass copy = PassInto(result, "_CameraOpaqueTexture");
    const RenderTexture& texture = *copy.colors.at(0).texture;
    EXPECT_EQ(texture.descriptor(),
              RenderTextureDescriptor(64, 32, GraphicsFormat::R16G16B16A16_SFloat));
    EXPECT_EQ(texture.sampler().filterMode, FilterMode::Point);
    EXPECT_EQ(texture.sampler().wrapModeU, TextureWrapMode::Clamp);
    EXPECT_EQ(copy.colors.at(0).load, LoadOp::DontCare);
}

TEST_F(CameraTextures, AreGrayWithANoteWhereOpaqueObjectsReadTheOpaqueColor)
{
    AddCube("_CameraOpaqueTexture", 2000);
    const RenderResult result = Render();
    EXPECT_THAT(Ran(result), ElementsAre("250 Draw Opaque Objects", "450 Draw Transparent Objects",
                                         "1001 Final Blit"));
    EXPECT_THAT(
        result.report.notes,
        ElementsAre(test::Mentions("'Test/Program'", "'Draw Opaque Objects'",
                                   "'_CameraOpaqueTexture'", "gray", "nothing", "event 400")));
}

TEST_F(CameraTextures, AreAllMadeAtTheirPlacesWhereAllAreRead)
{
    AddPass("reads", 500, Needs::None,
            {"_CameraDepthTexture", "_CameraNormalsTexture", "_CameraOpaqueTexture"});
    EXPECT_THAT(Ran(Render()), ElementsAre("150 DepthNormalPrepass", "250 Draw Opaque Objects",
                                           "400 CopyColor", "450 Draw Transparent Objects",
                                           "499 CopyDepth", "500 reads", "1001 Final Blit"));
}

TEST_F(CameraTextures, DoNotIncludeMotionVectors)
{
    AddPass("blur", 550, Needs::Motion);
    EXPECT_THAT(Render().report.notes, ElementsAre(test::Mentions("blur", "motion vectors",
                                                                  "_MotionVectorTexture is gray")));
}

} // namespace
} // namespace limn
