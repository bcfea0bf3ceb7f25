#pragma once

#include <limn/core/Judge.h>
#include <limn/core/Scene.h>
#include <limn/shaderlab/ShaderProgram.h>
#include <vector>

namespace limn
{

struct Camera;

/// One (renderer, material) pair that the camera may see.
struct RendererItem
{
    const GameObject* object = nullptr; ///< never null; its renderer is set
    std::shared_ptr<const Material> material;
    int materialIndex = 0; ///< among the renderer's materials
    int subMesh = 0;
    FilterItem filter;
    std::size_t perDraw = 0;      ///< index into CullingResults::perDraw
    glm::dvec3 boundsCenter{0.0}; ///< world
};

/// What culling found. Valid as long as the scene is neither changed nor destroyed.
/// Unity: UnityEngine.Rendering.CullingResults (2022.3).
struct CullingResults
{
    std::vector<RendererItem> items;  ///< scene order
    std::vector<PerDrawData> perDraw; ///< of the visible objects, relative to the camera's
                                      ///< renderOrigin(), whatever the number of draws
    /// Objects, in sight or not, whose world matrix has an infinity or NaN once it is rounded to
    /// float: nothing of them is seen.
    std::vector<const GameObject*> beyondFloat;
    int rendererCount = 0;      ///< enabled renderers of active objects, visible or not
    int outsideFrustum = 0;     ///< of these, how many lie outside the frustum
    int outsideCullingMask = 0; ///< and how many the camera's cullingMask leaves out
};

/// The renderers of active objects in the camera's culling mask whose world bounds touch its
/// frustum. Unity: ScriptableRenderContext.Cull.
/// @param aspect  width / height of the picture
CullingResults Cull(const Scene& scene, const Camera& camera, float aspect);

/// The order in which a DrawRenderers call draws: indices into `items`, stable.
/// @param indices  which items take part, in scene order
void Sort(const std::vector<RendererItem>& items, const SortingSettings& sorting,
          std::vector<int>& indices);

} // namespace limn
