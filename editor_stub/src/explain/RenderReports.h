#pragma once

#include <filesystem>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/Allocations.h>
#include <limn/vulkan/VulkanDevice.h>

namespace limn
{

/// The measurements of `limn render`.
struct RenderMeasurements
{
    std::string device;
    int frames = 1;
    ShaderCompiler::Statistics shaders;
    /// The spans "load", "compile shaders", "frame" and "write"; within "load" "device", the time
    /// for which it waits for the device; within a frame "volumes" and those of
    /// RenderRequest::timeline and VulkanDevice::SetTimeline.
    Timeline timeline{[]
                      {
                          return Allocations::soFar.load();
                      }};
    VulkanDeviceStatistics memory;     ///< after the last frame
    std::vector<PassTiming> gpuPasses; ///< of the last frame
    RenderResult lastFrame;
};

/// Writes everything as JSON: milliseconds (of all frames together), pixels, bytes and counts. Heap
/// allocations are given by phase, for all frames together and for the last one alone, or are null
/// if the program does not count them.
/// @throws AssetError if the file cannot be written
void WriteStats(const std::filesystem::path& path, const RenderMeasurements& measurements);

/// Writes the timeline in the format of chrome://tracing and Perfetto. The passes of the last frame
/// are shown beside it at the times of the device's clock. The first one is placed at the moment of
/// submission, since Vulkan does not tell how the device's clock relates to the CPU's.
/// @throws AssetError if the file cannot be written
void WriteTrace(const std::filesystem::path& path, const RenderMeasurements& measurements);

} // namespace limn
