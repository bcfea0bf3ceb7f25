#include "study/StudyBench.h"

#include "reports/ExplainedFrame.h"
#include "study/StudyScene.h"
#include "study_pages/Numbers.h"

#include <algorithm>
#include <cmath>
#include <limn/core/Timeline.h>

namespace limn::study
{

namespace
{

/// Bytes of a pixel that is blended once: four read, four written.
constexpr double k_BytesOfAPixel = 8.0;
constexpr int k_WarmUpFrames = 3; // the third repeats what the second recorded

/// A picture that is drawn in turn with others, and what its frames took.
struct Contestant
{
    std::unique_ptr<StudyPicture> picture;
    RenderResult result;
    std::vector<double> gpu; ///< milliseconds
    std::vector<double> cpu;
    std::vector<double> gpuAdded; ///< to the frame without an outline just before
    std::vector<double> cpuAdded;

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

void AddMedian(CellResult& result, const std::string& key, const std::vector<double>& values)
{
    const Spread spread = SpreadOf(values);
    result.values[key] = spread.median;
    result.quartiles[key] = {spread.lower, spread.upper};
}

/// Half the interval that holds the median of all frames with about 95 %: the notch of a box plot,
/// of McGill, Tukey and Larsen, "Variations of Box Plots" (1978).
double UncertaintyOfMedian(const std::vector<double>& values)
{
    const Spread spread = SpreadOf(values);
    return 1.57 * (spread.upper - spread.lower) / std::sqrt(static_cast<double>(values.size()));
}

int DrawsOf(const CompiledFrame& frame)
{
    int draws = 0;
    for (const ExplainedPass& pass : ExplainFrame(frame).passes)
    {
        draws += pass.draws;
    }
    return draws;
}

CellResult ResultOf(const CellId& id, const Contestant& with, const Contestant& without)
{
    CellResult result{id, {}, {}, {}, {}};
    AddMedian(result, "gpuMilliseconds", with.gpu);
    AddMedian(result, "gpuAddedMilliseconds", with.gpuAdded);
    result.values["gpuAddedUncertainty"] = UncertaintyOfMedian(with.gpuAdded);
    AddMedian(result, "cpuRecordMilliseconds", with.cpu);
    AddMedian(result, "cpuAddedMilliseconds", with.cpuAdded);
    const CompiledFrame& frame = *with.result.frame;
    const CompiledFrame& plain = *without.result.frame;
    const FrameBytes bytes = BytesOf(frame);
    const FrameBytes plainBytes = BytesOf(plain);
    result.values["passes"] =
        static_cast<double>(frame.passes.size()) - static_cast<double>(plain.passes.size());
    result.values["draws"] = DrawsOf(frame) - DrawsOf(plain);
    result.values["targetBytes"] = bytes.targets - plainBytes.targets;
    result.values["movedBytes"] = bytes.moved - plainBytes.moved;
    const RenderReport& report = with.result.report;
    result.notes.insert(result.notes.end(), report.choices.begin(), report.choices.end());
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

FrameBytes BytesOf(const CompiledFrame& frame)
{
    FrameBytes bytes;
    const ExplainedFrame explained = ExplainFrame(frame);
    const auto sizeOf = [&explained](std::size_t texture)
    {
        return static_cast<double>(explained.textures[texture].bytes);
    };
    for (const ExplainedPass& pass : explained.passes)
    {
        for (const ExplainedAttachment& target : pass.targets)
        {
            bytes.moved += target.load == "load" ? sizeOf(target.texture) : 0.0;
            bytes.moved += target.store != "-" ? sizeOf(target.texture) : 0.0;
        }
        for (const std::size_t texture : pass.reads)
        {
            bytes.moved += sizeOf(texture);
        }
    }
    for (const ExplainedTexture& texture : explained.textures)
    {
        bytes.targets += texture.isDrawn ? static_cast<double>(texture.bytes) : 0.0;
    }
    return bytes;
}

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
        if (const std::string why = WhyNotDrawn(id); !why.empty())
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
    for (int round = 0; round < rounds; ++round)
    {
        for (std::size_t i = 1; i < contestants.size(); ++i)
        {
            const auto [plainGpu, plainCpu] = contestants.front().Draw(m_Device);
            const auto [gpu, cpu] = contestants[i].Draw(m_Device);
            contestants[i].gpu.push_back(gpu);
            contestants[i].cpu.push_back(cpu);
            contestants[i].gpuAdded.push_back(gpu - plainGpu);
            contestants[i].cpuAdded.push_back(cpu - plainCpu);
        }
    }
    const SceneAsset marked = MakeSubject(ids.front(), false, m_Scene, m_Assets);
    const double pixels = ExactOutlineCoverage(OutlinedSilhouette(marked), {ids.front().width},
                                               marked.width, marked.height, 0)
                              .Sum();
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        CellResult result = ResultOf(drawn[i], contestants[i + 1], contestants.front());
        result.values["floorMilliseconds"] = 1000.0 * k_BytesOfAPixel * pixels / copyBandwidth();
        results.push_back(std::move(result));
    }
    return results;
}

} // namespace limn::study
