#include "study/StudyBench.h"

#include "study/StudyPictures.h"
#include "study/StudyScene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limn::study
{

/// What the outlines of one subject and width are compared with.
struct StudyBench::Reference
{
    std::string name; ///< of the cell, without its technique
    Silhouette silhouette;
    Coverage exact;
};

namespace
{

constexpr int k_Steps = 16; ///< of a sixteenth of a pixel each
const glm::dvec2 k_Motion(1.0, 0.3);

std::string NameWithoutTechnique(CellId id)
{
    id.kind = CellKind::Geometry;
    id.technique.clear();
    return id.Name();
}

const Technique& TechniqueOf(const CellId& id)
{
    const Technique* technique = FindTechnique(id.technique);
    if (technique == nullptr)
    {
        throw ContractError("there is no technique '" + id.technique + "'");
    }
    return *technique;
}

/// Why it is drawn, but not compared; "" if it is.
std::string WhyNotCompared(const CellId& id)
{
    const std::string& why = TechniqueOf(id).info.noWidth;
    return why.empty() ? why : "not compared: " + why;
}

/// The outline in the picture, not beyond: where nothing can be drawn nothing is missing.
double PerimeterWithin(const Coverage& exact, double width)
{
    return width > 0.0 ? exact.Sum() / width : 0.0;
}

void AddScores(const Coverage& alpha, const Coverage& exact, const Silhouette& silhouette,
               double width, CellResult& result)
{
    const OutlineScore score = ScoreOutline(alpha, exact, PerimeterWithin(exact, width));
    const ContourScores contours = ScoreContours(alpha, silhouette, {width});
    result.values = {{"meanAbsoluteError", score.meanAbsoluteError},
                     {"rootMeanSquare", score.rootMeanSquare},
                     {"percentile99", score.percentile99},
                     {"largest", score.largest},
                     {"intersectionOverUnion", score.intersectionOverUnion},
                     {"areaRatio", score.areaRatio},
                     {"effectiveWidth", score.effectiveWidth},
                     {"effectiveWidthSpread", contours.high.spread},
                     {"contourInner", contours.low.mean},
                     {"contourOuter", contours.high.mean},
                     {"hausdorff", HausdorffDistance(alpha, exact)},
                     {"bandPixels", static_cast<double>(score.bandPixels)},
                     {"outOfRange", static_cast<double>(score.badValues)}};
    if (contours.high.crossings == 0)
    {
        result.notes.push_back("nowhere as opaque as one half: it has no contour");
        result.values.erase("contourInner");
        result.values.erase("contourOuter");
        result.values.erase("effectiveWidthSpread");
    }
}

double MeanOf(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double DeviationOf(const std::vector<double>& values)
{
    const double mean = MeanOf(values);
    double squares = 0.0;
    for (const double value : values)
    {
        squares += (value - mean) * (value - mean);
    }
    return std::sqrt(squares / static_cast<double>(values.size()));
}

ScreenTriangles Moved(ScreenTriangles triangles, const glm::dvec2& offset)
{
    for (auto& triangle : triangles)
    {
        for (glm::dvec2& corner : triangle)
        {
            corner += offset;
        }
    }
    return triangles;
}

} // namespace

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

std::string WhyNotDrawn(const CellId& id)
{
    const double widest = TechniqueOf(id).widestOutline;
    return id.width > widest ? "not drawn: it is " + std::to_string(static_cast<int>(widest)) +
                                   " pixels wide at most"
                             : std::string();
}

std::unique_ptr<StudyPicture> StudyBench::Picture(const CellId& id, bool isBlack)
{
    SceneAsset asset = MakeSubject(id, isBlack, m_Scene, m_Assets);
    UseTechnique(asset, TechniqueOf(id), id.width, m_Assets);
    return std::make_unique<StudyPicture>(std::move(asset), m_Assets, m_Device);
}

const StudyBench::Reference& StudyBench::ReferenceOf(const CellId& id)
{
    const std::string name = NameWithoutTechnique(id);
    if (!m_Reference || m_Reference->name != name)
    {
        const SceneAsset asset = MakeSubject(id, true, m_Scene, m_Assets);
        Silhouette silhouette = OutlinedSilhouette(asset);
        Coverage exact = ExactOutlineCoverage(silhouette, {id.width}, asset.width, asset.height);
        m_Reference =
            std::make_unique<Reference>(Reference{name, std::move(silhouette), std::move(exact)});
    }
    return *m_Reference;
}

CellResult StudyBench::Measure(const CellId& id)
{
    switch (id.kind)
    {
    case CellKind::Geometry:
        return MeasureGeometry(id);
    case CellKind::Temporal:
        return MeasureTemporal(id);
    case CellKind::Numerical:
        return m_Numerical.Measure(id);
    default:
        throw ContractError(id.Name() + ": cells of this kind are not measured one by one");
    }
}

CellResult StudyBench::MeasureGeometry(const CellId& id)
{
    CellResult result{id, {}, {}, {}, {}};
    if (const std::string why = WhyNotDrawn(id); !why.empty())
    {
        result.notes.push_back(why);
        return result;
    }
    const std::unique_ptr<StudyPicture> picture = Picture(id, true);
    const Coverage alpha = picture->Alpha();
    const Reference& reference = ReferenceOf(id);
    if (const std::string why = WhyNotCompared(id); why.empty())
    {
        AddScores(alpha, reference.exact, reference.silhouette, id.width, result);
    }
    else
    {
        result.notes.push_back(why);
    }
    if (alpha.width != id.pictureWidth || alpha.height != id.pictureHeight)
    {
        result.notes.push_back("the camera draws " + std::to_string(alpha.width) + "x" +
                               std::to_string(alpha.height) +
                               " pixels (renderScale): its widths and errors are in these");
    }
    if (!m_Folder.empty())
    {
        WritePictures(alpha, reference, result);
        if (id.subject == k_SceneSubject)
        {
            const Image output = Picture(id, false)->Output();
            const double scale = static_cast<double>(output.width) / alpha.width; // renderScale's
            Box bounds = reference.silhouette.bounds();
            bounds.low *= scale;
            bounds.high *= scale;
            result.pictures["scene"] =
                WriteScenePicture(output, bounds, id.width * scale, m_Folder, id);
        }
    }
    return result;
}

void StudyBench::WritePictures(const Coverage& alpha, const Reference& reference,
                               CellResult& result)
{
    const PictureWindow window = WindowOnBorder(reference.silhouette, alpha.width, alpha.height);
    const bool isCompared = result.Has("meanAbsoluteError");
    result.pictures["picture"] =
        WriteStudyPicture(AlphaImage(alpha, window), m_Folder, result.id, "picture");
    if (isCompared)
    {
        result.pictures["reference"] = WriteStudyPicture(AlphaImage(reference.exact, window),
                                                         m_Folder, result.id, "reference");
        result.pictures["difference"] = WriteStudyPicture(
            DifferenceImage(alpha, reference.exact, window), m_Folder, result.id, "difference");
    }
}

CellResult StudyBench::MeasureTemporal(const CellId& id)
{
    CellResult result{id, {}, {}, {}, {}};
    for (const std::string& why : {WhyNotDrawn(id), WhyNotCompared(id)})
    {
        if (!why.empty())
        {
            result.notes.push_back(why);
            return result;
        }
    }
    const std::unique_ptr<StudyPicture> picture = Picture(id, true);
    Transform& place = picture->scene().Find(id.subject)->transform;
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
    result.values = {{"flicker", MeanOf(changes)},
                     {"areaWobble", DeviationOf(areas)},
                     {"areaLow", *std::ranges::min_element(areas)},
                     {"areaHigh", *std::ranges::max_element(areas)},
                     {"contourSwim", DeviationOf(contours)}};
    return result;
}

} // namespace limn::study
