#include "library/Formulas.h"
#include "library/FunctionGrid.h"
#include "library/Lights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// URP's passes and the functions between them that fill structures, against formulas in double.

namespace limn::test::universal
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using UniversalShading = GpuTest;

std::string Include(const std::string& file)
{
    return "#include \"Packages/com.unity.render-pipelines.universal/" + file + ".hlsl\"\n";
}

std::shared_ptr<const Texture2D> OneTexel(const glm::vec4& texel)
{
    return MakeTexture(1, 1, [=](int, int) { return texel; });
}

const dvec3 k_Camera(1, 2, 6);

/// An object where it was modelled, seen in world space, before Lights.h's sky and sun.
void SetScene(FunctionGrid& grid)
{
    const std::vector<float> identity = Floats(glm::mat4(1));
    std::ranges::copy(identity, grid.perDraw.objectToWorld);
    std::ranges::copy(identity, grid.perDraw.worldToObject);
    grid.perDraw.worldTransformParams[3] = 1;
    grid.SetGlobal("unity_MatrixVP", identity);
    grid.SetGlobal("unity_MatrixV", identity);
    grid.SetGlobal("_WorldSpaceCameraPos", Floats4(k_Camera, 1));
    grid.SetGlobal("limn_CameraPos", Floats4(k_Camera, 1));
    grid.SetGlobal("_ScaledScreenParams", {8, 4, 1.125f, 1.25f});
    grid.SetGlobal("_ScaleBiasRt", {-1, 1, -1, 1});
    SetLights(grid);
}

struct Surface
{
    dvec3 diffuse{0};
    dvec3 specular{0};
    double reflectivity = 0;
    double smoothness = 0;

    double Roughness() const { return std::max(std::pow(1 - smoothness, 2), 1.0 / 128); }
};

/// Lights.h's sky from all sides, and its reflection.
dvec3 Around(const Surface& s, double cosine)
{
    const double r2 = std::max(s.Roughness() * s.Roughness(), std::pow(2.0, -14));
    const dvec3 mirrored = glm::mix(s.specular, dvec3(Saturate(s.smoothness + s.reflectivity)),
                                    std::pow(1 - cosine, 4));
    return k_Sky * s.diffuse + k_Mirrored * mirrored / (r2 + 1);
}
/// GGX with a fitted visibility, of a specular colour of 1.
double Highlight(double roughness, const dvec3& n, const dvec3& v)
{
    const dvec3 h = glm::normalize(k_Sun + v);
    const double r2 = std::max(roughness * roughness, std::pow(2.0, -14));
    const double d = std::pow(Saturate(glm::dot(n, h)), 2) * (r2 - 1) + 1.00001;
    const double fit = std::max(0.1, std::pow(Saturate(glm::dot(k_Sun, h)), 2));
    return r2 / (d * d * fit * (4 * roughness + 2));
}

const dvec3 k_Albedo(0.8, 0.4, 0.1);
const dvec3 k_Glow(0, 0, 0.25);

const std::vector<dvec3> k_Views = {{0, 0.6, -0.8}, {0, 1, 0}, {1, 0, 0}};
const std::vector<dvec3> k_Places = {{0, 0, 0}, {1, 1, 1}, {-2, 0, 5}};

/// A frame of any two directions across a normal.
const std::string k_Frame = R"(
    float3 limn_Across(float3 n) { return normalize(cross(n, float3(0.3, 0.5, 0.9))); }
)";
dvec3 Across(const dvec3& n)
{
    return glm::normalize(glm::cross(n, dvec3(0.3, 0.5, 0.9)));
}
dvec3 Turned(const dvec3& inFrame, const dvec3& n)
{
    const dvec3 t = Across(n);
    return glm::normalize(t * inFrame.x + glm::cross(n, t) * inFrame.y + n * inFrame.z);
}
const std::vector<dvec3> k_InFrame = {{0, 0, 1}, {0.6, 0, 0.8}, {-0.48, 0.64, 0.6}};

} // namespace

