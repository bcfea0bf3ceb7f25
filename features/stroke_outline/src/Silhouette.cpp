#include "Silhouette.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace limn
{

namespace
{

constexpr std::uint32_t k_NoPoint = ~std::uint32_t{0};

/// Returns the distance of a point on the inner side of the near plane.
double InsideNear(const glm::dvec4& clip)
{
    return clip.w - clip.z;
}
double InsideFar(const glm::dvec4& clip)
{
    return clip.z;
}
using Plane = double (*)(const glm::dvec4&);

/// Cuts off what is not inside. @return false if nothing is left
bool Cut(glm::dvec4& a, glm::dvec4& b, Plane plane)
{
    // A point that the plane has cut before lies on it, except for rounding.
    const double slack = -1e-12 * (std::abs(a.w) + std::abs(b.w));
    const double insideA = plane(a);
    const double insideB = plane(b);
    if (insideA < slack && insideB < slack)
    {
        return false;
    }
    if (insideA < slack || insideB < slack)
    {
        const glm::dvec4 cut = glm::mix(a, b, insideA / (insideA - insideB));
        (insideA < slack ? a : b) = cut;
    }
    return true;
}

/// The sign of the area that a face has on the screen, also where it reaches behind the camera: > 0
/// where its corners go round clockwise, so that it is on the right of each of its sides.
signed char SignOfArea(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c)
{
    const glm::dmat3 corners(glm::dvec3(a.x, a.y, a.w), glm::dvec3(b.x, b.y, b.w),
                             glm::dvec3(c.x, c.y, c.w));
    const double area = -glm::determinant(corners);
    return static_cast<signed char>((area > 0.0) - (area < 0.0));
}

} // namespace

/// Turns edges of one mesh into strokes.
class SilhouetteFinder::StrokeMaker
{
public:
    StrokeMaker(SilhouetteFinder& finder, std::size_t pointCount, const glm::dvec2& picture,
                std::vector<Stroke>& strokes)
        : m_Finder(finder), m_Picture(picture), m_Strokes(&strokes)
    {
        m_Finder.m_Ends.clear();
        m_Finder.m_EndsOfPoint.assign(pointCount, k_NoPoint);
    }

    /// @param side    the object is on the right of a to b (> 0), on the left (< 0), or it cannot
    /// be
    ///                said (0), and it is drawn to both sides
    /// @param pointA  the mesh's, for joining it with others; or k_NoPoint
    void Add(glm::dvec4 a, glm::dvec4 b, int side, std::uint32_t pointA, std::uint32_t pointB)
    {
        const glm::dvec4 wholeA = a;
        const glm::dvec4 wholeB = b;
        if (!Cut(a, b, InsideNear) || !Cut(a, b, InsideFar) || !(a.w > 0.0) || !(b.w > 0.0))
        {
            return;
        }
        Stroke stroke{ToPixel(a), ToPixel(b), a.z / a.w, b.z / b.w};
        pointA = a == wholeA ? pointA : k_NoPoint;
        pointB = b == wholeB ? pointB : k_NoPoint;
        if (side >= 0)
        {
            Push(stroke, pointA, pointB);
        }
        if (side <= 0)
        {
            std::swap(stroke.a, stroke.b);
            std::swap(stroke.depthA, stroke.depthB);
            Push(stroke, pointB, pointA);
        }
    }

    /// Finds where strokes go on.
    void Join()
    {
        for (const Ends& end : m_Finder.m_Ends)
        {
            if (end.count != 2)
            {
                continue;
            }
            Stroke& in = (*m_Strokes)[end.strokes[0].first];
            Stroke& out = (*m_Strokes)[end.strokes[1].first];
            const bool endsAtB = end.strokes[0].second;
            const bool beginsAtA = !end.strokes[1].second;
            const glm::dvec2 from = endsAtB ? in.b - in.a : in.a - in.b;
            const glm::dvec2 to = beginsAtA ? out.b - out.a : out.a - out.b;
            const double lengths = glm::length(from) * glm::length(to);
            const double turn = lengths > 0.0 ? glm::dot(from, to) / lengths : -1.0;
            (endsAtB ? in.turnB : in.turnA) = turn;
            (beginsAtA ? out.turnA : out.turnB) = turn;
        }
    }

private:
    glm::dvec2 ToPixel(const glm::dvec4& clip) const
    {
        return glm::dvec2(1.0 + clip.x / clip.w, 1.0 - clip.y / clip.w) * 0.5 * m_Picture;
    }

    void Push(const Stroke& stroke, std::uint32_t pointA, std::uint32_t pointB)
    {
        const std::size_t index = m_Strokes->size();
        m_Strokes->push_back(stroke);
        for (const bool isB : {false, true})
        {
            const std::uint32_t point = isB ? pointB : pointA;
            if (point != k_NoPoint)
            {
                std::uint32_t& place = m_Finder.m_EndsOfPoint[point];
                if (place == k_NoPoint)
                {
                    place = static_cast<std::uint32_t>(m_Finder.m_Ends.size());
                    m_Finder.m_Ends.emplace_back();
                }
                Ends& ends = m_Finder.m_Ends[place];
                if (ends.count < 2)
                {
                    ends.strokes[ends.count] = {index, isB};
                }
                ++ends.count;
            }
        }
    }

    SilhouetteFinder& m_Finder; ///< whose memory is used again
    glm::dvec2 m_Picture;
    std::vector<Stroke>* m_Strokes;
};

namespace
{

/// Adds the segment in which a plane cuts a face.
void AddCut(const WeldedMesh::Face& face, const std::vector<glm::dvec4>& clip, Plane plane,
            SilhouetteFinder::StrokeMaker& maker)
{
    glm::dvec4 ends[2];
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec4& a = clip[face.points[i]];
        const glm::dvec4& b = clip[face.points[(i + 1) % 3]];
        const double insideA = plane(a);
        const double insideB = plane(b);
        if ((insideA < 0.0) != (insideB < 0.0) && count < 2)
        {
            ends[count++] = glm::mix(a, b, insideA / (insideA - insideB));
        }
    }
    if (count == 2)
    {
        maker.Add(ends[0], ends[1], 0, k_NoPoint, k_NoPoint);
    }
}

} // namespace

