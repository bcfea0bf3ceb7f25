#include "Mentions.h"
#include "Paths.h"
#include "SceneFolder.h"
#include "assets/Importer.h"
#include "unity/RendererData.h"

#include <limn/base/ReadFile.h>
#include <limn/core/Image.h>
#include <limn/core/Inspector.h>
#include <limn/core/Resources.h>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <limn/features/PostProcessRendererFeature.h>
#include <limn/features/ScreenSpaceAmbientOcclusion.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>

namespace limn::test
{

namespace
{

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

const std::string k_Project = test::SourcePath("tests/editor_stub/data/unity_project");

/// A renderer asset with one feature of these lines.
std::string AssetWithFeature(const std::string& lines)
{
    return "%YAML 1.1\n"
           "%TAG !u! tag:unity3d.com,2011:\n"
           "--- !u!114 &5\n"
           "MonoBehaviour:\n" +
           lines +
           "--- !u!114 &11400000\n"
           "MonoBehaviour:\n"
           "  m_Name: R\n"
           "  m_RendererFeatures:\n"
           "  - {fileID: 5}\n"
           "  - {fileID: 0}\n"
           "  m_OpaqueLayerMask: {serializedVersion: 2, m_Bits: 3}\n"
           "  m_TransparentLayerMask: {serializedVersion: 2, m_Bits: 4}\n";
}

/// A feature of a plug-in, which looks for a shader and a graph of the project by their names, and
/// has a setting for a third.
class FindingFeature : public ScriptableRendererFeature
{
public:
    void Create() override
    {
        shader = Shader::Find("Project/Haze");
        graph = Shader::Find("Shader Graphs/Water");
    }
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
    void Describe(Inspector& inspector) override { inspector.Field("m_Third", m_Third, ""); }

    std::shared_ptr<const Shader> shader;
    std::shared_ptr<const Shader> graph;
    std::shared_ptr<const Shader> m_Third;
};

/// A feature of a plug-in, which loads files of the project's folders Resources.
class LoadingFeature : public ScriptableRendererFeature
{
public:
    void Create() override
    {
        shader = Resources::Load<Shader>("Haze");
        graph = Resources::Load<Shader>("Water");
        texture = Resources::Load<Texture2D>("Noise/Blue");
        kernels = Resources::Load<ComputeShader>("Fill");
        outside = Resources::Load<Shader>("Outside");
        part = Resources::Load<Texture>("Blue");
    }
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}

    std::shared_ptr<const Shader> shader;
    std::shared_ptr<const Shader> graph;
    std::shared_ptr<const Texture> texture;
    std::shared_ptr<ComputeShader> kernels;
    std::shared_ptr<const Shader> outside;
    std::shared_ptr<const Texture> part;
};

std::string EmptyShader(const std::string& name)
{
    return "Shader \"" + name + "\" { SubShader { Pass { } } }";
}

} // namespace

