#include "unity_scene/UnityScene.h"

#include "Mentions.h"
#include "Paths.h"
#include "TemporaryFolder.h"
#include "unity_scene/UnitySceneLoader.h"
#include "volume/Problems.h"
#include <cmath>
#include <gmock/gmock.h>
#include <limn/core/Material.h>

namespace limn::test
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* k_Cube = "{fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}";
constexpr const char* k_Red = "{fileID: 2100000, guid: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa, type: 2}";

/// An object of that id, its Transform, MeshFilter and MeshRenderer.
std::string CubeText(int id, const std::string& name, int father, const std::string& material)
{
    const std::string n = std::to_string(id);
    return "--- !u!1 &" + n + "\nGameObject:\n  m_Layer: 6\n  m_Name: " + name +
           "\n  m_IsActive: 1\n--- !u!4 &" + n + "4\nTransform:\n  m_GameObject: {fileID: " + n +
           "}\n  m_LocalRotation: {x: 0, y: 0.70710677, z: 0, w: 0.70710677}\n"
           "  m_LocalPosition: {x: 1, y: 2, z: 3}\n  m_LocalScale: {x: 2, y: 2, z: 2}\n"
           "  m_Father: {fileID: " +
           std::to_string(father) + "}\n--- !u!33 &" + n +
           "3\nMeshFilter:\n  m_GameObject: {fileID: " + n + "}\n  m_Mesh: " + k_Cube +
           "\n--- !u!23 &" + n + "2\nMeshRenderer:\n  m_GameObject: {fileID: " + n +
           "}\n  m_Enabled: 1\n  m_RenderingLayerMask: 257\n  m_Materials:\n  - " + material + "\n";
}

constexpr const char* k_Camera =
    "--- !u!1 &1\nGameObject:\n  m_Name: Main Camera\n"
    "  m_TagString: MainCamera\n  m_IsActive: 1\n"
    "--- !u!4 &14\nTransform:\n  m_GameObject: {fileID: 1}\n"
    "  m_LocalPosition: {x: 0, y: 1, z: -10}\n"
    "  m_Father: {fileID: 0}\n"
    "--- !u!20 &12\nCamera:\n  m_GameObject: {fileID: 1}\n"
    "  m_ClearFlags: 2\n  m_BackGroundColor: {r: 1, g: 0, b: 0, a: 0}\n"
    "  near clip plane: 0.5\n  field of view: 45\n";

/// A project of a few files.
class ProjectOfAFewFiles : public testing::Test
{
protected:
    ProjectOfAFewFiles()
    {
        Write("Assets/Red.mat",
              "--- !u!21 &2100000\nMaterial:\n"
              "  m_Shader: {fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, type: 3}\n"
              "  m_CustomRenderQueue: 2100\n  m_SavedProperties:\n    m_Floats:\n"
              "    - _Smoothness: 0.25\n    - _NoSuchThing: 1\n    m_Colors:\n"
              "    - _BaseColor: {r: 1, g: 0.25, b: 0, a: 1}\n",
              "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa");
        Write("ProjectSettings/TagManager.asset",
              "--- !u!78 &1\nTagManager:\n  layers:\n  - Default\n  - \n  - \n  - \n  - \n  - UI\n"
              "  - Selectable\n");
    }

