#include "SampleStudy.h"

#include <cmath>

namespace limn::test
{

namespace
{

using study::CellKind;
using study::Study;

/// What a technique's figures are made from.
struct MadeUp
{
    const char* name;
    bool isArticle;
    const char* noWidth;
    double error; ///< at 8 px
    double time;  ///< ms
};

constexpr double k_NoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double k_Infinite = std::numeric_limits<double>::infinity();
constexpr MadeUp k_MadeUp[] = {
    {"Strokes", false, "", 0.0001, 1.7},
    {"Separable", false, "", 0.012, 14.7},
    {"Jump flood", false, "", 0.0125, 17.0},
    {"Auto", false, "", 0.0, 1.9},
    {"Inflated", false, "", 0.08, 1.1},
    {"Screen space", true, "", 0.53, 2.2},
    {"Selection", true, "", 0.6, 9.0},
    {"Mask difference", true, "", 0.51, 2.6},
    {"Depth and normals (article)", true, "its lines lie on both sides", k_NoNumber, 21.0},
    {"Rim", false, "it is as wide as the object is curved", k_NoNumber, 0.9},
    {"<i>A</i> & \"|\" `x` = 1, 2", false, "", 0.3, -0.02},
    {"Fails", false, "", k_Infinite, 4.0},
};

void AddGeometry(Study& sample, const MadeUp& technique, const std::string& subject, double width,
                 const std::string& variant = "")
{
    const bool isScene = subject == "scene";
    const double error = technique.error * std::sqrt(8.0 / width) * (isScene ? 1.0 : 1.3);
    study::CellResult& cell = AddCell(sample,
                                      {CellKind::Geometry, technique.name, subject, width,
                                       isScene ? 1280 : 480, isScene ? 720 : 270, variant},
                                      {});
    if (std::isnan(error))
    {
        cell.notes.emplace_back("not compared: " + std::string(technique.noWidth));
        return;
    }
    cell.values = {{"meanAbsoluteError", error},
                   {"rootMeanSquare", error * 1.5},
                   {"percentile99", error * 1.8},
                   {"largest", std::min(1.0, error * 2.0)},
                   {"intersectionOverUnion", 1.0 - error},
                   {"areaRatio", 1.0 + error / 2.0},
                   {"effectiveWidth", width * (1.0 + error)},
                   {"effectiveWidthSpread", error},
                   {"contourInner", error / 3.0},
                   {"contourOuter", error / 2.0},
                   {"hausdorff", error * 4.0},
                   {"bandPixels", 10000.0}};
}

void AddCost(Study& sample, const MadeUp& technique, double width, int pictureWidth,
             int pictureHeight, double factor, const std::string& variant = "")
{
    const double time = technique.time * factor;
    study::CellResult& cell =
        AddCell(sample,
                {CellKind::Cost, technique.name, variant.empty() ? "scene" : "balls", width,
                 pictureWidth, pictureHeight, variant},
                {{"gpuMilliseconds", 30.0 * factor + time},
                 {"gpuAddedMilliseconds", time},
                 {"gpuAddedUncertainty", std::abs(time) * 0.1},
                 {"cpuRecordMilliseconds", 0.3},
                 {"cpuAddedMilliseconds", 0.05},
                 {"cpuAddedUncertainty", 0.01},
                 {"quietMilliseconds", 30.0 * factor},
                 {"busyMilliseconds", 95.0 * factor},
                 {"quietPart", 0.42},
                 {"otherPrograms", 1.5},
                 {"passes", 3.0},
                 {"draws", 4.0},
                 {"targetBytes", 8294400.0},
                 {"movedBytes", 24883200.0},
                 {"floorMilliseconds", 0.03}});
    cell.quartiles["gpuAddedMilliseconds"] = {time * 0.93, time * 1.15};
}

void AddStability(Study& sample, const MadeUp& technique)
{
    for (int i = 0; i < 20; ++i)
    {
        const bool fails = technique.isArticle && i % 7 == 0;
        study::CellResult& cell =
            AddCell(sample,
                    {CellKind::Stability, technique.name, "scene", i % 2 == 0 ? 8.0 : k_Infinite, 3,
                     7, "ratio=1e+" + std::to_string(i) + " fov=170 view=oblique"},
                    {{"badTexels", fails ? 21.0 : 0.0}, {"failures", fails ? 1.0 : 0.0}});
        if (fails)
        {
            cell.notes.emplace_back("21 of 21 texels are NaN: pow of a negative number");
        }
    }
}

} // namespace

Study ThreeTechniques()
{
    Study sample = EmptySample();
    for (const char* name : {"Slow", "Quick", "Bad", "Unmeasured"})
    {
        AddTechnique(sample, name);
    }
    AddPoint(sample, "Slow", 8.0, 10.0, 0.001);
    AddPoint(sample, "Quick", 8.0, 1.0, 0.1);
    AddPoint(sample, "Bad", 8.0, 12.0, 0.5);
    return sample;
}

Study FullSample()
{
    Study sample = EmptySample();
    for (const MadeUp& technique : k_MadeUp)
    {
        AddTechnique(sample, technique.name, technique.isArticle, technique.noWidth);
    }
    for (const MadeUp& technique : k_MadeUp)
    {
        for (const double width : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0})
        {
            for (const char* subject : {"scene", "disc", "needle"})
            {
                AddGeometry(sample, technique, subject, width);
            }
        }
        AddGeometry(sample, technique, "disc", 8.0, "half");
        AddCost(sample, technique, 8.0, 320, 180, 0.0625);
        AddCost(sample, technique, 8.0, 640, 360, 0.25);
        AddCost(sample, technique, 8.0, 1280, 720, 1.0);
        AddCost(sample, technique, 8.0, 1920, 1080, 2.2);
        for (const int count : {1, 10, 100, 1000})
        {
            AddCost(sample, technique, 4.0, 1280, 720, std::sqrt(count),
                    std::to_string(count) + " objects");
        }
        AddStability(sample, technique);
        if (!std::isnan(technique.error))
        {
            AddCell(sample, {CellKind::Temporal, technique.name, "disc", 8.0, 160, 90, ""},
                    {{"flicker", technique.error / 3.0}, {"areaWobble", technique.error / 5.0}});
            AddCell(sample, {CellKind::Temporal, technique.name, "needle", 8.0, 160, 90, ""},
                    {{"flicker", technique.error / 2.0}, {"areaWobble", technique.error / 4.0}});
            AddCell(
                sample, {CellKind::Numerical, technique.name, "disc", 8.0, 480, 270, "half"},
                {{"numericalMean", technique.error / 100.0},
                 {"numericalLargest",
                  technique.name == std::string("Fails") ? k_NoNumber : technique.error / 10.0}});
        }
    }
    return sample;
}

} // namespace limn::test
