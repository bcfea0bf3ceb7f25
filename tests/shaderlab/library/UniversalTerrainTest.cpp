#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

// URP's terrain and its grass: every pass compiles, plain and with its keywords.

namespace limn
{
namespace
{

using test::CompileEntries;

std::string Terrain(const std::string& file)
{
    return "#include \"Packages/com.unity.render-pipelines.universal/Shaders/Terrain/" + file +
           ".hlsl\"\n";
}

struct Pass
{
    const char* before;
    const char* vertex;
    const char* fragment;
};

TEST(UniversalFiles, DrawTerrainsInEachOfTheirPasses)
{
    const Pass passes[] = {
        {"", "SplatmapVert", "SplatmapFragment"},
        {"#define TERRAIN_SPLAT_ADDPASS\n", "SplatmapVert", "SplatmapFragment"},
        {"#define TERRAIN_SPLAT_BASEPASS\n", "SplatmapVert", "SplatmapFragment"},
        {"#define TERRAIN_GBUFFER 1\n", "SplatmapVert", "SplatmapFragment"},
        {"", "ShadowPassVertex", "ShadowPassFragment"},
        {"#define SCENESELECTIONPASS\n", "DepthOnlyVertex", "DepthOnlyFragment"},
    };
    const std::vector<std::string> keywords = {"_NORMALMAP",
                                               "_MASKMAP",
                                               "_ALPHATEST_ON",
                                               "_TERRAIN_BLEND_HEIGHT",
                                               "FOG_EXP2",
                                               "_MAIN_LIGHT_SHADOWS",
                                               "_ADDITIONAL_LIGHTS_VERTEX"};
    for (const Pass& pass : passes)
    {
        SCOPED_TRACE(pass.before + std::string(pass.vertex));
        const std::string text =
            pass.before + Terrain("TerrainLitInput") + Terrain("TerrainLitPasses");
        CompileEntries(text, pass.vertex, pass.fragment, {}, ProgramLanguage::Hlsl);
        CompileEntries(text, pass.vertex, pass.fragment, keywords, ProgramLanguage::Hlsl);
    }
    const std::string normals = Terrain("TerrainLitInput") + Terrain("TerrainLitDepthNormalsPass");
    for (const auto& variant : {std::vector<std::string>{}, keywords})
    {
        CompileEntries(normals, "DepthNormalOnlyVertex", "DepthNormalOnlyFragment", variant,
                       ProgramLanguage::Hlsl);
    }
}

TEST(UniversalFiles, DrawGrassInEachOfItsPasses)
{
    const Pass passes[] = {
        {"", "WavingGrassVert", "LitPassFragmentGrass"},
        {"#define TERRAIN_GBUFFER\n", "WavingGrassBillboardVert", "LitPassFragmentGrass"},
        {"", "DepthOnlyVertex", "DepthOnlyFragment"},
        {"", "DepthNormalOnlyVertex", "DepthNormalOnlyFragment"},
        {"", "DepthNormalOnlyBillboardVertex", "DepthNormalOnlyFragment"},
    };
    for (const Pass& pass : passes)
    {
        SCOPED_TRACE(pass.before + std::string(pass.vertex));
        const std::string text = pass.before + Terrain("WavingGrassInput") +
                                 Terrain("WavingGrassPasses") +
                                 Terrain("WavingGrassDepthNormalsPass");
        CompileEntries(text, pass.vertex, pass.fragment, {}, ProgramLanguage::Hlsl);
        CompileEntries(text, pass.vertex, pass.fragment,
                       {"_ALPHATEST_ON", "_MAIN_LIGHT_SHADOWS", "FOG_LINEAR"},
                       ProgramLanguage::Hlsl);
    }
}

} // namespace
} // namespace limn
