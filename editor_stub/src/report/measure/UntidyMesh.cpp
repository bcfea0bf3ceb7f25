#include "report/measure/UntidyMesh.h"

#include <glm/geometric.hpp>
#include <utility>

namespace limn::study
{

namespace
{

constexpr float k_FinHeight = 0.4f; ///< of the edge's distance from the mesh's origin

bool IsTurned(Untidiness untidiness, std::size_t triangle)
{
    const bool isAtRandom =
        untidiness == Untidiness::TurnedAtRandom || untidiness == Untidiness::Soup;
    return (untidiness == Untidiness::OneTriangleTurned && triangle == 5) ||
           (untidiness == Untidiness::OneFaceTurned && triangle / 2 == 2) ||
           // Knuth's multiplicative hash
           (isAtRandom && (triangle * 2654435761u >> 7 & 1u) != 0);
}

} // namespace

std::shared_ptr<const Mesh> MakeUntidy(const Mesh& tidy, Untidiness untidiness)
{
    MeshData data;
    data.vertices = tidy.data().vertices;
    data.normals = tidy.data().normals;
    const auto add = [&data](std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        data.triangles.insert(data.triangles.end(), {a, b, c});
    };
    // Adds a vertex between two others, its distance from the origin times a factor.
    const auto addPoint = [&data](std::uint32_t a, std::uint32_t b, float factor = 1.0f)
    {
        data.vertices.push_back((data.vertices[a] + data.vertices[b]) * (0.5f * factor));
        data.normals.push_back(glm::normalize(data.normals[a] + data.normals[b]));
        return static_cast<std::uint32_t>(data.vertices.size() - 1);
    };
    const std::vector<std::uint32_t>& corners = tidy.data().triangles;
    const std::size_t count = corners.size() / 3;
    for (std::size_t number = untidiness == Untidiness::Open ? count / 3 : 0; number < count;
         ++number)
    {
        std::uint32_t a = corners[number * 3];
        std::uint32_t b = corners[number * 3 + 1];
        std::uint32_t c = corners[number * 3 + 2];
        if (untidiness == Untidiness::TJunctions && number % 2 == 0)
        {
            const std::uint32_t middle = addPoint(a, b);
            add(a, middle, c);
            add(middle, b, c);
            continue;
        }
        if (untidiness == Untidiness::Soup)
        {
            a = addPoint(a, a);
            b = addPoint(b, b);
            c = addPoint(c, c);
        }
        if (IsTurned(untidiness, number))
        {
            std::swap(b, c);
        }
        add(a, b, c);
        if (untidiness == Untidiness::Doubled)
        {
            add(b, c, a);
        }
        if (untidiness == Untidiness::DoubleSided)
        {
            add(a, c, b);
        }
        if (untidiness == Untidiness::NoArea && number % 2 == 0)
        {
            add(a, addPoint(a, b), b);
            add(c, c, c);
        }
        if (untidiness == Untidiness::Fins && number % 24 == 0)
        {
            add(a, b, addPoint(a, b, 1.0f + k_FinHeight));
        }
    }
    return std::make_shared<const Mesh>(k_UntidinessNames[static_cast<std::size_t>(untidiness)],
                                        std::move(data));
}

} // namespace limn::study
