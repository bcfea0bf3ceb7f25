#include "Mentions.h"
#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>

namespace limn::test
{

namespace
{

const GameObject& Object(SceneAsset& asset, std::string_view name)
{
    const GameObject* object = asset.scene.Find(name);
    if (object == nullptr)
    {
        throw std::runtime_error("no object " + std::string(name));
    }
    return *object;
}

const ScreenSpaceOutlineSettings& OutlineSettings(const SceneAsset& asset, std::size_t index = 0)
{
    return dynamic_cast<const ScreenSpaceOutlineRenderFeature&>(*asset.renderer.features.at(index))
        .settings();
}

} // namespace

TEST(SceneFile, ACameraAloneIsAScene)
{
    SceneFolder folder;
    const SceneAsset asset = folder.Load("camera:\n");
    EXPECT_EQ(1280, asset.width);
    EXPECT_EQ(720, asset.height);
    EXPECT_TRUE(asset.scene.objects().empty());
    EXPECT_EQ(60.0f, asset.camera.fieldOfView);
    EXPECT_EQ(LayerMask(1), asset.camera.volumeLayerMask);
}

TEST(SceneFile, SetsEveryFieldOfTheCamera)
{
    SceneFolder folder;
    const SceneAsset asset = folder.Load("size: [64, 48]\n"
                                         "layers: {6: Furniture}\n"
                                         "camera:\n"
                                         "  position: [1, 2, 3]\n"
                                         "  rotation: [0, 90, 0]\n"
                                         "  orthographic: true\n"
                                         "  orthographicSize: 7\n"
                                         "  fieldOfView: 45\n"
                                         "  nearClipPlane: 0.5\n"
                                         "  farClipPlane: 50\n"
                                         "  clearFlags: Nothing\n"
                                         "  backgroundColor: [0.25, 0.5, 0.75]\n"
                                         "  cullingMask: [Default, Furniture, 9]\n"
                                         "  allowHDR: false\n"
                                         "  allowMSAA: false\n"
                                         "  antialiasing: FastApproximateAntialiasing\n"
                                         "  renderPostProcessing: false\n"
                                         "  volumeLayerMask: Everything\n"
                                         "  volumeTrigger: [4, 5, 6]\n"
                                         "  transparencySortMode: CustomAxis\n"
                                         "  transparencySortAxis: [0, 1, 0]\n");
    const Camera& camera = asset.camera;
    EXPECT_EQ(64, asset.width);
    EXPECT_EQ(48, asset.height);
    EXPECT_EQ(glm::vec3(1, 2, 3), camera.transform.localPosition);
    EXPECT_NEAR(1.0f, camera.transform.forward().x, 1e-6f);
    EXPECT_TRUE(camera.orthographic);
    EXPECT_EQ(7.0f, camera.orthographicSize);
    EXPECT_EQ(45.0f, camera.fieldOfView);
    EXPECT_EQ(0.5f, camera.nearClipPlane);
    EXPECT_EQ(50.0f, camera.farClipPlane);
    EXPECT_EQ(CameraClearFlags::Nothing, camera.clearFlags);
    EXPECT_EQ((Color{0.25f, 0.5f, 0.75f, 1.0f}), camera.backgroundColor);
    EXPECT_EQ(LayerMask(1u + 64u + 512u), camera.cullingMask);
    EXPECT_FALSE(camera.allowHDR);
    EXPECT_FALSE(camera.allowMSAA);
    EXPECT_EQ(camera.antialiasing, AntialiasingMode::FastApproximateAntialiasing);
    EXPECT_FALSE(camera.renderPostProcessing);
    EXPECT_EQ(LayerMask::Everything(), camera.volumeLayerMask);
    EXPECT_EQ(glm::vec3(4, 5, 6), camera.volumeTrigger);
    EXPECT_EQ(TransparencySortMode::CustomAxis, camera.transparencySortMode);
    EXPECT_EQ(glm::vec3(0, 1, 0), camera.transparencySortAxis);
}

TEST(SceneFile, SaysWhereNothingDrawsTheAntialiasingOfItsCamera)
{
    SceneFolder folder;
    const auto notes = [&](const std::string& camera, const std::string& feature)
    {
        return Texts(folder
                         .Load("camera: {antialiasing: FastApproximateAntialiasing" + camera +
                               "}\nrenderer: {features: [" + feature + "]}\n")
                         .notes);
    };
    const std::string feature = "{type: PostProcessRendererFeature}";
    EXPECT_THAT(notes("", feature), testing::IsEmpty());
    EXPECT_THAT(notes("", ""),
                testing::ElementsAre(Mentions("1:24: camera.antialiasing", feature)));
    const std::string off = ", renderPostProcessing: false";
    EXPECT_THAT(notes(off, feature), testing::ElementsAre(Mentions("camera.antialiasing",
                                                                   "renderPostProcessing is off")));
    EXPECT_THAT(notes(off + ", cameraStack: [{renderPostProcessing: true}]", feature),
                testing::IsEmpty());
}

TEST(SceneFile, SaysHowManySamplesAPixelHas)
{
    SceneFolder folder;
    EXPECT_EQ(1, folder.LoadWithCamera("").msaaSampleCount);
    EXPECT_EQ(4, folder.LoadWithCamera("msaaSampleCount: 4\n").msaaSampleCount);
    EXPECT_EQ(8, folder.LoadWithCamera("msaaSampleCount: _8x\n").msaaSampleCount);
    EXPECT_EQ(
        folder.ProblemsOf("camera:\nmsaaSampleCount: 3\n"),
        std::vector<std::string>{"2:18: msaaSampleCount: 3 is none of Disabled 1, _2x 2, _4x 4, "
                                 "_8x 8"});
}

TEST(SceneFile, TakesTheSamplesOfUnitysPipelineAsset)
{
    SceneFolder folder;
    const auto write = [&](const std::string& samples)
    {
        folder.Write("urp.asset", "%YAML 1.1\n"
                                  "%TAG !u! tag:unity3d.com,2011:\n"
                                  "--- !u!114 &11400000\n"
                                  "MonoBehaviour:\n"
                                  "  m_Name: URP-HighFidelity\n"
                                  "  m_SupportsHDR: 1\n" +
                                      samples + "  m_RenderScale: 1\n");
    };
    for (const int samples : {1, 2, 4, 8})
    {
        write("  m_MSAA: " + std::to_string(samples) + "\n");
        EXPECT_EQ(samples,
                  folder.LoadWithCamera("renderPipelineAsset: urp.asset\n").msaaSampleCount);
    }
    EXPECT_THAT(
        folder.ProblemsOf("camera:\nmsaaSampleCount: 4\nrenderPipelineAsset: urp.asset\n"),
        testing::ElementsAre(Mentions("2:18: msaaSampleCount:", "renderPipelineAsset", "already")));
    write("  m_MSAA: 3\n");
    EXPECT_THAT(folder.ProblemsOf("camera:\nrenderPipelineAsset: urp.asset\n"),
                testing::Contains(
                    testing::HasSubstr("m_MSAA: 3 is none of Disabled 1, _2x 2, _4x 4, _8x 8")));
    write("");
    EXPECT_THAT(folder.ProblemsOf("camera:\nrenderPipelineAsset: urp.asset\n"),
                testing::Contains(testing::HasSubstr("no render pipeline in this Unity asset")));
}

TEST(SceneFile, SaysHowManyBitsAnHdrColourHas)
{
    using enum HDRColorBufferPrecision;
    SceneFolder folder;
    const SceneAsset plain = folder.LoadWithCamera("");
    EXPECT_TRUE(plain.supportsHDR);
    EXPECT_EQ(_64Bits, plain.hdrColorBufferPrecision);
    const auto precision = [&](const std::string& value)
    {
        return folder.LoadWithCamera("hdrColorBufferPrecision: " + value + "\n")
            .hdrColorBufferPrecision;
    };
    EXPECT_EQ(_32Bits, precision("32"));
    EXPECT_EQ(_32Bits, precision("_32Bits"));
    EXPECT_EQ(_64Bits, precision("64"));
    EXPECT_FALSE(folder.LoadWithCamera("supportsHDR: false\n").supportsHDR);
    EXPECT_EQ(folder.ProblemsOf("camera:\nhdrColorBufferPrecision: 16\n"),
              std::vector<std::string>{
                  "2:26: hdrColorBufferPrecision: 16 is none of _32Bits 32, _64Bits 64"});
}

TEST(SceneFile, TakesTheBitsOfUnitysPipelineAsset)
{
    using enum HDRColorBufferPrecision;
    SceneFolder folder;
    const auto load = [&](const std::string& lines)
    {
        folder.Write("urp.asset", "%YAML 1.1\n"
                                  "%TAG !u! tag:unity3d.com,2011:\n"
                                  "--- !u!114 &11400000\n"
                                  "MonoBehaviour:\n"
                                  "  m_MSAA: 1\n" +
                                      lines);
        return folder.LoadWithCamera("renderPipelineAsset: urp.asset\n");
    };
    const SceneAsset wide = load("  m_SupportsHDR: 1\n  m_HDRColorBufferPrecision: 1\n");
    EXPECT_TRUE(wide.supportsHDR);
    EXPECT_EQ(_64Bits, wide.hdrColorBufferPrecision);
    const SceneAsset flat = load("  m_SupportsHDR: 0\n  m_HDRColorBufferPrecision: 0\n");
    EXPECT_FALSE(flat.supportsHDR);
    EXPECT_EQ(_32Bits, flat.hdrColorBufferPrecision);
    EXPECT_EQ(_32Bits, load("").hdrColorBufferPrecision) << "URP before 13 has no other";
    EXPECT_THAT(folder.ProblemsOf("camera:\nhdrColorBufferPrecision: 32\n"
                                  "renderPipelineAsset: urp.asset\n"),
                testing::Contains(
                    Mentions("2:26: hdrColorBufferPrecision:", "renderPipelineAsset", "already")));
}

TEST(SceneFile, DrawsAtAnotherSize)
{
    SceneFolder folder;
    EXPECT_EQ(1.0f, folder.LoadWithCamera("").renderScale);
    EXPECT_EQ(0.5f, folder.LoadWithCamera("renderScale: 0.5\n").renderScale);
    EXPECT_THAT(
        folder.ProblemsOf("camera:\nrenderScale: 3\n"),
        testing::ElementsAre(testing::HasSubstr("2:14: scene.renderScale: 3 is outside [0.1, 2]")));
    const auto write = [&](const std::string& scale)
    {
        folder.Write("urp.asset", "%YAML 1.1\n"
                                  "%TAG !u! tag:unity3d.com,2011:\n"
                                  "--- !u!114 &11400000\n"
                                  "MonoBehaviour:\n"
                                  "  m_MSAA: 1\n"
                                  "  m_RenderScale: " +
                                      scale + "\n");
    };
    write("1.5");
    EXPECT_EQ(1.5f, folder.LoadWithCamera("renderPipelineAsset: urp.asset\n").renderScale);
    EXPECT_THAT(folder.ProblemsOf("camera:\nrenderScale: 1\nrenderPipelineAsset: urp.asset\n"),
                testing::ElementsAre(
                    testing::HasSubstr("renderScale: it comes from renderPipelineAsset already")));
    write("0");
    EXPECT_THAT(folder.ProblemsOf("camera:\nrenderPipelineAsset: urp.asset\n"),
                testing::Contains(testing::HasSubstr("m_RenderScale: 0 is outside [0.1, 2]")));
}

TEST(SceneFile, TakesTheRenderingModeOfLightsFromAUnityAsset)
{
    SceneFolder folder;
    const auto write = [&](const std::string& mode)
    {
        folder.Write("urp.asset", "%YAML 1.1\n"
                                  "%TAG !u! tag:unity3d.com,2011:\n"
                                  "--- !u!114 &11400000\n"
                                  "MonoBehaviour:\n"
                                  "  m_MSAA: 1\n"
                                  "  m_AdditionalLightsRenderingMode: " +
                                      mode + "\n  m_AdditionalLightsPerObjectLimit: 3\n");
    };
    write("1");
    EXPECT_EQ(3,
              folder.LoadWithCamera("renderPipelineAsset: urp.asset\n").maxAdditionalLightsCount);
    write("0");
    EXPECT_EQ(0,
              folder.LoadWithCamera("renderPipelineAsset: urp.asset\n").maxAdditionalLightsCount);
    write("2");
    EXPECT_THAT(folder.ProblemsOf("camera:\nrenderPipelineAsset: urp.asset\n"),
                testing::Contains(testing::HasSubstr(
                    "m_AdditionalLightsRenderingMode: PerVertex is not drawn; set PerPixel")));
    write("7");
    EXPECT_THAT(folder.ProblemsOf("camera:\nrenderPipelineAsset: urp.asset\n"),
                testing::Contains(testing::HasSubstr("m_AdditionalLightsRenderingMode")));
}

TEST(SceneFile, LimitsTheLightsOfAnObject)
{
    SceneFolder folder;
    EXPECT_EQ(4, folder.LoadWithCamera("").maxAdditionalLightsCount);
    EXPECT_EQ(7, folder.LoadWithCamera("maxAdditionalLightsCount: 7\n").maxAdditionalLightsCount);
    EXPECT_THAT(folder.ProblemsOf("camera:\nmaxAdditionalLightsCount: 9\n"),
                testing::ElementsAre(
                    testing::HasSubstr("2:27: maxAdditionalLightsCount: 9 is outside [0, 8]")));
    const auto write = [&](const std::string& limit)
    {
        folder.Write("urp.asset", "%YAML 1.1\n"
                                  "%TAG !u! tag:unity3d.com,2011:\n"
                                  "--- !u!114 &11400000\n"
                                  "MonoBehaviour:\n"
                                  "  m_MSAA: 1\n"
                                  "  m_AdditionalLightsPerObjectLimit: " +
                                      limit + "\n");
    };
    write("2");
    EXPECT_EQ(2,
              folder.LoadWithCamera("renderPipelineAsset: urp.asset\n").maxAdditionalLightsCount);
    EXPECT_THAT(
        folder.ProblemsOf("camera:\nmaxAdditionalLightsCount: 1\nrenderPipelineAsset: urp.asset\n"),
        testing::ElementsAre(testing::HasSubstr(
            "maxAdditionalLightsCount: it comes from renderPipelineAsset already")));
    write("9");
    EXPECT_THAT(folder.ProblemsOf("camera:\nrenderPipelineAsset: urp.asset\n"),
                testing::Contains(
                    testing::HasSubstr("m_AdditionalLightsPerObjectLimit: 9 is outside [0, 8]")));
}

TEST(SceneFile, SaysWhichVersionOfThePipelineItsFeaturesAreOf)
{
    SceneFolder folder;
    EXPECT_EQ(14, folder.LoadWithCamera("").pipelineVersion);
    EXPECT_EQ(10, folder.LoadWithCamera("pipelineVersion: 10\n").pipelineVersion);
    EXPECT_THAT(
        folder.ProblemsOf("camera:\npipelineVersion: 6\n"),
        testing::ElementsAre(testing::HasSubstr("2:18: pipelineVersion: 6 is outside [7, 17]")));
}

TEST(SceneFile, LookAtTurnsTheCameraToThePoint)
{
    SceneFolder folder;
    const SceneAsset asset = folder.Load("camera: {position: [1, 1, 1], lookAt: [1, 1, -4]}\n");
    EXPECT_NEAR(-1.0f, asset.camera.transform.forward().z, 1e-6f);
}

TEST(SceneFile, HasLightsBesidesTheMainOne)
{
    SceneFolder folder;
    const SceneAsset asset = folder.LoadWithCamera(
        "lights:\n"
        "  - {position: [1, 2, 3], color: [1, 0, 0], intensity: 4, range: 5}\n"
        "  - {type: Spot, rotation: [90, 0, 0], spotAngle: 60, "
        "innerSpotAngle: 20}\n"
        "  - {type: Directional}\n");
    const std::vector<Light>& lights = asset.scene.additionalLights;
    ASSERT_EQ(3u, lights.size());
    EXPECT_EQ(LightType::Point, lights[0].type);
    EXPECT_EQ(glm::vec3(1, 2, 3), lights[0].transform.localPosition);
    EXPECT_EQ(Color::red, lights[0].color);
    EXPECT_EQ(4.0f, lights[0].intensity);
    EXPECT_EQ(5.0f, lights[0].range);
    EXPECT_EQ(LightType::Spot, lights[1].type);
    EXPECT_NEAR(-1.0f, lights[1].transform.forward().y, 1e-6f);
    EXPECT_EQ(60.0f, lights[1].spotAngle);
    EXPECT_EQ(20.0f, lights[1].innerSpotAngle);
    EXPECT_EQ(LightType::Directional, lights[2].type);
    EXPECT_THAT(folder.ProblemsOf("camera: {position: [0, 0, -5]}\n"
                                  "lights:\n"
                                  "  - {type: Area, range: -1}\n"
                                  "  - {angle: 3}\n"),
                testing::SizeIs(3));
}

TEST(SceneFile, TheLightShinesAlongItsForwardDirection)
{
    SceneFolder folder;
    const SceneAsset asset =
        folder.LoadWithCamera("light: {rotation: [90, 0, 0], color: \"#ff0000\", intensity: 2}\n"
                              "ambientLight: [0.5, 0.5, 0.5]\n");
    EXPECT_NEAR(-1.0f, asset.scene.mainLight.direction.y, 1e-6f);
    EXPECT_EQ(Color::red, asset.scene.mainLight.color);
    EXPECT_EQ(2.0f, asset.scene.mainLight.intensity);
    EXPECT_EQ((Color{0.5f, 0.5f, 0.5f, 1.0f}), asset.scene.ambientLight);
}

TEST(SceneFile, TheSkyboxIsOneOfTheMaterials)
{
    SceneFolder folder;
    const SceneAsset asset = folder.Load("camera: {clearFlags: Skybox}\n"
                                         "skybox: evening\n"
                                         "materials:\n"
                                         "  evening: {shader: Skybox/Procedural, _SunDisk: 1}\n");
    EXPECT_EQ(CameraClearFlags::Skybox, asset.camera.clearFlags);
    ASSERT_NE(nullptr, asset.scene.skybox);
    EXPECT_EQ("Skybox/Procedural", asset.scene.skybox->shader()->name());
    EXPECT_THAT(asset.scene.skybox->shaderKeywords(), testing::ElementsAre("_SUNDISK_SIMPLE"));
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "skybox: morning\n"
                                  "materials: {evening: {shader: Skybox/Procedural}}\n"),
                testing::ElementsAre("2:9: skybox: unknown material 'morning' (known: "
                                     "evening)"));
}

