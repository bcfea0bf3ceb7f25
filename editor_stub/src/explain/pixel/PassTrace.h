#pragma once

#include "explain/pixel/PixelHistory.h"

#include <limn/core/CompiledFrame.h>
#include <limn/core/RenderReport.h>
#include <limn/core/Shader.h>
#include <set>

namespace limn
{

/// A recorded frame, and what it shows.
struct TracedFrame
{
    const CompiledFrame& frame;
    const RenderReport& report;
    const std::vector<const GameObject*>& objects; ///< all objects of the scene
    std::shared_ptr<const RenderTexture> output;
    std::shared_ptr<ShaderCompiler> compiler;
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
TracedObjects TraceFrame(const TracedFrame& traced, VulkanDevice& device, PixelHistory& history,
                         const std::function<void(const std::string&)>& progress);

} // namespace limn
