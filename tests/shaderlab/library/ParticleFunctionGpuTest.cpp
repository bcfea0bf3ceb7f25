#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vulkan/GpuTestDevice.h>

// What particles, grass and trees call, against formulas written out here.

namespace limn::test
{

namespace
{

using ParticleFunctions = GpuTest;

const std::string k_Particles =
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl\"\n";

std::vector<GridInput> Mixed()
{
    return {{{0.2, 0.6, 0.9, 0.5}, {0.7, 0.3, 0.1, 0.8}, {}},
            {{0.5, 0.4, 0.1, 1.0}, {0.0, 1.0, 0.6, 0.25}, {}}};
}

/// The colour mode that a keyword stands for; c is _BaseColorAddSubDiff.
void ExpectMix(const std::string& keyword, const std::string& addSubDiff, const Oracle& oracle)
{
    FunctionGrid grid("#define " + keyword + "\n" + k_Particles);
    grid.Add("MixParticleColor(a, b, " + addSubDiff + ")", Mixed(), oracle);
    grid.Run();
}

/// _ZBufferParams of a camera from 0.5 to 50.
const std::vector<float> k_ZBufferParams = {99.0f, 1.0f, 1.98f, 0.02f};

double EyeDepth(double depth)
{
    return 1.0 / (static_cast<double>(1.98f) * depth + static_cast<double>(0.02f));
}

} // namespace

TEST_F(ParticleFunctions, MixColorsByMode)
{
    ExpectMix("NO_MODE", "0", [](auto& a, auto& b, auto&) { return a * b; });
    ExpectMix("_COLOROVERLAY_ON", "0",
              [](auto& a, auto& b, auto&)
              {
                  glm::dvec4 result(0, 0, 0, a.w * b.w);
                  for (int i = 0; i < 3; ++i)
                  {
                      result[i] = a[i] <= 0.5 ? 2 * a[i] * b[i] : 1 - 2 * (1 - a[i]) * (1 - b[i]);
                  }
                  return result;
              });
    ExpectMix("_COLORADDSUBDIFF_ON", "float4(-1, 1, 0, 0)",
              [](auto& a, auto& b, auto&)
              { return glm::dvec4(glm::abs(glm::dvec3(a) - glm::dvec3(b)), a.w * b.w); });
    ExpectMix("_COLORADDSUBDIFF_ON", "float4(1, 0, 0, 0)",
              [](auto& a, auto& b, auto&)
              { return glm::dvec4(glm::dvec3(a) + glm::dvec3(b), a.w * b.w); });
    // The particle's hue and saturation, the texture's value: the largest channel.
    ExpectMix("_COLORCOLOR_ON", "0",
              [](auto& a, auto& b, auto&)
              {
                  const double value = std::max({a.x, a.y, a.z});
                  const glm::dvec3 color = glm::dvec3(b) / std::max({b.x, b.y, b.z}) * value;
                  return glm::dvec4(color, a.w * b.w);
              });
}

TEST_F(ParticleFunctions, FadeByDepth)
{
    FunctionGrid grid(k_Particles + R"(
        float Soft(float near, float far, float3 positionWS)
        {
            ParticleParams p = (ParticleParams)0;
            p.positionWS = float4(positionWS, 1);
            p.projectedPosition = float4(1, 1, 0, 2);
            return SoftParticles(near, far, p);
        })");
    grid.SetGlobal("_ZBufferParams", k_ZBufferParams);
    grid.SetGlobal("unity_MatrixV", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1});
    // The depth texture is 1, which is the near plane: what the scene holds is 0.5 away.
    const auto inputs = CombineVectors({{0, 0, 0}, {0.1, 0.4, 0}, {0, 20, 0}, {0.2, 1.5, 0}},
                                       {{0.3, 0, 0}, {0.9, 0, 0}, {0.99, 0, 0}});
    // projection: z/w is the particle's depth
    grid.Add("SoftParticles(a.x, a.y, float4(1, 1, b.x * 2, 2))", inputs,
             [](auto& a, auto& b, auto&)
             { return a.x > 0 || a.y > 0 ? Saturate(a.y * (0.5 - a.x - EyeDepth(b.x))) : 1.0; });
    grid.Add("SoftParticles(a.x, a.y, float4(1, 1, 6, 2)) + 1", Combine({0.0}, {0.0}),
             [](auto&, auto&, auto&) { return 2.0; });
    grid.Add("Soft(a.x, a.y, float3(3, 4, b.x))", inputs,
             [](auto& a, auto& b, auto&)
             { return a.x > 0 || a.y > 0 ? Saturate(a.y * (0.5 - a.x - b.x)) : 1.0; });
    grid.Add("CameraFade(a.x, a.y, float4(0, 0, b.x * 2, 2))", inputs,
             [](auto& a, auto& b, auto&) { return Saturate((EyeDepth(b.x) - a.x) * a.y); });
    grid.Run();
}

