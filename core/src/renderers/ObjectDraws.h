#pragma once

#include "resolve/DrawRecorder.h"

#include <limn/core/Culling.h>

#include <memory_resource>

namespace limn
{

/// Instances with the same pass, mesh and winding.
struct ObjectBatch
{
    std::uint32_t pass = 0;
    std::uint32_t meshPart = 0; ///< of the table
    bool isMirrored = false;
    std::uint32_t first = 0; ///< index of the first row
    std::uint32_t count = 0;
};

/// Consecutive rows that draw the same except for their place.
struct ClassRun
{
    std::uint32_t rowClass = 0; ///< of the table: the first of those that they have
    std::uint32_t first = 0;    ///< index of the first item
    std::uint32_t count = 0;
    /// The number of the passes to draw: the class's number, unless lights differ.
    std::uint32_t passes = 0;
};

/// The passes that a renderer draws, in order: indices of one call's list.
using PassNumbers = std::pmr::vector<std::uint32_t>;

/// Returns an empty list that keeps its memory for the thread's next call of the functions that
/// draw objects. Only one user at a time may have a list of each kind.
template <typename Value>
std::vector<Value>& ThreadScratch()
{
    static thread_local std::vector<Value> list;
    list.clear();
    return list;
}

/// Sorts items into the order in which a DrawRenderers call draws, and returns all runs, which are
/// valid until the thread's next call. The sort is stable.
std::span<const ClassRun> SortIntoRuns(RendererItems& items, const SortingSettings& sorting);

/// Makes batches of what rows draw. Draws that may change places become one batch, at the place of
/// the first, whatever lies between them; others only if they are consecutive.
/// @param items     in the order in which they are drawn
/// @param runs      all of them
/// @param passesOf  by ClassRun::passes: the passes that each of its rows draws, in this order
/// @param commutes  by pass: passes with equal numbers other than 0 give the same picture in any
///     order
/// @param rows      the batches' rows of the table are appended to it
/// @return the batches in the order in which they are drawn, valid until the thread's next call
std::span<const ObjectBatch> MakeBatches(const RendererItems& items, std::span<const ClassRun> runs,
                                         const std::pmr::vector<PassNumbers>& passesOf,
                                         const std::vector<std::uint32_t>& commutes,
                                         std::vector<std::uint32_t>& rows);

/// Appends the draws of a DrawRenderers call.
/// @param items  in the order in which they are drawn; not empty
/// @param runs   all of them
void DrawObjects(const RendererItems& items, std::span<const ClassRun> runs,
                 const DrawingSettings& drawing, const RenderStateBlock& stateBlock,
                 DrawRecorder& recorder);

} // namespace limn
