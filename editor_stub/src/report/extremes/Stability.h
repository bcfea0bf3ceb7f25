#pragma once

#include "report/extremes/ExtremeCase.h"

#include <limn/editor_stub/AssetContext.h>
#include <string>
#include <vector>

namespace limn
{
class GraphicsDevice;
class VulkanDevice;
} // namespace limn

namespace limn::study
{

/// How many cases each technique is put through.
enum class SweepSize
{
    Sampled,  ///< it meets every level; every two levels meet for one technique or another
    Pairwise, ///< every two levels meet for it
    Full      ///< all, where pictures of more than 256 pixels leave the first level of two factors
              ///< at most; a width that is no finite number is tried once
};

/// The technique of cells that are formulas, see FormulaCell: the subject is the formula, the
/// variant its input.
inline constexpr const char* k_FormulasName = "Formulas";

/// A cell for each technique and case. Cells know nothing of each other: any of them may be
/// measured alone, in any process.
std::vector<CellId> PlanSweep(std::span<const Technique> techniques, SweepSize size,
                              const ExtremeLevels& levels = {});
/// Those and one for each cell of the table of formulas.
std::vector<CellId> PlanStability(std::span<const Technique> techniques, SweepSize size,
                                  const ExtremeLevels& levels = {});

/// What an error bound has to know of the drawn object.
struct ShapeFacts
{
    double size = 0.0;              ///< the smaller one of width and height, pixels
    double thickness = 0.0;         ///< of the thinnest part, pixels
    std::size_t comparedPixels = 0; ///< how many the mean error is over
    std::size_t borderPixels = 0;   ///< those of them that the object covers in part
};

/// The largest mean error of alpha in the band that a technique's README leaves room for, and half
/// a pixel in all, which counts where there are few; none where it says nothing about such a case.
std::optional<double> ErrorBound(const Technique& technique, const ExtremeCase& extreme,
                                 const ShapeFacts& shape);

/// Values of all channels of a picture that no picture should have.
struct BadValues
{
    int notFinite = 0;
    int outOfRange = 0; ///< of 0...1, by more than 1e-3
};
/// @throws std::invalid_argument for formats that ChannelOf does not read
BadValues CountBadValues(const Image& colors);

/// A formula of an article and the one that limn has in its place, for one input.
struct FormulaCell
{
    std::string formula;    ///< "pow(x, 2)"
    std::string where;      ///< which technique it is of
    std::string input;      ///< "x = -0.5"
    double meant = 0.0;     ///< what it should give, in double precision
    double tolerance = 0.0; ///< how far off it may be
    double article = 0.0;   ///< what the article's gives on this device, in float
    double ours = 0.0;      ///< what limn's gives there
    /// Whether the article's is known to be good for this input; on lavapipe, where it is
    /// undefined.
    bool articleHolds = false;
    std::string reason; ///< why the article's fails, and what is done in its place

    bool IsGood(double value) const; ///< finite, and no farther off than the tolerance
};

/// The table without what came out.
std::vector<FormulaCell> Formulas();

/// Everything that is known to fail in a formula of the articles: a few inputs each, those for
/// which the article's is as good as ours among them. What a shader does is evaluated on the
/// device, in floats; the rest as the library does it.
/// @throws ContractError, VulkanError as any frame
std::vector<FormulaCell> EvaluateFormulas(AssetContext& assets, GraphicsDevice& device);

/// Measures cells of PlanStability, in any order.
class StabilityStudy
{
public:
    /// @param assets  cases take its plug-ins and its compiler's options, whose cacheFolder makes
    /// the
    ///     difference between seconds and minutes; the direction of Z is each case's
    /// @param device  made with VulkanDeviceOptions::validation, or no messages are counted; must
    ///     outlive this, as must the assets
    StabilityStudy(const AssetContext& assets, VulkanDevice& device)
        : m_Assets(assets), m_Device(device)
    {
    }

    /// Draws the case that the cell's id says, with its width and with twice that.
    ///
    /// The checks, each a sentence in CellResult::notes that begins with "failed: ": no texel of
    /// the camera's colour (half floats, before they are rounded) NaN, infinite or outside 0...1;
    /// no exception; no message of the validation layer; no less area for twice the width; an error
    /// within ErrorBound; nothing drawn for the width 0, something for a pixel and more. A width
    /// that is no finite number has to be refused with a sentence.
    ///
    /// Of formulas: that ours is as near to what is meant as it should be.
    ///
    /// values: formulaMeant, formulaArticle, formulaOurs; badTexels, outOfRange,
    /// validationMessages, meanAbsoluteError, bandPixels, errorBound, areaGrowth, failures; those
    /// that there are.
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
