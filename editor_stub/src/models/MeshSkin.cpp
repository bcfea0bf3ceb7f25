#include "models/MeshSkin.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_relational.hpp>
#include <glm/geometric.hpp>

namespace limn
{

namespace
{

bool IsIdentity(const glm::dmat4& matrix)
{
    constexpr double k_Rounding = 1e-5;
    return glm::all(glm::equal(matrix, glm::dmat4(1.0), k_Rounding));
}

/// Normals keep their side of the surface when they are multiplied with it, and it needs no
/// division.
glm::dmat3 CofactorsOf(const glm::dmat3& m)
{
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0.0 ? -cofactors : cofactors;
}

glm::vec3 DirectionOr(const glm::vec3& other, const glm::dvec3& direction)
{
    const double length = glm::length(direction);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(direction / length) : other;
}

} // namespace

void Normalize(BoneWeights& weights)
{
    double sum = 0.0;
    for (BoneWeight& each : weights)
    {
        each.weight = std::isfinite(each.weight) ? std::max(each.weight, 0.0f) : 0.0f;
        sum += static_cast<double>(each.weight);
    }
    for (BoneWeight& each : weights)
    {
        each.weight = sum > 0.0 ? static_cast<float>(static_cast<double>(each.weight) / sum) : 0.0f;
    }
}

std::shared_ptr<const Mesh> PoseMesh(const std::shared_ptr<const Mesh>& mesh, const MeshSkin& skin,
                                     std::span<const glm::dmat4> bones)
{
    std::vector<glm::dmat4> matrices;
    for (std::size_t i = 0; i < bones.size(); ++i)
    {
        matrices.push_back(bones[i] * glm::dmat4(skin.bindPoses.at(i)));
    }
    if (std::ranges::all_of(matrices, IsIdentity))
    {
        return mesh;
    }
    MeshData data = mesh->data();
    for (std::size_t i = 0; i < data.vertices.size(); ++i)
    {
        glm::dmat4 matrix(0.0);
        double sum = 0.0;
        for (const BoneWeight& each : skin.weights.at(i))
        {
            const auto weight = static_cast<double>(each.weight);
            sum += weight;
            matrix += weight > 0.0 ? weight * matrices.at(each.bone) : glm::dmat4(0.0);
        }
        if (sum <= 0.0)
        {
            continue;
        }
        data.vertices[i] = glm::vec3(matrix * glm::dvec4(glm::dvec3(data.vertices[i]), 1.0));
        if (!data.normals.empty())
        {
            data.normals[i] = DirectionOr(data.normals[i], CofactorsOf(glm::dmat3(matrix)) *
                                                               glm::dvec3(data.normals[i]));
        }
        if (!data.tangents.empty())
        {
            const glm::vec3 along(data.tangents[i]);
            data.tangents[i] = glm::vec4(DirectionOr(along, glm::dmat3(matrix) * glm::dvec3(along)),
                                         data.tangents[i].w);
        }
    }
    return std::make_shared<const Mesh>(mesh->name(), std::move(data));
}

} // namespace limn
