#include "library/Formulas.h"
#include "library/FunctionGrid.h"
#include "library/Lights.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <vulkan/GpuTestDevice.h>

// Lights and reflection of the ShaderLibrary against the published formulas.

namespace limn::test
{

namespace
{

#define LIMN_CORE(name)                                                                            \
    "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/" name ".hlsl\"\n"
#define LIMN_URP(name)                                                                             \
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/" name ".hlsl\"\n"

const std::vector<double> k_Cosines = {0.0, 0.01, 0.3, 0.7, 1.0};
const std::vector<double> k_Roughness = {0.01, 0.2, 0.6, 1.0};

/// A surface as URP's Lit shader has it.
struct Material
{
    glm::dvec3 albedo{0.8, 0.4, 0.1};
    double metallic = 0.0;
    double smoothness = 0.5;

    double OneMinusReflectivity() const { return 0.96 * (1.0 - metallic); }
    glm::dvec3 Diffuse() const { return albedo * OneMinusReflectivity(); }
    glm::dvec3 Specular() const { return glm::dvec3(0.04) * (1.0 - metallic) + albedo * metallic; }
    double Roughness() const
    {
        return std::max((1.0 - smoothness) * (1.0 - smoothness), 1.0 / 128);
    }
};

/// r^2 / (d^2 max(0.1, LoH^2) (4 r + 2)), d = NoH^2 (r^2 - 1) + 1.00001, r = roughness.
double Highlight(double roughness, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v)
{
    const glm::dvec3 sum = l + v;
    const glm::dvec3 h = sum / std::max(glm::length(sum), 1e-19);
    const double noh = Saturate(glm::dot(n, h));
    const double loh = Saturate(glm::dot(l, h));
    const double r2 = std::max(roughness * roughness, std::pow(2.0, -14.0));
    const double d = noh * noh * (r2 - 1.0) + 1.00001;
    return r2 / (d * d * std::max(0.1, loh * loh) * (4.0 * roughness + 2.0));
}

/// Light of a direction that a material sends to the eye.
glm::dvec3 Direct(const Material& m, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v,
                  const glm::dvec3& color)
{
    const double cosine = Saturate(glm::dot(n, l));
    return (m.Diffuse() + m.Specular() * Highlight(m.Roughness(), n, l, v)) * color * cosine;
}

/// Even light from all sides, and what the surroundings mirror.
glm::dvec3 Ambient(const Material& m, const glm::dvec3& n, const glm::dvec3& v,
                   const glm::dvec3& sky)
{
    const double r2 = std::max(m.Roughness() * m.Roughness(), std::pow(2.0, -14.0));
    const double grazing = Saturate(m.smoothness + 1.0 - m.OneMinusReflectivity());
    const double fresnel = std::pow(1.0 - Saturate(glm::dot(n, v)), 4.0);
    const glm::dvec3 reflected = m.Specular() * (1.0 - fresnel) + glm::dvec3(grazing * fresnel);
    return sky * m.Diffuse() + k_Mirrored * reflected / (r2 + 1.0);
}

} // namespace

using LightingLibrary = GpuTest;

TEST_F(LightingLibrary, ReflectsByThePublishedTerms)
{
    FunctionGrid grid(LIMN_CORE("BSDF") LIMN_CORE("CommonLighting"));
    const auto cosines = Combine(k_Cosines, k_Cosines, k_Roughness);
    grid.Add("F_Schlick(a.x, b.x)", Combine({0.02, 0.04, 0.9}, k_Cosines),
             [](auto& a, auto& b, auto&) { return a.x + (1 - a.x) * std::pow(1 - b.x, 5.0); });
    grid.Add("F_FresnelDielectric(a.x, b.x)", Combine({1.0, 1.33, 1.5, 2.4}, {0.01, 0.3, 0.7, 1.0}),
             [](auto& a, auto& b, auto&)
             {
                 // Of light from air, by Snell's law and Fresnel's two amplitudes.
                 const double inside = std::sqrt(1 - (1 - b.x * b.x) / (a.x * a.x));
                 const double s = (b.x - a.x * inside) / (b.x + a.x * inside);
                 const double p = (a.x * b.x - inside) / (a.x * b.x + inside);
                 return (s * s + p * p) / 2;
             },
             {1e-4, 1e-6});
    grid.Add(
        "float2(IorToFresnel0(a.x), Fresnel0ToIor(IorToFresnel0(a.x)))", Combine({1.2, 1.5, 2.4}),
        [](auto& a, auto&, auto&) { return glm::dvec2(std::pow((a.x - 1) / (a.x + 1), 2), a.x); });
    grid.Add("D_GGX(a.x, c.x)", Combine({0.0, 0.3, 0.9, 1.0}, {0.0}, {0.1, 0.5, 1.0}),
             [](auto& a, auto&, auto& c)
             {
                 const double d = a.x * a.x * (c.x * c.x - 1) + 1;
                 return c.x * c.x / (M_PI * d * d);
             },
             {5e-5, 1e-6});
    grid.Add("V_SmithJointGGX(a.x, b.x, c.x)",
             Combine({0.01, 0.3, 1.0}, {0.01, 0.5, 1.0}, k_Roughness),
             [](auto& a, auto& b, auto& c)
             {
                 const double r2 = c.x * c.x;
                 return 0.5 / (a.x * std::sqrt(b.x * b.x * (1 - r2) + r2) +
                               b.x * std::sqrt(a.x * a.x * (1 - r2) + r2));
             },
             {2e-5, 1e-6});
    grid.Add("DisneyDiffuse(a.x, b.x, 0.5, c.x)", cosines,
             [](auto& a, auto& b, auto& c)
             {
                 const double rise = 0.5 + c.x * 1.5 - 1;
                 return (1 + rise * std::pow(1 - a.x, 5)) * (1 + rise * std::pow(1 - b.x, 5)) /
                        (1.03571 * M_PI); // as Unity normalises it
             });
    grid.Add("D_CharlieNoPI(a.x, c.x)", Combine({0.0, 0.5, 0.99}, {0.0}, {0.2, 0.6, 1.0}),
             [](auto& a, auto&, auto& c)
             { return (2 + 1 / c.x) * std::pow(1 - a.x * a.x, 0.5 / c.x) / 2; },
             {1e-4, 1e-6});
    grid.Run();
}

TEST_F(LightingLibrary, EvaluatesSphericalHarmonics)
{
    FunctionGrid grid(LIMN_URP("GlobalIllumination"));
    const std::vector<glm::dvec4> ar = {
        {0.1, -0.2, 0.3, 0.5}, {0.2, 0.1, -0.1, 0.6}, {0, 0.4, 0, 0.7}};
    const std::vector<glm::dvec4> br = {
        {0.1, 0, 0.2, -0.1}, {0, 0.1, 0.1, 0}, {0.05, 0.05, 0, 0.2}};
    const glm::dvec3 c(0.1, -0.05, 0.2);
    const char* const names[] = {"r", "g", "b"};
    for (std::size_t i = 0; i < 3; ++i)
    {
        grid.SetGlobal(std::string("unity_SHA") + names[i],
                       Floats4(glm::dvec3(ar[i]), static_cast<float>(ar[i].w)));
        grid.SetGlobal(std::string("unity_SHB") + names[i],
                       Floats4(glm::dvec3(br[i]), static_cast<float>(br[i].w)));
    }
    grid.SetGlobal("unity_SHC", Floats4(c, 0.0f));
    grid.Add("SampleSH(a.xyz)", CombineVectors(UnitVectors()),
             [=](auto& n, auto&, auto&)
             {
                 glm::dvec3 sum(0.0);
                 for (int i = 0; i < 3; ++i)
                 {
                     const auto& a = ar[static_cast<std::size_t>(i)];
                     const auto& b = br[static_cast<std::size_t>(i)];
                     sum[i] = a.x * n.x + a.y * n.y + a.z * n.z + a.w + b.x * n.x * n.y +
                              b.y * n.y * n.z + b.z * n.z * n.z + b.w * n.z * n.x +
                              c[i] * (n.x * n.x - n.y * n.y);
                     sum[i] = std::max(sum[i], 0.0);
                 }
                 return sum;
             });
    grid.Run();
}

// Of four boxes along x, each a quarter of the texture; the volume reaches from b to b + 1 / c.
TEST_F(LightingLibrary, FindsAPlaceInAProbeVolume)
{
    FunctionGrid grid(LIMN_CORE("EntityLighting") R"(
        static const float4x4 k_Twice = float4x4(2, 0, 0, 1, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1);)");
    grid.Add("limn_InProbeVolume(a.xyz, k_Twice, a.w, b.xyz, c.xyz)",
             {{{1, 2, 3, 0}, {-1, 0, 1, 0}, {0.5, 0.25, 0.125, 0}},
              {{1, 2, 3, 1}, {-1, 0, 1, 0}, {0.5, 0.25, 0.125, 0}}},
             [](auto& a, auto& b, auto& c)
             {
                 const glm::dvec3 local =
                     a.w == 1.0 ? glm::dvec3(2 * a.x + 1, 2 * a.y, 2 * a.z) : glm::dvec3(a);
                 return (local - glm::dvec3(b)) * glm::dvec3(c);
             });
    // Quarters of eight texels in all: a texel's middle is never nearer to a border than 1 / 16.
    grid.Add("limn_InProbeBox(a.xyz, b.x, 0.125)",
             {{{-5, 0.3, 0.4, 0}, {0, 0, 0, 0}},
              {{0.5, 0.3, 0.4, 0}, {1, 0, 0, 0}},
              {{5, 0.3, 0.4, 0}, {3, 0, 0, 0}}},
             [](auto& a, auto& b, auto&)
             {
                 const double x = a.x < 0 ? 1.0 / 16 : a.x > 1 ? 3.0 / 16 : 1.0 / 8;
                 return glm::dvec3(x + b.x / 4, a.y, a.z);
             });
    grid.Run();
}

TEST_F(LightingLibrary, ReadsWhatWasBakedBeforehand)
{
    FunctionGrid grid(LIMN_CORE("EntityLighting") LIMN_CORE("ImageBasedLighting")
                          LIMN_CORE("Filtering"));
    grid.Add("DecodeHDREnvironment(a, b)",
             {{{0.5, 0.25, 1, 0.5}, {2, 1, 0, 0}}, {{0.5, 0.25, 1, 0.5}, {2, 2.2, 0, 1}}},
             [](auto& a, auto& b, auto&)
             {
                 const double alpha = b.w == 0.0 ? 1.0 : a.w;
                 return glm::dvec3(a) * b.x * std::pow(alpha, b.y);
             });
    grid.Add("MipmapLevelToPerceptualRoughness(PerceptualRoughnessToMipmapLevel(a.x))",
             Combine({0.0, 0.1, 0.5, 0.9, 1.0}), [](auto& a, auto&, auto&) { return a.x; },
             {1e-5, 2e-5});
    grid.Add("PerceptualRoughnessToMipmapLevel(a.x)", Combine({0.0, 0.5, 1.0}),
             [](auto& a, auto&, auto&) { return 6 * a.x * (1.7 - 0.7 * a.x); });
    grid.Add("Hammersley2dSeq((uint)a.x, 8)", Combine({0.0, 1.0, 2.0, 3.0, 6.0, 7.0}),
             [](auto& a, auto&, auto&)
             {
                 const int i = static_cast<int>(a.x);
                 return glm::dvec2(i / 8.0, (i & 1) / 2.0 + (i >> 1 & 1) / 4.0 + (i >> 2) / 8.0);
             });
    const auto places = Combine({0.0, 0.25, 0.5, 0.9, 1.0});
    grid.Add("float4(BSpline3Leftmost(a.xx).x, BSpline3MiddleLeft(a.xx).x, "
             "BSpline3MiddleRight(a.xx).x, BSpline3Rightmost(a.xx).x)",
             places,
             [](auto& a, auto&, auto&)
             {
                 // The cubic B-spline at the distances of the four neighbours.
                 const auto spline = [](double d)
                 {
                     return d < 1 ? 2.0 / 3 - d * d + d * d * d / 2 : std::pow(2 - d, 3) / 6;
                 };
                 return glm::dvec4(spline(1 + a.x), spline(a.x), spline(1 - a.x), spline(2 - a.x));
             });
    grid.Add("BSpline2Left(a.xx).x + BSpline2Middle(a.xx).x + BSpline2Right(a.xx).x", places,
             [](auto&, auto&, auto&) { return 1.0; });
    grid.Run();
}

TEST_F(LightingLibrary, ReachesNoFurtherThanALightsRangeAndCone)
{
    FunctionGrid grid(LIMN_URP("Lighting"));
    // Light 0: at (1, 2, 3), range 10; light 1: a cone of 30 to 40 degrees that looks down.
    const double inner = std::cos(30 * M_PI / 180);
    const double outer = std::cos(40 * M_PI / 180);
    const auto scale = static_cast<float>(1 / (inner - outer));
    const auto offset = static_cast<float>(-outer / (inner - outer));
    grid.SetGlobal("_AdditionalLightsCount", {4, 0, 0, 0});
    grid.SetGlobal("limn_LightCount", {2, 0, 0, 0});
    grid.SetGlobal("unity_LightIndices", {0, 1, 0, 0, 0, 0, 0, 0});
    grid.SetGlobal("_AdditionalLightsPosition", {1, 2, 3, 1, 0, 5, 0, 1});
    grid.SetGlobal("_AdditionalLightsColor", {1, 2, 3, 0, 4, 4, 4, 0});
    grid.SetGlobal("_AdditionalLightsAttenuation", {0.01f, 0, 0, 1, 0.01f, 0, scale, offset});
    grid.SetGlobal("_AdditionalLightsSpotDir", {0, 0, 1, 0, 0, 1, 0, 0});
    const auto points = CombineVectors(
        {{0, 0, 0}, {1, 2, 3.5}, {8, 2, 3}, {1, 2, 13.5}, {0.5, 0, 0}, {3.5, 0, 0}, {10, 0, 0}});
    const auto falloff = [](const glm::dvec3& toLight)
    {
        const double d2 = glm::dot(toLight, toLight);
        const double window = Saturate(1 - std::pow(d2 / 100, 2));
        return window * window / d2;
    };
    grid.Add("GetAdditionalLight(0, a.xyz).distanceAttenuation", points,
             [&](auto& a, auto&, auto&) { return falloff(glm::dvec3(1, 2, 3) - glm::dvec3(a)); },
             {5e-5, 1e-7});
    grid.Add("GetAdditionalLight(1, a.xyz).distanceAttenuation", points,
             [&](auto& a, auto&, auto&)
             {
                 const glm::dvec3 toLight = glm::dvec3(0, 5, 0) - glm::dvec3(a);
                 const double cosine = glm::normalize(toLight).y;
                 const double cone = Saturate((cosine - outer) / (inner - outer));
                 return falloff(toLight) * cone * cone;
             },
             {1e-4, 1e-6});
    grid.Add("GetAdditionalLight(0, a.xyz).direction", points,
             [](auto& a, auto&, auto&)
             { return glm::normalize(glm::dvec3(1, 2, 3) - glm::dvec3(a)); });
    grid.Add("float4(GetAdditionalLight(1, a.xyz).color, GetAdditionalLightsCount())", points,
             [](auto&, auto&, auto&) { return glm::dvec4(4, 4, 4, 2); });
    grid.Run();
}

TEST_F(LightingLibrary, HasTheLightsOfTheObjectInTheirOrder)
{
    FunctionGrid grid(LIMN_URP("Lighting"));
    grid.SetGlobal("_AdditionalLightsCount", {7, 0, 0, 0});
    grid.SetGlobal("limn_LightCount", {6, 0, 0, 0});
    grid.SetGlobal("unity_LightIndices", {3, 4, 9, 10, 17, 31, 0, 0});
    const double indices[] = {3, 4, 9, 10, 17, 31};
    grid.Add("GetPerObjectLightIndex((uint)a.x)", Combine({0.0, 1.0, 2.0, 3.0, 4.0, 5.0}),
             [&](auto& a, auto&, auto&) { return indices[static_cast<int>(a.x)]; });
    grid.Add("float4(GetAdditionalLightsCount(), unity_LightData.yz, 0)", Combine({0.0}),
             [](auto&, auto&, auto&) { return glm::dvec4(6, 6, 1, 0); });
    grid.Run();
}

TEST_F(LightingLibrary, LightsEverythingWhereThereIsNoShadowMap)
{
    for (const char* keywords : {"", "#define _MAIN_LIGHT_SHADOWS\n",
                                 "#define _MAIN_LIGHT_SHADOWS_CASCADE\n#define _SHADOWS_SOFT\n"})
    {
        SCOPED_TRACE(keywords);
        FunctionGrid grid(keywords + std::string(LIMN_URP("Lighting")));
        grid.Add("GetMainLight(TransformWorldToShadowCoord(a.xyz), a.xyz, 1).shadowAttenuation",
                 CombineVectors({{0, 0, 0}, {5, -3, 40}}), [](auto&, auto&, auto&) { return 1.0; });
        grid.Add("ApplyShadowBias(a.xyz, b.xyz, float3(0, 1, 0))",
                 CombineVectors({{1, 2, 3}}, UnitVectors()),
                 [](auto& a, auto& n, auto&)
                 {
                     const double grazing = 1 - Saturate(n.y);
                     return glm::dvec3(a) + glm::dvec3(0, -0.25, 0) +
                            glm::dvec3(n) * grazing * -0.5;
                 });
        grid.SetGlobal("_ShadowBias", {-0.25f, -0.5f, 0, 0});
        grid.Run();
    }
}

TEST_F(LightingLibrary, DarkensWhatAShadowMapCovers)
{
    FunctionGrid grid("#define _MAIN_LIGHT_SHADOWS\n" LIMN_URP("Lighting"));
    // The map is white: what is nearest to the light is as near as can be. Shadow space is the
    // world.
    grid.SetGlobal("_MainLightWorldToShadow", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    grid.SetGlobal("_MainLightShadowParams", {0.75f, 0, 0, 0});
    grid.Add("MainLightRealtimeShadow(TransformWorldToShadowCoord(a.xyz))",
             CombineVectors({{0.5, 0.5, 0.5}, {0.1, 0.9, 0.999}, {0.5, 0.5, 1}, {0.5, 0.5, 0}}),
             [](auto& a, auto&, auto&) { return a.z > 0.0 && a.z < 1.0 ? 0.25 : 1.0; });
    grid.Add("MixRealtimeAndBakedShadows(a.x, b.x, c.x)",
             Combine({0.0, 0.5, 1.0}, {0.25, 1.0}, {0.0, 0.5, 1.0}),
             [](auto& a, auto& b, auto& c) { return a.x * (1 - c.x) + b.x * c.x; });
    grid.Run();
}

TEST_F(LightingLibrary, ShadesPhysicallyBased)
{
    FunctionGrid grid("#define _ADDITIONAL_LIGHTS\n" LIMN_URP("Lighting") R"(
        float4 Shade(float3 n, float3 v, float metallic, float smoothness)
        {
            InputData inputData = (InputData)0;
            inputData.normalWS = n;
            inputData.viewDirectionWS = v;
            inputData.bakedGI = SampleSH(n);
            SurfaceData surfaceData = (SurfaceData)0;
            surfaceData.albedo = float3(0.8, 0.4, 0.1);
            surfaceData.metallic = metallic;
            surfaceData.smoothness = smoothness;
            surfaceData.occlusion = 1;
            surfaceData.emission = float3(0, 0, 0.25);
            surfaceData.alpha = 0.75;
            return UniversalFragmentPBR(inputData, surfaceData);
        })");
    SetLights(grid);
    grid.SetGlobal("_AdditionalLightsCount", {4, 0, 0, 0});
    grid.SetGlobal("limn_LightCount", {1, 0, 0, 0});
    grid.SetGlobal("_AdditionalLightsPosition", {0, 0, 1, 0}); // a direction
    grid.SetGlobal("_AdditionalLightsColor", {0.5f, 0.5f, 0.5f, 0});
    grid.SetGlobal("_AdditionalLightsAttenuation", {0, 0, 0, 1});
    for (const glm::dvec2 surface : {glm::dvec2(0, 0), glm::dvec2(0, 0.5), glm::dvec2(0.5, 0.9),
                                     glm::dvec2(1, 0.25), glm::dvec2(1, 1)})
    {
        const Material m{{0.8, 0.4, 0.1}, surface.x, surface.y};
        const std::string call = "Shade(a.xyz, b.xyz, " + std::to_string(surface.x) + ", " +
                                 std::to_string(surface.y) + ")";
        grid.Add(call, CombineVectors(UnitVectors(), {{0, 0.6, -0.8}, {0, 1, 0}, {1, 0, 0}}),
                 [=](auto& a, auto& b, auto&)
                 {
                     const glm::dvec3 n(a);
                     const glm::dvec3 v(b);
                     const glm::dvec3 sum =
                         Ambient(m, n, v, k_Sky) + Direct(m, n, k_Sun, v, k_SunColor) +
                         Direct(m, n, {0, 0, 1}, v, glm::dvec3(0.5)) + glm::dvec3(0, 0, 0.25);
                     return glm::dvec4(sum, 0.75);
                 },
                 {1e-3, 1e-5}); // near a mirror's highlight d is a small difference of floats
    }
    grid.Run();
}

TEST_F(LightingLibrary, ShadesByLambertAndBlinnPhong)
{
    FunctionGrid grid("#define _SPECULAR_COLOR\n" LIMN_URP("Unlit") R"(
        float4 Shade(float3 n, float3 v, bool lit)
        {
            InputData inputData = (InputData)0;
            inputData.normalWS = n;
            inputData.viewDirectionWS = v;
            inputData.bakedGI = SampleSH(n);
            SurfaceData surfaceData = (SurfaceData)0;
            surfaceData.albedo = float3(0.8, 0.4, 0.1);
            surfaceData.specular = float3(0.5, 0.25, 1);
            surfaceData.smoothness = 0.3;
            surfaceData.occlusion = 0.5;
            surfaceData.alpha = 1;
            return lit ? UniversalFragmentBlinnPhong(inputData, surfaceData)
                       : UniversalFragmentBakedLit(inputData, surfaceData);
        })");
    SetLights(grid);
    const auto inputs = CombineVectors(UnitVectors(), {{0, 0.6, -0.8}, {1, 0, 0}});
    const glm::dvec3 albedo(0.8, 0.4, 0.1);
    grid.Add("Shade(a.xyz, b.xyz, true)", inputs,
             [=](auto& a, auto& b, auto&)
             {
                 const glm::dvec3 h = glm::normalize(k_Sun + glm::dvec3(b));
                 const double shine =
                     std::pow(Saturate(glm::dot(glm::dvec3(a), h)), std::exp2(10 * 0.3 + 1));
                 const double cosine = Saturate(glm::dot(glm::dvec3(a), k_Sun));
                 const glm::dvec3 color = k_Sky * 0.5 * albedo + k_SunColor * cosine * albedo +
                                          k_SunColor * glm::dvec3(0.5, 0.25, 1) * shine;
                 return glm::dvec4(color, 1);
             },
             {1e-4, 1e-5});
    grid.Add("Shade(a.xyz, b.xyz, false)", inputs,
             [=](auto&, auto&, auto&) { return glm::dvec4(k_Sky * 0.5 * albedo, 1); });
    grid.Run();
}

} // namespace limn::test