TEST(SceneFile, AChildStandsInItsParentsSpace)
{
    SceneFolder folder;
    SceneAsset asset = folder.LoadWithCamera(
        "objects:\n"
        "  - name: Parent\n"
        "    position: [10, 0, 0]\n"
        "    rotation: [0, 90, 0]\n"
        "    scale: 2\n"
        "    children:\n"
        "      - {name: Child, mesh: cube, position: [0, 0, 1], scale: [1, 2, 3]}\n");
    const Transform& child = Object(asset, "Child").transform;
    // Turned by 90 degrees about y, +z is +x; twice as large, one metre is two.
    const glm::vec3 position = child.position();
    EXPECT_NEAR(12.0f, position.x, 1e-5f);
    EXPECT_NEAR(0.0f, position.y, 1e-5f);
    EXPECT_NEAR(0.0f, position.z, 1e-5f);
    EXPECT_NEAR(4.0f, glm::length(glm::vec3(child.localToWorldMatrix()[1])), 1e-5f);
    EXPECT_FALSE(Object(asset, "Parent").renderer);
}

TEST(SceneFile, ChildrenInheritLayersMaterialAndBeingInactive)
{
    SceneFolder folder;
    SceneAsset asset = folder.LoadWithCamera(
        "layers: {6: Furniture}\n"
        "renderingLayers: {8: Selected}\n"
        "materials: {wood: {}, glass: {}}\n"
        "objects:\n"
        "  - name: Sofa\n"
        "    active: false\n"
        "    layer: Furniture\n"
        "    renderingLayerMask: [Default, Selected]\n"
        "    material: wood\n"
        "    children:\n"
        "      - {name: Seat, mesh: cube}\n"
        "      - {name: Table, mesh: cube, layer: 2, renderingLayerMask: Everything,\n"
        "         material: glass, active: true}\n");
    const GameObject& seat = Object(asset, "Seat");
    EXPECT_EQ(6, seat.layer);
    EXPECT_EQ(RenderingLayerMask(257), seat.renderer->renderingLayerMask);
    EXPECT_EQ("wood", seat.renderer->sharedMaterials.at(0)->name());
    EXPECT_FALSE(seat.activeSelf);
    const GameObject& table = Object(asset, "Table");
    EXPECT_EQ(2, table.layer);
    EXPECT_EQ(RenderingLayerMask::Everything(), table.renderer->renderingLayerMask);
    EXPECT_EQ("glass", table.renderer->sharedMaterials.at(0)->name());
    EXPECT_FALSE(table.activeSelf);
}

