#include "models/MikkTangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <limn/base/HashContent.h>
#include <numeric>
#include <unordered_map>

namespace limn
{

namespace
{

constexpr std::size_t k_NoCorner = std::numeric_limits<std::size_t>::max();

bool IsNotZero(double value)
{
    return std::abs(value) > static_cast<double>(std::numeric_limits<float>::min());
}

glm::dvec3 NormalOrZero(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return IsNotZero(length) ? v / length : glm::dvec3(0.0);
}

/// A triangle's direction of growing u.
struct TriangleTangent
{
    glm::dvec3 direction{0.0};
    bool isPreserving = false; ///< uv turn the same way round as the corners
    bool isAny = true;         ///< it has no direction, and goes along with its neighbours
    bool isDegenerate = false; ///< two corners are at one place
};

struct BytesHash
{
    std::size_t operator()(const std::array<std::uint32_t, 8>& key) const
    {
        return HashContent({reinterpret_cast<const char*>(key.data()), sizeof(key)});
    }
};

class MikkSpace
{
public:
    explicit MikkSpace(MeshData& data)
        : m_Data(data),
          m_Triangles(data.triangles.size() / 3),
          m_Neighbours(data.triangles.size(), k_NoCorner),
          m_Groups(data.triangles.size()),
          m_Results(data.triangles.size())
    {
        std::iota(m_Groups.begin(), m_Groups.end(), std::size_t{0});
    }

    std::vector<std::uint32_t> Compute()
    {
        Weld();
        for (std::size_t i = 0; i < m_Triangles.size(); ++i)
        {
            m_Triangles[i] = TangentOf(i);
        }
        Connect();
        Orient();
        Join();
        Evaluate();
        CopyToDegenerate();
        Split();
        return std::move(m_Copied);
    }

private:
    static std::size_t Next(std::size_t corner) { return corner - corner % 3 + (corner + 1) % 3; }
    static std::size_t Previous(std::size_t corner)
    {
        return corner - corner % 3 + (corner + 2) % 3;
    }
    glm::dvec3 Position(std::size_t corner) const
    {
        return m_Data.vertices[m_Data.triangles[corner]];
    }
    glm::dvec2 Uv(std::size_t corner) const { return m_Data.uv[m_Data.triangles[corner]]; }

