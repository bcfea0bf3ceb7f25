#pragma once

#include <limn/core/Mesh.h>
#include <utility>

namespace limn
{

/// One vertex of a built-in shape.
struct PrimitiveVertex
{
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec3 tangent; ///< towards larger u
    glm::vec2 uv;      ///< v grows downwards, so that a picture stands upright
};

/// One point of the outline that a surface of revolution is swept from.
struct ProfilePoint
{
    float radius; ///< distance from the y axis
    float y;
    glm::vec2 normal; ///< (away from the axis, along y), unit length
    float v;
};

/// Collects the vertices and triangles of a built-in shape.
class MeshBuilder
{
public:
    std::uint32_t AddVertex(const PrimitiveVertex& vertex);

    /// Adds a triangle, clockwise as seen from outside.
    void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    /// Adds a grid of cells x cells squares. `right` and `up` are half the side, seen from outside.
    void AddGrid(glm::vec3 center, glm::vec3 right, glm::vec3 up, int cells);

    /// Sweeps `profile`, which runs from the top along the outside to the bottom, around the y
    /// axis. u = 0.5 faces -z. Points of radius 0 are poles.
    void AddRevolution(const std::vector<ProfilePoint>& profile, int segments);

    /// Adds a flat lid across the y axis that faces `side` (+1: up, -1: down).
    void AddDisc(float radius, float y, float side, int segments);

    MeshData Take() { return std::move(m_Data); }

private:
    MeshData m_Data;
};

} // namespace limn
