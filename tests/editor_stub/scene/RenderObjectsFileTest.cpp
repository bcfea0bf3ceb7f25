#include "Mentions.h"
#include "SceneFolder.h"
#include "settings/SettingsCollector.h"

#include <limn/core/Material.h>
#include <limn/editor_stub/UnityRendererData.h>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <limn/features/RenderObjects.h>

namespace limn::test
{

namespace
{

using Lines = std::vector<std::string>;
using Mode = RenderObjectsSettings::OverrideMaterialMode;

const RenderObjectsSettings& Settings(const RendererAsset& renderer)
{
    return dynamic_cast<const RenderObjects&>(*renderer.features.at(0)).settings;
}

} // namespace

TEST(RenderObjectsInAScene, TakesEverySettingUnderUnitysName)
{
    SceneFolder folder;
    const SceneAsset asset = folder.LoadWithCamera(
        "layers: {6: Glass}\n"
        "materials: {flat: {shader: Universal Render Pipeline/Unlit}}\n"
        "renderer:\n"
        "  features:\n"
        "    - type: RenderObjects\n"
        "      name: Mask\n"
        "      passTag: mask\n"
        "      Event: BeforeRenderingTransparents\n"
        "      filterSettings: {RenderQueueType: Transparent, LayerMask: [Glass], PassNames: "
        "[StencilMask, Other]}\n"
        "      overrideMode: Material\n"
        "      overrideMaterial: flat\n"
        "      overrideMaterialPassIndex: 0\n"
        "      overrideShader: Universal Render Pipeline/Lit\n"
        "      overrideShaderPassIndex: 0\n"
        "      overrideDepthState: true\n"
        "      depthCompareFunction: Greater\n"
        "      enableWrite: false\n"
        "      stencilSettings:\n"
        "        overrideStencilState: true\n"
        "        stencilReference: 200\n"
        "        stencilCompareFunction: NotEqual\n"
        "        passOperation: IncrementSaturate\n"
        "        failOperation: 5\n"
        "        zFailOperation: Zero\n"
        "      cameraSettings: {overrideCamera: true, restoreCamera: false, offset: [1, 2, 3, 0], "
        "cameraFieldOfView: 30}\n");
    const RenderObjectsSettings& settings = Settings(asset.renderer);
    EXPECT_EQ("Mask", asset.renderer.features[0]->name);
    EXPECT_EQ("mask", settings.passTag);
    EXPECT_EQ(RenderPassEvent::BeforeRenderingTransparents, settings.Event);
    EXPECT_EQ(RenderQueueType::Transparent, settings.filterSettings.RenderQueueType);
    EXPECT_EQ(LayerMask(64), settings.filterSettings.LayerMask);
    EXPECT_EQ((Lines{"StencilMask", "Other"}), settings.filterSettings.PassNames);
    EXPECT_EQ(Mode::Material, settings.overrideMode);
    EXPECT_EQ("flat", settings.overrideMaterial->name());
    EXPECT_EQ("Universal Render Pipeline/Lit", settings.overrideShader->name());
    EXPECT_TRUE(settings.overrideDepthState);
    EXPECT_EQ(CompareFunction::Greater, settings.depthCompareFunction);
    EXPECT_FALSE(settings.enableWrite);
    EXPECT_TRUE(settings.stencilSettings.overrideStencilState);
    EXPECT_EQ(200, settings.stencilSettings.stencilReference);
    EXPECT_EQ(CompareFunction::NotEqual, settings.stencilSettings.stencilCompareFunction);
    EXPECT_EQ(StencilOp::IncrementSaturate, settings.stencilSettings.passOperation);
    EXPECT_EQ(StencilOp::Invert, settings.stencilSettings.failOperation);
    EXPECT_EQ(StencilOp::Zero, settings.stencilSettings.zFailOperation);
    EXPECT_TRUE(settings.cameraSettings.overrideCamera);
    EXPECT_FALSE(settings.cameraSettings.restoreCamera);
    EXPECT_EQ(glm::vec4(1, 2, 3, 0), settings.cameraSettings.offset);
    EXPECT_EQ(30.0f, settings.cameraSettings.cameraFieldOfView);
}

TEST(RenderObjectsInAScene, ReportsWhatIsWrongWithItsSettingsAllAtOnce)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "materials: {flat: {}}\n"
                                  "renderer: {features: [\n"
                                  "  {type: RenderObjects,\n"
                                  "     filterSettings: {LayerMaks: 1},\n"
                                  "     overrideMaterial:   nosuch,\n"
                                  "     stencilSettings: {stencilReference:   256,\n"
                                  "                      failOperation: Keeep}}]}\n"),
                testing::ElementsAre(
                    Mentions("5:23: renderer.features[0].filterSettings:", "unknown key",
                             "'LayerMaks'", "'LayerMask'"),
                    Mentions("6:26: renderer.features[0].overrideMaterial:", "unknown material",
                             "'nosuch'", "flat"),
                    Mentions("7:44: renderer.features[0].stencilSettings.stencilReference:", "256",
                             "outside", "[0, 255]"),
                    Mentions("8:38: renderer.features[0].stencilSettings.failOperation:",
                             "unknown value", "'Keeep'", "'Keep'")));
}

