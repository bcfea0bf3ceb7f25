#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// Where the wind moves the vertices of SpeedTrees, in double.

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using SpeedTreeFunctions = GpuTest;

double Fraction(double x)
{
    return x - std::floor(x);
}

/// A wave of -1 to 1 and of length 1 that starts at its trough: the smooth step, there and back.
double Wave(double x)
{
    const double f = Fraction(x);
    const double t = f < 0.5 ? 2 * f : 2 - 2 * f;
    return t * t * (6 - 4 * t) - 1;
}

/// The direction that one number holds.
dvec3 Unpacked(double v)
{
    return {2 * Fraction(v / 16) - 1, 2 * Fraction(v) - 1, 2 * Fraction(v * 16) - 1};
}

dvec3 Turned(const dvec3& v, const dvec3& axis, double angle)
{
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
           axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
}

const std::string k_Wind = "#include \"UnityCG.cginc\"\n#include \"SpeedTreeWind.cginc\"\n";

TEST_F(SpeedTreeFunctions, TreesLeanWithTheirHeight)
{
    FunctionGrid grid(k_Wind, ProgramLanguage::Cg);
    grid.SetGlobal("_ST_WindGlobal", {0, 0.5f, 0.125f, 1.5f});
    grid.SetGlobal("_ST_WindBranchAdherences", {0.25f, 0, 0, 0});
    const auto inputs = CombineVectors({{1, 1, 0.5}, {-1, 4, 2}, {0, 9, 0.25}},
                                       {{0.3, 1.7, 4}, {12, -3.3, 0}}, {{0.6, 0, 0.8}, {0, 1, 0}});
    const auto lean = [](const dvec4& p, const dvec4& tree, const dvec4& wind)
    {
        const double share = std::pow(std::max(0.0, (p.y - 2.0) / 8), 1.5);
        const double second = Wave(tree.y + 1.3 * 0.8);
        const double amount =
            0.5 * (Wave(tree.x + 1.3) + second * second) + 0.25 * 8; // adherence times height
        return dvec3(p) + dvec3(wind.x, 0, wind.z) * amount * share;
    };
    grid.Add("GlobalWind(a.xyz, b.xyz, false, c.xyz, 1.3)", inputs, lean, {1e-4, 1e-5});
    grid.Add("GlobalWind(a.xyz, b.xyz, true, c.xyz, 1.3)", inputs,
             [=](auto& p, auto& tree, auto& wind)
             { return glm::normalize(dvec3(lean(p, tree, wind))) * glm::length(dvec3(p)); },
             {1e-4, 1e-5});
    grid.Run();
}

