#pragma once

#include <limn/core/RenderingData.h>
#include <limn/features/OutlineSettings.h>
#include <vector>

namespace limn
{

/// A (renderer, material) pair that is outlined.
struct OutlinedObject
{
    RendererItem item;
    int group = 0; ///< 0...; the objects of one group have one silhouette
};

/// Returns whether a material's alpha cuts holes into its mesh. As for URP's materials, it does
/// with the keyword _ALPHATEST_ON or with a queue of RenderQueue.AlphaTest, 2450 to 2500.
bool IsAlphaTested(const Material& material);

/// The culling results that pass the filter, ordered by group and then in the scene's order.
struct OutlinedObjects
{
    std::vector<OutlinedObject> objects;
    int groupCount = 0;
    std::string why; ///< if there are no objects: what happened to the renderers
};

/// Finds the objects that a feature outlines, and adds the filter to RenderReport::filters. An
/// object whose shader has none of URP's forward passes is neither drawn nor outlined.
/// @param found  receives the objects in place of what it has; its memory is used again
/// @throws ContractError as OutlineSettings::filtering
void FindOutlinedObjects(const RenderingData& renderingData, const OutlineSettings& settings,
                         OutlineGrouping grouping, OutlinedObjects& found);

} // namespace limn
