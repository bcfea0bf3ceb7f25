#pragma once

#include "features/OutlineGpuReference.h"

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace limn::test
{

/// A triangle in pixels, y down, at one distance from the camera; any winding.
struct FlatTriangle
{
    std::array<glm::dvec2, 3> points;
    double distance = 0.0;
};

/// What the effect does to a picture, written down a second time, apart from Vulkan: a rasteriser
/// with the bottom-left rule on corners rounded to 1/256 pixel, a depth buffer of distances, the
/// stencil, and blending by alpha in doubles.
class StencilModel
{
public:
    StencilModel(int width, int height, const glm::dvec4& background);

    /// Opaque, in front of what is farther away.
    void DrawOpaque(const FlatTriangle& triangle, const glm::dvec4& color);
    /// Behind what is opaque it does not show.
    void DrawTransparent(const FlatTriangle& triangle, const glm::dvec4& color);
    /// 255 wherever the hull is, seen or not.
    void MaskHull(const FlatTriangle& triangle);
    /// From 255 to 254 where the solid is seen.
    void MaskSolid(const FlatTriangle& triangle);
    /// Colour where 255 is left.
    void DrawBand(const FlatTriangle& triangle, const glm::dvec4& color);
    /// Colour where 254 is left, which becomes 253.
    void DrawSolid(const FlatTriangle& triangle, const glm::dvec4& color);

    const Field& color() const { return m_Color; }
    int StencilAt(int x, int y) const
    {
        return m_Stencil.at(static_cast<std::size_t>(y * m_Color.width + x));
    }

private:
    template <typename Visit>
    void Rasterise(const FlatTriangle& triangle, Visit&& visit);
    void Blend(int x, int y, const glm::dvec4& color);

    Field m_Color;
    std::vector<int> m_Stencil;
    std::vector<double> m_Depth;
};

} // namespace limn::test
