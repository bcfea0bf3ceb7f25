#pragma once

#include "view/Timeline.h"

#include <filesystem>
#include <limn/core/UniversalRenderPipeline.h>

namespace limn
{

/// What `limn render` measured.
struct RenderMeasurements
{
    std::string device;
    int frames = 1;
    ShaderCompiler::Statistics shaders;
    Timeline
        timeline; ///< spans "load", "compile shaders", "device", "frame", in it "submit", "wait"
    std::vector<PassTiming> gpuPasses; ///< of the last frame
    RenderResult lastFrame;
};

/// Everything as JSON: milliseconds, pixels, counts.
/// @throws AssetError if the file cannot be written
void WriteStats(const std::filesystem::path& path, const RenderMeasurements& measurements);

/// The timeline in the format of chrome://tracing and Perfetto. The device tells durations only, so
/// its passes stand one behind the other from the moment of submission.
/// @throws AssetError if the file cannot be written
void WriteTrace(const std::filesystem::path& path, const RenderMeasurements& measurements);

} // namespace limn
