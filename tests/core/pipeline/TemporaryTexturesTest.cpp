#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>

#include "pipeline/PipelineTest.h"

namespace limn
{
namespace
{

/// Draws an object into one temporary texture, that one into another, and this into the camera's.
class TemporaryPass final : public ScriptableRenderPass
{
public:
    explicit TemporaryPass(const GameObject& object) : m_Object(object)
    {
        renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
    }

    void Execute(ScriptableRenderContext& context, RenderingData& data) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        const TemporaryTexture mask = data.temporaryTextures->GetTemporary(8, 4);
        const TemporaryTexture copy = data.temporaryTextures->GetTemporary(8, 4);
        CoreUtils::SetRenderTarget(*cmd, mask, ClearFlag::Color);
        cmd->DrawRenderer(m_Object, m_Material);
        cmd->Blit(mask, copy, m_Material);
        cmd->Blit(copy, data.cameraData.renderer->cameraColorTargetHandle(), m_Material);
        context.ExecuteCommandBuffer(*cmd);
        used = {mask.rt(), copy.rt()};
    }

    std::vector<std::shared_ptr<const RenderTexture>> used; ///< by the last frame

private:
    const GameObject& m_Object;
    std::shared_ptr<Material> m_Material = std::make_shared<Material>(test::ShaderWithProgram(
        "_MainTex (\"\", 2D) = \"black\" {}", "Texture2D _MainTex; SamplerState sampler_MainTex;",
        "_MainTex.Sample(sampler_MainTex, 0.5)"));
};

/// The same colours there and back by a named texture, as URP 8 to 12 features do it.
class NamedTemporaryPass final : public ScriptableRenderPass
{
public:
    NamedTemporaryPass()
    {
        m_Temp.Init("_NamedTemporary");
        renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
    }

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& data) override
    {
        cmd.GetTemporaryRT(m_Temp.id, data.cameraData.cameraTargetDescriptor);
    }
    void Execute(ScriptableRenderContext& context, RenderingData&) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        Blit(*cmd, BuiltinRenderTextureType::CameraTarget, m_Temp.Identifier());
        Blit(*cmd, m_Temp.Identifier(), BuiltinRenderTextureType::CameraTarget);
        context.ExecuteCommandBuffer(*cmd);
    }
    void OnCameraCleanup(CommandBuffer& cmd) override { cmd.ReleaseTemporaryRT(m_Temp.id); }

private:
    RenderTargetHandle m_Temp;
};

class NamedTemporaryFeature final : public ScriptableRendererFeature
{
public:
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    NamedTemporaryPass m_Pass;
};

class TemporaryFeature final : public ScriptableRendererFeature
{
public:
    explicit TemporaryFeature(const GameObject& object) : pass(object) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(pass);
    }

    TemporaryPass pass;
};

/// A cube before a camera, drawn by way of temporary textures.
class TemporaryTextures : public test::PipelineTest<>
{
protected:
    TemporaryTextures() : PipelineTest(8, 4)
    {
        GameObject& cube = test::AddCube(m_Scene, "cube", {0.0f, 0.0f, 5.0f}, {});
        auto feature = std::make_unique<TemporaryFeature>(cube);
        m_Pass = &feature->pass;
        m_Renderer.AddFeature(std::move(feature));
        m_Cube = &cube;
    }

    GameObject* m_Cube = nullptr;
    TemporaryPass* m_Pass = nullptr;
};

} // namespace

TEST_F(TemporaryTextures, AreTheSameInEachFrameWhichIsNotCompiledAgain)
{
    std::uint64_t structure = 0;
    for (int i = 0; i < 4; ++i)
    {
        structure = Render().frame->structure;
    }
    const auto used = m_Pass->used;
    EXPECT_NE(used[0], used[1]);
    m_Cube->transform.localPosition.x = 0.5f;
    EXPECT_EQ(Render().frame->structure, structure);
    EXPECT_EQ(m_Pass->used, used);
}

TEST_F(TemporaryTextures, OfANameAreTheSameInEachFrameWhichIsNotCompiledAgain)
{
    m_Renderer.AddFeature(std::make_unique<NamedTemporaryFeature>());
    const RenderResult first = Render();
    EXPECT_TRUE(first.report.notes.empty());
    std::uint64_t structure = 0;
    for (int i = 0; i < 3; ++i)
    {
        structure = Render().frame->structure;
    }
    m_Cube->transform.localPosition.x = 0.5f;
    const RenderResult last = Render();
    EXPECT_EQ(last.frame->structure, structure);
    EXPECT_TRUE(last.report.notes.empty());
}

TEST_F(TemporaryTextures, AreNotSharedByTwoPipelines)
{
    Render();
    const auto first = m_Pass->used;
    RecordingDevice device;
    UniversalRenderPipeline other(device);
    other.RenderSingleCamera(m_Renderer, m_Request);
    EXPECT_NE(m_Pass->used[0], first[0]);
    EXPECT_NE(m_Pass->used[1], first[1]);
    Render();
    EXPECT_EQ(m_Pass->used, first);
}

} // namespace limn
