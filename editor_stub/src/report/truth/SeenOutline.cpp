#include "report/truth/SeenOutline.h"

#include <glm/geometric.hpp>
#include <set>

namespace limn::study
{

namespace
{

constexpr int k_PlacesPerSide = 4; ///< of a pixel

/// Returns the nearness of a triangle at a point; less than 0 outside of it.
double NearnessOf(const DepthTriangle& triangle, const glm::dvec2& point)
{
    const std::array<glm::dvec2, 3> corners{triangle[0], triangle[1], triangle[2]};
    if (!IsInTriangle(corners, point))
    {
        return -1.0;
    }
    const double area = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    double nearness = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2& begin = corners[(i + 1) % 3];
        const double part = Cross(corners[(i + 2) % 3] - begin, point - begin); // times area
        nearness += part / area * triangle[i].z;
    }
    return std::max(nearness, 0.0);
}

} // namespace

void Surfaces::Add(const std::vector<DepthTriangle>& triangles, std::size_t owner)
{
    for (const DepthTriangle& triangle : triangles)
    {
        const glm::dvec2 a(triangle[0]);
        if (std::abs(Cross(glm::dvec2(triangle[1]) - a, glm::dvec2(triangle[2]) - a)) > 1e-12)
        {
            m_Triangles.push_back(triangle);
            m_Owners.push_back(owner);
        }
    }
}

void Surfaces::Finish()
{
    m_Tree = TreeOf(m_Triangles);
}

Surfaces::Hit Surfaces::NearestAt(const glm::dvec2& point) const
{
    Hit nearest;
    m_Tree.AnyOverlapping(Box{point, point}, k_Touching,
                          [&](std::size_t index)
                          {
                              const double nearness = NearnessOf(m_Triangles[index], point);
                              if (nearness >= nearest.nearness)
                              {
                                  nearest = {nearness, m_Owners[index]};
                              }
                              return false;
                          });
    return nearest;
}

SeenOutline SeenOutlineCoverage(const Coverage& whole, const Silhouette& silhouette, double width,
                                const Surfaces& own, const Surfaces& others, HiddenAt where)
{
    SeenOutline result{whole, {}};
    if (others.isEmpty())
    {
        return result;
    }
    std::set<std::size_t> hiding;
    const auto isSeen = [&](const glm::dvec2& place, const glm::dvec2& nearest)
    {
        constexpr double k_NotInFront = 1.001;
        const Surfaces::Hit other = others.NearestAt(where == HiddenAt::Border ? nearest : place);
        const bool isHidden = other.owner != Surfaces::k_NoOwner &&
                              other.nearness > own.NearestAt(nearest).nearness * k_NotInFront;
        if (isHidden)
        {
            hiding.insert(other.owner);
        }
        return !isHidden;
    };
    // Returns the part of a pixel's outline that is seen, 0...1.
    const auto partOf = [&](int x, int y)
    {
        constexpr int k_Places = k_PlacesPerSide * k_PlacesPerSide;
        int inBand = 0;
        int seenInBand = 0;
        int seen = 0;
        for (int i = 0; i < k_Places; ++i)
        {
            const glm::dvec2 step(i % k_PlacesPerSide + 0.5, i / k_PlacesPerSide + 0.5);
            const glm::dvec2 place = glm::dvec2(x, y) + step / static_cast<double>(k_PlacesPerSide);
            glm::dvec2 nearest = place;
            const double distance = silhouette.SignedDistance(place, width + 2.0, &nearest);
            const int isPlaceSeen = isSeen(place, nearest) ? 1 : 0;
            const int isInBand = distance > 0.0 && distance < width ? 1 : 0;
            inBand += isInBand;
            seenInBand += isInBand * isPlaceSeen;
            seen += isPlaceSeen;
        }
        // A sliver of the outline may pass between all places.
        return inBand > 0 ? static_cast<double>(seenInBand) / inBand
                          : static_cast<double>(seen) / k_Places;
    };
    whole.ForEach(
        [&](int x, int y)
        {
            if (whole.At(x, y) > 0.0)
            {
                result.seen.At(x, y) *= partOf(x, y);
            }
        });
    result.hiding.assign(hiding.begin(), hiding.end());
    return result;
}

} // namespace limn::study