TEST(SceneFile, AMaskAsANumberIsItsBits)
{
    SceneFolder folder;
    SceneAsset asset =
        folder.LoadWithCamera("objects: [{name: A, mesh: quad, renderingLayerMask: 256}]\n");
    EXPECT_EQ(RenderingLayerMask::FromIndex(8), Object(asset, "A").renderer->renderingLayerMask);
}

TEST(SceneFile, EqualMeshesAndShadersAreShared)
{
    SceneFolder folder;
    SceneAsset asset = folder.LoadWithCamera("objects:\n"
                                             "  - {name: A, mesh: cube}\n"
                                             "  - {name: B, mesh: Cube}\n");
    EXPECT_EQ(Object(asset, "A").renderer->mesh, Object(asset, "B").renderer->mesh);
    EXPECT_EQ(Object(asset, "A").renderer->sharedMaterials,
              Object(asset, "B").renderer->sharedMaterials);
}

TEST(SceneFile, AMaterialHasThePropertiesItNames)
{
    SceneFolder folder;
    SceneAsset asset = folder.LoadWithCamera("materials:\n"
                                             "  wood:\n"
                                             "    shader: Universal Render Pipeline/Lit\n"
                                             "    _BaseColor: \"#ff0000\"\n"
                                             "    _Smoothness: 0.75\n"
                                             "    _BaseMap: black\n"
                                             "    renderQueue: 2450\n"
                                             "objects: [{name: A, mesh: cube, material: wood}]\n");
    const Material& wood = *Object(asset, "A").renderer->sharedMaterials.at(0);
    EXPECT_EQ(2450, wood.renderQueue());
    EXPECT_EQ(0.75f, std::get<float>(*wood.Find(ShaderPropertyId("_Smoothness"))));
    EXPECT_EQ(Color::red, std::get<Color>(*wood.Find(ShaderPropertyId("_BaseColor"))));
    EXPECT_EQ(
        "black",
        std::get<std::shared_ptr<const Texture>>(*wood.Find(ShaderPropertyId("_BaseMap")))->name());
}

