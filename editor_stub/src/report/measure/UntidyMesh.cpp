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
    switch (untidiness)
    {
    case Untidiness::OneTriangleTurned:
        return triangle == 5;
    case Untidiness::OneFaceTurned:
        return triangle / 2 == 2;
    case Untidiness::TurnedAtRandom:
    case Untidiness::Soup:
        return (triangle * 2654435761u >> 7 & 1u) != 0; // Knuth's multiplicative hash
    default:
        return false;
    }
}

/// The copy while it is made.
class UntidyMesh
{
public:
    explicit UntidyMesh(const Mesh& tidy) : m_Tidy(tidy.data())
    {
        m_Data.vertices = m_Tidy.vertices;
        m_Data.normals = m_Tidy.normals;
    }

    void AddTriangle(Untidiness untidiness, std::size_t number)
    {
        std::uint32_t a = m_Tidy.triangles[number * 3];
        std::uint32_t b = m_Tidy.triangles[number * 3 + 1];
        std::uint32_t c = m_Tidy.triangles[number * 3 + 2];
        if (untidiness == Untidiness::Open && number < m_Tidy.triangles.size() / 9)
        {
            return;
        }
        if (untidiness == Untidiness::TJunctions && number % 2 == 0)
        {
            const std::uint32_t middle = AddPoint(a, b, 1.0f);
            Add(a, middle, c);
            Add(middle, b, c);
            return;
        }
        if (untidiness == Untidiness::Soup)
        {
            a = AddPoint(a, a, 1.0f);
            b = AddPoint(b, b, 1.0f);
            c = AddPoint(c, c, 1.0f);
        }
        if (IsTurned(untidiness, number))
        {
            std::swap(b, c);
        }
        Add(a, b, c);
        if (untidiness == Untidiness::Doubled)
        {
            Add(b, c, a);
        }
        if (untidiness == Untidiness::DoubleSided)
        {
            Add(a, c, b);
        }
        if (untidiness == Untidiness::NoArea && number % 2 == 0)
        {
            Add(a, AddPoint(a, b, 1.0f), b);
            Add(c, c, c);
        }
        if (untidiness == Untidiness::Fins && number % 24 == 0)
        {
            Add(a, b, AddPoint(a, b, 1.0f + k_FinHeight));
        }
    }

    std::shared_ptr<const Mesh> Finish(const std::string& name)
    {
        return std::make_shared<const Mesh>(name, std::move(m_Data));
    }

private:
    void Add(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        m_Data.triangles.insert(m_Data.triangles.end(), {a, b, c});
    }
    /// Between two vertices, its distance from the origin times a factor.
    std::uint32_t AddPoint(std::uint32_t a, std::uint32_t b, float factor)
    {
        m_Data.vertices.push_back((m_Data.vertices[a] + m_Data.vertices[b]) * (0.5f * factor));
        m_Data.normals.push_back(glm::normalize(m_Data.normals[a] + m_Data.normals[b]));
        return static_cast<std::uint32_t>(m_Data.vertices.size() - 1);
    }

    const MeshData& m_Tidy;
    MeshData m_Data;
};

} // namespace

const std::vector<std::string>& UntidinessNames()
{
    static const std::vector<std::string> names = {"tidy",
                                                   "one triangle turned",
                                                   "one face turned",
                                                   "turned at random",
                                                   "doubled",
                                                   "double-sided",
                                                   "two objects",
                                                   "soup",
                                                   "T-junctions",
                                                   "no area",
                                                   "open",
                                                   "fins"};
    return names;
}

std::shared_ptr<const Mesh> MakeUntidy(const Mesh& tidy, Untidiness untidiness)
{
    UntidyMesh mesh(tidy);
    for (std::size_t i = 0; i < tidy.data().triangles.size() / 3; ++i)
    {
        mesh.AddTriangle(untidiness, i);
    }
    return mesh.Finish(UntidinessNames()[static_cast<std::size_t>(untidiness)]);
}

} // namespace limn::study
