#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using BuiltinFunctions = GpuTest;

constexpr const char* k_UnitStepsyCg = "#include \"UnityCG.cginc\"\n";

/// f of each component.
Values Each(const dvec4& v, const std::function<double(double)>& f)
{
    return dvec3(f(v.x), f(v.y), f(v.z));
}

const std::vector<double> k_UnitSteps = {0.0,  1e-6, 0.003, 0.04,  0.0405,
                                         0.18, 0.5,  0.9,   0.999, 1.0};

TEST_F(BuiltinFunctions, ConvertColors)
{
    FunctionGrid grid(k_UnitStepsyCg, ProgramLanguage::Cg);
    const Tolerance power{3e-5, 1e-6};
    grid.Add(
        "GammaToLinearSpaceExact(a.x)", Combine({0.0, 0.01, 0.04, 0.0405, 0.5, 0.99}),
        [](auto& a, auto&, auto&) { return SrgbToLinear(a.x); }, power);
    grid.Add(
        "GammaToLinearSpaceExact(a.x)", Combine({1.0, 2.0, 8.0}),
        [](auto& a, auto&, auto&) { return std::pow(a.x, 2.2); }, power);
    grid.Add(
        "LinearToGammaSpaceExact(a.x)", Combine({0.0031309, 0.01, 0.18, 0.9, 0.999}),
        [](auto& a, auto&, auto&) { return 1.055 * std::pow(a.x, 1 / 2.4) - 0.055; }, power);
    grid.Add("LinearToGammaSpaceExact(a.x)", Combine({-1.0, 0.0, 0.001, 0.0031}),
             [](auto& a, auto&, auto&) { return std::max(0.0, a.x) * 12.92; });
    grid.Add(
        "LinearToGammaSpaceExact(a.x)", Combine({1.0, 4.0, 100.0}),
        [](auto& a, auto&, auto&) { return std::pow(a.x, 1 / 2.2); }, power);
    // The approximations are what Unity draws with; how near the true curve they come is stated.
    const Tolerance approximate{0.0, 0.002};
    grid.Add(
        "GammaToLinearSpace(a.xxx).y", Combine(k_UnitSteps),
        [](auto& a, auto&, auto&) { return SrgbToLinear(a.x); }, approximate);
    grid.Add(
        "LinearToGammaSpace(a.xyz)", CombineVectors({{-1, 0, 0.01}, {0.2, 0.6, 1}, {4, 9, 50}}),
        [](auto& a, auto&, auto&)
        {
            return Each(
                a, [](double x)
                { return std::max(0.0, 1.055 * std::pow(std::max(x, 0.0), 1 / 2.4) - 0.055); });
        },
        power);
    grid.Add("LinearRgbToLuminance(a.xyz)", CombineVectors(Colors()),
             [](auto& a, auto&, auto&)
             { return 0.2126729 * a.x + 0.7151522 * a.y + 0.0721750 * a.z; });
    grid.Add("Luminance(a.xyz)", CombineVectors(Colors()),
             [](auto& a, auto&, auto&)
             { return 0.0396819152 * a.x + 0.458021790 * a.y + 0.00609653955 * a.z; });
    grid.Add(
        "DecodeHDR(float4(a.xyz, b.x), float4(b.y, c.x, 0, c.y))",
        CombineVectors(Colors(), {{0, 2, 0}, {0.5, 5, 0}, {1, 1, 0}},
                       {{1, 0, 0}, {1, 1, 0}, {2.2, 1, 0}}),
        [](auto& a, auto& b, auto& c)
        {
            const double alpha = std::pow(c.y * (b.x - 1) + 1, c.x);
            return dvec3(a.x, a.y, a.z) * (b.y * alpha);
        },
        power);
    grid.Run();
}

