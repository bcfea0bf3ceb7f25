#include "report/truth/Silhouette.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace limn::study
{

namespace
{

using Segment = std::array<glm::dvec2, 2>;

constexpr double k_Aside = 1e-6; ///< pixels; to see what is on either side of an edge

template <std::size_t N>
Box BoxOf(const std::array<glm::dvec2, N>& points)
{
    Box box;
    for (const glm::dvec2& point : points)
    {
        box.Add(point);
    }
    return box;
}

template <std::size_t N>
BoxTree TreeOf(const std::vector<std::array<glm::dvec2, N>>& items)
{
    std::vector<Box> boxes;
    for (const auto& item : items)
    {
        boxes.push_back(BoxOf(item));
    }
    return BoxTree(std::move(boxes));
}

glm::dvec2 NearestOf(const Segment& segment, const glm::dvec2& point)
{
    const glm::dvec2 along = segment[1] - segment[0];
    const double t = glm::dot(point - segment[0], along) / glm::dot(along, along);
    return segment[0] + along * std::clamp(t, 0.0, 1.0);
}

/// The edges that do not have a triangle on both sides already because two share them.
std::vector<Segment> EdgesOfOneSide(const ScreenTriangles& triangles)
{
    struct Edge
    {
        Segment ends;
        bool isLeft; ///< the triangle is on the edge's left
        auto Key() const { return std::tie(ends[0].x, ends[0].y, ends[1].x, ends[1].y); }
    };
    std::vector<Edge> edges;
    for (const auto& triangle : triangles)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            Edge edge{{triangle[i], triangle[(i + 1) % 3]}, false};
            if (std::tie(edge.ends[1].x, edge.ends[1].y) < std::tie(edge.ends[0].x, edge.ends[0].y))
            {
                std::swap(edge.ends[0], edge.ends[1]);
            }
            edge.isLeft =
                Cross(edge.ends[1] - edge.ends[0], triangle[(i + 2) % 3] - edge.ends[0]) > 0.0;
            edges.push_back(edge);
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.Key() < b.Key(); });
    std::vector<Segment> result;
    for (std::size_t i = 0; i < edges.size();)
    {
        bool hasLeft = false;
        bool hasRight = false;
        const Edge& edge = edges[i];
        for (; i < edges.size() && edges[i].Key() == edge.Key(); ++i)
        {
            (edges[i].isLeft ? hasLeft : hasRight) = true;
        }
        if (hasLeft != hasRight)
        {
            result.push_back(edge.ends);
        }
    }
    return result;
}

/// Where along `segment`, 0...1, the other one crosses, touches or leaves it.
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
        tree.AnyOverlapping(BoxOf(edge), k_Touching,
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
    const Box box{point, point};
    return m_TriangleTree.AnyOverlapping(
        box, k_Touching,
        [&](std::size_t index)
        {
            const auto& corners = m_Triangles[index];
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
        });
}

double Silhouette::SignedDistance(const glm::dvec2& point, double limit, glm::dvec2* nearest) const
{
    double least = limit;
    m_BorderTree.Nearest(point, limit,
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
                             return distance;
                         });
    return Contains(point) ? -least : least;
}

double Silhouette::Perimeter() const
{
    double sum = 0.0;
    for (const Segment& segment : m_Border)
    {
        sum += glm::length(segment[1] - segment[0]);
    }
    return sum;
}

} // namespace limn::study
