#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <vulkan/GpuTestDevice.h>

// The render-pipelines.universal part of the ShaderLibrary: places, depth, fog.

namespace limn::test
{

namespace
{

#define LIMN_URP(name)                                                                             \
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/" name ".hlsl\"\n"

/// An object that is moved, turned, stretched and mirrored, before a camera that looks along +z
/// from z = -5; reversed depth from 0.5 to 100.
struct Stage
{
    glm::dmat4 object =
        glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(1, -2, 3)), 0.8,
                               glm::dvec3(0.6, 0.0, 0.8)),
                   glm::dvec3(2.0, -0.5, 1.5));
    glm::dmat4 view = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1)) *
                      glm::translate(glm::dmat4(1.0), glm::dvec3(-1, 0.5, 5));
    glm::dmat4 projection{0.0};
    double n = 0.5;
    double f = 100.0;

    Stage()
    {
        // As float, which is what the device gets.
        object = glm::dmat4(glm::mat4(object));
        projection[0][0] = 1.2;
        projection[1][1] = 1.8;
        projection[2][2] = n / (f - n);
        projection[2][3] = -1.0;
        projection[3][2] = f * n / (f - n);
        projection = glm::dmat4(glm::mat4(projection));
    }

    void SetUp(FunctionGrid& grid) const
    {
        const glm::mat4 toWorld(object);
        const glm::mat4 toObject(glm::inverse(object));
        std::memcpy(grid.perDraw.objectToWorld, &toWorld, sizeof(toWorld));
        std::memcpy(grid.perDraw.worldToObject, &toObject, sizeof(toObject));
        grid.perDraw.worldTransformParams[3] = -1.0f;
        grid.perDraw.renderingLayer[0] = 0x1A5;
        grid.SetGlobal("unity_MatrixV", Floats(glm::mat4(view)));
        grid.SetGlobal("unity_MatrixInvV", Floats(glm::mat4(glm::inverse(view))));
        grid.SetGlobal("glstate_matrix_projection", Floats(glm::mat4(projection)));
        grid.SetGlobal("unity_MatrixVP", Floats(glm::mat4(projection * view)));
        grid.SetGlobal("_WorldSpaceCameraPos", {1.0f, -0.5f, -5.0f});
        grid.SetGlobal("_ProjectionParams", {-1.0f, 0.5f, 100.0f, 0.01f});
        grid.SetGlobal("_ScaledScreenParams",
                       {640.0f, 360.0f, 1.0f + 1 / 640.0f, 1.0f + 1 / 360.0f});
        grid.SetGlobal("_ScaleBiasRt", {-1.0f, 1.0f, -1.0f, 1.0f});
        grid.SetGlobal("unity_FogColor", {0.2f, 0.4f, 0.8f, 1.0f});
        grid.SetGlobal("unity_FogParams", {0.03f, 0.05f, -0.02f, 1.2f});
    }
};

const std::vector<glm::dvec3> k_Points = {
    {0, 0, 0}, {1, 2, 3}, {-4, 0.5, 2}, {0.001, -7, 20}, {30, 30, 60}};

glm::dvec3 Point(const glm::dmat4& m, const glm::dvec4& p)
{
    return glm::dvec3(m * glm::dvec4(glm::dvec3(p), 1.0));
}
glm::dvec3 Direction(const glm::dmat4& m, const glm::dvec4& d)
{
    return glm::dvec3(m * glm::dvec4(glm::dvec3(d), 0.0));
}

} // namespace

using UniversalLibrary = GpuTest;

