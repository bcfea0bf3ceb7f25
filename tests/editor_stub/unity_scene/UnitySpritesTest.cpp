#include "Mentions.h"
#include "TemporaryFolder.h"
#include "unity_scene/UnityScene.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <numbers>
#include <optional>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* k_SpriteGuid = "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb";

/// A scene of one sprite of the picture "sheet.png", which is 40 texels wide and 20 high.
class UnitySprites : public testing::Test
{
protected:
    UnitySprites()
    {
        std::filesystem::create_directories(m_Folder.path() / "Assets");
        WritePng(m_Folder.path() / "Assets/sheet.png",
                 {40, 20, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(40 * 20 * 4)});
    }

    /// @param importer  lines of TextureImporter
    /// @param renderer  lines of SpriteRenderer, behind its sprite
    const GameObject& Load(const std::string& importer, const std::string& renderer = "",
                           const std::string& fileID = "21300000",
                           const std::string& guid = k_SpriteGuid)
    {
        m_Folder.Write("Assets/sheet.png.meta", std::string("fileFormatVersion: 2\nguid: ") +
                                                    k_SpriteGuid + "\nTextureImporter:\n" +
                                                    importer);
        m_Folder.Write(
            "Assets/Main.unity",
            "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"
            "--- !u!1 &1\nGameObject:\n  m_Name: Eye\n  m_IsActive: 1\n"
            "--- !u!4 &14\nTransform:\n  m_GameObject: {fileID: 1}\n  m_Father: {fileID: 0}\n"
            "--- !u!20 &12\nCamera:\n  m_GameObject: {fileID: 1}\n"
            "--- !u!1 &2\nGameObject:\n  m_Name: Flower\n  m_IsActive: 1\n"
            "--- !u!4 &24\nTransform:\n  m_GameObject: {fileID: 2}\n  m_Father: {fileID: 0}\n"
            "--- !u!212 &22\nSpriteRenderer:\n  m_GameObject: {fileID: 2}\n  m_Enabled: 1\n"
            "  m_Materials:\n"
            "  - {fileID: 10754, guid: 0000000000000000f000000000000000, type: 0}\n"
            "  m_Sprite: {fileID: " +
                fileID + ", guid: " + guid + ", type: 3}\n" + renderer);
        m_Assets.Forget(m_Folder.path() / "Assets/sheet.png.meta");
        m_Asset.emplace(LoadScene(m_Folder.path(), m_Assets));
        return *m_Asset->scene.Find("Flower");
    }
    /// The corners of the quad: those at the smallest and at the largest uv.
    static std::pair<glm::vec3, glm::vec3> Corners(const GameObject& object)
    {
        const MeshData& quad = object.renderer->mesh->data();
        return {quad.vertices.at(0), quad.vertices.at(2)};
    }
    static std::pair<glm::vec2, glm::vec2> Part(const GameObject& object)
    {
        const MeshData& quad = object.renderer->mesh->data();
        return {quad.uv.at(0), quad.uv.at(2)};
    }
    std::vector<std::string> Notes() const
    {
        std::vector<std::string> notes;
        for (const Diagnostic& note : m_Asset->notes)
        {
            if (note.message.find("Sprite") != std::string::npos)
            {
                notes.push_back(note.message);
            }
        }
        return notes;
    }

    TemporaryFolder m_Folder;
    AssetContext m_Assets;
    std::optional<SceneAsset> m_Asset;
};

TEST_F(UnitySprites, AreQuadsInTheSizeOfTheirPictureAroundTheirPivot)
{
    const GameObject& plain = Load("  spriteMode: 1\n  spritePixelsToUnits: 10\n  alignment: 0\n");
    EXPECT_EQ(Corners(plain), std::pair(glm::vec3(-2, -1, 0), glm::vec3(2, 1, 0)));
    EXPECT_EQ(Part(plain), std::pair(glm::vec2(0, 0), glm::vec2(1, 1)));
    EXPECT_EQ(plain.renderer->sharedMaterials.at(0)->shader()->name(), "Sprites/Default");
    EXPECT_EQ(plain.renderer->sharedMaterials.at(0)->renderQueue(), 3000);
    EXPECT_EQ(plain.renderer->mesh->data().colors.at(0), glm::vec4(1, 1, 1, 1));
    const auto block = plain.renderer->PropertiesOf(0);
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(block->GetTexture(ShaderPropertyId("_MainTex"))->name(), "sheet.png");

    // 100 texels are a metre where nothing else is said.
    EXPECT_EQ(Corners(Load("  alignment: 7\n")),
              std::pair(glm::vec3(-0.2f, 0, 0), glm::vec3(0.2f, 0.2f, 0)));
    EXPECT_EQ(Corners(Load("  alignment: 1\n  spritePixelsToUnits: 20\n")),
              std::pair(glm::vec3(0, -1, 0), glm::vec3(2, 0, 0)));
    EXPECT_EQ(Corners(Load("  alignment: 9\n  spritePixelsToUnits: 10\n"
                           "  spritePivot: {x: 0.25, y: 1}\n")),
              std::pair(glm::vec3(-1, -2, 0), glm::vec3(3, 0, 0)));
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UnitySprites, AreTurnedOverColouredAndOrderedAsTheRendererSays)
{
    const GameObject& object =
        Load("  spritePixelsToUnits: 10\n  alignment: 6\n",
             "  m_FlipX: 1\n  m_FlipY: 0\n  m_Color: {r: 1, g: 0.5, b: 0, a: 0.25}\n"
             "  m_SortingLayer: 1\n  m_SortingOrder: -30\n");
    EXPECT_EQ(Corners(object), std::pair(glm::vec3(0, 0, 0), glm::vec3(-4, 2, 0)));
    const glm::vec4 color = object.renderer->mesh->data().colors.at(0);
    EXPECT_EQ(color.r, 1.0f);
    EXPECT_NEAR(color.g, 0.2140411f, 1e-6f); // linear
    EXPECT_EQ(color.a, 0.25f);
    EXPECT_EQ(object.renderer->sharedMaterials.at(0)->renderQueue(), 3070);
}

