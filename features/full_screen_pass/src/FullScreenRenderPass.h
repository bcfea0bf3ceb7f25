#pragma once

#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// The pass of FullScreenPassRendererFeature. Unity: FullScreenRenderPass (URP 14).
class FullScreenRenderPass final : public ScriptableRenderPass
{
public:
    explicit FullScreenRenderPass(const std::string& passName);

    /// @param material  must not be null
    void SetupMembers(std::shared_ptr<const Material> material, int passIndex,
                      bool fetchActiveColor, bool bindDepthStencilAttachment,
                      ScriptableRenderPassInput requirements);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    std::shared_ptr<const Material> m_Material;
    int m_PassIndex = 0;
    bool m_FetchActiveColor = true;
    bool m_BindDepthStencilAttachment = false;
    std::shared_ptr<const Material> m_CopyMaterial;
    RTHandle m_CopiedColor;
};

} // namespace limn
