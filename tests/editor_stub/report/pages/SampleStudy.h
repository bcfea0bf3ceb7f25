#pragma once

#include "report/measure/Study.h"

#include <cmath>
#include <limits>
#include <utility>

namespace limn::test
{

/// A study with what every kind of cell may hold, all figures made up; names try to break out of
/// HTML, Markdown, CSV and gnuplot.
inline study::Study EmptySample()
{
    study::Study sample;
    sample.scene = "a <b>\"scene\"</b> & more, `|x|`.yaml";
    sample.sceneHash = "0123456789abcdef";
    sample.device = "a device (driver 1.2)";
    sample.machine = "2 cores";
    sample.limnVersion = "9.9";
    sample.options = "--widths 2,8";
    sample.started = "2026-11-22T22:00:00Z";
    sample.loadAverage = 0.5;
    sample.copyBandwidth = 1e10;
    return sample;
}

inline void AddTechnique(study::Study& sample, const std::string& name, bool isArticle = false,
                         const std::string& noWidth = "")
{
    sample.techniques.push_back(
        {name, name + "RendererFeature", name + "'s way", isArticle, noWidth});
}

inline study::CellResult& AddCell(study::Study& sample, study::CellId id,
                                  std::map<std::string, double> values)
{
    sample.planned.push_back(id);
    sample.cells.push_back({std::move(id), std::move(values), {}, {}, {}});
    return sample.cells.back();
}

/// Its error and its time at a width, which is known to a tenth of itself: two cells.
inline void AddPoint(study::Study& sample, const std::string& technique, double width,
                     double milliseconds, double error)
{
    AddCell(sample, {study::CellKind::Geometry, technique, "scene", width, 640, 360, ""},
            {{"meanAbsoluteError", error}});
    AddCell(sample, {study::CellKind::Cost, technique, "scene", width, 640, 360, ""},
            {{"gpuAddedMilliseconds", milliseconds},
             {"gpuAddedUncertainty", std::abs(milliseconds) * 0.1},
             {"quietMilliseconds", 30.0},
             {"busyMilliseconds", 33.0},
             {"quietPart", 0.95},
             {"otherPrograms", 0.01},
             {"floorMilliseconds", 0.25}})
        .quartiles["gpuAddedMilliseconds"] = {milliseconds * 0.9, milliseconds * 1.2};
}

/// One technique is slow and near, one quick, one bad, one not measured, each 8 px wide.
study::Study ThreeTechniques();

/// Every kind of cell, as many as a real study has; "Fails" has NaN, infinite and zero figures.
study::Study FullSample();

} // namespace limn::test
