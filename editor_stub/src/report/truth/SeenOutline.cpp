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
    const auto corner = [&triangle](std::size_t i)
    {
        return glm::dvec2(triangle[i % 3]);
    };
    const double area = Cross(corner(1) - corner(0), corner(2) - corner(0));
    double nearness = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2 along = corner(i + 2) - corner(i + 1);
        const double part = Cross(along, point - corner(i + 1)); // of the corner i, times area
        if (part * (area > 0.0 ? 1.0 : -1.0) < -k_Touching * glm::length(along))
        {
            return -1.0;
        }
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
    for (int y = 0; y < whole.height; ++y)
    {
        for (int x = 0; x < whole.width; ++x)
        {
            if (whole.At(x, y) > 0.0)
            {
                result.seen.At(x, y) *= partOf(x, y);
            }
        }
    }
    result.hiding.assign(hiding.begin(), hiding.end());
    return result;
}

} // namespace limn::study