TEST_F(SpeedTreeFunctions, BranchesSwingAndAreHeld)
{
    FunctionGrid grid(k_Wind, ProgramLanguage::Cg);
    grid.SetGlobal("_ST_WindVector", {1, 0, 0, 0.4f});
    grid.SetGlobal("_ST_WindBranch", {2.25f, 0.75f, 0, 0});
    grid.SetGlobal("_ST_WindBranchTwitch", {0.3f, 1.5f, 0, 0});
    grid.SetGlobal("_ST_WindBranchWhip", {0.5f, 0, 0, 0});
    grid.SetGlobal("_ST_WindBranchAdherences", {0, 0.2f, 0, 0});
    grid.SetGlobal("_ST_WindTurbulences", {0.6f, 0, 0, 0});
    grid.SetGlobal("_ST_WindAnimation", {3.5f, 0, 0, 0});
    const auto slow = [](double x) // towards the extreme of its sign, twice
    {
        const double extreme = x < 0 ? -1 : 1;
        const double once = x + (extreme - x) * std::abs(x);
        return once + (extreme - once) * std::abs(x);
    };
    const auto swing = [=](double offset, double time)
    {
        const double fine = Wave(time + offset);
        const double broad = slow(Wave(time * 1.5 + offset) * Wave(0.75 * (time + offset)));
        return broad * 0.3 * (1 - 0.4) + fine * (1 - 0.3);
    };
    const auto inputs = CombineVectors({{1, 2, 3}, {-1, 0.5, 0}}, {{0, 0, 0}, {0.3, 0.1, 5}},
                                       {{0.25, 5.40625, 0}, {1, 12.71875, 0}, {0, 3, 0}});
    grid.Add("BranchWind(false, a.xyz, b.xyz, float4(c.xy, 0, 0), float3(1, 0, 0), 0)", inputs,
             [=](auto& a, auto& b, auto& c)
             {
                 const double s = swing(c.y, 2.25 + b.x + b.y);
                 return dvec3(a) + Unpacked(c.y) * (c.x * s * 0.75);
             },
             {1e-4, 1e-5});
    grid.Add("BranchWind(true, a.xyz, b.xyz, float4(c.xy, 0, 0), float3(1, 0, 0), float3(0, 8, 1))",
             inputs,
             [=](auto& a, auto& b, auto& c)
             {
                 const double time = 2.25 + b.x + b.y;
                 const double whip = Wave(time + c.y + 1 - c.x);
                 const double s = swing(c.y, time) * (1 + whip * 0.5);
                 const dvec3 swung = dvec3(a) + Unpacked(c.y) * (c.x * s * 0.75);
                 const double w = Wave(time * 0.1 + c.y) * Wave(3.5 * 0.6 * 0.1 + c.y);
                 const double hold = 1 - w * w * 0.6 + whip * 0.4 * 0.5;
                 return swung + (dvec3(0, 8, 1) - swung) * (0.2 * hold * c.x);
             },
             {1e-4, 1e-5});
    // The simple kind, without the slow part.
    grid.Add("SimpleBranchWind(a.xyz, b.xyz, c.x, c.y, 2.25, 0.75, 0.3, 1.5, 0.5, true, false, "
             "false, float3(1, 0, 0))",
             inputs,
             [=](auto& a, auto& b, auto& c)
             {
                 const double time = 2.25 + b.x + b.y;
                 const double s = Wave(time + c.y) * (1 + Wave(time * 0.689 + c.y)) *
                                  (1 + 0.5 * Wave(time + c.y + 1 - c.x));
                 return dvec3(a) + Unpacked(c.y) * (c.x * s * 0.75);
             },
             {1e-4, 1e-5});
    grid.Run();
}

