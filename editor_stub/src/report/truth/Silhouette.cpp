#include "report/truth/Silhouette.h"

#include <cmath>
#include <glm/ext/scalar_constants.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <span>
#include <tuple>

namespace limn::study
{

namespace
{

using Segment = std::array<glm::dvec2, 2>;

constexpr double k_Aside = 1e-6; ///< pixels; to see what is on either side of an edge

glm::dvec2 NearestOf(const Segment& segment, const glm::dvec2& point)
{
    const glm::dvec2 along = segment[1] - segment[0];
    const double t = glm::dot(point - segment[0], along) / glm::dot(along, along);
    return segment[0] + along * std::clamp(t, 0.0, 1.0);
}

/// The edges that do not have a triangle on both sides already because two share them.
std::vector<Segment> EdgesOfOneSide(const ScreenTriangles& triangles)
{
    std::map<std::array<double, 4>, int> sides; // 1: a triangle on its left, 2: on its right
    for (const auto& triangle : triangles)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            glm::dvec2 a = triangle[i];
            glm::dvec2 b = triangle[(i + 1) % 3];
            if (std::tie(b.x, b.y) < std::tie(a.x, a.y))
            {
                std::swap(a, b);
            }
            const bool isLeft = Cross(b - a, triangle[(i + 2) % 3] - a) > 0.0;
            sides[{a.x, a.y, b.x, b.y}] |= isLeft ? 1 : 2;
        }
    }
    std::vector<Segment> result;
    for (const auto& [ends, where] : sides)
    {
        if (where != 3)
        {
            result.push_back({glm::dvec2(ends[0], ends[1]), glm::dvec2(ends[2], ends[3])});
        }
    }
    return result;
}

/// Adds the places along `segment`, 0...1, where the other one crosses, touches or leaves it.
void AddCuts(const Segment& segment, const Segment& other, std::vector<double>& cuts)
{
    const glm::dvec2 along = segment[1] - segment[0];
    const glm::dvec2 across = other[1] - other[0];
    const glm::dvec2 between = other[0] - segment[0];
    const double area = Cross(along, across);
    if (std::abs(area) > 1e-14 * glm::length(along) * glm::length(across))
    {
        const double t = Cross(between, across) / area;
        const double s = Cross(between, along) / area;
        const double margin = k_Touching / glm::length(across);
        if (s > -margin && s < 1.0 + margin && t > 0.0 && t < 1.0)
        {
            cuts.push_back(t);
        }
    }
    for (const glm::dvec2& end : other)
    {
        const double t = glm::dot(end - segment[0], along) / glm::dot(along, along);
        if (t > 0.0 && t < 1.0 && glm::distance(NearestOf(segment, end), end) < k_Touching)
        {
            cuts.push_back(t);
        }
    }
}

constexpr double k_Pi = glm::pi<double>();

