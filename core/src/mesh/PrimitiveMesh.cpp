#include <limn/core/PrimitiveMesh.h>

#include "mesh/MeshBuilder.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limn/base/Case.h>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

constexpr double k_Pi = 3.141592653589793;
constexpr int k_Segments = 32; ///< around the y axis
constexpr int k_Rings = 16;    ///< from pole to pole of a sphere

/// Rings `first` to `last` of a sphere of diameter 1 that is lifted by `y`.
/// @param vScale,vOffset  map the ring's share of the way down, 0...1, to v
void AddSphereRings(std::vector<ProfilePoint>& profile, int first, int last, float y, float vScale,
                    float vOffset)
{
    for (int ring = first; ring <= last; ++ring)
    {
        const double angle = k_Pi * ring / k_Rings;
        const bool pole = ring == 0 || ring == k_Rings;
        const glm::vec2 normal{pole ? 0.0 : std::sin(angle), std::cos(angle)};
        const float share = static_cast<float>(ring) / k_Rings;
        profile.push_back({0.5f * normal.x, y + 0.5f * normal.y, normal, vOffset + vScale * share});
    }
}

void BuildSphere(MeshBuilder& builder)
{
    std::vector<ProfilePoint> profile;
    AddSphereRings(profile, 0, k_Rings, 0.0f, 1.0f, 0.0f);
    builder.AddRevolution(profile, k_Segments);
}

void BuildCapsule(MeshBuilder& builder)
{
    // v follows the way along the outline: two quarter circles of radius 0.5 and a line of 1.
    const double length = 0.5 * k_Pi + 1.0;
    const auto lineShare = static_cast<float>(1.0 / length);
    const auto roundShare = static_cast<float>(0.5 * k_Pi / length);
    std::vector<ProfilePoint> profile;
    AddSphereRings(profile, 0, k_Rings / 2, 0.5f, roundShare, 0.0f);
    AddSphereRings(profile, k_Rings / 2, k_Rings, -0.5f, roundShare, lineShare);
    builder.AddRevolution(profile, k_Segments);
}

void BuildCylinder(MeshBuilder& builder)
{
    builder.AddRevolution({{0.5f, 1.0f, {1.0f, 0.0f}, 0.0f}, {0.5f, -1.0f, {1.0f, 0.0f}, 1.0f}},
                          k_Segments);
    builder.AddDisc(0.5f, 1.0f, 1.0f, k_Segments);
    builder.AddDisc(0.5f, -1.0f, -1.0f, k_Segments);
}

void BuildCube(MeshBuilder& builder)
{
    const glm::vec3 x{0.5f, 0.0f, 0.0f};
    const glm::vec3 y{0.0f, 0.5f, 0.0f};
    const glm::vec3 z{0.0f, 0.0f, 0.5f};
    builder.AddGrid(-z, x, y, 1);
    builder.AddGrid(x, z, y, 1);
    builder.AddGrid(z, -x, y, 1);
    builder.AddGrid(-x, -z, y, 1);
    builder.AddGrid(y, x, z, 1);
    builder.AddGrid(-y, x, -z, 1);
}

void BuildTorus(MeshBuilder& builder)
{
    std::vector<ProfilePoint> profile;
    for (int ring = 0; ring <= k_Rings; ++ring)
    {
        // From the inner side over the top; the last ring is exactly the first, so that it closes.
        const double angle = k_Pi * (1.0 - 2.0 * (ring % k_Rings) / k_Rings);
        const glm::vec2 normal{std::cos(angle), std::sin(angle)};
        profile.push_back({0.5f + 0.125f * normal.x, 0.125f * normal.y, normal,
                           static_cast<float>(ring) / k_Rings});
    }
    builder.AddRevolution(profile, k_Segments);
}

void BuildPlane(MeshBuilder& builder)
{
    // Unity's plane has its picture's top at -z, so its right is at -x.
    builder.AddGrid({}, {-5.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -5.0f}, 10);
}

void BuildQuad(MeshBuilder& builder)
{
    builder.AddGrid({}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}, 1);
}

struct Primitive
{
    std::string_view name;
    void (*build)(MeshBuilder&);
};

constexpr Primitive k_Primitives[] = {{"sphere", &BuildSphere},     {"capsule", &BuildCapsule},
                                      {"cylinder", &BuildCylinder}, {"cube", &BuildCube},
                                      {"plane", &BuildPlane},       {"quad", &BuildQuad},
                                      {"torus", &BuildTorus}};

} // namespace

std::shared_ptr<const Mesh> CreatePrimitive(PrimitiveType type)
{
    const auto index = static_cast<std::size_t>(type);
    if (index >= std::size(k_Primitives))
    {
        throw ContractError("PrimitiveType " + std::to_string(static_cast<int>(type)) +
                            " is not one that limn knows");
    }
    MeshBuilder builder;
    k_Primitives[index].build(builder);
    return std::make_shared<const Mesh>(std::string(k_Primitives[index].name), builder.Take());
}

std::optional<PrimitiveType> PrimitiveTypeFromName(std::string_view name)
{
    const auto* const named = std::ranges::find_if(k_Primitives, [&](const auto& each)
                                                   { return EqualsIgnoringCase(name, each.name); });
    return named == std::end(k_Primitives)
               ? std::nullopt
               : std::optional(static_cast<PrimitiveType>(named - k_Primitives));
}

std::vector<std::string_view> PrimitiveTypeNames()
{
    std::vector<std::string_view> names;
    for (const Primitive& primitive : k_Primitives)
    {
        names.push_back(primitive.name);
    }
    return names;
}

} // namespace limn
