#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// Passes of the built-in pipeline, from a vertex to a colour, and what fills structures in between.

namespace limn::test::shading
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using BuiltinShading = GpuTest;

const dvec3 k_LightColor(1, 0.5, 2);
const dvec3 k_LightDir(0, 0.6, 0.8);
const dvec3 k_Camera(1, 2, 6);
const dvec3 k_Sky(0.1, 0.2, 0.3);
const dvec3 k_Albedo(0.8, 0.4, 0.2);
const Tolerance k_Lobe{2e-3, 2e-4}; // the device subtracts near numbers at the top of a highlight

struct Shiny
{
    dvec3 diffuse{0};
    dvec3 specular{0};
    double oneMinusReflectivity = 0;
    double smoothness = 0;

    double Grazing() const { return Saturate(smoothness + 1 - oneMinusReflectivity); }
};

/// The surface of k_Albedo, a quarter of a metal.
Shiny QuarterMetal()
{
    return {k_Albedo * (0.96 * 0.75), glm::mix(dvec3(0.04), k_Albedo, 0.25), 0.96 * 0.75, 0.6};
}

/// Disney's diffuse and GGX with Smith's visibility: what a light of color from l adds.
dvec3 Direct(const Shiny& s, const dvec3& n, const dvec3& l, const dvec3& v, const dvec3& color)
{
    const double perceptual = 1 - s.smoothness;
    const double rough = std::max(0.002, perceptual * perceptual);
    const dvec3 h = (l + v) / std::sqrt(std::max(0.001, glm::dot(l + v, l + v)));
    const double nv = std::abs(glm::dot(n, v));
    const double nl = Saturate(glm::dot(n, l));
    const double nh = Saturate(glm::dot(n, h));
    const double lh = Saturate(glm::dot(l, h));
    const double f = 2 * lh * lh * perceptual - 0.5;
    const double matte = nl * (1 + f * std::pow(1 - nl, 5)) * (1 + f * std::pow(1 - nv, 5));
    const double a2 = rough * rough;
    const double d = nh * nh * (a2 - 1) + 1;
    const double visibility =
        0.5 / (nl * (nv + rough - nv * rough) + nv * (nl + rough - nl * rough) + 1e-5);
    const double lobe = nl * visibility * a2 / (d * d + 1e-7);
    const dvec3 fresnel = glm::mix(s.specular, dvec3(1), std::pow(1 - lh, 5));
    return color * (s.diffuse * matte + fresnel * lobe);
}
/// What surroundings of one colour add to it.
dvec3 Mirrored(const Shiny& s, const dvec3& n, const dvec3& v, const dvec3& around)
{
    const double fresnel = std::pow(1 - std::abs(glm::dot(n, v)), 5);
    const double rough = std::max(0.002, std::pow(1 - s.smoothness, 2));
    return around * glm::mix(s.specular, dvec3(s.Grazing()), fresnel) / (rough * rough + 1);
}
/// Phong's lobe, a quarter as narrow as Blinn's of the same roughness.
double Phong(double smoothness, double mirrored)
{
    const double m2 = std::max(1e-4, std::pow(1 - smoothness, 4));
    const double power = std::max(2 / m2 - 2, 1e-4) / 4;
    return std::min(16.0, std::pow(std::abs(mirrored), power) * (power + 1) / 2);
}

const std::vector<float> k_Identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

std::vector<float> Floats3(const dvec3& v, float w = 1)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), w};
}

std::shared_ptr<const Texture2D> OneTexel(const glm::vec4& texel)
{
    return MakeTexture(1, 1, [=](int, int) { return texel; });
}

/// An object where it was modelled, seen in world space, in the light of one lamp.
void SetScene(FunctionGrid& grid)
{
    std::ranges::copy(k_Identity, grid.perDraw.objectToWorld);
    std::ranges::copy(k_Identity, grid.perDraw.worldToObject);
    grid.perDraw.worldTransformParams[3] = 1;
    grid.SetGlobal("unity_MatrixVP", k_Identity);
    grid.SetGlobal("unity_MatrixV", k_Identity);
    grid.SetGlobal("_LightColor0", Floats3(k_LightColor));
    grid.SetGlobal("_MainLightColor", Floats3(k_LightColor));
    grid.SetGlobal("_MainLightPosition", Floats3(k_LightDir, 0));
    grid.SetGlobal("_WorldSpaceCameraPos", Floats3(k_Camera));
    grid.SetGlobal("limn_CameraPos", Floats3(k_Camera));
    grid.SetGlobal("unity_AmbientSky", Floats3(k_Sky));
}

