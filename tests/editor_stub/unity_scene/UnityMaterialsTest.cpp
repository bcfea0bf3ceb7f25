#include "Mentions.h"
#include "unity_scene/UnityScene.h"

#include "Mentions.h"
#include "TemporaryFolder.h"
#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/Material.h>
#include <limn/features/FullScreenPassRendererFeature.h>

namespace limn::test
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* k_MaterialGuid = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa";
constexpr const char* k_GraphGuid = "dddddddddddddddddddddddddddddddd";
constexpr const char* k_Wood = "{fileID: 2800000, guid: bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb, type: 3}";
constexpr const char* k_Rust = "{fileID: 2800000, guid: cccccccccccccccccccccccccccccccc, type: 3}";
constexpr const char* k_Lit = "{fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, type: 3}";
constexpr const char* k_SimpleLit =
    "{fileID: 4800000, guid: 8d2bb70cbf9db8d4da26e15b26e74248, type: 3}";

std::string BuiltIn(int id)
{
    return "{fileID: " + std::to_string(id) + ", guid: 0000000000000000f000000000000000, type: 0}";
}

constexpr const char* k_Head = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

/// A project with a cube of one material, and the pictures "wood.png" and "rust.png".
class MaterialOfAProject : public testing::Test
{
protected:
    MaterialOfAProject()
    {
        for (const auto& [name, guid] : {std::pair("wood.png", "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb"),
                                         std::pair("rust.png", "cccccccccccccccccccccccccccccccc")})
        {
            std::filesystem::create_directories(m_Folder.path() / "Assets");
            WritePng(m_Folder.path() / "Assets" / name,
                     {1, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(4)});
            WriteMeta(name, guid);
        }
    }

    void WriteMeta(const std::string& name, const std::string& guid)
    {
        m_Folder.Write("Assets/" + name + ".meta", "fileFormatVersion: 2\nguid: " + guid + "\n");
    }
    /// @param fields  of the material, behind its shader
    const Material& Load(const std::string& shader, const std::string& fields)
    {
        m_Folder.Write("Assets/A.mat", std::string(k_Head) +
                                           "--- !u!21 &2100000\nMaterial:\n"
                                           "  m_Shader: " +
                                           shader + "\n" + fields);
        WriteMeta("A.mat", k_MaterialGuid);
        return LoadBox();
    }
    /// The material of the box, whichever file has its guid.
    /// @param reference  the renderer's
    /// @param more       documents of the scene
    const Material&
    LoadBox(const std::string& reference =
                "{fileID: 2100000, guid: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa, type: 2}",
            const std::string& more = "")
    {
        m_Folder.Write(
            "Assets/Main.unity",
            std::string(k_Head) +
                "--- !u!1 &1\nGameObject:\n  m_Name: Eye\n  m_IsActive: 1\n"
                "--- !u!4 &14\nTransform:\n  m_GameObject: {fileID: 1}\n"
                "  m_Father: {fileID: 0}\n"
                "--- !u!20 &12\nCamera:\n  m_GameObject: {fileID: 1}\n"
                "--- !u!1 &2\nGameObject:\n  m_Name: Box\n  m_IsActive: 1\n"
                "--- !u!4 &24\nTransform:\n  m_GameObject: {fileID: 2}\n"
                "  m_Father: {fileID: 0}\n"
                "--- !u!33 &23\nMeshFilter:\n  m_GameObject: {fileID: 2}\n"
                "  m_Mesh: {fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}\n"
                "--- !u!23 &22\nMeshRenderer:\n  m_GameObject: {fileID: 2}\n  m_Enabled: 1\n"
                "  m_Materials:\n  - " +
                reference + "\n" + more);
        m_Asset.emplace(LoadScene(m_Folder.path(), m_Assets));
        for (const auto& object : m_Asset->scene.objects())
        {
            if (object->name == "Box")
            {
                return *object->renderer->sharedMaterials.front();
            }
        }
        throw std::runtime_error("the box is not there");
    }
    /// What is said of the material.
    std::vector<std::string> Notes(const std::string& file = "A.mat") const
    {
        std::vector<std::string> notes;
        for (const Diagnostic& note : m_Asset->notes)
        {
            if (note.file.ends_with(file))
            {
                notes.push_back(note.message);
            }
        }
        return notes;
    }
    static std::string TextureOf(const Material& material, const std::string& name)
    {
        const auto texture = material.GetTexture(ShaderPropertyId(name));
        return texture ? texture->name() : "";
    }
    static float Number(const Material& material, const std::string& name)
    {
        return material.GetFloat(ShaderPropertyId(name));
    }
    static std::string Map(const std::string& name, const std::string& texture)
    {
        return "    - " + name + ":\n        m_Texture: " + texture +
               "\n        m_Scale: {x: 2, y: 3}\n        m_Offset: {x: 0.5, y: 0}\n";
    }

