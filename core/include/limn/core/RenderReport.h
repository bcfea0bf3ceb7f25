#pragma once

#include <limn/core/Judge.h>
#include <limn/core/PooledAllocator.h>
#include <limn/core/RenderPassEvent.h>
#include <string>
#include <vector>

namespace limn
{

/// The verdicts of one filter on the renderers that it was asked about.
struct DrawRenderersReport
{
    SampleName pass; ///< name of the pass that called the filter
    FilteringSettings filtering;
    DrawingSettings drawing;
    FilterCounts counts{};
    std::size_t feature = k_NoFeature; ///< index into RenderReport::features

    static constexpr std::size_t k_NoFeature = static_cast<std::size_t>(-1); ///< the renderer's own
};

/// The part of a renderer feature in a camera's frame.
struct FeatureReport
{
    SampleName name;
    std::size_t passes = 0; ///< number of passes that it added; with none it draws nothing
    /// The index in RenderReport::notes of the first note that it added meanwhile.
    std::size_t firstNote = 0;
    std::size_t noteCount = 0;
};

struct ExecutedPassReport
{
    SampleName name;
    RenderPassEvent renderPassEvent = RenderPassEvent::BeforeRendering;
};

/// The events while one camera was rendered, as data for people and tests.
struct RenderReport
{
    std::vector<ExecutedPassReport> passes; ///< in the order they ran
    std::vector<DrawRenderersReport> draws; ///< DrawRenderers calls, in the order they were made
    /// Filters of features that do not use DrawRenderers to draw what they let through. A feature
    /// adds its own in AddRenderPasses; the renderer fills in `pass`, the feature's name, and
    /// `feature`.
    std::vector<DrawRenderersReport> filters;
    std::vector<FeatureReport> features; ///< in the renderer's order, once per camera of the stack
    /// Sentences for the user, each of which is a reason why something is absent.
    std::vector<std::string> notes;
    std::vector<PooledString> choices; ///< what features decided by themselves, and why
};

} // namespace limn
