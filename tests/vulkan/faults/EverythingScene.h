#pragma once

#include "CachedCompiler.h"
#include "GpuTestDevice.h"
#include "Paths.h"
#include "features/RecordingFeature.h"
#include "scene/SceneView.h"

#include <limn/core/AsyncGPUReadback.h>
#include <limn/core/CoreUtils.h>

namespace limn::test
{

/// everything.scene.yaml, and what a scene file cannot say: a kernel, mip levels that are
/// generated, a geometry function, an uploaded texture, and copies to the CPU that frames do not
/// wait for.
class EverythingScene
{
public:
    static constexpr int k_Width = 24;
    static constexpr int k_Height = 16;

    EverythingScene() : m_Assets(Options())
    {
        SceneAsset asset =
            LoadScene(SourcePath("tests/vulkan/faults/everything.scene.yaml"), m_Assets);
        asset.renderer.features.push_back(std::make_unique<RecordingFeature>(
            RenderPassEvent::BeforeRenderingTransparents,
            [this](CommandBuffer& cmd, RenderingData& data) { Record(cmd, data); }));
        m_View.emplace(std::move(asset), m_Assets);
        RenderTextureDescriptor descriptor(8, 8, GraphicsFormat::R16G16B16A16_SFloat);
        descriptor.enableRandomWrite = true;
        descriptor.useMipMap = true;
        descriptor.autoGenerateMips = false;
        m_Levels = std::make_shared<RenderTexture>("Levels", descriptor);
        m_Compute->SetTexture(0, "_Levels", m_Levels);
        m_Compute->SetBuffer(0, "_Places", m_Places);
        m_Material = std::make_shared<Material>(
            Shader::FromText(GeometryShader(), "Everything.shader", m_Assets.compiler()));
        m_Material->SetTexture("_Levels", m_Levels);
    }

    /// Draws with a new texture each time, so that what is known of the last one is thrown away.
    /// @param isLast  whether the frame leaves out what only a next one could read
    Image Draw(VulkanDevice& device, UniversalRenderPipeline& pipeline, bool isLast)
    {
        m_Material->SetTexture(
            "_Paint", std::make_shared<Texture2D>("Paint", 2, 2, GraphicsFormat::R8_UNorm,
                                                  std::vector<std::byte>(4, std::byte{200}),
                                                  SamplerState{}, true));
        const RenderResult result = m_View->Render(pipeline, 0.0, isLast);
        report = result.report;
        const RenderTexture& output = *result.output.rt();
        const auto texels = device.BeginReadBack(output);
        const auto places = device.BeginReadBack(*m_Places);
        Image image = device.ReadBack(output);
        for (const auto& copy : {texels, places})
        {
            copy->Finish(true);
            if (copy->hasError())
            {
                throw VulkanError(copy->error());
            }
        }
        EXPECT_EQ(image.texels, FlipRows(texels->result().texels, k_Height));
        return image;
    }

    RenderReport report; ///< of the last frame

private:
    static ShaderCompilerOptions Options()
    {
        ShaderCompilerOptions options = CachedCompiler();
        options.missingFeatures = SharedDevice().missingShaderFeatures();
        return options;
    }

    /// Shows a coarse level of what the kernel wrote in a corner of the picture.
    static std::string GeometryShader()
    {
        return std::string("Shader \"Test/Everything\" { SubShader { Pass { ZTest Always Cull Off\n"
                           "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n") +
               (Lacks("geometry") ? "" : "#pragma geometry G\n") +
               "Texture2D _Levels; SamplerState sampler_Levels;\n"
               "Texture2D _Paint; SamplerState sampler_Paint;\n"
               "struct v2f { float4 pos : SV_POSITION; };\n"
               "v2f V(uint i : SV_VertexID) { v2f o;\n"
               "  o.pos = float4(i == 1 ? 0 : -1, i == 2 ? 0 : -1, 0.5, 1); return o; }\n"
               "[maxvertexcount(3)]\n"
               "void G(triangle v2f v[3], inout TriangleStream<v2f> stream)\n"
               "{ for (int i = 0; i < 3; ++i) { stream.Append(v[i]); } }\n"
               "float4 F() : SV_Target { return _Levels.SampleLevel(sampler_Levels, 0.5, 2)\n"
               "  * _Paint.SampleLevel(sampler_Paint, 0.5, 1).r; }\nENDHLSL } } }";
    }

    void Record(CommandBuffer& cmd, RenderingData& data)
    {
        if (data.cameraData.renderType != CameraRenderType::Base)
        {
            return;
        }
        cmd.DispatchCompute(m_Compute, 0, 1, 1, 1);
        cmd.GenerateMips(m_Levels);
        CoreUtils::SetRenderTarget(cmd, data.cameraData.renderer->cameraColorTargetHandle());
        cmd.DrawProcedural(glm::mat4(1.0f), m_Material, 0, 3);
    }

    AssetContext m_Assets;
    std::shared_ptr<ComputeShader> m_Compute = ComputeShader::FromText(
        "#pragma kernel K\nRWTexture2D<float4> _Levels; RWStructuredBuffer<uint> _Places;\n"
        "[numthreads(8, 8, 1)] void K(uint3 id : SV_DispatchThreadID)\n"
        "{ _Levels[id.xy] = float4(id.xy / 8.0, 1, 1); _Places[id.y * 8 + id.x] = id.x; }\n",
        "Everything.compute", m_Assets.compiler());
    std::shared_ptr<GraphicsBuffer> m_Places =
        std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 64, 4);
    std::shared_ptr<RenderTexture> m_Levels;
    std::shared_ptr<Material> m_Material;
    std::optional<SceneView> m_View;
};

} // namespace limn::test
