#pragma once

#include <limn/core/RenderGraph.h>
#include <limn/core/RenderingData.h>

namespace limn
{

/// The camera's textures that limn has, for RecordRenderGraph.
/// Unity: UnityEngine.Rendering.Universal.UniversalResourceData (URP 17).
class UniversalResourceData final : public ContextItem
{
public:
    /// The colour into which later passes draw and of which the picture is made. Another texture of
    /// the camera's size that is assigned here replaces it when RecordRenderGraph returns, so that
    /// nothing need be copied back.
    TextureHandle cameraColor;
    TextureHandle cameraDepth;
    // These are the textures that shaders find under these names at the pass's event; none if
    // nothing makes them by then.
    TextureHandle cameraDepthTexture;
    TextureHandle cameraNormalsTexture;
    TextureHandle cameraOpaqueTexture;
    // These are none in frames without such shadows.
    TextureHandle mainShadowsTexture;
    TextureHandle additionalShadowsTexture; ///< of spot and point lights

    const TextureHandle& activeColorTexture() const { return cameraColor; }
    const TextureHandle& activeDepthTexture() const { return cameraDepth; }
    bool isActiveTargetBackBuffer() const { return false; } ///< features never draw into it

    void Reset() override;
};

/// Unity: UnityEngine.Rendering.Universal.UniversalCameraData (URP 17).
class UniversalCameraData final : public ContextItem, public CameraData
{
public:
    int scaledWidth() const { return cameraTargetDescriptor.width; } ///< texels
    int scaledHeight() const { return cameraTargetDescriptor.height; }

    void Reset() override { static_cast<CameraData&>(*this) = CameraData(); }
};

/// Unity: UnityEngine.Rendering.Universal.UniversalRenderingData (URP 17), and what RenderingData
/// has beyond that.
class UniversalRenderingData final : public ContextItem
{
public:
    const CullingResults& cullResults() const { return m_Data->cullResults; }
    const VolumeStackPointer& volumeStack() const { return m_Data->volumeStack; }
    RenderReport& report() const { return *m_Data->report; }
    double time() const { return m_Data->time; }           ///< seconds
    double deltaTime() const { return m_Data->deltaTime; } ///< seconds since the frame before

    void Set(const RenderingData& data) { m_Data = &data; }
    void Reset() override { m_Data = nullptr; }

private:
    const RenderingData* m_Data = nullptr; ///< not null in RecordRenderGraph
};

/// Unity: UnityEngine.Rendering.Universal.UniversalLightData (URP 17).
class UniversalLightData final : public ContextItem, public LightData
{
public:
    void Reset() override { static_cast<LightData&>(*this) = LightData(); }
};

/// Unity: UnityEngine.Rendering.Universal.UniversalShadowData (URP 17).
class UniversalShadowData final : public ContextItem, public ShadowData
{
public:
    void Reset() override { static_cast<ShadowData&>(*this) = ShadowData(); }
};

namespace RenderingUtils
{

/// Returns drawing settings as ScriptableRenderPass::CreateDrawingSettings does. Unity: the same
/// (URP 17).
DrawingSettings CreateDrawingSettings(std::span<const ShaderTagId> shaderTagIdList,
                                      const UniversalRenderingData& renderingData,
                                      const UniversalCameraData& cameraData,
                                      const UniversalLightData& lightData,
                                      SortingCriteria sortingCriteria);
DrawingSettings CreateDrawingSettings(ShaderTagId shaderTagId,
                                      const UniversalRenderingData& renderingData,
                                      const UniversalCameraData& cameraData,
                                      const UniversalLightData& lightData,
                                      SortingCriteria sortingCriteria);

/// Unity: the same (URP 14).
DrawingSettings CreateDrawingSettings(std::span<const ShaderTagId> shaderTagIdList,
                                      const RenderingData& renderingData,
                                      SortingCriteria sortingCriteria);
DrawingSettings CreateDrawingSettings(ShaderTagId shaderTagId, const RenderingData& renderingData,
                                      SortingCriteria sortingCriteria);

} // namespace RenderingUtils

} // namespace limn