TEST(RenderObjectsInAScene, ReportsAPassIndexThatTheMaterialDoesNotHave)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "materials: {flat: {shader: Universal Render Pipeline/Unlit}}\n"
                                  "renderer: {features: [{type: RenderObjects, overrideMaterial: "
                                  "flat, overrideMaterialPassIndex: 4}]}\n"),
                testing::ElementsAre(
                    Mentions("3:23: renderer.features[0]:", "overrideMaterialPassIndex is 4",
                             "'Universal Render Pipeline/Unlit'", "0...3")));
}

TEST(FullScreenPassInAScene, TakesEverySettingUnderUnitysName)
{
    SceneFolder folder;
    const SceneAsset asset =
        folder.LoadWithCamera("materials: {m: {}}\n"
                              "renderer:\n"
                              "  features:\n"
                              "    - type: FullScreenPassRendererFeature\n"
                              "      injectionPoint: BeforeRenderingTransparents\n"
                              "      fetchColorBuffer: false\n"
                              "      requirements: Depth\n"
                              "      passMaterial: m\n"
                              "      passIndex: 0\n"
                              "      bindDepthStencilAttachment: true\n");
    const auto& feature =
        dynamic_cast<const FullScreenPassRendererFeature&>(*asset.renderer.features.at(0));
    EXPECT_EQ(FullScreenPassRendererFeature::InjectionPoint::BeforeRenderingTransparents,
              feature.injectionPoint);
    EXPECT_FALSE(feature.fetchColorBuffer);
    EXPECT_EQ(ScriptableRenderPassInput::Depth, feature.requirements);
    EXPECT_EQ("m", feature.passMaterial->name());
    EXPECT_TRUE(feature.bindDepthStencilAttachment);
}