TEST_F(UniversalLibrary, TakesPlacesFromSpaceToSpace)
{
    const Stage stage;
    FunctionGrid grid(LIMN_URP("Core"));
    stage.SetUp(grid);
    const auto points = CombineVectors(k_Points);
    const Tolerance place{1e-5, 2e-5};
    grid.Add(
        "TransformObjectToWorld(a.xyz)", points,
        [&](auto& a, auto&, auto&) { return Point(stage.object, a); }, place);
    grid.Add("TransformWorldToObject(TransformObjectToWorld(a.xyz))", points,
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {1e-5, 5e-5});
    grid.Add(
        "TransformWorldToView(a.xyz)", points,
        [&](auto& a, auto&, auto&) { return Point(stage.view, a); }, place);
    grid.Add(
        "TransformViewToWorld(TransformWorldToView(a.xyz))", points,
        [](auto& a, auto&, auto&) { return glm::dvec3(a); }, place);
    grid.Add("TransformObjectToHClip(a.xyz)", points,
             [&](auto& a, auto&, auto&)
             { return stage.projection * stage.view * glm::dvec4(Point(stage.object, a), 1.0); },
             {1e-5, 1e-4});
    grid.Add(
        "TransformWViewToHClip(a.xyz)", points,
        [&](auto& a, auto&, auto&) { return stage.projection * glm::dvec4(glm::dvec3(a), 1.0); },
        place);
    grid.Add("GetVertexPositionInputs(a.xyz).positionNDC", points,
             [&](auto& a, auto&, auto&)
             {
                 const glm::dvec4 clip =
                     stage.projection * stage.view * glm::dvec4(Point(stage.object, a), 1.0);
                 return glm::dvec4((clip.w + clip.x) / 2, (clip.w - clip.y) / 2, clip.z, clip.w);
             },
             {1e-5, 1e-4});
    grid.Add("GetWorldSpaceViewDir(a.xyz)", points,
             [](auto& a, auto&, auto&) { return glm::dvec3(1.0, -0.5, -5.0) - glm::dvec3(a); });
    grid.Add("GetNormalizedScreenSpaceUV(a.xy)", CombineVectors({{0.5, 0.5, 0}, {320, 90, 0}}),
             [](auto& a, auto&, auto&) { return glm::dvec2(a.x / 640, a.y / 360); });
    grid.Run();
}

TEST_F(UniversalLibrary, TakesDirectionsAndNormalsFromSpaceToSpace)
{
    const Stage stage;
    FunctionGrid grid(LIMN_URP("Core"));
    stage.SetUp(grid);
    const auto directions = CombineVectors(UnitVectors());
    const glm::dmat4 inverse = glm::inverse(stage.object);
    const auto normal = [&](const glm::dvec4& n)
    {
        return glm::normalize(Direction(glm::transpose(inverse), n));
    };
    const Tolerance tolerance{1e-5, 3e-6};
    grid.Add(
        "TransformObjectToWorldDir(a.xyz)", directions,
        [&](auto& a, auto&, auto&) { return glm::normalize(Direction(stage.object, a)); },
        tolerance);
    grid.Add(
        "TransformObjectToWorldDir(a.xyz, false)", directions,
        [&](auto& a, auto&, auto&) { return Direction(stage.object, a); }, tolerance);
    grid.Add(
        "TransformWorldToObjectDir(a.xyz)", directions,
        [&](auto& a, auto&, auto&) { return glm::normalize(Direction(inverse, a)); }, tolerance);
    grid.Add(
        "TransformObjectToWorldNormal(a.xyz)", directions,
        [&](auto& a, auto&, auto&) { return normal(a); }, tolerance);
    grid.Add(
        "TransformWorldToObjectNormal(a.xyz)", directions,
        [&](auto& a, auto&, auto&)
        { return glm::normalize(Direction(glm::transpose(stage.object), a)); },
        tolerance);
    grid.Add(
        "TransformWorldToViewDir(a.xyz)", directions,
        [&](auto& a, auto&, auto&) { return glm::dvec3(a.x, a.y, -a.z); }, tolerance);
    grid.Add(
        "TransformWorldToHClipDir(a.xyz)", directions,
        [&](auto& a, auto&, auto&) { return Direction(stage.projection * stage.view, a); },
        tolerance);
    grid.Add(
        "GetVertexNormalInputs(a.xyz, float4(b.xyz, -1)).bitangentWS",
        CombineVectors({{0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}}),
        [&](auto& a, auto& b, auto&)
        {
            // The handedness, times that of the mirrored object.
            const double side = -1.0 * -1.0;
            return side * glm::cross(normal(a), glm::normalize(Direction(stage.object, b)));
        },
        tolerance);
    grid.Add(
        "TransformWorldToTangent(TransformTangentToWorld(a.xyz, CreateTangentToWorld(float3(0, "
        "1, 0), float3(1, 0, 0), 1)), CreateTangentToWorld(float3(0, 1, 0), float3(1, 0, 0), "
        "1))",
        directions, [](auto& a, auto&, auto&) { return glm::dvec3(a); }, tolerance);
    for (const char* frame : {"float3x3(1, 0, 0, 0.5, 2, 0, -0.25, 0.5, 0.75)", // skewed
                              "float3x3(0, 1, 0, 1, 0, 0, 0, 0, 3)"})           // mirrored
    {
        const std::string there = "TransformTangentToWorld(a.xyz, " + std::string(frame) + "), ";
        grid.Add(
            "TransformWorldToTangent(" + there + frame + ", false)", directions,
            [](auto& a, auto&, auto&) { return glm::dvec3(a); }, tolerance);
        grid.Add(
            "TransformWorldToTangent(" + there + frame + ")", directions,
            [](auto& a, auto&, auto&) { return glm::normalize(glm::dvec3(a)); }, tolerance);
    }
    grid.Add("GetOddNegativeScale()", Combine({0.0}), [](auto&, auto&, auto&) { return -1.0; });
    grid.Add("float2(GetMeshRenderingLayer(), EncodeMeshRenderingLayer(GetMeshRenderingLayer()))",
             Combine({0.0}), [](auto&, auto&, auto&) { return glm::dvec2(0x1A5, 0xA5 / 255.0); });
    grid.Add("DecodeMeshRenderingLayer(EncodeMeshRenderingLayer((uint)a.x))",
             Combine({0.0, 1.0, 128.0, 255.0}), [](auto& a, auto&, auto&) { return a.x; });
    grid.Run();
}

