#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// What deferred lights and particles of the built-in pipeline come to, against formulas in double.

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using BuiltinEffectValues = GpuTest;

/// The columns 0.2 and 0.8 in every channel.
std::shared_ptr<const Texture2D> RampTexture()
{
    std::vector<std::byte> texels(16, std::byte{51});
    std::fill(texels.begin() + 4, texels.begin() + 8, std::byte{204});
    std::fill(texels.begin() + 12, texels.end(), std::byte{204});
    return std::make_shared<Texture2D>("ramp", 2, 2, GraphicsFormat::R8G8B8A8_UNorm, texels);
}

/// The same, bilinear and repeated.
double Ramp(double u)
{
    const double fromFirst = std::abs(u - 0.25 - std::round(u - 0.25));
    return 0.2 + 1.2 * fromFirst;
}

/// A light at (1, 2, 3) with range 20 on what lies 10 before the camera, which looks along x.
class DeferredLight
{
public:
    explicit DeferredLight(const std::string& keyword)
        : m_Grid("#define " + keyword + R"( 1
            #include "UnityDeferredLibrary.cginc"
            struct Reached { float3 place; float2 uv; half3 direction; float atten; };
            Reached Reach(float3 ray)
            {
                unity_v2f_deferred i;
                i.pos = 0;
                i.uv = float4(1, 3, 0, 4);
                i.ray = ray;
                Reached r;
                float fade;
                UnityDeferredCalculateLightParams(i, r.place, r.uv, r.direction, r.atten, fade);
                return r;
            })",
                 ProgramLanguage::Cg)
    {
        m_Grid.SetGlobal("_ZBufferParams", {3, 1, 0, 0}); // the depth texture's 1 is a quarter
        m_Grid.SetGlobal("_ProjectionParams", {1, 0.5f, 40, 0.025f});
        m_Grid.SetGlobal("unity_CameraToWorld", {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1});
        m_Grid.SetGlobal("_LightPos", {1, 2, 3, 1.0f / 400});
        m_Grid.SetGlobal("_LightDir", {0, -0.6f, 0.8f, 0});
        m_Grid.SetGlobal("unity_WorldToLight", {0, 0, 0, 0, 0.02f, 0, 0, 0, 0.05f, 0.05f, 0, 0.1f,
                                                -0.375f, -0.375f, 0, -0.75f});
        m_Grid.SetTexture("_LightTexture0", RampTexture());
        m_Grid.SetTexture("_LightTextureB0", RampTexture());
    }

    using Function = std::function<double(dvec3 place)>;

    /// @param hasPlace  the light comes from (1, 2, 3), not from a direction
    void Expect(bool hasPlace, const Function& attenuation)
    {
        const std::vector<GridInput> rays =
            CombineVectors({{0, 0, 1}, {1, 0, 2}, {-1, 0.5, 1}, {0.25, -1, 2}});
        const auto place = [](const dvec4& ray)
        {
            const dvec3 seen = dvec3(ray) * (10.0 / ray.z);
            return dvec3(1 + seen.z, 2 + seen.y, 3 - seen.x);
        };
        m_Grid.Add("Reach(a.xyz).place", rays, [=](auto& a, auto&, auto&) { return place(a); });
        m_Grid.Add("Reach(a.xyz).uv", rays, [](auto&, auto&, auto&) { return dvec2(0.25, 0.75); });
        m_Grid.Add("Reach(a.xyz).direction", rays,
                   [=](auto& a, auto&, auto&) {
                       return hasPlace ? glm::normalize(dvec3(1, 2, 3) - place(a))
                                       : dvec3(0, 0.6, -0.8);
                   });
        m_Grid.Add("Reach(a.xyz).atten", rays,
                   [=](auto& a, auto&, auto&) { return attenuation(place(a)); },
                   {1e-5, 5e-3}); // devices place texels by 8 bits
        m_Grid.Run();
    }

private:
    FunctionGrid m_Grid;
};

/// By the square of the distance over that of the range.
double Falloff(dvec3 place)
{
    const dvec3 way = dvec3(1, 2, 3) - place;
    return Ramp(glm::dot(way, way) / 400);
}

