#pragma once

#include <limn/features/Technique.h>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limn::study
{

/// The kinds of measurements in cells.
enum class CellKind
{
    Geometry,  ///< the drawn outline against the exact one of the asked width
    Numerical, ///< the drawn outline against the same algorithm in double precision
    Temporal,  ///< the changes while the picture moves by sixteenths of a pixel
    Cost,      ///< time and bytes
    Stability  ///< extreme inputs, which must be survived
};

/// The words that ToString returns, in the order of the kinds.
inline constexpr std::string_view k_CellKindNames[] = {"geometry", "numerical", "temporal", "cost",
                                                       "stability"};
const char* ToString(CellKind kind); ///< returns "geometry", ...

/// Returns the size of a picture as text: "1280x720".
std::string SizeText(int width, int height);

/// The variants of a cell of geometry in a scene where something is in front of the outlined
/// objects. The technique draws only this part of the outline, and is compared with this part.
inline constexpr const char* k_SeenPart = "seen part";
inline constexpr const char* k_HiddenPart = "hidden part";

/// The identity of a cell: one thing that is measured on its own. A shard measures a cell or leaves
/// it to another shard; an interrupted run has it or lacks it. Its name is unique in a study and
/// the same in every run.
struct CellId
{
    CellKind kind = CellKind::Geometry;
    std::string technique; ///< Technique::name
    std::string subject;   ///< the outlined object: "scene", or a shape's name
    double width = 0.0;    ///< the wanted width in pixels
    int pictureWidth = 0;  ///< pixels
    int pictureHeight = 0; ///< pixels
    std::string variant;   ///< the unusual setting: "", "half", "standard Z", "100 objects", ...

    /// Returns the name "geometry/Strokes/disc/8/1920x1080", with "/half" behind it if there is a
    /// variant.
    std::string Name() const;
    /// Returns the name without the technique, which cells share that are measured in turn.
    std::string NameForAllTechniques() const;
};

/// A figure: its name in results, its title in tables and its unit.
struct Metric
{
    const char* key;   ///< "meanAbsoluteError"
    const char* title; ///< "mean error"
    const char* unit;  ///< "" for plain numbers, "ms", "px", "bytes", ...
    /// Set if the figure differs from run to run. Shards and a whole run agree in everything else.
    bool isMeasured = false;
};

/// Returns all figures, in the order of columns. Results may lack any of them.
const std::vector<Metric>& Metrics();

/// The result of a cell.
struct CellResult
{
    CellId id;
    /// The figures by Metric::key. NaN and infinities are kept.
    std::map<std::string, double> values = {};
    /// The lower and the upper quartile by Metric::key, for figures that are medians.
    std::map<std::string, std::pair<double, double>> quartiles = {};
    /// Sentences: why there is no figure, what failed, what a stability cell was put through.
    std::vector<std::string> notes = {};
    /// PNG files relative to the study's folder: "picture", "reference", "difference",
    /// and of the scene "closeUp" and "scene".
    std::map<std::string, std::string> pictures = {};

    bool Has(const std::string& key) const { return values.contains(key); }
    double Value(const std::string& key) const; ///< NaN if there is none
    /// Returns two NaN if there are none.
    std::pair<double, double> Quartiles(const std::string& key) const;
};

/// All that was measured on one device.
struct Study
{
    std::string scene; ///< as the user named it
    /// The hash of all files it was read from; studies with different hashes do not merge.
    std::string sceneHash;
    std::string device;  ///< name and driver
    std::string machine; ///< processor, cores, system
    std::string limnVersion;
    std::string options; ///< the options that decide about cells: "--quick --widths 2,8"
    std::string started; ///< UTC, ISO 8601, the earliest of all parts
    /// The load average of one minute, the largest while cost was measured.
    double loadAverage = 0.0;
    double copyBandwidth = 0.0; ///< bytes that a copy of a large texture reads and writes a second
    std::vector<Technique> techniques; ///< files store the members before Technique::place
    std::vector<CellId> planned;       ///< all cells of all shards
    std::vector<CellResult> cells;     ///< the measured ones, in the order of `planned`

    /// Returns the names of the measured cells, which tell them apart: a width may be NaN.
    std::set<std::string> MeasuredCells() const;
    /// Returns the names of the planned cells that are not measured.
    std::vector<std::string> MissingCells() const;
};

} // namespace limn::study
