#pragma once

#include "HeightFogFeature.h"

#include <limn/core/UniversalFrameData.h>

namespace porting
{

// HeightFogUnity6Feature.cs, line by line.
class HeightFogUnity6Feature final : public ScriptableRendererFeature
{
    class HeightFogPass final : public ScriptableRenderPass
    {
        static inline const ShaderPropertyId s_Density = Shader::PropertyToID("_FogDensity");
        static inline const ShaderPropertyId s_BaseHeight = Shader::PropertyToID("_FogBaseHeight");
        static inline const ShaderPropertyId s_Falloff = Shader::PropertyToID("_FogFalloff");
        static inline const ShaderPropertyId s_Color = Shader::PropertyToID("_FogColor");

        std::shared_ptr<Material> m_Material;

    public:
        HeightFogPass(std::shared_ptr<const Shader> shader)
        {
            m_Material = CoreUtils::CreateEngineMaterial(shader);
            renderPassEvent = RenderPassEvent::BeforeRenderingPostProcessing;
            ConfigureInput(ScriptableRenderPassInput::Depth);
        }

        void Setup(const HeightFog* fog)
        {
            m_Material->SetFloat(s_Density, fog->density.value());
            m_Material->SetFloat(s_BaseHeight, fog->baseHeight.value());
            m_Material->SetFloat(s_Falloff, fog->falloff.value());
            m_Material->SetColor(s_Color, fog->color.value());
        }

        void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) override
        {
            UniversalResourceData& resourceData = frameData.Get<UniversalResourceData>();
            if (resourceData.isActiveTargetBackBuffer())
            {
                return;
            }

            TextureHandle source = resourceData.activeColorTexture();
            TextureDesc descriptor = renderGraph.GetTextureDesc(source);
            descriptor.name = "_HeightFogColor";
            descriptor.clearBuffer = false;
            TextureHandle destination = renderGraph.CreateTexture(descriptor);

            RenderGraphUtils::BlitMaterialParameters parameters(source, destination, m_Material, 1);
            renderGraph.AddBlitPass(parameters, "Height Fog");
            resourceData.cameraColor = destination;
        }
    };

public:
    std::shared_ptr<const Shader> shader;

private:
    std::unique_ptr<HeightFogPass> m_Pass;

public:
    void Create() override { m_Pass = std::make_unique<HeightFogPass>(shader); }

    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        const HeightFog* fog = renderingData.volumeStack->GetComponent<HeightFog>();
        if (!fog->IsActive() || !renderingData.cameraData.postProcessEnabled)
        {
            return;
        }
        m_Pass->Setup(fog);
        renderer.EnqueuePass(*m_Pass);
    }

    void Describe(Inspector& inspector) override
    {
        inspector.Field("shader", shader, "Draws the fog over the picture");
    }
};

} // namespace porting