/// The material of QuarterMetal: it shines by itself, and a texture closes half of its
/// surroundings.
void SetMaterial(FunctionGrid& grid)
{
    grid.SetGlobal("_Color", Floats3(k_Albedo));
    grid.SetGlobal("_Metallic", {0.25f});
    grid.SetGlobal("_Glossiness", {0.6f});
    grid.SetGlobal("_EmissionColor", {0.05f, 0.3f, 0.15f, 1});
    grid.SetGlobal("_OcclusionStrength", {0.5f});
    grid.SetTexture("_OcclusionMap", OneTexel({0, 0, 0, 0}));
}
const dvec3 k_Glow(0.05, 0.3, 0.15);

const std::vector<dvec3> k_Places = {{0, 0, 0}, {1, 1, 1}, {-2, 0, 5}};

} // namespace

TEST_F(BuiltinShading, PhongsLobeIsTheCheapest)
{
    FunctionGrid grid(R"(
        #include "UnityStandardBRDF.cginc"
        float3 Shade(float3 n, float3 l, float smoothness)
        {
            UnityLight light;
            light.color = float3(1, 0.5, 2);
            light.dir = l;
            light.ndotl = 0;
            UnityIndirect gi;
            gi.diffuse = float3(0.1, 0.2, 0.3);
            gi.specular = float3(0.4, 0.5, 0.6);
            return BRDF3_Unity_PBS(float3(0.7, 0.2, 0.1), float3(0.04, 0.04, 0.04), 0.96, smoothness,
                                   n, float3(0, 0, 1), light, gi).rgb;
        })",
                      ProgramLanguage::Cg);
    auto inputs =
        CombineVectors(UnitVectors(), UnitVectors(), {{0, 0, 0}, {0.5, 0, 0}, {0.7, 0, 0}});
    // The lobe of a fully rough surface jumps from 1 to 0 where the cosine is 0, and what the
    // logarithm of 0 is Vulkan leaves to the driver.
    std::erase_if(inputs,
                  [](const GridInput& i)
                  {
                      const dvec3 mirrored = glm::reflect(dvec3(0, 0, 1), dvec3(i.a));
                      return i.c.x == 0.0 && glm::dot(mirrored, dvec3(i.b)) == 0.0;
                  });
    grid.Add(
        "Shade(a.xyz, b.xyz, c.x)", inputs,
        [](auto& a, auto& b, auto& c)
        {
            const dvec3 n(a), l(b), v(0, 0, 1), diffuse(0.7, 0.2, 0.1);
            const double lobe = Phong(c.x, glm::dot(glm::reflect(v, n), l));
            const double fresnel = std::pow(1 - Saturate(glm::dot(n, v)), 4);
            const double mirrored = glm::mix(0.04, Saturate(c.x + 0.04), fresnel);
            return (diffuse + 0.04 * lobe) * k_LightColor * Saturate(glm::dot(n, l)) +
                   diffuse * dvec3(0.1, 0.2, 0.3) + dvec3(0.4, 0.5, 0.6) * mirrored;
        },
        k_Lobe);
    grid.Run();
}

TEST_F(BuiltinShading, HighlightsCanBeTurnedOff)
{
    for (const char* model : {"BRDF1_Unity_PBS", "BRDF2_Unity_PBS", "BRDF3_Unity_PBS"})
    {
        FunctionGrid grid("#define _SPECULARHIGHLIGHTS_OFF\n#include \"UnityStandardBRDF.cginc\"\n"
                          "float3 Shade(float3 n, float3 l, float3 specular)\n{\n"
                          "    UnityLight light; light.color = 1; light.dir = l; light.ndotl = 0;\n"
                          "    UnityIndirect gi; gi.diffuse = 0; gi.specular = 0;\n    return " +
                              std::string(model) +
                              "(0, specular, 0.5, 0.5, n, float3(0, 0, 1), light, gi).rgb;\n}\n",
                          ProgramLanguage::Cg);
        grid.Add("Shade(a.xyz, b.xyz, 0.5)", CombineVectors(UnitVectors(), UnitVectors()),
                 [](auto&, auto&, auto&) { return dvec3(0); });
        grid.Run();
    }
}

