#include "mesh/MeshProblems.h"

#include <algorithm>
#include <cmath>

namespace limn
{

namespace
{

template <typename Vector>
bool IsFinite(const Vector& vector)
{
    for (int i = 0; i < Vector::length(); ++i)
    {
        if (!std::isfinite(vector[i]))
        {
            return false;
        }
    }
    return true;
}

template <typename Vector>
void CheckArray(std::vector<std::string>& problems, const char* name,
                const std::vector<Vector>& array, std::size_t vertexCount)
{
    if (!array.empty() && array.size() != vertexCount)
    {
        problems.push_back(std::string(name) + ": " + std::to_string(array.size()) +
                           " elements for " + std::to_string(vertexCount) +
                           " vertices; one a vertex or none is right");
    }
    const auto bad = std::find_if_not(array.begin(), array.end(), IsFinite<Vector>);
    if (bad != array.end())
    {
        problems.push_back(std::string(name) + "[" + std::to_string(bad - array.begin()) +
                           "]: not a finite number");
    }
}

void CheckTriangles(std::vector<std::string>& problems, const MeshData& data)
{
    const std::vector<std::uint32_t>& indices = data.triangles;
    if (indices.size() % 3 != 0)
    {
        problems.push_back("triangles: " + std::to_string(indices.size()) +
                           " indices; a multiple of three is right");
    }
    const std::size_t limit = data.vertices.size();
    const auto isOutside = [limit](std::uint32_t index)
    {
        return index >= limit;
    };
    const auto first = std::find_if(indices.begin(), indices.end(), isOutside);
    if (first != indices.end())
    {
        const auto count = std::count_if(indices.begin(), indices.end(), isOutside);
        problems.push_back("triangles[" + std::to_string(first - indices.begin()) + "]: index " +
                           std::to_string(*first) + " of " + std::to_string(limit) + " vertices (" +
                           std::to_string(count) + " such indices in all)");
    }
}

void CheckSubMeshes(std::vector<std::string>& problems, const MeshData& data)
{
    for (std::size_t i = 0; i < data.subMeshes.size(); ++i)
    {
        const SubMesh& subMesh = data.subMeshes[i];
        const std::string subject = "subMeshes[" + std::to_string(i) + "]: ";
        if (subMesh.indexCount % 3 != 0)
        {
            problems.push_back(subject + std::to_string(subMesh.indexCount) +
                               " indices; a multiple of three is right");
        }
        const std::uint64_t end = std::uint64_t{subMesh.indexStart} + subMesh.indexCount;
        if (end > data.triangles.size())
        {
            problems.push_back(subject + "indices " + std::to_string(subMesh.indexStart) + " to " +
                               std::to_string(end) + " of " +
                               std::to_string(data.triangles.size()));
        }
    }
}

} // namespace

std::vector<std::string> MeshProblems(const MeshData& data)
{
    std::vector<std::string> problems;
    const std::size_t count = data.vertices.size();
    if (count == 0)
    {
        problems.emplace_back("vertices: none; at least one is needed");
    }
    CheckArray(problems, "vertices", data.vertices, count);
    CheckArray(problems, "normals", data.normals, count);
    CheckArray(problems, "tangents", data.tangents, count);
    CheckArray(problems, "colors", data.colors, count);
    CheckArray(problems, "uv", data.uv, count);
    CheckArray(problems, "uv8", data.uv8, count);
    CheckTriangles(problems, data);
    CheckSubMeshes(problems, data);
    return problems;
}

} // namespace limn