    /// Gives vertices of equal position, normal and uv one number.
    void Weld()
    {
        std::unordered_map<std::array<std::uint32_t, 8>, std::uint32_t, BytesHash> numbers;
        for (std::size_t i = 0; i < m_Data.vertices.size(); ++i)
        {
            const glm::vec3& p = m_Data.vertices[i];
            const glm::vec3& n = m_Data.normals[i];
            const glm::vec2& uv = m_Data.uv[i];
            std::array<float, 8> values{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
            std::array<std::uint32_t, 8> key;
            for (float& value : values)
            {
                value += 0.0f; // -0 is 0
            }
            std::memcpy(key.data(), values.data(), sizeof(key));
            m_Welded.push_back(
                numbers.emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second);
        }
    }
    std::uint32_t Welded(std::size_t corner) const { return m_Welded[m_Data.triangles[corner]]; }

    TriangleTangent TangentOf(std::size_t triangle) const
    {
        const std::size_t first = 3 * triangle;
        TriangleTangent result;
        const glm::dvec3 p[] = {Position(first), Position(first + 1), Position(first + 2)};
        result.isDegenerate = p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
        const glm::dvec2 uv1 = Uv(first + 1) - Uv(first);
        const glm::dvec2 uv2 = Uv(first + 2) - Uv(first);
        const double area = uv1.x * uv2.y - uv1.y * uv2.x;
        result.isPreserving = area > 0.0;
        if (!IsNotZero(area))
        {
            return result;
        }
        const glm::dvec3 alongU = uv2.y * (p[1] - p[0]) - uv1.y * (p[2] - p[0]);
        const glm::dvec3 alongV = uv1.x * (p[2] - p[0]) - uv2.x * (p[1] - p[0]);
        const double lengthU = glm::length(alongU);
        if (IsNotZero(lengthU))
        {
            result.direction = (result.isPreserving ? 1.0 : -1.0) / lengthU * alongU;
        }
        result.isAny = !IsNotZero(lengthU / std::abs(area)) ||
                       !IsNotZero(glm::length(alongV) / std::abs(area));
        return result;
    }

    /// Finds for each corner the one that begins the same edge, the other way, in another triangle.
    void Connect()
    {
        std::unordered_multimap<std::uint64_t, std::size_t> open;
        for (std::size_t corner = 0; corner < m_Neighbours.size(); ++corner)
        {
            if (m_Triangles[corner / 3].isDegenerate)
            {
                continue;
            }
            const std::uint64_t from = Welded(corner);
            const std::uint64_t to = Welded(Next(corner));
            const auto other = open.find(to << 32 | from);
            if (other != open.end() && other->second / 3 != corner / 3)
            {
                m_Neighbours[corner] = other->second;
                m_Neighbours[other->second] = corner;
                open.erase(other);
            }
            else
            {
                open.emplace(from << 32 | to, corner);
            }
        }
    }

    /// Triangles without a direction take the way round of the first neighbour that has one.
    void Orient()
    {
        std::vector<std::size_t> reached;
        std::vector<bool> isKnown(m_Triangles.size());
        for (std::size_t i = 0; i < m_Triangles.size(); ++i)
        {
            isKnown[i] = !m_Triangles[i].isAny;
            if (isKnown[i])
            {
                reached.push_back(i);
            }
        }
        for (std::size_t i = 0; i < reached.size(); ++i)
        {
            for (std::size_t corner = 3 * reached[i]; corner < 3 * reached[i] + 3; ++corner)
            {
                const std::size_t other = m_Neighbours[corner];
                if (other != k_NoCorner && !isKnown[other / 3])
                {
                    isKnown[other / 3] = true;
                    m_Triangles[other / 3].isPreserving = m_Triangles[reached[i]].isPreserving;
                    reached.push_back(other / 3);
                }
            }
        }
    }

    std::size_t GroupOf(std::size_t corner)
    {
        while (m_Groups[corner] != corner)
        {
            corner = m_Groups[corner] = m_Groups[m_Groups[corner]];
        }
        return corner;
    }

    void Join()
    {
        for (std::size_t corner = 0; corner < m_Neighbours.size(); ++corner)
        {
            const std::size_t other = m_Neighbours[corner];
            if (other != k_NoCorner &&
                m_Triangles[corner / 3].isPreserving == m_Triangles[other / 3].isPreserving)
            {
                m_Groups[GroupOf(corner)] = GroupOf(Next(other));
                m_Groups[GroupOf(Next(corner))] = GroupOf(other);
            }
        }
    }

    void Evaluate()
    {
        std::vector<glm::dvec3> sums(m_Groups.size(), glm::dvec3(0.0));
        for (std::size_t corner = 0; corner < m_Groups.size(); ++corner)
        {
            const TriangleTangent& triangle = m_Triangles[corner / 3];
            if (triangle.isAny || triangle.isDegenerate)
            {
                continue;
            }
            const glm::dvec3 normal = m_Data.normals[m_Data.triangles[corner]];
            const auto inPlane = [&](const glm::dvec3& v)
            {
                return NormalOrZero(v - glm::dot(normal, v) * normal);
            };
            const glm::dvec3 a = inPlane(Position(Previous(corner)) - Position(corner));
            const glm::dvec3 b = inPlane(Position(Next(corner)) - Position(corner));
            const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
            sums[GroupOf(corner)] += angle * inPlane(triangle.direction);
        }
        for (std::size_t corner = 0; corner < m_Groups.size(); ++corner)
        {
            const glm::dvec3 sum = NormalOrZero(sums[GroupOf(corner)]);
            const bool isPreserving = m_Triangles[corner / 3].isPreserving;
            m_Results[corner] = sum == glm::dvec3(0.0)
                                    ? k_Default
                                    : glm::vec4(glm::vec3(sum), isPreserving ? 1.0f : -1.0f);
        }
    }

    void CopyToDegenerate()
    {
        std::unordered_map<std::uint32_t, std::size_t> good;
        for (std::size_t corner = 0; corner < m_Groups.size(); ++corner)
        {
            if (!m_Triangles[corner / 3].isDegenerate)
            {
                good.emplace(Welded(corner), corner);
            }
        }
        for (std::size_t corner = 0; corner < m_Groups.size(); ++corner)
        {
            const auto found =
                m_Triangles[corner / 3].isDegenerate ? good.find(Welded(corner)) : good.end();
            m_Results[corner] = found != good.end() ? m_Results[found->second] : m_Results[corner];
        }
    }

    void Split()
    {
        const std::size_t count = m_Data.vertices.size();
        m_Data.tangents.assign(count, k_Default);
        std::vector<std::uint32_t> next(count); ///< another copy of a vertex; 0 = none
        std::vector<bool> isSet(count);
        for (std::size_t corner = 0; corner < m_Results.size(); ++corner)
        {
            std::uint32_t vertex = m_Data.triangles[corner];
            while (isSet[vertex] && m_Data.tangents[vertex] != m_Results[corner])
            {
                if (next[vertex] == 0)
                {
                    next[vertex] = Duplicate(vertex);
                    next.push_back(0);
                    isSet.push_back(false);
                }
                vertex = next[vertex];
            }
            isSet[vertex] = true;
            m_Data.tangents[vertex] = m_Results[corner];
            m_Data.triangles[corner] = vertex;
        }
    }

    std::uint32_t Duplicate(std::uint32_t vertex)
    {
        const auto copy = [&](auto& values)
        {
            if (!values.empty())
            {
                const auto value = values[vertex];
                values.push_back(value);
            }
        };
        const auto copyAll = [&](auto&... arrays)
        {
            (copy(arrays), ...);
        };
        copyAll(m_Data.vertices, m_Data.normals, m_Data.tangents, m_Data.colors, m_Data.uv,
                m_Data.uv2, m_Data.uv3, m_Data.uv4, m_Data.uv5, m_Data.uv6, m_Data.uv7, m_Data.uv8);
        m_Copied.push_back(vertex);
        return static_cast<std::uint32_t>(m_Data.vertices.size() - 1);
    }

    static constexpr glm::vec4 k_Default{1.0f, 0.0f, 0.0f, 1.0f};

    MeshData& m_Data;
    std::vector<std::uint32_t> m_Welded; ///< by vertex
    std::vector<TriangleTangent> m_Triangles;
    std::vector<std::size_t> m_Neighbours; ///< by corner, the edge that begins there
    std::vector<std::size_t> m_Groups;     ///< by corner, towards the group's first
    std::vector<glm::vec4> m_Results;      ///< by corner
    std::vector<std::uint32_t> m_Copied;
};

} // namespace

std::vector<std::uint32_t> ComputeMikkTangents(MeshData& data)
{
    data.tangents.clear();
    return data.normals.empty() || data.uv.empty() ? std::vector<std::uint32_t>()
                                                   : MikkSpace(data).Compute();
}

} // namespace limn
