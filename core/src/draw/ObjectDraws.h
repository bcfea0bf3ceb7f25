#pragma once

#include "draw/DrawRecorder.h"

#include <limn/core/Culling.h>

namespace limn
{

/// Instances of one pass, mesh and winding.
struct ObjectBatch
{
    std::uint32_t pass = 0;
    std::uint32_t meshPart = 0; ///< of the table
    bool isMirrored = false;
    std::uint32_t first = 0; ///< in ObjectBatches::rows
    std::uint32_t count = 0;
};

struct ObjectBatches
{
    std::vector<ObjectBatch> batches; ///< in the order in which they are drawn
    std::vector<std::uint32_t> rows;  ///< of the table
};

/// What rows draw. Draws that may change places become one batch whatever lies between them, at
/// the place of the first; others only where they follow upon each other.
/// @param items     in the order in which they are drawn
/// @param passesOf  by the table's class: the passes that each of its rows draws, in this order
/// @param commutes  by pass: passes of equal numbers other than 0 give the same picture in any
///                  order
ObjectBatches MakeBatches(const RendererItems& items,
                          const std::vector<std::vector<std::uint32_t>>& passesOf,
                          const std::vector<std::uint32_t>& commutes);

/// Appends the draws of a DrawRenderers call.
/// @param items  in the order in which they are drawn; not empty
void DrawObjects(const RendererItems& items, const DrawingSettings& drawing,
                 const RenderStateBlock& stateBlock, DrawRecorder& recorder);

} // namespace limn