TEST_F(ParticleFunctions, BlendFramesAndColors)
{
    const std::string helper = R"(
        struct VaryingsParticle
        {
            float2 texcoord; float3 texcoord2AndBlend; float4 color; float4 positionWS;
            float4 projectedPosition;
        };
        float4 _BaseColor;
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl"
        float2 First(float4 t) { float2 u; float3 v; GetParticleTexcoords(u, v, t, 0.75); return u; }
        float3 Next(float4 t) { float2 u; float3 v; GetParticleTexcoords(u, v, t, 0.75); return v; }
        float4 Params(float4 t)
        {
            VaryingsParticle i = (VaryingsParticle)0;
            i.texcoord = t.xy; i.texcoord2AndBlend = t.zwx; i.projectedPosition = t;
            ParticleParams p;
            InitParticleParams(i, p);
            return p.blendUv.xyzx + p.uv.xyxy * 10 + p.projectedPosition * 100 + p.baseColor;
        })";
    FunctionGrid on("#define _FLIPBOOKBLENDING_ON\n#define _SOFTPARTICLES_ON\n"
                    "#define _ALPHAPREMULTIPLY_ON\n" +
                    helper);
    FunctionGrid off("#define _ALPHAMODULATE_ON\n" + helper);
    const auto inputs = Mixed();
    on.SetGlobal("_BaseColor", {1, 2, 3, 4});
    off.SetGlobal("_BaseColor", {1, 2, 3, 4});
    for (FunctionGrid* grid : {&on, &off})
    {
        grid->Add("First(a)", inputs, [](auto& a, auto&, auto&) { return glm::dvec2(a); });
    }
    on.Add("Next(a)", inputs, [](auto& a, auto&, auto&) { return glm::dvec3(a.z, a.w, 0.75); });
    off.Add("Next(a)", inputs, [](auto& a, auto&, auto&) { return glm::dvec3(a.x, a.y, 0.5); });
    on.Add("Params(a)", inputs,
           [](auto& a, auto&, auto&)
           {
               return glm::dvec4(a.z, a.w, a.x, a.z) + glm::dvec4(a.x, a.y, a.x, a.y) * 10.0 +
                      a * 100.0 + glm::dvec4(1, 2, 3, 4);
           });
    off.Add("Params(a)", inputs,
            [](auto& a, auto&, auto&)
            { return glm::dvec4(a.x, a.y, a.x, a.y) * 10.0 + glm::dvec4(1, 2, 3, 4); });
    on.Add("AlphaModulateAndPremultiply(a.xyz, a.w)", inputs,
           [](auto& a, auto&, auto&) { return glm::dvec3(a) * a.w; });
    off.Add("AlphaModulateAndPremultiply(a.xyz, a.w)", inputs,
            [](auto& a, auto&, auto&) { return 1.0 + (glm::dvec3(a) - 1.0) * a.w; });
    on.Add("SOFT_PARTICLE_MUL_ALBEDO(a, b.x)", inputs,
           [](auto& a, auto& b, auto&) { return a * b.x; });
    off.Add("SOFT_PARTICLE_MUL_ALBEDO(a, b.x)", inputs,
            [](auto& a, auto& b, auto&)
            {
                const double alpha = a.w * b.x;
                return glm::dvec4(1.0 + (glm::dvec3(a) - 1.0) * alpha, alpha);
            });
    // What lies behind is white.
    on.Add("Distortion(a, float3(0.1, 0.2, 1), 0.5, 0.25, float4(1, 1, 0, 2))", inputs,
           [](auto& a, auto&, auto&)
           { return 1.0 + (glm::dvec3(a) - 1.0) * Saturate(a.w - 0.25); });
    on.Run();
    off.Run();
}