TEST_F(UniversalLibrary, TurnsDepthIntoDistanceAndPlace)
{
    const Stage stage;
    FunctionGrid grid(LIMN_URP("Core"));
    stage.SetUp(grid);
    const glm::mat4 invVP(glm::inverse(stage.projection * stage.view));
    grid.SetGlobal("unity_MatrixInvVP", Floats(invVP));
    grid.SetGlobal("unity_MatrixInvP", Floats(glm::mat4(glm::inverse(stage.projection))));
    const auto n = static_cast<float>(stage.n);
    const auto f = static_cast<float>(stage.f);
    grid.SetGlobal("_ZBufferParams", {f / n - 1, 1.0f, 1 / n - 1 / f, 1 / f});
    const auto depths = Combine({0.0, 1e-4, 0.01, 0.3, 0.9, 1.0});
    // Of reversed depth: 1 at the near plane, 0 at the far one.
    const auto eye = [&](double d)
    {
        return stage.f * stage.n / (d * (stage.f - stage.n) + stage.n);
    };
    grid.Add("LinearEyeDepth(a.x, _ZBufferParams)", depths,
             [&](auto& a, auto&, auto&) { return eye(a.x); });
    grid.Add("Linear01Depth(a.x, _ZBufferParams)", depths,
             [&](auto& a, auto&, auto&) { return eye(a.x) / stage.f; });
    grid.Add("Linear01DepthFromNear(a.x, _ZBufferParams)", depths,
             [&](auto& a, auto&, auto&) { return (eye(a.x) - stage.n) / (stage.f - stage.n); });
    grid.Add("LinearDepthToEyeDepth(a.x)", depths,
             [&](auto& a, auto&, auto&) { return stage.n + (stage.f - stage.n) * (1 - a.x); });
    grid.Add("LinearEyeDepth(a.xyz, UNITY_MATRIX_V)", CombineVectors(k_Points),
             [](auto& a, auto&, auto&) { return std::abs(a.z + 5.0); });
    grid.Add("ComputeNormalizedDeviceCoordinatesWithZ(a.xyz, UNITY_MATRIX_VP)",
             CombineVectors(k_Points),
             [&](auto& a, auto&, auto&)
             {
                 const glm::dvec4 c = stage.projection * stage.view * glm::dvec4(glm::dvec3(a), 1);
                 return glm::dvec3(0.5 + 0.5 * c.x / c.w, 0.5 - 0.5 * c.y / c.w, c.z / c.w);
             },
             {2e-5, 2e-6});
    grid.Add("float4(ComputeNormalizedDeviceCoordinates(a.xyz), "
             "ComputeNormalizedDeviceCoordinatesWithZ(a.xyz).z, ComputeClipSpacePosition(a.xyz).w)",
             CombineVectors(k_Points), // of clip space
             [](auto& a, auto&, auto&)
             { return glm::dvec4(0.5 + 0.5 * a.x, 0.5 - 0.5 * a.y, a.z, 1); });
    const char* place = "ComputeWorldSpacePosition(ComputeNormalizedDeviceCoordinatesWithZ(a.xyz, "
                        "UNITY_MATRIX_VP).xy, ComputeNormalizedDeviceCoordinatesWithZ(a.xyz, "
                        "UNITY_MATRIX_VP).z, UNITY_MATRIX_I_VP)";
    grid.Add(place, CombineVectors({{0, 0, 0}, {1, 2, 3}, {-4, 0.5, 2}}),
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {1e-4, 1e-4});
    grid.Run();
}