TEST_F(BuiltinEffectValues, DeferredLightsReachAPlaceFromWhereTheyAre)
{
    DeferredLight("DIRECTIONAL").Expect(false, [](dvec3) { return 1.0; });
    DeferredLight("POINT").Expect(true, Falloff);
    DeferredLight("DIRECTIONAL_COOKIE")
        .Expect(false, [](dvec3 at) { return Ramp(0.02 * at.y + 0.05 * at.z - 0.375); });
    DeferredLight("SPOT").Expect(true,
                                 [](dvec3 at)
                                 {
                                     const double w = 0.1 * at.z - 0.75; // ahead where negative
                                     const double u = (0.02 * at.y + 0.05 * at.z - 0.375) / w;
                                     return w < 0 ? Falloff(at) * Ramp(u) : 0.0;
                                 });
}

/// The colour of a particle of (0.5, 0.8, 0.25, 0.5) in white, multiplied by the vertex's.
void ExpectParticle(const std::vector<std::string>& keywords,
                    const std::function<dvec4(const dvec4& albedo)>& result)
{
    std::string defines;
    for (const std::string& keyword : keywords)
    {
        defines += "#define " + keyword + " 1\n";
    }
    FunctionGrid grid(defines + R"(
        #include "UnityStandardParticles.cginc"
        float4 Draw(float4 color)
        {
            VertexOutput i = (VertexOutput)0;
            i.color = color;
            i.texcoord = float2(0.25, 0.5);
        #ifdef _FLIPBOOK_BLENDING
            i.texcoord2AndBlend = float3(0.75, 0.5, 0.25);
        #endif
        #ifdef FOG_EXP2
            i.fogCoord = 0.475; // 10 away
        #endif
        #ifdef _DISTORTION_ON
            i.grabPassPosition = float4(1.5, 1, 0, 2);
        #endif
            return fragParticleUnlit(i);
        })",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_Color", {0.5f, 0.8f, 0.25f, 0.5f});
    grid.SetGlobal("_EmissionColor", {0.1f, 0.2f, 0.3f});
    grid.SetGlobal("_Cutoff", {0.3f});
    grid.SetGlobal("_ProjectionParams", {1, 0.5f, 200, 0.005f});
    grid.SetGlobal("unity_FogParams", {static_cast<float>(0.05 / std::sqrt(std::log(2.0)))});
    grid.SetGlobal("_DistortionBlend", {0.125f});
    grid.SetTexture("_GrabTexture", RampTexture());
    if (std::ranges::count(keywords, "_REQUIRE_UV2") != 0)
    {
        grid.SetTexture("_MainTex", RampTexture());
    }
    grid.Add("Draw(a)", {{{1, 1, 1, 1}}, {{0.5, 0.25, 2, 0.5}}, {{0.2, 1, 0.6, 0.8}}},
             [&](auto& a, auto&, auto&) { return result(a * dvec4(0.5, 0.8, 0.25, 0.5)); },
             {2e-5, 5e-3});
    SCOPED_TRACE(defines);
    grid.Run();
}

TEST_F(BuiltinEffectValues, ParticlesAreDrawnAsTheKeywordSays)
{
    const auto opaque = [](dvec3 color)
    {
        return dvec4(color, 1);
    };
    ExpectParticle({}, [=](const dvec4& albedo) { return opaque(dvec3(albedo)); });
    for (const char* blended : {"_ALPHABLEND_ON", "_ALPHAPREMULTIPLY_ON"})
    {
        ExpectParticle({blended}, [](const dvec4& albedo) { return albedo; });
    }
    ExpectParticle({"_ALPHAMODULATE_ON"}, [=](const dvec4& albedo)
                   { return opaque(glm::mix(dvec3(1), dvec3(albedo), albedo.w)); });
    ExpectParticle({"_EMISSION", "_ALPHABLEND_ON"},
                   [](const dvec4& albedo) { return albedo + dvec4(0.1, 0.2, 0.3, 0); });
    ExpectParticle({"_ALPHATEST_ON", "_ALPHABLEND_ON"}, [](const dvec4& albedo)
                   { return albedo.w < 0.3 ? dvec4(0, 0, 0, 1) : albedo; }); // the clear colour
    ExpectParticle({"FOG_EXP2"},
                   [=](const dvec4& albedo) { return opaque(dvec3(albedo) * std::exp(-0.25)); });
    // Two frames, 0.2 and 0.8, mixed by a quarter.
    ExpectParticle({"_REQUIRE_UV2", "_ALPHABLEND_ON"},
                   [](const dvec4& albedo) { return albedo * 0.35; });
    // What is behind is 0.8 there.
    ExpectParticle({"EFFECT_BUMP"}, [=](const dvec4& albedo)
                   { return opaque(glm::mix(dvec3(0.8), dvec3(albedo), albedo.w - 0.125)); });
}

} // namespace
} // namespace limn::test
