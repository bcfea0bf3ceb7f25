#include "report/measure/Study.h"

#include <limits>
#include <sstream>

namespace limn::study
{

const char* ToString(CellKind kind)
{
    return k_CellKindNames[static_cast<std::size_t>(kind)].data();
}

std::string SizeText(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

std::string CellId::Name() const
{
    std::ostringstream name;
    name << ToString(kind) << '/' << technique << '/' << subject << '/' << width << '/'
         << SizeText(pictureWidth, pictureHeight);
    if (!variant.empty())
    {
        name << '/' << variant;
    }
    return name.str();
}

std::string CellId::NameForAllTechniques() const
{
    CellId id = *this;
    id.technique.clear();
    return id.Name();
}

const std::vector<Metric>& Metrics()
{
    static const std::vector<Metric> metrics = {
        // geometry: of coverage, over pixels in the drawn or the exact outline
        {"meanAbsoluteError", "mean error", ""},
        {"rootMeanSquare", "RMS error", ""},
        {"percentile99", "99th percentile", ""},
        {"largest", "largest error", ""},
        {"intersectionOverUnion", "IoU", ""},
        {"areaRatio", "area drawn / exact", ""},
        {"effectiveWidth", "effective width", "px"},
        {"effectiveWidthSpread", "spread of the width", "px"},
        {"contourInner", "inner contour off", "px"},
        {"contourOuter", "outer contour off", "px"},
        {"hausdorff", "Hausdorff distance", "px"},
        {"bandPixels", "pixels compared", ""},
        // numerical: against the same algorithm in double, over the same pixels
        {"numericalMean", "mean numerical error", ""},
        {"numericalPercentile99", "99th percentile, numerical", ""},
        {"numericalLargest", "largest numerical error", ""},
        {"numericalDiffering", "part of pixels off by more than 1/255", ""},
        // temporal: over sixteen steps of a sixteenth of a pixel
        {"flicker", "flicker", ""},
        {"areaWobble", "area wobble", ""},
        {"areaLow", "least area drawn / exact", ""},
        {"areaHigh", "largest area drawn / exact", ""},
        {"contourSwim", "contour swim", "px"},
        // cost
        {"gpuMilliseconds", "GPU time of the frame", "ms", true},
        {"gpuAddedMilliseconds", "GPU time added", "ms", true},
        {"gpuAddedUncertainty", "GPU time added, known to ±", "ms", true},
        {"cpuRecordMilliseconds", "CPU time to record", "ms", true},
        {"cpuAddedMilliseconds", "CPU time added", "ms", true},
        {"cpuAddedUncertainty", "CPU time added, known to ±", "ms", true},
        {"quietMilliseconds", "GPU time without an outline, when quiet", "ms", true},
        {"busyMilliseconds", "GPU time without an outline, when busy", "ms", true},
        {"quietPart", "part of the run that was quiet", "", true},
        {"otherPrograms", "processors that other programs kept busy", "", true},
        {"passes", "render passes added", ""},
        {"draws", "draws added", ""},
        {"targetBytes", "targets added", "bytes"},
        {"movedBytes", "loaded and stored, added", "bytes"},
        {"floorMilliseconds", "floor: its pixels copied once", "ms", true},
        // stability
        {"badTexels", "NaN or infinite texels", ""},
        {"outOfRange", "texels outside 0...1, or NaN", ""},
        {"validationMessages", "validation messages", ""},
        {"errorBound", "error bound", ""},
        {"areaGrowth", "area for twice the width / area", ""},
        {"failures", "failed checks", ""},
        {"formulaMeant", "meant", ""},
        {"formulaArticle", "the article's", ""},
        {"formulaOurs", "ours", ""},
    };
    return metrics;
}

double CellResult::Value(const std::string& key) const
{
    const auto found = values.find(key);
    return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

std::pair<double, double> CellResult::Quartiles(const std::string& key) const
{
    constexpr double k_None = std::numeric_limits<double>::quiet_NaN();
    const auto found = quartiles.find(key);
    return found == quartiles.end() ? std::pair(k_None, k_None) : found->second;
}

std::set<std::string> Study::MeasuredCells() const
{
    std::set<std::string> names;
    for (const CellResult& cell : cells)
    {
        names.insert(cell.id.Name());
    }
    return names;
}

std::vector<std::string> Study::MissingCells() const
{
    const std::set<std::string> measured = MeasuredCells();
    std::vector<std::string> missing;
    for (const CellId& id : planned)
    {
        if (std::string name = id.Name(); !measured.contains(name))
        {
            missing.push_back(std::move(name));
        }
    }
    return missing;
}

} // namespace limn::study