TEST(FullScreenPassInAScene, CanRequireSeveralTextures)
{
    struct Case
    {
        const char* text;
        int bits;
        const char* shown;
    };
    for (const Case& one :
         {Case{"[Depth, Normal]", 3, "[Depth, Normal]"}, Case{"3", 3, "[Depth, Normal]"},
          Case{"[Motion]", 8, "Motion"}, Case{"[]", 0, "None"}, Case{"15", 15, "Everything"},
          Case{"-1", 15, "Everything"}, Case{"Everything", 15, "Everything"}})
    {
        SceneFolder folder;
        const SceneAsset asset = folder.LoadWithCamera("renderer:\n  features:\n"
                                                       "    - type: FullScreenPassRendererFeature\n"
                                                       "      requirements: " +
                                                       std::string(one.text) + "\n");
        auto& feature =
            dynamic_cast<FullScreenPassRendererFeature&>(*asset.renderer.features.at(0));
        EXPECT_EQ(one.bits, static_cast<int>(feature.requirements)) << one.text;
        FullScreenPassRendererFeature untouched;
        const std::vector<InspectedValue> values = CollectSettings(feature, untouched, {}, {});
        const auto shown = std::ranges::find(values, "requirements", &InspectedValue::name);
        ASSERT_NE(shown, values.end());
        EXPECT_EQ(one.shown, shown->value);
    }
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nrenderer:\n  features:\n"
                                  "    - {type: FullScreenPassRendererFeature, requirements: 16}\n"
                                  "    - {type: FullScreenPassRendererFeature, "
                                  "requirements: [Depth, Dpeth]}\n"),
                testing::ElementsAre(Mentions("4:59:", "requirements", "16", "Motion 8"),
                                     Mentions("5:67:", "requirements", "'Dpeth'", "'Depth'")));
}

TEST(RenderObjectsInAUnityAsset, IsKnownByItsPackagesGuid)
{
    SceneFolder folder;
    AssetContext assets;
    const UnityRendererDataLoadResult result =
        LoadUnityRendererData(folder.Write("R.asset", "%YAML 1.1\n"
                                                      "%TAG !u! tag:unity3d.com,2011:\n"
                                                      "--- !u!114 &5\n"
                                                      "MonoBehaviour:\n"
                                                      "  m_Script: {fileID: 11500000, guid: "
                                                      "6b3d386ba5cd94485973aee1479b272e, type: 3}\n"
                                                      "  m_Name: Mask\n"
                                                      "  m_Active: 1\n"
                                                      "  settings:\n"
                                                      "    passTag: Mask\n"
                                                      "    Event: 450\n"
                                                      "    filterSettings:\n"
                                                      "      RenderQueueType: 1\n"
                                                      "      LayerMask:\n"
                                                      "        serializedVersion: 2\n"
                                                      "        m_Bits: 8\n"
                                                      "      PassNames:\n"
                                                      "      - StencilMask\n"
                                                      "    overrideMaterial: {fileID: 0}\n"
                                                      "    overrideMaterialPassIndex: 0\n"
                                                      "    overrideMode: 1\n"
                                                      "    stencilSettings:\n"
                                                      "      overrideStencilState: 1\n"
                                                      "      stencilReference: 2\n"
                                                      "      stencilCompareFunction: 3\n"
                                                      "      passOperation: 2\n"
                                                      "      failOperation: 0\n"
                                                      "      zFailOperation: 4\n"
                                                      "    cameraSettings:\n"
                                                      "      overrideCamera: 0\n"
                                                      "      restoreCamera: 1\n"
                                                      "      offset: {x: 0, y: 0, z: 0, w: 0}\n"
                                                      "      cameraFieldOfView: 60\n"
                                                      "--- !u!114 &11400000\n"
                                                      "MonoBehaviour:\n"
                                                      "  m_Name: R\n"
                                                      "  m_RendererFeatures:\n"
                                                      "  - {fileID: 5}\n"),
                              assets);
    const RenderObjectsSettings& settings = Settings(result.renderer);
    EXPECT_EQ(RenderPassEvent::BeforeRenderingTransparents, settings.Event);
    EXPECT_EQ(RenderQueueType::Transparent, settings.filterSettings.RenderQueueType);
    EXPECT_EQ(LayerMask(8), settings.filterSettings.LayerMask);
    EXPECT_EQ((Lines{"StencilMask"}), settings.filterSettings.PassNames);
    EXPECT_EQ(nullptr, settings.overrideMaterial);
    EXPECT_EQ(CompareFunction::Equal, settings.stencilSettings.stencilCompareFunction);
    EXPECT_EQ(StencilOp::DecrementSaturate, settings.stencilSettings.zFailOperation);
    EXPECT_TRUE(result.notes.empty());
}

} // namespace limn::test
