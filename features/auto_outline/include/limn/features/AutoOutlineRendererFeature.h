#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <limn/features/AutoOutline.h>
#include <limn/features/OutlineSettings.h>
#include <limn/features/OutlineTechnique.h>
#include <limn/features/OutlinedObjects.h>
#include <memory>

namespace limn
{

class StrokeOutlinePass;
class WideOutlineRenderPass;
class StrokeOutline;
class WideOutline;

struct AutoOutlineSettings : OutlineSettings
{
    OutlineTechnique m_Technique = OutlineTechnique::Auto;
    OutlineGrouping m_Grouping = OutlineGrouping::PerGroup;

    void Describe(Inspector& inspector);
};

/// Draws an outline outside of the objects with the technique that suits them. The frame's report
/// says which one and why (RenderReport::choices).
class AutoOutlineRendererFeature final : public ScriptableRendererFeature
{
public:
    using Component = AutoOutline;
    using Settings = AutoOutlineSettings;

    AutoOutlineRendererFeature();
    explicit AutoOutlineRendererFeature(AutoOutlineSettings settings);
    ~AutoOutlineRendererFeature() override;

    void Create() override;
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    float cullingMargin(const VolumeStackPointer& volumeStack) const override;
    void Describe(Inspector& inspector) override { m_Settings.Describe(inspector); }

    const AutoOutlineSettings& settings() const { return m_Settings; }
    OutlinedObjects m_Found; ///< of this frame, kept for its memory

private:
    // They return why nothing is drawn, or "".
    std::string AddTechnique(const AutoOutline& component, ScriptableRenderer& renderer,
                             RenderingData& renderingData);
    std::string AddWide(ScriptableRenderer& renderer, RenderingData& renderingData,
                        OutlineTechnique technique);
    void MakeStrokes(const ScriptableRenderer& renderer);

    AutoOutlineSettings m_Settings;
    std::unique_ptr<StrokeOutline> m_StrokeValues;
    std::unique_ptr<StrokeOutlinePass> m_Strokes;
    std::unique_ptr<WideOutline> m_WideValues;
    std::unique_ptr<WideOutlineRenderPass> m_Wide[2]; ///< separable, jump flood
};

} // namespace limn
