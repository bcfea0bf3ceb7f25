#include "library/Formulas.h"
#include "library/FunctionGrid.h"
#include "library/Lights.h"

#include <bit>
#include <cmath>
#include <vulkan/GpuTestDevice.h>

// How the ShaderLibrary adds light up, and which of it arrives.

namespace limn::test
{

#define LIMN_URP(name)                                                                             \
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/" name ".hlsl\"\n"

using LightSum = GpuTest;

TEST_F(LightSum, MultipliesAllLightButEmissionByTheAlbedo)
{
    FunctionGrid grid(LIMN_URP("Lighting") R"(
        LightingData Sum(float3 a, float3 b)
        {
            LightingData data = (LightingData)0;
            data.giColor = a;
            data.mainLightColor = b;
            data.additionalLightsColor = 2 * b;
            data.vertexLightingColor = 4 * b;
            data.emissionColor = float3(0.5, 0.25, 0.125);
            return data;
        })");
    const auto inputs = CombineVectors(Colors(), Colors(), {{0.8, 0.4, 0.1}, {0, 0, 0}});
    const glm::dvec3 emission(0.5, 0.25, 0.125);
    grid.Add("CalculateLightingColor(Sum(a.xyz, b.xyz), c.xyz)", inputs,
             [=](auto& a, auto& b, auto& c)
             { return (glm::dvec3(a) + glm::dvec3(b) * 7.0) * glm::dvec3(c) + emission; });
    grid.Add("CalculateFinalColor(Sum(a.xyz, b.xyz), c.x)", inputs,
             [=](auto& a, auto& b, auto& c)
             { return glm::dvec4(glm::dvec3(a) + glm::dvec3(b) * 7.0 + emission, c.x); });
    grid.Run();
}

TEST_F(LightSum, PremultipliesWhatASurfaceScattersAndNotItsHighlight)
{
    for (const bool isPremultiplied : {false, true})
    {
        FunctionGrid grid(std::string(isPremultiplied ? "#define _ALPHAPREMULTIPLY_ON\n" : "") +
                          "#define _SPECULAR_COLOR\n" LIMN_URP("Lighting") R"(
            float3 Shade(float3 n, float alpha)
            {
                InputData inputData = (InputData)0;
                inputData.normalWS = n;
                inputData.viewDirectionWS = float3(0, 0.6, -0.8);
                SurfaceData surfaceData = (SurfaceData)0;
                surfaceData.albedo = float3(0.8, 0.4, 0.1);
                surfaceData.specular = float3(0.5, 0.25, 1);
                surfaceData.smoothness = 0.3;
                surfaceData.alpha = alpha;
                return CalculateBlinnPhong(GetMainLight(), inputData, surfaceData);
            })");
        SetLights(grid);
        grid.Add("Shade(a.xyz, b.x)",
                 CombineVectors(UnitVectors(), {{0, 0, 0}, {0.25, 0, 0}, {1, 0, 0}}),
                 [=](auto& a, auto& b, auto&)
                 {
                     const glm::dvec3 n(a);
                     const glm::dvec3 h = glm::normalize(k_Sun + glm::dvec3(0, 0.6, -0.8));
                     const double shine = std::pow(Saturate(glm::dot(n, h)), std::exp2(4.0));
                     const double cosine = Saturate(glm::dot(n, k_Sun));
                     return k_SunColor *
                            (glm::dvec3(0.8, 0.4, 0.1) * cosine * (isPremultiplied ? b.x : 1.0) +
                             glm::dvec3(0.5, 0.25, 1) * shine);
                 },
                 {1e-4, 1e-5});
        grid.Run();
    }
}

TEST_F(LightSum, TakesLightMapsForWhite)
{
    FunctionGrid grid(LIMN_URP("Lighting"));
    for (const char* coordinates : {"a.xy", "a.xy, a.yx"})
    {
        grid.Add("a.xyz + SampleLightmap(" + std::string(coordinates) + ", b.xyz)",
                 CombineVectors({{0, 0, 0}, {0.5, 1, 0}}, UnitVectors()),
                 [](auto& a, auto&, auto&) { return glm::dvec3(a) + 1.0; });
    }
    grid.Run();
}

/// The bits of an integer, as SetGlobal takes them.
static float BitsOf(std::uint32_t bits)
{
    return std::bit_cast<float>(bits);
}

TEST_F(LightSum, LightsOnlyTheRenderingLayersOfALight)
{
    for (const bool hasLayers : {false, true})
    {
        FunctionGrid grid(std::string(hasLayers ? "#define _LIGHT_LAYERS\n" : "") +
                          LIMN_URP("Lighting") R"(
            float3 Shade(float3 n)
            {
                InputData inputData = (InputData)0;
                inputData.normalWS = n;
                inputData.viewDirectionWS = n;
                SurfaceData surfaceData = (SurfaceData)0;
                surfaceData.albedo = 1;
                return UniversalFragmentBlinnPhong(inputData, surfaceData).rgb;
            })");
        SetLights(grid);
        grid.SetGlobal("_MainLightLayerMask", {BitsOf(0x104)});
        for (const std::uint32_t layers : {0x4u, 0x100u, 0x1u, 0xFFFFFEFBu})
        {
            SCOPED_TRACE(layers);
            FunctionGrid drawn = grid;
            drawn.perDraw.renderingLayer[0] = layers;
            const bool isLit = !hasLayers || (layers & 0x104u) != 0;
            drawn.Add("Shade(a.xyz)", CombineVectors(UnitVectors()),
                      [=](auto& n, auto&, auto&)
                      {
                          const double cosine = Saturate(glm::dot(glm::dvec3(n), k_Sun));
                          return k_SunColor * (isLit ? cosine : 0.0);
                      });
            drawn.Run();
        }
    }
}

TEST_F(LightSum, LooksUpShadowsOfTheScreenForWhatIsOpaqueOnly)
{
    const std::string screen = "#define _MAIN_LIGHT_SHADOWS_SCREEN\n";
    FunctionGrid transparent(screen + "#define _SURFACE_TYPE_TRANSPARENT\n" LIMN_URP("Lighting"));
    // As in DarkensWhatAShadowMapCovers; a position on the screen would be another one.
    transparent.SetGlobal("_MainLightWorldToShadow",
                          {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    transparent.SetGlobal("_MainLightShadowParams", {0.75f, 0, 0, 0});
    transparent.Add("TransformWorldToShadowCoord(a.xyz)", CombineVectors({{0.5, 0.25, 0.75}}),
                    [](auto& a, auto&, auto&) { return glm::dvec4(glm::dvec3(a), 0.0); });
    transparent.Add("GetShadowCoord(GetVertexPositionInputs(a.xyz))",
                    CombineVectors({{0.5, 0.25, 0.75}}),
                    [](auto&, auto&, auto&) { return glm::dvec4(0.0); });
    transparent.Add("MainLightRealtimeShadow(TransformWorldToShadowCoord(a.xyz))",
                    CombineVectors({{0.5, 0.5, 0.5}, {0.5, 0.5, 1}}),
                    [](auto& a, auto&, auto&) { return a.z < 1.0 ? 0.25 : 1.0; });
    transparent.Run();

    FunctionGrid opaque(screen + LIMN_URP("Lighting"));
    opaque.SetGlobal("_ProjectionParams", {-1, 0.5f, 200, 0.005f}); // into a texture
    opaque.SetGlobal("unity_MatrixVP", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    opaque.Add("TransformWorldToShadowCoord(a.xyz)", CombineVectors({{0.5, -0.5, 0.25}}),
               [](auto&, auto&, auto&) { return glm::dvec4(0.75, 0.75, 0.25, 1.0); });
    opaque.Run();
}

} // namespace limn::test
