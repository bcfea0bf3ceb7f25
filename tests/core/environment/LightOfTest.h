#pragma once

#include "environment/CubeLight.h"

#include <glm/geometric.hpp>

namespace limn::test
{

/// Returns a cube whose texels have a function's value at their middles.
/// @param light  of a unit direction
template <typename Function>
CubeLight LightOf(int width, const Function& light)
{
    CubeLight cube(width);
    for (int face = 0; face < k_CubeFaces; ++face)
    {
        for (int y = 0; y < width; ++y)
        {
            for (int x = 0; x < width; ++x)
            {
                const glm::dvec3 direction = glm::normalize(glm::dvec3(cube.Direction(face, x, y)));
                cube.texels[cube.Index(face, x, y)] = glm::vec3(light(direction));
            }
        }
    }
    return cube;
}

/// Calls function(texel's middle, colour, solid angle) for each.
template <typename Function>
void ForEachTexel(const CubeLight& cube, const Function& function)
{
    for (int face = 0; face < k_CubeFaces; ++face)
    {
        for (int y = 0; y < cube.width; ++y)
        {
            for (int x = 0; x < cube.width; ++x)
            {
                // Of a texel seen from the middle of the cube: its area by the cosine and distance.
                const glm::dvec3 place(cube.Direction(face, x, y));
                const double area = 4.0 / (cube.width * cube.width);
                function(glm::normalize(place), glm::dvec3(cube.texels[cube.Index(face, x, y)]),
                         area / std::pow(glm::dot(place, place), 1.5));
            }
        }
    }
}

} // namespace limn::test
