#include "scene/TestScene.h"

#include <gmock/gmock.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>

namespace limn
{
namespace
{

/// Draws a triangle into a texture, or one that samples it into the camera's.
class TrianglePass final : public ScriptableRenderPass
{
public:
    TrianglePass(RTHandle shared, bool writes) : m_Shared(std::move(shared))
    {
        profilingSampler = ProfilingSampler("Triangle");
        renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
        m_Material = std::make_shared<Material>(
            test::ShaderWithProgram("", "Texture2D _Shared;", writes ? "1" : "_Shared.Load(0)"));
        if (writes)
        {
            ConfigureTarget(m_Shared);
        }
        else
        {
            m_Material->SetTexture(ShaderPropertyId("_Shared"), m_Shared.rt());
        }
    }

    void Execute(ScriptableRenderContext& context, RenderingData&) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        cmd->DrawMesh(test::Cube(), glm::mat4(1.0f), m_Material);
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    RTHandle m_Shared;
    std::shared_ptr<Material> m_Material;
};

class TriangleFeature final : public ScriptableRendererFeature
{
public:
    TriangleFeature(const RTHandle& shared, bool writes) : m_Pass(shared, writes) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    TrianglePass m_Pass;
};

} // namespace

TEST(PipelinesOfOneDevice, KnowWhatEachOtherDid)
{
    Scene scene;
    const Camera camera;
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = 8;
    request.height = 4;
    RecordingDevice device;
    UniversalRenderPipeline first(device);
    UniversalRenderer writer(test::Compiler());
    const RTHandle shared(test::Target("Shared"));
    writer.AddFeature(std::make_unique<TriangleFeature>(shared, true));
    first.RenderSingleCamera(writer, request);
    UniversalRenderPipeline second(device);
    UniversalRenderer reader(test::Compiler());
    reader.AddFeature(std::make_unique<TriangleFeature>(shared, false));
    const CompiledFrame frame = *second.RenderSingleCamera(reader, request).frame;
    EXPECT_THAT(frame.passes.at(0).barriers,
                testing::Contains(TextureBarrier{shared.rt(), TextureUsage::ColorAttachment,
                                                 TextureUsage::ShaderRead, ShaderStage::Fragment}));
}

} // namespace limn
