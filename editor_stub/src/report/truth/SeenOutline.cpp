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

/// Finds the places of an outline that nothing stands in front of.
class Seer
{
public:
    Seer(const Silhouette& silhouette, double width, const Surfaces& own, const Surfaces& others,
         HiddenAt where)
        : m_Silhouette(silhouette), m_Width(width), m_Own(own), m_Others(others), m_Where(where)
    {
    }

    /// Returns how much of a pixel's outline is seen, 0...1.
    double PartOf(int x, int y)
    {
        int inBand = 0;
        int seenInBand = 0;
        int seen = 0;
        for (int i = 0; i < k_PlacesPerSide * k_PlacesPerSide; ++i)
        {
            const glm::dvec2 step(i % k_PlacesPerSide + 0.5, i / k_PlacesPerSide + 0.5);
            const glm::dvec2 place = glm::dvec2(x, y) + step / static_cast<double>(k_PlacesPerSide);
            glm::dvec2 nearest = place;
            const double distance = m_Silhouette.SignedDistance(place, m_Width + 2.0, &nearest);
            const int isSeen = IsSeen(place, nearest) ? 1 : 0;
            const int isInBand = distance > 0.0 && distance < m_Width ? 1 : 0;
            inBand += isInBand;
            seenInBand += isInBand * isSeen;
            seen += isSeen;
        }
        // A sliver of the outline may pass between all places.
        return inBand > 0 ? static_cast<double>(seenInBand) / inBand
                          : static_cast<double>(seen) / (k_PlacesPerSide * k_PlacesPerSide);
    }

    std::vector<std::size_t> hiding() const { return {m_Hiding.begin(), m_Hiding.end()}; }

private:
    bool IsSeen(const glm::dvec2& place, const glm::dvec2& nearest)
    {
        constexpr double k_NotInFront = 1.001;
        const Surfaces::Hit other =
            m_Others.NearestAt(m_Where == HiddenAt::Border ? nearest : place);
        if (other.owner == Surfaces::k_NoOwner ||
            other.nearness <= m_Own.NearestAt(nearest).nearness * k_NotInFront)
        {
            return true;
        }
        m_Hiding.insert(other.owner);
        return false;
    }

    const Silhouette& m_Silhouette;
    double m_Width;
    const Surfaces& m_Own;
    const Surfaces& m_Others;
    HiddenAt m_Where;
    std::set<std::size_t> m_Hiding;
};

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
    std::vector<Box> boxes(m_Triangles.size());
    for (std::size_t i = 0; i < m_Triangles.size(); ++i)
    {
        for (const glm::dvec3& corner : m_Triangles[i])
        {
            boxes[i].Add(glm::dvec2(corner));
        }
    }
    m_Tree = BoxTree(std::move(boxes));
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
    Seer seer(silhouette, width, own, others, where);
    for (int y = 0; y < whole.height; ++y)
    {
        for (int x = 0; x < whole.width; ++x)
        {
            if (whole.At(x, y) > 0.0)
            {
                result.seen.At(x, y) *= seer.PartOf(x, y);
            }
        }
    }
    result.hiding = seer.hiding();
    return result;
}

} // namespace limn::study