    TemporaryFolder m_Folder;
    AssetContext m_Assets;
    std::optional<SceneAsset> m_Asset;
};

TEST_F(MaterialOfAProject, HasTheKeywordsAndMapsThatAreSaved)
{
    const Material& material = Load(
        k_Lit, "  m_ValidKeywords:\n  - _NORMALMAP\n  - _OCCLUSIONMAP\n  m_InvalidKeywords:\n"
               "  - _EMISSION\n  m_SavedProperties:\n    m_TexEnvs:\n" +
                   Map("_BumpMap", k_Wood) + Map("_OcclusionMap", k_Rust) +
                   Map("_MetallicGlossMap", k_Rust) + "    m_Floats:\n    - _Metallic: 0.75\n");
    EXPECT_EQ(material.shader()->name(), "Universal Render Pipeline/Lit");
    EXPECT_THAT(material.shaderKeywords(), ElementsAre("_EMISSION", "_NORMALMAP", "_OCCLUSIONMAP"))
        << "a map without its keyword is not read, as in Unity";
    EXPECT_EQ(TextureOf(material, "_BumpMap"), "wood.png");
    EXPECT_EQ(TextureOf(material, "_OcclusionMap"), "rust.png");
    EXPECT_EQ(TextureOf(material, "_MetallicGlossMap"), "rust.png");
    EXPECT_EQ(Number(material, "_Metallic"), 0.75f);
    EXPECT_THAT(Notes(), Not(Contains(HasSubstr("maps _"))));
}

TEST_F(MaterialOfAProject, HasNoKeywordOfItsShadersOwnThatIsNotSaved)
{
    EXPECT_THAT(Load(k_SimpleLit, "  m_ShaderKeywords: \n").shaderKeywords(), IsEmpty());
    EXPECT_THAT(Load(k_SimpleLit, "  m_ShaderKeywords: _SPECULAR_COLOR\n").shaderKeywords(),
                ElementsAre("_SPECULAR_COLOR"));
}

