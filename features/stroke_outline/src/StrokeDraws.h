#pragma once

#include "Silhouette.h"

#include <glm/vec4.hpp>
#include <limn/features/OutlineRegion.h>
#include <span>
#include <vector>

namespace limn
{

/// The greatest number of vectors in an array of a shader: the largest even number that Unity
/// allows.
inline constexpr int k_ArrayLength = 1022;

/// A list of vectors in parts that fit a shader's array; each drawn element takes `stride` of them.
/// Parts are filled up with elements that draw nothing, so that the same commands draw a list that
/// is a few elements longer than the last frame's.
struct ShaderArrays
{
    int stride = 1;
    std::vector<std::vector<glm::vec4>> parts;

    void Assign(std::span<const glm::vec4> values, const glm::vec4& nothing);
};

/// The data from which one group's outline is drawn.
struct StrokeDraws
{
    OutlineRegion region;
    std::span<const OutlinedObject> objects;
    int edgeCount = 0;
    double strokeArea = 0.0; ///< pixels
    /// The strokes, two vectors each: the ends in pixels of the region; how far the stroke goes on
    /// beyond them (negative: there is no stroke) and their device depths.
    ShaderArrays strokes{2, {}};
    ShaderArrays tiles{1, {}}; ///< the tiles: left, top, right, bottom in pixels of the region
    RTHandle depth;
    RTHandle coverage;
    RTHandle edges;

    /// @param strokes  the strokes of the group; those out of reach of the picture are ignored
    /// @param width    the width of the outline in pixels
    /// @return false if no stroke is left
    bool Assign(std::vector<Stroke>& strokes, double width, const glm::ivec2& picture);
};

} // namespace limn
