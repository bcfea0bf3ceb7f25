#pragma once

#include "report/measure/Study.h"

#include <glm/vec2.hpp>

namespace limn::study
{

/// What decides which cells there are.
struct StudyOptions
{
    bool isQuick = false;                ///< under a minute on a software rasteriser
    bool isFull = false;                 ///< all combinations of extreme inputs, not all pairs
    bool hasStability = false;           ///< the stability cells, and no others
    std::vector<std::string> techniques; ///< names; empty = all
    glm::ivec2 sceneSize{0};             ///< of the scene's picture, pixels
    bool isPartlyHidden = false;         ///< something hides a part of the scene's outline

    /// The same text for the same cells: "quick, 1280x720, Strokes, Selection".
    std::string Text() const;
    /// Of cells of cost: frames of each technique, at least. Those that techniques are compared by
    /// get more.
    int RoundsOf(const CellId& cell) const;
};

/// All cells, those of one reference side by side, their techniques one after the other.
/// @param techniques  of which StudyOptions::techniques takes some
std::vector<CellId> PlanStudy(const StudyOptions& options, std::span<const Technique> techniques);

/// Cells that are measured together: those of cost that differ in their technique only, so that the
/// techniques' frames take turns; any other one is alone.
std::vector<std::vector<CellId>> UnitsOf(const std::vector<CellId>& cells);

} // namespace limn::study
