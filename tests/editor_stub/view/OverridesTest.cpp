#include "Mentions.h"
#include "SceneFolder.h"

#include <limn/editor_stub/Overrides.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/volume/VolumeManager.h>

namespace limn::test
{

namespace
{

constexpr const char* k_Scene = "camera: {}\n"
                                "layers: {6: Furniture}\n"
                                "renderer:\n"
                                "  features:\n"
                                "    - {type: ScreenSpaceOutlineRenderFeature, name: My Outline}\n"
                                "    - {type: ScreenSpaceOutlineRenderFeature, name: Other}\n"
                                "volumes:\n"
                                "  - {name: Room, profile: on.profile.yaml, priority: 100}\n";

class Overrides : public testing::Test
{
protected:
    void Apply(const std::vector<std::string>& overrides)
    {
        ApplyOverrides(asset, overrides, folder.assets);
    }

    std::vector<std::string> ProblemsOf(const std::vector<std::string>& overrides)
    {
        return Problems([&] { Apply(overrides); });
    }

    /// The blended component at the scene's camera.
    VolumeStack Blend()
    {
        VolumeManager manager(folder.assets.volumeComponents());
        for (const Volume& volume : asset.volumes)
        {
            manager.Register(&volume);
        }
        VolumeStack stack = manager.CreateStack();
        manager.Update(stack, glm::vec3(0.0f), asset.camera.volumeLayerMask);
        return stack;
    }

    const ScriptableRendererFeature& Feature(std::size_t index)
    {
        return *asset.renderer.features.at(index);
    }

    const ScreenSpaceOutlineSettings& Settings(std::size_t index)
    {
        return dynamic_cast<const ScreenSpaceOutlineRenderFeature&>(Feature(index)).settings();
    }

    SceneFolder folder;
    SceneAsset asset = folder.Load(k_Scene);
};

} // namespace

TEST_F(Overrides, OfAVolumeParameterWinOverEveryVolume)
{
    Apply({"ScreenSpaceOutline.m_OutlineWidth=7", "ScreenSpaceOutline.outlineColor=#00ff00"});
    const VolumeStack stack = Blend();
    const auto* outline = stack.GetComponent<ScreenSpaceOutline>();
    EXPECT_EQ(7.0f, outline->m_OutlineWidth.value());
    EXPECT_EQ(Color::green, outline->m_OutlineColor.value());
    EXPECT_TRUE(outline->m_Enable.value()) << "the scene's own volume still counts";
}

TEST_F(Overrides, ReachACameraThatLooksAtOtherVolumeLayers)
{
    asset.camera.volumeLayerMask = LayerMask::FromIndex(6);
    Apply({"ScreenSpaceOutline.m_OutlineWidth=7"});
    EXPECT_EQ(7.0f, Blend().GetComponent<ScreenSpaceOutline>()->m_OutlineWidth.value());
}

TEST_F(Overrides, ByAFeaturesNameChangeThatFeature)
{
    Apply({"My Outline.m_LayerMask=[Furniture]", "My Outline.renderPassEvent=BeforeRendering+3"});
    EXPECT_EQ(LayerMask(64), Settings(0).m_LayerMask);
    EXPECT_EQ(3, static_cast<int>(Settings(0).m_RenderPassEvent));
    EXPECT_EQ(LayerMask::Nothing(), Settings(1).m_LayerMask);
}

TEST_F(Overrides, ByAFeaturesTypeChangeAllOfThem)
{
    Apply({"ScreenSpaceOutlineRenderFeature.active=false"});
    EXPECT_FALSE(Feature(0).isActive());
    EXPECT_FALSE(Feature(1).isActive());
}

TEST_F(Overrides, FindAShaderFileBesideTheScene)
{
    folder.Write("my.shader", "Shader \"Mine\" { SubShader { Pass { } Pass { } Pass { } } }");
    Apply({"Other.m_ScreenSpaceOutlineShader=my.shader"});
    EXPECT_EQ("Mine", Settings(1).m_ScreenSpaceOutlineShader->name());
}

TEST_F(Overrides, ThatAreWrongAreAllReported)
{
    EXPECT_THAT(
        ProblemsOf({"nonsense", "My Outlin.active=true", "ScreenSpaceOutline.m_OutlineWidth=14",
                    "ScreenSpaceOutline.outlneColor=white", "My Outline.m_LayerMsk=Nothing",
                    "My Outline.m_RenderingLayerMask=32"}),
        testing::ElementsAre(
            Mentions("NAME.path=value", "ScreenSpaceOutline.m_OutlineWidth=4"),
            Mentions("unknown name", "'My Outlin'", "'My Outline'"),
            Mentions("ScreenSpaceOutline.m_OutlineWidth:", "14", "outside", "[1, 10]"),
            Mentions("ScreenSpaceOutline:", "unknown parameter", "'outlneColor'", "'outlineColor'"),
            Mentions("My Outline:", "unknown setting", "'m_LayerMsk'", "'m_LayerMask'"),
            Mentions("My Outline.m_RenderingLayerMask:", "32", "outside", "[0, 31]")));
}

TEST_F(Overrides, ThatDoNotFitEachOtherAreAnErrorOfTheirs)
{
    folder.Write("one.shader", "Shader \"One\" { SubShader { Pass { } } }");
    asset = folder.Load("camera: {}\nrenderer: {features: [{type: RenderObjects, name: R, "
                        "overrideMode: Shader, overrideShader: one.shader}]}\n");
    EXPECT_THAT(
        ProblemsOf({"R.overrideShaderPassIndex=9"}),
        testing::ElementsAre(Mentions("R:", "overrideShaderPassIndex is 9", "'One'", "0...0")));
    EXPECT_NO_THROW(Apply({"R.overrideShaderPassIndex=9", "R.overrideMode=None"}));
}

TEST_F(Overrides, NeedACameraThatLooksAtVolumes)
{
    asset.camera.volumeLayerMask = LayerMask::Nothing();
    EXPECT_THAT(ProblemsOf({"ScreenSpaceOutline.m_OutlineWidth=4"}),
                testing::ElementsAre(Mentions("volumeLayerMask is Nothing", "no volume")));
}

TEST_F(Overrides, AProfileReplacesThatOfGlobalVolumes)
{
    folder.Write("wide.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 9}\n");
    ReplaceProfile(asset, "wide.profile.yaml", folder.assets);
    ASSERT_EQ(1u, asset.volumes.size());
    const VolumeStack stack = Blend();
    const auto* outline = stack.GetComponent<ScreenSpaceOutline>();
    EXPECT_EQ(9.0f, outline->m_OutlineWidth.value());
    EXPECT_FALSE(outline->m_Enable.value()) << "the profile that was there is gone";
}

TEST_F(Overrides, AProfileComesAsANewVolumeWhereNoneIsGlobal)
{
    asset.volumes.clear();
    ReplaceProfile(asset, "on.profile.yaml", folder.assets);
    EXPECT_EQ(4.0f, Blend().GetComponent<ScreenSpaceOutline>()->m_OutlineWidth.value());
}

} // namespace limn::test