TEST(UnityRendererData, LetsAFeatureLoadFilesOfTheFoldersResources)
{
    SceneFolder folder;
    folder.Write("ProjectSettings/ProjectSettings.asset", "");
    folder.Write("Assets/Sky/Resources/Haze.shader", EmptyShader("Project/Haze"));
    folder.Write("Assets/Sky/Resources/Haze.shader.meta", "guid: a1\n");
    folder.Write("Assets/Outside.shader", EmptyShader("Project/Outside"));
    folder.Write("Assets/Outside.shader.meta", "guid: a2\n");
    folder.Write("Assets/Resources/Water.shadergraph", "Shader Graphs/Water");
    folder.Write("Assets/Resources/Water.shadergraph.meta", "guid: a3\n");
    folder.Write("Assets/Resources/Noise/Blue.png.meta", "guid: a4\n");
    WritePng(folder / "Assets/Resources/Noise/Blue.png",
             {2, 3, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(2 * 3 * 4)});
    folder.Write("Assets/Resources/Fill.compute", "#pragma kernel Fill\nRWBuffer<float> _Out;\n"
                                                  "[numthreads(1, 1, 1)] void Fill() "
                                                  "{ _Out[0] = 1; }\n");
    folder.Write("Assets/Resources/Fill.compute.meta", "guid: a5\n");
    folder.Write("Assets/LoadingFeature.cs.meta", "guid: a6\n");
    const auto path = folder.Write(
        "Assets/r.asset", AssetWithFeature("  m_Script: {fileID: 11500000, guid: a6, type: 3}\n"
                                           "  m_Name: Loader\n  m_Active: 1\n"));
    AssetContext assets;
    assets.features().Register<LoadingFeature>("LoadingFeature");
    UnityAssetLoaders load;
    load.graph = [](const std::filesystem::path& graph, AssetContext& context)
    {
        return Shader::FromText(EmptyShader(ReadFile(graph)), graph.generic_string(),
                                context.compiler());
    };
    const UnityRendererDataLoadResult result =
        LoadUnityRendererData(path, assets, UnityProject(path), load);
    ASSERT_EQ(1u, result.renderer.features.size());
    const auto& feature = dynamic_cast<const LoadingFeature&>(*result.renderer.features[0]);
    ASSERT_NE(nullptr, feature.shader);
    EXPECT_EQ("Project/Haze", feature.shader->name());
    ASSERT_NE(nullptr, feature.graph);
    EXPECT_EQ("Shader Graphs/Water", feature.graph->name());
    ASSERT_NE(nullptr, feature.texture);
    EXPECT_EQ(2, feature.texture->width());
    EXPECT_EQ(3, feature.texture->height());
    ASSERT_NE(nullptr, feature.kernels);
    EXPECT_TRUE(feature.kernels->HasKernel("Fill"));
    EXPECT_EQ(nullptr, feature.outside) << "it lies in no folder Resources";
    EXPECT_EQ(nullptr, feature.part) << "the folder belongs to the name";
}

TEST(UnityRendererData, LetsAFeatureFindTheShadersOfTheProject)
{
    SceneFolder folder;
    folder.Write("ProjectSettings/ProjectSettings.asset", "");
    folder.Write("Assets/Haze.shader", "Shader \"Project/Haze\" { SubShader { Pass { } } }");
    folder.Write("Assets/Haze.shader.meta", "guid: 000000000000000000000000000000a1\n");
    folder.Write("Assets/Broken.shader", "Shader \"Project/Broken\" {");
    folder.Write("Assets/Broken.shader.meta", "guid: 000000000000000000000000000000a2\n");
    folder.Write("Assets/FindingFeature.cs.meta", "guid: 000000000000000000000000000000a3\n");
    folder.Write("Assets/FindingFeature.cs", "class FindingFeature { }");
    folder.Write("Assets/r.asset",
                 AssetWithFeature("  m_Script: {fileID: 11500000, guid: "
                                  "000000000000000000000000000000a3, type: 3}\n"
                                  "  m_Name: Finder\n  m_EditorClassIdentifier: \n"
                                  "  m_Active: 1\n"));
    AssetContext assets;
    assets.features().Register<FindingFeature>("FindingFeature");
    const UnityRendererDataLoadResult result =
        LoadUnityRendererData(folder / "Assets/r.asset", assets);
    ASSERT_EQ(1u, result.renderer.features.size());
    const auto& feature = dynamic_cast<const FindingFeature&>(*result.renderer.features[0]);
    ASSERT_NE(nullptr, feature.shader);
    EXPECT_EQ("Project/Haze", feature.shader->name());
    EXPECT_EQ(nullptr, feature.graph);
    assets.shaderSource()->Clear(); // as when a plug-in is loaded
    EXPECT_NE(nullptr, assets.FindShader("Project/Haze"));
    EXPECT_EQ(nullptr, assets.FindShader("Project/Broken"));
}

