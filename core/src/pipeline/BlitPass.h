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
    /// @param materialPass  of `material`, which reads _BlitTexture
    BlitPass(const char* name, RenderPassEvent event, std::shared_ptr<const Material> material,
             int materialPass)
        : m_Material(std::move(material)), m_MaterialPass(materialPass)
    {
        profilingSampler = ProfilingSampler(name);
        renderPassEvent = event;
    }

    void SetTargets(const RTHandle& source, const RTHandle& destination)
    {
        m_Source = source;
        ConfigureTarget(destination);
    }

    void Execute(ScriptableRenderContext& context, RenderingData&) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        Blitter::BlitTexture(*cmd, m_Source, {1.0f, 1.0f, 0.0f, 0.0f}, m_Material, m_MaterialPass);
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    std::shared_ptr<const Material> m_Material;
    int m_MaterialPass;
    RTHandle m_Source;
};

} // namespace limn
