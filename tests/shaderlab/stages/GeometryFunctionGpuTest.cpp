#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vulkan/GpuTestDevice.h>

// GeometricTools.hlsl, and the matrices and ranges of Common.hlsl, against geometry done another
// way.

namespace limn::test
{

namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

constexpr const char* k_Geometry =
    "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/GeometricTools.hlsl\"\n";
const dvec3 k_BoxMin(-1, -2, 0.5);
const dvec3 k_BoxMax(2, 1, 3);

/// Where a ray passes the six sides of the box of the tests: the first and the last place, 9, 9 if
/// it misses.
dvec2 HitsOfBox(const dvec3& origin, const dvec3& direction)
{
    double first = 9.0;
    double last = -9.0;
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const double side : {k_BoxMin[axis], k_BoxMax[axis]})
        {
            const double t = (side - origin[axis]) / direction[axis];
            const dvec3 p = origin + direction * t;
            bool on = std::isfinite(t);
            for (int other = 0; other < 3; ++other)
            {
                on = on && (other == axis || (p[other] >= k_BoxMin[other] - 1e-9 &&
                                              p[other] <= k_BoxMax[other] + 1e-9));
            }
            first = on ? std::min(first, t) : first;
            last = on ? std::max(last, t) : last;
        }
    }
    return last < first ? dvec2(9.0) : dvec2(first, last);
}

/// From the point of the ray that is nearest to the middle of the sphere, back and ahead.
dvec2 HitsOfSphere(const dvec3& origin, const dvec3& direction, double radius)
{
    const double speed = glm::length(direction);
    const double nearest = -glm::dot(origin, direction) / speed;
    const double height = glm::length(origin + direction / speed * nearest);
    const double half = std::sqrt(radius * radius - height * height);
    return dvec2(nearest - half, nearest + half) / speed;
}

std::vector<GridInput> Rays()
{
    return CombineVectors({{-4, 0.1, 1.2}, {0.3, -0.7, 6}, {0.5, 0.2, 1.5}, {0.5, 5, 2}},
                          {{1, 0.05, 0.1}, {0.02, -0.1, -1}, {0.3, -2, 0.1}, {-0.4, 0.6, -0.5}});
}

} // namespace

using GeometryFunctions = GpuTest;

