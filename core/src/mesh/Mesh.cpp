#include <limn/core/Mesh.h>

#include "support/UniqueId.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <limn/base/Diagnostic.h>
#include <utility>

namespace limn
{

namespace
{

Bounds BoundsOf(const std::vector<glm::vec3>& points)
{
    glm::vec3 low = points.front();
    glm::vec3 high = points.front();
    for (const glm::vec3& point : points)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    // Halved before they are added: the sum of two large coordinates may overflow.
    return {0.5f * low + 0.5f * high, 0.5f * high - 0.5f * low};
}

float RadiusAround(const glm::vec3& center, const std::vector<glm::vec3>& points)
{
    double square = 0.0;
    for (const glm::vec3& point : points)
    {
        const glm::dvec3 offset = glm::dvec3(point) - glm::dvec3(center);
        square = std::max(square, glm::dot(offset, offset));
    }
    // Rounded up, so that none is left outside.
    return std::nextafter(static_cast<float>(std::sqrt(square)),
                          std::numeric_limits<float>::infinity());
}

} // namespace

Mesh::Mesh(std::string name, MeshData data)
    : m_Id(NextUniqueId()), m_Name(std::move(name)), m_Data(std::move(data))
{
    const std::vector<std::string> problems = MeshProblems(m_Data);
    if (!problems.empty())
    {
        std::string message;
        for (const std::string& problem : problems)
        {
            message += (message.empty() ? "" : "\n") + ("mesh '" + m_Name + "': ") + problem;
        }
        throw ContractError(message);
    }
    if (m_Data.subMeshes.empty())
    {
        m_Data.subMeshes.push_back({0, static_cast<std::uint32_t>(m_Data.triangles.size())});
    }
    m_Bounds = BoundsOf(m_Data.vertices);
    m_BoundingRadius = RadiusAround(m_Bounds.center, m_Data.vertices);
}

} // namespace limn