TEST(UnityRendererData, FindsShaderGraphsByNameAndForSettings)
{
    SceneFolder folder;
    folder.Write("ProjectSettings/ProjectSettings.asset", "");
    folder.Write("Assets/Other/Water.shadergraph", "Shader Graphs/Rain");
    folder.Write("Assets/Water.shadergraph", "Shader Graphs/Water");
    folder.Write("Assets/Sand.shadergraph", "Shader Graphs/Sand");
    folder.Write("Assets/Other/Water.shadergraph.meta", "guid: a1\n");
    folder.Write("Assets/Water.shadergraph.meta", "guid: a2\n");
    folder.Write("Assets/Sand.shadergraph.meta", "guid: a3\n");
    folder.Write("Assets/FindingFeature.cs.meta", "guid: a4\n");
    const auto path = folder.Write(
        "Assets/r.asset",
        AssetWithFeature("  m_Script: {fileID: 11500000, guid: a4, type: 3}\n  m_Name: Finder\n"
                         "  m_Active: 1\n  m_Third: {fileID: -646, guid: a3, type: 3}\n"));
    AssetContext assets;
    assets.features().Register<FindingFeature>("FindingFeature");
    const UnityProject project(path);
    UnityAssetLoaders load;
    load.graph = [](const std::filesystem::path& graph, AssetContext& context)
    {
        const std::string name = ReadFile(graph); // in place of a graph
        return Shader::FromText("Shader \"" + name + "\" { SubShader { Pass { } } }",
                                graph.generic_string(), context.compiler());
    };
    const UnityRendererDataLoadResult result = LoadUnityRendererData(path, assets, project, load);
    ASSERT_EQ(1u, result.renderer.features.size());
    const auto& feature = dynamic_cast<const FindingFeature&>(*result.renderer.features[0]);
    ASSERT_NE(nullptr, feature.graph);
    EXPECT_EQ("Shader Graphs/Water", feature.graph->name());
    ASSERT_NE(nullptr, feature.m_Third);
    EXPECT_EQ("Shader Graphs/Sand", feature.m_Third->name());
    EXPECT_THAT(Texts(result.notes),
                Each(HasSubstr("a feature is left out; it is not in this file")));
}

TEST(UnityRendererData, GivesTheFeatureOfTheArticlesProject)
{
    AssetContext assets;
    const UnityRendererDataLoadResult result =
        LoadUnityRendererData(k_Project + "/Assets/Settings/UniversalRenderer.asset", assets);
    ASSERT_EQ(2u, result.renderer.features.size()) << "and post-processing, which URP has built in";
    EXPECT_NE(nullptr,
              dynamic_cast<const PostProcessRendererFeature*>(result.renderer.features[1].get()));
    EXPECT_EQ("Post-processing", result.renderer.features[1]->name);
    const auto& feature =
        dynamic_cast<const ScreenSpaceOutlineRenderFeature&>(*result.renderer.features[0]);
    EXPECT_EQ("Screem Space Outline", feature.name);
    EXPECT_TRUE(feature.isActive());
    const ScreenSpaceOutlineSettings& settings = feature.settings();
    EXPECT_EQ(500, static_cast<int>(settings.m_RenderPassEvent));
    EXPECT_EQ(ScreenSpaceOutlineSettings::RenderQueueRange::Opaque, settings.m_RenderQueueRange);
    EXPECT_EQ(LayerMask(64), settings.m_LayerMask);
    EXPECT_EQ(8, settings.m_RenderingLayerMask);
    EXPECT_EQ("Hidden/ScreenSpaceOutline", settings.m_ScreenSpaceOutlineShader->name());
    EXPECT_EQ(LayerMask::Everything(), result.renderer.opaqueLayerMask);
    EXPECT_EQ(LayerMask::Everything(), result.renderer.transparentLayerMask);
}

