#include "report/extremes/Stability.h"

#include "report/measure/StudyPicture.h"

#include <algorithm>
#include <cmath>
#include <limn/vulkan/VulkanDevice.h>

namespace limn::study
{

namespace
{

constexpr double k_RangeSlack = 1e-3;
constexpr double k_LeastGrowth = 0.999;

/// The result of drawing a case.
struct DrawnCase
{
    Coverage alpha;
    double area = 0.0; ///< pixels
    BadValues bad;
};

DrawnCase DrawCase(const ExtremeCase& extreme, const Technique& technique, AssetContext& assets,
                   VulkanDevice& device)
{
    SceneAsset asset = extreme.Scene(assets, !technique.noWidth.empty());
    UseTechnique(asset, technique, extreme.width, assets);
    StudyPicture picture(std::move(asset), assets, device);
    const Image colors = picture.Colors();
    const Coverage alpha = ChannelOf(colors, 0);
    return {alpha, alpha.Sum(), CountBadValues(colors)};
}

/// The part of the picture that can tell something: around the object, as far as the outline's
/// shape depends on it.
struct CompareWindow
{
    glm::ivec2 corner{0};
    glm::ivec2 size{0};

    CompareWindow(const ExtremeCase& extreme, const Silhouette& silhouette)
    {
        const glm::dvec2 picture(extreme.size);
        const double margin = std::min(extreme.width, 64.0) + 8.0;
        const auto inPicture = [&](const glm::dvec2& point)
        {
            return glm::ivec2(glm::clamp(point, glm::dvec2(0.0), picture));
        };
        corner = inPicture(glm::floor(silhouette.bounds().low - margin));
        size = inPicture(glm::ceil(silhouette.bounds().high + margin)) - corner;
    }

