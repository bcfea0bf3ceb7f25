#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numeric>
#include <vector>

namespace limn::study
{

inline constexpr double k_Touching = 1e-9; ///< in pixels; points that are nearer count as the same

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
        return glm::length(glm::max(glm::max(low - point, point - high), 0.0));
    }
    bool Touches(const Box& other) const
    {
        return glm::all(glm::lessThanEqual(low, other.high + k_Touching)) &&
               glm::all(glm::lessThanEqual(other.low, high + k_Touching));
    }
};

/// Finds boxes near a place by a tree that is halved at the median of the boxes' centres.
class BoxTree
{
public:
    explicit BoxTree(std::vector<Box> boxes = {})
        : m_Boxes(std::move(boxes)), m_Items(m_Boxes.size())
    {
        std::iota(m_Items.begin(), m_Items.end(), std::size_t{0});
        Build(0, m_Items.size());
    }

    /// Calls visit(index) for the boxes that touch `box`, until one call returns true. Returns
    /// whether one did.
    template <typename Visit>
    bool AnyTouching(const Box& box, const Visit& visit, std::size_t node = 0) const
    {
        if (!m_Nodes[node].box.Touches(box))
        {
            return false;
        }
        const auto& [around, first, end, second] = m_Nodes[node];
        if (second != 0)
        {
            return AnyTouching(box, visit, node + 1) || AnyTouching(box, visit, second);
        }
        for (std::size_t i = first; i < end; ++i)
        {
            if (m_Boxes[m_Items[i]].Touches(box) && visit(m_Items[i]))
            {
                return true;
            }
        }
        return false;
    }

    /// Calls visit(index) for all boxes that may be nearer than `least`, which the calls may make
    /// smaller.
    template <typename Visit>
    void Nearest(const glm::dvec2& point, const double& least, const Visit& visit,
                 std::size_t node = 0) const
    {
        const auto& [around, first, end, second] = m_Nodes[node];
        if (second == 0)
        {
            std::for_each(m_Items.data() + first, m_Items.data() + end, visit);
            return;
        }
        const std::pair ofFirst(m_Nodes[node + 1].box.DistanceTo(point), node + 1);
        const std::pair ofSecond(m_Nodes[second].box.DistanceTo(point), second);
        for (const auto& [distance, child] :
             {std::min(ofFirst, ofSecond), std::max(ofFirst, ofSecond)})
        {
            if (distance < least)
            {
                Nearest(point, least, visit, child);
            }
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
        std::size_t* const items = m_Items.data();
        std::nth_element(items + first, items + middle, items + end,
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