TEST_F(BuiltinFunctions, KeepNumbersThatAreEncodedInEightBitChannels)
{
    FunctionGrid grid(std::string(k_UnitStepsyCg) +
                          "float4 Stored(float4 v) { return round(v * 255.0) / 255.0; }",
                      ProgramLanguage::Cg);
    const auto numbers = Combine({0.0, 1e-5, 0.1, 0.25, 1.0 / 3.0, 0.5, 0.7071, 0.9, 0.9999});
    const auto same = [](auto& a, auto&, auto&)
    {
        return a.x;
    };
    grid.Add("DecodeFloatRGBA(EncodeFloatRGBA(a.x))", numbers, same, {0.0, 1e-6});
    grid.Add("DecodeFloatRGBA(Stored(EncodeFloatRGBA(a.x)))", numbers, same, {0.0, 1e-6});
    grid.Add("DecodeFloatRG(EncodeFloatRG(a.x))", numbers, same, {0.0, 1e-6});
    grid.Add("DecodeFloatRG(Stored(EncodeFloatRG(a.x).xyxy).xy)", numbers, same,
             {0.0, 0.51 / 65025.0});
    grid.Add("EncodeFloatRG(a.x)", numbers,
             [](auto& a, auto&, auto&)
             {
                 const double fine = a.x * 255 - std::floor(a.x * 255);
                 return dvec2(a.x - fine / 255, fine);
             },
             {0.0, 3e-5});
    grid.Run();
}

TEST_F(BuiltinFunctions, EncodeAndUnpackNormals)
{
    FunctionGrid grid(std::string(k_UnitStepsyCg) + R"(
        float4 Again(float3 n, float d)
        {
            float depth;
            float3 normal;
            DecodeDepthNormal(EncodeDepthNormal(d, n), depth, normal);
            return float4(normal, depth);
        })",
                      ProgramLanguage::Cg);
    std::vector<dvec3> towardsCamera;
    for (const dvec3& n : UnitVectors())
    {
        if (n.z > -0.5)
        {
            towardsCamera.push_back(n);
        }
    }
    grid.Add("Again(a.xyz, b.x)",
             CombineVectors(towardsCamera, {{0, 0, 0}, {0.3, 0, 0}, {0.99, 0, 0}}),
             [](auto& a, auto& b, auto&) { return dvec4(a.x, a.y, a.z, b.x); }, {0.0, 3e-5});
    // Stereographic projection from (0, 0, -1): (x, y) / (1 + z).
    grid.Add("EncodeViewNormalStereo(a.xyz)", CombineVectors(towardsCamera),
             [](auto& a, auto&, auto&)
             { return dvec2(a.x, a.y) / (1.0 + a.z) / 1.7777 * 0.5 + 0.5; });
    const auto packed = CombineVectors({{0.5, 0.5, 1}, {0, 0.5, 1}, {1, 1, 1}, {0.8, 0.3, 0.1}});
    const auto unpacked = [](double px, double py, double scale)
    {
        const dvec2 xy(px * 2 - 1, py * 2 - 1);
        const double z = std::sqrt(1 - std::min(1.0, xy.x * xy.x + xy.y * xy.y));
        return dvec3(xy.x * scale, xy.y * scale, z);
    };
    const Tolerance root{1e-5, 1e-5};
    grid.Add(
        "UnpackNormal(float4(a.xyz, 1))", packed,
        [=](auto& a, auto&, auto&) { return unpacked(a.x, a.y, 1); }, root);
    grid.Add(
        "UnpackNormal(float4(1, a.y, 0, a.x))", packed,
        [=](auto& a, auto&, auto&) { return unpacked(a.x, a.y, 1); }, root);
    grid.Add(
        "UnpackNormalDXT5nm(float4(0.3, a.y, 0, a.x))", packed,
        [=](auto& a, auto&, auto&) { return unpacked(a.x, a.y, 1); }, root);
    grid.Add(
        "UnpackNormalWithScale(float4(a.xyz, 1), 2)", packed,
        [=](auto& a, auto&, auto&) { return unpacked(a.x, a.y, 2); }, root);
    grid.Run();
}

TEST_F(BuiltinFunctions, TurnDepthIntoDistance)
{
    const double n = 0.3;
    const double f = 1000.0;
    FunctionGrid grid(k_UnitStepsyCg, ProgramLanguage::Cg);
    grid.SetGlobal("_ZBufferParams",
                   {static_cast<float>(f / n - 1), 1.0f, static_cast<float>(1 / n - 1 / f),
                    static_cast<float>(1 / f)});
    // Reversed z: a point at the distance d is drawn at n (f - d) / (d (f - n)).
    const auto depths = Combine({0.0, 1e-5, 0.001, 0.1, 0.5, 0.99, 1.0});
    const auto distance = [=](double depth)
    {
        return n * f / (n + depth * (f - n));
    };
    grid.Add("LinearEyeDepth(a.x)", depths, [=](auto& a, auto&, auto&) { return distance(a.x); });
    grid.Add("Linear01Depth(a.x)", depths,
             [=](auto& a, auto&, auto&) { return distance(a.x) / f; });
    grid.Run();
}

