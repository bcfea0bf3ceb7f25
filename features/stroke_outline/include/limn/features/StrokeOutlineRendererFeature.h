#pragma once

#include <limn/features/OutlineRegion.h>
#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/StrokeOutline.h>

namespace limn
{

/// The part of an outline that is drawn. A point is hidden if something else hides the nearest
/// point of the object's silhouette.
enum class OutlineOcclusion
{
    All,       ///< all points, whatever stands in front
    Visible,   ///< points that are not hidden
    Hidden,    ///< hidden
    SeeThrough ///< all points, the hidden ones in m_OccludedColor
};

struct StrokeOutlineSettings : OutlineSettings
{
    OutlineGrouping m_Grouping = OutlineGrouping::PerGroup;
    OutlineOcclusion m_Occlusion = OutlineOcclusion::All;

    void Describe(Inspector& inspector);
};

class SilhouetteFinder;
struct Stroke;
struct StrokeDraws;

/// Draws silhouette edges as strokes on the screen, and their coverage outside of the objects into
/// the camera's colour, for each group on its own. In a pixel the largest coverage counts, or the
/// sum of two that come from opposite sides.
///
/// Textures of the region's size: _StrokeDepth, D32_SFloat, is the group's own device depth, 0
/// where it is not. _StrokeCoverage, R16G16B16A16_SFloat, is the coverage of strokes that come from
/// the left, the top, the right and the bottom. _StrokeEdges.r is by how much the group covers more
/// of the pixel than _StrokeDepth has; it is R16_SFloat, or with occlusion R16G16B16A16_SFloat,
/// whose a is the coverage of strokes that are seen.
class StrokeOutlinePass final : public OutlineTechniquePass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/StrokeOutline";

    StrokeOutlinePass(const std::string& featureName, const StrokeOutlineSettings& settings,
                      std::shared_ptr<const Shader> shader);
    ~StrokeOutlinePass() override;

    /// @return why nothing is drawn, "" if something is
    std::string Setup(const StrokeOutline& volumeComponent, const RenderingData& renderingData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

    /// Returns the number of edges that the last Setup found, for choosing between techniques.
    int edgeCount() const;     ///< silhouette edges
    double strokeArea() const; ///< the area of their strokes in pixels, overlapping ones included

private:
    void DrawGroup(CommandBuffer& cmd, const StrokeDraws& group, const CameraData& camera);
    void DrawOwnDepth(CommandBuffer& cmd, const StrokeDraws& group, const CameraData& camera);

    StrokeOutlineSettings m_Settings;
    std::unique_ptr<SilhouetteFinder> m_Finder;
    std::vector<Stroke> m_Strokes; ///< of one group, kept for its memory
    MaterialPropertyBlock m_Properties;
    std::vector<std::unique_ptr<StrokeDraws>> m_Groups;
};

/// Draws the outline as a geometric shape: all points outside of an object that are no farther away
/// than the width. The coverage of a pixel is the part of it that the shape covers.
/// @source silhouette edges: McGuire, Hughes, "Hardware-Determined Feature Edges" (NPAR 2004)
using StrokeOutlineRendererFeature =
    OutlineRendererFeature<StrokeOutline, StrokeOutlineSettings, StrokeOutlinePass>;

} // namespace limn
