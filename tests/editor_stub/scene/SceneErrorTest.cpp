#include "Mentions.h"
#include "SceneFolder.h"

namespace limn::test
{

namespace
{

using testing::ElementsAre;

} // namespace

TEST(SceneErrors, AreAllReportedAtOnceInTheOrderOfTheFile)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("size: [0, 8]\n"
                          "camera:\n"
                          "  fieldOfVeiw: 60\n"
                          "  position: [0, .nan, 1]\n"
                          "lihgt: {}\n"),
        ElementsAre(Mentions("1:8: size[0]:", "0", "outside", "[1, 16384]"),
                    Mentions("3:3: camera:", "unknown key", "'fieldOfVeiw'", "'fieldOfView'"),
                    Mentions("4:17: camera.position[1]:", "'.nan'", "finite"),
                    Mentions("5:1: scene:", "unknown key", "'lihgt'", "'light'")));
}

TEST(SceneErrors, NameARenderScaleThatMakesTooManyPixels)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("size: [16384, 10]\nrenderScale: 2\ncamera: {}\n"),
        ElementsAre(Mentions("2:14: renderScale:", "32768x20", "16384x10", "at most 16384")));
    EXPECT_NO_THROW(folder.Load("size: [8192, 8192]\nrenderScale: 2\ncamera: {}\n"));
    EXPECT_NO_THROW(folder.Load("size: [16384, 1]\ncamera: {}\n"));
}

TEST(SceneErrors, NameAMissingCamera)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("objects: []\n"),
                ElementsAre(Mentions("1:1: scene:", "'camera'", "missing")));
}

TEST(SceneErrors, NameAnEmptyFile)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf(""), ElementsAre(Mentions("empty", "'name:'")));
}

TEST(SceneErrors, NameABinaryFile)
{
    SceneFolder folder;
    const std::string png("\x89PNG\r\n\x1a\n\0\0", 10);
    EXPECT_THAT(folder.ProblemsOf(png), ElementsAre(Mentions("1:1:", "not UTF-8", "save")));
}

TEST(SceneErrors, NameAWrongOrderOfTransparentObjects)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("camera:\n"
                          "  transparencySortMode: Custom\n"
                          "  transparencySortAxis: [0, 0, 0]\n"
                          "  cameraStack: [{transparencySortMode: 7}]\n"),
        ElementsAre(Mentions("2:25: camera.transparencySortMode:", "unknown value", "'Custom'",
                             "'CustomAxis'"),
                    Mentions("3:25: camera.transparencySortAxis:", "no direction", "other than 0"),
                    Mentions("4:40: camera.cameraStack[0].transparencySortMode:", "7",
                             "Default 0, Perspective 1, Orthographic 2, CustomAxis 3")));
    EXPECT_THAT(folder.ProblemsOf("camera:\n  transparencySortAxis: up\n"),
                ElementsAre(Mentions("2:25: camera.transparencySortAxis:", "'up'", "3 numbers")));
}

TEST(SceneErrors, NameADuplicateMaterial)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nmaterials:\n  wood: {}\n  wood: {}\n"),
                ElementsAre(Mentions("4:3:", "duplicate", "'wood'", "3:3")));
}

TEST(SceneErrors, ListTheLayersThereAre)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\n"
                          "layers: {6: Furniture}\n"
                          "objects:\n"
                          " - {layer: Furnitur, renderingLayerMask: [   Chosen, 32], name: A}\n"),
        ElementsAre(
            Mentions("4:12: object 'A'.layer:", "unknown layer", "'Furnitur'", "'Furniture'"),
            Mentions("4:46: object 'A'.renderingLayerMask[0]:", "unknown rendering layer",
                     "'Chosen'", "Default"),
            Mentions("4:54: object 'A'.renderingLayerMask[1]:", "32", "outside", "[0, 31]")));
}

TEST(SceneErrors, NameLayersThatCannotBe)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "layers: {40: X, 7: Default, 3:  Nothing, 0: Ground}\n"),
                ElementsAre(Mentions("2:10: layers.40:", "number", "0...31"),
                            Mentions("2:20: layers.7:", "'Default'", "layer 0", "already"),
                            Mentions("2:33: layers.3:", "'Nothing'", "cannot be", "name"),
                            Mentions("2:45: layers.0:", "always 'Default'", "1...31")));
}

TEST(SceneErrors, NameCameraPlanesInTheWrongOrder)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {nearClipPlane: 3, farClipPlane:  2}\n"),
                ElementsAre(Mentions("1:43: camera.farClipPlane:", "2", "nearClipPlane", "3")));
}

TEST(SceneErrors, NameTwoDirectionsOfTheCamera)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {rotation: [0, 0, 0], lookAt: [0, 0, 0]}\n"),
                ElementsAre(Mentions("1:39: camera.lookAt:", "rotation", "already")));
}

