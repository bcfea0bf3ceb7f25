#include "report/measure/StudyBench.h"

#include "explain/ExplainedFrame.h"
#include "report/measure/Statistics.h"
#include "report/measure/StudyScene.h"
#include <limn/base/OtherPrograms.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limn/core/Timeline.h>

namespace limn::study
{

namespace
{

/// Bytes of a pixel that is blended once: four read, four written.
constexpr double k_BytesOfAPixel = 8.0;
constexpr int k_WarmUpFrames = 3; // the third repeats what the second recorded
/// Rounds beyond those asked for are drawn while they cost no more time than this.
constexpr std::chrono::seconds k_CheapTime{2};
constexpr int k_MostRounds = 101;

/// A picture that is drawn in turn with others.
struct Contestant
{
    std::unique_ptr<StudyPicture> picture;
    RenderResult result;

    /// Milliseconds of a frame: on the device, and on the CPU up to its submission.
    std::pair<double, double> Draw(VulkanDevice& device)
    {
        Timeline timeline;
        result = picture->Render(&timeline);
        device.Wait();
        double gpuTime = 0.0;
        for (const PassTiming& timing : device.LastFrameTimings())
        {
            gpuTime += timing.milliseconds;
        }
        double cpuTime = 0.0;
        for (const char* phase : {"cull", "record", "compile", "execute"})
        {
            cpuTime += timeline.Total(phase);
        }
        return {gpuTime, cpuTime};
    }
};

void AddMedian(CellResult& result, const std::string& key, const Spread& spread)
{
    result.values[key] = spread.median;
    result.quartiles[key] = {spread.lower, spread.upper};
}

/// Adds what a technique's frames took on the GPU or on the CPU.
/// @param added  the keys' beginning: "gpuAdded" or "cpuAdded"
void AddTimes(CellResult& result, const TimeAdded& time, const std::string& frame,
              const std::string& added)
{
    AddMedian(result, frame, time.frame);
    AddMedian(result, added + "Milliseconds", time.added);
    if (!std::isnan(time.uncertainty))
    {
        result.values[added + "Uncertainty"] = time.uncertainty;
    }
}

/// The times of all frames, in the order in which they were drawn.
struct FrameTimes
{
    std::vector<std::size_t> turns; ///< TurnsOf
    std::vector<double> gpu;        ///< milliseconds
    std::vector<double> cpu;
    double otherPrograms = 0.0; ///< processors that they kept busy
};

/// @param contestants  the first has no outline
/// @param rounds       that are drawn at least; more while they are quick
FrameTimes DrawInTurn(std::span<Contestant> contestants, int rounds, VulkanDevice& device)
{
    const std::size_t techniques = contestants.size() - 1;
    const std::size_t asked = 2 * techniques * static_cast<std::size_t>(rounds) + 1;
    const OtherPrograms others;
    const auto begin = std::chrono::steady_clock::now();
    FrameTimes times;
    for (const std::size_t turn : TurnsOf(techniques, std::max(rounds, k_MostRounds)))
    {
        const auto [gpu, cpu] = contestants[turn].Draw(device);
        times.turns.push_back(turn);
        times.gpu.push_back(gpu);
        times.cpu.push_back(cpu);
        const bool isRoundDone =
            (times.turns.size() - 1) % std::max<std::size_t>(2 * techniques, 1) == 0;
        if (isRoundDone && times.turns.size() >= asked &&
            std::chrono::steady_clock::now() - begin >= k_CheapTime)
        {
            break;
        }
    }
    times.otherPrograms = others.BusyProcessors();
    return times;
}

/// A frame takes this besides time: the bytes that its passes load, store and read, each texture as
/// a whole, and those of its targets.
struct FrameCost
{
    double passes = 0.0;
    double draws = 0.0;
    double targetBytes = 0.0;
    double movedBytes = 0.0;