    void Write(const std::string& name, const std::string& text, const std::string& guid = "")
    {
        m_Folder.Write(name, "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + text);
        if (!guid.empty())
        {
            m_Folder.Write(name + ".meta", "fileFormatVersion: 2\nguid: " + guid + "\n");
        }
    }
    SceneAsset Load(const std::string& text)
    {
        Write("Assets/Main.unity", text);
        return LoadScene(m_Folder.path(), m_Assets);
    }
    static std::vector<std::string> NotesOf(const SceneAsset& asset)
    {
        std::vector<std::string> notes;
        for (const Diagnostic& note : asset.notes)
        {
            notes.push_back(note.message);
        }
        return notes;
    }

    TemporaryFolder m_Folder;
    AssetContext m_Assets;
};

TEST_F(ProjectOfAFewFiles, HasItsObjectsMaterialsAndCamera)
{
    const SceneAsset asset =
        Load(k_Camera + CubeText(2, "Box", 0, k_Red) + CubeText(3, "Child", 24, k_Red));
    ASSERT_EQ(asset.scene.objects().size(), 3u);
    const GameObject& box = *asset.scene.objects()[1];
    EXPECT_EQ(box.name, "Box");
    EXPECT_EQ(box.layer, 6);
    EXPECT_EQ(asset.layers.Name(6), "Selectable");
    EXPECT_EQ(box.renderer->renderingLayerMask.bits, 257u);
    ASSERT_EQ(box.renderer->sharedMaterials.size(), 1u);
    const Material& red = *box.renderer->sharedMaterials.front();
    EXPECT_EQ(red.GetColor(ShaderPropertyId("_BaseColor")), (Color{1, 0.25f, 0, 1}));
    EXPECT_EQ(red.GetFloat(ShaderPropertyId("_Smoothness")), 0.25f);
    EXPECT_EQ(red.renderQueue(), 2100);
    EXPECT_EQ(asset.scene.objects()[2]->renderer->sharedMaterials.front().get(), &red);
    EXPECT_THAT(NotesOf(asset), ElementsAre(HasSubstr("no asset of the Universal")))
        << "settings that are not there are Unity's defaults";
    // The child stands at (1, 2, 3) + a turn of 90 degrees about y of 2 * (1, 2, 3).
    const glm::vec3 place = asset.scene.objects()[2]->transform.position();
    EXPECT_NEAR(place.x, 1 + 2 * 3, 1e-5);
    EXPECT_NEAR(place.y, 2 + 2 * 2, 1e-5);
    EXPECT_NEAR(place.z, 3 - 2 * 1, 1e-5);
    EXPECT_EQ(asset.camera.fieldOfView, 45.0f);
    EXPECT_EQ(asset.camera.nearClipPlane, 0.5f);
    EXPECT_EQ(asset.camera.clearFlags, CameraClearFlags::SolidColor);
    EXPECT_FALSE(asset.camera.renderPostProcessing) << "Unity's cameras begin without";
}

TEST_F(ProjectOfAFewFiles, DrawsWhatIsMissingAsUnityDoesAndSaysSo)
{
    const SceneAsset asset =
        Load(std::string(k_Camera) +
             CubeText(2, "Box", 0, "{fileID: 2100000, guid: bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb}") +
             CubeText(3, "None", 0, "{fileID: 0}"));
    EXPECT_EQ(asset.scene.objects()[1]->renderer->sharedMaterials.front(),
              asset.scene.objects()[2]->renderer->sharedMaterials.front());
    EXPECT_THAT(
        NotesOf(asset),
        Contains(Mentions("Box/MeshRenderer.m_Materials.Array.data[0]:", "no file", "guid bbbb")));
}

TEST_F(ProjectOfAFewFiles, KeepsTheRestWhereAValueIsWrong)
{
    std::string text = k_Camera + CubeText(2, "Box", 0, k_Red);
    text.replace(text.find("y: 2, z: 3"), 10, "y: up, z: 3");
    const SceneAsset asset = Load(text);
    EXPECT_EQ(asset.scene.objects()[1]->transform.localPosition, glm::vec3(1, 0, 3));
    EXPECT_THAT(NotesOf(asset),
                Contains(HasSubstr("Box/Transform.m_LocalPosition.y: 'up' is no number")));
}

TEST_F(ProjectOfAFewFiles, LeavesOutWhatNoRootLeadsTo)
{
    const SceneAsset asset =
        Load(k_Camera + CubeText(2, "A", 34, k_Red) + CubeText(3, "B", 24, k_Red) +
             "--- !u!1 &9\nGameObject:\n  m_Name: Placeless\n");
    EXPECT_EQ(asset.scene.objects().size(), 1u);
    EXPECT_THAT(NotesOf(asset), Contains(HasSubstr("3 objects are left out")));
}

TEST_F(ProjectOfAFewFiles, KeepsNumbersInTheirRanges)
{
    std::string text = k_Camera + CubeText(2, "Box", 0, k_Red);
    text.replace(text.find("near clip plane: 0.5"), 20, "near clip plane: -10");
    text.replace(text.find("field of view: 45"), 17, "field of view: 0 ");
    text += "  m_CastShadows: 7\n";
    const SceneAsset asset = Load(text);
    EXPECT_EQ(asset.camera.nearClipPlane, Camera().nearClipPlane);
    EXPECT_EQ(asset.camera.fieldOfView, Camera().fieldOfView);
    EXPECT_EQ(asset.scene.objects()[1]->renderer->shadowCastingMode, ShadowCastingMode::On);
    EXPECT_THAT(NotesOf(asset), Contains(HasSubstr("Main Camera/Camera.near clip plane: -10 is not "
                                                   "from ")));
    EXPECT_THAT(NotesOf(asset),
                Contains(Mentions("Box/MeshRenderer.m_CastShadows:", "7", "0 to 3", "left at 1")));
}

/// Returns the linear sRGB colour of Planck's law, its largest component 1, with the eye as Wyman
/// et al. (2013) fit it to CIE 1931.
glm::dvec3 PlanckColor(double kelvin)
{
    const auto lobe = [](double l, double mean, double below, double above)
    {
        const double t = (l - mean) * (l < mean ? below : above);
        return std::exp(-0.5 * t * t);
    };
    glm::dvec3 xyz(0.0);
    for (double l = 360.0; l < 830.0; l += 1.0)
    {
        const double power = 1.0 / (std::pow(l, 5) * (std::exp(1.438777e7 / (l * kelvin)) - 1.0));
        xyz += power *
               glm::dvec3(
                   0.362 * lobe(l, 442.0, 0.0624, 0.0374) + 1.056 * lobe(l, 599.8, 0.0264, 0.0323) -
                       0.065 * lobe(l, 501.1, 0.0490, 0.0382),
                   0.821 * lobe(l, 568.8, 0.0213, 0.0247) + 0.286 * lobe(l, 530.9, 0.0613, 0.0322),
                   1.217 * lobe(l, 437.0, 0.0845, 0.0278) + 0.681 * lobe(l, 459.0, 0.0385, 0.0725));
    }
    const glm::dvec3 rgb(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z,
                         -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                         0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z);
    return rgb / std::max({rgb.x, rgb.y, rgb.z});
}

TEST(BlackBodyColor, IsThatOfPlancksLaw)
{
    for (const float kelvin : {2000.0f, 2700.0f, 3999.0f, 4001.0f, 5000.0f, 6570.0f, 12000.0f})
    {
        const glm::dvec3 expected = PlanckColor(static_cast<double>(kelvin));
        for (int channel = 0; channel < 3; ++channel)
        {
            EXPECT_NEAR(BlackBodyColor(kelvin)[channel], std::max(expected[channel], 0.0), 0.02)
                << kelvin << " K, channel " << channel;
        }
    }
    EXPECT_EQ(BlackBodyColor(1000.0f), BlackBodyColor(1667.0f)) << "the fit goes no further";
}

TEST_F(ProjectOfAFewFiles, TakesALightsTemperatureWhereItIsUsed)
{
    const std::string light =
        "--- !u!108 &16\nLight:\n  m_GameObject: {fileID: 1}\n  m_Enabled: 1\n"
        "  m_Type: 1\n  m_Color: {r: 1, g: 1, b: 1, a: 1}\n"
        "  m_ColorTemperature: 5000\n  m_UseColorTemperature: ";
    EXPECT_EQ(Load(k_Camera + light + "0\n").scene.mainLight.color, Color::white);
    const Color warm = Load(k_Camera + light + "1\n").scene.mainLight.color.linear();
    const glm::dvec3 expected = PlanckColor(5000.0);
    EXPECT_NEAR(warm.g, expected.g, 0.02);
    EXPECT_NEAR(warm.b, expected.b, 0.02);
    Write("ProjectSettings/GraphicsSettings.asset",
          "--- !u!30 &1\nGraphicsSettings:\n  m_LightsUseColorTemperature: 0\n");
    EXPECT_EQ(Load(k_Camera + light + "1\n").scene.mainLight.color, Color::white);
}

TEST_F(ProjectOfAFewFiles, HasTheCamerasThatAreStackedOnItsOwn)
{
    const std::string overlay =
        "--- !u!1 &5\nGameObject:\n  m_Name: Hands\n  m_IsActive: 1\n"
        "--- !u!4 &54\nTransform:\n  m_GameObject: {fileID: 5}\n"
        "  m_LocalPosition: {x: 7, y: 0, z: 0}\n  m_Father: {fileID: 0}\n"
        "--- !u!20 &52\nCamera:\n  m_GameObject: {fileID: 5}\n  field of view: 30\n"
        "--- !u!114 &53\nMonoBehaviour:\n  m_GameObject: {fileID: 5}\n"
        "  m_Script: {fileID: 11500000, guid: a79441f348de89743a2939f4d699eac1, type: 3}\n"
        "  m_CameraType: 1\n";
    const SceneAsset asset =
        Load(std::string(k_Camera) +
             "--- !u!114 &13\nMonoBehaviour:\n  m_GameObject: {fileID: 1}\n"
             "  m_Script: {fileID: 11500000, guid: a79441f348de89743a2939f4d699eac1, type: 3}\n"
             "  m_CameraType: 0\n  m_Cameras:\n  - {fileID: 52}\n  m_RenderPostProcessing: 1\n" +
             overlay);
    EXPECT_EQ(asset.camera.fieldOfView, 45.0f);
    EXPECT_TRUE(asset.camera.renderPostProcessing);
    ASSERT_EQ(asset.camera.cameraStack.size(), 1u);
    const Camera& hands = *asset.camera.cameraStack.front();
    EXPECT_EQ(hands.renderType, CameraRenderType::Overlay);
    EXPECT_EQ(hands.fieldOfView, 30.0f);
    EXPECT_EQ(hands.transform.localPosition.x, 7.0f);
}

TEST_F(ProjectOfAFewFiles, HasTheFxaaOfItsCameraAndSaysThatOthersAreLeftOut)
{
    const auto loadWith = [&](const char* antialiasing)
    {
        return Load(
            std::string(k_Camera) +
            "--- !u!114 &13\nMonoBehaviour:\n  m_GameObject: {fileID: 1}\n"
            "  m_Script: {fileID: 11500000, guid: a79441f348de89743a2939f4d699eac1, type: 3}\n"
            "  m_Antialiasing: " +
            antialiasing + "\n");
    };
    const auto note = HasSubstr("antialiasing");
    EXPECT_EQ(loadWith("0").camera.antialiasing, AntialiasingMode::None);
    const SceneAsset smoothed = loadWith("1");
    EXPECT_EQ(smoothed.camera.antialiasing, AntialiasingMode::FastApproximateAntialiasing);
    EXPECT_THAT(NotesOf(smoothed), testing::Not(Contains(note)));
    for (const char* other : {"2", "3"}) // SMAA, TAA
    {
        const SceneAsset asset = loadWith(other);
        EXPECT_EQ(asset.camera.antialiasing, AntialiasingMode::None);
        EXPECT_THAT(NotesOf(asset), Contains(testing::AllOf(note, HasSubstr("SMAA or TAA"))));
    }
}

TEST_F(ProjectOfAFewFiles, TakesNoNumberOfAMaterialThatIsNotFinite)
{
    Write("Assets/Red.mat",
          "--- !u!21 &2100000\nMaterial:\n"
          "  m_Shader: {fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, type: 3}\n"
          "  m_CustomRenderQueue: 1e30\n  m_SavedProperties:\n    m_Floats:\n"
          "    - _Smoothness: inf\n    m_Colors:\n"
          "    - _BaseColor: {r: nan, g: 0.25, b: 0, a: 1}\n",
          "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa");
    const SceneAsset asset = Load(k_Camera + CubeText(2, "Box", 0, k_Red));
    const Material& material = *asset.scene.objects()[1]->renderer->sharedMaterials.front();
    EXPECT_EQ(material.GetFloat(ShaderPropertyId("_Smoothness")), 0.0f);
    EXPECT_EQ(material.GetColor(ShaderPropertyId("_BaseColor")), (Color{0, 0.25f, 0, 1}));
    EXPECT_EQ(material.renderQueue(), 5000);
    EXPECT_THAT(NotesOf(asset), Contains(HasSubstr("'inf' is not finite; it is 0")));
}

TEST_F(ProjectOfAFewFiles, KeepsAShadersCubeWhereAMaterialHasAPicture)
{
    std::filesystem::copy_file(SourcePath("tests/editor_stub/data/yard/Assets/Textures/Wood.png"),
                               m_Folder / "Assets/Wood.png");
    m_Folder.Write("Assets/Wood.png.meta", "guid: eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee\n");
    m_Folder.Write(
        "Assets/Sky.shader",
        "Shader \"T/Sky\" { Properties { _Tex (\"\", Cube) = \"\" {} } SubShader { Pass {} } }");
    m_Folder.Write("Assets/Sky.shader.meta", "guid: ffffffffffffffffffffffffffffffff\n");
    Write("Assets/Red.mat",
          "--- !u!21 &2100000\nMaterial:\n"
          "  m_Shader: {fileID: 4800000, guid: ffffffffffffffffffffffffffffffff, type: 3}\n"
          "  m_SavedProperties:\n    m_TexEnvs:\n    - _Tex:\n        m_Texture: {fileID: 2800000, "
          "guid: eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee, type: 3}\n"
          "        m_Scale: {x: 1, y: 1}\n        m_Offset: {x: 0, y: 0}\n",
          "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa");
    const SceneAsset asset = Load(k_Camera + CubeText(2, "Box", 0, k_Red));
    EXPECT_THAT(NotesOf(asset), Contains(HasSubstr("_Tex: Wood.png is no cube")));
}

// Repositories may hold what lies in Assets alone.
TEST_F(ProjectOfAFewFiles, MayBeOnlyWhatLiesInItsAssets)
{
    const std::string material =
        "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!21 &2100000\nMaterial:\n"
        "  m_Shader: {fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, type: 3}\n"
        "  m_SavedProperties:\n    m_Colors:\n    - _BaseColor: {r: 0, g: 0.25, b: 0, a: 1}\n";
    const TemporaryFolder folder;
    const std::string scene = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" +
                              std::string(k_Camera) + CubeText(2, "Box", 0, k_Red);
    folder.Write("part/Red.mat", material);
    folder.Write("part/Red.mat.meta", "guid: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\n");
    const std::filesystem::path file = folder.Write("part/Demo/Scenes/Main.unity", scene);
    EXPECT_THAT(Problems([&] { LoadScene(file, m_Assets); }),
                ElementsAre(AllOf(HasSubstr("no .meta file"), HasSubstr("Assets folder"))));
    for (const char* imported : {"part/Demo/Scenes/Main.unity", "part/Demo/Scenes", "part/Demo"})
    {
        folder.Write(imported + std::string(".meta"), "guid: 0\n");
    }
    const SceneAsset asset = LoadScene(file, m_Assets);
    const Material& red = *asset.scene.objects()[1]->renderer->sharedMaterials.front();
    EXPECT_EQ(red.GetColor(ShaderPropertyId("_BaseColor")), (Color{0, 0.25f, 0, 1}));
}

TEST_F(ProjectOfAFewFiles, NeedsACamera)
{
    Write("Assets/Main.unity", CubeText(2, "Box", 0, k_Red));
    EXPECT_THAT(Problems([&] { LoadScene(m_Folder.path(), m_Assets); }),
                ElementsAre(AllOf(HasSubstr("no camera draws a picture"),
                                  HasSubstr("name another scene with --scene"))));
}

TEST_F(ProjectOfAFewFiles, SaysWhyNothingIsDrawn)
{
    std::string off = CubeText(2, "Box", 0, k_Red);
    off.replace(off.find("m_Enabled: 1"), 12, "m_Enabled: 0");
    Write("Assets/Builder.cs", "", "cccccccccccccccccccccccccccccccc");
    const SceneAsset asset =
        Load(k_Camera + off +
             "--- !u!114 &15\nMonoBehaviour:\n  m_GameObject: {fileID: 1}\n"
             "  m_Script: {fileID: 11500000, guid: cccccccccccccccccccccccccccccccc, type: 3}\n");
    EXPECT_THAT(NotesOf(asset), Contains(Mentions("nothing but the background", "2 objects",
                                                  "renderer that is on", "1 script")));
}

TEST_F(ProjectOfAFewFiles, SaysWhoseSettingsItHasNot)
{
    Write("Assets/Other.asset", "--- !u!114 &11400000\nMonoBehaviour:\n  m_Name: Other\n",
          "dddddddddddddddddddddddddddddddd");
    Write("ProjectSettings/GraphicsSettings.asset",
          "--- !u!30 &1\nGraphicsSettings:\n  m_CustomRenderPipeline: {fileID: 11400000, guid: "
          "dddddddddddddddddddddddddddddddd, type: 2}\n");
    const SceneAsset asset = Load(k_Camera + CubeText(2, "Box", 0, k_Red));
    EXPECT_THAT(NotesOf(asset), Contains(HasSubstr("not the Universal Render Pipeline")));
}

TEST_F(ProjectOfAFewFiles, NamesItsScenesWhereItIsNotClearWhichIsDrawn)
{
    Write("Assets/A.unity", k_Camera);
    Write("Assets/B.unity", k_Camera);
    EXPECT_THAT(Problems([&] { LoadScene(m_Folder.path(), m_Assets); }),
                ElementsAre(HasSubstr("Assets/A.unity")));
    Write("ProjectSettings/EditorBuildSettings.asset",
          "--- !u!1045 &1\nEditorBuildSettings:\n  m_Scenes:\n  - enabled: 0\n"
          "    path: Assets/A.unity\n  - enabled: 1\n    path: Assets/B.unity\n");
    EXPECT_EQ(FindFirstUnityScene(m_Folder.path()), m_Folder / "Assets/B.unity");
    std::filesystem::remove_all(m_Folder / "Assets");
    EXPECT_THAT(Problems([&] { LoadScene(m_Folder.path(), m_Assets); }),
                ElementsAre(HasSubstr("this folder is no Unity project")));
}

TEST(UnityScene, ThatIsNotThereIsNotSaidToHaveNoProject)
{
    const TemporaryFolder folder;
    AssetContext assets;
    EXPECT_THAT(Problems([&] { LoadScene(folder / "none.unity", assets); }),
                ElementsAre(HasSubstr("there is no such file")));
}

TEST_F(ProjectOfAFewFiles, SaysWhatIsNoText)
{
    AssetContext first;
    m_Folder.Write("Assets/Main.unity", "");
    EXPECT_THAT(Problems([&] { LoadScene(m_Folder / "Assets/Main.unity", first); }),
                ElementsAre(HasSubstr("the file is empty")));
    m_Folder.Write("Assets/Main.unity", std::string("\0\0\0\x16", 4));
    EXPECT_THAT(Problems([&] { LoadScene(m_Folder / "Assets/Main.unity", m_Assets); }),
                ElementsAre(HasSubstr("saved as binary")));
    m_Folder.Write("Assets/Main.unity", "version https://git-lfs.github.com/spec/v1\n");
    AssetContext others;
    EXPECT_THAT(Problems([&] { LoadScene(m_Folder / "Assets/Main.unity", others); }),
                ElementsAre(HasSubstr("git lfs pull")));
}

} // namespace
} // namespace limn::test