TEST_F(UnitySprites, ArePartsOfASheet)
{
    const std::string sheet = "  spriteMode: 2\n  spritePixelsToUnits: 10\n  spriteSheet:\n"
                              "    sprites:\n"
                              "    - name: left\n      rect: {x: 0, y: 0, width: 10, height: 20}\n"
                              "      alignment: 0\n      internalID: 77\n"
                              "    - name: right\n"
                              "      rect: {x: 20, y: 5, width: 20, height: 10}\n"
                              "      alignment: 6\n      internalID: -5\n";
    const GameObject& right = Load(sheet, "", "-5");
    EXPECT_EQ(Corners(right), std::pair(glm::vec3(0, 0, 0), glm::vec3(2, 1, 0)));
    EXPECT_EQ(Part(right), std::pair(glm::vec2(0.5f, 0.25f), glm::vec2(1, 0.75f)));
    EXPECT_EQ(Corners(Load(sheet, "", "77")),
              std::pair(glm::vec3(-0.5f, -1, 0), glm::vec3(0.5f, 1, 0)));
    // A texture that is smaller than its file keeps the places.
    EXPECT_EQ(Part(Load(sheet + "  maxTextureSize: 8\n", "", "-5")),
              std::pair(glm::vec2(0.5f, 0.25f), glm::vec2(1, 0.75f)));

    EXPECT_FALSE(Load(sheet, "", "78").renderer);
    EXPECT_THAT(Notes(), ElementsAre(Mentions("Flower/SpriteRenderer.m_Sprite", "sheet.png",
                                              "no sprite with the id 78", "nothing is drawn")));
}

// Areas in square metres, by the shapes' formulas.
TEST_F(UnitySprites, MayBeTheShapesOfUnitysMenu)
{
    struct Case
    {
        const char* guid;
        glm::vec2 size;
        double area;
    };
    constexpr double k_HexagonHeight = 222.0 / 256.0; // Unity rounds 0.866 to a texel
    const Case cases[] = {
        {"311925a002f4447b3a28927169b83ea6", {1, 1}, 1.0},
        {"a86470a33a6bf42c4b3595704624658b", {1, 1}, 0.25 * std::numbers::pi},
        {"207ee8102dd4143d288186ef0be518ee", {1, 2}, 1.0 + 0.25 * std::numbers::pi},
        {"19fb86013d8c24d6cb8410c0aadf30fa", {1, 0.5}, 0.25},
        {"b670ab75dde984907b8570040daa08c5", {1, 226.0 / 256.0}, 0.75 * k_HexagonHeight},
        {"5aa8b770bc43046bc8d993d0d5b7f4a5", {226.0 / 256.0, 1}, 0.75 * k_HexagonHeight},
        {"8884154dfe85442a3a3578be807dbcdf", {1, 1}, 0.75 + 0.0625 * std::numbers::pi}};
    for (const Case& each : cases)
    {
        SCOPED_TRACE(each.guid);
        const GameObject& object = Load("", "", "1", each.guid);
        EXPECT_THAT(Notes(), IsEmpty());
        ASSERT_TRUE(object.renderer);
        EXPECT_EQ(Corners(object),
                  std::pair(glm::vec3(-0.5f * each.size, 0), glm::vec3(0.5f * each.size, 0)));
        const auto texture = std::dynamic_pointer_cast<const Texture2D>(
            object.renderer->PropertiesOf(0)->GetTexture(ShaderPropertyId("_MainTex")));
        double area = 0.0;
        for (std::size_t i = 3; i < texture->texels().size(); i += 4)
        {
            area += std::to_integer<int>(texture->texels()[i]) / 255.0 / (256.0 * 256.0);
        }
        EXPECT_NEAR(area, each.area, 2e-4);
        const std::size_t middle =
            4 * static_cast<std::size_t>(texture->width() * (texture->height() + 1) / 2);
        EXPECT_EQ(std::to_integer<int>(texture->texels()[middle + 3]), 255);
        EXPECT_EQ(std::to_integer<int>(texture->texels()[0]), 255) << "white everywhere";
    }
    EXPECT_FALSE(Load("", "", "1", "311925a002f4447b3a28927169b83ea7").renderer);
    EXPECT_THAT(Notes(), ElementsAre(Mentions("no file of the project", "nothing is drawn")));
}

TEST_F(UnitySprites, SayWhatLimnDoesNotDrawOfThem)
{
    const GameObject& wide =
        Load("  spritePixelsToUnits: 10\n", "  m_DrawMode: 1\n  m_Size: {x: 8, y: 6}\n");
    EXPECT_EQ(Corners(wide), std::pair(glm::vec3(-4, -3, 0), glm::vec3(4, 3, 0)));
    EXPECT_THAT(Notes(), ElementsAre(Mentions("m_DrawMode", "stretches", "neither slices")));
    EXPECT_FALSE(Load("  spritePixelsToUnits: nan\n").renderer);
    EXPECT_THAT(Notes(), ElementsAre(Mentions("m_Sprite", "sheet.png.meta", "no size or place")));
    EXPECT_FALSE(Load("", "  m_Enabled: 0\n").renderer);
    EXPECT_THAT(Notes(), IsEmpty());
}

} // namespace
} // namespace limn::test