TEST(SceneErrors, NameAMissingMesh)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nobjects: [{name: A,  mesh: a.glb}]\n"),
                ElementsAre(Mentions("2:28: object 'A'.mesh:", "'a.glb'", "cannot be used"),
                            "there is no such file"));
}

TEST(SceneErrors, NameAnUnknownPrimitive)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nobjects: [{name: A, mesh: cub}]\n"),
                ElementsAre(Mentions("2:27: object 'A'.mesh:", "unknown mesh", "'cub'", "'cube'",
                                     "'.gltf' or '.glb'")));
}

TEST(SceneErrors, NameAMissingShaderFileOnceForAllReferences)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\n"
                          "materials:\n"
                          "  a: { shader: nope.shader}\n"
                          "  b: { shader: nope.shader}\n"),
        ElementsAre(Mentions("3:16: material 'a'.shader:", "'nope.shader'", "cannot be used"),
                    "there is no such file",
                    Mentions("4:16: material 'b'.shader:", "'nope.shader'", "cannot be used")));
}

TEST(SceneErrors, OfAProfileFollowTheLineThatNamesIt)
{
    SceneFolder folder;
    folder.Write("bad.profile.yaml",
                 "ScreenSpaceOutline:\n  m_OutlineWidth: 14\n  outlneColor: white\n");
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\n"
                          "volumes:\n"
                          "  - profile: bad.profile.yaml\n"
                          "objects: [{ layer: -1, name: A}]\n"),
        ElementsAre(
            Mentions("3:14: volumes[0].profile:", "'bad.profile.yaml'", "cannot be used"),
            Mentions("2:19: ScreenSpaceOutline.m_OutlineWidth:", "14", "outside", "[1, 10]"),
            Mentions("3:3: ScreenSpaceOutline:", "unknown parameter", "'outlneColor'",
                     "'outlineColor'"),
            Mentions("4:20: object 'A'.layer:", "-1", "outside", "[0, 31]")));
}

TEST(SceneErrors, NameAPropertyThatTheShaderLacks)
{
    SceneFolder folder;
    folder.Write("my.shader", "Shader \"Mine\" {\n"
                              "Properties { _Tint (\"\", Color) = (1, 1, 1, 1)\n"
                              "_Gloss (\"\", Range(0, 1)) = 0 }\n"
                              "SubShader { Pass { HLSLPROGRAM ENDHLSL } } }");
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\n"
                          "materials:\n"
                          "  wood:\n"
                          "    _Tnt: \"#a9743f\"\n"
                          "    _Gloss: 4\n"
                          "    renderQueue: 5001\n"
                          "    shader: my.shader\n"),
        ElementsAre(
            Mentions("4:5: material 'wood':", "unknown property", "'_Tnt'", "'_Tint'"),
            Mentions("5:13: material 'wood'._Gloss:", "4", "outside", "[0, 1]"),
            Mentions("6:18: material 'wood'.renderQueue:", "5001", "outside", "[-1, 5000]")));
}

TEST(SceneErrors, NameARenderingLayerIndexOf32)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "renderer:\n"
                                  "  features:\n"
                                  "    - type: ScreenSpaceOutlineRenderFeature\n"
                                  "      m_RenderingLayerMask: 32\n"),
                ElementsAre(Mentions("5:29: renderer.features[0].m_RenderingLayerMask:", "32",
                                     "outside", "[0, 31]")));
}

TEST(SceneErrors, NameWhatAFeatureCannotBe)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\n"
                          "renderer:\n"
                          "  features:\n"
                          "     - {type: Outline, foo: 1}\n"
                          "     - type: ScreenSpaceOutlineRenderFeature\n"
                          "       m_RenderQueueRange: 7\n"
                          "       m_RenderPassEvent: AfterRendering+x\n"
                          "       m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutlin\n"),
        ElementsAre(
            Mentions("4:15: renderer.features[0].type:", "unknown feature", "'Outline'"),
            Mentions("6:28: renderer.features[1].m_RenderQueueRange:", "7",
                     "All 0, Opaque 1, Transparent 2"),
            Mentions("7:27: renderer.features[1].m_RenderPassEvent:", "'+x'", "whole number",
                     "AfterRendering+1"),
            Mentions("8:36: renderer.features[1].m_ScreenSpaceOutlineShader:", "unknown shader",
                     "'Hidden/ScreenSpaceOutlin'", "'Hidden/ScreenSpaceOutline'", "'.shader'")));
}

TEST(SceneErrors, NameASecondDescriptionOfTheSameThing)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf(
            "materials: {m: {}}\n"
            "renderer: { features:   [], rendererData: x.asset}\n"
            "objects: [{name: A, material: m, materials:         [m], children:   {a: 1}}]\n"
            "camera: {}\n"),
        ElementsAre(
            Mentions("2:25: renderer.features:", "rendererData", "already"),
            Mentions("3:53: object 'A'.materials:", "already", "'material' and 'materials'"),
            Mentions("3:70: object 'A'.children:", "a map", "list", "'- '")));
}

} // namespace limn::test