TEST(UnityRendererData, NotesWhatItDoesNotKnow)
{
    AssetContext assets;
    const UnityRendererDataLoadResult result =
        LoadUnityRendererData(k_Project + "/Assets/Settings/UniversalRenderer.asset", assets);
    EXPECT_THAT(
        Texts(result.notes),
        ElementsAre(Mentions("18:33: Screem Space Outline.m_Settings.m_ScreenSpaceOutlineShader:",
                             "ScreenSpaceOutline.shader", "not in the project",
                             "Hidden/ScreenSpaceOutline"),
                    Mentions("19:5: Screem Space Outline.m_Settings.m_DownSampleLevel:", "left out",
                             "no such setting"),
                    Mentions("25:5: Screem Space Outline.m_Settings.m_OutlineWidth:", "left out",
                             "no such setting"),
                    Mentions("26:5: Screem Space Outline.m_Settings.m_OutlineColor:", "left out",
                             "no such setting")));
}

TEST(UnityRendererData, NamesAFeatureOfThePackageThatLimnHasNot)
{
    SceneFolder folder;
    AssetContext assets;
    const auto path =
        folder.Write("r.asset", AssetWithFeature("  m_Script: {fileID: 11500000, guid: "
                                                 "a1614fc811f8f184697d9bee70ab9fe5, type: 3}\n"
                                                 "  m_Name: Stains\n  m_Active: 1\n"));
    const UnityRendererDataLoadResult result = LoadUnityRendererData(path, assets);
    EXPECT_THAT(Texts(result.notes),
                testing::Contains(Mentions("Stains: it is left out", "DecalRendererFeature")));
}

// URP 13 and the samples from before gave the script another guid than URP 14 does.
TEST(UnityRendererData, ReadsAFullScreenPassByBothOfItsGuids)
{
    for (const char* guid :
         {"b00045f12942b46c698459096c89274e", "6d613f08f173d4dd895bb07b3230baa9"})
    {
        SceneFolder folder;
        folder.Write("r.asset",
                     AssetWithFeature("  m_Script: {fileID: 11500000, guid: " + std::string(guid) +
                                      ", type: 3}\n  m_Name: Whole\n"
                                      "  m_EditorClassIdentifier: \n  m_Active: 1\n"
                                      "  injectionPoint: 600\n  requirements: 5\n"
                                      "  passIndex: 0\n  m_Version: 0\n"));
        AssetContext assets;
        const UnityRendererDataLoadResult result =
            LoadUnityRendererData(folder / "r.asset", assets);
        EXPECT_THAT(Texts(result.notes), Each(Not(HasSubstr("m_Version"))));
        ASSERT_EQ(1u, result.renderer.features.size()) << guid;
        EXPECT_EQ("Whole", result.renderer.features[0]->name);
        const auto& pass =
            dynamic_cast<const FullScreenPassRendererFeature&>(*result.renderer.features[0]);
        EXPECT_EQ(ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Color,
                  pass.requirements);
    }
}

