#include "report/measure/StudyBench.h"

#include "report/measure/StudyPictures.h"
#include "report/measure/StudyScene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limn/base/TerminalText.h>
#include <map>
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

/// Why it is drawn, but not compared; "" if it is.
std::string WhyNotCompared(const CellId& id, const AssetContext& assets)
{
    const std::string& why = RequireTechnique(assets, id.technique).noWidth;
    return why.empty() ? why : "not compared: " + why;
}

/// The outline in the picture, not beyond: where nothing can be drawn nothing is missing.
double PerimeterWithin(const Coverage& exact, double width)
{
    return width > 0.0 ? exact.Sum() / width : 0.0;
}

void AddScores(const Coverage& alpha, const Coverage& exact, double width, CellResult& result)
{
    const OutlineScore score = ScoreOutline(alpha, exact, PerimeterWithin(exact, width));
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
        const SeenOutline& outline =
            SeenAt(technique.hiddenAt.value_or(HiddenAt::Border), id.width);
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

private:
    const SeenOutline& SeenAt(HiddenAt where, double width)
    {
        const auto [found, isNew] = seen.try_emplace(where);
        if (isNew)
        {
            found->second = SeenOutlineCoverage(whole, silhouette, width, surfaces.outlined,
                                                surfaces.others, where);
        }
        return found->second;
    }
};

StudyBench::StudyBench(std::filesystem::path scene, std::filesystem::path folder,
                       AssetContext& assets, VulkanDevice& device)
    : m_Scene(std::move(scene)),
      m_Folder(std::move(folder)),
      m_Assets(assets),
      m_Device(device),
      m_Numerical(assets, device)
{
}

StudyBench::~StudyBench() = default;

std::string WhyNotDrawn(const CellId& id, const AssetContext& assets)
{
    const double widest = RequireTechnique(assets, id.technique).widestOutline;
    return id.width > widest ? "not drawn: it is " + std::to_string(static_cast<int>(widest)) +
                                   " pixels wide at most"
                             : std::string();
}

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
    if (id.kind == CellKind::Numerical)
    {
        return m_Numerical.Measure(id);
    }
    if (id.kind != CellKind::Geometry && id.kind != CellKind::Temporal)
    {
        throw ContractError(id.Name() + ": cells of this kind are not measured one by one");
    }
    if (const std::string why = WhyNotDrawn(id, m_Assets); !why.empty())
    {
        return {id, {}, {}, {why}};
    }
    return id.kind == CellKind::Geometry ? MeasureGeometry(id) : MeasureTemporal(id);
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

} // namespace limn::study
