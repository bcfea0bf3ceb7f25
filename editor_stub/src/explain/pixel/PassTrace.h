#pragma once

#include "explain/pixel/PixelHistory.h"

#include <limn/core/Culling.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <set>

namespace limn
{

/// The parts of a scene that outlive its move into a view, and its frame.
struct TracedScene
{
    std::vector<const GameObject*> objects; ///< all objects of the scene
    Camera camera;
    CullingResults culled;
    RenderResult result;
};

/// The objects that passes of the picture draw, as indices in the scene.
struct TracedObjects
{
    std::set<std::uint32_t> drawn;
    std::set<std::uint32_t> reaching; ///< those of `drawn` that reach the pixel
};

/// Goes through a frame's passes and finds out what each does at one pixel.
/// @param history   has the pixel and the size; receives all that passes do
/// @param progress  as TracePixel
TracedObjects TraceFrame(const TracedScene& scene, const std::shared_ptr<ShaderCompiler>& compiler,
                         VulkanDevice& device, PixelHistory& history,
                         const std::function<void(const std::string&)>& progress);

} // namespace limn