TEST(UnityRendererData, ReadsAmbientOcclusionOfUrp14WithoutAWord)
{
    SceneFolder folder;
    folder.Write("r.asset", AssetWithFeature("  m_Script: {fileID: 11500000, guid: "
                                             "f62c9c65cf3354c93be831c8bc075510, type: 3}\n"
                                             "  m_Name: Corners\n"
                                             "  m_EditorClassIdentifier: \n"
                                             "  m_Active: 1\n"
                                             "  m_Settings:\n"
                                             "    AOMethod: 1\n"
                                             "    Downsample: 1\n"
                                             "    AfterOpaque: 1\n"
                                             "    Source: 0\n"
                                             "    NormalSamples: 2\n"
                                             "    Intensity: 0.5\n"
                                             "    DirectLightingStrength: 0.75\n"
                                             "    Radius: 0.25\n"
                                             "    Samples: 0\n"
                                             "    BlurQuality: 2\n"
                                             "    Falloff: 40\n"
                                             "    SampleCount: -1\n"
                                             "  m_BlueNoise256Textures:\n"
                                             "  - {fileID: 2800000, guid: 36, type: 3}\n"
                                             "  m_Shader: {fileID: 4800000, guid: 8e, type: 3}\n"));
    AssetContext assets;
    const UnityRendererDataLoadResult result = LoadUnityRendererData(folder / "r.asset", assets);
    ASSERT_EQ(1u, result.renderer.features.size());
    EXPECT_EQ("Corners", result.renderer.features[0]->name);
    using Settings = ScreenSpaceAmbientOcclusionSettings;
    const Settings& settings =
        dynamic_cast<const ScreenSpaceAmbientOcclusion&>(*result.renderer.features[0]).m_Settings;
    EXPECT_EQ(Settings::AOMethodOptions::InterleavedGradient, settings.AOMethod);
    EXPECT_TRUE(settings.Downsample);
    EXPECT_TRUE(settings.AfterOpaque);
    EXPECT_EQ(Settings::DepthSource::Depth, settings.Source);
    EXPECT_EQ(Settings::NormalQuality::High, settings.NormalSamples);
    EXPECT_EQ(0.5f, settings.Intensity);
    EXPECT_EQ(0.75f, settings.DirectLightingStrength);
    EXPECT_EQ(0.25f, settings.Radius);
    EXPECT_EQ(Settings::AOSampleOption::High, settings.Samples);
    EXPECT_EQ(Settings::BlurQualityOptions::Low, settings.BlurQuality);
    EXPECT_EQ(40.0f, settings.Falloff);
    EXPECT_THAT(Texts(result.notes),
                ElementsAre(Mentions("30:5: m_RendererFeatures:", "left out", "this file")))
        << "the helper's own second reference, and nothing else";
}

TEST(UnityRendererData, ReadsAmbientOcclusionOfUrp12AsUrp14Does)
{
    SceneFolder folder;
    folder.Write("r.asset", AssetWithFeature("  m_Script: {fileID: 11500000, guid: "
                                             "f62c9c65cf3354c93be831c8bc075510, type: 3}\n"
                                             "  m_Name: SSAO\n"
                                             "  m_Active: 1\n"
                                             "  m_Shader: {fileID: 0}\n"
                                             "  m_Settings:\n"
                                             "    Downsample: 1\n"
                                             "    AfterOpaque: 0\n"
                                             "    Source: 0\n"
                                             "    NormalSamples: 0\n"
                                             "    Intensity: 0.5\n"
                                             "    DirectLightingStrength: 0.25\n"
                                             "    Radius: 0.25\n"
                                             "    SampleCount: 4\n"));
    AssetContext assets;
    const UnityRendererDataLoadResult result = LoadUnityRendererData(folder / "r.asset", assets);
    using Settings = ScreenSpaceAmbientOcclusionSettings;
    const Settings& settings =
        dynamic_cast<const ScreenSpaceAmbientOcclusion&>(*result.renderer.features.at(0))
            .m_Settings;
    EXPECT_EQ(Settings::AOMethodOptions::InterleavedGradient, settings.AOMethod);
    EXPECT_EQ(Settings::AOSampleOption::Low, settings.Samples);
    EXPECT_EQ(Settings::BlurQualityOptions::High, settings.BlurQuality);
    EXPECT_EQ(100.0f, settings.Falloff);
    EXPECT_EQ(1u, result.notes.size());
}

TEST(UnityRendererData, FindsScriptAndShaderOfTheProjectByGuid)
{
    SceneFolder folder;
    std::filesystem::create_directories(folder / "Assets/Code");
    folder.Write("Assets/Code/ScreenSpaceOutlineRenderFeature.cs.meta", "guid: aa\n");
    folder.Write("Assets/Code/my.shader.meta", "fileFormatVersion: 2\nguid: bb\n");
    folder.Write("Assets/Code/my.shader",
                 "Shader \"Mine\" { SubShader { Pass { } Pass { } Pass { } } }");
    folder.Write("Assets/r.asset",
                 AssetWithFeature("  m_Script: {fileID: 11500000, guid: aa, type: 3}\n"
                                  "  m_Name: F\n"
                                  "  m_Active: 0\n"
                                  "  m_Settings:\n"
                                  "    m_ScreenSpaceOutlineShader: {fileID: 4800000, guid: bb}\n"));
    const UnityRendererDataLoadResult result =
        LoadUnityRendererData(folder / "Assets/r.asset", folder.assets);
    ASSERT_EQ(1u, result.renderer.features.size());
    const auto& feature =
        dynamic_cast<const ScreenSpaceOutlineRenderFeature&>(*result.renderer.features[0]);
    EXPECT_FALSE(feature.isActive());
    EXPECT_EQ("Mine", feature.settings().m_ScreenSpaceOutlineShader->name());
    EXPECT_EQ(LayerMask(3), result.renderer.opaqueLayerMask);
    EXPECT_EQ(LayerMask(4), result.renderer.transparentLayerMask);
    EXPECT_THAT(Texts(result.notes),
                ElementsAre(Mentions("15:5: m_RendererFeatures:", "left out", "this file")));
}