TEST(SceneFile, AFeaturesSettingsAreReadByUnitysNames)
{
    SceneFolder folder;
    const SceneAsset asset =
        folder.LoadWithCamera("layers: {6: Furniture}\n"
                              "renderingLayers: {8: Selected}\n"
                              "renderer:\n"
                              "  features:\n"
                              "    - type: ScreenSpaceOutlineRenderFeature\n"
                              "      name: Outline\n"
                              "      active: false\n"
                              "      m_RenderPassEvent: AfterRenderingOpaques + 1\n"
                              "      m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline\n"
                              "      m_RenderQueueRange: Transparent\n"
                              "      m_LayerMask: [Furniture]\n"
                              "      renderingLayerMask: Selected\n"
                              "    - type: ScreenSpaceOutlineRenderFeature\n"
                              "      m_RenderPassEvent: 550\n"
                              "      m_RenderQueueRange: 0\n"
                              "      m_LayerMask: {serializedVersion: 2, m_Bits: 64}\n"
                              "      m_RenderingLayerMask: 31\n");
    const ScreenSpaceOutlineSettings& first = OutlineSettings(asset, 0);
    EXPECT_EQ("Outline", asset.renderer.features[0]->name);
    EXPECT_FALSE(asset.renderer.features[0]->isActive());
    EXPECT_EQ(301, static_cast<int>(first.m_RenderPassEvent));
    EXPECT_EQ("Hidden/ScreenSpaceOutline", first.m_ScreenSpaceOutlineShader->name());
    EXPECT_EQ(ScreenSpaceOutlineSettings::RenderQueueRange::Transparent, first.m_RenderQueueRange);
    EXPECT_EQ(LayerMask(64), first.m_LayerMask);
    EXPECT_EQ(8, first.m_RenderingLayerMask);
    const ScreenSpaceOutlineSettings& second = OutlineSettings(asset, 1);
    EXPECT_EQ("ScreenSpaceOutlineRenderFeature", asset.renderer.features[1]->name);
    EXPECT_TRUE(asset.renderer.features[1]->isActive());
    EXPECT_EQ(RenderPassEvent::BeforeRenderingPostProcessing, second.m_RenderPassEvent);
    EXPECT_EQ(nullptr, second.m_ScreenSpaceOutlineShader);
    EXPECT_EQ(ScreenSpaceOutlineSettings::RenderQueueRange::All, second.m_RenderQueueRange);
    EXPECT_EQ(LayerMask(64), second.m_LayerMask);
    EXPECT_EQ(31, second.m_RenderingLayerMask);
}