TEST_F(UniversalLibrary, FogsByDistance)
{
    const struct
    {
        const char* keyword;
        double (*factor)(double);
        double (*clear)(double);
    } modes[] = {
        {"FOG_LINEAR", [](double z) { return std::min(std::max(z * -0.02 + 1.2, 0.0), 1.0); },
         [](double factor)
         {
             return factor;
         }},
        // URP takes x, the density over sqrt(ln 2), here too.
        {"FOG_EXP", [](double z) { return 0.03 * z; },
         [](double x)
         {
             return std::exp2(-x);
         }},
        {"FOG_EXP2", [](double z) { return 0.03 * z; },
         [](double x)
         {
             return std::exp2(-x * x);
         }},
        {"NO_FOG", [](double) { return 0.0; },
         [](double)
         {
             return 1.0;
         }},
    };
    for (const auto& mode : modes)
    {
        SCOPED_TRACE(mode.keyword);
        FunctionGrid grid("#define " + std::string(mode.keyword) + "\n" LIMN_URP("Core"));
        Stage().SetUp(grid);
        const auto distances = Combine({0.0, 1.0, 15.0, 50.0, 99.0});
        grid.Add("ComputeFogFactorZ0ToFar(a.x)", distances,
                 [&](auto& a, auto&, auto&) { return mode.factor(a.x); });
        grid.Add("MixFog(float3(1, 0.5, 0), ComputeFogFactorZ0ToFar(a.x))", distances,
                 [&](auto& a, auto&, auto&)
                 {
                     const double clear = mode.clear(mode.factor(a.x));
                     return glm::dvec3(0.2, 0.4, 0.8) * (1 - clear) + glm::dvec3(1, 0.5, 0) * clear;
                 },
                 {1e-4, 1e-5});
        grid.Run();
    }
}

TEST_F(UniversalLibrary, GivesVertexFunctionsPlacesAndDirections)
{
    const Stage stage;
    FunctionGrid grid(LIMN_URP("Core"));
    stage.SetUp(grid);
    const glm::dvec3 camera(1.0, -0.5, -5.0);
    const auto points = CombineVectors(k_Points);
    const Tolerance place{1e-5, 1e-4};
    grid.Add(
        "TransformWorldToHClip(a.xyz)", points,
        [&](auto& a, auto&, auto&)
        { return stage.projection * stage.view * glm::dvec4(glm::dvec3(a), 1.0); },
        place);
    grid.Add("GetWorldSpaceNormalizeViewDir(a.xyz)", points,
             [=](auto& a, auto&, auto&) { return glm::normalize(camera - glm::dvec3(a)); });
    grid.Add("GetObjectSpaceNormalizeViewDir(a.xyz)", points,
             [&](auto& a, auto&, auto&)
             {
                 const glm::dvec3 toCamera = camera - Point(stage.object, a);
                 return glm::normalize(
                     Direction(glm::inverse(stage.object), glm::dvec4(toCamera, 0.0)));
             },
             {1e-4, 1e-5});
    for (const std::string function : {"NormalizeNormalPerPixel", "NormalizeNormalPerVertex"})
    {
        grid.Add(function + "(a.xyz * 3)", CombineVectors(UnitVectors()),
                 [](auto& a, auto&, auto&) { return glm::normalize(glm::dvec3(a)); });
    }
    grid.Add("GetCameraPositionWS()", Combine({0.0}), [=](auto&, auto&, auto&) { return camera; });
    for (const std::string function : {"GetAbsolutePositionWS", "GetCameraRelativePositionWS"})
    {
        grid.Add(function + "(a.xyz)", points, [](auto& a, auto&, auto&) { return glm::dvec3(a); });
    }
    grid.Add(
        "mul(GetObjectToWorldMatrix(), float4(a.xyz, 1)).xyz", points,
        [&](auto& a, auto&, auto&) { return Point(stage.object, a); }, place);
    grid.Add(
        "mul(GetWorldToObjectMatrix(), float4(a.xyz, 1)).xyz", points,
        [&](auto& a, auto&, auto&) { return Point(glm::inverse(stage.object), a); }, place);
    grid.Run();
}

