#include "mesh/MeshProblems.h"

#include <algorithm>
#include <cmath>
#include <limn/core/Mesh.h>

namespace limn
{

namespace
{

void CheckArray(std::vector<std::string>& problems, const VertexAttribute& attribute,
                const MeshData& data)
{
    const std::string name(attribute.array);
    const std::span<const float> values = attribute.values(data);
    const std::size_t size = values.size() / attribute.components;
    if (size != 0 && size != data.vertices.size())
    {
        problems.push_back(name + ": " + std::to_string(size) + " elements for " +
                           std::to_string(data.vertices.size()) +
                           " vertices; one a vertex or none is right");
    }
    const auto bad =
        std::ranges::find_if_not(values, [](float value) { return std::isfinite(value); });
    if (bad != values.end())
    {
        const auto index = static_cast<std::size_t>(bad - values.begin()) / attribute.components;
        problems.push_back(name + "[" + std::to_string(index) + "]: not a finite number");
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
    if (data.vertices.empty())
    {
        problems.emplace_back("vertices: none; at least one is needed");
    }
    for (const VertexAttribute& attribute : VertexAttributes())
    {
        CheckArray(problems, attribute, data);
    }
    CheckTriangles(problems, data);
    CheckSubMeshes(problems, data);
    return problems;
}

} // namespace limn
