#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/Mathf.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace porting
{

using namespace limn;

// BlurredGlassFeature.cs, line by line.
class BlurredGlassFeature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingSkybox;
        std::shared_ptr<const Shader> blurShader = nullptr;
        int iterations = 4;
        int downsample = 2;
    };

private:
    class BlurPass final : public ScriptableRenderPass
    {
        static constexpr const char* k_Tag = "Blurred Glass";
        static inline const ShaderPropertyId s_Offset = Shader::PropertyToID("_Offset");
        static inline const ShaderPropertyId s_Blurred = Shader::PropertyToID("_GlassBlurTexture");

        const Settings* m_Settings;
        std::shared_ptr<Material> m_Material;
        RenderTargetIdentifier m_Source;
        RenderTargetHandle m_Ping;
        RenderTargetHandle m_Pong;

    public:
        BlurPass(const Settings& settings)
        {
            m_Settings = &settings;
            m_Material = CoreUtils::CreateEngineMaterial(settings.blurShader);
            renderPassEvent = settings.renderPassEvent;
            m_Ping.Init("_GlassPing");
            m_Pong.Init("_GlassPong");
        }

        void Setup(RenderTargetIdentifier source) { m_Source = source; }

        void Configure(CommandBuffer& cmd,
                       const RenderTextureDescriptor& cameraTextureDescriptor) override
        {
            RenderTextureDescriptor descriptor = cameraTextureDescriptor;
            descriptor.width = Mathf::Max(1, descriptor.width / m_Settings->downsample);
            descriptor.height = Mathf::Max(1, descriptor.height / m_Settings->downsample);
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            cmd.GetTemporaryRT(m_Ping.id, descriptor, FilterMode::Bilinear);
            cmd.GetTemporaryRT(m_Pong.id, descriptor, FilterMode::Bilinear);
        }

        void Execute(ScriptableRenderContext& context,
                     [[maybe_unused]] RenderingData& renderingData) override
        {
            auto cmd = CommandBufferPool::Get(k_Tag);
            cmd->SetGlobalFloat(s_Offset, 0.5f);
            cmd->Blit(m_Source, m_Ping.Identifier(), m_Material, 0);
            for (int i = 1; i < m_Settings->iterations; i++)
            {
                cmd->SetGlobalFloat(s_Offset, 0.5f + static_cast<float>(i));
                cmd->Blit(m_Ping.Identifier(), m_Pong.Identifier(), m_Material, 0);
                CoreUtils::Swap(m_Ping, m_Pong);
            }
            cmd->SetGlobalTexture(s_Blurred, m_Ping.Identifier());
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }

        void FrameCleanup(CommandBuffer& cmd) override
        {
            cmd.ReleaseTemporaryRT(m_Ping.id);
            cmd.ReleaseTemporaryRT(m_Pong.id);
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
        m_BlurPass->Setup(renderer.cameraColorTarget());
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