TEST(UnityRendererData, LeavesOutAFeatureWhoseScriptIsUnknown)
{
    SceneFolder folder;
    std::filesystem::create_directories(folder / "Assets");
    folder.Write("Assets/FullScreenPass.cs.meta", "guid: cc\n");
    folder.Write("Assets/r.asset", AssetWithFeature("  m_Script: {fileID: 1, guid: cc}\n"
                                                    "  m_Name: Dither\n"));
    folder.Write("Assets/s.asset", AssetWithFeature("  m_Script: {fileID: 1, guid: dd}\n"
                                                    "  m_Name: Dither\n"));
    const auto known = LoadUnityRendererData(folder / "Assets/r.asset", folder.assets);
    EXPECT_TRUE(known.renderer.features.empty());
    EXPECT_THAT(Texts(known.notes).at(0),
                Mentions("4:1: Dither:", "left out", "no feature FullScreenPass"));
    const auto unknown = LoadUnityRendererData(folder / "Assets/s.asset", folder.assets);
    EXPECT_TRUE(unknown.renderer.features.empty());
    EXPECT_THAT(Texts(unknown.notes).at(0),
                Mentions("4:1: Dither:", "left out", ".cs.meta", "guid 'dd'"));

    folder.Write("Assets/FullScreenPass.cs", "class FullScreenPass : ScriptableRendererFeature {}");
    const auto there = LoadUnityRendererData(folder / "Assets/r.asset", folder.assets);
    EXPECT_THAT(Texts(there.notes).at(0),
                Mentions("left out", "no feature FullScreenPass", "limn port",
                         (folder / "Assets/FullScreenPass.cs").generic_string(), "-o"));
}

TEST(UnityRendererData, LeavesOutAFeatureThatIsOffWithoutAWord)
{
    SceneFolder folder;
    std::filesystem::create_directories(folder / "Assets");
    for (const char* script : {"cc", "dd"})
    {
        folder.Write("Assets/FullScreenPass.cs.meta", "guid: cc\n");
        folder.Write("Assets/r.asset",
                     AssetWithFeature("  m_Script: {fileID: 1, guid: " + std::string(script) +
                                      "}\n  m_Name: Dither\n  m_Active: 0\n"));
        const auto result = LoadUnityRendererData(folder / "Assets/r.asset", folder.assets);
        EXPECT_TRUE(result.renderer.features.empty());
        EXPECT_THAT(Texts(result.notes), testing::Each(testing::Not(testing::HasSubstr("Dither"))));
    }
}

TEST(UnityRendererData, ReportsASettingOutsideItsRange)
{
    SceneFolder folder;
    std::filesystem::create_directories(folder / "Assets");
    folder.Write("Assets/ScreenSpaceOutlineRenderFeature.cs.meta", "guid: aa\n");
    const auto path = folder.Write("Assets/r.asset",
                                   AssetWithFeature("  m_Script: {fileID: 1, guid: aa}\n"
                                                    "  m_Name: F\n"
                                                    "  m_Settings: {m_RenderingLayerMask: 32}\n"));
    EXPECT_EQ((std::vector<std::string>{
                  "7:38: F.m_Settings.m_RenderingLayerMask: 32 is outside [0, 31]"}),
              Problems([&] { LoadUnityRendererData(path, folder.assets); }));
}