TEST_F(BuiltinShading, StandardSurfacesAreDrawnByEachPass)
{
    FunctionGrid grid(R"(
        #define _GLOSSYREFLECTIONS_OFF
        #define _EMISSION
        #define DIRECTIONAL
        #define UNITY_BRDF_PBS BRDF1_Unity_PBS
        #define UNITY_SETUP_BRDF_INPUT MetallicSetup
        #include "UnityStandardCore.cginc"
        VertexInput At(float3 place, float3 normal)
        {
            VertexInput v = (VertexInput)0;
            v.vertex = float4(place, 1);
            v.normal = normal;
            return v;
        }
        float4 Base(VertexInput v) { return fragForwardBaseInternal(vertForwardBase(v)); }
        float4 Added(VertexInput v) { return fragForwardAddInternal(vertForwardAdd(v)); }
        float4 Stored(VertexInput v, int target)
        {
            half4 t[4];
            fragDeferred(vertDeferred(v), t[0], t[1], t[2], t[3]);
            return t[target];
        })",
                      ProgramLanguage::Cg);
    SetScene(grid);
    SetMaterial(grid);
    const auto inputs = CombineVectors(k_Places, UnitVectors());
    const Shiny s = QuarterMetal();
    const auto lit = [=](const dvec4& a, const dvec4& b)
    {
        return Direct(s, dvec3(b), k_LightDir, glm::normalize(k_Camera - dvec3(a)), k_LightColor);
    };
    const auto unlit = [=](const dvec4& a, const dvec4& b)
    {
        return k_Glow + Mirrored(s, dvec3(b), glm::normalize(k_Camera - dvec3(a)), k_Sky) * 0.5;
    };
    grid.Add(
        "Base(At(a.xyz, b.xyz))", inputs,
        [=](auto& a, auto& b, auto&) { return dvec4(lit(a, b) + unlit(a, b), 1); }, k_Lobe);
    grid.Add(
        "Added(At(a.xyz, b.xyz))", inputs,
        [=](auto& a, auto& b, auto&) { return dvec4(lit(a, b), 1); }, k_Lobe);
    grid.Add("Stored(At(a.xyz, b.xyz), 0)", inputs,
             [=](auto&, auto&, auto&) { return dvec4(s.diffuse, 0.5); });
    grid.Add("Stored(At(a.xyz, b.xyz), 1)", inputs,
             [=](auto&, auto&, auto&) { return dvec4(s.specular, 0.6); });
    grid.Add("Stored(At(a.xyz, b.xyz), 2)", inputs,
             [](auto&, auto& b, auto&) { return dvec4(dvec3(b) * 0.5 + 0.5, 1); });
    grid.Add("Stored(At(a.xyz, b.xyz), 3)", inputs,
             [=](auto& a, auto& b, auto&) { return dvec4(glm::exp2(-unlit(a, b)), 1); },
             {1e-4, 1e-5});
    grid.Run();
}

TEST_F(BuiltinShading, SimpleStandardSurfacesAddALamp)
{
    FunctionGrid grid(R"(
        #define _GLOSSYREFLECTIONS_OFF
        #define DIRECTIONAL
        #define UNITY_SETUP_BRDF_INPUT MetallicSetup
        #include "UnityStandardCoreForwardSimple.cginc"
        float4 Added(float3 place, float3 normal)
        {
            VertexInput v = (VertexInput)0;
            v.vertex = float4(place, 1);
            v.normal = normal;
            return fragForwardAddSimpleInternal(vertForwardAddSimple(v));
        })",
                      ProgramLanguage::Cg);
    SetScene(grid);
    SetMaterial(grid);
    grid.Add(
        "Added(a.xyz, b.xyz)", CombineVectors(k_Places, UnitVectors()),
        [](auto& a, auto& b, auto&)
        {
            const Shiny s = QuarterMetal();
            const dvec3 away = glm::normalize(dvec3(a) - k_Camera);
            const double lobe =
                Phong(s.smoothness, glm::dot(glm::reflect(away, dvec3(b)), k_LightDir));
            const double cosine = Saturate(glm::dot(dvec3(b), k_LightDir));
            return dvec4(k_LightColor * cosine * (s.diffuse + s.specular * lobe), 1);
        },
        k_Lobe);
    grid.Run();
}

