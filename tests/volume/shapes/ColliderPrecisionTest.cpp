#include "blending/VolumeScene.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <limn/core/PrimitiveMesh.h>
#include <precision/RandomFloats.h>

namespace limn
{

namespace
{

using test::RandomFloats;
using Number = long double;
using Vector = std::array<Number, 3>;

Number Length(const Vector& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

/// A collider's place. What follows is worked out from it with 64 bits of mantissa.
struct Place
{
    glm::vec3 position;
    glm::quat rotation;
    glm::vec3 scale;

    /// Of `point` from the place, along the axes of the turned object, not scaled: the rows of the
    /// rotation's matrix, divided by its squared length, against the quaternion's products.
    Vector Offset(const glm::vec3& point) const
    {
        const Number w = rotation.w;
        const Number x = rotation.x;
        const Number y = rotation.y;
        const Number z = rotation.z;
        const Vector from{Number(point.x) - Number(position.x),
                          Number(point.y) - Number(position.y),
                          Number(point.z) - Number(position.z)};
        const Number square = w * w + x * x + y * y + z * z;
        const std::array<Vector, 3> columns{
            {{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
             {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
             {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}}};
        Vector turned{};
        for (std::size_t i = 0; i < 3; ++i)
        {
            const Vector& column = columns[i];
            turned[i] = (column[0] * from[0] + column[1] * from[1] + column[2] * from[2]) / square;
        }
        return turned;
    }
};

/// What is left of a coordinate outside of -half...half.
Number Outside(Number coordinate, Number half)
{
    return std::max(std::abs(coordinate) - half, Number(0));
}

Number BoxDistance(const Place& place, const glm::vec3& center, const glm::vec3& size,
                   const glm::vec3& point)
{
    Vector outside = place.Offset(point);
    for (int i = 0; i < 3; ++i)
    {
        const Number scale = place.scale[i];
        Number& coordinate = outside[static_cast<std::size_t>(i)];
        coordinate =
            Outside(coordinate - scale * Number(center[i]), std::abs(scale * Number(size[i])) / 2);
    }
    return Length(outside);
}

Number CapsuleDistance(const Place& place, const CapsuleCollider& capsule, const glm::vec3& point)
{
    Vector offset = place.Offset(point);
    Number across = 0;
    for (int i = 0; i < 3; ++i)
    {
        offset[static_cast<std::size_t>(i)] -= Number(place.scale[i]) * Number(capsule.center[i]);
        across =
            i == capsule.direction ? across : std::max(across, std::abs(Number(place.scale[i])));
    }
    const Number radius = across * Number(capsule.radius);
    const Number tip =
        std::abs(Number(place.scale[capsule.direction])) * Number(capsule.height) / 2;
    Number& along = offset[static_cast<std::size_t>(capsule.direction)];
    along = Outside(along, std::max(tip - radius, Number(0)));
    return Outside(Length(offset), radius);
}

Number SphereDistance(const Place& place, const SphereCollider& sphere, const glm::vec3& point)
{
    const glm::vec3 lengths = glm::abs(place.scale);
    const Number longest = std::max({lengths.x, lengths.y, lengths.z});
    Vector offset = place.Offset(point);
    for (int i = 0; i < 3; ++i)
    {
        offset[static_cast<std::size_t>(i)] -= Number(place.scale[i]) * Number(sphere.center[i]);
    }
    return Outside(Length(offset), longest * Number(sphere.radius));
}

/// From a millimetre to a hundred kilometres, as likely in each decade.
float AnySize(RandomFloats& random)
{
    return std::pow(10.0f, random.Between(-3.0f, 5.0f));
}

glm::vec3 AnyVector(RandomFloats& random, float size)
{
    return {random.Between(-size, size), random.Between(-size, size), random.Between(-size, size)};
}

/// Places of all sizes, turned, mirrored, some flat; and points in, on, beside and far from them.
struct RandomPlaces
{
    RandomFloats random{11};

    Place Next()
    {
        const float size = AnySize(random);
        Place place{AnyVector(random, AnySize(random)),
                    glm::normalize(glm::quat(random.Between(-1.0f, 1.0f), AnyVector(random, 1.0f))),
                    AnyVector(random, size)};
        if (random.Below(8) == 0)
        {
            place.scale[random.Below(3)] = 0.0f;
        }
        if (random.Below(4) == 0)
        {
            place.rotation = glm::quat(1, 0, 0, 0);
        }
        return place;
    }
    glm::vec3 PointAt(const Place& place)
    {
        const float size = std::max(
            {std::abs(place.scale.x), std::abs(place.scale.y), std::abs(place.scale.z), 1e-3f});
        return place.position + AnyVector(random, random.Below(4) == 0 ? 100.0f * size : size);
    }
};

/// All lengths that take part.
Number SizeOf(const Place& place, const glm::vec3& point)
{
    return Number(glm::length(place.position)) + Number(glm::length(point)) +
           Number(glm::length(place.scale)) * 4;
}

/// Keeps the largest error, as a share of what a double can hold of the lengths that take part.
class LargestError
{
public:
    void Add(const Collider& collider, const Place& place, const glm::vec3& point, Number exact)
    {
        const auto closest = std::visit(
            [&](const auto& shape)
            { return shape.ClosestPoint(point, place.position, place.rotation, place.scale); },
            collider);
        const Vector offset{Number(closest.x) - Number(point.x),
                            Number(closest.y) - Number(point.y),
                            Number(closest.z) - Number(point.z)};
        const Number error = std::abs(Length(offset) - exact);
        m_Largest = std::max(m_Largest, error / SizeOf(place, point));
    }
    /// @param ulps  of a double
    void Expect(const char* what, double ulps) const
    {
        const double found = static_cast<double>(m_Largest) * 0x1p52;
        std::cout << what << ": off by up to " << found << " double ulp of the lengths\n";
        EXPECT_LE(found, ulps) << what;
    }

private:
    Number m_Largest = 0;
};

// A turn takes about 20 operations, a length, a scaling and a sum a few more, each off by 2^-53 of
// the lengths at most.
constexpr double k_Ulps = 16.0;

TEST(ColliderPrecision, DistancesAreThoseOfTheExactShapes)
{
    RandomPlaces places;
    RandomFloats& random = places.random;
    LargestError box;
    LargestError sphere;
    LargestError capsule;
    LargestError mesh;
    const Collider cube = MeshCollider(CreatePrimitive(PrimitiveType::Cube));
    for (int i = 0; i < 25'000; ++i)
    {
        const Place place = places.Next();
        const glm::vec3 point = places.PointAt(place);
        const glm::vec3 center = AnyVector(random, 1.0f);
        const glm::vec3 size = AnyVector(random, 2.0f);
        box.Add(BoxCollider{true, center, size}, place, point,
                BoxDistance(place, center, size, point));
        const SphereCollider ball{true, center, random.Between(0.0f, 1.0f)};
        sphere.Add(ball, place, point, SphereDistance(place, ball, point));
        const CapsuleCollider pill{true, center, random.Between(0.0f, 1.0f),
                                   random.Between(0.0f, 3.0f), random.Below(3)};
        capsule.Add(pill, place, point, CapsuleDistance(place, pill, point));
        if (i % 10 == 0) // it looks at every triangle
        {
            mesh.Add(cube, place, point,
                     BoxDistance(place, glm::vec3(0.0f), glm::vec3(1.0f), point));
        }
    }
    box.Expect("boxes", k_Ulps);
    sphere.Expect("spheres", k_Ulps);
    capsule.Expect("capsules", k_Ulps);
    mesh.Expect("meshes", k_Ulps);
}

} // namespace

} // namespace limn