    explicit FrameCost(const CompiledFrame& frame)
    {
        const ExplainedFrame explained = ExplainFrame(frame);
        const auto sizeOf = [&explained](std::size_t texture)
        {
            return static_cast<double>(explained.textures[texture].bytes);
        };
        passes = static_cast<double>(explained.passes.size());
        for (const ExplainedPass& pass : explained.passes)
        {
            draws += pass.draws;
            for (const ExplainedAttachment& target : pass.targets)
            {
                movedBytes += target.load == "load" ? sizeOf(target.texture) : 0.0;
                movedBytes += target.store != "-" ? sizeOf(target.texture) : 0.0;
            }
            for (const std::size_t texture : pass.reads)
            {
                movedBytes += sizeOf(texture);
            }
        }
        for (const ExplainedTexture& texture : explained.textures)
        {
            targetBytes += texture.isDrawn ? static_cast<double>(texture.bytes) : 0.0;
        }
    }
};

CellResult ResultOf(const CellId& id, const Contestant& with, const Contestant& without)
{
    CellResult result{id};
    const FrameCost outlined(*with.result.frame);
    const FrameCost plain(*without.result.frame);
    result.values = {{"passes", outlined.passes - plain.passes},
                     {"draws", outlined.draws - plain.draws},
                     {"targetBytes", outlined.targetBytes - plain.targetBytes},
                     {"movedBytes", outlined.movedBytes - plain.movedBytes}};
    const RenderReport& report = with.result.report;
    for (const PooledString& choice : report.choices)
    {
        result.notes.emplace_back(choice);
    }
    for (const std::string& note : report.notes)
    {
        if (note.find("not drawn") != std::string::npos)
        {
            result.notes.push_back(note);
        }
    }
    return result;
}

} // namespace

double StudyBench::copyBandwidth()
{
    if (m_CopyBandwidth == 0.0)
    {
        m_CopyBandwidth = m_Device.MeasureCopyBandwidth();
    }
    return m_CopyBandwidth;
}

std::vector<CellResult> StudyBench::MeasureCosts(std::span<const CellId> ids, int rounds)
{
    std::vector<Contestant> contestants(1); // the first has no outline
    SceneAsset plain = MakeSubject(ids.front(), false, m_Scene, m_Assets);
    plain.renderer.features.clear();
    plain.volumes.clear();
    contestants.front().picture =
        std::make_unique<StudyPicture>(std::move(plain), m_Assets, m_Device);
    std::vector<CellId> drawn;
    std::vector<CellResult> results;
    for (const CellId& id : ids)
    {
        if (const std::string why = WhyNotDrawn(id, m_Assets); !why.empty())
        {
            results.push_back({id, {}, {}, {why}, {}});
            continue;
        }
        drawn.push_back(id);
        contestants.emplace_back().picture = Picture(id, false);
    }
    for (Contestant& contestant : contestants)
    {
        for (int i = 0; i < k_WarmUpFrames; ++i)
        {
            contestant.Draw(m_Device);
        }
    }
    const FrameTimes times = DrawInTurn(contestants, rounds, m_Device);
    const TimesInTurn gpuTimes(times.turns, times.gpu);
    const TimesInTurn cpuTimes(times.turns, times.cpu);
    const SceneAsset marked = MakeSubject(ids.front(), false, m_Scene, m_Assets);
    const double pixels = ExactOutlineCoverage(OutlinedSilhouette(marked), {ids.front().width},
                                               marked.width, marked.height, 0)
                              .Sum();
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        CellResult result = ResultOf(drawn[i], contestants[i + 1], contestants.front());
        AddTimes(result, gpuTimes.AddedBy(i + 1), "gpuMilliseconds", "gpuAdded");
        AddTimes(result, cpuTimes.AddedBy(i + 1), "cpuRecordMilliseconds", "cpuAdded");
        result.values["quietMilliseconds"] = gpuTimes.quietTime();
        result.values["busyMilliseconds"] = gpuTimes.busyTime();
        result.values["quietPart"] = gpuTimes.quietPart();
        result.values["otherPrograms"] = times.otherPrograms;
        result.values["floorMilliseconds"] = 1000.0 * k_BytesOfAPixel * pixels / copyBandwidth();
        results.push_back(std::move(result));
    }
    return results;
}

} // namespace limn::study
