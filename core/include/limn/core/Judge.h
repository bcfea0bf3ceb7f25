#pragma once

#include <array>
#include <limn/core/DrawingSettings.h>
#include <limn/core/FilteringSettings.h>
#include <string>

namespace limn
{

class Material;
class Shader;

/// The verdict of one DrawRenderers call on a renderer: why it is drawn or not. The rules are tried
/// in this order, and the first that rejects is named.
enum class FilterVerdict
{
    Drawn,
    QueueOutOfRange,        ///< material's render queue outside FilteringSettings::renderQueueRange
    LayerMaskMiss,          ///< game object's layer not in layerMask
    RenderingLayerMaskMiss, ///< no common bit with renderingLayerMask
    NoMatchingPass          ///< no pass has any of the LightMode tags, or those passes are off
};
inline constexpr int k_FilterVerdictCount = 5;

/// Returns the rule in words: "layer mask", "render queue" ...
const char* ToString(FilterVerdict verdict);

/// The properties of a pair of renderer and material that filtering looks at.
struct FilterItem
{
    int renderQueue = 2000;                   ///< the material's, 0...5000
    int layer = 0;                            ///< the game object's, 0...31
    RenderingLayerMask renderingLayerMask{1}; ///< the renderer's
    const Shader* shader = nullptr;           ///< the material's; never null when judged
    const Material* material = nullptr;       ///< may switch passes off; may be null

    bool operator==(const FilterItem&) const = default;
};

/// Judges queue and masks only: the part of Judge that needs no shader.
constexpr FilterVerdict JudgeMasks(const FilterItem& item, const FilteringSettings& filtering)
{
    if (!filtering.renderQueueRange.Contains(item.renderQueue))
    {
        return FilterVerdict::QueueOutOfRange;
    }
    if (((filtering.layerMask.bits >> item.layer) & 1u) == 0)
    {
        return FilterVerdict::LayerMaskMiss;
    }
    if (!filtering.renderingLayerMask.Intersects(item.renderingLayerMask))
    {
        return FilterVerdict::RenderingLayerMaskMiss;
    }
    return FilterVerdict::Drawn;
}

/// Returns the verdict of a DrawRenderers call on one item: it is drawn, or the first rule that
/// rejects it. It is a pure function; the draw path calls the same one.
FilterVerdict Judge(const FilterItem& item, const FilteringSettings& filtering,
                    const DrawingSettings& drawing);

/// The number of items that each rule decided, by FilterVerdict.
using FilterCounts = std::array<int, k_FilterVerdictCount>;

/// Returns a summary such as "0 of 2 renderers are drawn: the layer mask leaves out 2", followed by
/// what is suspicious in the filter itself, e.g. "; the filter's layerMask is 0 (Nothing)".
std::string Describe(const FilterCounts& counts, const FilteringSettings& filtering);

} // namespace limn