    Coverage Of(const Coverage& picture) const
    {
        Coverage part(size.x, size.y);
        part.ForEach([&](int x, int y) { part.At(x, y) = picture.At(corner.x + x, corner.y + y); });
        return part;
    }
};

/// Checks something of a cell.
void Expect(bool condition, const std::string& otherwise, CellResult& cell)
{
    if (!condition)
    {
        cell.notes.push_back("failed: " + otherwise);
        cell.values["failures"] += 1.0;
    }
}

std::string ShortNumber(double value)
{
    char text[40];
    std::snprintf(text, sizeof(text), "%.4g", value);
    return text;
}

void CheckTexels(const DrawnCase& drawn, CellResult& result)
{
    result.values["badTexels"] = drawn.bad.notFinite;
    result.values["outOfRange"] = drawn.bad.outOfRange;
    Expect(drawn.bad.notFinite == 0,
           std::to_string(drawn.bad.notFinite) + " values are NaN or infinite", result);
    Expect(drawn.bad.outOfRange == 0,
           std::to_string(drawn.bad.outOfRange) + " values are outside 0...1", result);
}

/// The facts about the drawn object that an error bound depends on.
struct ShapeFacts
{
    double size = 0.0;              ///< the smaller of width and height, in pixels
    double thickness = 0.0;         ///< of the thinnest part, in pixels
    std::size_t comparedPixels = 0; ///< the number of pixels that the mean error is over
    std::size_t borderPixels = 0;   ///< the number of these that the object covers in part
};

/// The READMEs' shapes are no smaller. In smaller ones corners count, where a border pixel may be
/// off by so much; the sharp tips of a star are off by more (stroke_outline/README.md).
constexpr double k_SmallestShape = 20.0; // pixels
constexpr double k_CornerError = 0.4;
/// The least width of an outline that is measured; a thinner one falls between four samples
/// (wide_outline/README.md).
constexpr double k_Hair = 0.3; // pixels

struct BoundFigure
{
    double width;
    double error;
};

/// Between the figures of a table, straight over the logarithm of the width.
double BoundBetween(std::span<const BoundFigure> figures, double width)
{
    const auto high = std::ranges::lower_bound(figures, width, {}, &BoundFigure::width);
    if (high == figures.begin() || high == figures.end())
    {
        return high == figures.end() ? figures.back().error : figures.front().error;
    }
    const BoundFigure& low = *std::prev(high);
    const double part = std::log(width / low.width) / std::log(high->width / low.width);
    return low.error + part * (high->error - low.error);
}

/// stroke_outline/README.md, shapes of 20 pixels.
double StrokesBound(double width)
{
    return width < 8.0 ? 0.0125 : 0.004;
}

/// wide_outline/README.md: the star's column, or the needle's for parts as thin as one.
double DistancesBound(double width, double thickness)
{
    constexpr BoundFigure k_Star[] = {{1, 0.063}, {2, 0.051}, {8, 0.030}, {32, 0.009}};
    constexpr BoundFigure k_Needle[] = {{1, 0.227}, {2, 0.118}, {8, 0.032}, {32, 0.009}};
    return BoundBetween(thickness < 2.0 ? std::span<const BoundFigure>(k_Needle) : k_Star, width);
}

/// translucent_outline/README.md: within a quarter of a pixel; and two edges that are as good as
/// samples make them, a quarter of a pixel off in the mean for one.
double HullBound(double width, int samples)
{
    return (0.25 + 2.0 * 1.27 * 0.25 / samples) / (width + 1.0);
}

/// Returns the error that a README states for shapes like those on which it was measured.
std::optional<double> StatedBound(const std::string& name, const ExtremeCase& extreme,
                                  const ShapeFacts& shape)
{
    const double width = extreme.width;
    if (name == "Strokes")
    {
        return StrokesBound(width);
    }
    if ((name == "Separable" || name == "Jump flood") && shape.thickness >= k_Hair)
    {
        return DistancesBound(width, shape.thickness);
    }
    if (name == "Auto")
    {
        return std::max(StrokesBound(width), DistancesBound(width, shape.thickness));
    }
    // The techniques below cull by the way triangles go round; their READMEs mean whole outlines.
    const Untidiness mesh = extreme.untidiness;
    if (mesh == Untidiness::TurnedAtRandom || mesh == Untidiness::Soup || mesh == Untidiness::Open)
    {
        return std::nullopt;
    }
    // "Concave objects": a hull that closes the hole is not the outline's.
    if (name == "Inflated" && width >= 1.0 && width < 0.5 * shape.thickness)
    {
        return HullBound(width, extreme.samples);
    }
    const bool isOrdinary = width >= 1.0 && shape.thickness >= 2.0;
    // outlines.md, §6: a line of 2 pixels on whole silhouettes.
    if (name == "Screen space" && isOrdinary && width <= 2.0)
    {
        return 0.28;
    }
    // Its README: as wide inside as outside, 0.9 of what is asked; a cross, not a circle.
    if (name == "Mask difference" && isOrdinary && width < shape.thickness)
    {
        return 0.6;
    }
    // Its README: steps of 1, 0.69, 0.18 and 0.02 on 1/7, 2/7, 2/7 and 2/7 of the width.
    if (name == "Selection" && isOrdinary)
    {
        return 0.65;
    }
    return std::nullopt;
}

/// Returns the largest mean error of alpha in the band that a technique's README allows, plus half
/// a pixel in all, which matters if there are few pixels. For small objects it adds an allowance
/// for each border pixel. Returns nothing if the README does not cover such a case.
std::optional<double> ErrorBound(const Technique& technique, const ExtremeCase& extreme,
                                 const ShapeFacts& shape)
{
    const auto pixels = static_cast<double>(std::max<std::size_t>(shape.comparedPixels, 1));
    std::optional<double> bound = StatedBound(technique.name, extreme, shape);
    if (bound)
    {
        const bool isSmall = shape.size < k_SmallestShape;
        const double corners =
            isSmall ? k_CornerError * static_cast<double>(shape.borderPixels) : 0.0;
        *bound += (0.5 + corners) / pixels;
    }
    return bound;
}

ShapeFacts FactsOf(const Silhouette& silhouette, const CompareWindow& window,
                   const OutlineScore& score)
{
    constexpr double k_TubePart = 0.2; // of the torus
    const glm::dvec2 extent = silhouette.bounds().high - silhouette.bounds().low;
    const double size = std::min(extent.x, extent.y);
    const Coverage fill = ExactFillCoverage(silhouette, window.size.x, window.size.y);
    const auto border =
        std::ranges::count_if(fill.values, [](double part) { return part > 0.0 && part < 1.0; });
    return {size, k_TubePart * size, score.bandPixels, static_cast<std::size_t>(border)};
}

/// Checks the shape of a picture whose texels are finite.
void CheckShape(const ExtremeCase& extreme, const Technique& technique, const DrawnCase& drawn,
                AssetContext& assets, CellResult& result)
{
    if (extreme.width == 0.0)
    {
        const double object = technique.noWidth.empty() ? drawn.area : 0.0;
        Expect(object == 0.0, "a width of 0 draws " + ShortNumber(object) + " pixels", result);
        return;
    }
    const SceneAsset asset = extreme.Scene(assets, false);
    const GameObject& object = *asset.scene.objects().front();
    const ScreenTriangles triangles = MeshTriangles(*object.renderer->mesh, object.transform,
                                                    asset.camera, asset.width, asset.height);
    const CompareWindow window(extreme, Silhouette(triangles));
    const Silhouette silhouette(Moved(triangles, -glm::dvec2(window.corner)));
    const Coverage exact =
        ExactOutlineCoverage(silhouette, {extreme.width}, window.size.x, window.size.y);
    const OutlineScore score = ScoreOutline(window.Of(drawn.alpha), exact);
    const ShapeFacts shape = FactsOf(silhouette, window, score);
    // A shape that covers no pixel's middle has no surface to draw lines on.
    const bool isSeen = technique.noWidth.empty() ? shape.thickness >= 0.3 : shape.thickness >= 1.5;
    Expect(extreme.width < 1.0 || drawn.area > 0.0 || exact.Sum() < 8.0 || !isSeen,
           "nothing is drawn where an outline has " + ShortNumber(exact.Sum()) + " pixels", result);
    if (!technique.noWidth.empty())
    {
        return;
    }
    const auto bound = ErrorBound(technique, extreme, shape);
    result.values["meanAbsoluteError"] = score.meanAbsoluteError;
    result.values["bandPixels"] = static_cast<double>(score.bandPixels);
    if (bound)
    {
        result.values["errorBound"] = *bound;
        Expect(score.meanAbsoluteError <= *bound,
               "a mean error of " + ShortNumber(score.meanAbsoluteError) + ", more than " +
                   ShortNumber(*bound),
               result);
    }
}

void CheckGrowth(const ExtremeCase& extreme, const Technique& technique, const DrawnCase& drawn,
                 AssetContext& assets, VulkanDevice& device, CellResult& result)
{
    ExtremeCase wider = extreme;
    wider.width *= 2.0;
    if (extreme.width == 0.0 || wider.width > technique.widestOutline)
    {
        return;
    }
    const double area = DrawCase(wider, technique, assets, device).area;
    if (drawn.area > 0.0)
    {
        result.values["areaGrowth"] = area / drawn.area;
    }
    // Lines on a surface of a few pixels come and go with the pixels' middles that it covers.
    const bool isTooSmall = !technique.noWidth.empty() && drawn.area < 8.0;
    Expect(isTooSmall || area >= k_LeastGrowth * drawn.area,
           "twice the width has " + ShortNumber(area) + " pixels, less than " +
               ShortNumber(drawn.area),
           result);
}

/// The technique refuses the width, for a reason.
/// @return whether it did
bool IsRefused(const ExtremeCase& extreme, const Technique& technique, AssetContext& assets,
               CellResult& result)
{
    try
    {
        SceneAsset asset = extreme.Scene(assets, false);
        UseTechnique(asset, technique, extreme.width, assets);
    }
    catch (const AssetError& error)
    {
        result.notes.push_back("refused: " + std::string(error.what()));
        return true;
    }
    Expect(std::isfinite(extreme.width), "a width that is no finite number is accepted", result);
    return !std::isfinite(extreme.width);
}

} // namespace

BadValues CountBadValues(const Image& colors)
{
    BadValues bad;
    for (int channel = 0; channel < 4; ++channel)
    {
        for (const double value : ChannelOf(colors, channel).values)
        {
            bad.notFinite += std::isfinite(value) ? 0 : 1;
            bad.outOfRange += value < -k_RangeSlack || value > 1.0 + k_RangeSlack ? 1 : 0;
        }
    }
    return bad;
}

std::vector<CellId> PlanStability(std::span<const Technique> techniques, SweepSize size)
{
    std::vector<CellId> cells = PlanSweep(techniques, size);
    for (const FormulaCell& formula : Formulas())
    {
        cells.push_back(
            {CellKind::Stability, k_FormulasName, formula.formula, 0.0, 1, 1, formula.input});
    }
    return cells;
}

std::vector<CellId> PlanSweep(std::span<const Technique> techniques, SweepSize size,
                              const ExtremeLevels& levels)
{
    std::vector<CellId> cells;
    const auto add = [&](const Technique& technique, const ExtremeCase& extreme)
    {
        cells.push_back({CellKind::Stability, technique.name, "torus", extreme.width,
                         extreme.size.x, extreme.size.y, extreme.Variant()});
    };
    std::vector<int> counts = levels.Counts();
    if (size == SweepSize::Sampled)
    {
        counts.push_back(static_cast<int>(techniques.size()));
        for (Combination combination : CoverPairs(counts))
        {
            const auto technique = static_cast<std::size_t>(combination.back());
            combination.pop_back();
            add(techniques[technique], levels.At(combination));
        }
        return cells;
    }
    const std::vector<Combination> cases =
        size == SweepSize::Full ? AllCombinations(counts, [&](const Combination& combination)
                                                  { return levels.IsWorthIt(combination); })
                                : CoverPairs(counts);
    for (const Technique& technique : techniques)
    {
        for (const Combination& combination : cases)
        {
            add(technique, levels.At(combination));
        }
    }
    return cells;
}

AssetContext& StabilityStudy::AssetsFor(bool isStandardZ)
{
    std::unique_ptr<AssetContext>& assets = isStandardZ ? m_Standard : m_Reversed;
    if (!assets)
    {
        ShaderCompilerOptions options = m_Assets.compiler()->options();
        options.usesReversedZBuffer = !isStandardZ;
        assets = std::make_unique<AssetContext>(std::move(options));
        assets->LoadPluginsOf(m_Assets);
    }
    return *assets;
}

CellResult StabilityStudy::MeasureFormula(const CellId& cell)
{
    if (m_Formulas.empty())
    {
        m_Formulas = EvaluateFormulas(AssetsFor(false), m_Device);
    }
    const auto found = std::ranges::find_if(
        m_Formulas, [&](const FormulaCell& formula)
        { return formula.formula == cell.subject && formula.input == cell.variant; });
    if (found == m_Formulas.end())
    {
        throw ContractError("'" + cell.Name() + "' is no formula of the stability table");
    }
    CellResult result{cell,
                      {{"failures", 0.0},
                       {"formulaMeant", found->meant},
                       {"formulaArticle", found->article},
                       {"formulaOurs", found->ours}}};
    Expect(found->IsGood(found->ours), "ours is off by more than " + ShortNumber(found->tolerance),
           result);
    result.notes.push_back(found->where + ": " + found->reason);
    return result;
}

CellResult StabilityStudy::Measure(const CellId& cell)
{
    if (cell.kind == CellKind::Stability && cell.technique == k_FormulasName)
    {
        return MeasureFormula(cell);
    }
    const Technique* technique = FindTechnique(m_Assets.features().techniques(), cell.technique);
    if (cell.kind != CellKind::Stability || technique == nullptr || cell.pictureWidth < 1 ||
        cell.pictureHeight < 1)
    {
        throw ContractError("'" + cell.Name() + "' is no cell of the stability sweep");
    }
    const ExtremeCase extreme = ExtremeCase::OfCell(cell);
    AssetContext& assets = AssetsFor(extreme.isStandardZ);
    CellResult result{cell, {{"failures", 0.0}}};
    const std::size_t messages = m_Device.validationMessages().size();
    try
    {
        if (!IsRefused(extreme, *technique, assets, result))
        {
            const DrawnCase drawn = DrawCase(extreme, *technique, assets, m_Device);
            CheckTexels(drawn, result);
            if (drawn.bad.notFinite == 0)
            {
                CheckShape(extreme, *technique, drawn, assets, result);
                CheckGrowth(extreme, *technique, drawn, assets, m_Device, result);
            }
        }
    }
    catch (const std::exception& error)
    {
        Expect(false, error.what(), result);
    }
    const std::vector<ValidationMessage> all = m_Device.validationMessages();
    result.values["validationMessages"] = static_cast<double>(all.size() - messages);
    Expect(all.size() == messages,
           all.size() == messages ? "" : "the validation layer reports " + all[messages].text,
           result);
    return result;
}

} // namespace limn::study
