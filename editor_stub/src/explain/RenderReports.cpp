#include "explain/RenderReports.h"
#include "console/Json.h"
#include "console/Texts.h"
#include "explain/ExplainedFrame.h"

#include <limn/base/WriteFile.h>

#include <algorithm>
#include <limits>

namespace limn
{

namespace
{

/// Keys of the phases with the names of their spans.
constexpr std::pair<const char*, const char*> k_Phases[] = {
    {"load", "load"},       {"compileShaders", "compile shaders"},
    {"device", "device"},   {"frame", "frame"},
    {"volumes", "volumes"}, {"cull", "cull"},
    {"record", "record"},   {"compile", "compile"},
    {"execute", "execute"}, {"waitForSlot", "wait for a slot"},
    {"prepare", "prepare"}, {"recordCommands", "record commands"},
    {"submit", "submit"},   {"wait", "wait"},
    {"write", "write"}};

Json CpuTimes(const Timeline& timeline)
{
    Json times = Json::object();
    for (const auto& [key, span] : k_Phases)
    {
        times[key] = timeline.Total(span);
    }
    return times;
}

/// Returns the allocations of each phase, of all frames together or of the last one alone; the last
/// one has only the phases of a frame.
Json AllocationCounts(const Timeline& timeline, bool ofLastFrame)
{
    if (!Allocations::areCounted)
    {
        return nullptr;
    }
    const std::vector<Timeline::Span>& spans = timeline.spans();
    const auto frame = std::find_if(spans.rbegin(), spans.rend(),
                                    [](const auto& span) { return span.name == "frame"; });
    const double begin = ofLastFrame && frame != spans.rend() ? frame->start : 0.0;
    const double end = ofLastFrame && frame != spans.rend() ? frame->start + frame->duration
                                                            : std::numeric_limits<double>::max();
    Json counts = Json::object();
    for (const auto& [key, name] : k_Phases)
    {
        for (const Timeline::Span& span : spans)
        {
            if (span.name == name && span.start >= begin && span.start + span.duration <= end)
            {
                counts[key] = counts.value(key, std::uint64_t{0}) + span.allocations;
            }
        }
    }
    return counts;
}

/// Returns the counts of draws and the memory of the last frame.
Json FrameCounts(const RenderMeasurements& measurements)
{
    const CompiledFrame& frame = *measurements.lastFrame.frame;
    const ExplainedFrame explained = ExplainFrame(frame);
    int draws = 0;
    int instances = 0;
    for (const ExplainedPass& pass : explained.passes)
    {
        draws += pass.draws;
        instances += pass.instances;
    }
    std::uint64_t drawnTextures = 0;
    for (const ExplainedTexture& texture : explained.textures)
    {
        drawnTextures += texture.isDrawn ? texture.bytes : 0;
    }
    return {{"passes", frame.passes.size()},
            {"leftOut", frame.leftOut.size()},
            {"drawsBeforeInstancing", instances},
            {"draws", draws},
            {"allocations", AllocationCounts(measurements.timeline, true)},
            {"bytes",
             {{"texturesDrawnInto", drawnTextures},
              {"uniforms", frame.uniformData.size()},
              {"perDraw", frame.perDraw.size() * sizeof(PerDrawData) +
                              frame.instances.size() * sizeof(std::uint32_t)},
              {"deviceInUse", measurements.memory.usedBytes},
              {"deviceAllocated", measurements.memory.allocatedBytes}}}};
}

/// Adds the device's time for a pass of a feature. It may consist of several compiled passes; if a
/// compiled pass has other parts, too, its time is that of all of them.
void AddGpuTime(const std::string& pass, const RenderMeasurements& measurements, Json& result)
{
    const std::vector<CompiledRenderPass>& compiled = measurements.lastFrame.frame->passes;
    Json total = nullptr;
    Json shared = Json::array();
    for (std::size_t i = 0; i < std::min(compiled.size(), measurements.gpuPasses.size()); ++i)
    {
        const std::vector<std::string> names = compiled[i].SampleNames();
        const PassTiming& timing = measurements.gpuPasses[i];
        if (names.size() == 1 && names[0] == pass)
        {
            total = (total.is_null() ? 0.0 : total.get<double>()) + timing.milliseconds;
        }
        else if (std::ranges::find(names, pass) != names.end())
        {
            shared.push_back(timing.name);
        }
    }
    result["gpuMilliseconds"] = std::move(total);
    result["partOf"] = std::move(shared);
}

Json FilterCountsJson(const DrawRenderersReport& draw)
{
    Json counts = Json::object();
    for (std::size_t i = 0; i < draw.counts.size(); ++i)
    {
        counts[ToString(static_cast<FilterVerdict>(i))] = draw.counts[i];
    }
    return {{"pass", draw.pass.name()}, {"counts", std::move(counts)}};
}

/// The textures that passes draw into, once each.
Json Attachments(const CompiledFrame& frame)
{
    std::vector<Json> attachments;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        for (const auto& texture : TargetTextures(pass))
        {
            AddOnce(Json{{"name", texture->name()},
                         {"width", texture->width()},
                         {"height", texture->height()},
                         {"format", ToString(texture->graphicsFormat())}},
                    attachments);
        }
    }
    return attachments;
}

/// A complete event; times in microseconds, as the format has them.
Json TraceEvent(const std::string& name, int thread, double start, double duration)
{
    return {{"name", name}, {"ph", "X"},    {"ts", start * 1000.0}, {"dur", duration * 1000.0},
            {"pid", 1},     {"tid", thread}};
}

Json ThreadName(const char* name, int thread)
{
    return {{"name", "thread_name"},
            {"ph", "M"},
            {"pid", 1},
            {"tid", thread},
            {"args", {{"name", name}}}};
}

} // namespace