TEST_F(GeometryFunctions, InvertMatricesAndMoveBetweenRanges)
{
    FunctionGrid grid(k_Geometry + std::string(R"(
        float4 Solve(float3 scale, float3 position, float3 v)
        {
            float4x4 m = float4x4(scale.x, 0.5, -1, position.x, 0.25, scale.y, 2, position.y,
                                  -0.75, 1.5, scale.z, position.z, 0.1, -0.2, 0.05, 1.5);
            return mul(Inverse(m), float4(v, 1));
        })"));
    grid.Add("Solve(a.xyz, b.xyz, c.xyz)",
             CombineVectors({{3, 2, 4}, {-1, 5, 0.5}}, {{0, 0, 0}, {7, -3, 1}},
                            {{1, 0, 0}, {0.5, -2, 3}}),
             [](auto& s, auto& p, auto& v)
             {
                 const glm::dmat4 rows(s.x, 0.5, -1, p.x, 0.25, s.y, 2, p.y, -0.75, 1.5, s.z, p.z,
                                       0.1, -0.2, 0.05, 1.5);
                 return glm::inverse(glm::transpose(rows)) * dvec4(dvec3(v), 1.0);
             },
             {1e-5, 2e-6});
    grid.Add("mul(RotationFromAxisAngle(a.xyz, sin(c.x), cos(c.x)), b.xyz)",
             CombineVectors(UnitVectors(), {{1, 2, -3}, {0, 0.5, 0}}, {{0, 0, 0}, {1.2, 0, 0}}),
             [](auto& a, auto& b, auto& c)
             { return dvec3(glm::rotate(glm::dmat4(1.0), c.x, dvec3(a)) * dvec4(dvec3(b), 0.0)); },
             {1e-5, 2e-6, 7.5});
    grid.Run();
}

TEST_F(GeometryFunctions, SolveQuadraticEquations)
{
    FunctionGrid grid(k_Geometry + std::string(R"(
        float3 Roots(float a, float b, float c)
        {
            float2 roots;
            bool real_ = SolveQuadraticEquation(a, b, c, roots);
            return real_ ? float3(roots, 1) : float3(0, 0, 0);
        })"));
    // a (t - b)(t - c)
    grid.Add("Roots(a.x, -a.x * (b.x + c.x), a.x * b.x * c.x)",
             Combine({-2.0, 0.5, 1.0}, {-3.0, 0.0, 2.0}, {-1.0, 4.0, 8.0}),
             [](auto&, auto& b, auto& c)
             { return dvec3(std::min(b.x, c.x), std::max(b.x, c.x), 1.0); });
    // a ((t - 1)^2 + b)
    grid.Add("Roots(a.x, -2 * a.x, a.x * (1 + b.x))", Combine({-2.0, 1.0}, {0.25, 3.0}),
             [](auto&, auto&, auto&) { return dvec3(0.0); });
    grid.Run();
}

TEST_F(GeometryFunctions, MeetBoxesAndSpheresWithRays)
{
    FunctionGrid grid(k_Geometry + std::string(R"(
        float3 Box(float3 origin, float3 direction, float tMin, float tMax)
        {
            float first, last;
            bool hit = IntersectRayAABB(origin, direction, float3(-1, -2, 0.5), float3(2, 1, 3),
                                        tMin, tMax, first, last);
            return hit ? float3(first, last, 1) : float3(9, 9, 0);
        }
        float3 Sphere(float3 origin, float3 direction, float radius)
        {
            float2 t;
            bool hit = IntersectRaySphere(origin, direction, radius, t);
            return hit ? float3(t, 1) : float3(9, 9, 0);
        })"));
    const Tolerance tolerance{1e-5, 1e-5};
    grid.Add(
        "Box(a.xyz, b.xyz, -100, 100)", Rays(),
        [](auto& a, auto& b, auto&)
        {
            const dvec2 t = HitsOfBox(dvec3(a), dvec3(b));
            return dvec3(t, t.x != 9.0 ? 1.0 : 0.0);
        },
        tolerance);
    // Along an axis, beside the box and through it; and only from 2 to 3.
    grid.Add("Box(a.xyz, float3(1, 0, 0), -100, 100)", {{{-4, 0, 1, 0}}, {{-4, 1.5, 1, 0}}},
             [](auto& a, auto&, auto&) { return a.y < 1 ? dvec3(3, 6, 1) : dvec3(9, 9, 0); });
    grid.Add(
        "Box(a.xyz, float3(1, 0, 0), 2, 3)",
        {{{-1.5, 0, 1, 0}}, {{-3.5, 0, 1, 0}}, {{-5, 0, 1, 0}}},
        [](auto& a, auto&, auto&)
        {
            // enters at 0.5, 2.5, 4 and leaves at 3.5, 5.5, 7
            return a.x == -1.5 ? dvec3(2, 3, 1) : a.x == -3.5 ? dvec3(2.5, 3, 1) : dvec3(9, 9, 0);
        });
    std::vector<GridInput> inside =
        CombineVectors({{0.5, 0.2, 1.5}, {1.5, -1.5, 2.75}}, {{1, 2, -3}, {-0.2, -0.1, 0.3}});
    grid.Add(
        "IntersectRayAABBSimple(a.xyz, b.xyz, float3(-1, -2, 0.5), float3(2, 1, 3))", inside,
        [](auto& a, auto& b, auto&) { return HitsOfBox(dvec3(a), dvec3(b)).y; }, tolerance);
    const auto rays = CombineVectors({{-5, 0.5, 1}, {0.3, 0.4, -0.2}, {0, 1, -6}},
                                     {{1, 0.1, -0.2}, {0.1, -0.3, 2}});
    grid.Add(
        "Sphere(a.xyz, b.xyz, 2)", rays,
        [](auto& a, auto& b, auto&)
        {
            const dvec2 t = HitsOfSphere(dvec3(a), dvec3(b), 2.0);
            return std::isnan(t.x) ? dvec3(9, 9, 0) : dvec3(t, 1);
        },
        tolerance);
    grid.Add(
        "IntersectRaySphereSimple(a.xyz, b.xyz, 2)",
        CombineVectors({{0, 0, 0}, {0.3, 0.4, -0.2}, {-1.2, 0.5, 1}}, UnitVectors()),
        [](auto& a, auto& b, auto&) { return HitsOfSphere(dvec3(a), dvec3(b), 2.0).y; }, tolerance);
    grid.Run();
}

TEST_F(GeometryFunctions, MeetPlanesAndMeasureDistances)
{
    FunctionGrid grid(k_Geometry + std::string(R"(
        float2 Plane(float3 origin, float3 direction, float3 place, float3 normal)
        {
            float t;
            bool hit = IntersectRayPlane(origin, direction, place, normal, t);
            return float2(t, hit);
        })"));
    // The plane z = 2 turned by a quarter about x: y = -2.
    grid.Add("IntersectRayPlane(a.xyz, b.xyz, float3(5, -2, 7), float3(0, 1, 0))",
             CombineVectors({{1, 4, 2}, {-3, -5, 0}}, {{0.5, -2, 1}, {0.25, 1, 0}}),
             [](auto& a, auto& b, auto&)
             {
                 const double t = (-2.0 - a.y) / b.y;
                 return dvec3(a.x + t * b.x, -2.0, a.z + t * b.z);
             },
             {1e-5, 1e-5});
    grid.Add("Plane(a.xyz, b.xyz, float3(5, -2, 7), float3(0, 1, 0))",
             {{{1, 4, 2, 0}, {0.5, -2, 1, 0}},
              {{1, 4, 2, 0}, {0.5, 2, 1, 0}},
              {{1, 4, 2, 0}, {1, 0, 0, 0}}},
             [](auto&, auto& b, auto&) {
                 return b.y < 0 ? dvec2(3, 1) : b.y > 0 ? dvec2(-3, 0) : dvec2(-1, 0);
             });
    const auto points = CombineVectors({{0, 0, 1}, {4, 0, 1}, {4, 5, 1}, {-2, 4, -11.5}});
    const auto fromBox = [](auto& a)
    {
        return a.x == 0.0 ? 0.0 : a.x == -2.0 ? 12.4096736 : a.y == 0.0 ? 2.0 : std::sqrt(20.0);
    };
    grid.Add("DistancePointBox(a.xyz, float3(-1, -2, 0.5), float3(2, 1, 3))", points,
             [fromBox](auto& a, auto&, auto&) { return fromBox(a); });
    grid.Add("IntersectSphereAABB(a.xyz, 4.4, float3(-1, -2, 0.5), float3(2, 1, 3))", points,
             [fromBox](auto& a, auto&, auto&) { return fromBox(a) < 4.4 ? 1.0 : 0.0; });
    grid.Add("ProjectPointOnPlane(a.xyz, float3(1, 1, 1), float3(0, 0.6, 0.8))", points,
             [](auto& a, auto&, auto&)
             {
                 const double above = 0.6 * a.y + 0.8 * a.z - 1.4;
                 return dvec3(a.x, a.y - 0.6 * above, a.z - 0.8 * above);
             });
    grid.Add("DistanceFromPlane(a.xyz, float4(0, 0.6, 0.8, -1.4))", points,
             [](auto& a, auto&, auto&) { return 0.6 * a.y + 0.8 * a.z - 1.4; }, {1e-5, 1e-6});
    grid.Run();
}

TEST_F(GeometryFunctions, CullTriangles)
{
    FunctionGrid grid(k_Geometry + std::string(R"(
        bool Frustum(float3 at, float epsilon)
        {
            float4 box[6] = {float4(1, 0, 0, 1), float4(-1, 0, 0, 1), float4(0, 1, 0, 1),
                             float4(0, -1, 0, 1), float4(0, 0, 1, 1), float4(0, 0, -1, 1)};
            return CullTriangleFrustum(at, at + float3(1, 0, 0), at + float3(0, 1, 0), epsilon, box, 6);
        })"));
    // The box is -1...1: only the last is right of it by 0.5 as a whole.
    grid.Add("Frustum(a.xyz, a.w)",
             {{{0, 0, 0, 0}},
              {{-1.5, 0, 0, 0}},
              {{-2.5, 0, 0, 0}},
              {{-2.5, 0, 0, -1}},
              {{0, 1.5, 0, 0}}},
             [](auto& a, auto&, auto&)
             { return (a.x == -2.5 && a.w == 0.0) || a.y == 1.5 ? 1.0 : 0.0; });
    // Counter-clockwise seen from +z.
    grid.Add(
        "CullTriangleBackFace(float3(0, 0, 0), float3(1, 0, 0), float3(0, 1, 0), a.w, a.xyz, b.x)",
        {{{0, 0, 5, 0}, {1, 0, 0, 0}},
         {{0, 0, -5, 0}, {1, 0, 0, 0}},
         {{0, 0, -5, 0}, {-1, 0, 0, 0}},
         {{3, 0, -4, -0.9}, {1, 0, 0, 0}},
         {{3, 0, -4, -0.7}, {1, 0, 0, 0}}},
        [](auto& a, auto& b, auto&)
        { return b.x * a.z / glm::length(dvec3(a)) < a.w ? 1.0 : 0.0; });
    grid.Run();
}

} // namespace limn::test
