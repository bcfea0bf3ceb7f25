#pragma once

#include <filesystem>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/Allocations.h>
#include <limn/vulkan/VulkanDevice.h>

namespace limn
{

/// What `limn render` measured.
struct RenderMeasurements
{
    std::string device;
    int frames = 1;
    ShaderCompiler::Statistics shaders;
    /// Spans "load", "compile shaders", "device", "frame", "write", in a frame "volumes" and those
    /// of RenderRequest::timeline and VulkanDevice::SetTimeline.
    Timeline timeline{[]
                      {
                          return Allocations::soFar.load();
                      }};
    VulkanDeviceStatistics memory;     ///< after the last frame
    std::vector<PassTiming> gpuPasses; ///< of the last frame
    RenderResult lastFrame;
};

/// Everything as JSON: milliseconds (of all frames together), pixels, bytes, counts; of heap
/// allocations, those of all frames together and of the last one alone, by phase, or null where the
/// program does not count them.
/// @throws AssetError if the file cannot be written
void WriteStats(const std::filesystem::path& path, const RenderMeasurements& measurements);

/// The timeline in the format of chrome://tracing and Perfetto. The passes of the last frame stand
/// beside it as the device's clock tells, the first at the moment of submission, since Vulkan does
/// not say how the device's clock stands to the CPU's.
/// @throws AssetError if the file cannot be written
void WriteTrace(const std::filesystem::path& path, const RenderMeasurements& measurements);

} // namespace limn
