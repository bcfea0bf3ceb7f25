#pragma once

#include <limn/editor_stub/AssetContext.h>
#include <string>
#include <vector>

namespace limn
{
class GraphicsDevice;
}

namespace limn::study
{

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

} // namespace limn::study
