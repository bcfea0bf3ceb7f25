#pragma once

#include <limn/core/Judge.h>
#include <limn/core/RenderPassEvent.h>
#include <string>
#include <vector>

namespace limn
{

/// What became of one DrawRenderers call.
struct DrawRenderersReport
{
    SampleName pass; ///< name of the pass that made it
    FilteringSettings filtering;
    DrawingSettings drawing;
    FilterCounts counts{};
};

struct ExecutedPassReport
{
    SampleName name;
    RenderPassEvent renderPassEvent = RenderPassEvent::BeforeRendering;
};

/// What happened while one camera was rendered: data for people and tests.
struct RenderReport
{
    std::vector<ExecutedPassReport> passes; ///< in the order they ran
    std::vector<DrawRenderersReport> draws; ///< in the order they were made
    std::vector<std::string>
        notes; ///< sentences for the user, each a reason why something is absent
    std::vector<std::string> choices; ///< what features decided by themselves, and why
};

} // namespace limn