TEST_F(BuiltinFunctions, FadeIntoFogByDistance)
{
    FunctionGrid grid(k_UnitStepsyCg, ProgramLanguage::Cg);
    const double density = 0.05;
    const double start = 10.0;
    const double end = 80.0;
    grid.SetGlobal("unity_FogParams", {static_cast<float>(density / std::sqrt(std::log(2.0))),
                                       static_cast<float>(density / std::log(2.0)),
                                       static_cast<float>(-1 / (end - start)),
                                       static_cast<float>(end / (end - start))});
    grid.SetGlobal("_ProjectionParams", {1.0f, 0.5f, 200.0f, 0.005f});
    const auto distances = Combine({0.0, 0.5, 10.0, 45.0, 80.0, 200.0});
    grid.Add("limn_FogLinear(a.x, unity_FogParams)", distances,
             [=](auto& a, auto&, auto&) { return (end - a.x) / (end - start); });
    grid.Add("limn_FogExp(a.x, unity_FogParams)", distances,
             [=](auto& a, auto&, auto&) { return std::exp(-density * a.x); }, {2e-5, 1e-6});
    grid.Add("limn_FogExp2(a.x, unity_FogParams)", distances,
             [=](auto& a, auto&, auto&) { return std::exp(-density * density * a.x * a.x); },
             {2e-5, 1e-6});
    // Clip space z runs from near (at the camera's near plane) to 0 (at the far plane).
    grid.Add("UNITY_Z_0_FAR_FROM_CLIPSPACE(a.x)", Combine({0.0, 0.25, 0.5, 0.7}),
             [](auto& a, auto&, auto&) { return std::max(0.0, (0.5 - a.x) / 0.5 * 200.0); });
    grid.Run();
}

