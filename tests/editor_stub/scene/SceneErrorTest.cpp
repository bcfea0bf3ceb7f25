#include "SceneFolder.h"

namespace limn::test
{

namespace
{

using Lines = std::vector<std::string>;

} // namespace

TEST(SceneErrors, AreAllReportedAtOnceInTheOrderOfTheFile)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"1:8: size[0]: 0 is outside [1, 16384]",
                     "3:3: camera: unknown key 'fieldOfVeiw'; did you mean 'fieldOfView'?",
                     "4:17: camera.position[1]: '.nan' is not a finite number; a number such as "
                     "0.5 is expected",
                     "5:1: scene: unknown key 'lihgt'; did you mean 'light'?"}),
              folder.ProblemsOf("size: [0, 8]\n"
                                "camera:\n"
                                "  fieldOfVeiw: 60\n"
                                "  position: [0, .nan, 1]\n"
                                "lihgt: {}\n"));
}

TEST(SceneErrors, NameARenderScaleThatMakesTooManyPixels)
{
    SceneFolder folder;
    const std::string problem = "2:14: renderScale: it makes 32768x20 of 16384x10 pixels, and "
                                "cameras draw in at most 16384 either way; lower it, or draw a "
                                "smaller picture";
    EXPECT_EQ((Lines{problem}),
              folder.ProblemsOf("size: [16384, 10]\nrenderScale: 2\ncamera: {}\n"));
    EXPECT_NO_THROW(folder.Load("size: [8192, 8192]\nrenderScale: 2\ncamera: {}\n"));
    EXPECT_NO_THROW(folder.Load("size: [16384, 1]\ncamera: {}\n"));
}

TEST(SceneErrors, NameAMissingCamera)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"1:1: scene: key 'camera' is missing"}), folder.ProblemsOf("objects: []\n"));
}

TEST(SceneErrors, NameAnEmptyFile)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"the file is empty; write a name and a colon first, 'name:'"}),
              folder.ProblemsOf(""));
}

TEST(SceneErrors, NameABinaryFile)
{
    SceneFolder folder;
    const std::string png("\x89PNG\r\n\x1a\n\0\0", 10);
    EXPECT_EQ((Lines{"1:1: the bytes here are not UTF-8; save the file as UTF-8 text"}),
              folder.ProblemsOf(png));
}

TEST(SceneErrors, NameAWrongOrderOfTransparentObjects)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"2:25: camera.transparencySortMode: unknown value 'Custom'; did you mean "
                     "'CustomAxis'?",
                     "3:25: camera.transparencySortAxis: it has no direction; a vector other than "
                     "0 is expected",
                     "4:40: camera.cameraStack[0].transparencySortMode: 7 is none of Default 0, "
                     "Perspective 1, Orthographic 2, CustomAxis 3"}),
              folder.ProblemsOf("camera:\n"
                                "  transparencySortMode: Custom\n"
                                "  transparencySortAxis: [0, 0, 0]\n"
                                "  cameraStack: [{transparencySortMode: 7}]\n"));
    EXPECT_EQ((Lines{"2:25: camera.transparencySortAxis: found 'up'; 3 numbers are expected: "
                     "[1, 2, 3]"}),
              folder.ProblemsOf("camera:\n  transparencySortAxis: up\n"));
}

TEST(SceneErrors, NameADuplicateMaterial)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"4:3: duplicate key 'wood'; it is already at 3:3"}),
              folder.ProblemsOf("camera: {}\nmaterials:\n  wood: {}\n  wood: {}\n"));
}

TEST(SceneErrors, ListTheLayersThereAre)
{
    SceneFolder folder;
    EXPECT_EQ(
        (Lines{"4:12: object 'A'.layer: unknown layer 'Furnitur'; did you mean 'Furniture'?",
               "4:46: object 'A'.renderingLayerMask[0]: unknown rendering layer 'Chosen' (known: "
               "Default)",
               "4:54: object 'A'.renderingLayerMask[1]: 32 is outside [0, 31]"}),
        folder.ProblemsOf("camera: {}\n"
                          "layers: {6: Furniture}\n"
                          "objects:\n"
                          " - {layer: Furnitur, renderingLayerMask: [   Chosen, 32], name: A}\n"));
}

TEST(SceneErrors, NameLayersThatCannotBe)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"2:10: layers.40: a layer's number is expected, 0...31, and its name behind "
                     "it",
                     "2:20: layers.7: 'Default' is the name of layer 0 already; a name belongs to "
                     "one layer",
                     "2:33: layers.3: 'Nothing' cannot be a layer's name; masks use it for "
                     "something else",
                     "2:45: layers.0: layer 0 is always 'Default'; name one of 1...31"}),
              folder.ProblemsOf("camera: {}\n"
                                "layers: {40: X, 7: Default, 3:  Nothing, 0: Ground}\n"));
}

TEST(SceneErrors, NameCameraPlanesInTheWrongOrder)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"1:43: camera.farClipPlane: 2 is not greater than nearClipPlane, which is 3"}),
              folder.ProblemsOf("camera: {nearClipPlane: 3, farClipPlane:  2}\n"));
}

TEST(SceneErrors, NameTwoDirectionsOfTheCamera)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"1:39: camera.lookAt: the camera has a rotation already; keep one of them"}),
              folder.ProblemsOf("camera: {rotation: [0, 0, 0], lookAt: [0, 0, 0]}\n"));
}

