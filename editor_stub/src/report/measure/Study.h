#pragma once

#include <cstdint>
#include <limn/features/Technique.h>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limn::study
{

/// What a cell measures.
enum class CellKind
{
    Geometry,  ///< the drawn outline against the exact one of the asked width
    Numerical, ///< the drawn outline against the same algorithm in double precision
    Temporal,  ///< what changes while the picture moves by sixteenths of a pixel
    Cost,      ///< time and bytes
    Stability  ///< whether an extreme input is survived
};

const char* ToString(CellKind kind); ///< "geometry", ...
/// All words that ToString gives, in the order of the kinds.
std::span<const std::string_view> CellKindNames();

/// Variants of a cell of geometry in a scene where something stands in front of what is outlined:
/// the technique draws, and is held to, this part of the outline alone.
inline constexpr const char* k_SeenPart = "seen part";
inline constexpr const char* k_HiddenPart = "hidden part";

/// One thing that is measured on its own: what a shard takes or leaves, what an interrupted run
/// has or lacks. Its name is unique in a study and the same in every run.
struct CellId
{
    CellKind kind = CellKind::Geometry;
    std::string technique; ///< Technique::name
    std::string subject;   ///< what is outlined: "scene", or a shape's name
    double width = 0.0;    ///< pixels asked
    int pictureWidth = 0;  ///< pixels
    int pictureHeight = 0; ///< pixels
    std::string variant;   ///< what is unusual: "", "half", "standard Z", "100 objects", ...

    /// "geometry/Strokes/disc/8/1920x1080", behind it "/half" if there is a variant.
    std::string Name() const;
};

/// A figure's name in results, what it is called in tables, its unit.
struct Metric
{
    const char* key;   ///< "meanAbsoluteError"
    const char* title; ///< "mean error"
    const char* unit;  ///< "" for plain numbers, "ms", "px", "bytes", ...
    /// Differs from run to run: shards and a whole run agree in everything but these.
    bool isMeasured = false;
};

/// All figures there are, in the order of columns. Results may lack any of them.
const std::vector<Metric>& Metrics();
/// Null for a key that no metric has.
const Metric* FindMetric(std::string_view key);

/// What became of a cell.
struct CellResult
{
    CellId id;
    /// By Metric::key; NaN and infinities are kept.
    std::map<std::string, double> values;
    /// By metric, where a figure is a median: the lower and upper quartile.
    std::map<std::string, std::pair<double, double>> quartiles;
    /// Sentences: why there is no figure, what failed, what a stability cell was put through.
    std::vector<std::string> notes;
    /// PNG files relative to the study's folder: "picture", "reference", "difference".
    std::map<std::string, std::string> pictures;

    bool Has(const std::string& key) const { return values.contains(key); }
    double Value(const std::string& key) const; ///< NaN if it has none
};

/// Everything that was measured on one device.
struct Study
{
    std::string scene;     ///< as the user named it
    std::string sceneHash; ///< of all files it was read from; studies of others do not merge
    std::string device;    ///< name and driver
    std::string machine;   ///< processor, cores, system
    std::string limnVersion;
    std::string options;        ///< what decides about cells: "--quick --widths 2,8"
    std::string started;        ///< UTC, ISO 8601, the earliest of all parts
    double loadAverage = 0.0;   ///< one minute's, the largest while cost was measured
    double copyBandwidth = 0.0; ///< bytes read and written a second by a copy of a large texture
    std::vector<Technique> techniques; ///< files keep what comes before Technique::place
    std::vector<CellId> planned;       ///< all cells of all shards
    std::vector<CellResult> cells;     ///< those that are there, in the order of `planned`
};

} // namespace limn::study