TEST_F(BuiltinShading, SurfacesAreStoredForDeferredLight)
{
    for (const bool isMetallic : {true, false})
    {
        const std::string kind = isMetallic ? "" : "Specular";
        FunctionGrid grid(
            "#define UNITY_BRDF_PBS BRDF1_Unity_PBS\n"
            "#include \"UnityPBSLighting.cginc\"\n"
            "float4 Stored(float3 n, int target)\n{\n    SurfaceOutputStandard" +
                kind + " s = (SurfaceOutputStandard" + kind + ")0;\n    " +
                (isMetallic ? "s.Metallic = 0.25;" : "s.Specular = float3(0.2, 0.3, 0.1);") +
                R"(
            s.Albedo = float3(0.8, 0.4, 0.2);
            s.Smoothness = 0.6;
            s.Occlusion = 0.5;
            s.Normal = n;
            s.Emission = float3(0.05, 0.3, 0.15);
            UnityGI gi = (UnityGI)0;
            gi.light.dir = float3(0, 0.6, 0.8);
            gi.light.color = float3(1, 0.5, 2);
            gi.indirect.diffuse = float3(0.4, 0.5, 0.6);
            gi.indirect.specular = float3(0.1, 0.2, 0.3);
            half4 t[4];
            t[3] = LightingStandard)" +
                kind + R"(_Deferred(s, float3(0, 0, 1), gi, t[0], t[1], t[2]);
            return t[target];
        }
        float4 Read(float3 n, bool isFirst)
        {
            UnityStandardData d = UnityStandardDataFromGbuffer(Stored(n, 0), Stored(n, 1),
                                                               Stored(n, 2));
            return isFirst ? float4(d.diffuseColor + d.specularColor, d.occlusion)
                           : float4(d.normalWorld, d.smoothness);
        })",
            ProgramLanguage::Cg);
        const dvec3 specular(0.2, 0.3, 0.1);
        const Shiny s = isMetallic ? QuarterMetal() : Shiny{k_Albedo * 0.7, specular, 0.7, 0.6};
        const auto inputs = CombineVectors(UnitVectors());
        grid.Add("Stored(a.xyz, 0)", inputs,
                 [=](auto&, auto&, auto&) { return dvec4(s.diffuse, 0.5); });
        grid.Add("Stored(a.xyz, 1)", inputs,
                 [=](auto&, auto&, auto&) { return dvec4(s.specular, 0.6); });
        grid.Add("Stored(a.xyz, 2)", inputs,
                 [](auto& a, auto&, auto&) { return dvec4(dvec3(a) * 0.5 + 0.5, 1); });
        grid.Add(
            "Stored(a.xyz, 3)", inputs,
            [=](auto& a, auto&, auto&)
            {
                const dvec3 n(a), v(0, 0, 1);
                const dvec3 around = s.diffuse * dvec3(0.4, 0.5, 0.6) + Mirrored(s, n, v, k_Sky);
                return dvec4(Direct(s, n, k_LightDir, v, k_LightColor) + around + k_Glow, 1);
            },
            k_Lobe);
        grid.Add("Read(a.xyz, true)", inputs,
                 [=](auto&, auto&, auto&) { return dvec4(s.diffuse + s.specular, 0.5); });
        grid.Add("Read(a.xyz, false)", inputs,
                 [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 0.6); });
        grid.Run();
    }
}

