#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Draws one texture over the whole of another. Unity: FinalBlitPass, CopyDepthPass and
/// CopyColorPass of UnityEngine.Rendering.Universal.Internal (URP 14).
class BlitPass final : public ScriptableRenderPass
{
public:
    /// @param materialPass  the pass of `material`, which reads _BlitTexture
    BlitPass(const char* name, RenderPassEvent event, std::shared_ptr<const Material> material,
             int materialPass)
        : m_Material(std::move(material)), m_MaterialPass(materialPass)
    {
        profilingSampler = ProfilingSampler(name);
        renderPassEvent = event;
    }

    /// @param scaleBias  of the source's uv
    void SetMaterialPass(int materialPass, const glm::vec4& scaleBias)
    {
        m_MaterialPass = materialPass;
        m_ScaleBias = scaleBias;
    }

    /// @param depth  what the material reads as _CameraDepthTexture; none = the texture of all
    ///     draws
    void SetTargets(const RTHandle& source, const RTHandle& destination, const RTHandle& depth = {})
    {
        m_Source = source;
        m_Depth = depth;
        ConfigureTarget(destination);
    }

    void Execute(ScriptableRenderContext& context, RenderingData&) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        if (m_Depth)
        {
            cmd->SetGlobalTexture(ShaderPropertyId("_CameraDepthTexture"), m_Depth);
        }
        Blitter::BlitTexture(*cmd, m_Source, m_ScaleBias, m_Material, m_MaterialPass);
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    std::shared_ptr<const Material> m_Material;
    int m_MaterialPass;
    glm::vec4 m_ScaleBias{1.0f, 1.0f, 0.0f, 0.0f};
    RTHandle m_Source;
    RTHandle m_Depth;
};

} // namespace limn