TEST_F(UniversalShading, TermsOfCoreFollowTheirFormulas)
{
    FunctionGrid grid(CoreInclude("CommonLighting") + CoreInclude("Color") +
                      CoreInclude("ImageBasedLighting") + R"(
        float4 Angles(float3 V, float3 L)
        {
            float4 r;
            GetBSDFAngle(V, L, 0.3, 0.6, r.x, r.y, r.z, r.w);
            return r;
        }
        float4 Brushed(float3 V, float anisotropy, float roughness)
        {
            float4 r;
            GetGGXAnisotropicModifiedNormalAndRoughness(float3(1, 0, 0), float3(0, 1, 0),
                float3(0, 0, 1), V, anisotropy, roughness, r.xyz, r.w);
            return r;
        })");
    grid.Add("Angles(a.xyz, b.xyz)", CombineVectors({{0, 0, 1}, {0, 0.6, 0.8}}, UnitVectors()),
             [](auto& a, auto& b, auto&)
             {
                 const double cosine = glm::dot(dvec3(a), dvec3(b));
                 const double inverse = 1 / std::sqrt(std::max(2 * cosine + 2, std::pow(2.0, -23)));
                 return dvec4(cosine, Saturate(0.9 * inverse), Saturate((1 + cosine) * inverse),
                              inverse);
             },
             {1e-4, 1e-6});
    grid.Add("GetSpecularOcclusionFromAmbientOcclusion(a.x, b.x, c.x)",
             Combine({0.0, 0.3, 1.0}, {0.0, 0.2, 0.7, 1.0}, {0.0, 0.25, 1.0}),
             [](auto& a, auto& b, auto& c)
             { return Saturate(std::pow(a.x + b.x, std::exp2(-16 * c.x - 1)) - 1 + b.x); });
    grid.Add("Brushed(a.xyz, b.x, c.x)",
             CombineVectors({{0, 0.6, 0.8}, {0.48, 0.64, 0.6}},
                            {{-0.75, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                            {{0.04, 0, 0}, {0.25, 0, 0}, {0.9, 0, 0}}),
             [](auto& a, auto& b, auto& c)
             {
                 const dvec3 grain = b.x < 0 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
                 const dvec3 v(a);
                 const dvec3 facing = glm::normalize(v - grain * glm::dot(v, grain));
                 const double bend = std::abs(b.x) * Saturate(1.5 * std::sqrt(c.x));
                 return dvec4(glm::normalize(glm::mix(dvec3(0, 0, 1), facing, bend)),
                              c.x * Saturate(1.2 - std::abs(b.x)));
             });
    grid.Add("SoftLight(a.xyz, b.xyz)",
             CombineVectors({{0, 0.25, 1}, {0.04, 0.5, 0.81}}, {{0, 0.25, 0.5}, {0.6, 0.9, 1}}),
             [](auto& a, auto& b, auto&)
             {
                 dvec3 result;
                 for (int i = 0; i < 3; ++i)
                 {
                     const double s = 2 * b[i];
                     result[i] = b[i] < 0.5 ? a[i] * s + a[i] * a[i] * (1 - s)
                                            : std::sqrt(a[i]) * (s - 1) + a[i] * (2 - s);
                 }
                 return result;
             });
    grid.Add("NeutralCurve(a.xyz, 0.2, 0.29, 0.24, 0.272, 0.02, 0.3)", CombineVectors(Colors()),
             [](auto& a, auto&, auto&)
             {
                 const dvec3 x(a);
                 return (0.2 * x * x + 0.24 * 0.29 * x + 0.272 * 0.02) /
                            (0.2 * x * x + 0.29 * x + 0.272 * 0.3) -
                        0.02 / 0.3;
             },
             {1e-5, 1e-5});
    grid.Run();
}

TEST_F(UniversalShading, CoatsTakeLightFromWhatLiesBelow)
{
    FunctionGrid grid("#define _CLEARCOAT\n#define _ADDITIONAL_LIGHTS_VERTEX\n" +
                      Include("ShaderLibrary/Lighting") + R"(
        float4 Shade(float3 n, float3 v)
        {
            InputData inputData = (InputData)0;
            inputData.normalWS = n;
            inputData.viewDirectionWS = v;
            inputData.bakedGI = SampleSH(n);
            inputData.vertexLighting = float3(0.1, 0.2, 0.05);
            SurfaceData surfaceData = (SurfaceData)0;
            surfaceData.albedo = float3(0.8, 0.4, 0.1);
            surfaceData.metallic = 0.25;
            surfaceData.smoothness = 0.5;
            surfaceData.occlusion = 0.75;
            surfaceData.emission = float3(0, 0, 0.25);
            surfaceData.alpha = 0.75;
            surfaceData.clearCoatMask = 0.5;
            surfaceData.clearCoatSmoothness = 0.8;
            return UniversalFragmentPBR(inputData, surfaceData);
        })");
    SetScene(grid);
    grid.Add("Shade(a.xyz, b.xyz)", CombineVectors(UnitVectors(), k_Views),
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 n(a), v(b);
                 const double nv = Saturate(glm::dot(n, v));
                 Surface s{k_Albedo * (0.96 * 0.75), glm::mix(dvec3(0.04), k_Albedo, 0.25),
                           1 - 0.96 * 0.75, 0.5};
                 // From below a coat of index 1.5 the surface reflects less than from below air.
                 const dvec3 root = glm::sqrt(s.specular);
                 const dvec3 below = (1.0 - 5.0 * root) / (5.0 - root);
                 s.specular = glm::mix(s.specular, below * below, 0.5);
                 const Surface coat{dvec3(0), dvec3(0.04), 0.04, 0.8};
                 const double taken = 0.5 * (0.04 + 0.96 * std::pow(1 - nv, 4));
                 const dvec3 around = Around(s, nv) * (1 - taken) + 0.5 * Around(coat, nv);
                 const double away = 0.5 * (0.04 + 0.96 * std::pow(1 - nv, 5));
                 const dvec3 direct =
                     (s.diffuse + s.specular * Highlight(s.Roughness(), n, v)) * (1 - away) +
                     0.5 * 0.04 * Highlight(coat.Roughness(), n, v);
                 const dvec3 sum = around * 0.75 +
                                   direct * k_SunColor * Saturate(glm::dot(n, k_Sun)) +
                                   dvec3(0.1, 0.2, 0.05) * s.diffuse + k_Glow;
                 return dvec4(sum, 0.75);
             },
             {2e-3, 1e-4});
    grid.Run();
}

TEST_F(UniversalShading, SurfacesComeInPartsToo)
{
    FunctionGrid grid("#define _ADDITIONAL_LIGHTS_VERTEX\n" + Include("ShaderLibrary/Lighting") +
                      R"(
        InputData Seen(float3 n, float3 v)
        {
            InputData inputData = (InputData)0;
            inputData.normalWS = n;
            inputData.viewDirectionWS = v;
            inputData.bakedGI = SampleSH(n);
            inputData.vertexLighting = float3(0.1, 0.2, 0.05);
            return inputData;
        }
        float4 Shade(float3 n, float3 v)
        {
            return UniversalFragmentPBR(Seen(n, v), float3(0.8, 0.4, 0.1), 0.25, float3(9, 9, 9), 0.5,
                                        0.75, float3(0, 0, 0.25), 0.625);
        }
        float4 Matte(float3 n)
        {
            return UniversalFragmentBlinnPhong(Seen(n, n), float3(0.8, 0.4, 0.1), 0, 0,
                                               float3(0, 0, 0.25), 0.625, float3(0, 0, 1));
        })");
    SetScene(grid);
    grid.Add("Shade(a.xyz, b.xyz)", CombineVectors(UnitVectors(), k_Views),
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 n(a), v(b);
                 const Surface s{k_Albedo * (0.96 * 0.75), glm::mix(dvec3(0.04), k_Albedo, 0.25),
                                 1 - 0.96 * 0.75, 0.5};
                 const dvec3 direct = (s.diffuse + s.specular * Highlight(s.Roughness(), n, v)) *
                                      k_SunColor * Saturate(glm::dot(n, k_Sun));
                 return dvec4(Around(s, Saturate(glm::dot(n, v))) * 0.75 + direct +
                                  dvec3(0.1, 0.2, 0.05) * s.diffuse + k_Glow,
                              0.625);
             },
             {1e-3, 1e-4});
    grid.Add("Matte(a.xyz)", CombineVectors(UnitVectors()),
             [](auto& a, auto&, auto&)
             {
                 const dvec3 lit = k_Sky + k_SunColor * Saturate(glm::dot(dvec3(a), k_Sun)) +
                                   dvec3(0.1, 0.2, 0.05);
                 return dvec4(lit * k_Albedo + k_Glow, 0.625);
             },
             {1e-4, 1e-5});
    grid.Run();
}

