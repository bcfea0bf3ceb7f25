#include "shaders/UsedShaders.h"
#include "Mentions.h"
#include "SceneFolder.h"
#include "commands/WatchedAssets.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

constexpr const char* k_Materials = "camera: {}\n"
                                    "materials:\n"
                                    "  own: {shader: own.shader, renderQueue: 2600}\n"
                                    "  lit: {}\n"
                                    "objects:\n"
                                    "  - {name: A, mesh: cube, material: own}\n"
                                    "  - {name: B, mesh: cube, material: lit}\n"
                                    "  - {name: C, mesh: cube, material: own}\n";

} // namespace

TEST(UsedShaders, GivesObjectsOfABrokenShaderTheErrorShaderInTheirQueue)
{
    SceneFolder folder;
    folder.Write("Tint.hlsl", TintText("1, 1, 1"));
    folder.Write("own.shader", ShaderText("undeclared"));
    SceneAsset asset = folder.Load(k_Materials);
    const std::vector<Diagnostic> problems =
        CompileOrReplaceShaders(asset, folder.assets.compiler());
    ASSERT_FALSE(problems.empty());
    EXPECT_THAT(ToString(problems.front()), testing::HasSubstr("undeclared"));
    const auto materialOf = [&asset](std::size_t index)
    {
        return asset.scene.objects()[index]->renderer->sharedMaterials.front();
    };
    EXPECT_EQ("Hidden/Core/FallbackError", materialOf(0)->shader()->name());
    EXPECT_EQ(2600, materialOf(0)->renderQueue());
    EXPECT_EQ("own", materialOf(0)->name());
    EXPECT_EQ("Limn/Half Lambert", materialOf(1)->shader()->name());
    EXPECT_EQ(materialOf(0), materialOf(2)) << "one material, so that both are instances";
    EXPECT_EQ(1, materialOf(0)->passCount());
    EXPECT_NO_THROW(materialOf(0)->shader()->Compile(0));
}

TEST(UsedShaders, AreMagentaOrInactiveInASceneOfUnitysWhereTheyAreBroken)
{
    SceneFolder folder;
    folder.Write("Tint.hlsl", TintText("1, 1, 1"));
    folder.Write("own.shader", ShaderText("undeclared"));
    folder.Write("sound.shader", ShaderText("1"));
    SceneAsset asset = folder.Load(
        std::string(k_Materials) +
        "renderer:\n  features:\n"
        "  - {type: RenderObjects, name: Over, overrideMode: Shader, overrideShader: own.shader}\n"
        "  - {type: RenderObjects, name: Sound, overrideMode: Shader, "
        "overrideShader: sound.shader}\n");
    EXPECT_THROW(CompileUsedShaders(asset), AssetError) << "limn's own scenes";
    asset.isUnityScene = true;
    const std::vector<Diagnostic> notes = CompileUsedShaders(asset);
    std::vector<std::string> texts;
    for (const Diagnostic& note : notes)
    {
        EXPECT_EQ(note.severity, Severity::Note);
        texts.push_back(ToString(note));
    }
    EXPECT_THAT(texts, testing::ElementsAre(Mentions("own.shader", "undeclared"),
                                            Mentions("own.shader", "magenta"),
                                            Mentions("own.shader", "Over: it is left out")));
    const auto shaderOf = [&asset](std::size_t index)
    {
        return asset.scene.objects()[index]->renderer->sharedMaterials.front()->shader()->name();
    };
    EXPECT_EQ("Hidden/Core/FallbackError", shaderOf(0));
    EXPECT_EQ("Limn/Half Lambert", shaderOf(1));
    EXPECT_FALSE(asset.renderer.features[0]->isActive());
    EXPECT_TRUE(asset.renderer.features[1]->isActive());
    EXPECT_THAT(CompileUsedShaders(asset), testing::IsEmpty()) << "nothing is broken any more";
}

TEST(UsedShaders, CannotDrawMeshesWhereTheirGeometryFunctionTakesPoints)
{
    SceneFolder folder;
    folder.Write("Tint.hlsl", TintText("1, 1, 1"));
    folder.Write("own.shader", R"(Shader "Test/Points"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Place
            #pragma geometry Grow
            #pragma fragment Paint
            struct Point { float4 position : SV_POSITION; };
            Point Place(float4 position : POSITION) { Point p = {position}; return p; }
            [maxvertexcount(1)] void Grow(point Point p[1], inout PointStream<Point> stream)
            {
                stream.Append(p[0]);
            }
            float4 Paint() : SV_Target { return 1; }
            ENDHLSL
        }
    }
}
)");
    SceneAsset asset = folder.Load(k_Materials);
    EXPECT_THAT([&] { CompileUsedShaders(asset); },
                testing::ThrowsMessage<AssetError>(
                    Mentions("own.shader:5:9: error", "geometry", "'triangle'")))
        << "limn's own scenes";
    SceneAsset watched = folder.Load(k_Materials);
    EXPECT_THAT(CompileOrReplaceShaders(watched, folder.assets.compiler()), testing::SizeIs(1));
    EXPECT_EQ("Hidden/Core/FallbackError",
              watched.scene.objects()[0]->renderer->sharedMaterials[0]->shader()->name());
    asset.isUnityScene = true;
    std::vector<std::string> texts;
    for (const Diagnostic& note : CompileUsedShaders(asset))
    {
        texts.push_back(ToString(note));
    }
    EXPECT_THAT(texts,
                testing::ElementsAre(Mentions("own.shader:5:9: note", "geometry", "'triangle'"),
                                     Mentions("own.shader", "'Test/Points'", "magenta")));
}

TEST(UsedShaders, RefusesAFeaturesBrokenShader)
{
    SceneFolder folder;
    folder.Write("Tint.hlsl", TintText("1, 1, 1"));
    folder.Write("own.shader", ShaderText("undeclared"));
    SceneAsset asset =
        folder.LoadWithCamera("renderer: {features: [{type: RenderObjects, overrideMode: Shader, "
                              "overrideShader: own.shader}]}\n");
    EXPECT_THROW(CompileOrReplaceShaders(asset, folder.assets.compiler()), AssetError);
}

} // namespace limn::test
