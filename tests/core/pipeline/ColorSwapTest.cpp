#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "pipeline/PipelineTest.h"
#include "pipeline/RendererHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

/// A pass that runs what a test says.
class SwappingPass final : public ScriptableRenderPass
{
public:
    using Action = std::function<void(const SwappingPass&, CommandBuffer&, RenderingData&)>;

    SwappingPass(int event, Action action) : m_Action(std::move(action))
    {
        renderPassEvent = static_cast<RenderPassEvent>(event);
    }
    void Execute(ScriptableRenderContext& context, RenderingData& data) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        m_Action(*this, *cmd, data);
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    Action m_Action;
};

class SwappingFeature final : public ScriptableRendererFeature
{
public:
    SwappingFeature(int event, SwappingPass::Action action) : m_Pass(event, std::move(action)) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    SwappingPass m_Pass;
};

/// What ScriptableRenderPass::Blit does that makes its destination the camera's colour.
class ColorSwaps : public test::PipelineTest<>
{
protected:
    ColorSwaps() : PipelineTest(8, 4) { m_Request.compile.leavesOut = false; }

    void Add(int event, SwappingPass::Action action)
    {
        m_Renderer.AddFeature(std::make_unique<SwappingFeature>(event, std::move(action)));
    }
    void AddSwap(int event)
    {
        Add(event, [this](const SwappingPass& pass, CommandBuffer& cmd, RenderingData& data)
            { pass.Blit(cmd, data, m_Reads); });
    }
    RenderResult Render()
    {
        test::AddCube(m_Scene, "cube", {0, 0, 10}, {m_Opaque});
        return PipelineTest::Render();
    }
    /// "texture <- what its draws read" of all passes in order.
    static std::vector<std::string> DrawnInto(const RenderResult& result)
    {
        std::vector<std::string> passes;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            std::string text = pass.colors.at(0).texture->name() + " <-";
            for (const PassCommand& command : pass.commands)
            {
                const auto* draw = std::get_if<DrawCommand>(&command);
                const auto* bindings =
                    draw != nullptr ? result.frame->Setup(*draw).bindings.get() : nullptr;
                text += bindings == nullptr          ? ""
                        : bindings->textures.empty() ? " nothing"
                                                     : " " + bindings->textures[0].texture->name();
            }
            passes.push_back(text);
        }
        return passes;
    }
    static std::shared_ptr<Material> Reading(const std::string& texture)
    {
        return std::make_shared<Material>(test::ShaderWithProgram(
            "", "Texture2D " + texture + ";", texture + ".Load(int3(0, 0, 0))"));
    }

    const std::shared_ptr<Material> m_Opaque =
        std::make_shared<Material>(test::ShaderWithProgram(""));
    const std::shared_ptr<Material> m_Reads = Reading("_BlitTexture");
};

TEST_F(ColorSwaps, ReachTheOutputWithoutACopyBack)
{
    AddSwap(300);
    EXPECT_THAT(DrawnInto(Render()),
                ElementsAre("_CameraColorAttachmentA <- nothing",
                            "_CameraColorAttachmentB <- _CameraColorAttachmentA",
                            HasSubstr(" <- _CameraColorAttachmentB")));
}

TEST_F(ColorSwaps, GoThereAndBackAndBeginAnewInEachFrame)
{
    AddSwap(300);
    AddSwap(310);
    for (int frame = 0; frame < 2; ++frame)
    {
        EXPECT_THAT(DrawnInto(Render()),
                    ElementsAre(HasSubstr("_CameraColorAttachmentA <- nothing"),
                                "_CameraColorAttachmentB <- _CameraColorAttachmentA",
                                "_CameraColorAttachmentA <- _CameraColorAttachmentB",
                                HasSubstr(" <- _CameraColorAttachmentA")))
            << "frame " << frame;
    }
}

TEST_F(ColorSwaps, AreWhatLaterPassesAndCommandsCallTheCameras)
{
    RTHandle before;
    RTHandle after;
    Add(300,
        [&](const SwappingPass& pass, CommandBuffer& cmd, RenderingData& data)
        {
            before = data.cameraData.renderer->cameraColorTargetHandle();
            cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
            cmd.DrawProcedural(glm::mat4(1.0f), m_Opaque, 0, 3);
            pass.Blit(cmd, data, m_Reads);
            cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
            cmd.DrawProcedural(glm::mat4(1.0f), m_Opaque, 0, 3);
            after = data.cameraData.renderer->cameraColorTargetHandle();
        });
    Add(500, [this](const SwappingPass&, CommandBuffer& cmd, RenderingData&)
        { cmd.DrawProcedural(glm::mat4(1.0f), m_Opaque, 0, 3); });
    const RenderResult result = Render();
    EXPECT_THAT(DrawnInto(result), ElementsAre("_CameraColorAttachmentA <- nothing nothing",
                                               "_CameraColorAttachmentB <- _CameraColorAttachmentA",
                                               "_CameraColorAttachmentB <- nothing nothing",
                                               HasSubstr(" <- _CameraColorAttachmentB")));
    EXPECT_EQ(before.rt()->name(), "_CameraColorAttachmentA");
    EXPECT_EQ(after.rt()->name(), "_CameraColorAttachmentB");
    EXPECT_EQ(after.rt()->descriptor(), before.rt()->descriptor());
    EXPECT_FALSE(result.frame->passes.at(1).depth) << "a blit has none";
    EXPECT_TRUE(result.frame->passes.at(2).depth) << "the camera keeps its own";
}

TEST_F(ColorSwaps, AreWhatTheOpaqueTextureIsCopiedFromIfTheyComeBefore)
{
    const auto opaque = Reading("_CameraOpaqueTexture");
    const auto read = [&](const SwappingPass&, CommandBuffer& cmd, RenderingData&)
    {
        cmd.DrawProcedural(glm::mat4(1.0f), opaque, 0, 3);
    };
    AddSwap(300);
    AddSwap(450);
    Add(500, read);
    EXPECT_THAT(DrawnInto(Render()),
                ElementsAre("_CameraColorAttachmentA <- nothing",
                            "_CameraColorAttachmentB <- _CameraColorAttachmentA",
                            "_CameraOpaqueTexture <- _CameraColorAttachmentB",
                            "_CameraColorAttachmentA <- _CameraColorAttachmentB",
                            "_CameraColorAttachmentA <- _CameraOpaqueTexture",
                            HasSubstr(" <- _CameraColorAttachmentA")));
}

TEST_F(ColorSwaps, NeedAMaterialAndARendererWithASecondColor)
{
    std::shared_ptr<const Material> material;
    SwappingPass pass(300, [&](const SwappingPass& self, CommandBuffer& cmd, RenderingData& data)
                      { self.Blit(cmd, data, material); });
    const auto message = [](const std::function<void()>& render)
    {
        return test::ThrownMessage<ContractError>(render);
    };
    Add(300, [&](const SwappingPass& self, CommandBuffer& cmd, RenderingData& data)
        { self.Blit(cmd, data, material); });
    EXPECT_THAT(message([&] { Render(); }), test::Mentions("BlitTexture", "material", "null"));
    material = m_Reads;
    test::Log log;
    test::RendererHarness harness;
    harness.AddFeature("f", log, {&pass});
    EXPECT_THAT(message([&] { harness.Render(); }), test::Mentions("Blit(", "no second colour"));
}

} // namespace
} // namespace limn
