#pragma once

#include <array>
#include <limn/core/CoreUtils.h>
#include <limn/core/Debug.h>
#include <limn/core/Inspector.h>
#include <limn/core/Mathf.h>
#include <limn/core/ProfilingScope.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace porting
{

using namespace limn;

// InkLinesFeature.cs, line by line.
class InkLinesFeature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::BeforeRenderingTransparents;
        LayerMask layerMask = LayerMask::Everything();
        std::shared_ptr<Material> material;
        Color color = Color::black;
        float angle = 25.0f;
    };

private:
    class InkPass final : public ScriptableRenderPass
    {
        static constexpr int k_SurfacePass = 0;
        static constexpr int k_InkPass = 1;
        static inline const ShaderPropertyId s_Normals = Shader::PropertyToID("_InkNormals");
        static inline const ShaderPropertyId s_Ids = Shader::PropertyToID("_InkIds");
        static inline const ShaderPropertyId s_Depth = Shader::PropertyToID("_InkDepth");
        static inline const ShaderTagId s_ShaderTagId = ShaderTagId("UniversalForward");

        const Settings* m_Settings;
        const ProfilingSampler m_ProfilingSampler = ProfilingSampler("Ink Lines");
        MaterialPropertyBlock m_Properties = MaterialPropertyBlock();
        std::array<RenderTargetIdentifier, 2> m_Targets;
        FilteringSettings m_FilteringSettings;

    public:
        InkPass(const Settings& settings)
        {
            m_Settings = &settings;
            m_FilteringSettings = FilteringSettings(RenderQueueRange::opaque, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
        }

        void Configure(CommandBuffer& cmd,
                       const RenderTextureDescriptor& cameraTextureDescriptor) override
        {
            RenderTextureDescriptor descriptor = cameraTextureDescriptor;
            descriptor.msaaSamples = 1;
            descriptor.depthBufferBits = 0;
            descriptor.graphicsFormat = GraphicsFormat::A2B10G10R10_UNormPack32;
            cmd.GetTemporaryRT(s_Normals, descriptor, FilterMode::Point);
            descriptor.graphicsFormat = GraphicsFormat::R8_UNorm;
            cmd.GetTemporaryRT(s_Ids, descriptor, FilterMode::Point);
            descriptor.SetColorFormat(RenderTextureFormat::Depth);
            descriptor.depthBufferBits = 32;
            cmd.GetTemporaryRT(s_Depth, descriptor, FilterMode::Point);

            m_Targets[0] = s_Normals;
            m_Targets[1] = s_Ids;
            ConfigureTarget(m_Targets, s_Depth);
            ConfigureClear(ClearFlag::All, Color::clear);
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            auto cmd = CommandBufferPool::Get();
            {
                const ProfilingScope scope(*cmd, m_ProfilingSampler);
                context.ExecuteCommandBuffer(*cmd);
                cmd->Clear();

                DrawingSettings drawingSettings = CreateDrawingSettings(
                    s_ShaderTagId, renderingData, SortingCriteria::CommonOpaque);
                drawingSettings.overrideMaterial = m_Settings->material;
                drawingSettings.overrideMaterialPassIndex = k_SurfacePass;
                context.DrawRenderers(renderingData.cullResults, drawingSettings,
                                      m_FilteringSettings);

                CameraData& cameraData = renderingData.cameraData;
                RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
                m_Properties.SetVector("_InkSize",
                                       Vector4(descriptor.width, descriptor.height, 0, 0));
                m_Properties.SetColor("_InkColor", m_Settings->color);
                m_Properties.SetFloat("_InkCosine", Mathf::Cos(m_Settings->angle * Mathf::Deg2Rad));
                cmd->SetRenderTarget(cameraData.renderer->cameraColorTarget());
                cmd->SetViewProjectionMatrices(glm::mat4(1), glm::mat4(1));
                cmd->DrawMesh(RenderingUtils::fullscreenMesh(), glm::mat4(1), m_Settings->material,
                              0, k_InkPass, m_Properties);
                cmd->SetViewProjectionMatrices(cameraData.GetViewMatrix(),
                                               cameraData.GetProjectionMatrix());
            }
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }

        void OnCameraCleanup(CommandBuffer& cmd) override
        {
            cmd.ReleaseTemporaryRT(s_Normals);
            cmd.ReleaseTemporaryRT(s_Ids);
            cmd.ReleaseTemporaryRT(s_Depth);
        }
    };

public:
    Settings settings = Settings();

private:
    std::unique_ptr<InkPass> m_InkPass;

public:
    void Create() override { m_InkPass = std::make_unique<InkPass>(settings); }

    void AddRenderPasses(ScriptableRenderer& renderer,
                         [[maybe_unused]] RenderingData& renderingData) override
    {
        if (settings.material == nullptr)
        {
            Debug::LogWarning("Ink Lines: there is no material.");
            return;
        }
        renderer.EnqueuePass(*m_InkPass);
    }

    void Describe(Inspector& inspector) override
    {
        inspector.BeginGroup("settings");
        inspector.Field("renderPassEvent", settings.renderPassEvent,
                        "The event at which it is drawn");
        inspector.Field("layerMask", settings.layerMask,
                        "The layers of the objects that have lines");
        inspector.Field("material", settings.material, "Draws surfaces, then lines");
        inspector.Field("color", settings.color, "The colour in sRGB; its alpha is the opacity");
        inspector.Field("angle", settings.angle, {1.0f, 90.0f},
                        "The angle between two normals, in degrees, from which on there is a line");
        inspector.EndGroup();
    }
};

} // namespace porting