TEST_F(BuiltinShading, BakersGetWhatSurfacesScatterAndGive)
{
    for (const bool asksForAlbedo : {true, false})
    {
        FunctionGrid grid(R"(
            #define _EMISSION
            #define UNITY_SETUP_BRDF_INPUT MetallicSetup
            #include "UnityStandardMeta.cginc"
            float4 Baked()
            {
                v2f_meta i = (v2f_meta)0;
                return frag_meta(i);
            })",
                          ProgramLanguage::Cg);
        SetMaterial(grid);
        grid.SetGlobal("unity_MetaFragmentControl",
                       {asksForAlbedo ? 1.0f : 0.0f, asksForAlbedo ? 0.0f : 1.0f, 0, 0});
        grid.SetGlobal("unity_OneOverOutputBoost", {1});
        grid.SetGlobal("unity_MaxOutputValue", {10});
        grid.SetGlobal("unity_UseLinearSpace", {1});
        grid.Add("Baked() + 0 * a", Combine({0.0}),
                 [=](auto&, auto&, auto&)
                 {
                     const Shiny s = QuarterMetal();
                     return dvec4(asksForAlbedo ? s.diffuse + s.specular * (0.4 * 0.4 / 2) : k_Glow,
                                  1);
                 });
        grid.Run();
    }
}

TEST_F(BuiltinShading, NothingShinesBeforeItIsSet)
{
    FunctionGrid grid(R"(
        #include "UnityGlobalIllumination.cginc"
        UnityGI Reset()
        {
            UnityGI gi;
            ResetUnityGI(gi);
            return gi;
        })",
                      ProgramLanguage::Cg);
    const auto once = Combine({0.0});
    grid.Add("float4(Reset().light.color, Reset().light.ndotl) + a.x", once,
             [](auto&, auto&, auto&) { return dvec4(0); });
    grid.Add("Reset().light.dir + a.x", once, [](auto&, auto&, auto&) { return dvec3(0, 1, 0); });
    grid.Add("Reset().indirect.diffuse + Reset().indirect.specular + a.x", once,
             [](auto&, auto&, auto&) { return dvec3(0); });
    grid.Add("float4(UnityGlossyEnvironmentSetup(0.6, b.xyz, a.xyz, 0).reflUVW, "
             "UnityGlossyEnvironmentSetup(0.6, b.xyz, a.xyz, 0).roughness)",
             CombineVectors(UnitVectors(), UnitVectors()),
             [](auto& a, auto& b, auto&) { return dvec4(glm::reflect(-dvec3(b), dvec3(a)), 0.4); });
    grid.Run();
}

TEST_F(BuiltinShading, SpritesAndTheInterfaceAreTinted)
{
    FunctionGrid sprite(R"(
        #define PIXELSNAP_ON
        #include "UnitySprites.cginc"
        v2f At(float3 place, float4 color)
        {
            appdata_t v = (appdata_t)0;
            v.vertex = float4(place, 1);
            v.color = color;
            v.texcoord = float2(0.25, 0.75);
            return SpriteVert(v);
        })",
                        ProgramLanguage::Cg);
    SetScene(sprite);
    sprite.SetGlobal("_ScreenParams", {8, 4, 1.125f, 1.25f});
    sprite.SetGlobal("_Flip", {-1, 1, 0, 0});
    sprite.SetGlobal("_Color", {0.5f, 1, 0.25f, 0.5f});
    sprite.SetGlobal("_RendererColor", {1, 0.5f, 1, 0.5f});
    sprite.SetTexture("_MainTex", OneTexel({0.25f, 0.5f, 1, 0.5f}));
    const auto inputs = CombineVectors({{0, 0, 0.5}, {0.2, -0.4, 0.25}}, Colors());
    const auto snapped = [](double x, double half)
    {
        return std::round(x * half) / half;
    };
    sprite.Add("At(a.xyz, b).vertex", inputs,
               [=](auto& a, auto&, auto&)
               { return dvec4(snapped(-a.x, 4), snapped(a.y, 2), a.z, 1); });
    sprite.Add("At(a.xyz, float4(b.xyz, 1)).color", inputs,
               [](auto&, auto& b, auto&) { return dvec4(b.x * 0.5, b.y * 0.5, b.z * 0.25, 0.25); });
    sprite.Add("At(a.xyz, b).texcoord", inputs,
               [](auto&, auto&, auto&) { return dvec2(0.25, 0.75); });
    sprite.Add("SpriteFrag(At(a.xyz, float4(b.xyz, 1)))", inputs,
               [](auto&, auto& b, auto&)
               {
                   const double alpha = 0.5 * 0.25;
                   return dvec4(dvec3(b) * dvec3(0.125, 0.25, 0.25) * alpha, alpha);
               });
    sprite.Run();

    FunctionGrid ui("#include \"UnityUI.cginc\"\nsampler2D _Picture, _Opacity;\n",
                    ProgramLanguage::Cg);
    ui.SetTexture("_Picture", OneTexel({0.25f, 0.5f, 1, 0.125f}));
    ui.SetTexture("_Opacity", OneTexel({0.375f, 0, 0, 0}));
    ui.Add("UnityGetUIDiffuseColor(a.xy, _Picture, _Opacity, b)",
           CombineVectors(Colors(), Colors()),
           [](auto&, auto& b, auto&) { return dvec4(0.25, 0.5, 1, 0.375) + b; });
    ui.Run();
}

