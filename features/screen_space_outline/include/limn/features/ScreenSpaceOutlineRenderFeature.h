#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/Shader.h>
#include <limn/features/OutlineSettings.h>
#include <memory>

namespace limn
{

class OutlineDrawingRenderPass;
class ScreenSpaceOutline;

/// The settings for when, with which shader and around which objects the outline is drawn.
/// @source nscTechArt/URP-Screen-Space-Outline, ScreenSpaceOutlineSettings (Unity 2022.3)
struct ScreenSpaceOutlineSettings
{
    using RenderQueueRange = OutlineRenderQueueRange;

    RenderPassEvent m_RenderPassEvent = RenderPassEvent::AfterRenderingTransparents;
    std::shared_ptr<const Shader> m_ScreenSpaceOutlineShader;

    RenderQueueRange m_RenderQueueRange = RenderQueueRange::Opaque;
    LayerMask m_LayerMask;        ///< Nothing until set, as in Unity
    int m_RenderingLayerMask = 0; ///< an index 0...31, not bits

    void Describe(Inspector& inspector);
};

/// Outlines the objects of one rendering layer on top of the picture.
/// @source nscTechArt/URP-Screen-Space-Outline, ScreenSpaceOutlineRenderFeature (Unity 2022.3)
class ScreenSpaceOutlineRenderFeature final : public ScriptableRendererFeature
{
public:
    using Component = ScreenSpaceOutline;
    using Settings = ScreenSpaceOutlineSettings;

    explicit ScreenSpaceOutlineRenderFeature(ScreenSpaceOutlineSettings settings = {});
    ~ScreenSpaceOutlineRenderFeature() override;

    /// Creates the pass. Without a shader there is no pass, and every frame's report says so.
    /// @throws ContractError if m_RenderingLayerMask is outside 0...31
    void Create() override;
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    void Describe(Inspector& inspector) override { m_Settings.Describe(inspector); }

    const ScreenSpaceOutlineSettings& settings() const { return m_Settings; }

private:
    ScreenSpaceOutlineSettings m_Settings;
    std::unique_ptr<OutlineDrawingRenderPass> mPass;
};

} // namespace limn
