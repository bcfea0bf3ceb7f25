#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// What generated shaders call, in double.

namespace limn::test
{
namespace
{

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

using GraphFunctions = GpuTest;

constexpr const char* k_GraphFunctions =
    "#include "
    "\"Packages/com.unity.render-pipelines.universal/ShaderLibrary/ShaderGraphFunctions.hlsl\"\n";

/// A graph for the whole screen that hands on its coordinates.
std::string Fullscreen(const std::string& mode)
{
    return std::string(k_GraphFunctions) + "#define DEPTH_WRITE\n#define DEPTH_WRITE_MODE_" + mode +
           R"(
        struct Attributes { uint vertexID; };
        struct Varyings { float4 positionCS; float4 texCoord0; float4 texCoord1; };
        #define PackedVaryings Varyings
        #define SurfaceDescriptionInputs Varyings
        Varyings UnpackVaryings(Varyings v) { return v; }
        Varyings BuildSurfaceDescriptionInputs(Varyings v) { return v; }
        struct SurfaceDescription { float3 BaseColor; float Alpha; float FullscreenEyeDepth;
                                    float FullscreenLinear01Depth; float FullscreenRawDepth; };
        SurfaceDescription SurfaceDescriptionFunction(Varyings v)
        {
            SurfaceDescription s; s.BaseColor = v.texCoord0.rgb; s.Alpha = v.texCoord0.a;
            s.FullscreenEyeDepth = s.FullscreenLinear01Depth = s.FullscreenRawDepth = v.texCoord1.x;
            return s;
        }
        float _FlipY;
        #include "Packages/com.unity.shadergraph/Editor/Generation/Targets/Fullscreen/Includes/FullscreenCommon.hlsl"
        Varyings Built(float4 positionCS)
        {
            Varyings v = (Varyings)0; Attributes a = (Attributes)0; v.positionCS = positionCS;
            BuildVaryings(a, v); return v;
        }
        float DepthAt(float distance)
        {
            Varyings v = (Varyings)0; v.texCoord1.x = distance;
            return DefaultFullscreenFragmentShader(v).depth;
        }
    )";
}

// Near and far plane; depth is 1 at the near one.
constexpr double k_GraphNear = 0.5;
constexpr double k_GraphFar = 40.0;

TEST_F(GraphFunctions, DepthOfTheWholeScreenIsThatOfItsDistance)
{
    for (const bool isEye : {true, false})
    {
        FunctionGrid grid(Fullscreen(isEye ? "EYE" : "LINEAR01"));
        const double x = k_GraphFar / k_GraphNear - 1.0;
        grid.SetGlobal("_ZBufferParams",
                       {static_cast<float>(x), 1, static_cast<float>(x / k_GraphFar),
                        static_cast<float>(1.0 / k_GraphFar)});
        grid.Add("DepthAt(a.x)", isEye ? Combine({0.5, 1, 7, 40}) : Combine({0.0125, 0.25, 1}),
                 [&](const dvec4& a, const dvec4&, const dvec4&) -> Values
                 {
                     // A projection that gives 1 at the near plane and 0 at the far one.
                     const double distance = isEye ? a.x : a.x * k_GraphFar;
                     return k_GraphNear * (k_GraphFar - distance) /
                            (distance * (k_GraphFar - k_GraphNear));
                 },
                 {1e-5, 1e-6});
        grid.Run();
    }
}

TEST_F(GraphFunctions, TheWholeScreensFirstRowIsTheUppermost)
{
    for (const bool isFlipped : {false, true})
    {
        FunctionGrid grid(Fullscreen("RAW"));
        grid.SetGlobal("_FlipY", {isFlipped ? 1.0f : 0.0f});
        grid.Add("Built(float4(a.xy, 1, 1)).texCoord0.xy",
                 CombineVectors({dvec3(-1, -1, 0), dvec3(3, -1, 0), dvec3(0.25, 0.5, 0)}),
                 [&](const dvec4& a, const dvec4&, const dvec4&)
                 {
                     const double v = (1.0 + a.y) / 2.0;
                     return Values(glm::dvec2((1.0 + a.x) / 2.0, isFlipped ? v : 1.0 - v));
                 });
        grid.Run();
    }
}

TEST_F(GraphFunctions, MatricesAreInverted)
{
    FunctionGrid grid(Fullscreen("RAW"));
    const dmat4 matrix(dvec4(0.9, 0.1, -0.3, 0.05), dvec4(-0.2, 1.3, 0.4, 0.0),
                       dvec4(0.5, -0.6, 0.7, -1.0), dvec4(2.0, -3.0, 1.5, 0.25));
    std::string rows;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            rows += (rows.empty() ? "" : ", ") + std::to_string(matrix[column][row]);
    grid.Add("mul(inverse(float4x4(" + rows + ")), float4(a.xyz, 1))",
             CombineVectors(UnitVectors()),
             [&](const dvec4& a, const dvec4&, const dvec4&)
             { return Values(glm::inverse(matrix) * dvec4(dvec3(a), 1.0)); },
             {1e-5, 1e-5});
    grid.Run();
}

// A grey has no colour, and for lightness the cube root of its light.
TEST_F(GraphFunctions, GreysHaveTheRootOfTheirLightInOklab)
{
    FunctionGrid grid(k_GraphFunctions);
    grid.Add("LinearToOklab(a.xxx)", Combine({0.0, 0.001, 0.18, 0.5, 1.0, 4.0}),
             [](const dvec4& a, const dvec4&, const dvec4&)
             { return Values(dvec3(std::cbrt(a.x), 0.0, 0.0)); },
             {1e-4, 1e-4});
    grid.Add("OklabToLinear(LinearToOklab(a.xyz))", CombineVectors(Colors()),
             [](const dvec4& a, const dvec4&, const dvec4&) { return Values(dvec3(a)); },
             {1e-4, 1e-4});
    // Ottosson's table: pure red.
    grid.Add("LinearToOklab(float3(1, 0, 0))", Combine({0.0}),
             [](const dvec4&, const dvec4&, const dvec4&)
             { return Values(dvec3(0.62796, 0.22486, 0.12585)); },
             {0.0, 2e-4});
    grid.Run();
}

// Linear fog from 2 to 12 behind the near plane at 0.5; the camera looks along -z.
TEST_F(GraphFunctions, FogIsAsDenseAsTheSceneIsFar)
{
    FunctionGrid grid("#define FOG_LINEAR\n" + std::string(k_GraphFunctions) + R"(
        float DensityAt(float z)
        {
            float4 color; float density;
            SHADERGRAPH_FOG(float3(0, 0, z), color, density);
            return density;
        })");
    const std::vector<float> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    grid.SetGlobal("unity_MatrixV", identity);
    std::ranges::copy(identity, grid.perDraw.objectToWorld);
    grid.SetGlobal("_ProjectionParams", {1, 0.5f, 40, 0.025f});
    grid.SetGlobal("unity_FogParams", {0, 0, -0.1f, 1.2f});
    grid.Add("DensityAt(a.x)", Combine({-0.25, -1.5, -2.75, -7.5, -12.5, -20}),
             [](const dvec4& a, const dvec4&, const dvec4&) -> Values
             { return std::clamp((-a.x - 0.5 - 2.0) / 10.0, 0.0, 1.0); });
    grid.Run();
}

} // namespace
} // namespace limn::test
