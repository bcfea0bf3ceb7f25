#include "StrokeDraws.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <tuple>

namespace limn
{

namespace
{

constexpr int k_TileSize = 16;      // pixels
constexpr int k_ElementStep = 32;   // lists grow by so many
constexpr double k_Smoothing = 1.0; // how far beyond its border a stroke covers parts of pixels
const glm::vec4 k_Nothing(-1.0f);

/// Cuts a stroke off outside of a box. @return false if nothing is left
bool CutToBox(Stroke& stroke, const glm::dvec2& low, const glm::dvec2& high)
{
    const glm::dvec2 along = stroke.b - stroke.a;
    double from = 0.0;
    double to = 1.0;
    for (int axis = 0; axis < 2; ++axis)
    {
        if (along[axis] == 0.0)
        {
            if (stroke.a[axis] < low[axis] || stroke.a[axis] > high[axis])
            {
                return false;
            }
            continue;
        }
        const double t0 = (low[axis] - stroke.a[axis]) / along[axis];
        const double t1 = (high[axis] - stroke.a[axis]) / along[axis];
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
    }
    if (!(from <= to))
    {
        return false;
    }
    const Stroke whole = stroke;
    const double depth = whole.depthB - whole.depthA;
    if (from > 0.0)
    {
        stroke.a = whole.a + along * from;
        stroke.depthA = whole.depthA + depth * from;
        stroke.turnA = 1.0;
    }
    if (to < 1.0)
    {
        stroke.b = whole.a + along * to;
        stroke.depthB = whole.depthA + depth * to;
        stroke.turnB = 1.0;
    }
    return true;
}

/// Leaves one of the strokes that lie at the same place, as those of objects at the same place do;
/// the others keep their order.
void LeaveOutDoubles(std::vector<Stroke>& strokes)
{
    const auto place = [](const Stroke& stroke)
    {
        return std::tie(stroke.a.x, stroke.a.y, stroke.b.x, stroke.b.y);
    };
    // Kept from frame to frame: a steady frame asks for no memory.
    thread_local std::vector<std::size_t> order;
    thread_local std::vector<bool> isDouble;
    order.resize(strokes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order,
                      [&](std::size_t a, std::size_t b)
                      {
                          const auto placeA = place(strokes[a]);
                          const auto placeB = place(strokes[b]);
                          return placeA != placeB ? placeA < placeB : a < b;
                      });
    isDouble.assign(strokes.size(), false);
    for (std::size_t i = 1; i < order.size(); ++i)
    {
        isDouble[order[i]] = place(strokes[order[i - 1]]) == place(strokes[order[i]]);
    }
    std::size_t index = 0;
    std::erase_if(strokes, [&](const Stroke&) { return isDouble[index++]; });
}

/// Returns how far a stroke must go on so that it and the next one cover all points within `radius`
/// of their joint. Their borders meet there.
double Extension(double turn, double radius)
{
    const double meeting = std::sqrt(std::max(1.0 - turn, 0.0) / std::max(1.0 + turn, 1e-9));
    return std::max(radius * std::min(meeting, 1.0), k_Smoothing);
}

glm::dvec2 Direction(const Stroke& stroke)
{
    const glm::dvec2 along = stroke.b - stroke.a;
    const double length = glm::length(along);
    return length > 0.0 ? along / length : glm::dvec2(1.0, 0.0);
}

/// Finds the squares of a region that strokes touch.
class Tiles
{
public:
    /// Begins with a region of which no square is touched.
    void Begin(const glm::ivec2& size)
    {
        m_Count = size / k_TileSize;
        m_Touched.assign(static_cast<std::size_t>(m_Count.x * m_Count.y), false);
    }

    /// @param a, b  ends of a rectangle's middle line, pixels
    /// @param left, right  how far it reaches across
    void Touch(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& left,
               const glm::dvec2& right)
    {
        const int steps = 1 + static_cast<int>(glm::length(b - a) / k_TileSize);
        for (int i = 0; i < steps; ++i)
        {
            const glm::dvec2 p = glm::mix(a, b, static_cast<double>(i) / steps);
            const glm::dvec2 q = glm::mix(a, b, static_cast<double>(i + 1) / steps);
            TouchBox(glm::min(glm::min(p + left, q + left), glm::min(p + right, q + right)),
                     glm::max(glm::max(p + left, q + left), glm::max(p + right, q + right)));
        }
    }