TEST_F(BuiltinFunctions, MovePositionsBetweenSpaces)
{
    FunctionGrid grid(k_UnitStepsyCg, ProgramLanguage::Cg);
    const glm::mat4 object(glm::vec4(0, 2, 0, 0), glm::vec4(-3, 0, 0, 0), glm::vec4(0, 0, 0.5f, 0),
                           glm::vec4(4, -5, 6, 1));
    const glm::mat4 view(glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0), glm::vec4(1, 0, 0, 0),
                         glm::vec4(1, 2, -30, 1));
    const glm::mat4 projection(glm::vec4(1.5f, 0, 0, 0), glm::vec4(0, 2, 0, 0),
                               glm::vec4(0, 0, 0.01f, -1), glm::vec4(0, 0, 0.3f, 0));
    const glm::dmat4 toWorld(object);
    const glm::dmat4 toObject = glm::inverse(toWorld);
    std::ranges::copy(Floats(object), grid.perDraw.objectToWorld);
    std::ranges::copy(Floats(glm::mat4(toObject)), grid.perDraw.worldToObject);
    grid.SetGlobal("unity_MatrixV", Floats(view));
    grid.SetGlobal("glstate_matrix_projection", Floats(projection));
    grid.SetGlobal("unity_MatrixVP", Floats(projection * view));
    grid.SetGlobal("unity_MatrixInvV", Floats(glm::inverse(view)));
    grid.SetGlobal("_WorldSpaceCameraPos", {7, 8, 9});
    grid.SetGlobal("_MainLightPosition", {0, 0.6f, -0.8f, 0});
    grid.SetGlobal("_ScreenParams", {64, 32, 0, 0});
    grid.SetGlobal("_ProjectionParams", {-1, 0.5f, 200, 0.005f}); // into a texture
    const glm::dmat4 v(view);
    const glm::dmat4 p(projection);
    const auto points = CombineVectors({{0, 0, 0}, {1, 2, 3}, {-10, 0.5, 1e-3}, {100, -70, 30}});
    const auto directions = CombineVectors(UnitVectors());
    const Tolerance tolerance{1e-5, 1e-4};
    const auto add = [&](const char* hlsl, const std::vector<GridInput>& inputs, auto oracle)
    {
        grid.Add(
            hlsl, inputs, [=](auto& a, auto&, auto&) -> Values { return oracle(dvec3(a)); },
            tolerance);
    };
    add("UnityObjectToClipPos(a.xyz)", points,
        [=](dvec3 x) { return p * v * toWorld * dvec4(x, 1); });
    add("UnityWorldToClipPos(a.xyz)", points, [=](dvec3 x) { return p * v * dvec4(x, 1); });
    add("UnityViewToClipPos(a.xyz)", points, [=](dvec3 x) { return p * dvec4(x, 1); });
    add("UnityObjectToViewPos(a.xyz)", points,
        [=](dvec3 x) { return dvec3(v * toWorld * dvec4(x, 1)); });
    add("WorldSpaceViewDir(float4(a.xyz, 1))", points,
        [=](dvec3 x) { return dvec3(7, 8, 9) - dvec3(toWorld * dvec4(x, 1)); });
    add("ObjSpaceViewDir(float4(a.xyz, 1))", points,
        [=](dvec3 x) { return dvec3(toObject * dvec4(7, 8, 9, 1)) - x; });
    add("WorldSpaceLightDir(float4(a.xyz, 1))", points, [](dvec3) { return dvec3(0, 0.6, -0.8); });
    add("ObjSpaceLightDir(float4(a.xyz, 1))", points,
        [=](dvec3) { return dvec3(toObject * dvec4(0, 0.6, -0.8, 0)); });
    add("UnityObjectToWorldDir(a.xyz)", directions,
        [=](dvec3 x) { return glm::normalize(glm::dmat3(toWorld) * x); });
    add("UnityWorldToObjectDir(a.xyz)", directions,
        [=](dvec3 x) { return glm::normalize(glm::dmat3(toObject) * x); });
    add("UnityObjectToWorldNormal(a.xyz)", directions,
        [=](dvec3 x) { return glm::normalize(glm::transpose(glm::dmat3(toObject)) * x); });
    add("TransformViewToProjection(a.xyz)", directions, [=](dvec3 x) { return glm::dmat3(p) * x; });
    add("ComputeScreenPos(float4(a.xyz, 2))", points,
        [](dvec3 x) { return dvec4(x.x / 2 + 1, 1 - x.y / 2, x.z, 2); });
    for (const char* same : {"ComputeGrabScreenPos", "ComputeNonStereoScreenPos"})
    {
        add((std::string(same) + "(float4(a.xyz, 2))").c_str(), points,
            [](dvec3 x) { return dvec4(x.x / 2 + 1, 1 - x.y / 2, x.z, 2); });
    }
    add("UnityWorldSpaceViewDir(a.xyz)", points, [](dvec3 x) { return dvec3(7, 8, 9) - x; });
    add("UnityWorldSpaceLightDir(a.xyz)", points, [](dvec3) { return dvec3(0, 0.6, -0.8); });
    add("UnityPixelSnap(float4(a.xyz, 2))", CombineVectors({{0.31, -0.47, 1}, {2, -2, 0}}),
        [](dvec3 x) {
            return dvec4(std::round(x.x / 2 * 32) / 32 * 2, std::round(x.y / 2 * 16) / 16 * 2, x.z,
                         2);
        });
    add("float3(ParallaxOffset(0.75, 0.2, a.xyz), 0)", CombineVectors({{0, 0, 1}, {3, 4, 12}}),
        [](dvec3 x)
        {
            const dvec3 n = glm::normalize(x);
            return dvec3(n.x, n.y, 0) * ((0.75 * 0.2 - 0.1) / (n.z + 0.42));
        });
    grid.Run();
}

TEST_F(BuiltinFunctions, LeaveTextureCoordinatesAsTheyAreByTheMatricesOfTextures)
{
    FunctionGrid grid(k_UnitStepsyCg, ProgramLanguage::Cg);
    grid.Add(
        "float4(MultiplyUV(UNITY_MATRIX_TEXTURE0, a.xy), MultiplyUV(UNITY_MATRIX_TEXTURE3, a.yx))",
        CombineVectors({{0.25, -3, 0}, {1, 0, 0}}),
        [](auto& a, auto&, auto&) { return dvec4(a.x, a.y, a.y, a.x); });
    grid.Run();
}