TEST_F(UniversalShading, LitSurfacesAreReadFromTheirTextures)
{
    FunctionGrid grid(
        "#define _DETAIL_MULX2\n#define _METALLICSPECGLOSSMAP\n#define _OCCLUSIONMAP\n"
        "#define _EMISSION\n#define _CLEARCOATMAP\n#define _NORMALMAP\n" +
        Include("Shaders/LitInput") + Include("Shaders/LitGBufferPass") + R"(
        SurfaceData Read(float4 uv)
        {
            SurfaceData s;
            InitializeStandardLitSurfaceData(uv.xy, s);
            return s;
        }
        FragmentOutput Stored(float3 place, float3 normal)
        {
            Varyings v = (Varyings)0;
            v.positionWS = place;
            v.normalWS = normal;
            v.tangentWS = float4(normalize(cross(normal, float3(0.3, 0.5, 0.9))), 1);
            return LitGBufferPassFragment(v);
        })");
    SetScene(grid);
    grid.SetTexture("_BaseMap", OneTexel({0.5f, 0.25f, 1, 0.5f}));
    grid.SetGlobal("_BaseColor", {0.8f, 0.5f, 0.25f, 0.5f});
    grid.SetTexture("_MetallicGlossMap", OneTexel({0.25f, 0, 0, 0.75f}));
    grid.SetGlobal("_Smoothness", {0.5f});
    grid.SetTexture("_BumpMap", OneTexel({0.5f, 0.5f, 1, 1})); // flat
    grid.SetTexture("_DetailNormalMap", OneTexel({0.5f, 0.5f, 1, 1}));
    grid.SetGlobal("_BumpScale", {1});
    grid.SetGlobal("_DetailNormalMapScale", {1});
    grid.SetTexture("_OcclusionMap", OneTexel({0, 0.5f, 0, 0}));
    grid.SetGlobal("_OcclusionStrength", {0.5f});
    grid.SetTexture("_EmissionMap", OneTexel({0.5f, 1, 0.25f, 0}));
    grid.SetGlobal("_EmissionColor", {2, 0.5f, 1, 0});
    grid.SetTexture("_ClearCoatMap", OneTexel({0.5f, 0.25f, 0, 0}));
    grid.SetGlobal("_ClearCoatMask", {0.5f});
    grid.SetGlobal("_ClearCoatSmoothness", {0.75f});
    grid.SetTexture("_DetailMask", OneTexel({0, 0, 0, 0.5f}));
    grid.SetTexture("_DetailAlbedoMap", OneTexel({0.25f, 0.5f, 1, 0}));
    const auto once = Combine({0.25});
    const dvec3 albedo = dvec3(0.4, 0.125, 0.25) * dvec3(0.75, 1, 1.5);
    const dvec3 glow(1, 0.5, 0.25);
    grid.Add("float4(Read(a).albedo, Read(a).alpha)", once,
             [=](auto&, auto&, auto&) { return dvec4(albedo, 0.25); });
    grid.Add(
        "float4(Read(a).metallic, Read(a).smoothness, Read(a).occlusion, Read(a).clearCoatMask)",
        once, [](auto&, auto&, auto&) { return dvec4(0.25, 0.375, 0.75, 0.25); });
    grid.Add("float4(Read(a).emission, Read(a).clearCoatSmoothness)", once,
             [=](auto&, auto&, auto&) { return dvec4(glow, 0.1875); });
    grid.Add("Read(a).normalTS", once, [](auto&, auto&, auto&) { return dvec3(0, 0, 1); },
             {1e-5, 5e-3});

    const Surface s{albedo * (0.96 * 0.75), glm::mix(dvec3(0.04), albedo, 0.25), 1 - 0.96 * 0.75,
                    0.375};
    const auto inputs = CombineVectors(k_Places, UnitVectors());
    grid.Add("Stored(a.xyz, b.xyz).GBuffer0.rgb", inputs,
             [=](auto&, auto&, auto&) { return albedo; });
    grid.Add("float3(Stored(a.xyz, b.xyz).GBuffer1.ra, Stored(a.xyz, b.xyz).GBuffer2.a)", inputs,
             [=](auto&, auto&, auto&) { return dvec3(s.reflectivity, 0.75, s.smoothness); });
    grid.Add("Stored(a.xyz, b.xyz).GBuffer3", inputs,
             [=](auto& a, auto& b, auto&)
             {
                 const double nv =
                     Saturate(glm::dot(dvec3(b), glm::normalize(k_Camera - dvec3(a))));
                 return dvec4(Around(s, nv) * 0.75 + glow, 1);
             },
             {1e-3, 5e-3}); // the normal map is flat to a 255th
    grid.Run();
}

