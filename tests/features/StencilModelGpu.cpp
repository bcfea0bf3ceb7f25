#include "features/StencilModel.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace limn::test
{

namespace
{

constexpr double k_Grid = 256.0;

struct GridPoint
{
    std::int64_t x = 0;
    std::int64_t y = 0;
};

GridPoint ToGrid(const glm::dvec2& point)
{
    return {std::llround(point.x * k_Grid), std::llround(point.y * k_Grid)};
}

/// Whether a point is inside the edge from a to b of a triangle that is clockwise on the screen;
/// points on it belong to left edges and, as the first row of a target is the bottom of the
/// picture, to bottom ones.
bool IsInside(const GridPoint& a, const GridPoint& b, const GridPoint& point)
{
    const std::int64_t side = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
    const bool isBottom = a.y == b.y && b.x < a.x;
    const bool isLeft = b.y < a.y;
    return side > 0 || (side == 0 && (isBottom || isLeft));
}

} // namespace

StencilModel::StencilModel(int width, int height, const glm::dvec4& background)
    : m_Color{width, height, 4, {}}
{
    const auto count = static_cast<std::size_t>(width * height);
    for (std::size_t i = 0; i < count; ++i)
    {
        m_Color.values.insert(m_Color.values.end(),
                              {background.r, background.g, background.b, background.a});
    }
    m_Stencil.assign(count, 0);
    m_Depth.assign(count, std::numeric_limits<double>::infinity());
}

template <typename Visit>
void StencilModel::Rasterise(const FlatTriangle& triangle, Visit&& visit)
{
    std::array<GridPoint, 3> p = {ToGrid(triangle.points[0]), ToGrid(triangle.points[1]),
                                  ToGrid(triangle.points[2])};
    const std::int64_t area =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0)
    {
        return;
    }
    if (area < 0)
    {
        std::swap(p[1], p[2]);
    }
    for (int y = 0; y < m_Color.height; ++y)
    {
        for (int x = 0; x < m_Color.width; ++x)
        {
            const GridPoint centre = ToGrid({x + 0.5, y + 0.5});
            if (IsInside(p[0], p[1], centre) && IsInside(p[1], p[2], centre) &&
                IsInside(p[2], p[0], centre))
            {
                const auto i = static_cast<std::size_t>(y * m_Color.width + x);
                visit(x, y, m_Stencil[i], triangle.distance <= m_Depth[i]);
            }
        }
    }
}

void StencilModel::Blend(int x, int y, const glm::dvec4& color)
{
    for (int channel = 0; channel < 4; ++channel)
    {
        double& value = m_Color.At(x, y, channel);
        value = color[channel] * color.a + value * (1.0 - color.a);
    }
}

void StencilModel::DrawOpaque(const FlatTriangle& triangle, const glm::dvec4& color)
{
    Rasterise(triangle,
              [&](int x, int y, int&, bool isSeen)
              {
                  for (int channel = 0; isSeen && channel < 4; ++channel)
                  {
                      m_Color.At(x, y, channel) = color[channel];
                  }
                  const auto i = static_cast<std::size_t>(y * m_Color.width + x);
                  m_Depth[i] = isSeen ? triangle.distance : m_Depth[i];
              });
}

void StencilModel::DrawTransparent(const FlatTriangle& triangle, const glm::dvec4& color)
{
    Rasterise(triangle,
              [&](int x, int y, int&, bool isSeen)
              {
                  if (isSeen)
                  {
                      Blend(x, y, color);
                  }
              });
}

void StencilModel::MaskHull(const FlatTriangle& triangle)
{
    Rasterise(triangle, [](int, int, int& stencil, bool) { stencil = 255; });
}

void StencilModel::MaskSolid(const FlatTriangle& triangle)
{
    Rasterise(triangle, [](int, int, int& stencil, bool isSeen)
              { stencil -= isSeen && stencil == 255 ? 1 : 0; });
}

void StencilModel::DrawBand(const FlatTriangle& triangle, const glm::dvec4& color)
{
    Rasterise(triangle,
              [&](int x, int y, int& stencil, bool isSeen)
              {
                  if (isSeen && stencil == 255)
                  {
                      Blend(x, y, color);
                  }
              });
}

void StencilModel::DrawSolid(const FlatTriangle& triangle, const glm::dvec4& color)
{
    Rasterise(triangle,
              [&](int x, int y, int& stencil, bool isSeen)
              {
                  if (isSeen && stencil == 254)
                  {
                      Blend(x, y, color);
                      --stencil;
                  }
              });
}

} // namespace limn::test