TEST_F(UniversalLibrary, CoversTheScreenFromTheVertexNumberAlone)
{
    FunctionGrid grid(LIMN_URP("Core"));
    const auto three = Combine({0.0, 1.0, 2.0});
    const auto four = Combine({0.0, 1.0, 2.0, 3.0});
    const auto table = [](std::vector<glm::dvec4> rows)
    {
        return [rows](const glm::dvec4& a, auto&, auto&)
        {
            return rows.at(static_cast<std::size_t>(a.x));
        };
    };
    // z: the near plane, which is 1.
    grid.Add("GetFullScreenTriangleVertexPosition((uint)a.x)", three,
             table({{-1, -1, 1, 1}, {3, -1, 1, 1}, {-1, 3, 1, 1}}));
    // y of clip space points up, v of textures down.
    grid.Add("float4(GetFullScreenTriangleTexCoord((uint)a.x), 0, 0)", three,
             table({{0, 1, 0, 0}, {2, 1, 0, 0}, {0, -1, 0, 0}}));
    grid.Add("GetQuadVertexPosition((uint)a.x)", four,
             table({{0, 1, 1, 1}, {0, 0, 1, 1}, {1, 0, 1, 1}, {1, 1, 1, 1}}));
    grid.Add("float4(GetQuadTexCoord((uint)a.x), 0, 0)", four,
             table({{0, 1, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 0, 0}}));
    grid.Run();
}

TEST_F(UniversalLibrary, FogsByClipSpaceAndByPixel)
{
    const Stage stage;
    const auto depths = Combine({0.5, 0.4, 0.25, 0.0}); // of clip space: near plane to far plane
    const auto distance = [](double z)
    {
        return (0.5 - z) / 0.5 * 100.0;
    };
    const auto linear = [](double d)
    {
        return std::clamp(1.2 - 0.02 * d, 0.0, 1.0);
    };
    FunctionGrid grid("#define FOG_LINEAR 1\n" LIMN_URP("Core"));
    FunctionGrid square("#define FOG_EXP2 1\n#define _FOG_FRAGMENT 1\n" LIMN_URP("Core"));
    FunctionGrid none(LIMN_URP("Core"));
    for (FunctionGrid* each : {&grid, &square, &none})
    {
        stage.SetUp(*each);
    }
    grid.Add("ComputeFogFactor(a.x)", depths,
             [=](auto& a, auto&, auto&) { return linear(distance(a.x)); });
    grid.Add("MixFogColor(float3(1, 0, 2), float3(0, 1, 0), ComputeFogFactor(a.x))", depths,
             [=](auto& a, auto&, auto&)
             {
                 const double clear = linear(distance(a.x));
                 return glm::dvec3(clear, 1 - clear, 2 * clear);
             });
    grid.Add("InitializeInputDataFog(a, 0.75)", depths,
             [](auto&, auto&, auto&) { return 0.75; }); // what the vertex function worked out
    square.Add("ComputeFogFactor(a.x)", depths,
               [=](auto& a, auto&, auto&) { return 0.03 * distance(a.x); });
    square.Add("MixFogColor(float3(1, 0, 2), float3(0, 1, 0), ComputeFogFactor(a.x))", depths,
               [=](auto& a, auto&, auto&)
               {
                   const double clear = std::exp2(-std::pow(0.03 * distance(a.x), 2.0));
                   return glm::dvec3(clear, 1 - clear, 2 * clear);
               },
               {2e-5, 1e-6});
    // From the near plane of a camera at z = -5.
    square.Add("InitializeInputDataFog(float4(a.xyz, 1), 0.75)", CombineVectors(k_Points),
               [](auto& a, auto&, auto&) { return 0.03 * std::max(a.z + 5 - 0.5, 0.0); });
    none.Add("ComputeFogFactor(a.x)", depths, [](auto&, auto&, auto&) { return 0.0; });
    none.Add("MixFog(a.xyz, 0.25)", CombineVectors(k_Points),
             [](auto& a, auto&, auto&) { return glm::dvec3(a); });
    grid.Run();
    square.Run();
    none.Run();
}