void WriteStats(const std::filesystem::path& path, const RenderMeasurements& measurements)
{
    const RenderResult& frame = measurements.lastFrame;
    const RenderTexture& output = *frame.output.rt();
    const auto passJson = [&](const ExecutedPassReport& pass)
    {
        Json json{{"name", pass.name.name()}, {"event", static_cast<int>(pass.renderPassEvent)}};
        AddGpuTime(pass.name.name(), measurements, json);
        return json;
    };
    const auto timingJson = [](const PassTiming& timing) -> Json
    {
        return {{"name", timing.name}, {"milliseconds", timing.milliseconds}};
    };
    const Json stats{{"device", measurements.device},
                     {"width", output.width()},
                     {"height", output.height()},
                     {"frames", measurements.frames},
                     {"cpuMilliseconds", CpuTimes(measurements.timeline)},
                     {"allocations", AllocationCounts(measurements.timeline, false)},
                     {"lastFrame", FrameCounts(measurements)},
                     {"shaderPasses",
                      {{"compiled", measurements.shaders.compiled},
                       {"loadedFromCache", measurements.shaders.loadedFromCache}}},
                     {"passes", JsonList(frame.report.passes, passJson)},
                     {"gpuPasses", JsonList(measurements.gpuPasses, timingJson)},
                     {"drawRenderers", JsonList(frame.report.draws, FilterCountsJson)},
                     {"attachments", Attachments(*frame.frame)},
                     {"notes", frame.report.notes}};
    WriteFile(path, JsonText(stats));
}

void WriteTrace(const std::filesystem::path& path, const RenderMeasurements& measurements)
{
    constexpr int k_Cpu = 1;
    constexpr int k_Gpu = 2;
    Json events = Json::array({ThreadName("CPU", k_Cpu), ThreadName("GPU", k_Gpu)});
    double gpuStart = 0.0;
    for (const Timeline::Span& span : measurements.timeline.spans())
    {
        events.push_back(TraceEvent(span.name, k_Cpu, span.start, span.duration));
        gpuStart = span.name == "submit" ? span.start : gpuStart;
    }
    for (const PassTiming& timing : measurements.gpuPasses)
    {
        events.push_back(
            TraceEvent(timing.name, k_Gpu, gpuStart + timing.start, timing.milliseconds));
    }
    WriteFile(path, JsonText({{"displayTimeUnit", "ms"}, {"traceEvents", std::move(events)}}));
}

} // namespace limn
