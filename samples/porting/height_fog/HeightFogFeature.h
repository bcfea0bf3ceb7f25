#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/ProfilingScope.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeComponent.h>
#include <limn/volume/VolumeManager.h>

namespace porting
{

using namespace limn;

// HeightFogFeature.cs, line by line.
class HeightFog final : public VolumeComponent, public IPostProcessComponent
{
public:
    ClampedFloatParameter density{this, "density", 0.0f, 0.0f, 1.0f};
    FloatParameter baseHeight{this, "baseHeight", 0.0f};
    MinFloatParameter falloff{this, "falloff", 0.5f, 0.001f};
    ColorParameter color{this, "color", Color::gray};

    bool IsActive() const override { return density.value() > 0.0f; }

    bool IsTileCompatible() const override { return false; }
};

class HeightFogFeature final : public ScriptableRendererFeature
{
    class HeightFogPass final : public ScriptableRenderPass
    {
        static inline const ShaderPropertyId s_Density = Shader::PropertyToID("_FogDensity");
        static inline const ShaderPropertyId s_BaseHeight = Shader::PropertyToID("_FogBaseHeight");
        static inline const ShaderPropertyId s_Falloff = Shader::PropertyToID("_FogFalloff");
        static inline const ShaderPropertyId s_Color = Shader::PropertyToID("_FogColor");

        const ProfilingSampler m_ProfilingSampler = ProfilingSampler("Height Fog");
        std::shared_ptr<Material> m_Material;
        RenderTargetHandle m_Temporary;

    public:
        HeightFogPass(std::shared_ptr<const Shader> shader)
        {
            m_Material = CoreUtils::CreateEngineMaterial(shader);
            m_Temporary.Init("_HeightFogTemporary");
            renderPassEvent = RenderPassEvent::BeforeRenderingPostProcessing;
            ConfigureInput(ScriptableRenderPassInput::Depth);
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            const VolumeStack& stack = *VolumeManager::instance().stack();
            const HeightFog* fog = stack.GetComponent<HeightFog>();
            if (!fog->IsActive() || !renderingData.cameraData.postProcessEnabled)
            {
                return;
            }

            m_Material->SetFloat(s_Density, fog->density.value());
            m_Material->SetFloat(s_BaseHeight, fog->baseHeight.value());
            m_Material->SetFloat(s_Falloff, fog->falloff.value());
            m_Material->SetColor(s_Color, fog->color.value());

            auto cmd = CommandBufferPool::Get();
            {
                const ProfilingScope scope(*cmd, m_ProfilingSampler);
                RenderTextureDescriptor descriptor =
                    renderingData.cameraData.cameraTargetDescriptor;
                descriptor.depthBufferBits = 0;
                descriptor.msaaSamples = 1;
                RenderTargetIdentifier source =
                    renderingData.cameraData.renderer->cameraColorTarget();
                cmd->GetTemporaryRT(m_Temporary.id, descriptor, FilterMode::Point);
                Blit(*cmd, source, m_Temporary.Identifier(), m_Material, 0);
                Blit(*cmd, m_Temporary.Identifier(), source);
                cmd->ReleaseTemporaryRT(m_Temporary.id);
            }
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }
    };

public:
    std::shared_ptr<const Shader> shader;

private:
    std::unique_ptr<HeightFogPass> m_Pass;

public:
    void Create() override { m_Pass = std::make_unique<HeightFogPass>(shader); }

    void AddRenderPasses(ScriptableRenderer& renderer,
                         [[maybe_unused]] RenderingData& renderingData) override
    {
        renderer.EnqueuePass(*m_Pass);
    }

    void Describe(Inspector& inspector) override
    {
        inspector.Field("shader", shader, "Draws the fog over the picture");
    }
};

} // namespace porting