/// The corners of a regular polygon of the disc's area whose middle of an edge is 5e-5 pixels, at
/// most, off the circle.
std::vector<glm::dvec2> Circle(const glm::dvec2& center, double radius, std::size_t atLeast = 16)
{
    const auto count = std::max(
        atLeast, 2 * static_cast<std::size_t>(std::ceil(k_Pi / 2.0 * std::sqrt(radius / 1e-4))));
    const double step = 2.0 * k_Pi / static_cast<double>(count);
    const double corner = radius * std::sqrt(step / std::sin(step));
    std::vector<glm::dvec2> corners;
    for (std::size_t i = 0; i < count; ++i)
    {
        const double angle = step * (static_cast<double>(i) + 0.5);
        corners.push_back(center + corner * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

void AddQuad(ScreenTriangles& triangles, const glm::dvec2& a, const glm::dvec2& b,
             const glm::dvec2& c, const glm::dvec2& d)
{
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
}

/// Returns the part of a polygon where dot(plane, corner) >= 0.
std::vector<glm::dvec4> Clip(const std::vector<glm::dvec4>& polygon, const glm::dvec4& plane)
{
    std::vector<glm::dvec4> result;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const glm::dvec4& a = polygon[i];
        const glm::dvec4& b = polygon[(i + 1) % polygon.size()];
        const double da = glm::dot(plane, a);
        const double db = glm::dot(plane, b);
        if (da >= 0.0)
        {
            result.push_back(a);
        }
        if ((da >= 0.0) != (db >= 0.0))
        {
            // From the inner end, whichever triangle asks: both get the same point.
            result.push_back(da >= 0.0 ? a + (b - a) * (da / (da - db))
                                       : b + (a - b) * (db / (db - da)));
        }
    }
    return result;
}

/// Returns the triangles that the indices are of, cut at the near and the far plane.
std::vector<DepthTriangle> Project(const MeshData& data, std::span<const std::uint32_t> indices,
                                   const Transform& transform, const Camera& camera, int width,
                                   int height)
{
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const glm::dmat4 toClip = glm::dmat4(camera.gpuProjectionMatrix(aspect)) * camera.viewMatrix() *
                              transform.worldMatrix();
    std::vector<DepthTriangle> triangles;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    {
        std::vector<glm::dvec4> polygon;
        for (std::size_t k = 0; k < 3; ++k)
        {
            polygon.push_back(toClip * glm::dvec4(data.vertices[indices[i + k]], 1.0));
        }
        polygon = Clip(polygon, {0.0, 0.0, -1.0, 1.0}); // near: z is w there
        polygon = Clip(polygon, {0.0, 0.0, 1.0, 0.0});  // far: z is 0 there
        const auto pixel = [&](std::size_t corner)
        {
            const glm::dvec4& p = polygon[corner];
            return glm::dvec3((p.x / p.w * 0.5 + 0.5) * width, (0.5 - p.y / p.w * 0.5) * height,
                              p.z / p.w);
        };
        for (std::size_t k = 2; k < polygon.size(); ++k)
        {
            triangles.push_back({pixel(0), pixel(k - 1), pixel(k)});
        }
    }
    return triangles;
}

} // namespace

Silhouette::Silhouette(const ScreenTriangles& triangles)
{
    for (const auto& triangle : triangles)
    {
        if (std::abs(Cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) > 1e-12)
        {
            m_Triangles.push_back(triangle);
            m_Bounds.Add(BoxOf(triangle));
        }
    }
    m_TriangleTree = TreeOf(m_Triangles);
    const std::vector<Segment> edges = EdgesOfOneSide(m_Triangles);
    const BoxTree tree = TreeOf(edges);
    for (const Segment& edge : edges)
    {
        std::vector<double> cuts{0.0, 1.0};
        tree.AnyTouching(BoxOf(edge),
                         [&](std::size_t other)
                         {
                             AddCuts(edge, edges[other], cuts);
                             return false;
                         });
        std::sort(cuts.begin(), cuts.end());
        const glm::dvec2 along = edge[1] - edge[0];
        const double length = glm::length(along);
        const glm::dvec2 aside = glm::dvec2(-along.y, along.x) * (k_Aside / length);
        for (std::size_t i = 1; i < cuts.size(); ++i)
        {
            const Segment piece{edge[0] + along * cuts[i - 1], edge[0] + along * cuts[i]};
            const glm::dvec2 middle = 0.5 * (piece[0] + piece[1]);
            if ((cuts[i] - cuts[i - 1]) * length > k_Touching &&
                Contains(middle + aside) != Contains(middle - aside))
            {
                m_Border.push_back(piece);
            }
        }
    }
    m_BorderTree = TreeOf(m_Border);
}

bool Silhouette::Contains(const glm::dvec2& point) const
{
    return m_TriangleTree.AnyTouching(Box{point, point}, [&](std::size_t index)
                                      { return IsInTriangle(m_Triangles[index], point); });
}

bool IsInTriangle(const std::array<glm::dvec2, 3>& corners, const glm::dvec2& point)
{
    const double area = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2 along = corners[(i + 1) % 3] - corners[i];
        const double side = Cross(along, point - corners[i]) * (area > 0.0 ? 1.0 : -1.0);
        if (side < -k_Touching * glm::length(along))
        {
            return false;
        }
    }
    return true;
}

double Silhouette::SignedDistance(const glm::dvec2& point, double limit, glm::dvec2* nearest) const
{
    double least = limit;
    m_BorderTree.Nearest(point, least,
                         [&](std::size_t index)
                         {
                             const glm::dvec2 candidate = NearestOf(m_Border[index], point);
                             const double distance = glm::distance(candidate, point);
                             if (distance < least)
                             {
                                 least = distance;
                                 if (nearest != nullptr)
                                 {
                                     *nearest = candidate;
                                 }
                             }
                         });
    return Contains(point) ? -least : least;
}