TEST(SceneErrors, NameAMissingMesh)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"2:28: object 'A'.mesh: 'a.glb' cannot be used; see the errors of that file",
                     "there is no such file"}),
              folder.ProblemsOf("camera: {}\nobjects: [{name: A,  mesh: a.glb}]\n"));
}

TEST(SceneErrors, NameAnUnknownPrimitive)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"2:27: object 'A'.mesh: unknown mesh 'cub'; did you mean 'cube'? (a file's "
                     "path ends in '.gltf' or '.glb')"}),
              folder.ProblemsOf("camera: {}\nobjects: [{name: A, mesh: cub}]\n"));
}

TEST(SceneErrors, NameAMissingShaderFileOnceForAllReferences)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"3:16: material 'a'.shader: 'nope.shader' cannot be used; see the errors of "
                     "that file",
                     "there is no such file",
                     "4:16: material 'b'.shader: 'nope.shader' cannot be used; see the errors of "
                     "that file"}),
              folder.ProblemsOf("camera: {}\n"
                                "materials:\n"
                                "  a: { shader: nope.shader}\n"
                                "  b: { shader: nope.shader}\n"));
}

TEST(SceneErrors, OfAProfileFollowTheLineThatNamesIt)
{
    SceneFolder folder;
    folder.Write("bad.profile.yaml",
                 "ScreenSpaceOutline:\n  m_OutlineWidth: 14\n  outlneColor: white\n");
    EXPECT_EQ((Lines{"3:14: volumes[0].profile: 'bad.profile.yaml' cannot be used; see the errors "
                     "of that file",
                     "2:19: ScreenSpaceOutline.m_OutlineWidth: 14 is outside [1, 10]",
                     "3:3: ScreenSpaceOutline: unknown parameter 'outlneColor'; did you mean "
                     "'outlineColor'?",
                     "4:20: object 'A'.layer: -1 is outside [0, 31]"}),
              folder.ProblemsOf("camera: {}\n"
                                "volumes:\n"
                                "  - profile: bad.profile.yaml\n"
                                "objects: [{ layer: -1, name: A}]\n"));
}

TEST(SceneErrors, NameAPropertyThatTheShaderLacks)
{
    SceneFolder folder;
    folder.Write("my.shader", "Shader \"Mine\" {\n"
                              "Properties { _Tint (\"\", Color) = (1, 1, 1, 1)\n"
                              "_Gloss (\"\", Range(0, 1)) = 0 }\n"
                              "SubShader { Pass { HLSLPROGRAM ENDHLSL } } }");
    EXPECT_EQ((Lines{"4:5: material 'wood': unknown property '_Tnt'; did you mean '_Tint'?",
                     "5:13: material 'wood'._Gloss: 4 is outside [0, 1]",
                     "6:18: material 'wood'.renderQueue: 5001 is outside [-1, 5000]"}),
              folder.ProblemsOf("camera: {}\n"
                                "materials:\n"
                                "  wood:\n"
                                "    _Tnt: \"#a9743f\"\n"
                                "    _Gloss: 4\n"
                                "    renderQueue: 5001\n"
                                "    shader: my.shader\n"));
}

TEST(SceneErrors, NameARenderingLayerIndexOf32)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"5:29: renderer.features[0].m_RenderingLayerMask: 32 is outside [0, 31]"}),
              folder.ProblemsOf("camera: {}\n"
                                "renderer:\n"
                                "  features:\n"
                                "    - type: ScreenSpaceOutlineRenderFeature\n"
                                "      m_RenderingLayerMask: 32\n"));
}

TEST(SceneErrors, NameWhatAFeatureCannotBe)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"4:15: renderer.features[0].type: unknown feature " +
                         UnknownName("Outline", folder.assets.features().names()),
                     "6:28: renderer.features[1].m_RenderQueueRange: 7 is none of All 0, Opaque 1, "
                     "Transparent 2",
                     "7:27: renderer.features[1].m_RenderPassEvent: '+x' is no distance from "
                     "AfterRendering; a whole number is expected, AfterRendering+1",
                     "8:36: renderer.features[1].m_ScreenSpaceOutlineShader: unknown shader "
                     "'Hidden/ScreenSpaceOutlin'; did you mean 'Hidden/ScreenSpaceOutline'? (a "
                     "file's path ends in '.shader')"}),
              folder.ProblemsOf("camera: {}\n"
                                "renderer:\n"
                                "  features:\n"
                                "     - {type: Outline, foo: 1}\n"
                                "     - type: ScreenSpaceOutlineRenderFeature\n"
                                "       m_RenderQueueRange: 7\n"
                                "       m_RenderPassEvent: AfterRendering+x\n"
                                "       m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutlin\n"));
}

TEST(SceneErrors, NameASecondDescriptionOfTheSameThing)
{
    SceneFolder folder;
    EXPECT_EQ((Lines{"2:25: renderer.features: the features come from rendererData already; keep "
                     "one of them",
                     "3:53: object 'A'.materials: there is a material already; keep one of "
                     "'material' and 'materials'",
                     "3:70: object 'A'.children: found a map; a list is expected, each item behind "
                     "a '- '"}),
              folder.ProblemsOf(
                  "materials: {m: {}}\n"
                  "renderer: { features:   [], rendererData: x.asset}\n"
                  "objects: [{name: A, material: m, materials:         [m], children:   {a: 1}}]\n"
                  "camera: {}\n"));
}

} // namespace limn::test