    /// Runs of touched squares as rectangles: left, top, right, bottom; valid until the next call.
    std::span<const glm::vec4> Runs()
    {
        m_Runs.clear();
        for (int y = 0; y < m_Count.y; ++y)
        {
            for (int x = 0; x < m_Count.x; ++x)
            {
                if (!At(x, y))
                {
                    continue;
                }
                const int first = x;
                while (x < m_Count.x && At(x, y))
                {
                    ++x;
                }
                m_Runs.emplace_back(glm::vec4(first, y, x, y + 1) * static_cast<float>(k_TileSize));
            }
        }
        return m_Runs;
    }

private:
    bool At(int x, int y) const { return m_Touched[static_cast<std::size_t>(y * m_Count.x + x)]; }

    void TouchBox(const glm::dvec2& low, const glm::dvec2& high)
    {
        const glm::ivec2 first = glm::clamp(glm::ivec2(glm::floor(low / double{k_TileSize})),
                                            glm::ivec2(0), m_Count - 1);
        const glm::ivec2 last = glm::clamp(glm::ivec2(glm::floor(high / double{k_TileSize})),
                                           glm::ivec2(0), m_Count - 1);
        for (int y = first.y; y <= last.y; ++y)
        {
            for (int x = first.x; x <= last.x; ++x)
            {
                m_Touched[static_cast<std::size_t>(y * m_Count.x + x)] = true;
            }
        }
    }

    glm::ivec2 m_Count{0};
    std::vector<bool> m_Touched;
    std::vector<glm::vec4> m_Runs;
};

} // namespace

void ShaderArrays::Assign(std::span<const glm::vec4> values, const glm::vec4& nothing)
{
    const auto length = static_cast<std::size_t>(k_ArrayLength / stride * stride);
    parts.resize((values.size() + length - 1) / length);
    for (std::vector<glm::vec4>& part : parts)
    {
        const std::size_t count = std::min(values.size(), length);
        part.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
        const auto step = static_cast<std::size_t>(k_ElementStep * stride);
        part.resize(std::min((count + step - 1) / step * step, length), nothing);
        values = values.subspan(count);
    }
}

bool StrokeDraws::Assign(std::vector<Stroke>& strokesOfGroup, double width,
                         const glm::ivec2& picture)
{
    const double radius = width + k_Smoothing;
    const glm::dvec2 border(radius + 1.0);
    std::erase_if(strokesOfGroup, [&](Stroke& stroke)
                  { return !CutToBox(stroke, -border, glm::dvec2(picture) + border); });
    LeaveOutDoubles(strokesOfGroup);
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high = -low;
    for (const Stroke& stroke : strokesOfGroup)
    {
        low = glm::min(low, glm::min(stroke.a, stroke.b));
        high = glm::max(high, glm::max(stroke.a, stroke.b));
    }
    const auto found = FindOutlineRegion(low, high, picture, static_cast<float>(width));
    if (!found)
    {
        return false;
    }
    region = *found;
    edgeCount = static_cast<int>(strokesOfGroup.size());
    strokeArea = 0.0;
    const glm::dvec2 corner(region.corner);
    thread_local Tiles touched; // for their memory
    thread_local std::vector<glm::vec4> values;
    touched.Begin(region.size);
    values.clear();
    for (const Stroke& stroke : strokesOfGroup)
    {
        const double before = Extension(stroke.turnA, radius);
        const double behind = Extension(stroke.turnB, radius);
        const glm::dvec2 along = Direction(stroke);
        const glm::dvec2 outward(along.y, -along.x);
        const glm::dvec2 a = stroke.a - corner;
        const glm::dvec2 b = stroke.b - corner;
        values.emplace_back(a.x, a.y, b.x, b.y);
        values.emplace_back(before, behind, stroke.depthA, stroke.depthB);
        strokeArea += (before + glm::length(b - a) + behind) * (radius + k_Smoothing);
        touched.Touch(a - along * before, b + along * behind, outward * radius,
                      outward * -k_Smoothing);
    }
    strokes.Assign(values, k_Nothing);
    tiles.Assign(touched.Runs(), glm::vec4(0.0f));
    return true;
}

} // namespace limn
