#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>
#include <span>

// URP's terrain, its grass and its trees: every pass compiles, plain and with its keywords.

namespace limn
{
namespace
{

using test::CompileEntries;
using test::k_Tree8Variants;

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
    const std::string baked = Terrain("TerrainLitInput") + Terrain("TerrainLitMetaPass");
    for (const auto& variant : {std::vector<std::string>{}, keywords})
    {
        CompileEntries(baked, "TerrainVertexMeta", "TerrainFragmentMeta", variant,
                       ProgramLanguage::Hlsl);
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

std::string UrpTree(const std::string& file)
{
    return "#include \"Packages/com.unity.render-pipelines.universal/Shaders/Nature/" + file +
           ".hlsl\"\n";
}

struct TreePass
{
    const char* define;
    const char* vertex;
    const char* fragment;
};

TEST(UniversalFiles, DrawSpeedTree8InEachOfItsPasses)
{
    const TreePass passes[] = {
        {"#define EFFECT_BACKSIDE_NORMALS\n", "SpeedTree8Vert", "SpeedTree8Frag"},
        {"#define GBUFFER\n", "SpeedTree8Vert", "SpeedTree8Frag"},
        {"#define SHADOW_CASTER\n", "SpeedTree8VertDepth", "SpeedTree8FragDepth"},
        {"#define SCENESELECTIONPASS\n", "SpeedTree8VertDepth", "SpeedTree8FragDepth"},
        {"", "SpeedTree8VertDepthNormal", "SpeedTree8FragDepthNormal"},
    };
    for (const TreePass& pass : passes)
    {
        // The lit pass with all, the others with those that change them.
        const bool isLit = pass.fragment == std::string("SpeedTree8Frag");
        for (const auto& keywords : std::span(k_Tree8Variants).first(isLit ? 6 : 2))
        {
            SCOPED_TRACE(pass.define + testing::PrintToString(keywords));
            CompileEntries("#define ENABLE_WIND\n" + std::string(pass.define) +
                               UrpTree("SpeedTree8Input") + UrpTree("SpeedTree8Passes"),
                           pass.vertex, pass.fragment, keywords, ProgramLanguage::Hlsl);
        }
    }
}

TEST(UniversalFiles, DrawSpeedTree7AndItsBillboardsInEachOfTheirPasses)
{
    const TreePass passes[] = {
        {"#define VERTEX_COLOR\n", "SpeedTree7Vert", "SpeedTree7Frag"},
        {"#define GBUFFER\n", "SpeedTree7Vert", "SpeedTree7Frag"},
        {"#define SHADOW_CASTER\n", "SpeedTree7VertDepth", "SpeedTree7FragDepth"},
        {"#define SCENESELECTIONPASS\n", "SpeedTree7VertDepth", "SpeedTree7FragDepth"},
        {"", "SpeedTree7VertDepthNormal", "SpeedTree7FragDepthNormal"},
    };
    const std::vector<std::string> bumped = {"EFFECT_BUMP", "EFFECT_HUE_VARIATION",
                                             "_MAIN_LIGHT_SHADOWS", "LOD_FADE_CROSSFADE"};
    for (const char* geometry : {"BRANCH", "BRANCH_DETAIL", "FROND", "LEAF", "MESH"})
    {
        SCOPED_TRACE(geometry);
        // The other passes have the same vertices, and fragments that details tell apart.
        const bool isDetailed = geometry == std::string("BRANCH_DETAIL");
        for (const TreePass& pass : std::span(passes).first(isDetailed ? std::size(passes) : 1))
        {
            SCOPED_TRACE(pass.define);
            const std::string text = std::string("#define ENABLE_WIND\n#define GEOM_TYPE_") +
                                     geometry + "\n" + pass.define + UrpTree("SpeedTree7Input") +
                                     UrpTree("SpeedTree7Passes");
            CompileEntries(text, pass.vertex, pass.fragment, {}, ProgramLanguage::Hlsl);
            CompileEntries(text, pass.vertex, pass.fragment, bumped, ProgramLanguage::Hlsl);
        }
    }
    const std::string board =
        UrpTree("SpeedTree7BillboardInput") + UrpTree("SpeedTree7BillboardPasses");
    CompileEntries(board, "SpeedTree7Vert", "SpeedTree7Frag", bumped, ProgramLanguage::Hlsl);
    CompileEntries("#define ENABLE_WIND\n#define BILLBOARD_FACE_CAMERA_POS\n" + board,
                   "SpeedTree7VertDepth", "SpeedTree7FragDepth", {}, ProgramLanguage::Hlsl);
    CompileEntries(board, "SpeedTree7VertDepthNormalBillboard",
                   "SpeedTree7FragDepthNormalBillboard", bumped, ProgramLanguage::Hlsl);
}

} // namespace
} // namespace limn