ScreenTriangles DiscTriangles(const glm::dvec2& center, double radius)
{
    // In slices from one side to the other: no corner is in more than a few triangles.
    const std::vector<glm::dvec2> circle = Circle(center, radius);
    const std::size_t last = circle.size() - 1;
    ScreenTriangles triangles;
    for (std::size_t i = 0; i < circle.size() / 2 - 1; ++i)
    {
        AddQuad(triangles, circle[i], circle[i + 1], circle[last - i - 1], circle[last - i]);
    }
    return triangles;
}

ScreenTriangles RingTriangles(const glm::dvec2& center, double innerRadius, double outerRadius)
{
    const std::vector<glm::dvec2> outer = Circle(center, outerRadius);
    const std::vector<glm::dvec2> inner = Circle(center, innerRadius, outer.size());
    ScreenTriangles triangles;
    for (std::size_t i = 0; i < outer.size(); ++i)
    {
        const std::size_t next = (i + 1) % outer.size();
        AddQuad(triangles, inner[i], outer[i], outer[next], inner[next]);
    }
    return triangles;
}

ScreenTriangles StarTriangles(const glm::dvec2& center, int tips, double innerRadius,
                              double outerRadius, double turn)
{
    const auto corner = [&](int i)
    {
        const double angle = turn + k_Pi * i / tips;
        const double radius = i % 2 == 0 ? outerRadius : innerRadius;
        return center + radius * glm::dvec2(std::cos(angle), std::sin(angle));
    };
    ScreenTriangles triangles;
    for (int i = 0; i < 2 * tips; ++i)
    {
        triangles.push_back({center, corner(i), corner((i + 1) % (2 * tips))});
    }
    return triangles;
}

ScreenTriangles NeedleTriangles(const glm::dvec2& from, const glm::dvec2& to, double thickness)
{
    const glm::dvec2 along = glm::normalize(to - from);
    const glm::dvec2 aside = glm::dvec2(-along.y, along.x) * (thickness / 2.0);
    ScreenTriangles triangles;
    AddQuad(triangles, from - aside, to - aside, to + aside, from + aside);
    return triangles;
}

ScreenTriangles MeshTriangles(const Mesh& mesh, const Transform& transform, const Camera& camera,
                              int width, int height)
{
    ScreenTriangles triangles;
    for (const auto& [a, b, c] :
         Project(mesh.data(), mesh.data().triangles, transform, camera, width, height))
    {
        triangles.push_back({glm::dvec2(a), glm::dvec2(b), glm::dvec2(c)});
    }
    return triangles;
}

std::vector<DepthTriangle> MeshDepths(const Mesh& mesh, int subMesh, const Transform& transform,
                                      const Camera& camera, int width, int height, CullMode cull)
{
    const SubMesh& part = mesh.subMesh(subMesh);
    const std::span<const std::uint32_t> indices(mesh.data().triangles);
    std::vector<DepthTriangle> triangles =
        Project(mesh.data(), indices.subspan(part.indexStart, part.indexCount), transform, camera,
                width, height);
    const bool isMirrored = glm::determinant(glm::dmat3(transform.worldMatrix())) < 0.0;
    std::erase_if(triangles,
                  [&](const DepthTriangle& triangle)
                  {
                      const glm::dvec2 b(triangle[1] - triangle[0]);
                      const glm::dvec2 c(triangle[2] - triangle[0]);
                      // Clockwise triangles face the viewer; y counts downwards here.
                      const bool isFront = (Cross(b, c) > 0.0) != isMirrored;
                      return cull == (isFront ? CullMode::Front : CullMode::Back);
                  });
    return triangles;
}

ScreenTriangles Together(std::initializer_list<ScreenTriangles> parts)
{
    ScreenTriangles all;
    for (const ScreenTriangles& part : parts)
    {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

ScreenTriangles Moved(ScreenTriangles triangles, const glm::dvec2& offset)
{
    for (auto& triangle : triangles)
    {
        for (glm::dvec2& corner : triangle)
        {
            corner += offset;
        }
    }
    return triangles;
}

} // namespace limn::study