TEST_F(BuiltinShading, HeightsShiftWhatIsSeen)
{
    FunctionGrid grid("#define _PARALLAXMAP\n#include \"UnityStandardInput.cginc\"\n",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_Parallax", {0.08f});
    grid.SetTexture("_ParallaxMap", OneTexel({0, 0.75f, 0, 0}));
    grid.Add("Parallax(float4(a.xy, a.yx), b.xyz)",
             CombineVectors({{0, 0, 0}, {0.25, 2, 0}}, {{0, 0, 1}, {0.6, 0, 0.8}, {2, -3, 6}}),
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 v = glm::normalize(dvec3(b));
                 const dvec2 shift = dvec2(v) * (0.02 / (v.z + 0.42));
                 return dvec4(dvec2(a) + shift, dvec2(a.y, a.x) + shift);
             });
    grid.Run();
}

TEST_F(BuiltinShading, ScreensAndDeferredLightsFindTheirPlace)
{
    FunctionGrid grid(R"(
        #include "UnityCG.cginc"
        #include "UnityDeferredLibrary.cginc"
        v2f_img Image(float3 place, float2 uv)
        {
            appdata_img v = (appdata_img)0;
            v.vertex = float4(place, 1);
            v.texcoord = uv;
            return vert_img(v);
        })",
                      ProgramLanguage::Cg);
    SetScene(grid);
    grid.SetGlobal("_ProjectionParams", {1, 0.5f, 200, 0.005f});
    grid.SetGlobal("_LightAsQuad", {0.25f});
    const auto inputs =
        CombineVectors({{0, 0, 0.5}, {0.25, -0.75, 0.125}}, {{1, 2, 3}, {0, -1, 5}});
    grid.Add("Image(a.xyz, b.xy).pos", inputs,
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 1); });
    grid.Add("Image(a.xyz, b.xy).uv", inputs, [](auto&, auto& b, auto&) { return dvec2(b); });
    grid.Add("vert_deferred(float4(a.xyz, 1), b.xyz).pos", inputs,
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 1); });
    grid.Add("vert_deferred(float4(a.xyz, 1), b.xyz).uv", inputs,
             [](auto& a, auto&, auto&) { return dvec4(a.x / 2 + 0.5, a.y / 2 + 0.5, a.z, 1); });
    grid.Add("vert_deferred(float4(a.xyz, 1), b.xyz).ray", inputs,
             [](auto& a, auto& b, auto&)
             { return glm::mix(dvec3(-a.x, -a.y, a.z), dvec3(b), 0.25); });
    grid.Run();
}

TEST_F(BuiltinShading, ParticlesKeepTheirColorAndPlace)
{
    FunctionGrid grid(R"(
        #include "UnityStandardParticles.cginc"
        VertexOutput At(float3 place, float4 color)
        {
            appdata_particles v = (appdata_particles)0;
            v.vertex = float4(place, 1);
            v.color = color;
            VertexOutput o;
            vertParticleUnlit(v, o);
            return o;
        })",
                      ProgramLanguage::Cg);
    SetScene(grid);
    const auto inputs = CombineVectors(k_Places, Colors());
    grid.Add("At(a.xyz, b).vertex", inputs,
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 1); });
    grid.Add("At(a.xyz, b).color", inputs, [](auto&, auto& b, auto&) { return b; });
    grid.Run();
}

} // namespace limn::test::shading
