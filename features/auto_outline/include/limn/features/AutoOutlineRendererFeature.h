#pragma once

#include <limn/core/PooledAllocator.h>
#include <limn/features/AutoOutline.h>
#include <limn/features/StrokeOutlineRendererFeature.h>
#include <limn/features/WideOutlineRendererFeature.h>

namespace limn
{

/// A way to draw outlines of a given width.
enum class OutlineTechnique
{
    Auto,      ///< the cheapest of those that are right for the objects
    Strokes,   ///< StrokeOutlinePass
    Separable, ///< WideOutlineRenderPass, two passes that look as far as the width
    JumpFlood  ///< WideOutlineRenderPass, a pass for each doubling of the width
};

const char* ToString(OutlineTechnique technique);

/// The data by which a technique is chosen.
struct OutlineWork
{
    double width = 0.0; ///< pixels
    int edgeCount = 0;  ///< silhouette edges that are drawn
    /// The area of their strokes, in pixels; pixels that several strokes cover are counted several
    /// times.
    double strokeArea = 0.0;
    double regionArea = 0.0;    ///< pixels that the outline can touch, of all groups
    bool isAlphaTested = false; ///< a material cuts holes that the mesh does not have
};

struct OutlineChoice
{
    OutlineTechnique technique = OutlineTechnique::Strokes; ///< not Auto
    PooledString why;                                       ///< for people
};

/// Chooses strokes if the mesh defines the silhouette and they do not cost several times as much as
/// a distance transform, which is less exact. Otherwise chooses the cheaper one of the two
/// transforms.
OutlineChoice ChooseOutlineTechnique(const OutlineWork& work);

struct AutoOutlineSettings : OutlineSettings
{
    OutlineTechnique m_Technique = OutlineTechnique::Auto;
    OutlineGrouping m_Grouping = OutlineGrouping::PerGroup;

    void Describe(Inspector& inspector);
};

/// Draws an outline outside of the objects with the technique that suits them. The frame's report
/// says which one and why (RenderReport::choices).
class AutoOutlineRendererFeature final
    : public OutlineTechniqueFeature<AutoOutline, AutoOutlineSettings>
{
public:
    using OutlineTechniqueFeature::OutlineTechniqueFeature;

    void Create() override;
    OutlinedObjects m_Found; ///< of this frame, kept for its memory

private:
    // They return why nothing is drawn, or "".
    std::string AddTechnique(const AutoOutline& component, ScriptableRenderer& renderer,
                             RenderingData& renderingData) override;
    std::string AddWide(ScriptableRenderer& renderer, RenderingData& renderingData,
                        OutlineTechnique technique);
    void MakeStrokes(const ScriptableRenderer& renderer);

    StrokeOutline m_StrokeValues;
    std::unique_ptr<StrokeOutlinePass> m_Strokes;
    WideOutline m_WideValues;
    std::unique_ptr<WideOutlineRenderPass> m_Wide[2]; ///< separable, jump flood
};

} // namespace limn
