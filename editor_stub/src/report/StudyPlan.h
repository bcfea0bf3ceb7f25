#pragma once

#include "report/measure/Study.h"

#include <glm/vec2.hpp>
#include <span>

namespace limn::study
{

/// The options that decide which cells there are.
struct StudyOptions
{
    bool isQuick = false;      ///< takes under a minute on a software rasteriser
    bool isFull = false;       ///< tries all combinations of extreme inputs, not all pairs
    bool hasStability = false; ///< only the stability cells, and no others
    std::vector<std::string> techniques; ///< their names; empty = all
    glm::ivec2 sceneSize{0};             ///< of the scene's picture, in pixels
    bool isPartlyHidden = false;         ///< true if something hides a part of the scene's outline

    /// Returns a text that is the same for the same cells: "quick, 1280x720, Strokes, Selection".
    std::string Text() const;
    /// Returns the least number of frames of each technique in a cell of cost. Cells by which
    /// techniques are compared get more.
    int RoundsOf(const CellId& cell) const;
};

/// Returns all cells. Those of one reference are side by side, their techniques one after the
/// other.
/// @param techniques  the techniques from which StudyOptions::techniques selects
std::vector<CellId> PlanStudy(const StudyOptions& options, std::span<const Technique> techniques);

/// Returns words for people: "flicker of Strokes around a disc, 8 pixels wide, picture 160x90".
/// The cells are one of UnitsOf's groups.
std::string UnitText(std::span<const CellId> unit);

/// Returns the cells in groups that are measured together. Cells of cost that differ only in their
/// technique form a group, so that the techniques' frames take turns. Every other cell is alone.
std::vector<std::vector<CellId>> UnitsOf(const std::vector<CellId>& cells);

} // namespace limn::study