namespace
{

const std::string k_Terrain = "#include \"TerrainEngine.cginc\"\n";

const double k_Wave[] = {0.35, 0.8, 0.5, 40.0}; // _WaveAndDistance
const glm::dvec3 k_Camera(1.0, 2.0, -3.0);

/// Sines of four waves at a place, to the fourth power; the series' own error is far below 1 %.
glm::dvec4 Waves(const glm::dvec4& p)
{
    const double sizeX[] = {0.012, 0.02, 0.06, 0.024};
    const double sizeZ[] = {0.006, 0.02, 0.02, 0.05};
    const double speed[] = {0.3 * 4, 0.5 * 4, 0.4 * 4, 1.2 * 4};
    glm::dvec4 result;
    for (int i = 0; i < 4; ++i)
    {
        const double wave = (p.x * sizeX[i] + p.z * sizeZ[i]) * k_Wave[1] + k_Wave[0] * speed[i];
        const double x = (wave - std::floor(wave)) * 6.408849 - 3.1415927;
        const double s =
            x - x * x * x * 0.16161616 + std::pow(x, 5) * 0.0083333 - std::pow(x, 7) * 0.00019841;
        result[i] = s * s * s * s;
    }
    return result;
}

void SetTerrain(FunctionGrid& grid)
{
    grid.SetGlobal("_WaveAndDistance", {0.35f, 0.8f, 0.5f, 40.0f});
    grid.SetGlobal("_CameraPosition", {1, 2, -3, 0.025f});
    grid.SetGlobal("_CameraRight", {0, 0, 1});
    grid.SetGlobal("_CameraUp", {0, 1, 0});
    grid.SetGlobal("_WavingTint", {0.9f, 0.6f, 0.1f, 0});
    grid.SetGlobal("_Wind", {0.3f, 0.1f, -0.2f, 0.7f});
    grid.SetGlobal("_Time", {0.1f, 2.0f, 4.0f, 6.0f});
    grid.SetGlobal("_TreeInstanceScale", {2, 3, 0.5f, 1});
    grid.SetGlobal("_SquashPlaneNormal", {0, 0.6f, 0.8f, -1});
    grid.SetGlobal("_SquashAmount", {0.25f});
}

std::vector<GridInput> Places()
{
    return CombineVectors({{0, 0, 0}, {3, 1, -4}, {-20, 0.5, 7}}, {{0.2, 0.5, 0.8}});
}

} // namespace

TEST_F(ParticleFunctions, FarTreesAreSquashedTowardsAPlane)
{
    FunctionGrid grid(k_Terrain + R"(
        float4 Flat(float3 p) { return Squash(float4(p, 2)); }
        float4 Stiff(float3 p) { float4 v = float4(p, 1); TerrainAnimateTree(v, 0.0); return v; })",
                      ProgramLanguage::Cg);
    SetTerrain(grid);
    // A quarter of the distance to the plane is left.
    const auto flat = [](const glm::dvec3& p)
    {
        const glm::dvec3 normal(0, 0.6, 0.8);
        const double distance = glm::dot(normal, p) - 1.0;
        return glm::dvec4(p - normal * distance * 0.75, 1.0);
    };
    grid.Add("Flat(a.xyz)", Places(), [=](auto& a, auto&, auto&) { return flat(a); }, {1e-5, 1e-5});
    grid.Add("Stiff(a.xyz)", Places(),
             [=](auto& a, auto&, auto&) { return flat(glm::dvec3(a) * glm::dvec3(2, 3, 0.5)); },
             {1e-5, 1e-5});
    grid.Run();
}

