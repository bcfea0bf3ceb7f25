#include "Mentions.h"
#include "core/scene/TestScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/FullScreenPassRendererFeature.h>

using namespace limn;
using testing::ElementsAre;

namespace
{

class FullScreenPass : public testing::Test
{
protected:
    FullScreenPass() { feature->passMaterial = material; }

    RenderResult Render()
    {
        UniversalRenderer renderer(test::Compiler());
        renderer.AddFeature(std::move(feature));
        RenderRequest request;
        request.scene = &scene;
        request.camera = &camera;
        request.width = 64;
        request.height = 32;
        request.compile.leavesOut = false; // frames as recorded
        return pipeline.RenderSingleCamera(renderer, request);
    }

    /// "name → first colour target" of each compiled pass.
    static std::vector<std::string> Targets(const RenderResult& result)
    {
        std::vector<std::string> names;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            names.push_back(pass.colors.front().texture->name());
        }
        return names;
    }

    /// The names of the textures that the pass's only draw samples.
    static std::vector<std::string> Sampled(const CompiledFrame& frame, std::size_t pass)
    {
        std::vector<std::string> names;
        int draws = 0;
        for (const PassCommand& command : frame.passes.at(pass).commands)
        {
            if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                ++draws;
                for (const TextureSlot& slot : frame.Setup(*draw).bindings->textures)
                {
                    names.push_back(slot.texture->name());
                }
            }
        }
        EXPECT_EQ(draws, 1);
        return names;
    }

    std::unique_ptr<FullScreenPassRendererFeature> feature =
        std::make_unique<FullScreenPassRendererFeature>();
    const std::shared_ptr<Material> material = std::make_shared<Material>(
        test::ShaderWithProgram("", "Texture2D _BlitTexture;", "_BlitTexture.Load(int3(0, 0, 0))"));
    Scene scene;
    Camera camera;
    RecordingDevice device;
    UniversalRenderPipeline pipeline{device};
};

TEST_F(FullScreenPass, HasUnitysDefaults)
{
    using Point = FullScreenPassRendererFeature::InjectionPoint;
    EXPECT_EQ(feature->injectionPoint, Point::AfterRenderingPostProcessing);
    EXPECT_EQ(static_cast<int>(Point::BeforeRenderingTransparents), 450);
    EXPECT_EQ(static_cast<int>(Point::BeforeRenderingPostProcessing), 550);
    EXPECT_EQ(static_cast<int>(Point::AfterRenderingPostProcessing), 600);
    EXPECT_TRUE(feature->fetchColorBuffer);
    EXPECT_EQ(feature->requirements, ScriptableRenderPassInput::None);
    EXPECT_EQ(feature->passIndex, 0);
    EXPECT_FALSE(feature->bindDepthStencilAttachment);
}

TEST_F(FullScreenPass, ReadsACopyOfThePictureAndDrawsIntoThePicture)
{
    const RenderResult result = Render();
    EXPECT_THAT(Targets(result), ElementsAre("_CameraColorAttachmentA", "_FullscreenPassColorCopy",
                                             "_CameraColorAttachmentA", "limn_Output"));
    EXPECT_FALSE(result.frame->passes[2].depth);
    EXPECT_TRUE(result.report.notes.empty());
    EXPECT_THAT(Sampled(*result.frame, 1), ElementsAre("_CameraColorAttachmentA"));
    EXPECT_THAT(Sampled(*result.frame, 2), ElementsAre("_FullscreenPassColorCopy"));
}

TEST_F(FullScreenPass, LeavesTheCopyOutWhereNothingIsFetched)
{
    feature->fetchColorBuffer = false;
    feature->passMaterial = std::make_shared<Material>(test::ShaderWithProgram(""));
    EXPECT_THAT(Targets(Render()),
                ElementsAre("_CameraColorAttachmentA", "_CameraColorAttachmentA", "limn_Output"));
}

TEST_F(FullScreenPass, BindsTheCamerasDepthWhereAsked)
{
    feature->bindDepthStencilAttachment = true;
    EXPECT_TRUE(Render().frame->passes.at(2).depth);
}

TEST_F(FullScreenPass, DrawsNothingWithoutAMaterialAndSaysSo)
{
    feature->passMaterial = nullptr;
    const RenderResult result = Render();
    EXPECT_THAT(Targets(result), ElementsAre("_CameraColorAttachmentA", "limn_Output"));
    EXPECT_THAT(result.report.notes,
                ElementsAre(test::Mentions("FullScreenPassRendererFeature", "not drawn",
                                           "passMaterial", "not assigned")));
}

TEST_F(FullScreenPass, DrawsNothingWithAPassThatIsNotThereAndSaysSo)
{
    feature->passIndex = 1;
    EXPECT_THAT(Render().report.notes,
                ElementsAre(test::Mentions("FullScreenPassRendererFeature", "not drawn",
                                           "passIndex is 1", "'Test/Program'", "0...0")));
}

} // namespace
