#pragma once

#include "../../../features/screen_space_ambient_occlusion/src/BlueNoise.h"
#include "../../../features/screen_space_ambient_occlusion/src/ScreenSpaceAmbientOcclusionPass.h"
#include "OcclusionScene.h"

#include <limn/core/CoreUtils.h>

namespace limn::test
{

/// What SSAO.hlsl's fragment function gives, in floats, which do not turn NaN into a number.
class FloatOcclusion final : public ScriptableRendererFeature
{
public:
    /// @param samples  of each pixel; 0 = as many as a shader has without a keyword, 4
    FloatOcclusion(const SsaoSettings& settings, bool isOrthographic, int samples = 0)
        : m_Pass(settings, isOrthographic, samples)
    {
    }
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    class Pass final : public ScriptableRenderPass
    {
    public:
        Pass(const SsaoSettings& settings, bool isOrthographic, int samples) : m_Settings(settings)
        {
            ConfigureInput(ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Normal);
            renderPassEvent = RenderPassEvent::AfterRenderingPrePasses + 1;
            constexpr const char* sources[] = {"_SOURCE_DEPTH_LOW", "_SOURCE_DEPTH_MEDIUM",
                                               "_SOURCE_DEPTH_HIGH"};
            const bool hasNormals = settings.Source == SsaoSource::DepthNormals;
            const std::string source = hasNormals
                                           ? "_SOURCE_DEPTH_NORMALS"
                                           : sources[static_cast<int>(settings.NormalSamples)];
            const std::string include = "#include \"Packages/com.unity.render-pipelines.";
            m_Material = std::make_shared<Material>(ShaderOf(
                "Shader \"Test/Floats\" { SubShader { Pass { ZTest Always ZWrite Off "
                "Cull Off\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment SSAO\n"
                "#define " +
                source + "\n" + (isOrthographic ? "#define _ORTHOGRAPHIC\n" : "") +
                (settings.AOMethod == SsaoMethod::BlueNoise ? "#define _BLUE_NOISE\n" : "") +
                (samples > 0 ? "#define LIMN_SSAO_SAMPLES " + std::to_string(samples)
                             : std::string()) +
                "\n" + include + "universal/ShaderLibrary/Core.hlsl\"\n" + include +
                "core/Runtime/Utilities/Blit.hlsl\"\n" + include +
                "universal/ShaderLibrary/SSAO.hlsl\"\nENDHLSL\n} } }"));
        }
        void OnCameraSetup(CommandBuffer&, RenderingData& data) override
        {
            RenderTextureDescriptor descriptor = data.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.graphicsFormat = GraphicsFormat::R16G16B16A16_SFloat;
            if (m_Settings.Downsample)
            {
                descriptor.width = std::max(descriptor.width / 2, 1);
                descriptor.height = std::max(descriptor.height / 2, 1);
            }
            RenderingUtils::ReAllocateIfNeeded(m_Target, descriptor, FilterMode::Point,
                                               TextureWrapMode::Clamp, "Floats");
        }
        void Execute(ScriptableRenderContext& context, RenderingData& data) override
        {
            const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
            SetSsaoConstants(*cmd, m_Settings, data.cameraData);
            cmd->SetGlobalTexture(Shader::PropertyToID("_BlueNoiseTexture"), BlueNoise());
            CoreUtils::SetRenderTarget(*cmd, m_Target);
            MaterialPropertyBlock properties;
            properties.SetVector(Shader::PropertyToID("_BlitScaleBias"), {1, 1, 0, 0});
            CoreUtils::DrawFullScreen(*cmd, m_Material, properties);
            context.ExecuteCommandBuffer(*cmd);
        }

    private:
        SsaoSettings m_Settings;
        std::shared_ptr<Material> m_Material;
        RTHandle m_Target;
    };
    Pass m_Pass;
};

} // namespace limn::test
