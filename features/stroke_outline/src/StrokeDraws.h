#pragma once

#include "Silhouette.h"

#include <glm/vec4.hpp>
#include <limn/core/RTHandle.h>
#include <limn/features/OutlineRegion.h>
#include <span>
#include <vector>

namespace limn
{

/// How many vectors an array of a shader may have, the largest even number that Unity allows.
inline constexpr int k_ArrayLength = 1022;

/// A list of vectors in parts that fit a shader's array; an element of what is drawn takes
/// `stride` of them. Parts are filled up with elements that draw nothing, so that a list that is a
/// few elements longer than the last frame's is drawn by the same commands.
struct ShaderArrays
{
    int stride = 1;
    std::vector<std::vector<glm::vec4>> parts;

    void Assign(std::span<const glm::vec4> values, const glm::vec4& nothing);
};

/// What one group's outline is drawn from.
struct StrokeDraws
{
    OutlineRegion region;
    std::span<const OutlinedObject> objects;
    int edgeCount = 0;
    double strokeArea = 0.0; ///< pixels
    /// Two vectors each: ends in pixels of the region; how far it goes on beyond them (negative:
    /// there is none) and their device depths.
    ShaderArrays strokes{2, {}};
    ShaderArrays tiles{1, {}}; ///< left, top, right, bottom in pixels of the region
    RTHandle depth;
    RTHandle coverage;
    RTHandle edges;

    /// @param strokes  of the group; those out of reach of the picture are left out
    /// @param width    of the outline, pixels
    /// @return false if none is left
    bool Assign(std::vector<Stroke>& strokes, double width, const glm::ivec2& picture);
};

} // namespace limn