const WeldedMesh& SilhouetteFinder::Find(const std::shared_ptr<const Mesh>& mesh, int subMesh)
{
    const auto key = std::pair(mesh->id(), subMesh);
    const auto found = m_Meshes.find(key);
    if (found != m_Meshes.end())
    {
        return found->second.welded;
    }
    std::erase_if(m_Meshes, [](const auto& entry) { return entry.second.mesh.expired(); });
    return m_Meshes.emplace(key, Entry{mesh, Weld(*mesh, subMesh)}).first->second.welded;
}

void SilhouetteFinder::Append(const std::shared_ptr<const Mesh>& mesh, int subMesh,
                              const glm::dmat4& objectToClip, const glm::dvec2& picture,
                              std::vector<Stroke>& strokes)
{
    const WeldedMesh& welded = Find(mesh, subMesh);
    m_Clip.clear();
    bool isCut = false;
    for (const glm::vec3& point : welded.points)
    {
        m_Clip.push_back(objectToClip * glm::dvec4(point, 1.0));
        isCut = isCut || InsideNear(m_Clip.back()) < 0.0 || InsideFar(m_Clip.back()) < 0.0;
    }
    m_Areas.clear();
    for (const WeldedMesh::Face& face : welded.faces)
    {
        m_Areas.push_back(
            SignOfArea(m_Clip[face.points[0]], m_Clip[face.points[1]], m_Clip[face.points[2]]));
    }

    StrokeMaker maker(*this, welded.points.size(), picture, strokes);
    for (auto side = welded.sides.begin(); side != welded.sides.end();)
    {
        const auto& points = side->points;
        bool isOnRight = false;
        bool isOnLeft = false;
        for (; side != welded.sides.end() && side->points == points; ++side)
        {
            const int area = side->isForward ? m_Areas[side->face] : -m_Areas[side->face];
            isOnRight = isOnRight || area > 0;
            isOnLeft = isOnLeft || area < 0;
        }
        if (!isOnRight || !isOnLeft)
        {
            maker.Add(m_Clip[points[0]], m_Clip[points[1]], int{isOnRight} - int{isOnLeft},
                      points[0], points[1]);
        }
    }
    for (const WeldedMesh::Face& face : welded.faces)
    {
        if (isCut)
        {
            AddCut(face, m_Clip, InsideNear, maker);
            AddCut(face, m_Clip, InsideFar, maker);
        }
    }
    maker.Join();
}

} // namespace limn