/// Two zones: the upper left quarter, and one in the middle that is turned by a quarter.
void SetZones(FunctionGrid& grid, const dvec2& unit, float parameters)
{
    const auto at = [](double x, double y)
    {
        return dvec2(x, y);
    };
    std::vector<float> centers;
    std::vector<float> sizes;
    const auto add = [&](dvec2 center, dvec2 size, float degrees)
    {
        center *= unit;
        size *= unit;
        for (const double v : {center.x, center.y, 0.25})
        {
            centers.push_back(static_cast<float>(v));
        }
        centers.push_back(0.0f);
        for (const double v : {size.x, size.y, 0.5})
        {
            sizes.push_back(static_cast<float>(v));
        }
        sizes.push_back(degrees);
    };
    add(at(0.25, 0.75), at(0.5, 0.5), 0.0f);
    add(at(0.5, 0.5), at(0.5, 0.25), 90.0f);
    grid.SetGlobal("CustomRenderTextureCenters", centers);
    grid.SetGlobal("CustomRenderTextureSizesAndRotations", sizes);
    grid.SetGlobal("CustomRenderTexturePrimitiveIDs",
                   {std::bit_cast<float>(7u), 0, 0, 0, std::bit_cast<float>(9u)});
    grid.SetGlobal("CustomRenderTextureParameters", {parameters, 0.625f, 0, 0});
}

constexpr const char* k_CustomRenderTexture = R"(
    #include "UnityCustomRenderTexture.cginc"
    v2f_customrendertexture Corner(float id)
    {
        appdata_customrendertexture v;
        v.vertexID = (uint)id;
        return CustomRenderTextureVertexShader(v);
    })";

TEST_F(BuiltinFunctions, PlaceTheZonesOfACustomRenderTexture)
{
    const std::vector<GridInput> ids =
        Combine({0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0});
    const dvec2 corners[12] = {{-1, 1},     {-1, 0},      {0, 0},        {0, 1},
                               {-1, 1},     {0, 0},       {-0.25, -0.5}, {0.25, -0.5},
                               {0.25, 0.5}, {-0.25, 0.5}, {-0.25, -0.5}, {0.25, 0.5}};
    const dvec2 local[6] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}, {1, 1}};
    for (const bool pixels : {false, true})
    {
        SCOPED_TRACE(pixels);
        FunctionGrid grid(k_CustomRenderTexture, ProgramLanguage::Cg);
        SetZones(grid, pixels ? dvec2(200, 100) : dvec2(1, 1), pixels ? 1.0f : 0.0f);
        grid.SetGlobal("_CustomRenderTextureInfo", {200, 100, 1, 0});
        const Tolerance tolerance{1e-6, 1e-6};
        grid.Add(
            "Corner(a.x).vertex", ids,
            [&](auto& a, auto&, auto&) { return dvec4(corners[static_cast<int>(a.x)], 0, 1); },
            tolerance);
        grid.Add(
            "Corner(a.x).globalTexcoord", ids,
            [&](auto& a, auto&, auto&)
            {
                const dvec2 at = corners[static_cast<int>(a.x)];
                return dvec3(at.x / 2 + 0.5, 0.5 - at.y / 2, 0.625);
            },
            tolerance);
        grid.Add("Corner(a.x).localTexcoord", ids,
                 [&](auto& a, auto&, auto&)
                 { return dvec3(local[static_cast<int>(a.x) % 6], 0.625); });
        grid.Add("Corner(a.x).primitiveID", ids,
                 [](auto& a, auto&, auto&) { return a.x < 6.0 ? 7.0 : 9.0; });
        grid.Run();
    }
}

TEST_F(BuiltinFunctions, DrawOnlyTheSlicesAndFacesOfACustomRenderTextureThatAreAskedFor)
{
    // Half of 8 slices about the second: 0...3.
    for (const float slice : {0.0f, 3.0f, 4.0f})
    {
        FunctionGrid grid(k_CustomRenderTexture, ProgramLanguage::Cg);
        SetZones(grid, dvec2(1, 1), 0.0f);
        grid.SetGlobal("CustomRenderTextureParameters", {0, 0, 1, 0});
        grid.SetGlobal("_CustomRenderTextureInfo", {16, 16, 8, slice});
        grid.Add("Corner(2).vertex.xy", Combine({0.0}),
                 [slice](auto&, auto&, auto&)
                 { return slice < 3.5f ? dvec2(0, 0) : dvec2(1000, 1000); });
        grid.Run();
    }
    // The upper right corner of each face, and its middle.
    const dvec3 corners[6] = {{1, 1, -1}, {-1, 1, 1}, {1, 1, -1},
                              {1, -1, 1}, {1, 1, 1},  {-1, 1, -1}};
    const dvec3 axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face)
    {
        SCOPED_TRACE(face);
        FunctionGrid grid(k_CustomRenderTexture, ProgramLanguage::Cg);
        grid.SetGlobal("_CustomRenderTextureInfo", {16, 16, 1, static_cast<float>(face)});
        grid.Add("CustomRenderTextureComputeCubeDirection(a.xy)",
                 {{{1, 0, 0, 0}}, {{0.5, 0.5, 0, 0}}},
                 [&](auto& a, auto&, auto&)
                 { return a.x == 1.0 ? glm::normalize(corners[face]) : axes[face]; });
        grid.Run();
    }
}