TEST(UnityRendererData, ReportsSettingsThatCannotBeDrawnWith)
{
    SceneFolder folder;
    std::string names = "a";
    for (int i = 1; i < 17; ++i)
    {
        names += ", a";
    }
    const auto path = folder.Write(
        "r.asset", AssetWithFeature("  m_Script: {fileID: 11500000, guid: "
                                    "6b3d386ba5cd94485973aee1479b272e, type: 3}\n"
                                    "  m_Name: R\n  settings: {filterSettings: {PassNames: [" +
                                    names + "]}}\n"));
    EXPECT_THAT(Problems([&] { LoadUnityRendererData(path, folder.assets); }),
                ElementsAre(Mentions("4:1: R:", "filterSettings.PassNames", "17", "16")));
}

/// A feature of a plug-in that does not find its shader.
class UnmakeableFeature : public ScriptableRendererFeature
{
public:
    void Create() override { throw ContractError("Create: there is no shader 'Haze'"); }
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
};

/// A renderer with a feature and URP's post-processing.
/// @param settings  of the feature
std::string RendererOfAScene(const std::string& settings)
{
    std::string asset = AssetWithFeature("  m_Script: {fileID: 11500000, guid: aa, type: 3}\n"
                                         "  m_Name: F\n  m_Active: 1\n" +
                                         settings);
    return asset + "  postProcessData: {fileID: 11400000, guid: bb, type: 2}\n";
}

/// Loads the renderer as a Unity scene does.
UnityRendererDataLoadResult LoadForAScene(const SceneFolder& folder)
{
    const auto path = folder / "Assets/r.asset";
    AssetContext assets;
    assets.features().Register<UnmakeableFeature>("UnmakeableFeature");
    const UnityProject project(path, assets.importer().cacheFolder());
    return LoadUnityRendererData(path, assets, project, UnityAssetLoaders());
}

// A value that one feature cannot read is no reason to draw without the others.
TEST(UnityRendererData, KeepsTheDefaultOfASettingThatAScenesRendererCannotGive)
{
    SceneFolder folder;
    folder.Write("Assets/ScreenSpaceOutlineRenderFeature.cs.meta", "guid: aa\n");
    folder.Write("Assets/r.asset",
                 RendererOfAScene("  m_Settings: {m_LayerMask: {a: 1, b: 2}, "
                                  "m_RenderingLayerMask: 32, m_RenderPassEvent: 550}\n"));
    const UnityRendererDataLoadResult result = LoadForAScene(folder);
    ASSERT_EQ(2u, result.renderer.features.size()) << "with post-processing";
    const ScreenSpaceOutlineSettings& settings =
        dynamic_cast<const ScreenSpaceOutlineRenderFeature&>(*result.renderer.features[0])
            .settings();
    const ScreenSpaceOutlineSettings unset;
    EXPECT_EQ(unset.m_LayerMask, settings.m_LayerMask);
    EXPECT_EQ(unset.m_RenderingLayerMask, settings.m_RenderingLayerMask);
    EXPECT_EQ(RenderPassEvent::BeforeRenderingPostProcessing, settings.m_RenderPassEvent);
    EXPECT_THAT(Texts(result.notes),
                IsSupersetOf({Mentions("F.m_Settings.m_LayerMask:", "found a map"),
                              Mentions("F.m_Settings.m_RenderingLayerMask:", "[0, 31]"),
                              Mentions("F:", "keeps its default")}));
}

TEST(UnityRendererData, LeavesOutOfAScenesRendererWhatCannotBeCreated)
{
    SceneFolder folder;
    folder.Write("Assets/UnmakeableFeature.cs.meta", "guid: aa\n");
    folder.Write("Assets/r.asset", RendererOfAScene(""));
    const UnityRendererDataLoadResult result = LoadForAScene(folder);
    ASSERT_EQ(1u, result.renderer.features.size());
    EXPECT_EQ("Post-processing", result.renderer.features[0]->name);
    EXPECT_THAT(Texts(result.notes),
                IsSupersetOf({Mentions("there is no shader 'Haze'"), Mentions("F:", "left out")}));
}

