#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/core/Material.h>

namespace limn::test
{

namespace
{

const std::string k_Library =
    "Shader \"Lib/Passes\" { SubShader { Pass { Name \"Hull\" Cull Front\n"
    "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
    "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
    "float4 F() : SV_Target { return 1; }\nENDHLSL } } }";

const char* k_Scene = "camera: {}\n"
                      "materials: {m: {shader: user.shader}}\n"
                      "objects: [{name: a, mesh: cube, material: m}]\n";

} // namespace

TEST(SceneShader, TakesThePassThatUsePassNamesFromAnotherFileOfItsFolder)
{
    SceneFolder folder;
    folder.Write("library.shader", k_Library);
    folder.Write("user.shader", "Shader \"User\" { SubShader { UsePass \"Lib/Passes/HULL\" } }");
    SceneAsset asset = folder.Load(k_Scene);
    const Shader& shader = *asset.scene.Find("a")->renderer->sharedMaterials.at(0)->shader();
    ASSERT_EQ(1, shader.passCount());
    EXPECT_EQ(CullMode::Front, shader.passState(0).cull.value);
}

TEST(SceneShader, LivesFromItsFallback)
{
    SceneFolder folder;
    folder.Write("library.shader", k_Library);
    folder.Write("user.shader", "Shader \"User\" { SubShader { Tags { \"RenderPipeline\" = "
                                "\"HDRenderPipeline\" } Pass { } } Fallback \"Lib/Passes\" }");
    SceneAsset asset = folder.Load(k_Scene);
    EXPECT_EQ("Hull",
              asset.scene.Find("a")->renderer->sharedMaterials.at(0)->shader()->passName(0));
}

TEST(SceneShader, NamesAUsePassThatLeadsNowhere)
{
    SceneFolder folder;
    folder.Write("library.shader", k_Library);
    folder.Write("user.shader", "Shader \"User\" { SubShader { UsePass \"Lib/Pases/HULL\" } }");
    const std::vector<std::string> problems = folder.ProblemsOf(k_Scene);
    ASSERT_FALSE(problems.empty());
    EXPECT_THAT(problems, testing::Contains(testing::HasSubstr("did you mean 'Lib/Passes'?")));
}

} // namespace limn::test