TEST(SceneFile, AFeaturesShaderMayBeAFileBesideTheScene)
{
    SceneFolder folder;
    folder.Write("my.shader", "Shader \"Mine\" { SubShader { Pass { } Pass { } Pass { } } }");
    const SceneAsset asset =
        folder.LoadWithCamera("renderer: {features: [{type: ScreenSpaceOutlineRenderFeature, "
                              "m_ScreenSpaceOutlineShader: my.shader}]}\n");
    EXPECT_EQ("Mine", OutlineSettings(asset).m_ScreenSpaceOutlineShader->name());
}

TEST(SceneFile, AVolumeHasItsProfileAndPlace)
{
    SceneFolder folder;
    const SceneAsset asset =
        folder.LoadWithCamera("layers: {9: Effects}\n"
                              "volumes:\n"
                              "  - name: Placement\n"
                              "    profile: on.profile.yaml\n"
                              "    isGlobal: false\n"
                              "    priority: 3\n"
                              "    weight: 0.5\n"
                              "    blendDistance: 2\n"
                              "    layer: Effects\n"
                              "    enabled: false\n"
                              "    position: [1, 2, 3]\n"
                              "    scale: 2\n"
                              "    colliders: [{center: [0, 1, 0], size: [2, 3, 4]}]\n");
    ASSERT_EQ(1u, asset.volumes.size());
    const Volume& volume = asset.volumes[0];
    EXPECT_EQ("Placement", volume.name);
    EXPECT_EQ(4.0f, volume.sharedProfile->TryGet<ScreenSpaceOutline>()->m_OutlineWidth.value());
    EXPECT_FALSE(volume.isGlobal);
    EXPECT_EQ(3.0f, volume.priority);
    EXPECT_EQ(0.5f, volume.weight);
    EXPECT_EQ(2.0f, volume.blendDistance);
    EXPECT_EQ(9, volume.layer);
    EXPECT_FALSE(volume.enabled);
    EXPECT_EQ(glm::vec3(1, 2, 3), volume.position);
    EXPECT_EQ(glm::vec3(2), volume.scale);
    ASSERT_EQ(1u, volume.colliders.size());
    EXPECT_EQ(glm::vec3(0, 1, 0), std::get<BoxCollider>(volume.colliders[0]).center);
    EXPECT_EQ(glm::vec3(2, 3, 4), std::get<BoxCollider>(volume.colliders[0]).size);
}

TEST(SceneFile, AGlobalVolumeWithCollidersIsNoted)
{
    SceneFolder folder;
    const SceneAsset asset =
        folder.LoadWithCamera("volumes: [{profile: on.profile.yaml, colliders: [{}]}]\n");
    EXPECT_THAT(Texts(asset.notes),
                testing::ElementsAre(
                    Mentions("2:11: volumes[0]:", "is global", "colliders", "'isGlobal: false'")));
}

TEST(SceneFile, ALocalVolumeWithoutColliderIsNoted)
{
    SceneFolder folder;
    const SceneAsset asset =
        folder.LoadWithCamera("volumes: [{profile: on.profile.yaml, isGlobal: false}]\n");
    EXPECT_THAT(Texts(asset.notes),
                testing::ElementsAre(Mentions("2:11: volumes[0]:", "not global", "no colliders")));
}

} // namespace limn::test
