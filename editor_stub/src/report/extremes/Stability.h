#pragma once

#include "report/extremes/ExtremeCase.h"

namespace limn
{
class GraphicsDevice;
class VulkanDevice;
} // namespace limn

namespace limn::study
{

/// The number of cases that each technique is tested with.
enum class SweepSize
{
    Sampled,  ///< every level for it; every two levels meet for some technique
    Pairwise, ///< every two levels meet for each technique
    /// All combinations. For pictures of more than 256 pixels and for untidy meshes, at most three
    /// factors are not at their first level. A width that is no finite number is tried once.
    Full
};

/// The technique's name in cells that are formulas, see FormulaCell. Their subject is the formula,
/// their variant its input.
inline constexpr const char* k_FormulasName = "Formulas";

/// Returns a cell for each technique and case. Cells are independent: any of them may be measured
/// alone, in any process.
std::vector<CellId> PlanSweep(std::span<const Technique> techniques, SweepSize size,
                              const ExtremeLevels& levels = {});
/// Returns the cells of PlanSweep and one cell for each formula of the table.
std::vector<CellId> PlanStability(std::span<const Technique> techniques, SweepSize size);

/// The number of values, in all channels of a picture, that no picture should have.
struct BadValues
{
    int notFinite = 0;
    int outOfRange = 0; ///< outside 0...1 by more than 1e-3
};
/// @throws std::invalid_argument for formats that ChannelOf does not read
BadValues CountBadValues(const Image& colors);

/// A formula of an article and the one that limn uses in its place, for one input.
struct FormulaCell
{
    std::string formula;    ///< "pow(x, 2)"
    std::string where;      ///< the technique that it belongs to
    std::string input;      ///< "x = -0.5"
    double meant = 0.0;     ///< the right result, in double precision
    double tolerance = 0.0; ///< the largest error that is allowed
    double article = 0.0;   ///< the result of the article's formula on this device, in float
    double ours = 0.0;      ///< the result of limn's formula there
    /// Set if the article's formula is known to be good for this input. Where it is undefined, this
    /// holds for lavapipe.
    bool articleHolds = false;
    std::string reason; ///< why the article's formula fails, and what replaces it
    /// The formulas in HLSL of the numbers a, b, c and d; "" if they are of no shader.
    std::string articleText = {};
    std::string oursText = {};
    glm::vec4 values{0.0f}; ///< a to d; beyond 1e38: infinite; no constants for the compiler

    bool IsGood(double value) const; ///< true if finite and within the tolerance
};

/// Returns the table of formulas without results.
std::vector<FormulaCell> Formulas();

/// Evaluates everything that is known to fail in a formula of the articles, with a few inputs each.
/// For some of the inputs the article's formula is as good as ours. Formulas of shaders are
/// evaluated on the device, in floats, the others as the library does it.
/// @throws ContractError, VulkanError as for any frame
std::vector<FormulaCell> EvaluateFormulas(AssetContext& assets, GraphicsDevice& device);

/// Measures the cells of PlanStability, in any order.
class StabilityStudy
{
public:
    /// @param assets  gives the cases its plug-ins and its compiler's options, whose cacheFolder
    ///     makes the difference between seconds and minutes; each case has its own direction of Z
    /// @param device  must be made with VulkanDeviceOptions::validation, or no messages are
    ///     counted; device and assets must outlive this
    StabilityStudy(const AssetContext& assets, VulkanDevice& device)
        : m_Assets(assets), m_Device(device)
    {
    }

    /// Draws the case that the cell's id describes, with its width and with twice that width.
    ///
    /// Each check that fails adds a sentence to CellResult::notes that begins with "failed: ". The
    /// checks: no texel of the camera's colour (half floats, before they are rounded) is NaN,
    /// infinite or outside 0...1; there is no exception and no message of the validation layer; the
    /// area does not shrink for twice the width; the error is within what the technique's README
    /// allows; nothing is drawn
    /// for the width 0, and something for a pixel and more. A width that is no finite number must
    /// be refused with a sentence.
    ///
    /// For formulas the check is that the result of ours is as near to the right one as it should
    /// be.
    ///
    /// The values are those that apply of formulaMeant, formulaArticle, formulaOurs; badTexels,
    /// outOfRange, validationMessages, meanAbsoluteError, bandPixels, errorBound, areaGrowth,
    /// failures.
    /// @throws ContractError for a cell that is not of PlanStability
    CellResult Measure(const CellId& cell);

private:
    AssetContext& AssetsFor(bool isStandardZ);
    CellResult MeasureFormula(const CellId& cell);

    const AssetContext& m_Assets;
    VulkanDevice& m_Device;
    std::unique_ptr<AssetContext> m_Reversed;
    std::unique_ptr<AssetContext> m_Standard;
    std::vector<FormulaCell> m_Formulas; ///< empty until one of them is asked for
};

} // namespace limn::study