TEST_F(ParticleFunctions, GrassWavesOverTheTerrain)
{
    FunctionGrid grid(k_Terrain + R"(
        float3 Moved(float3 p) { float4 v = float4(p, 1); TerrainWaveGrass(v, 0.6, 1); return v.xyz; }
        float4 Color(float3 p, float3 c) { float4 v = float4(p, 1); return TerrainWaveGrass(v, 0.6, float4(c, 1)); }
        float3 Spread(float3 p, float2 o) { float4 v = float4(p, 1); TerrainBillboardGrass(v, o); return v.xyz; })",
                      ProgramLanguage::Cg);
    SetTerrain(grid);
    const auto moved = [](const glm::dvec4& p)
    {
        const glm::dvec4 s = Waves(p) * 0.6;
        return glm::dvec3(p.x - glm::dot(s, glm::dvec4(0.024, 0.04, -0.12, 0.096)) * k_Wave[2], p.y,
                          p.z - glm::dot(s, glm::dvec4(0.006, 0.02, -0.02, 0.1)) * k_Wave[2]);
    };
    grid.Add("Moved(a.xyz)", Places(), [=](auto& a, auto&, auto&) { return moved(a); },
             {1e-4, 1e-5});
    grid.Add("Color(a.xyz, b.xyz)", Places(),
             [=](auto& a, auto& b, auto&)
             {
                 const glm::dvec4 toward = glm::normalize(glm::dvec4(1, 1, 0.4, 0.2));
                 const double light = glm::dot(Waves(a), toward) * 0.7;
                 const glm::dvec3 tint =
                     glm::mix(glm::dvec3(0.5), glm::dvec3(0.9, 0.6, 0.1), light) * 2.0;
                 const glm::dvec3 away = moved(a) - k_Camera;
                 return glm::dvec4(tint * glm::dvec3(b),
                                   Saturate(2 * (k_Wave[3] - glm::dot(away, away)) * 0.025));
             },
             {1e-4, 1e-4});
    // The third place is too far away.
    grid.Add("Spread(a.xyz, b.xy)", Places(),
             [](auto& a, auto& b, auto&)
             { return a.x < -10 ? glm::dvec3(a) : glm::dvec3(a) + glm::dvec3(0, b.y, b.x); });
    grid.Run();
}

TEST_F(ParticleFunctions, TreesBendInTheWind)
{
    FunctionGrid grid(k_Terrain, ProgramLanguage::Cg);
    SetTerrain(grid);
    const float object[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.25f, 0.5f, -0.125f, 1};
    std::copy(std::begin(object), std::end(object), grid.perDraw.objectToWorld);
    const auto wave = [](double x)
    {
        const double y = x - std::floor(x); // frac
        const double z = y * 2 - 1 + 0.5;
        const double t = std::abs((z - std::floor(z)) * 2 - 1);
        return t * t * (3 - 2 * t);
    };
    grid.Add("AnimateVertex(float4(a.xyz, 1), b.xyz, float4(0.1, 0.4, 0.25, 0.5)).xyz", Places(),
             [=](auto& a, auto& b, auto&)
             {
                 const double branch = 0.625 + 0.1;
                 const double vertex = (a.x + a.y + a.z) * (0.4 + branch);
                 const double edges = wave((2 + vertex) * 1.975) + wave((2 + vertex) * 0.793);
                 const double bending = wave((2 + branch) * 0.375) + wave((2 + branch) * 0.193);
                 const glm::dvec3 wind(0.3, 0.1, -0.2);
                 const glm::dvec3 flutter(edges * 0.04 * b.x, bending * 0.15, edges * 0.04 * b.z);
                 return glm::dvec3(a) + (flutter + wind * bending * 0.5) * 0.7 + wind * 0.25;
             },
             {1e-4, 1e-4});
    grid.Add("SmoothTriangleWave(a)", Combine({-0.75, 0.0, 0.1, 0.5, 1.3}),
             [](auto& a, auto&, auto&)
             {
                 const auto smooth = [](double x)
                 {
                     const double y = x + 0.5 - std::floor(x + 0.5);
                     const double t = std::abs(y * 2 - 1);
                     return t * t * (3 - 2 * t);
                 };
                 return glm::dvec4(smooth(a.x), smooth(0), smooth(0), smooth(0));
             });
    grid.Run();
}

} // namespace limn::test
