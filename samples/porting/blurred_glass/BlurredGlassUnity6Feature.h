#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/Mathf.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/UniversalFrameData.h>
#include <limn/core/UniversalRenderer.h>

namespace porting
{

using namespace limn;

// BlurredGlassUnity6Feature.cs, line by line.
class BlurredGlassUnity6Feature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingSkybox;
        std::shared_ptr<const Shader> blurShader;
        int iterations = 4;
        int downsample = 2;
    };

private:
    class BlurPass final : public ScriptableRenderPass
    {
        static constexpr const char* k_PassName = "Blurred Glass";
        static inline const ShaderPropertyId s_Offset = Shader::PropertyToID("_Offset");
        static inline const ShaderPropertyId s_Blurred = Shader::PropertyToID("_GlassBlurTexture");

        const Settings* m_Settings;
        std::shared_ptr<Material> m_Material;

        struct PassData
        {
            TextureHandle source;
            TextureHandle ping;
            TextureHandle pong;
            std::shared_ptr<Material> material;
            int iterations;
        };

    public:
        BlurPass(const Settings& settings)
        {
            m_Settings = &settings;
            m_Material = CoreUtils::CreateEngineMaterial(settings.blurShader);
            renderPassEvent = settings.renderPassEvent;
        }

        static void ExecutePass(PassData& data, UnsafeGraphContext& context)
        {
            CommandBuffer& cmd = CommandBufferHelpers::GetNativeCommandBuffer(context.cmd);
            cmd.SetGlobalFloat(s_Offset, 0.5f);
            Blitter::BlitCameraTexture(cmd, data.source, data.ping, data.material, 1);
            for (int i = 1; i < data.iterations; i++)
            {
                cmd.SetGlobalFloat(s_Offset, 0.5f + static_cast<float>(i));
                TextureHandle from = i % 2 == 1 ? data.ping : data.pong;
                TextureHandle to = i % 2 == 1 ? data.pong : data.ping;
                Blitter::BlitCameraTexture(cmd, from, to, data.material, 1);
            }
        }

        void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) override
        {
            UniversalResourceData& resourceData = frameData.Get<UniversalResourceData>();
            UniversalCameraData& cameraData = frameData.Get<UniversalCameraData>();

            RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
            descriptor.width = Mathf::Max(1, descriptor.width / m_Settings->downsample);
            descriptor.height = Mathf::Max(1, descriptor.height / m_Settings->downsample);
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            TextureHandle ping = UniversalRenderer::CreateRenderGraphTexture(
                renderGraph, descriptor, "_GlassPing", false, FilterMode::Bilinear);
            TextureHandle pong = UniversalRenderer::CreateRenderGraphTexture(
                renderGraph, descriptor, "_GlassPong", false, FilterMode::Bilinear);

            PassData* passData = nullptr;
            auto builder = renderGraph.AddUnsafePass<PassData>(k_PassName, passData);
            passData->source = resourceData.activeColorTexture();
            passData->ping = ping;
            passData->pong = pong;
            passData->material = m_Material;
            passData->iterations = m_Settings->iterations;

            builder.UseTexture(passData->source, AccessFlags::Read);
            builder.UseTexture(passData->ping, AccessFlags::ReadWrite);
            builder.UseTexture(passData->pong, AccessFlags::ReadWrite);
            builder.AllowGlobalStateModification(true);
            builder.SetGlobalTextureAfterPass(m_Settings->iterations % 2 == 1 ? ping : pong,
                                              s_Blurred);
            builder.SetRenderFunc([](PassData& data, UnsafeGraphContext& context)
                                  { ExecutePass(data, context); });
        }
    };

public:
    Settings settings = Settings();

private:
    std::unique_ptr<BlurPass> m_BlurPass;

public:
    void Create() override { m_BlurPass = std::make_unique<BlurPass>(settings); }

    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        if (settings.blurShader == nullptr ||
            renderingData.cameraData.cameraType == CameraType::Preview)
        {
            return;
        }
        renderer.EnqueuePass(*m_BlurPass);
    }

    void Describe(Inspector& inspector) override
    {
        inspector.BeginGroup("settings");
        inspector.Field("renderPassEvent", settings.renderPassEvent,
                        "The event at which it is blurred");
        inspector.Field("blurShader", settings.blurShader, "Blurs the picture");
        inspector.Field("iterations", settings.iterations, {1, 8},
                        "The number of blurs; each reaches farther");
        inspector.Field("downsample", settings.downsample, {1, 4},
                        "The share of the picture's size");
        inspector.EndGroup();
    }
};

} // namespace porting