TEST_F(MaterialOfAProject, IsLitInPlaceOfTheBuiltInPipelinesStandard)
{
    const std::string saved =
        "  m_ShaderKeywords: _NORMALMAP _METALLICGLOSSMAP _ALPHAPREMULTIPLY_ON\n"
        "  m_SavedProperties:\n    m_TexEnvs:\n" +
        Map("_MainTex", k_Wood) + Map("_BaseMap", k_Rust) + Map("_BumpMap", k_Rust) +
        "    m_Floats:\n    - _Glossiness: 0.25\n    - _GlossMapScale: 0.75\n"
        "    - _Smoothness: 0.125\n    - _SrcBlend: 1\n    - _DstBlend: 10\n    - _ZWrite: 0\n"
        "    - _Mode: ";
    const std::string color = "    m_Colors:\n    - _Color: {r: 0, g: 1, b: 0, a: 0.5}\n"
                              "    - _BaseColor: {r: 1, g: 0, b: 0, a: 1}\n";
    const Material& glass = Load(BuiltIn(46), saved + "3\n" + color);
    EXPECT_EQ(glass.shader()->name(), "Universal Render Pipeline/Lit");
    EXPECT_EQ(TextureOf(glass, "_BaseMap"), "wood.png") << "what URP's Lit left does not count";
    EXPECT_EQ(glass.GetTextureScale(ShaderPropertyId("_BaseMap")), glm::vec2(2, 3));
    EXPECT_EQ(glass.GetColor(ShaderPropertyId("_BaseColor")), (Color{0, 1, 0, 0.5f}));
    EXPECT_EQ(Number(glass, "_Smoothness"), 0.25f);
    EXPECT_EQ(Number(glass, "_Surface"), 1.0f);
    EXPECT_EQ(Number(glass, "_DstBlend"), 10.0f);
    EXPECT_THAT(glass.shaderKeywords(),
                ElementsAre("_ALPHAPREMULTIPLY_ON", "_NORMALMAP", "_SURFACE_TYPE_TRANSPARENT"));

    const Material& cut = Load(BuiltIn(46), saved + "1\n" + color);
    EXPECT_THAT(cut.shaderKeywords(), ElementsAre("_ALPHATEST_ON", "_NORMALMAP"));

    const Material& mapped =
        Load(BuiltIn(45), "  m_SavedProperties:\n    m_TexEnvs:\n" + Map("_SpecGlossMap", k_Wood) +
                              Map("_OcclusionMap", k_Wood) +
                              "    m_Floats:\n    - _Glossiness: 0.25\n"
                              "    - _GlossMapScale: 0.75\n    m_Colors:\n"
                              "    - _EmissionColor: {r: 0, g: 0, b: 2, a: 1}\n");
    EXPECT_EQ(Number(mapped, "_Smoothness"), 0.75f) << "the map's scale";
    EXPECT_THAT(mapped.shaderKeywords(), ElementsAre("_EMISSION", "_METALLICSPECGLOSSMAP",
                                                     "_OCCLUSIONMAP", "_SPECULAR_SETUP"));
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(MaterialOfAProject, IsAsSimpleAsTheBuiltInPipelinesOlderShaders)
{
    const std::string saved = "  m_SavedProperties:\n    m_TexEnvs:\n" + Map("_MainTex", k_Wood);
    const Material& diffuse = Load(BuiltIn(7), saved);
    EXPECT_EQ(diffuse.shader()->name(), "Universal Render Pipeline/Simple Lit");
    EXPECT_EQ(TextureOf(diffuse, "_BaseMap"), "wood.png");
    EXPECT_THAT(diffuse.shaderKeywords(), IsEmpty()) << "without highlights";
    const Material& glass = Load(BuiltIn(10750), saved);
    EXPECT_EQ(glass.shader()->name(), "Universal Render Pipeline/Unlit");
    EXPECT_EQ(TextureOf(glass, "_BaseMap"), "wood.png");
    EXPECT_EQ(Number(glass, "_DstBlend"), 10.0f);
    EXPECT_EQ(Number(glass, "_ZWrite"), 0.0f);
    EXPECT_THAT(glass.shaderKeywords(), ElementsAre("_SURFACE_TYPE_TRANSPARENT"));
    EXPECT_EQ(glass.renderQueue(), 3000) << "behind the sky";
    EXPECT_THAT(Load(BuiltIn(10751), saved).shaderKeywords(), ElementsAre("_ALPHATEST_ON"));
}

/// URP's upgrader of materials turns them into Simple Lit, too (URP 14).
TEST_F(MaterialOfAProject, IsSimpleLitInPlaceOfTheOldestShaders)
{
    const std::string saved = "  m_CustomRenderQueue: -1\n  m_SavedProperties:\n    m_TexEnvs:\n" +
                              Map("_MainTex", k_Wood) + Map("_BumpMap", k_Rust) +
                              "    m_Floats:\n    - _Shininess: 0.25\n    - _Cutoff: 0.75\n";
    const Material& shiny = Load(BuiltIn(4), saved); // Bumped Specular
    EXPECT_EQ(shiny.shader()->name(), "Universal Render Pipeline/Simple Lit");
    EXPECT_EQ(TextureOf(shiny, "_BaseMap"), "wood.png");
    EXPECT_EQ(Number(shiny, "_Smoothness"), 0.25f);
    EXPECT_THAT(shiny.shaderKeywords(), ElementsAre("_NORMALMAP", "_SPECULAR_COLOR"));
    const Material& glass = Load(BuiltIn(30), saved); // Transparent/Diffuse
    EXPECT_THAT(glass.shaderKeywords(), ElementsAre("_NORMALMAP", "_SURFACE_TYPE_TRANSPARENT"));
    EXPECT_EQ(Number(glass, "_DstBlend"), 10.0f);
    EXPECT_EQ(glass.renderQueue(), 3000);
    const Material& leaves = Load(BuiltIn(51), saved); // Transparent/Cutout/Diffuse
    EXPECT_THAT(leaves.shaderKeywords(), ElementsAre("_ALPHATEST_ON", "_NORMALMAP"));
    EXPECT_EQ(Number(leaves, "_Cutoff"), 0.75f);
    EXPECT_EQ(Load(BuiltIn(10703), saved).shader()->name(), // Mobile/Diffuse
              "Universal Render Pipeline/Simple Lit");
    EXPECT_THAT(Notes(), IsEmpty());
    EXPECT_EQ(LoadBox(BuiltIn(10302)).shader()->name(), "Universal Render Pipeline/Simple Lit")
        << "the material Default-Diffuse";
}

TEST_F(MaterialOfAProject, IsLitInPlaceOfAutodesksGraphs)
{
    const auto shader = [](const std::string& guid)
    {
        return "{fileID: -6465566751694194690, guid: " + guid + ", type: 3}";
    };
    const std::string saved = "  m_CustomRenderQueue: -1\n  m_SavedProperties:\n    m_TexEnvs:\n" +
                              Map("_MainTex", k_Wood) +
                              "    m_Floats:\n    - _Glossiness: 0.75\n    - _UseColorMap: ";
    const std::string color = "    m_Colors:\n    - _Color: {r: 0, g: 1, b: 0, a: 0.5}\n";
    const Material& opaque =
        Load(shader("0e9d5a909a1f7e84882a534d0d11e49f"), saved + "1\n" + color);
    EXPECT_EQ(opaque.shader()->name(), "Universal Render Pipeline/Lit");
    EXPECT_EQ(TextureOf(opaque, "_BaseMap"), "wood.png");
    EXPECT_EQ(opaque.GetColor(ShaderPropertyId("_BaseColor")), (Color{0, 1, 0, 0.5f}));
    EXPECT_EQ(Number(opaque, "_Smoothness"), 0.25f) << "0.75 is a roughness";
    EXPECT_THAT(opaque.shaderKeywords(), IsEmpty());
    EXPECT_THAT(Notes(), IsEmpty());

    const Material& glass = Load(shader("5c81372d981403744adbdda4433c9c11"), saved + "0\n" + color);
    EXPECT_EQ(TextureOf(glass, "_BaseMap"), "") << "it is switched off";
    EXPECT_THAT(glass.shaderKeywords(), ElementsAre("_SURFACE_TYPE_TRANSPARENT"));
    EXPECT_EQ(glass.renderQueue(), 3000);
    EXPECT_THAT(Load(shader("80aa867ac363ac043847b06ad71604cd"), saved + "1\n").shaderKeywords(),
                ElementsAre("_ALPHATEST_ON"));
}

TEST_F(MaterialOfAProject, IsASpritesInPlaceOfTheLitOneOfThe2DRenderer)
{
    EXPECT_EQ(Load("{fileID: 4800000, guid: e260cfa7296ee7642b167f1eb5be5023, type: 3}", "")
                  .shader()
                  ->name(),
              "Sprites/Default");
}

TEST_F(MaterialOfAProject, HasACubeWhereThePictureIsOne)
{
    m_Folder.Write("Assets/Sky.shader",
                   "Shader \"Sky\" { Properties { _Tex (\"\", Cube) = \"\" {} }\n"
                   "SubShader { Pass { } } }");
    WriteMeta("Sky.shader", "dddddddddddddddddddddddddddddddd");
    const std::string shader = "{fileID: 4800000, guid: dddddddddddddddddddddddddddddddd, type: 3}";
    const std::string saved = "  m_SavedProperties:\n    m_TexEnvs:\n" + Map("_Tex", k_Wood);
    const auto cubeOf = [](const Material& material)
    {
        return std::dynamic_pointer_cast<const Cubemap>(
            material.GetTexture(ShaderPropertyId("_Tex")));
    };
    EXPECT_EQ(TextureOf(Load(shader, saved), "_Tex"), "");
    EXPECT_THAT(Notes(), ElementsAre(Mentions("_Tex: wood.png", "no cube")));

    WritePng(m_Folder.path() / "Assets/wood.png",
             {6, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(6 * 4)});
    m_Folder.Write("Assets/wood.png.meta", "guid: bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb\n"
                                           "TextureImporter:\n  textureShape: 2\n");
    m_Assets.Forget(m_Folder.path() / "Assets/wood.png.meta");
    const auto cube = cubeOf(Load(shader, saved));
    ASSERT_NE(cube, nullptr);
    EXPECT_EQ(cube->name(), "wood.png");
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(MaterialOfAProject, OfAGraphIsLitWithItsMainTextureAndColour)
{
    const std::string shader =
        "{fileID: -6465566751694194690, guid: " + std::string(k_GraphGuid) + ", type: 3}";
    WriteMeta("Paint.shadergraph", k_GraphGuid);

    m_Folder.Write("Assets/Paint.shadergraph",
                   "{\"m_Name\": \"Mask\", \"m_DefaultReferenceName\": \"Texture2D_2\"}\n"
                   "{\"m_DefaultReferenceName\": \"Texture2D_1\"}\n"
                   "{\"m_DefaultReferenceName\": \"Color_7\"}\n"
                   "{\"m_DefaultReferenceName\": \"Color_3\"}\n");
    const std::string saved = "  m_SavedProperties:\n    m_TexEnvs:\n" +
                              Map("Texture2D_1", k_Wood) + Map("Texture2D_2", k_Rust) +
                              "    m_Colors:\n    - Color_3: {r: 1, g: 0, b: 0, a: 1}\n"
                              "    - Color_7: {r: 0, g: 0.5, b: 0, a: 1}\n"
                              "    - Vector2_1: {r: 9, g: 9, b: 0, a: 0}\n";
    const Material& first = Load(shader, saved);
    EXPECT_EQ(first.shader()->name(), "Universal Render Pipeline/Lit");
    EXPECT_EQ(TextureOf(first, "_BaseMap"), "rust.png") << "the graph's first";
    EXPECT_EQ(first.GetColor(ShaderPropertyId("_BaseColor")), (Color{0, 0.5f, 0, 1}));
    EXPECT_THAT(Notes(), ElementsAre(Mentions("graph Paint.shadergraph", "cannot translate",
                                              "Universal Render Pipeline/Lit",
                                              "Color_7 as _BaseColor", "Texture2D_2 as _BaseMap")));

    m_Folder.Write("Assets/Paint.shadergraph", // as it was until 2019: JSON in strings of JSON
                   "{\"JSONnodeData\": \"{\\n \\\"m_Name\\\": \\\"Texture2D_1\\\"}\"}\n"
                   "{\"JSONnodeData\": \"{\\n \\\"m_Name\\\": \\\"Texture2D_2\\\"}\"}\n");
    EXPECT_EQ(TextureOf(Load(shader, saved), "_BaseMap"), "wood.png");

    const Material& usual = Load(shader, saved + "    - _Color: {r: 0, g: 0, b: 1, a: 1}\n");
    EXPECT_EQ(usual.GetColor(ShaderPropertyId("_BaseColor")), (Color{0, 0, 1, 1}));
    const Material& none = Load(shader, "  m_SavedProperties: {}\n");
    EXPECT_EQ(none.GetColor(ShaderPropertyId("_BaseColor")), Color::white);

    m_Folder.Write("Assets/Paint.shadergraph", "\"_Normal_Map\" \"_NoiseTexture\"");
    const Material& plain =
        Load(shader, "  m_SavedProperties:\n    m_TexEnvs:\n" + Map("_Normal_Map", k_Wood) +
                         Map("_NoiseTexture", k_Rust));
    EXPECT_EQ(TextureOf(plain, "_BaseMap"), "") << "neither holds colours";
}

TEST_F(MaterialOfAProject, MayBeTheOneThatUnityImportsWithAGraph)
{
    m_Folder.Write("Assets/Paint.shadergraph", "{\"m_SGVersion\": 3}\n");
    WriteMeta("Paint.shadergraph", k_MaterialGuid);
    const Material& own = LoadBox();
    EXPECT_EQ(own.shader()->name(), "Universal Render Pipeline/Lit");
    EXPECT_EQ(own.GetColor(ShaderPropertyId("_BaseColor")), Color::white);
    EXPECT_THAT(
        Notes("Paint.shadergraph"),
        ElementsAre(HasSubstr("no shader graph"),
                    Mentions("graph Paint.shadergraph", "cannot translate", "Lit is used")));
}

/// A shader with textures of three kinds.
constexpr const char* k_Textured =
    "Shader \"Textured\" { Properties { _Ramp (\"\", 2D) = \"\" {}\n"
    "_Noise (\"\", 3D) = \"\" {}\n _Layers (\"\", 2DArray) = \"\" {} }\n"
    "SubShader { Pass { } } }\n";

/// Editor scripts save volumes, arrays and ramps in such files.
TEST_F(MaterialOfAProject, HasTexturesThatAreSavedAsText)
{
    const std::string settings = "  m_TextureSettings:\n    m_FilterMode: 0\n    m_Aniso: 0\n"
                                 "    m_WrapU: 1\n    m_WrapV: 0\n    m_WrapW: 2\n";
    m_Folder.Write("Assets/Textured.shader", k_Textured);
    WriteMeta("Textured.shader", k_GraphGuid);
    const auto write =
        [&](const std::string& name, const std::string& guid, const std::string& text)
    {
        m_Folder.Write("Assets/" + name, k_Head + text + settings);
        WriteMeta(name, guid);
    };
    // Two levels of 2x1x2 texels of R8_UNorm, which is 5 among the formats of graphics.
    write("Noise.asset", "eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee",
          "--- !u!117 &11700000\nTexture3D:\n  m_Name: Noise\n  serializedVersion: 3\n"
          "  m_ColorSpace: 0\n  m_Format: 5\n  m_Width: 2\n  m_Height: 1\n  m_Depth: 2\n"
          "  m_MipCount: 2\n  _typelessdata: 0A14ff0107\n");
    // Two levels of two elements of 2x1 texels of ARGB32, as the first version saved it: its 5.
    write("Layers.asset", "ffffffffffffffffffffffffffffffff",
          "--- !u!187 &18700000\nTexture2DArray:\n  m_Name: Layers\n  m_ColorSpace: 1\n"
          "  m_Format: 5\n  m_Width: 2\n  m_Height: 1\n  m_Depth: 2\n  m_MipCount: 2\n"
          "  _typelessdata: a0010203b0040506ffffffffc0070809d00a0b0cffffffff\n");
    // A texel of RGB24 behind another object of the file.
    write("Ramp.asset", "99999999999999999999999999999999",
          "--- !u!114 &1\nMonoBehaviour:\n  m_Name: Ramp\n--- !u!28 &2800000\nTexture2D:\n"
          "  m_Name: Ramp\n  serializedVersion: 2\n  m_TextureFormat: 3\n  m_ColorSpace: 1\n"
          "  m_Width: 1\n  m_Height: 1\n  m_MipCount: 1\n  _typelessdata: 010203\n");
    const auto map = [](const std::string& name, const std::string& id, const std::string& guid)
    {
        return Map(name, "{fileID: " + id + ", guid: " + guid + ", type: 2}");
    };
    const Material& material =
        Load("{fileID: 4800000, guid: " + std::string(k_GraphGuid) + ", type: 3}",
             "  m_SavedProperties:\n    m_TexEnvs:\n" +
                 map("_Noise", "11700000", "eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee") +
                 map("_Layers", "18700000", "ffffffffffffffffffffffffffffffff") +
                 map("_Ramp", "2800000", "99999999999999999999999999999999"));
    EXPECT_THAT(Notes(), IsEmpty());
    const auto texels = [&](const char* name)
    {
        const auto texture = std::dynamic_pointer_cast<const TexelTexture>(
            material.GetTexture(ShaderPropertyId(name)));
        std::vector<int> values;
        for (const std::byte byte : texture ? texture->texels() : std::vector<std::byte>())
        {
            values.push_back(static_cast<int>(byte));
        }
        return values;
    };
    const auto noise = material.GetTexture(ShaderPropertyId("_Noise"));
    ASSERT_NE(noise, nullptr);
    EXPECT_EQ(noise->DescribeSize(), "2x1x2 3D");
    EXPECT_EQ(noise->graphicsFormat(), GraphicsFormat::R8_UNorm);
    EXPECT_EQ(noise->mipmapCount(), 2);
    EXPECT_EQ(noise->sampler().filterMode, FilterMode::Point);
    EXPECT_EQ(noise->sampler().wrapModeU, TextureWrapMode::Clamp);
    EXPECT_EQ(noise->sampler().wrapModeW, TextureWrapMode::Mirror);
    EXPECT_THAT(texels("_Noise"), ElementsAre(10, 20, 255, 1));
    const auto layers = material.GetTexture(ShaderPropertyId("_Layers"));
    ASSERT_NE(layers, nullptr);
    EXPECT_EQ(layers->graphicsFormat(), GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_THAT(texels("_Layers"),
                ElementsAre(1, 2, 3, 160, 4, 5, 6, 176, 7, 8, 9, 192, 10, 11, 12, 208));
    EXPECT_EQ(material.GetTexture(ShaderPropertyId("_Ramp"))->graphicsFormat(),
              GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_THAT(texels("_Ramp"), ElementsAre(1, 2, 3, 255));
}

TEST_F(MaterialOfAProject, SaysWhyATextureOfTextIsNotRead)
{
    m_Folder.Write("Assets/Textured.shader", k_Textured);
    WriteMeta("Textured.shader", k_GraphGuid);
    const auto notesOf = [&](const std::string& texture)
    {
        m_Folder.Write("Assets/T.asset", std::string(k_Head) + "--- !u!187 &1\nTexture2DArray:\n" +
                                             "  m_Width: 4\n  m_Height: 4\n  m_Depth: 1\n" +
                                             texture);
        WriteMeta("T.asset", "eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee");
        Load("{fileID: 4800000, guid: " + std::string(k_GraphGuid) + ", type: 3}",
             "  m_SavedProperties:\n    m_TexEnvs:\n" +
                 Map("_Layers", "{fileID: 1, guid: eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee, type: 2}"));
        return Notes("T.asset");
    };
    EXPECT_THAT(notesOf("  serializedVersion: 2\n  m_Format: 96\n  _typelessdata: 00\n"),
                ElementsAre(Mentions("RGBA_DXT1_SRGB", "compressed")));
    EXPECT_THAT(notesOf("  m_Format: 4\n  _typelessdata: 0000\n"),
                ElementsAre(Mentions("2 bytes", "4x4x1", "64")));
    EXPECT_THAT(notesOf("  m_Format: 4\n  _typelessdata: 0x\n"), ElementsAre(Mentions("'x'")));
    EXPECT_THAT(notesOf("  m_Format: 900\n  _typelessdata: 00\n"), ElementsAre(Mentions("900")));
    EXPECT_THAT(notesOf("  serializedVersion: 2\n  m_Format: 900\n  _typelessdata: 00\n"),
                testing::SizeIs(1));
    EXPECT_THAT(notesOf("  m_Format: 4\n  m_StreamData:\n    path: a.resS\n"),
                ElementsAre(Mentions("another file")));
    EXPECT_THAT(Notes(), Contains(Mentions("_Layers", "T.asset", "the shader's own")));
}

/// A script that makes a material in the editor leaves it in the scene.
TEST_F(MaterialOfAProject, MayStandInTheSceneItself)
{
    const Material& material =
        LoadBox("{fileID: 77}", std::string("--- !u!21 &77\nMaterial:\n  m_Shader: ") + k_Lit +
                                    "\n  m_SavedProperties:\n    m_Floats:\n"
                                    "    - _Metallic: 0.75\n");
    EXPECT_EQ(material.shader()->name(), "Universal Render Pipeline/Lit");
    EXPECT_EQ(Number(material, "_Metallic"), 0.75f);
    EXPECT_THAT(Notes("Main.unity"), Not(Contains(HasSubstr("material"))));
}

TEST_F(MaterialOfAProject, IsTheOneOfItsNumberWhereAFileHasSeveral)
{
    const auto material = [](const std::string& id, const std::string& metallic)
    {
        return "--- !u!21 &" + id + "\nMaterial:\n  m_Shader: " + k_Lit +
               "\n  m_SavedProperties:\n    m_Floats:\n    - _Metallic: " + metallic + "\n";
    };
    m_Folder.Write("Assets/Font.asset", k_Head + material("5", "0.25") + material("6", "0.5"));
    WriteMeta("Font.asset", k_MaterialGuid);
    const std::string file = ", guid: " + std::string(k_MaterialGuid) + ", type: 2}";
    EXPECT_EQ(Number(LoadBox("{fileID: 5" + file), "_Metallic"), 0.25f);
    EXPECT_EQ(Number(LoadBox("{fileID: 6" + file), "_Metallic"), 0.5f);
    EXPECT_EQ(Number(LoadBox("{fileID: 2100000" + file), "_Metallic"), 0.25f)
        << "versions of Unity number them differently";
}

TEST_F(MaterialOfAProject, ThatIsNoneIsMagentaAndSaysSo)
{
    EXPECT_EQ(LoadBox("{fileID: 0}").shader()->name(), "Hidden/Core/FallbackError");
    EXPECT_THAT(Notes("Main.unity"), Contains(Mentions("Box", "no material", "magenta")));
    EXPECT_EQ(LoadBox("{fileID: 24}").shader()->name(), "Hidden/Core/FallbackError");
    EXPECT_THAT(Notes("Main.unity"), Contains(Mentions("Box", "no material", "magenta")));
}

TEST_F(MaterialOfAProject, OfAShaderThatCannotBeUsedIsMagentaAndSaysSo)
{
    m_Folder.Write("Assets/Broken.shader",
                   "Shader \"Broken\" { SubShader { UsePass \"None/Such\" } }\n");
    WriteMeta("Broken.shader", "dddddddddddddddddddddddddddddddd");
    const Material& material =
        Load("{fileID: 4800000, guid: dddddddddddddddddddddddddddddddd, type: 3}", "");
    EXPECT_EQ(material.shader()->name(), "Hidden/Core/FallbackError");
    EXPECT_THAT(Notes(), testing::Contains(testing::AllOf(testing::HasSubstr("shader"),
                                                          testing::HasSubstr("magenta"))));
}

/// Unity's editor draws these in magenta where a project uses URP (URP 14, RenderingUtils).
TEST_F(MaterialOfAProject, OfTheBuiltInPipelinesShaderIsMagentaAndSaysSo)
{
    const std::string guid = "dddddddddddddddddddddddddddddddd";
    WriteMeta("Old.shader", guid);
    for (const auto& [content, word] :
         {std::pair("CGPROGRAM\n#pragma surface surf Lambert\nENDCG", "surface"),
          std::pair("Pass { Tags { \"LightMode\" = \"ForwardBase\" } }", "'ForwardBase'"),
          std::pair("Pass { Tags { \"LightMode\" = \"Vertex\" } }", "'Vertex'")})
    {
        m_Folder.Write("Assets/Old.shader",
                       std::string("Shader \"Old\" { SubShader {\n") + content + "\n} }\n");
        m_Assets.Forget(m_Folder / "Assets/Old.shader");
        const Material& material = Load("{fileID: 4800000, guid: " + guid + ", type: 3}", "");
        EXPECT_EQ(material.shader()->name(), "Hidden/Core/FallbackError");
        EXPECT_THAT(Notes("Old.shader"), ElementsAre(Mentions(word, "magenta")));
    }
}

/// Passes that only a feature draws are nothing wrong.
TEST_F(MaterialOfAProject, KeepsAShaderWithPassesOfItsOwnLightMode)
{
    const std::string guid = "dddddddddddddddddddddddddddddddd";
    WriteMeta("Own.shader", guid);
    m_Folder.Write("Assets/Own.shader", "Shader \"Own\" { SubShader { Pass { Tags { "
                                        "\"LightMode\" = \"Outline\" } } } }\n");
    EXPECT_EQ(Load("{fileID: 4800000, guid: " + guid + ", type: 3}", "").shader()->name(), "Own");
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(MaterialOfAProject, TellsAMissingFileFromAnUnknownGuid)
{
    std::filesystem::remove(m_Folder.path() / "Assets/wood.png"); // its .meta stays
    Load(k_Lit, "  m_SavedProperties:\n    m_TexEnvs:\n" + Map("_BaseMap", k_Wood));
    EXPECT_THAT(Notes(), ElementsAre(Mentions("_BaseMap", "'Assets/wood.png'", ".meta")));
}

/// A project whose renderer has a full-screen pass with the material.
class MaterialOfAFeature : public MaterialOfAProject
{
protected:
    /// @param material  the reference to it
    const FullScreenPassRendererFeature& LoadFeature(const std::string& material,
                                                     const std::string& shader)
    {
        const std::string head = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
        m_Folder.Write("ProjectSettings/GraphicsSettings.asset",
                       head + "--- !u!30 &1\nGraphicsSettings:\n  m_CustomRenderPipeline: " +
                           Asset(11400000, "11111111111111111111111111111111") + "\n");
        m_Folder.Write("Assets/P.asset", head +
                                             "--- !u!114 &11400000\nMonoBehaviour:\n"
                                             "  m_MSAA: 1\n  m_RendererDataList:\n  - " +
                                             Asset(11400000, "22222222222222222222222222222222") +
                                             "\n  m_DefaultRendererIndex: 0\n");
        m_Folder.Write("Assets/R.asset",
                       head + "--- !u!114 &5\nMonoBehaviour:\n  m_Script: " +
                           Asset(11500000, "b00045f12942b46c698459096c89274e") +
                           "\n  m_Name: Whole\n  m_Active: 1\n  passMaterial: " + material +
                           "\n--- !u!114 &11400000\nMonoBehaviour:\n  m_Name: R\n"
                           "  m_RendererFeatures:\n  - {fileID: 5}\n");
        WriteMeta("P.asset", "11111111111111111111111111111111");
        WriteMeta("R.asset", "22222222222222222222222222222222");
        Load(shader, "  m_SavedProperties:\n    m_Floats:\n    - _Metallic: 0.75\n");
        return dynamic_cast<const FullScreenPassRendererFeature&>(
            *m_Asset->renderer.features.at(0));
    }
    static std::string Asset(int id, const std::string& guid)
    {
        return "{fileID: " + std::to_string(id) + ", guid: " + guid + ", type: 2}";
    }

    const std::string m_Material = Asset(2100000, k_MaterialGuid);
};

TEST_F(MaterialOfAFeature, IsThatOfTheProject)
{
    const FullScreenPassRendererFeature& feature = LoadFeature(m_Material, k_Lit);
    ASSERT_NE(feature.passMaterial, nullptr);
    EXPECT_EQ(Number(*feature.passMaterial, "_Metallic"), 0.75f);
    EXPECT_THAT(Notes("R.asset"), IsEmpty());
}

// A stand-in or magenta over the whole picture would hide the scene.
TEST_F(MaterialOfAFeature, IsNoneWhereItCannotBeDrawn)
{
    EXPECT_EQ(LoadFeature(Asset(2100000, "33333333333333333333333333333333"), k_Lit).passMaterial,
              nullptr);
    EXPECT_THAT(Notes("R.asset"),
                ElementsAre(Mentions("Whole.passMaterial:", "left out", "the material's guid")));
    m_Folder.Write("Assets/Glow.shadergraph", "{}");
    WriteMeta("Glow.shadergraph", k_GraphGuid);
    EXPECT_EQ(LoadFeature(m_Material, Asset(-6, k_GraphGuid)).passMaterial, nullptr);
    EXPECT_THAT(Notes("R.asset"),
                ElementsAre(Mentions("Whole.passMaterial:", "left out", "Glow.shadergraph")));
    EXPECT_EQ(LoadFeature(Asset(2100000, k_GraphGuid), k_Lit).passMaterial, nullptr)
        << "the material that Unity imports with the graph";
    EXPECT_THAT(Notes("R.asset"),
                ElementsAre(Mentions("Whole.passMaterial:", "left out", "Glow.shadergraph")));
    EXPECT_EQ(
        LoadFeature(m_Material, Asset(4800000, "44444444444444444444444444444444")).passMaterial,
        nullptr);
    EXPECT_THAT(Notes("R.asset"),
                ElementsAre(Mentions("Whole.passMaterial:", "left out", "A.mat", "magenta")));
    EXPECT_EQ(LoadFeature(m_Material, "{fileID: 1").passMaterial, nullptr) << "a broken file";
    EXPECT_THAT(Notes("R.asset"),
                ElementsAre(Mentions("Whole.passMaterial:", "left out", "A.mat", "magenta")));
}

} // namespace
} // namespace limn::test
