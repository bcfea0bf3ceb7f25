#pragma once

#include <limn/core/ComputeShader.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/NullCheck.h>
#include <limn/core/ProfilingScope.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace porting
{

using namespace limn;

// DistanceOutlineFeature.cs, line by line.
class DistanceOutlineFeature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
        LayerMask layerMask = LayerMask::Nothing();
        std::shared_ptr<const Shader> shader;
        Shared<ComputeShader> computeShader;
        Color color = Color::white;
        int width = 6;
    };

private:
    class OutlinePass final : public ScriptableRenderPass
    {
        static constexpr int k_MaskPass = 0;
        static constexpr int k_CompositePass = 1;
        static constexpr int k_GroupSize = 8;
        static inline const ShaderPropertyId s_Mask = Shader::PropertyToID("_Mask");
        static inline const ShaderPropertyId s_Rows = Shader::PropertyToID("_Rows");
        static inline const ShaderPropertyId s_Distance = Shader::PropertyToID("_Distance");
        static inline const ShaderPropertyId s_Size = Shader::PropertyToID("_Size");

        const Settings* m_Settings;
        std::shared_ptr<Material> m_Material;
        int m_RowsKernel;
        int m_ColumnsKernel;
        FilteringSettings m_FilteringSettings;
        RTHandle m_Mask;
        RTHandle m_Rows;
        RTHandle m_Distance;

    public:
        OutlinePass(const Settings& settings)
        {
            m_Settings = &settings;
            m_Material = CoreUtils::CreateEngineMaterial(settings.shader);
            m_Material->SetColor("_OutlineColor", settings.color);
            m_Material->SetFloat("_OutlineWidth", settings.width);
            m_RowsKernel = settings.computeShader->FindKernel("Rows");
            m_ColumnsKernel = settings.computeShader->FindKernel("Columns");
            m_FilteringSettings = FilteringSettings(RenderQueueRange::all, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
            profilingSampler = ProfilingSampler("Distance Outline");
        }

        void OnCameraSetup([[maybe_unused]] CommandBuffer& cmd,
                           RenderingData& renderingData) override
        {
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.graphicsFormat = GraphicsFormat::R8_UNorm;
            RenderingUtils::ReAllocateIfNeeded(m_Mask, descriptor, FilterMode::Point,
                                               TextureWrapMode::Clamp, "_Mask");
            descriptor.enableRandomWrite = true;
            descriptor.graphicsFormat = GraphicsFormat::R32_SFloat;
            RenderingUtils::ReAllocateIfNeeded(m_Rows, descriptor, FilterMode::Point,
                                               TextureWrapMode::Clamp, "_Rows");
            RenderingUtils::ReAllocateIfNeeded(m_Distance, descriptor, FilterMode::Point,
                                               TextureWrapMode::Clamp, "_Distance");
            ConfigureTarget(m_Mask);
            ConfigureClear(ClearFlag::Color, Color::clear);
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            auto cmd = CommandBufferPool::Get();
            {
                const ProfilingScope scope(*cmd, profilingSampler);
                DrawingSettings drawingSettings = CreateDrawingSettings(
                    ShaderTagId("UniversalForward"), renderingData, SortingCriteria::None);
                drawingSettings.overrideMaterial = m_Material;
                drawingSettings.overrideMaterialPassIndex = k_MaskPass;
                context.DrawRenderers(renderingData.cullResults, drawingSettings,
                                      m_FilteringSettings);

                const Shared<ComputeShader>& compute = m_Settings->computeShader;
                int groupsX = (m_Mask.rt()->width() + k_GroupSize - 1) / k_GroupSize;
                int groupsY = (m_Mask.rt()->height() + k_GroupSize - 1) / k_GroupSize;
                cmd->SetComputeVectorParam(
                    compute, s_Size,
                    Vector4(m_Mask.rt()->width(), m_Mask.rt()->height(), m_Settings->width + 1, 0));
                cmd->SetComputeTextureParam(compute, m_RowsKernel, s_Mask, m_Mask);
                cmd->SetComputeTextureParam(compute, m_RowsKernel, s_Rows, m_Rows);
                cmd->DispatchCompute(compute, m_RowsKernel, groupsX, groupsY, 1);
                cmd->SetComputeTextureParam(compute, m_ColumnsKernel, s_Rows, m_Rows);
                cmd->SetComputeTextureParam(compute, m_ColumnsKernel, s_Distance, m_Distance);
                cmd->DispatchCompute(compute, m_ColumnsKernel, groupsX, groupsY, 1);

                Blitter::BlitCameraTexture(
                    *cmd, m_Distance, renderingData.cameraData.renderer->cameraColorTargetHandle(),
                    m_Material, k_CompositePass);
            }
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }

        void Dispose()
        {
            m_Mask.Release();
            m_Rows.Release();
            m_Distance.Release();
        }
    };

public:
    Settings settings = Settings();

private:
    std::unique_ptr<OutlinePass> m_Pass;

public:
    void Create() override { m_Pass = std::make_unique<OutlinePass>(settings); }

    void AddRenderPasses(ScriptableRenderer& renderer,
                         [[maybe_unused]] RenderingData& renderingData) override
    {
        renderer.EnqueuePass(*m_Pass);
    }

    void Dispose([[maybe_unused]] bool disposing) override { m_Pass->Dispose(); }

    void Describe(Inspector& inspector) override
    {
        inspector.BeginGroup("settings");
        inspector.Field("renderPassEvent", settings.renderPassEvent,
                        "The event at which it is drawn");
        inspector.Field("layerMask", settings.layerMask,
                        "The layers of the objects that are outlined");
        inspector.Field("shader", settings.shader, "Draws the outline from the distances");
        inspector.Field("computeShader", settings.computeShader,
                        "Measures the distances to the objects");
        inspector.Field("color", settings.color, "The colour in sRGB; its alpha is the opacity");
        inspector.Field("width", settings.width, {1, 32}, "Texels");
        inspector.EndGroup();
    }
};

} // namespace porting
