#include <limn/core/Mesh.h>

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
        problems.push_back(name + ": the list has " + std::to_string(size) + " elements for " +
                           std::to_string(data.vertices.size()) +
                           " vertices; it must have one per vertex, or none");
    }
    const auto bad =
        std::ranges::find_if_not(values, [](float value) { return std::isfinite(value); });
    if (bad != values.end())
    {
        const auto index = static_cast<std::size_t>(bad - values.begin()) / attribute.components;
        problems.push_back(name + "[" + std::to_string(index) +
                           "]: the value is not a finite number");
    }
}

void CheckTriangles(std::vector<std::string>& problems, const MeshData& data)
{
    const std::vector<std::uint32_t>& indices = data.triangles;
    if (indices.size() % 3 != 0)
    {
        problems.push_back("triangles: the list has " + std::to_string(indices.size()) +
                           " indices; their number must be a multiple of three");
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
                           std::to_string(*first) + " is too large for " + std::to_string(limit) +
                           " vertices; the number of such indices is " + std::to_string(count));
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
            problems.push_back(subject + "it has " + std::to_string(subMesh.indexCount) +
                               " indices; their number must be a multiple of three");
        }
        const std::uint64_t end = std::uint64_t{subMesh.indexStart} + subMesh.indexCount;
        if (end > data.triangles.size())
        {
            problems.push_back(subject + "it ranges over the indices " +
                               std::to_string(subMesh.indexStart) + " to " + std::to_string(end) +
                               ", but the mesh has only " + std::to_string(data.triangles.size()));
        }
    }
}

} // namespace

std::vector<std::string> MeshProblems(const MeshData& data)
{
    std::vector<std::string> problems;
    if (data.vertices.empty())
    {
        problems.emplace_back("vertices: the list is empty; at least one vertex is needed");
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