TEST(UnityRendererData, ReadsAMaskOfAProjectsOwnType)
{
    SceneFolder folder;
    folder.Write("Assets/ScreenSpaceOutlineRenderFeature.cs.meta", "guid: aa\n");
    folder.Write("Assets/r.asset", RendererOfAScene("  m_Settings: {m_LayerMask: {_bits: 66}}\n"));
    const UnityRendererDataLoadResult result = LoadForAScene(folder);
    const auto& feature =
        dynamic_cast<const ScreenSpaceOutlineRenderFeature&>(*result.renderer.features.at(0));
    EXPECT_EQ(LayerMask(66), feature.settings().m_LayerMask);
}

TEST(UnityRendererData, RefusesAnotherKindOfAsset)
{
    AssetContext assets;
    EXPECT_THAT(Problems(
                    [&] {
                        LoadUnityRendererData(k_Project + "/Assets/Scenes/SampleSceneProfile.asset",
                                              assets);
                    }),
                ElementsAre(Mentions("no renderer", "Unity asset", "'m_RendererFeatures'")));
}

TEST(UnityRendererData, IsASceneFilesRenderer)
{
    SceneFolder folder;
    folder.assets.AddRootsAround(k_Project + "/Assets/Settings/UniversalRenderer.asset");
    const SceneAsset asset = folder.LoadWithCamera("renderer: {rendererData: " + k_Project +
                                                   "/Assets/Settings/UniversalRenderer.asset}\n");
    EXPECT_EQ(
        (std::vector<std::string>{"ScreenSpaceOutlineRenderFeature", "PostProcessRendererFeature"}),
        asset.renderer.featureTypes);
    EXPECT_EQ(4u, asset.notes.size());
}

TEST(UnityRendererData, IsASceneFilesRendererByItsPathAlone)
{
    SceneFolder folder;
    folder.Write("sub/R.asset", AssetWithFeature("  m_Script: {fileID: 11500000, guid: "
                                                 "6b3d386ba5cd94485973aee1479b272e, type: 3}\n"
                                                 "  m_Name: Mask\n"));
    const SceneAsset asset = folder.LoadWithCamera("renderer:   sub/R.asset\n");
    EXPECT_EQ((std::vector<std::string>{"RenderObjects"}), asset.renderer.featureTypes);
    EXPECT_EQ(LayerMask(3), asset.renderer.opaqueLayerMask);
    ASSERT_EQ(1u, asset.notes.size()) << "of the reference to nothing";
}

TEST(UnityRendererData, ThatCannotBeASceneFilesRendererIsNamedWithItsKey)
{
    SceneFolder folder;
    folder.Write("p.asset", "%YAML 1.1\n--- !u!114 &1\nMonoBehaviour:\n  components: []\n");
    const std::string camera = "camera: {}\n";
    EXPECT_THAT(folder.ProblemsOf(camera + "renderer: x.yaml\n"),
                ElementsAre(Mentions("2:11: renderer:", "'x.yaml'", "no renderer", ".asset")));
    EXPECT_THAT(folder.ProblemsOf(camera + "renderer: x.asset\n"),
                ElementsAre(Mentions("2:11: renderer:", "'x.asset'", "cannot be used"),
                            "there is no such file"));
    EXPECT_THAT(folder.ProblemsOf(camera + "renderer: p.asset\n"),
                ElementsAre(Mentions("2:11: renderer:", "'p.asset'", "cannot be used"),
                            Mentions("no renderer", "Unity asset", "'m_RendererFeatures'")));
    EXPECT_THAT(folder.ProblemsOf(camera + "renderer: [x.asset]\n"),
                ElementsAre(Mentions("2:11: renderer:", "sequence", "a map")));
}

} // namespace limn::test