TEST_F(UniversalShading, SimpleSurfacesAreReadFromTheirTextures)
{
    FunctionGrid grid("#define _SPECGLOSSMAP\n#define _EMISSION\n" +
                      Include("ShaderLibrary/Lighting") + Include("Shaders/SimpleLitInput") + R"(
        SurfaceData Read(float4 uv)
        {
            SurfaceData s;
            InitializeSimpleLitSurfaceData(uv.xy, s);
            return s;
        })");
    grid.SetTexture("_BaseMap", OneTexel({0.5f, 0.25f, 1, 0.5f}));
    grid.SetGlobal("_BaseColor", {0.8f, 0.5f, 0.25f, 0.5f});
    grid.SetTexture("_SpecGlossMap", OneTexel({0.5f, 0.25f, 1, 0.5f}));
    grid.SetGlobal("_SpecColor", {0.5f, 0.5f, 0.25f, 0.75f});
    grid.SetTexture("_EmissionMap", OneTexel({0.5f, 1, 0.25f, 0}));
    grid.SetGlobal("_EmissionColor", {2, 0.5f, 1, 0});
    const auto once = Combine({0.25});
    grid.Add("float4(Read(a).albedo, Read(a).alpha)", once,
             [](auto&, auto&, auto&) { return dvec4(0.4, 0.125, 0.25, 0.25); });
    grid.Add("float4(Read(a).specular, Read(a).smoothness)", once,
             [](auto&, auto&, auto&) { return dvec4(0.25, 0.125, 0.25, 0.375); });
    grid.Add("float4(Read(a).emission, Read(a).occlusion)", once,
             [](auto&, auto&, auto&) { return dvec4(1, 0.5, 0.25, 1); });
    grid.Add("float4(Read(a).normalTS, Read(a).metallic)", once,
             [](auto&, auto&, auto&) { return dvec4(0, 0, 1, 0); });
    grid.Run();
}

