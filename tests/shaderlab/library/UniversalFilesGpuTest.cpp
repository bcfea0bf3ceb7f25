#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// URP's particles, sprites and shadow fade, against what their materials promise.

namespace limn::test
{
namespace
{

using glm::dvec3;
using glm::dvec4;

using UniversalFileFunctions = GpuTest;

std::string UrpFile(const std::string& name)
{
    return "#include \"Packages/com.unity.render-pipelines.universal/" + name + ".hlsl\"\n";
}

/// A particle in a white texture, at a distance of 4 from the camera.
const std::string k_Particle = R"(
    float4 Albedo(float4 color, float4 particle)
    {
        ParticleParams params = (ParticleParams)0;
        params.baseColor = color;
        params.vertexColor = particle;
        return SampleAlbedo(TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap), params);
    }
    float4 AlbedoAt(float4 color, float4 particle, float4 projected)
    {
        return SampleAlbedo(float2(0, 0), float3(0, 0, 0), color, particle, projected,
                            TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap));
    })";

std::vector<GridInput> Tints()
{
    std::vector<GridInput> inputs;
    for (const dvec4& color : {dvec4(0.2, 0.5, 0.9, 1.0), dvec4(1.5, 0.1, 0.4, 0.25)})
    {
        for (const dvec4& particle : {dvec4(1, 1, 1, 1), dvec4(0.3, 0.8, 0.5, 0.5)})
        {
            inputs.push_back({color, particle, dvec4(0, 0, 0.5, 1)});
        }
    }
    return inputs;
}

TEST_F(UniversalFileFunctions, ParticlesAreTintedByTheWayTheyBlend)
{
    FunctionGrid unlit("#define _ALPHAPREMULTIPLY_ON\n" +
                       UrpFile("Shaders/Particles/ParticlesUnlitInput") + k_Particle);
    unlit.Add("Albedo(a, b)", Tints(),
              [](auto& a, auto& b, auto&)
              {
                  const dvec4 color = a * b;
                  return dvec4(dvec3(color) * color.w, color.w);
              });
    unlit.Run();
    FunctionGrid modulated("#define _ALPHAMODULATE_ON\n" +
                           UrpFile("Shaders/Particles/ParticlesUnlitInput") + k_Particle);
    modulated.Add("Albedo(a, b)", Tints(),
                  [](auto& a, auto& b, auto&)
                  {
                      const dvec4 color = a * b;
                      return dvec4(glm::mix(dvec3(1), dvec3(color), color.w), color.w);
                  });
    modulated.Run();
    // The lighting multiplies by alpha later, and does so here where it adds.
    FunctionGrid lit("#define _ALPHAPREMULTIPLY_ON\n#define _COLORADDSUBDIFF_ON\n" +
                     UrpFile("Shaders/Particles/ParticlesLitInput") + k_Particle);
    lit.SetGlobal("_BaseColorAddSubDiff", {-1, 1, 0, 0});
    lit.Add("Albedo(a, b)", Tints(),
            [](auto& a, auto& b, auto&)
            { return dvec4(glm::abs(dvec3(a) - dvec3(b)), a.w * b.w); });
    lit.Run();
}

TEST_F(UniversalFileFunctions, ParticlesFadeNearTheCamera)
{
    FunctionGrid grid("#define _FADING_ON\n" + UrpFile("Shaders/Particles/ParticlesLitInput") +
                      k_Particle);
    grid.SetGlobal("_ZBufferParams", {3, 1, 0.3f, 0.1f}); // 1 / (0.3 z + 0.1)
    grid.SetGlobal("_CameraFadeParams", {1, 0.125f, 0, 0});
    grid.Add("AlbedoAt(a, b, c)", Tints(),
             [](auto& a, auto& b, auto& c)
             {
                 const double distance = 1 / (0.3 * c.z / c.w + 0.1);
                 const dvec4 color = a * b;
                 return dvec4(dvec3(color), color.w * Saturate((distance - 1) * 0.125));
             });
    grid.Run();
}

TEST_F(UniversalFileFunctions, SpritesAreFlippedAndTheirNormalsStored)
{
    FunctionGrid grid(UrpFile("ShaderLibrary/Core") +
                      UrpFile("Shaders/2D/Include/NormalsRenderingShared") +
                      UrpFile("Shaders/2D/Include/CombinedShapeLightShared"));
    const auto inputs = CombineVectors({{1, 2, 3}, {-0.5, 0.25, 4}});
    grid.Add("UnityFlipSprite(a.xyz, float2(-1, 1))", inputs,
             [](auto& a, auto&, auto&) { return dvec3(-a.x, a.y, a.z); });
    grid.Add("UnityFlipSprite(a.xyz, unity_SpriteProps.xy)", inputs,
             [](auto& a, auto&, auto&) { return dvec3(a); });
    // The tangent is the world's z, the bitangent its x, the normal its y.
    grid.Add("NormalsRenderingShared(float4(0, 0, 0, 0.25), a.xyz, float3(0, 0, 1), "
             "float3(1, 0, 0), float3(0, 1, 0))",
             CombineVectors({{0, 0, 1}, {0.6, 0, 0.8}, {0, -0.6, 0.8}}),
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a.y, a.z, a.x) * 0.5 + 0.5, 0.25); });
    grid.Add("CombinedShapeLightShared(float4(a.xyz, 0.5), 1, float2(0, 0))", inputs,
             [](auto& a, auto&, auto&) { return dvec4(glm::max(dvec3(a), 0.0), 0.5); });
    grid.Run();
}

TEST_F(UniversalFileFunctions, ShadowsFadeWithTheSquaredDistance)
{
    FunctionGrid grid(UrpFile("ShaderLibrary/Shadows"));
    grid.SetGlobal("_MainLightShadowParams", {1, 0, 0.02f, -0.5f});
    grid.SetGlobal("_WorldSpaceCameraPos", {1, 2, 3, 0});
    grid.Add("GetShadowFade(a.xyz)", CombineVectors({{1, 2, 3}, {1, 8, 3}, {7, 2, 6}, {30, 0, 0}}),
             [](auto& a, auto&, auto&)
             {
                 const dvec3 away = dvec3(a) - dvec3(1, 2, 3);
                 return Saturate(glm::dot(away, away) * 0.02 - 0.5);
             });
    grid.Run();
}

} // namespace
} // namespace limn::test