TEST_F(BuiltinFunctions, FadeParticlesBeforeSurfacesAndTheCamera)
{
    FunctionGrid grid(R"(
        #define SOFTPARTICLES_ON 1
        #define _FADING_ON 1
        #include "UnityStandardParticles.cginc"
        half2 Fade(float z)
        {
            VertexOutput i = (VertexOutput)0;
            i.projectedPosition = float4(0.5, 0.5, z, 1);
            half4 albedo = 1;
            fragSoftParticles(i)
            half soft = albedo.a;
            albedo = 1;
            fragCameraFading(i)
            return half2(soft, albedo.a);
        })",
                      ProgramLanguage::Cg);
    // Depth 1, which is all that the stand-in texture holds, is 4 units away.
    grid.SetGlobal("_ZBufferParams", {0, 0, 0.15f, 0.1f});
    grid.SetGlobal("_SoftParticleFadeParams", {0.5f, 2.0f});
    grid.SetGlobal("_CameraFadeParams", {1.0f, 0.25f});
    grid.Add("Fade(a.x)", Combine({0.5, 1.0, 2.0, 3.0, 3.25, 3.5, 4.5, 6.0}),
             [](auto& a, auto&, auto&) {
                 return dvec2(std::clamp((3.5 - a.x) * 2.0, 0.0, 1.0),
                              std::clamp((a.x - 1.0) / 4.0, 0.0, 1.0));
             },
             {1e-5, 2e-6});
    grid.Run();
}

TEST_F(BuiltinFunctions, MixTheColorsOfParticlesAsTheKeywordSays)
{
    const std::vector<GridInput> pairs = CombineVectors(
        {{0.2, 0.7, 0.5}, {0.9, 0.1, 0.4}, {1, 1, 1}, {0, 0, 0}},
        {{0.3, 0.6, 0.9}, {1, 0.25, 0}, {0.5, 0.8, 0.1}, {0.4, 0.4, 0.4}, {0.2, 1, 1}});
    const auto check = [&](const char* keyword, const std::vector<float>& parameters,
                           const std::function<dvec3(dvec3, dvec3)>& mix)
    {
        SCOPED_TRACE(keyword);
        FunctionGrid grid("#define " + std::string(keyword) + R"( 1
            #include "UnityStandardParticles.cginc"
            half4 Mix(half4 albedo, half4 color)
            {
                VertexOutput i = (VertexOutput)0;
                i.color = color;
                fragColorMode(i)
                return albedo;
            })",
                          ProgramLanguage::Cg);
        grid.SetGlobal("_ColorAddSubDiff", parameters);
        grid.Add("Mix(half4(a.rgb, 0.5), half4(b.rgb, 0.25))", pairs,
                 [&](auto& a, auto& b, auto&) { return dvec4(mix(dvec3(a), dvec3(b)), 0.125); },
                 {1e-5, 1e-6});
        grid.Run();
    };
    check("limn_NoKeyword", {}, [](dvec3 base, dvec3 blend) { return base * blend; });
    check("_COLOROVERLAY_ON", {},
          [](dvec3 base, dvec3 blend)
          {
              const auto overlay = [](double x, double y)
              {
                  return x <= 0.5 ? 2.0 * x * y : 1.0 - 2.0 * (1.0 - x) * (1.0 - y);
              };
              return dvec3(overlay(base.x, blend.x), overlay(base.y, blend.y),
                           overlay(base.z, blend.z));
          });
    // The tint, as bright as the base.
    check("_COLORCOLOR_ON", {},
          [](dvec3 base, dvec3 blend)
          {
              const auto value = [](dvec3 c)
              {
                  return std::max({c.x, c.y, c.z});
              };
              return blend * (value(base) / value(blend));
          });
    check("_COLORADDSUBDIFF_ON", {1, 0}, [](dvec3 base, dvec3 blend) { return base + blend; });
    check("_COLORADDSUBDIFF_ON", {-1, 0}, [](dvec3 base, dvec3 blend) { return base - blend; });
    check("_COLORADDSUBDIFF_ON", {-1, 1},
          [](dvec3 base, dvec3 blend) { return glm::abs(base - blend); });
}

} // namespace
} // namespace limn::test
