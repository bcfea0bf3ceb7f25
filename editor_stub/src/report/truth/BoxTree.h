#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numeric>
#include <vector>

namespace limn::study
{

/// An axis-aligned box in the plane. It is empty until something is added.
struct Box
{
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};

    void Add(const glm::dvec2& point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void Add(const Box& other)
    {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// Returns the distance from the box to a point, or 0 inside.
    double DistanceTo(const glm::dvec2& point) const
    {
        const double x = point.x < low.x ? low.x - point.x : std::max(0.0, point.x - high.x);
        const double y = point.y < low.y ? low.y - point.y : std::max(0.0, point.y - high.y);
        return std::sqrt(x * x + y * y);
    }
    bool Overlaps(const Box& other, double margin) const
    {
        return low.x <= other.high.x + margin && other.low.x <= high.x + margin &&
               low.y <= other.high.y + margin && other.low.y <= high.y + margin;
    }
};

/// Finds boxes near a place by a tree that is halved at the median of the boxes' centres.
class BoxTree
{
public:
    BoxTree() = default;
    explicit BoxTree(std::vector<Box> boxes) : m_Boxes(std::move(boxes)), m_Items(m_Boxes.size())
    {
        std::iota(m_Items.begin(), m_Items.end(), std::size_t{0});
        if (!m_Items.empty())
        {
            Build(0, m_Items.size());
        }
    }

    /// Calls visit(index) for the boxes that overlap `box`, until one call returns true. Returns
    /// whether one did.
    template <typename Visit>
    bool AnyOverlapping(const Box& box, double margin, Visit&& visit) const
    {
        return !m_Nodes.empty() && AnyBelow(0, box, margin, visit);
    }

    /// Calls distance(index) for all boxes that may be nearer than `limit` and than the distances
    /// that it returned before.
    template <typename Distance>
    void Nearest(const glm::dvec2& point, double limit, Distance&& distance) const
    {
        if (!m_Nodes.empty())
        {
            NearestBelow(0, m_Nodes[0].box.DistanceTo(point), point, limit, distance);
        }
    }

private:
    static constexpr std::size_t k_LeafSize = 4;
    struct Node
    {
        Box box;
        std::size_t first = 0;
        std::size_t end = 0;
        std::size_t second = 0; ///< the second child; the first one follows this node; 0 = a leaf
    };

    void Build(std::size_t first, std::size_t end)
    {
        const std::size_t self = m_Nodes.size();
        m_Nodes.push_back({{}, first, end, 0});
        Box box;
        Box centers;
        for (std::size_t i = first; i < end; ++i)
        {
            box.Add(m_Boxes[m_Items[i]]);
            centers.Add(Center(m_Items[i]));
        }
        m_Nodes[self].box = box;
        if (end - first <= k_LeafSize)
        {
            return;
        }
        const glm::dvec2 size = centers.high - centers.low;
        const int axis = size.x >= size.y ? 0 : 1;
        const std::size_t middle = (first + end) / 2;
        const auto at = [this](std::size_t i)
        {
            return m_Items.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(first), at(middle), at(end),
                         [&](std::size_t a, std::size_t b)
                         { return Center(a)[axis] < Center(b)[axis]; });
        Build(first, middle);
        m_Nodes[self].second = m_Nodes.size();
        Build(middle, end);
    }

    glm::dvec2 Center(std::size_t item) const
    {
        return 0.5 * (m_Boxes[item].low + m_Boxes[item].high);
    }

    template <typename Visit>
    bool AnyBelow(std::size_t index, const Box& box, double margin, Visit& visit) const
    {
        const Node& node = m_Nodes[index];
        if (!node.box.Overlaps(box, margin))
        {
            return false;
        }
        if (node.second != 0)
        {
            return AnyBelow(index + 1, box, margin, visit) ||
                   AnyBelow(node.second, box, margin, visit);
        }
        for (std::size_t i = node.first; i < node.end; ++i)
        {
            if (m_Boxes[m_Items[i]].Overlaps(box, margin) && visit(m_Items[i]))
            {
                return true;
            }
        }
        return false;
    }

    template <typename Distance>
    void NearestBelow(std::size_t index, double boxDistance, const glm::dvec2& point, double& limit,
                      Distance& distance) const
    {
        if (boxDistance >= limit)
        {
            return;
        }
        const Node& node = m_Nodes[index];
        if (node.second != 0)
        {
            const double first = m_Nodes[index + 1].box.DistanceTo(point);
            const double second = m_Nodes[node.second].box.DistanceTo(point);
            const bool swapped = second < first;
            NearestBelow(swapped ? node.second : index + 1, std::min(first, second), point, limit,
                         distance);
            NearestBelow(swapped ? index + 1 : node.second, std::max(first, second), point, limit,
                         distance);
            return;
        }
        for (std::size_t i = node.first; i < node.end; ++i)
        {
            limit = std::min(limit, distance(m_Items[i]));
        }
    }

    std::vector<Box> m_Boxes;
    std::vector<std::size_t> m_Items;
    std::vector<Node> m_Nodes;
};

/// Returns the box around the corners of an item.
template <typename Corners>
Box BoxOf(const Corners& corners)
{
    Box box;
    for (const auto& corner : corners)
    {
        box.Add(glm::dvec2(corner));
    }
    return box;
}

template <typename Items>
BoxTree TreeOf(const Items& items)
{
    std::vector<Box> boxes;
    for (const auto& item : items)
    {
        boxes.push_back(BoxOf(item));
    }
    return BoxTree(std::move(boxes));
}

} // namespace limn::study
