#pragma once

#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/RenderObjects.h>

namespace limn
{

/// The pass of the RenderObjects feature.
/// Unity: UnityEngine.Experimental.Rendering.Universal.RenderObjectsPass (URP 14).
class RenderObjectsPass final : public ScriptableRenderPass
{
public:
    /// @param shaderTags  LightMode names; empty = URP's three
    RenderObjectsPass(const std::string& profilerTag, RenderPassEvent event,
                      const std::vector<std::string>& shaderTags, RenderQueueType renderQueueType,
                      LayerMask layerMask,
                      const RenderObjectsSettings::CustomCameraSettings& cameraSettings);

    std::shared_ptr<const Material> overrideMaterial;
    int overrideMaterialPassIndex = 0;
    std::shared_ptr<const Shader> overrideShader;
    int overrideShaderPassIndex = 0;

    void SetDepthState(bool writeEnabled, CompareFunction function);
    void SetStencilState(int reference, CompareFunction compareFunction, StencilOp passOp,
                         StencilOp failOp, StencilOp zFailOp);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    void NoteUnknownTags(const RenderingData& renderingData) const;
    void SetCamera(CommandBuffer& cmd, const CameraData& cameraData) const;

    RenderQueueType m_RenderQueueType;
    FilteringSettings m_FilteringSettings;
    RenderObjectsSettings::CustomCameraSettings m_CameraSettings;
    std::vector<ShaderTagId> m_ShaderTagIdList;
    /// The user chose the tags, so a name that fits nothing is reported.
    bool m_TagsAreChosen;
    RenderStateBlock m_RenderStateBlock;
};

} // namespace limn