TEST_F(UniversalShading, FragmentsKnowWhereTheyAre)
{
    FunctionGrid grid("#define _NORMALMAP\n#define FOG_EXP2\n" + Include("Shaders/LitInput") +
                      Include("Shaders/LitForwardPass") + k_Frame + R"(
        Varyings Place(float3 place, float3 normal)
        {
            Attributes v = (Attributes)0;
            v.positionOS = float4(place, 1);
            v.normalOS = normal;
            v.tangentOS = float4(limn_Across(normal), 1);
            v.texcoord = place.xy;
            return ForwardPassVertex(v);
        }
        InputData At(float3 place, float3 normal, float3 normalTS)
        {
            Varyings v = Place(place, normal);
            v.positionCS = float4(2, 3, 0.5, 1);
            v.fogFactorAndVertexLight = float4(0.625, place);
            InputData d;
            InitializeInputData(v, normalTS, d);
            return d;
        })");
    SetScene(grid);
    grid.SetGlobal("_BaseMap_ST", {2, 4, 0.5f, -1});
    const auto inputs = CombineVectors(k_Places, UnitVectors(), k_InFrame);
    grid.Add("Place(a.xyz, b.xyz).positionCS", inputs,
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 1); });
    grid.Add("Place(a.xyz, b.xyz).uv", inputs,
             [](auto& a, auto&, auto&) { return dvec2(2 * a.x + 0.5, 4 * a.y - 1); });
    grid.Add("Place(a.xyz, b.xyz).tangentWS", inputs,
             [](auto&, auto& b, auto&) { return dvec4(Across(dvec3(b)), 1); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).positionWS", inputs,
             [](auto& a, auto&, auto&) { return dvec3(a); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).vertexLighting", inputs,
             [](auto& a, auto&, auto&) { return dvec3(a); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).normalWS", inputs,
             [](auto&, auto& b, auto& c) { return Turned(dvec3(c), dvec3(b)); });
    grid.Add("mul(c.xyz, At(a.xyz, b.xyz, c.xyz).tangentToWorld)", inputs,
             [](auto&, auto& b, auto& c) { return Turned(dvec3(c), dvec3(b)); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).viewDirectionWS", inputs,
             [](auto& a, auto&, auto&) { return glm::normalize(k_Camera - dvec3(a)); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).bakedGI", inputs, [](auto&, auto&, auto&) { return k_Sky; });
    grid.Add("float4(At(a.xyz, b.xyz, c.xyz).normalizedScreenSpaceUV, "
             "At(a.xyz, b.xyz, c.xyz).fogCoord, At(a.xyz, b.xyz, c.xyz).shadowMask.w)",
             inputs, [](auto&, auto&, auto&) { return dvec4(0.25, 0.75, 0.625, 1); });
    grid.Run();
}