TEST_F(SpeedTreeFunctions, LeavesRippleAndTumbleAboutTheirAnchor)
{
    FunctionGrid grid(k_Wind + R"(
        float3 Leaf(bool best, bool second, float3 p, float3 n, float3 leaf, float3 wind)
        {
            return LeafWind(best, second, p, n, leaf.x, 0, leaf.y, leaf.z, 0.7, wind);
        }
        float3 Normal(float3 p, float3 n, float3 leaf, float3 wind)
        {
            LeafWind(true, false, p, n, leaf.x, 0, leaf.y, leaf.z, 0.7, wind);
            return n;
        })",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_ST_WindLeaf1Ripple", {1.2f, 0.1f, 0, 0});
    grid.SetGlobal("_ST_WindLeaf2Ripple", {0.4f, 0.3f, 0, 0});
    grid.SetGlobal("_ST_WindLeaf1Tumble", {2.1f, 0.2f, 0.5f, 0.3f});
    grid.SetGlobal("_ST_WindLeaf1Twitch", {0.6f, 2.0f, 1.7f, 0});
    const auto inputs = CombineVectors({{1, 0.5, 0}, {-0.2, 0.3, 2}}, {{0, 0, 1}, {0.6, 0.8, 0}},
                                       {{0.5, 5.40625, 9.28125}, {1, 12.71875, 3.5}});
    const auto rippled = [](const dvec4& p, const dvec4& leaf, double time, double amount)
    {
        return dvec3(p) + Unpacked(leaf.z) * (leaf.x * amount * Wave(time + 0.7));
    };
    const dvec3 wind(0.8, 0.6, 0);
    const auto tumble = [=](const dvec3& v, const dvec4& leaf)
    {
        // The anchor is where the leaf's place is told from.
        const double offset = 3 * Fraction(leaf.y * 30.3);
        const double x = Wave(2.1 + offset);
        const double y = Wave(2.1 * 0.75 - offset);
        const dvec3 growth = Unpacked(leaf.y);
        const double along = glm::clamp(glm::dot(growth, wind), -1.0, 1.0);
        const dvec3 axis = glm::normalize(glm::cross(growth, wind) + dvec3(0, along, 0));
        const double t = 1.7 + offset;
        const double other = Wave(0.87 * t);
        const double twitch = 0.6 * std::pow((Wave(t) * other * other + 1) / 2, 2.0);
        const double angle = std::acos(along) * 0.3 + (y - x * x) * 0.2 + twitch;
        // The axis that a leaf grows along need not be of length 1.
        const dvec3 blown = Turned(v, axis, leaf.x * angle);
        return Turned(blown, growth, leaf.x * 0.5 * (x + y * y));
    };
    grid.Add("Leaf(false, false, a.xyz, b.xyz, c.xyz, float3(0.8, 0.6, 0))", inputs,
             [=](auto& a, auto&, auto& c) { return rippled(a, c, 1.2, 0.1); }, {1e-4, 1e-5});
    grid.Add("Leaf(false, true, a.xyz, b.xyz, c.xyz, float3(0.8, 0.6, 0))", inputs,
             [=](auto& a, auto&, auto& c) { return rippled(a, c, 0.4, 0.3); }, {1e-4, 1e-5});
    grid.Add("Leaf(true, false, a.xyz, b.xyz, c.xyz, float3(0.8, 0.6, 0))", inputs,
             [=](auto& a, auto&, auto& c)
             {
                 const dvec3 p = rippled(a, c, 1.2, 0.1);
                 return glm::normalize(tumble(p, c)) * glm::length(p);
             },
             {1e-3, 1e-4});
    grid.Add("Normal(a.xyz, b.xyz, c.xyz, float3(0.8, 0.6, 0))", inputs,
             [=](auto&, auto& b, auto& c) { return tumble(b, c); }, {1e-3, 1e-4});
    grid.Run();
}

TEST_F(SpeedTreeFunctions, FrondsRippleAlongTheirNormal)
{
    FunctionGrid grid(k_Wind + R"(
        float3 Frond(float3 p, float3 n, float u, float v) { return RippleFrond(p, n, u, v, 9, 0.75, 3); })",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_ST_WindFrondRipple", {1.7f, 0.4f, 2.5f, 0});
    grid.Add(
        "Frond(a.xyz, b.xyz, c.x, c.y)",
        CombineVectors({{1, 2, 3}}, {{0, 0, 1}, {0.6, 0, 0.8}}, {{0.25, 0.3, 0}, {0.75, 2, 0}}),
        [](auto& a, auto& b, auto& c)
        {
            const double phase = (1.7 + c.y) * 2.5 + (c.x < 0.5 ? 0.75 : 0.0);
            return dvec3(a) + dvec3(b) * (0.75 * 0.4 * Wave(phase));
        },
        {1e-4, 1e-5});
    grid.Run();
}

/// A turned and scaled object before a camera somewhere.
struct Placed
{
    glm::dmat4 object;
    glm::dmat4 view;
};

Placed Place(FunctionGrid& grid)
{
    Placed placed;
    placed.object = glm::rotate(glm::translate(glm::dmat4(1), dvec3(3, 1, -2)), 0.7,
                                glm::normalize(dvec3(1, 2, 0.5)));
    placed.object = glm::scale(placed.object, dvec3(1, 2, 0.5));
    placed.view = glm::lookAt(dvec3(5, 4, 9), dvec3(0, 1, 0), dvec3(0, 1, 0));
    const auto object = Floats(glm::mat4(placed.object));
    const auto inverse = Floats(glm::mat4(glm::inverse(placed.object)));
    std::copy(object.begin(), object.end(), grid.perDraw.objectToWorld);
    std::copy(inverse.begin(), inverse.end(), grid.perDraw.worldToObject);
    grid.SetGlobal("unity_MatrixInvV", Floats(glm::mat4(glm::inverse(placed.view))));
    return placed;
}

