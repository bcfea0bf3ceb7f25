#include "report/measure/StudyBench.h"

#include "explain/ExplainedFrame.h"
#include "report/measure/Statistics.h"
#include "report/truth/twins/Twins.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limn/base/OtherPrograms.h>
#include <limn/base/TerminalText.h>
#include <limn/core/Timeline.h>
#include <numeric>

namespace limn::study
{

namespace
{

/// "Wall stands", "Wall and Door stand", "Wall, Door, Lamp and 3 more stand".
std::string TheyStand(const std::vector<std::string>& names)
{
    constexpr std::size_t k_Named = 3;
    std::string text = OneLine(names.front());
    for (std::size_t i = 1; i < std::min(names.size(), k_Named); ++i)
    {
        text += (i + 1 == names.size() ? " and " : ", ") + OneLine(names[i]);
    }
    if (names.size() > k_Named)
    {
        text += " and " + std::to_string(names.size() - k_Named) + " more";
    }
    return text + (names.size() == 1 ? " stands" : " stand");
}

/// The picture that a cell is held to.
struct HeldTo
{
    Coverage coverage;
    bool isWhole = true; ///< not only a part of the outline
    std::string note;    ///< says which part; "" where nothing stands in front
};

constexpr int k_Steps = 16; ///< of a sixteenth of a pixel each
const glm::dvec2 k_Motion(1.0, 0.3);

std::string NameOfReference(CellId id)
{
    id.kind = CellKind::Geometry;
    id.variant = id.subject == k_SceneSubject ? "" : id.variant; // the parts share what they are of
    return id.NameForAllTechniques();
}

/// Why it is not drawn at its width; "" if it is.
std::string WhyNotDrawn(const CellId& id, const AssetContext& assets)
{
    const double widest = RequireTechnique(assets, id.technique).widestOutline;
    return id.width > widest ? "not drawn: it is " + std::to_string(static_cast<int>(widest)) +
                                   " pixels wide at most"
                             : std::string();
}

/// Why it is drawn, but not compared; "" if it is.
std::string WhyNotCompared(const CellId& id, const AssetContext& assets)
{
    const std::string& why = RequireTechnique(assets, id.technique).noWidth;
    return why.empty() ? why : "not compared: " + why;
}

void AddScores(const Coverage& alpha, const Coverage& exact, double width, CellResult& result)
{
    // The outline in the picture, not beyond: where nothing can be drawn nothing is missing.
    const double perimeter = width > 0.0 ? exact.Sum() / width : 0.0;
    const OutlineScore score = ScoreOutline(alpha, exact, perimeter);
    result.values = {{"meanAbsoluteError", score.meanAbsoluteError},
                     {"rootMeanSquare", score.rootMeanSquare},
                     {"percentile99", score.percentile99},
                     {"largest", score.largest},
                     {"intersectionOverUnion", score.intersectionOverUnion},
                     {"areaRatio", score.areaRatio},
                     {"effectiveWidth", score.effectiveWidth},
                     {"hausdorff", HausdorffDistance(alpha, exact)},
                     {"bandPixels", static_cast<double>(score.bandPixels)},
                     {"outOfRange", static_cast<double>(score.badValues)}};
}

/// Adds how far the ends of the line are off; a whole outline has no others.
void AddContours(const Coverage& alpha, const Silhouette& silhouette, double width,
                 CellResult& result)
{
    const ContourScores contours = ScoreContours(alpha, silhouette, {width});
    if (contours.high.crossings == 0)
    {
        result.notes.push_back("nowhere as opaque as one half: it has no contour");
        return;
    }
    result.values["effectiveWidthSpread"] = contours.high.spread;
    result.values["contourInner"] = contours.low.mean;
    result.values["contourOuter"] = contours.high.mean;
}

double MeanOf(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double DeviationOf(const std::vector<double>& values)
{
    const double mean = MeanOf(values);
    const double squares = std::accumulate(values.begin(), values.end(), 0.0,
                                           [mean](double sum, double value)
                                           { return sum + (value - mean) * (value - mean); });
    return std::sqrt(squares / static_cast<double>(values.size()));
}

std::map<std::string, double> DifferenceOf(const Coverage& drawn, const Coverage& other)
{
    const OutlineScore score = ScoreOutline(drawn, other);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < drawn.values.size(); ++i)
    {
        differing += std::abs(drawn.values[i] - other.values[i]) > 1.0 / 255.0 ? 1u : 0u;
    }
    const double pixels = std::max(static_cast<double>(score.bandPixels), 1.0);
    return {{"numericalMean", score.meanAbsoluteError},
            {"numericalPercentile99", score.percentile99},
            {"numericalLargest", score.largest},
            {"numericalDiffering", static_cast<double>(differing) / pixels}};
}

/// Returns the number of places that a device has for a corner along a pixel's side.
double CornerGrid(const VulkanDevice& device)
{
    const std::vector<VulkanDeviceInfo> devices = EnumerateVulkanDevices();
    const auto found = std::ranges::find(devices, device.deviceName(), &VulkanDeviceInfo::name);
    if (found == devices.end())
    {
        throw ContractError("no Vulkan device is called " + device.deviceName() + " any more");
    }
    return std::exp2(found->subPixelPrecisionBits);
}

/// Repeats what the device does, which puts corners at the nearest place that it has, and whose
/// targets have the bottom row of the picture first: the shapes are turned over before, and the
/// picture back again.
/// @param grid  how many places a pixel's side has for a corner
Coverage DrawTwin(const Twin& twin, const CellId& id, double grid)
{
    // Strokes takes its edges from the mesh, not from a drawing of the objects.
    const bool hasRoundedCorners = id.technique != "Strokes";
    ScreenTriangles triangles = ShapeTriangles(id.subject, id.pictureWidth, id.pictureHeight);
    for (auto& triangle : triangles)
    {
        for (glm::dvec2& corner : triangle)
        {
            corner.y = id.pictureHeight - corner.y;
            corner = hasRoundedCorners ? glm::round(corner * grid) / grid : corner;
        }
    }
    Coverage picture = twin(Silhouette(triangles), id.width, id.pictureWidth, id.pictureHeight);
    for (int row = 0; row < picture.height / 2; ++row)
    {
        double* const upper = &picture.At(0, row);
        std::swap_ranges(upper, upper + picture.width, &picture.At(0, picture.height - 1 - row));
    }
    return picture;
}

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

/// Returns what a frame takes besides time: the bytes that its passes load, store and read, each
/// texture as a whole, and those of its targets.
std::map<std::string, double> CostOf(const CompiledFrame& frame)
{
    const ExplainedFrame explained = ExplainFrame(frame);
    const auto sizeOf = [&explained](std::size_t texture)
    {
        return static_cast<double>(explained.textures[texture].bytes);
    };
    double draws = 0.0;
    double targetBytes = 0.0;
    double movedBytes = 0.0;
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
    return {{"passes", static_cast<double>(explained.passes.size())},
            {"draws", draws},
            {"targetBytes", targetBytes},
            {"movedBytes", movedBytes}};
}

CellResult ResultOf(const CellId& id, const Contestant& with, const Contestant& without)
{
    CellResult result{id, CostOf(*with.result.frame)};
    for (const auto& [key, plain] : CostOf(*without.result.frame))
    {
        result.values[key] -= plain;
    }
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

/// The reference with which the outlines of one subject and width are compared.
struct StudyBench::Reference
{
    std::string name; ///< of the cell, without its technique and its variant
    Silhouette silhouette;
    Coverage whole; ///< whatever stands in front
    SceneSurfaces surfaces;
    std::map<HiddenAt, SeenOutline> seen; ///< those that were asked for
    std::vector<std::string> notes;       ///< what every cell of the subject must say

    HeldTo Of(const CellId& id, const Technique& technique)
    {
        const HiddenAt where = technique.hiddenAt.value_or(HiddenAt::Border);
        const auto [found, isNew] = seen.try_emplace(where);
        SeenOutline& outline = found->second;
        if (isNew)
        {
            outline = SeenOutlineCoverage(whole, silhouette, id.width, surfaces.outlined,
                                          surfaces.others, where);
        }
        std::vector<std::string> names;
        for (const std::size_t owner : outline.hiding)
        {
            names.push_back(surfaces.names[owner]);
        }
        const std::string they = names.empty() ? "nothing stands" : TheyStand(names);
        if (id.variant == k_HiddenPart)
        {
            Coverage hidden = whole;
            std::ranges::transform(hidden.values, outline.seen.values, hidden.values.begin(),
                                   std::minus());
            return {hidden, false,
                    "measured against the hidden part of the outline: " + they + " in front of it"};
        }
        if (names.empty())
        {
            return {whole, true, ""};
        }
        if (id.variant == k_SeenPart || technique.hiddenAt)
        {
            return {outline.seen, false,
                    "measured against the visible part of the outline: " + they +
                        " in front of the rest"};
        }
        return {whole, true,
                "measured against the whole outline, also where " + they + " in front of it"};
    }
};

StudyBench::StudyBench(std::filesystem::path scene, std::filesystem::path folder,
                       AssetContext& assets, VulkanDevice& device)
    : m_Scene(std::move(scene)), m_Folder(std::move(folder)), m_Assets(assets), m_Device(device)
{
}

StudyBench::~StudyBench() = default;

std::unique_ptr<StudyPicture> StudyBench::Picture(const CellId& id, bool isBlack)
{
    SceneAsset asset = MakeSubject(id, isBlack, m_Scene, m_Assets);
    Technique technique = RequireTechnique(m_Assets, id.technique);
    if (id.variant == k_SeenPart || id.variant == k_HiddenPart)
    {
        technique.settings.push_back(technique.occlusion +
                                     (id.variant == k_SeenPart ? "=Visible" : "=Hidden"));
    }
    UseTechnique(asset, technique, id.width, m_Assets);
    return std::make_unique<StudyPicture>(std::move(asset), m_Assets, m_Device);
}

StudyBench::Reference& StudyBench::ReferenceOf(const CellId& id)
{
    const std::string name = NameOfReference(id);
    if (!m_Reference || m_Reference->name != name)
    {
        SceneAsset asset = MakeSubject(id, false, m_Scene, m_Assets);
        std::vector<std::string> notes;
        if (const std::size_t overlays = asset.camera.cameraStack.size(); overlays > 0)
        {
            notes.push_back("only the base camera is measured: what the " +
                            (overlays == 1 ? std::string("overlay camera")
                                           : std::to_string(overlays) + " overlay cameras") +
                            " of its cameraStack " + (overlays == 1 ? "draws" : "draw") +
                            " counts for the times and not for the errors");
        }
        MakeBlack(asset, m_Assets);
        Silhouette silhouette = OutlinedSilhouette(asset);
        Coverage whole = ExactOutlineCoverage(silhouette, {id.width}, asset.width, asset.height);
        m_Reference = std::make_unique<Reference>(
            Reference{name, std::move(silhouette), std::move(whole), SurfacesOf(asset), {}, notes});
    }
    return *m_Reference;
}

CellResult StudyBench::Measure(const CellId& id)
{
    if (const std::string why = WhyNotDrawn(id, m_Assets); !why.empty())
    {
        return {id, {}, {}, {why}};
    }
    switch (id.kind)
    {
    case CellKind::Geometry:
        return MeasureGeometry(id);
    case CellKind::Numerical:
        return MeasureNumerical(id);
    case CellKind::Temporal:
        return MeasureTemporal(id);
    default:
        throw ContractError(id.Name() + ": cells of this kind are not measured one by one");
    }
}

CellResult StudyBench::MeasureGeometry(const CellId& id)
{
    CellResult result{id};
    const std::unique_ptr<StudyPicture> picture = Picture(id, true);
    const Coverage alpha = picture->Alpha();
    Reference& reference = ReferenceOf(id);
    const HeldTo exact = reference.Of(id, RequireTechnique(m_Assets, id.technique));
    if (const std::string why = WhyNotCompared(id, m_Assets); why.empty())
    {
        AddScores(alpha, exact.coverage, id.width, result);
        if (exact.isWhole)
        {
            AddContours(alpha, reference.silhouette, id.width, result);
        }
        if (!exact.note.empty())
        {
            result.notes.push_back(exact.note);
        }
        result.notes.insert(result.notes.end(), reference.notes.begin(), reference.notes.end());
    }
    else
    {
        result.notes.push_back(why);
    }
    if (alpha.width != id.pictureWidth || alpha.height != id.pictureHeight)
    {
        result.notes.push_back("the camera draws " + SizeText(alpha.width, alpha.height) +
                               " pixels (renderScale): its widths and errors are in these");
    }
    if (!m_Folder.empty())
    {
        WritePictures(alpha, exact.coverage, reference.silhouette, result);
    }
    return result;
}

void StudyBench::WritePictures(const Coverage& alpha, const Coverage& exact,
                               const Silhouette& silhouette, CellResult& result)
{
    const PictureWindow window = WindowOnBorder(silhouette, alpha.width, alpha.height);
    const auto write = [&](const std::string& kind, const Image& image)
    {
        result.pictures[kind] = WriteStudyPicture(image, m_Folder, result.id, kind);
    };
    write("picture", AlphaImage(alpha, window));
    if (result.Has("meanAbsoluteError"))
    {
        write("reference", AlphaImage(exact, window));
        write("difference", DifferenceImage(alpha, exact, window));
    }
    if (result.id.subject == k_SceneSubject)
    {
        const Image output = Picture(result.id, false)->Output();
        const double scale = static_cast<double>(output.width) / alpha.width; // renderScale's
        Box bounds = silhouette.bounds();
        bounds.low *= scale;
        bounds.high *= scale;
        write("closeUp", EnlargedPart(output, CloseUp(window, result.id.width, scale)));
        write("scene", ScenePart(output, bounds, result.id.width * scale));
    }
}

CellResult StudyBench::MeasureTemporal(const CellId& id)
{
    if (const std::string why = WhyNotCompared(id, m_Assets); !why.empty())
    {
        return {id, {}, {}, {why}};
    }
    const std::unique_ptr<StudyPicture> picture = Picture(id, true);
    Transform& place = picture->asset().scene.Find(id.subject)->transform;
    const ScreenTriangles triangles = ShapeTriangles(id.subject, id.pictureWidth, id.pictureHeight);
    std::vector<double> changes;
    std::vector<double> areas;
    std::vector<double> contours;
    Coverage alphaBefore;
    Coverage exactBefore;
    for (int step = 0; step <= k_Steps; ++step)
    {
        const glm::dvec2 offset = k_Motion * (static_cast<double>(step) / k_Steps);
        place.localPosition = {offset.x, -offset.y, 0.0};
        const Silhouette silhouette(Moved(triangles, offset));
        const Coverage alpha = picture->Alpha();
        const Coverage exact =
            ExactOutlineCoverage(silhouette, {id.width}, id.pictureWidth, id.pictureHeight);
        if (step > 0)
        {
            changes.push_back(MeanErrorChange(alphaBefore, exactBefore, alpha, exact));
        }
        areas.push_back(alpha.Sum() / exact.Sum());
        contours.push_back(ScoreContours(alpha, silhouette, {id.width}).high.mean);
        alphaBefore = alpha;
        exactBefore = exact;
    }
    return {id,
            {{"flicker", MeanOf(changes)},
             {"areaWobble", DeviationOf(areas)},
             {"areaLow", *std::ranges::min_element(areas)},
             {"areaHigh", *std::ranges::max_element(areas)},
             {"contourSwim", DeviationOf(contours)}}};
}

AssetContext& StudyBench::AssetsFor(const std::string& variant)
{
    if (variant != k_HalfVariant && variant != k_StandardZVariant)
    {
        return m_Assets;
    }
    std::unique_ptr<AssetContext>& assets = m_Others[variant];
    if (!assets)
    {
        ShaderCompilerOptions options = m_Assets.compiler()->options();
        options.halfIs16Bit = variant == k_HalfVariant;
        options.usesReversedZBuffer = variant != k_StandardZVariant;
        options.missingFeatures = m_Device.missingShaderFeatures();
        assets = std::make_unique<AssetContext>(std::move(options));
        assets->LoadPluginsOf(m_Assets);
    }
    return *assets;
}

Coverage StudyBench::DrawShape(const CellId& id, AssetContext& assets, bool allowHDR)
{
    SceneAsset asset = MakeSubject(id, true, {}, assets);
    UseTechnique(asset, RequireTechnique(assets, id.technique), id.width, assets);
    asset.camera.allowHDR = allowHDR;
    return StudyPicture(std::move(asset), assets, m_Device).Alpha();
}

CellResult StudyBench::MeasureNumerical(const CellId& id)
{
    if (!IsShape(id.subject) || std::ranges::count(k_NumericalVariants, id.variant) == 0)
    {
        throw ContractError(id.Name() + ": its subject or its variant is not known");
    }
    const Twin twin = FindTwin(id.technique);
    if (id.variant.empty() && !twin)
    {
        return {id, {}, {}, {"no twin: nothing repeats its arithmetic in double precision"}};
    }
    try
    {
        AssetsFor(id.variant);
    }
    catch (const ContractError& error) // the device lacks something
    {
        return {id, {}, {}, {std::string("not drawn: ") + error.what()}};
    }
    const bool isSmall = id.variant == k_SmallTargetVariant;
    const Coverage drawn = DrawShape(id, AssetsFor(id.variant), !isSmall);
    if (id.variant.empty())
    {
        return {id, DifferenceOf(drawn, DrawTwin(twin, id, CornerGrid(m_Device)))};
    }
    Coverage usual = DrawShape(id, m_Assets, true);
    if (isSmall)
    {
        std::ranges::transform(usual.values, usual.values.begin(),
                               [](double value) { return std::min(value, 1.0); });
    }
    return {
        id, DifferenceOf(drawn, usual), {}, {"the difference between two pictures of the device"}};
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