TEST_F(UniversalLibrary, InitializesSurfaces)
{
    FunctionGrid grid(LIMN_URP("Lighting") R"(
        BRDFData Make(float3 albedo, float metallic, float smoothness)
        {
            BRDFData data; float alpha = 1;
            InitializeBRDFData(albedo, metallic, float3(9, 9, 9), smoothness, alpha, data);
            return data;
        })");
    std::vector<GridInput> inputs;
    for (const double metallic : {0.0, 0.3, 1.0})
    {
        for (const double smoothness : {0.0, 0.5, 0.9, 1.0})
        {
            inputs.push_back({{0.8, 0.4, 0.1, 0}, {metallic, smoothness, 0, 0}, {}});
        }
    }
    // 4 % of the light is reflected by what is no metal.
    grid.Add("Make(a.xyz, b.x, b.y).diffuse", inputs,
             [](auto& a, auto& b, auto&) { return glm::dvec3(a) * (0.96 * (1 - b.x)); });
    grid.Add("Make(a.xyz, b.x, b.y).specular", inputs,
             [](auto& a, auto& b, auto&) { return 0.04 * (1 - b.x) + glm::dvec3(a) * b.x; });
    grid.Add("Make(a.xyz, b.x, b.y).reflectivity", inputs,
             [](auto&, auto& b, auto&) { return 1 - 0.96 * (1 - b.x); });
    grid.Add("Make(a.xyz, b.x, b.y).grazingTerm", inputs,
             [](auto&, auto& b, auto&) { return std::min(b.y + 1 - 0.96 * (1 - b.x), 1.0); });
    // No surface is smoother than half precision can tell from a mirror.
    grid.Add("Make(a.xyz, b.x, b.y).roughness2", inputs,
             [](auto&, auto& b, auto&)
             {
                 const double roughness = std::max((1 - b.y) * (1 - b.y), 0.0078125);
                 return roughness * roughness;
             },
             {1e-4, 1e-9});
    grid.Add("PerceptualSmoothnessToPerceptualRoughness(b.y)", inputs,
             [](auto&, auto& b, auto&) { return 1 - b.y; });
    grid.Add("IsMatchingLightLayer((uint)a.x, (uint)b.x)", Combine({1.0, 6.0, 0.0}, {2.0, 9.0}),
             [](auto& a, auto& b, auto&)
             { return (static_cast<int>(a.x) & static_cast<int>(b.x)) != 0 ? 1.0 : 0.0; });
    grid.Add("float3(OutputAlpha(a.x, 1), OutputAlpha(a.x, 0), IsSurfaceTypeTransparent(a.x))",
             Combine({0.0, 0.25, 1.0}),
             [](auto& a, auto&, auto&) { return glm::dvec3(a.x, 1.0, a.x > 0.5 ? 1.0 : 0.0); });
    grid.Add("float2(OutputAlpha(a.x, IsSurfaceTypeTransparent(kSurfaceTypeOpaque)), "
             "OutputAlpha(a.x, IsSurfaceTypeTransparent(kSurfaceTypeTransparent)))",
             Combine({0.0, 0.25, 1.0}), [](auto& a, auto&, auto&) { return glm::dvec2(1.0, a.x); });
    grid.Add("OutputAlpha(a.x)", Combine({0.0, 0.25, 1.0}), // URP 7 to 11
             [](auto& a, auto&, auto&) { return a.x; });
    grid.Run();
}

} // namespace limn::test