/// An offset in view space, as one in the object's, as long as before.
dvec3 Facing(const Placed& placed, const dvec3& offset)
{
    const glm::dmat3 back = glm::inverse(glm::dmat3(placed.view * placed.object));
    return glm::normalize(back * offset) * glm::length(offset);
}

TEST_F(SpeedTreeFunctions, LeavesFaceTheCamera)
{
    const std::string offset = R"(
        float3 Offset(float3 position, float3 anchor, float lod)
        {
            SpeedTreeVB v = (SpeedTreeVB)0;
            v.vertex = float4(position, 1);
            v.texcoord1 = float4(anchor, 0.5);
            OffsetSpeedTreeVertex(v, lod);
            return v.vertex.xyz;
        })";
    const auto inputs = CombineVectors({{1, 2, 3}, {-4, 0.5, 0}}, {{0, 0, 1}, {2, -1, 7}},
                                       {{0, 0, 0}, {0.25, 0, 0}, {1, 0, 0}});
    for (const bool isWindy : {false, true}) // a wind that nobody has set
    {
        FunctionGrid grid((isWindy ? "#define ENABLE_WIND\n" : "") +
                              std::string("#define GEOM_TYPE_LEAF\n#define LOD_FADE_PERCENTAGE\n"
                                          "#include \"SpeedTreeCommon.cginc\"\n") +
                              offset,
                          ProgramLanguage::Cg);
        const Placed placed = Place(grid);
        grid.SetGlobal("_WindQuality", {4});
        grid.SetGlobal("_WindEnabled", {1});
        grid.Add("Offset(a.xyz, b.xyz, c.x)", inputs,
                 [=](auto& a, auto& b, auto& c)
                 {
                     const dvec3 anchor(b);
                     const dvec3 shrunk = (dvec3(a) - anchor) * (1 - 0.5 * c.x);
                     return anchor + Facing(placed, shrunk);
                 },
                 {1e-4, 1e-5});
        grid.Run();
    }
}

TEST_F(SpeedTreeFunctions, SpeedTree8TellsKindsOfGeometryApart)
{
    const std::string text =
        R"(
        #define ENABLE_WIND
        #define _WINDQUALITY_FASTEST
        #include "Packages/com.unity.render-pipelines.universal/Shaders/Nature/SpeedTree8Input.hlsl"
        #include "Packages/com.unity.render-pipelines.universal/Shaders/Nature/SpeedTree8Passes.hlsl"
        float3 Offset(float3 position, float3 anchor, float kind)
        {
            SpeedTreeVertexInput v = (SpeedTreeVertexInput)0;
            v.vertex = float4(position, 1);
            v.texcoord1 = float4(0, 0, anchor.xy);
            v.texcoord2 = float4(7, 7, 7, anchor.z);
            v.texcoord3.w = kind;
            InitializeData(v, 0);
            return v.vertex.xyz;
        })";
    const auto inputs = CombineVectors({{1, 2, 3}}, {{0, 0, 1}, {2, -1, 7}},
                                       {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {5, 0, 0}});
    FunctionGrid grid(text);
    const Placed placed = Place(grid);
    grid.SetGlobal("_ST_WindVector", {0, 0, 2, 0}); // blows, but moves no trunk
    grid.SetGlobal("_WindEnabled", {1});
    grid.Add("Offset(a.xyz, b.xyz, c.x)", inputs,
             [=](auto& a, auto& b, auto& c)
             {
                 const dvec3 anchor(b);
                 const bool faces = c.x == 3 || c.x == 5; // first and second kind of leaf
                 return faces ? anchor + Facing(placed, dvec3(a) - anchor) : dvec3(a);
             },
             {1e-4, 1e-5});
    grid.Run();
    FunctionGrid calm(text);
    Place(calm);
    calm.SetGlobal("_WindEnabled", {1});
    calm.Add("Offset(a.xyz, b.xyz, c.x)", inputs, [](auto& a, auto&, auto&) { return dvec3(a); });
    calm.Run();
}

} // namespace
} // namespace limn::test
