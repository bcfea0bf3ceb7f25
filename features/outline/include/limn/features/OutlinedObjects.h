#pragma once

#include <limn/core/RenderingData.h>
#include <limn/features/OutlineSettings.h>
#include <span>
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
    std::string why; ///< if there are no objects: what happened to the renderers
};

/// Finds the objects that a feature outlines, and adds the filter to RenderReport::filters. An
/// object whose shader has none of URP's forward passes is neither drawn nor outlined.
/// @param found  receives the objects in place of what it has; its memory is used again
/// @throws ContractError as OutlineSettings::filtering
void FindOutlinedObjects(const RenderingData& renderingData, const OutlineSettings& settings,
                         OutlineGrouping grouping, OutlinedObjects& found);

/// Calls `function` with the objects of each group.
/// @param objects  ordered by group
template <typename Function>
void ForEachGroup(std::span<const OutlinedObject> objects, const Function& function)
{
    for (std::size_t first = 0, end = 0; first < objects.size(); first = end)
    {
        while (end < objects.size() && objects[end].group == objects[first].group)
        {
            ++end;
        }
        function(objects.subspan(first, end - first));
    }
}

/// The objects of one group and their depth.
struct OutlinedGroup
{
    std::span<const OutlinedObject> objects;
    double depth = 0.0; ///< of the nearest middle of an object, in metres before the camera
};

/// Finds the groups and orders them, the farthest first.
/// @param groups  receives the groups in place of what it has; its memory is used again
void FindGroupsByDepth(const OutlinedObjects& found, const glm::dmat4& viewMatrix,
                       std::vector<OutlinedGroup>& groups);

} // namespace limn