TEST_F(UniversalShading, ParticlesKnowWhereTheyAre)
{
    for (const bool hasNormalMap : {false, true})
    {
        FunctionGrid grid((hasNormalMap ? "#define _NORMALMAP\n" : "") +
                          std::string("#define _FLIPBOOKBLENDING_ON\n#define _SOFTPARTICLES_ON\n") +
                          Include("Shaders/Particles/ParticlesLitInput") +
                          "#include \"limn/ParticlePass.hlsl\"\n" + k_Frame + R"(
            VaryingsParticle Place(float3 place, float3 normal)
            {
                AttributesParticle v = (AttributesParticle)0;
                v.positionOS = float4(place, 1);
                v.color = float4(place, 0.5);
                v.normalOS = normal;
                v.tangentOS = float4(limn_Across(normal), 1);
                v.texcoords = float4(place.xy, place.yz);
                v.texcoordBlend = 0.75;
                return limn_ParticleVertex(v);
            }
            InputData At(float3 place, float3 normal, float3 normalTS)
            {
                VaryingsParticle v = Place(place, normal);
                v.clipPos = float4(2, 3, 0.5, 1);
                v.positionWS.w = 0.625;
                InputData d;
                InitializeInputData(v, normalTS, d);
                return d;
            })");
        SetScene(grid);
        const auto inputs = CombineVectors(k_Places, UnitVectors(), k_InFrame);
        grid.Add("Place(a.xyz, b.xyz).clipPos", inputs,
                 [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 1); });
        grid.Add("Place(a.xyz, b.xyz).color", inputs,
                 [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 0.5); });
        grid.Add("Place(a.xyz, b.xyz).texcoord", inputs,
                 [](auto& a, auto&, auto&) { return dvec2(a); });
        grid.Add("Place(a.xyz, b.xyz).texcoord2AndBlend", inputs,
                 [](auto& a, auto&, auto&) { return dvec3(a.y, a.z, 0.75); });
        grid.Add("At(a.xyz, b.xyz, c.xyz).positionWS", inputs,
                 [](auto& a, auto&, auto&) { return dvec3(a); });
        grid.Add("At(a.xyz, b.xyz, c.xyz).normalWS", inputs,
                 [=](auto&, auto& b, auto& c)
                 { return hasNormalMap ? Turned(dvec3(c), dvec3(b)) : dvec3(b); });
        grid.Add("At(a.xyz, b.xyz, c.xyz).viewDirectionWS", inputs,
                 [](auto& a, auto&, auto&) { return glm::normalize(k_Camera - dvec3(a)); });
        grid.Add("At(a.xyz, b.xyz, c.xyz).bakedGI", inputs,
                 [](auto&, auto&, auto&) { return k_Sky; });
        grid.Add("float4(At(a.xyz, b.xyz, c.xyz).normalizedScreenSpaceUV, "
                 "At(a.xyz, b.xyz, c.xyz).fogCoord, At(a.xyz, b.xyz, c.xyz).shadowMask.w)",
                 inputs, [](auto&, auto&, auto&) { return dvec4(0.25, 0.75, 0.625, 1); });
        if (hasNormalMap)
        {
            grid.Add("mul(c.xyz, At(a.xyz, b.xyz, c.xyz).tangentToWorld)", inputs,
                     [](auto&, auto& b, auto& c) { return Turned(dvec3(c), dvec3(b)); });
        }
        grid.Run();
    }
}

} // namespace limn::test::universal
