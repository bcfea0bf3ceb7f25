#pragma once

#include <array>
#include <limn/core/DrawingSettings.h>
#include <limn/core/FilteringSettings.h>
#include <string>

namespace limn
{

class Material;
class Shader;

/// Why a renderer is drawn or not by one DrawRenderers call. The rules are tried in this order and
/// the first that rejects is named.
enum class FilterVerdict
{
    Drawn,
    QueueOutOfRange,        ///< material's render queue outside FilteringSettings::renderQueueRange
    LayerMaskMiss,          ///< game object's layer not in layerMask
    RenderingLayerMaskMiss, ///< no common bit with renderingLayerMask
    NoMatchingPass          ///< no pass of any of the LightMode tags, or those are off
};
inline constexpr int k_FilterVerdictCount = 5;

/// "layer mask", "render queue" ...: the rule in words.
const char* ToString(FilterVerdict verdict);

/// What filtering looks at of one (renderer, material) pair.
struct FilterItem
{
    int renderQueue = 2000;                   ///< the material's, 0...5000
    int layer = 0;                            ///< the game object's, 0...31
    RenderingLayerMask renderingLayerMask{1}; ///< the renderer's
    const Shader* shader = nullptr;           ///< the material's; never null when judged
    const Material* material = nullptr;       ///< may switch passes off; null = it does not

    bool operator==(const FilterItem&) const = default;
};

/// Queue and masks only: the part of Judge that needs no shader.
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

/// Whether one item is drawn by a DrawRenderers call, and if not, by which rule. Pure; the draw
/// path asks the same function.
FilterVerdict Judge(const FilterItem& item, const FilteringSettings& filtering,
                    const DrawingSettings& drawing);

/// How many items each rule decided.
using FilterCounts = std::array<int, k_FilterVerdictCount>;

/// "0 of 214 renderers drawn: 201 layer mask, 13 render queue", followed by what is suspicious in
/// the filter itself, e.g. "; the filter's layerMask is 0 (Nothing)".
std::string Describe(const FilterCounts& counts, const FilteringSettings& filtering);

} // namespace limn
